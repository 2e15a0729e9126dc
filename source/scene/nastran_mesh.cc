// SPDX-License-Identifier: LGPL-2.1-or-later
#include "nastran_reader.h"

#include <squeal/base/exceptions.h>

#include <squeal/parameters/text.h>

#include <squeal/scene/mesh_cell.h>

#include <cmath>

// Entries of a Nastran bulk data file.

namespace squeal
{
  using Kind = MeshFile::Kind;
  using import::BulkEntry;

  namespace
  {
    /** Entries that hold, tie or load points or add mass, stiffness or damping,
     * which a mesh alone does not do. */
    bool
    entry_changes_model(const std::string &name)
    {
      static const std::set<std::string> names{
        "RBE1",    "RBE2",    "RBE3",    "RBAR",    "RBAR1",   "RSPLINE",
        "RROD",    "RTRPLT",  "RTRPLT1", "RJOINT",  "RSSCON",  "MPC",
        "MPCADD",  "BCTABLE", "BCTABL1", "BCONP",   "BCTSET",  "BCTADD",
        "BCTPARA", "BGSET",   "BGADD",   "TIE",     "CONTACT", "CWELD",
        "CFAST",   "CSEAM",   "SPC",     "SPC1",    "SPCADD",  "SPCD",
        "SUPORT",  "SUPORT1", "CBUSH",   "CBUSH1D", "CBUSH2D", "CELAS1",
        "CELAS2",  "CELAS3",  "CELAS4",  "CDAMP1",  "CDAMP2",  "CDAMP3",
        "CDAMP4",  "CDAMP5",  "CVISC",   "CGAP",    "GENEL",   "DMIG",
        "CBAR",    "CBEAM",   "CBEND",   "CROD",    "CONROD",  "CTUBE",
        "CONM1",   "CONM2",   "CMASS1",  "CMASS2",  "CMASS3",  "CMASS4",
        "NSM",     "NSM1",    "NSML",    "NSML1",   "NSMADD",  "TEMP",
        "TEMPD",   "TABDMP1"};
      return names.count(name) > 0;
    }

    /** Why a material of another entry than MAT1 cannot be used; null for what
     * is none or is of plates alone. */
    const char *
    fault_of_material(const std::string &name)
    {
      static const std::map<std::string, const char *> faults{
        {"MAT9", "is not isotropic (MAT9)"},
        {"MAT11", "is not isotropic (MAT11)"},
        {"MAT12", "is not isotropic (MAT12)"},
        {"MAT10", "is a fluid (MAT10)"},
        {"MATHP", "is hyperelastic (MATHP)"}};
      const auto it = faults.find(name);
      return it == faults.end() ? nullptr : it->second;
    }

    /** Names of plates by what stands in front of the number of nodes. */
    bool
    is_plate(const std::string &name)
    {
      return name == "CQUAD4" || name == "CQUAD8" || name == "CQUADR" ||
             name == "CQUAD" || name == "CSHEAR";
    }

    Kind
    kind_of_entry(const std::string &name)
    {
      if (name == "CHEXA")
        return Kind::hexahedron;
      if (name == "CTETRA")
        return Kind::tetrahedron;
      if (name == "CPENTA")
        return Kind::wedge;
      if (name == "CPYRAM" || name == "CPYRA")
        return Kind::pyramid;
      if (is_plate(name))
        return Kind::quadrilateral;
      return Kind::other_surface;
    }
  } // namespace



  long
  NastranReader::integer(const BulkEntry  &entry,
                         const std::size_t i,
                         const char       *what) const
  {
    long value = 0;
    if (!import::parse_integer(entry.field(i), value))
      text.fail_at(entry.line,
                   entry.name + ": " + what + " " +
                     prm::in_quotes(entry.field(i)) + " is not an integer");
    return value;
  }

  long
  NastranReader::integer_or(const BulkEntry  &entry,
                            const std::size_t i,
                            const long        otherwise,
                            const char       *what) const
  {
    return entry.field(i).empty() ? otherwise : integer(entry, i, what);
  }

