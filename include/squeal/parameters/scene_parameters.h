// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_scene_parameters_h
#define squeal_parameters_scene_parameters_h

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace squeal
{
  using Vector3 = std::array<double, 3>;

  /**
   * One body of a scene, section "Scene/Body <name>". SI units.
   */
  struct BodyParameters
  {
    /** What the body is: a meshed solid or a lumped rigid body. */
    enum class Shape
    {
      annulus,
      block,
      cylinder,
      gmsh,    /**< mesh from a file of Gmsh */
      abaqus,  /**< of an Abaqus input file */
      nastran, /**< of Nastran bulk data */
      layer,   /**< hexahedra on a face of another body, glued to it */
      rigid
    };
    /** Elastic law of a meshed solid. */
    enum class MaterialModel
    {
      isotropic,
      orthotropic
    };
    /** What holds outside the frequencies and temperatures of a table. */
    enum class ModulusExtrapolation
    {
      refused,
      constant /**< the value at the nearest end of the table */
    };

    std::string name;
    Shape       shape = Shape::block;
    /** Centre of the bottom face (annulus, block, cylinder), centre of
     * gravity (rigid), offset added to the mesh file's coordinates. m */
    Vector3 position{{0., 0., 0.}};
    /** Edge lengths along x, y, z of a block. m */
    Vector3 size{{1., 1., 1.}};
    /** Radii and height along z of an annulus; a cylinder uses the outer
     * radius only. m */
    double inner_radius = 0.05;
    double outer_radius = 0.12;
    double height       = 0.01;
    /** Cells of the coarse mesh: block x, y, z; annulus and cylinder
     * circumference, radius, height. */
    std::array<unsigned int, 3> cells{{4, 4, 4}};
    /** Mesh file and what of it is the body: physical volume (gmsh), element
     * set (abaqus), property or element set (nastran). */
    std::string mesh_file;
    std::string physical_volume;
    /** Surfaces and node sets of the file that are faces of the body; empty:
     * all its surfaces. */
    std::vector<std::string> mesh_faces;
    double                   mesh_length_unit = 1.; /**< of the mesh file, m */
    double mesh_mass_unit = 1.; /**< of the mesh file's materials, kg */
    /** A layer: the body and its face that it lies on, its thickness along the
     * normals of that face, m, and its cells across. */
    std::string  layer_body, layer_face;
    double       thickness      = 0.001;
    unsigned int element_layers = 1;
    /** The material of the mesh file takes the place of the numbers below. */
    bool material_from_mesh_file = false;

    MaterialModel material_model = MaterialModel::isotropic;
    double        young_modulus  = 210e9;              /**< Pa, isotropic */
    double        poisson_ratio  = 0.3;                /**< isotropic */
    double        density        = 7800.;              /**< kg/m^3 */
    Vector3       young_moduli{{210e9, 210e9, 210e9}}; /**< E1, E2, E3, Pa */
    Vector3       shear_moduli{{80e9, 80e9, 80e9}};    /**< G23, G13, G12, Pa */
    Vector3       poisson_ratios{{0.3, 0.3, 0.3}};     /**< nu23, nu13, nu12 */
    /** Directions, of any length, of the axis 1 of an orthotropic material and
     * of one that lies with it in the plane of the axes 1 and 2. */
    Vector3 material_axis_1{{1., 0., 0.}}, material_axis_2{{0., 1., 0.}};
    /** Storage modulus and loss factor over frequency, temperature and
     * pressure, which take the place of `young_modulus` and
     * `structural_damping`; empty: none.
     */
    std::string modulus_table_file;
    double      temperature = 20.; /**< of the table, degrees Celsius */
    double      pressure    = 0.;  /**< of the table, Pa */
    ModulusExtrapolation modulus_extrapolation = ModulusExtrapolation::refused;
    /** Loss factor of that table at the frequency at which `young_modulus` is
     * its storage modulus; no entry of a file. NaN: nobody has read the table.
     */
    double table_loss_factor = std::numeric_limits<double>::quiet_NaN();

    double  mass = 1.;                   /**< kg, rigid */
    Vector3 inertia{{1e-3, 1e-3, 1e-3}}; /**< Jxx, Jyy, Jzz, kg m^2, rigid */

    double mass_damping       = 0.; /**< alpha, 1/s; model "per part" only */
    double stiffness_damping  = 0.; /**< beta, s; model "per part" only */
    double structural_damping = 0.; /**< loss factor eta; "per part" only */
    /** Turning speed about z for gyroscopic and convective terms in the fixed
     * frame, rad/s; 0 leaves them out. */
    double rotation_speed = 0.;
    /** Direction of the axis that the body turns about as a target. */
    Vector3 rotation_axis{{0., 0., 1.}};
    /** A point of that axis, m; none: `position`. */
    std::optional<Vector3> rotation_centre;
    /** What the body is turned by about that axis from the place that the other
     * numbers describe, degrees. */
    double angle = 0.;

    /** Whether the mesh is in a file. */
    bool
    has_mesh_file() const
    {
      return shape == Shape::gmsh || shape == Shape::abaqus ||
             shape == Shape::nastran;
    }

    bool
    has_modulus_table() const
    {
      return !modulus_table_file.empty();
    }

    const Vector3 &
    centre_of_rotation() const
    {
      return rotation_centre ? *rotation_centre : position;
    }
  };

  /** Two faces that move as one, or a face that moves as a rigid body does
   * (rigid coupling), section "Scene/Tie <name>". */
  struct TieParameters
  {
    enum class Kind
    {
      automatic, /**< conforming where the face meshes match, else mortar */
      conforming,
      mortar
    };
    std::string name;
    std::string source_body, source_face; /**< carries the multiplier */
    std::string target_body, target_face; /**< no face of a rigid body */
    Kind        kind = Kind::automatic;
  };

  /**
   * Springs and dashpots, section "Scene/Spring <name>": either `number` equal
   * point springs spaced evenly from first_point to last_point (both ends
   * included), or an elastic bed on a face. One end on `body`, the other on
   * the ground or on `other_body` at the same points. They act along
   * `direction` by `stiffness` and `dashpot`, and along x, y and z by
   * `stiffnesses` and `dashpots`.
   */
  struct SpringParameters
  {
    enum class Kind
    {
      points,
      area
    };
    std::string  name;
    Kind         kind = Kind::points;
    std::string  body;
    std::string  other_body = "ground";
    std::string  face; /**< area */
    Vector3      first_point{{0., 0., 0.}}, last_point{{0., 0., 0.}}; /**< m */
    unsigned int number = 1;
    Vector3      direction{{0., 0., 1.}}; /**< normalised when read */
    double       stiffness = 0.; /**< N/m for each point, N/m^3 on an area */
    double       dashpot = 0.; /**< N s/m for each point, N s/m^3 on an area */
    Vector3      stiffnesses{{0., 0., 0.}}; /**< along x, y, z; as stiffness */
    Vector3      dashpots{{0., 0., 0.}};    /**< along x, y, z; as dashpot */
    double       stiffness_damping  = 0.;   /**< beta, s; "per part" only */
    double       structural_damping = 0.;   /**< eta; "per part" only */
  };

  /** Displacements that are held at zero, section "Scene/Support <name>". */
  struct SupportParameters
  {
    enum class Kind
    {
      clamped,    /**< all components of the face (or of a rigid body) */
      components, /**< the listed components */
      guided, /**< the face moves along its normal (x, y or z) but cannot tilt;
                 free across it */
      held,   /**< guided, and kept along the normal where the loads moved it */
      free    /**< nothing is held */
    };
    std::string              name;
    std::string              body;
    std::string              face; /**< empty for a rigid body */
    Kind                     kind = Kind::clamped;
    std::vector<std::string> components; /**< x y z; rx ry rz of rigid bodies */
  };

  /** A point mass carried by a body, section "Scene/Lumped mass <name>". */
  struct LumpedMassParameters
  {
    std::string name;
    std::string body;
    Vector3     point{{0., 0., 0.}}; /**< m */
    double      mass = 0.;           /**< kg */
  };

  /** A force spread evenly over a face and a pressure on it, or force and
   * moment on a rigid body, section "Scene/Load <name>". */
  struct LoadParameters
  {
    std::string name;
    std::string body, face;           /**< no face of a rigid body */
    Vector3     force{{0., 0., 0.}};  /**< resultant, N */
    double      pressure = 0.;        /**< Pa, positive pushes on the body */
    Vector3     moment{{0., 0., 0.}}; /**< N m, rigid bodies only */
    double      ramp_time = 0.;       /**< s, from zero to full, smooth */
  };

  /** A frictional contact pair, section "Scene/Contact <name>". */
  struct ContactParameters
  {
    enum class Formulation
    {
      springs,        /**< point springs of stiffness k_n */
      mortar,         /**< no penetration in the dual mortar sense */
      node_to_surface /**< the source nodes do not enter the target face */
    };
    enum class SpringLayout
    {
      grid, /**< n1 x n2 point pairs over the source face, edges included */
      quadrature /**< Gauss points of the source face, stiffness per area */
    };
    enum class State
    {
      full,   /**< the whole face slips */
      stick,  /**< the whole face sticks (disc at rest) */
      preload /**< open, slip and stick sets of the steady sliding */
    };
    enum class FrictionDirection
    {
      fixed_y, /**< friction along +y everywhere */
      slip,    /**< along the local slip Omega x r of the target surface */
      given    /**< along `sliding_direction` everywhere */
    };
    enum class FrictionLaw
    {
      constant,    /**< `friction_coefficient` at every slip rate */
      exponential, /**< from `static_friction_coefficient` at rest down to
                        `friction_coefficient`, by exp(-|v_t| / decay_speed) */
      table        /**< linear between `friction_speeds` */
    };
    std::string name;
    std::string source_body, source_face; /**< pad: carries multipliers */
    std::string target_body, target_face; /**< disc; "ground" is allowed
                                             for rigid source bodies */
    /** Where a rigid source touches, from its centre of gravity. m */
    Vector3                     contact_point{{0., 0., 0.}};
    Formulation                 formulation = Formulation::springs;
    SpringLayout                layout      = SpringLayout::grid;
    std::array<unsigned int, 2> grid{{11, 11}};
    double normal_stiffness     = 2.5895e8;  /**< N/m per pair, layout grid */
    double tangential_stiffness = -1.;       /**< N/m per pair when sticking;
                                                  negative: equal to normal */
    double normal_stiffness_per_area = 3e14; /**< N/m^3, layout quadrature */
    State  state                     = State::full;
    double friction_coefficient = 0.; /**< negative: target turns backwards */
    FrictionLaw friction_law    = FrictionLaw::constant;
    double      static_friction_coefficient = 0.; /**< exponential law */
    double decay_speed = 0.; /**< m/s; 0: the static coefficient holds nodes
                                  that stick, the other one all that slip */
    /** Law by a table: slip rates from 0 upwards, m/s, and coefficients. */
    std::vector<double> friction_speeds, friction_coefficients;
    FrictionDirection   friction_direction = FrictionDirection::fixed_y;
    Vector3 sliding_direction{{0., 1., 0.}}; /**< of the target, any length */
    /** Add mu p0/|V| times the slip rate across the sliding direction. */
    bool   transverse_slip_term = false;
    double sliding_speed        = 0.1126; /**< |V| at the pad centre, m/s */
    double normal_force         = 100.;   /**< N, for p0 of the slip term */
    /** p0 dmu/dV along the sliding direction: slope of the friction law, s/m */
    double friction_slope     = 0.;
    double stiffness_damping  = 0.; /**< beta, s; "per part" only */
    double structural_damping = 0.; /**< eta; "per part" only */
    /** Which of the contact states of a sweep holds; no entry of a file. */
    unsigned int state_number = 0;
  };

  /** Damping of the whole model, section "Scene/Damping". */
  struct DampingParameters
  {
    enum class Model
    {
      none,
      whole_model, /**< C = alpha M + beta K, springs and contact included */
      per_part     /**< each body, spring and contact by its own entries */
    };
    Model  model              = Model::none;
    double mass_damping       = 0.; /**< alpha, 1/s */
    double stiffness_damping  = 0.; /**< beta, s */
    double structural_damping = 0.; /**< eta: K(1 + i eta) */
  };

  /** One operator part of an imported model, "Scene/Matrix part <name>". */
  struct MatrixPartParameters
  {
    enum class Role
    {
      mass,
      damping,
      stiffness,
      normal_contact, /**< symmetric stiffness of the contact springs */
      friction,       /**< non-symmetric, multiplied by mu */
      circulatory     /**< non-symmetric, of no friction */
    };
    enum class Format
    {
      automatic, /**< from the file's ending and first lines */
      matrix_market,
      abaqus,
      nastran
    };
    std::string name;
    std::string file;
    Role        role   = Role::stiffness;
    Format      format = Format::automatic;
    std::string matrix_name; /**< DMIG matrix to take; empty: the only one */
    double      factor = 1.; /**< scalar parameter that multiplies the part */
  };

  /** The whole scene, section "Scene". */
  struct SceneParameters
  {
    enum class Kind
    {
      bodies,  /**< meshed and rigid bodies declared below */
      matrices /**< parts read from files of another code */
    };
    std::string                       name = "unnamed";
    Kind                              kind = Kind::bodies;
    std::vector<BodyParameters>       bodies;
    std::vector<TieParameters>        ties;
    std::vector<SpringParameters>     springs;
    std::vector<SupportParameters>    supports;
    std::vector<LumpedMassParameters> lumped_masses;
    std::vector<LoadParameters>       loads;
    std::vector<ContactParameters>    contacts;
    DampingParameters                 damping;
    std::vector<MatrixPartParameters> matrix_parts;
    /** Contact pattern of an imported model: CSV with one row a point pair
     * (see doc/import.md); empty: none. */
    std::string contact_pattern_file;
    double      contact_normal_stiffness = 0.; /**< N/m per pair, imported */
    double      friction_coefficient     = 0.; /**< imported models */
    std::string node_table_file; /**< CSV dof,node,component,x,y,z,body */
  };

  /** Whether loads with a pressure decide on a contact's normal forces: it is
   * that of steady sliding. */
  bool presses_contacts(const SceneParameters &scene);
} // namespace squeal

#endif
