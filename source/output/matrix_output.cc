// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/output/matrix_output.h>

#include <squeal/base/files.h>
#include <squeal/results/matrix_market.h>
#include <squeal/scene/matrix_import.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace squeal
{
  namespace
  {
    const std::string equation =
      "(lambda^2 M + lambda C + K) x = 0, friction in K, SI units";

    /** One operator of the scene with its coefficients and its file. */
    struct NamedPart
    {
      std::string      name, label;
      TermCoefficients coefficients;
      bool             symmetric, is_friction;
      /** What it counts in C beside the damping of the whole model: whatever
       * the friction is, and by friction. */
      double fixed_damping, friction_damping;

      /** What counts nowhere has no file. */
      bool
      counts() const
      {
        return !coefficients.is_zero();
      }

      std::string
      damping_label() const
      {
        return label + "_friction_damping";
      }

      /** In a scene of kind `matrices`. */
      std::string
      stiffness_role() const
      {
        return symmetric     ? "stiffness"
               : is_friction ? "friction"
                             : "circulatory";
      }
    };

    /** The coefficient in C less alpha M + beta K of the whole model. */
    double
    own_damping(const AffineTerm &term, const SceneParameters &scene)
    {
      const TermCoefficients   c = term.coefficients(scene);
      const DampingParameters &d = scene.damping;
      if (d.model != DampingParameters::Model::whole_model)
        return c.damping;
      // Beside parts of role circulatory the whole model has no damping.
      const bool   is_elastic = term.matrix->is_symmetric() || term.is_friction;
      const double whole =
        d.mass_damping * c.mass +
        (is_elastic ? d.stiffness_damping * c.stiffness.real() : 0.);
      const double rest = c.damping - whole;
      return std::abs(rest) <= 1e-13 * std::abs(whole) ? 0. : rest;
    }

    SceneParameters
    with_half_friction(SceneParameters scene)
    {
      scene.friction_coefficient *= .5;
      for (ContactParameters &contact : scene.contacts)
        {
          contact.friction_coefficient *= .5;
          contact.static_friction_coefficient *= .5;
          for (double &coefficient : contact.friction_coefficients)
            coefficient *= .5;
        }
      return scene;
    }

    /** Splits the damping, which goes with friction or does not, into both. */
    void
    split_damping(const AffineTerm      &term,
                  const SceneParameters &scene,
                  NamedPart             &part)
    {
      const double whole = own_damping(term, scene),
                   half  = own_damping(term, with_half_friction(scene));
      const auto or_zero = [whole](const double x) {
        return std::abs(x) <= 1e-12 * std::abs(whole) ? 0. : x;
      };
      part.friction_damping = or_zero(2. * (whole - half));
      part.fixed_damping    = or_zero(whole - part.friction_damping);
    }

    /** A name for files and sections: "part_01_mass_of_disc". */
    std::string
    label_of(const std::size_t number, const std::string &name)
    {
      std::string label =
        (number < 10 ? "part_0" : "part_") + std::to_string(number) + "_";
      for (const char c : name)
        label += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
      return label;
    }

    std::string
    index_of(const std::vector<NamedPart> &parts, const unsigned int n_rows)
    {
      nlohmann::ordered_json list = nlohmann::ordered_json::array();
      for (const NamedPart &part : parts)
        if (part.counts())
          list.push_back(
            {{"name", part.name},
             {"file", part.label + ".mtx"},
             {"symmetric", part.symmetric},
             {"mass", part.coefficients.mass},
             {"damping", part.coefficients.damping},
             {"stiffness", part.coefficients.stiffness.real()},
             {"stiffness_imaginary", part.coefficients.stiffness.imag()}});
      const nlohmann::ordered_json index = {{"format_version", 1},
                                            {"equation", equation},
                                            {"unknowns", n_rows},
                                            {"parts", list}};
      return index.dump(
        2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
    }

    /** Whether a scene of kind `matrices` can hold the parts. */
    bool
    can_be_imported(const std::vector<NamedPart> &parts)
    {
      return std::all_of(parts.begin(), parts.end(), [](const auto &part) {
        return part.coefficients.stiffness.imag() == 0. &&
               (part.symmetric || part.coefficients.mass == 0.);
      });
    }

    void
    write_section(std::ostream      &out,
                  const std::string &name,
                  const std::string &file,
                  const std::string &role,
                  const double       factor)
    {
      out << "\n  subsection Matrix part " << name
          << "\n    set File   = " << file << ".mtx\n    set Role   = " << role
          << "\n    set Factor = " << shortest_text(factor) << "\n  end\n";
    }

    void
    write_whole_model_damping(std::ostream            &out,
                              const DampingParameters &damping)
    {
      if (damping.model == DampingParameters::Model::whole_model)
        out << "\n  subsection Damping\n    set Model             = whole model"
            << "\n    set Mass damping      = "
            << shortest_text(damping.mass_damping)
            << "\n    set Stiffness damping = "
            << shortest_text(damping.stiffness_damping) << "\n  end\n";
    }

    bool
    has_fixed_damping(const std::vector<NamedPart> &parts)
    {
      return std::any_of(parts.begin(), parts.end(), [](const auto &part) {
        return part.fixed_damping != 0.;
      });
    }

    /** M as a whole, and C but for what comes of M, K and friction; K, its
     * circulatory parts and friction by their parts: what the undamped,
     * frictionless problem leaves out must stay apart. */
    void
    write_scene(std::ostream                 &out,
                const SceneParameters        &scene,
                const std::vector<NamedPart> &parts)
    {
      std::ostringstream sections;
      std::string        names = "mass";
      const auto         add   = [&](const std::string &name,
                           const std::string &file,
                           const std::string &role,
                           const double       factor) {
        if (name != "mass")
          names += ", " + name;
        write_section(sections, name, file, role, factor);
      };
      add("mass", "mass", "mass", 1.);
      if (has_fixed_damping(parts))
        add("damping", "fixed_damping", "damping", 1.);
      bool has_friction = false;
      for (const NamedPart &part : parts)
        {
          const double k = part.coefficients.stiffness.real();
          if (k != 0.)
            add(part.label, part.label, part.stiffness_role(), k);
          if (part.friction_damping != 0.)
            add(part.damping_label(),
                part.damping_label(),
                "friction",
                part.friction_damping);
          has_friction = has_friction ||
                         (k != 0. && part.stiffness_role() == "friction") ||
                         part.friction_damping != 0.;
        }
      out << "# Matrices of the scene " << scene.name
          << " as a scene of their own, to be included.\n"
          << "subsection Scene\n  set Name = " << scene.name << "\n"
          << "  set Kind = matrices\n  set Matrix parts = " << names << '\n';
      if (has_friction)
        out << "  # Relative to that of the run, whose contact state stays.\n"
            << "  set Friction coefficient = 1\n";
      out << sections.str();
      write_whole_model_damping(out, scene.damping);
      out << "end\n";
    }

    /** The files of the damping, which the scene of kind `matrices` has beside
     * those of the operators. Collective. */
    void
    write_damping(RunContext                   &context,
                  const AffineSystem           &system,
                  const std::vector<NamedPart> &parts,
                  const std::string            &folder)
    {
      const auto write = [&](const std::string             &name,
                             const std::vector<MatrixTerm> &terms,
                             const std::string             &comment) {
        write_matrix_market(context.output.file(folder + "/" + name + ".mtx"),
                            context.is_root,
                            *system.space,
                            terms,
                            comment);
      };
      std::vector<MatrixTerm> fixed;
      for (std::size_t i = 0; i < parts.size(); ++i)
        {
          fixed.push_back({parts[i].fixed_damping, system.terms[i].matrix});
          if (parts[i].friction_damping != 0.)
            write(parts[i].damping_label(),
                  {{1., system.terms[i].matrix}},
                  parts[i].name + "\n% " + damping_mark);
        }
      if (has_fixed_damping(parts))
        write("fixed_damping",
              fixed,
              "C of " + equation +
                " without alpha M + beta K of the whole model and friction");
    }
  } // namespace



  void
  write_matrices(RunContext        &context,
                 const Pencil      &pencil,
                 const std::string &folder)
  {
    Timers::Section         section(context.timers, "Write: matrices");
    std::vector<MatrixTerm> mass, damping, stiffness;
    for (const auto &part : pencil.parts())
      {
        mass.push_back({part.coefficients.mass, part.matrix});
        damping.push_back({part.coefficients.damping, part.matrix});
        stiffness.push_back({part.coefficients.stiffness, part.matrix});
      }
    const auto write = [&](const std::string             &name,
                           const std::vector<MatrixTerm> &terms) {
      write_matrix_market(context.output.file(folder + "/" + name + ".mtx"),
                          context.is_root,
                          *pencil.space(),
                          terms,
                          name + " of " + equation);
    };
    write("mass", mass);
    write("damping", damping);
    write("stiffness", stiffness);
  }



  void
  write_matrix_parts(RunContext         &context,
                     const AffineSystem &system,
                     const std::string  &folder)
  {
    Timers::Section        section(context.timers, "Write: matrices");
    std::vector<NamedPart> parts;
    for (const AffineTerm &term : system.terms)
      {
        parts.push_back({term.name,
                         label_of(parts.size() + 1, term.name),
                         term.coefficients(context.parameters.scene),
                         term.matrix->is_symmetric(),
                         term.is_friction,
                         0.,
                         0.});
        split_damping(term, context.parameters.scene, parts.back());
        if (parts.back().counts())
          write_matrix_market(
            context.output.file(folder + "/" + parts.back().label + ".mtx"),
            context.is_root,
            *system.space,
            {{1., term.matrix}},
            term.name);
      }
    if (can_be_imported(parts))
      write_damping(context, system, parts, folder);
    if (!context.is_root)
      return;
    write_atomically(context.output.file(folder + "/index.json"),
                     [&](std::ostream &out) {
                       out << index_of(parts, system.space->n_global()) << '\n';
                     });
    if (!can_be_imported(parts))
      {
        context.log.info("  no " + folder +
                         "/scene.prm: a scene of kind "
                         "matrices holds neither a complex stiffness nor a "
                         "non-symmetric mass");
        return;
      }
    write_atomically(context.output.file(folder + "/scene.prm"),
                     [&](std::ostream &out) {
                       write_scene(out, context.parameters.scene, parts);
                     });
  }



  void
  write_eigenpairs(RunContext         &context,
                   const RowSpace     &space,
                   const ComplexPairs &pairs,
                   const std::string  &folder)
  {
    Timers::Section       section(context.timers, "Write: matrices");
    const Eigen::MatrixXd re = space.to_root(Block(pairs.right.real())),
                          im = space.to_root(Block(pairs.right.imag()));
    if (!context.is_root)
      return;
    Eigen::MatrixXcd vectors(re.rows(), re.cols());
    vectors.real() = re;
    vectors.imag() = im;
    write_matrix_market(context.output.file(folder + "/eigenvalues.mtx"),
                        Eigen::MatrixXcd(pairs.lambda),
                        "lambda in 1/s, sigma > 0 unstable");
    write_matrix_market(context.output.file(folder + "/right_vectors.mtx"),
                        vectors,
                        "x of eigenvalues.mtx, a column each");
  }
} // namespace squeal