  double
  NastranReader::real_or_zero(const BulkEntry  &entry,
                              const std::size_t i,
                              const char       *what) const
  {
    double value = 0.;
    if (!entry.field(i).empty() &&
        (!import::parse_real(entry.field(i), value) || !std::isfinite(value)))
      text.fail_at(entry.line,
                   entry.name + ": " + what + " " +
                     prm::in_quotes(entry.field(i)) +
                     " is not a finite number");
    return value;
  }

  unsigned int
  NastranReader::point(const long number, const unsigned int line) const
  {
    const auto it = index_of_point.find(number);
    if (it == index_of_point.end())
      text.fail_at(
        line, "grid point " + std::to_string(number) + " is not in the file");
    return it->second;
  }



  /** Numbers of points and elements begin anew in each superelement. */
  void
  NastranReader::refuse_parts(const unsigned int line) const
  {
    text.fail_at(line,
                 "parts of a model (BEGIN SUPER) are not put together: write "
                 "one BEGIN BULK without superelements");
  }

  /** What precedes the bulk data controls an analysis; parameters may stand
   * there, too. */
  void
  NastranReader::go_to_bulk_data()
  {
    while (text.next())
      if (const auto words = import::split_at_blanks_and_commas(text.line());
          import::upper_case(words[0]) == "BEGIN" &&
          import::upper_case(words[1]).compare(0, 4, "BULK") == 0)
        {
          // A part of its own: BEGIN BULK SUPER = 1.
          if (!words[2].empty() && words[2][0] != '$')
            refuse_parts(text.line_number());
          has_bulk_begin = true;
          take_case_control(text.line_number());
          return;
        }
    text.rewind();
  }

  /** Takes what matters of the lines up to @p n_lines, which is that of BEGIN
   * BULK. */
  void
  NastranReader::take_case_control(const unsigned int n_lines)
  {
    text.rewind();
    while (text.next() && text.line_number() < n_lines)
      {
        const auto line = text.line();
        const auto words =
          import::split_at_blanks_and_commas(line.substr(0, line.find('$')));
        const std::string name = import::upper_case(words[0]);
        if (name == "PARAM" || name == "PARAM*")
          read_parameter({"PARAM",
                          {std::string(words[1]), std::string(words[2])},
                          text.line_number()});
        else if (prm::starts_with(name, "INCLUDE"))
          text.fail("INCLUDE is not followed: put the files together");
      }
  }

  MeshFile
  NastranReader::read()
  {
    go_to_bulk_data();
    import::BulkEntries entries(text);
    BulkEntry           entry;
    while (entries.next(entry))
      take(entry);
    if (has_bulk_begin && !entries.has_end())
      throw InputError(text.name() + " is truncated: it has no ENDDATA");
    if (!entries.has_end())
      text.check_last_line_is_complete();
    finish();
    return std::move(file);
  }



  void
  NastranReader::take(const BulkEntry &entry)
  {
    const std::string &name = entry.name;
    if (name == "GRID")
      read_point(entry);
    else if (name == "GRDSET")
      {
        note_constraints(entry);
        if (integer_or(entry, 1, 0, "coordinate system") != 0)
          text.fail_at(entry.line,
                       "GRDSET: coordinates in a system of their own are not "
                       "read: write them in the basic one");
      }
    else if (name == "CHEXA" || name == "CTETRA" || name == "CPENTA" ||
             name == "CPYRAM" || name == "CPYRA" || is_plate(name) ||
             name == "CTRIA3" || name == "CTRIA6" || name == "CTRIAR")
      read_cell(entry);
    else if (name == "PSOLID" || name == "PLSOLID")
      read_property(entry);
    else if (name == "MAT1")
      read_material(entry);
    else if (const char *fault = fault_of_material(name))
      add_material(entry,
                   {std::to_string(integer(entry, 0, "number of a material")),
                    fault,
                    0.,
                    0.,
                    0.});
    else if (name == "MATT1")
      faults[integer(entry, 0, "number of a material")] =
        "depends on temperature";
    else if (name == "MATF1")
      faults[integer(entry, 0, "number of a material")] =
        "depends on frequency (MATF1)";
    else if (name == "PARAM")
      read_parameter(entry);
    else if (name == "PLOAD4")
      read_load(entry);
    else if (name == "SET1")
      read_set(entry, 1);
    else if (name == "SET3")
      {
        const std::string what = import::upper_case(entry.field(1));
        if (what == "GRID" || what == "POINT" ||
            what.compare(0, 4, "ELEM") == 0)
          read_set(entry, 2);
      }
    else if (name.compare(0, 5, "BEGIN") == 0)
      refuse_parts(entry.line);
    else if (name.compare(0, 7, "INCLUDE") == 0)
      text.fail_at(entry.line,
                   "INCLUDE is not followed: put the files together");
    else if (entry_changes_model(name))
      file.passed_over.insert(name);
  }



  void
  NastranReader::read_point(const BulkEntry &entry)
  {
    const long number = integer(entry, 0, "number of a grid point");
    if (integer_or(entry, 1, 0, "coordinate system") != 0)
      text.fail_at(entry.line,
                   "grid point " + std::to_string(number) +
                     " is in the coordinate system " + entry.field(1) +
                     ": write all points in the basic one");
    if (!index_of_point.emplace(number, file.nodes.size()).second)
      text.fail_at(entry.line,
                   "grid point " + std::to_string(number) + " is there twice");
    file.nodes.emplace_back(real_or_zero(entry, 2, "coordinate"),
                            real_or_zero(entry, 3, "coordinate"),
                            real_or_zero(entry, 4, "coordinate"));
    note_constraints(entry);
  }

  /** Field PS of GRID and GRDSET holds points at zero. */
  void
  NastranReader::note_constraints(const BulkEntry &entry)
  {
    if (integer_or(entry, 6, 0, "permanent constraints (PS)") != 0)
      file.passed_over.insert(entry.name + " permanent constraints (PS)");
  }

  void
  NastranReader::read_cell(const BulkEntry &entry)
  {
    const long        number = integer(entry, 0, "number of an element");
    Cell              cell{file.elements.size(),
              integer_or(entry, 1, number, "property"),
              {},
              entry.line};
    const Kind        kind     = kind_of_entry(entry.name);
    const std::size_t n_points = kind == Kind::hexahedron      ? 20
                                 : kind == Kind::quadrilateral ? 4
                                                               : 0;
    for (std::size_t i = 0; i < n_points; ++i)
      cell.points.push_back(integer_or(entry, 2 + i, 0, "grid point"));
    if (kind == Kind::hexahedron)
      for (std::size_t i = 22; i < entry.fields.size(); ++i)
        if (!entry.field(i).empty())
          text.fail_at(entry.line,
                       "CHEXA " + std::to_string(number) +
                         " has more than 20 grid points");
    if (!cell_of_element.emplace(number, cells.size()).second)
      text.fail_at(entry.line,
                   "element " + std::to_string(number) + " is there twice");
    file.elements.push_back({number, kind, 0, {}, -1});
    cells.push_back(std::move(cell));
  }

  void
  NastranReader::read_load(const BulkEntry &entry)
  {
    // Without corners, or "THRU" and another element, it is on plates.
    if (entry.field(6).empty() || import::upper_case(entry.field(6)) == "THRU")
      return;
    loads.push_back(
      {integer(entry, 1, "element"),
       integer(entry, 6, "grid point"),
       integer_or(entry, 7, 0, "grid point"),
       "load " + std::to_string(integer(entry, 0, "set of loads")),
       entry.line});
  }

  void
  NastranReader::read_property(const BulkEntry &entry)
  {
    const long        property = integer(entry, 0, "property");
    const std::string function =
      entry.name == "PSOLID" ? import::upper_case(entry.field(6)) : "";
    if (!sections
           .emplace(property,
                    Section{integer(entry, 1, "material"),
                            function == "PFLUID" || function == "FFLUID",
                            entry.line})
           .second)
      text.fail_at(entry.line,
                   "property " + std::to_string(property) + " is there twice");
  }

  void
  NastranReader::read_material(const BulkEntry &entry)
  {
    const long         number = integer(entry, 0, "number of a material");
    double             E      = real_or_zero(entry, 1, "Young's modulus");
    const double       G      = real_or_zero(entry, 2, "shear modulus");
    double             nu     = real_or_zero(entry, 3, "Poisson's ratio");
    MeshFile::Material material{std::to_string(number), "", 0., 0., 0.};
    // Two of the three give the third; one that is left out is 0 here.
    if (entry.field(1).empty())
      E = 2. * G * (1. + nu);
    else if (entry.field(3).empty())
      nu = entry.field(2).empty() ? 0. : .5 * E / G - 1.;
    else if (!entry.field(2).empty() &&
             std::abs(2. * G * (1. + nu) - E) > .01 * E)
      material.fault = "G is not E/2(1 + nu)";
    material.young_modulus = E;
    material.poisson_ratio = nu;
    material.density       = real_or_zero(entry, 4, "density");
    if (real_or_zero(entry, 7, "structural damping") != 0.)
      file.passed_over.insert("MAT1 damping (GE)");
    add_material(entry, material);
  }

  void
  NastranReader::add_material(const BulkEntry          &entry,
                              const MeshFile::Material &material)
  {
    if (!materials
           .emplace(integer(entry, 0, "number of a material"),
                    file.materials.size())
           .second)
      text.fail_at(entry.line, "material " + material.name + " is there twice");
    file.materials.push_back(material);
  }

  /** Parameters of analyses are none of a mesh, but one changes what densities
   * are and some are damping. */
  void
  NastranReader::read_parameter(const BulkEntry &entry)
  {
    const std::string name = import::upper_case(entry.field(0));
    if (name == "G" || name == "GFL" || name == "ALPHA1" || name == "ALPHA2")
      if (real_or_zero(entry, 1, "damping") != 0.)
        file.passed_over.insert("PARAM," + name);
    if (name != "WTMASS")
      return;
    const double factor = real_or_zero(entry, 1, "factor of weights");
    if (!(factor > 0.))
      text.fail_at(entry.line, "PARAM,WTMASS must be positive");
    // Programs differ in which of two values they take.
    if (mass_factor && *mass_factor != factor)
      text.fail_at(entry.line,
                   "PARAM,WTMASS has another value above: leave one of them");
    mass_factor = factor;
  }

  void
  NastranReader::finish_materials()
  {
    for (auto &material : file.materials)
      material.density *= mass_factor.value_or(1.);
    for (const auto &[number, fault] : faults)
      if (const auto it = materials.find(number); it != materials.end())
        file.materials[it->second].fault = fault;
  }

  void
  NastranReader::read_set(const BulkEntry &entry, const std::size_t first)
  {
    const bool is_points =
      first == 1 || import::upper_case(entry.field(1))[0] != 'E';
    auto &ranges =
      (is_points ? point_sets : cell_sets)[integer(entry, 0, "set")];
    for (std::size_t i = first; i < entry.fields.size(); ++i)
      {
        if (entry.field(i).empty())
          continue;
        const std::string word = import::upper_case(entry.field(i));
        if (word == "THRU")
          {
            if (ranges.empty())
              text.fail_at(entry.line, "THRU has nothing in front");
            ranges.back()[1] = integer(entry, ++i, "end of THRU");
          }
        else if (word == "BY" || word == "EXCEPT" || word == "SKIN")
          text.fail_at(entry.line,
                       entry.name + ": " + word + " is not read: list the " +
                         (is_points ? "grid points" : "elements"));
        else
          {
            const long number = integer(entry, i, "member of a set");
            ranges.push_back({{number, number}});
          }
      }
  }


  MeshFile
  read_nastran_mesh(const std::string              &name,
                    const std::vector<std::string> &sets)
  {
    return NastranReader(name, sets).read();
  }
} // namespace squeal
