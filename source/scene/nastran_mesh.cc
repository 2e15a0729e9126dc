// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/text.h>

#include <squeal/scene/bulk_data.h>
#include <squeal/scene/mesh_cell.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

namespace squeal
{
  namespace
  {
    using Kind = MeshFile::Kind;
    using import::BulkEntry;

    const char *const bulk_begin = "BEGIN BULK";

    /** Entries that tie points or bodies together, which a mesh alone does not
     * do. */
    bool
    couples(const std::string &name)
    {
      static const std::set<std::string> names{
        "RBE1", "RBE2",    "RBE3",    "RBAR",    "RSPLINE", "RROD",  "RTRPLT",
        "MPC",  "MPCADD",  "BCTABLE", "BCTABL1", "BCONP",   "BGSET", "BGADD",
        "TIE",  "CONTACT", "CBUSH",   "CELAS1",  "CELAS2",  "CONM2", "CONM1"};
      return names.count(name) > 0;
    }

    /** Names of plates by what stands in front of the number of nodes. */
    bool
    is_plate(const std::string &name)
    {
      return name == "CQUAD4" || name == "CQUAD8" || name == "CQUADR" ||
             name == "CQUAD" || name == "CSHEAR";
    }

    Kind
    kind_of(const std::string &name)
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



    class NastranReader
    {
    public:
      NastranReader(const std::string              &name,
                    const std::vector<std::string> &sets)
        : text(name)
        , wanted(sets.begin(), sets.end())
      {
      }

      MeshFile read();

    private:
      /** A face of a load: an element and two opposite corners. */
      struct Load
      {
        long         element, corner, opposite;
        std::string  name;
        unsigned int line;
      };
      struct Cell
      {
        std::size_t       position; /**< in the elements of the file */
        long              property;
        std::vector<long> points;
        unsigned int      line;
      };
      struct Section
      {
        long         material;
        unsigned int line;
      };

      void         go_to_bulk_data();
      void         take(const BulkEntry &entry);
      void         read_point(const BulkEntry &entry);
      void         read_cell(const BulkEntry &entry);
      void         read_load(const BulkEntry &entry);
      void         read_material(const BulkEntry &entry);
      void         read_set(const BulkEntry &entry, const std::size_t first);
      void         finish();
      void         number_points();
      void         place_hexahedron(const Cell &cell);
      void         add_face_of(const Load &load);
      void         add_point_sets();
      void         group_cells();
      int          tag_of_surface(const std::string &name);
      int          tag_of_volume(const std::string &name);
      unsigned int group_of(const std::vector<int> &tags);

      long         integer(const BulkEntry  &entry,
                           const std::size_t i,
                           const char       *what) const;
      long         integer_or(const BulkEntry  &entry,
                              const std::size_t i,
                              const long        otherwise,
                              const char       *what) const;
      double       real_or_zero(const BulkEntry  &entry,
                                const std::size_t i,
                                const char       *what) const;
      unsigned int point(const long number, const unsigned int line) const;

      import::TextFile                                 text;
      const std::set<std::string>                      wanted;
      MeshFile                                         file;
      bool                                             has_bulk_begin = false;
      std::unordered_map<long, unsigned int>           index_of_point;
      std::vector<Cell>                                cells;
      std::unordered_map<long, std::size_t>            cell_of_element;
      std::vector<Load>                                loads;
      std::map<long, Section>                          sections;
      std::map<long, int>                              materials;
      std::map<long, std::vector<std::array<long, 2>>> point_sets, cell_sets;
      std::map<std::string, int>               surface_tags, volume_tags;
      std::map<std::vector<int>, unsigned int> known_groups;
    };



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



    /** What precedes the bulk data controls an analysis. */
    void
    NastranReader::go_to_bulk_data()
    {
      while (text.next())
        if (import::upper_case(import::trimmed(text.line()))
              .compare(0, std::string(bulk_begin).size(), bulk_begin) == 0)
          {
            has_bulk_begin = true;
            return;
          }
      text.rewind();
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
        {
          const long property = integer(entry, 0, "property");
          if (!sections
                 .emplace(property,
                          Section{integer(entry, 1, "material"), entry.line})
                 .second)
            text.fail_at(entry.line,
                         "property " + std::to_string(property) +
                           " is there twice");
        }
      else if (name == "MAT1")
        read_material(entry);
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
      else if (name.compare(0, 7, "INCLUDE") == 0)
        text.fail_at(entry.line,
                     "INCLUDE is not followed: put the files together");
      else if (couples(name))
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
                     "grid point " + std::to_string(number) +
                       " is there twice");
      file.nodes.emplace_back(real_or_zero(entry, 2, "coordinate"),
                              real_or_zero(entry, 3, "coordinate"),
                              real_or_zero(entry, 4, "coordinate"));
    }

    void
    NastranReader::read_cell(const BulkEntry &entry)
    {
      const long        number = integer(entry, 0, "number of an element");
      Cell              cell{file.elements.size(),
                integer_or(entry, 1, number, "property"),
                {},
                entry.line};
      const Kind        kind     = kind_of(entry.name);
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
      if (entry.field(6).empty() ||
          import::upper_case(entry.field(6)) == "THRU")
        return;
      loads.push_back(
        {integer(entry, 1, "element"),
         integer(entry, 6, "grid point"),
         integer_or(entry, 7, 0, "grid point"),
         "load " + std::to_string(integer(entry, 0, "set of loads")),
         entry.line});
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
      if (!materials.emplace(number, file.materials.size()).second)
        text.fail_at(entry.line,
                     "material " + std::to_string(number) + " is there twice");
      file.materials.push_back(material);
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



    int
    NastranReader::tag_of_surface(const std::string &name)
    {
      const auto [it, is_new] =
        surface_tags.emplace(name, 1 + surface_tags.size());
      file.surface_names[it->second] = name;
      return it->second;
    }

    int
    NastranReader::tag_of_volume(const std::string &name)
    {
      const auto [it, is_new] =
        volume_tags.emplace(name, 1 + volume_tags.size());
      file.volume_names[it->second] = name;
      return it->second;
    }

    unsigned int
    NastranReader::group_of(const std::vector<int> &tags)
    {
      const auto [it, is_new] = known_groups.emplace(tags, file.groups.size());
      if (is_new)
        file.groups.push_back(tags);
      return it->second;
    }



    void
    NastranReader::place_hexahedron(const Cell &cell)
    {
      auto                     &element = file.elements[cell.position];
      std::vector<unsigned int> nodes;
      const bool                is_linear = std::all_of(cell.points.begin() + 8,
                                         cell.points.end(),
                                         [](const long p) { return p == 0; });
      for (unsigned int i = 0; i < (is_linear ? 8 : 20); ++i)
        if (cell.points[i] != 0 || i < 8)
          nodes.push_back(point(cell.points[i], cell.line));
        else
          {
            // An edge without its middle point is straight.
            const auto ends = ends_of_nastran_edge(i);
            nodes.push_back(file.nodes.size());
            file.nodes.push_back(
              file.nodes[nodes[ends[0]]] +
              .5 * (file.nodes[nodes[ends[1]]] - file.nodes[nodes[ends[0]]]));
          }
      element.nodes = in_gmsh_order(nodes, NodeOrder::nastran);
    }

    void
    NastranReader::number_points()
    {
      for (const Cell &cell : cells)
        {
          auto &element = file.elements[cell.position];
          if (element.kind == Kind::hexahedron)
            place_hexahedron(cell);
          else if (element.kind == Kind::quadrilateral)
            for (const long p : cell.points)
              element.nodes.push_back(point(p, cell.line));
        }
    }

    void
    NastranReader::group_cells()
    {
      std::map<long, std::vector<int>> sets_of_element;
      for (const auto &[number, ranges] : cell_sets)
        for (const auto &cell : file.elements)
          if (std::any_of(ranges.begin(), ranges.end(), [&](const auto &r) {
                return r[0] <= cell.tag && cell.tag <= r[1];
              }))
            sets_of_element[cell.tag].push_back(
              tag_of_volume("set " + std::to_string(number)));
      for (const Cell &cell : cells)
        {
          auto      &element  = file.elements[cell.position];
          const bool is_skin  = element.kind == Kind::quadrilateral;
          const auto property = std::to_string(cell.property);
          if (is_skin && !wanted.empty() && wanted.count(property) == 0)
            {
              element.kind = Kind::other_surface;
              element.nodes.clear();
            }
          std::vector<int> tags;
          if (element.kind == Kind::quadrilateral)
            tags = {tag_of_surface(property)};
          else if (element.kind != Kind::other_surface)
            {
              tags = sets_of_element[element.tag];
              tags.push_back(tag_of_volume(property));
              const auto section = sections.find(cell.property);
              if (section != sections.end())
                {
                  const auto material =
                    materials.find(section->second.material);
                  if (material != materials.end())
                    element.material = material->second;
                }
            }
          element.group = group_of(tags);
        }
    }



    void
    NastranReader::add_face_of(const Load &load)
    {
      const auto found = cell_of_element.find(load.element);
      if (found == cell_of_element.end())
        text.fail_at(load.line,
                     "element " + std::to_string(load.element) +
                       " is not in the file");
      const auto &element = file.elements[cells[found->second].position];
      if (element.kind != Kind::hexahedron ||
          (!wanted.empty() && wanted.count(load.name) == 0))
        return;
      const unsigned int a = point(load.corner, load.line),
                         b = point(load.opposite, load.line);
      for (const auto &corners : faces_of_gmsh_cell())
        {
          std::vector<unsigned int> nodes;
          for (const unsigned int c : corners)
            nodes.push_back(element.nodes[c]);
          if ((nodes[0] == a && nodes[2] == b) ||
              (nodes[2] == a && nodes[0] == b) ||
              (nodes[1] == a && nodes[3] == b) ||
              (nodes[3] == a && nodes[1] == b))
            {
              file.elements.push_back({load.element,
                                       Kind::quadrilateral,
                                       group_of({tag_of_surface(load.name)}),
                                       nodes,
                                       -1});
              return;
            }
        }
      text.fail_at(load.line,
                   "PLOAD4: grid points " + std::to_string(load.corner) +
                     " and " + std::to_string(load.opposite) +
                     " are no opposite corners of a face of element " +
                     std::to_string(load.element));
    }

    void
    NastranReader::add_point_sets()
    {
      for (const auto &[number, ranges] : point_sets)
        {
          const std::string name = "set " + std::to_string(number);
          if (wanted.count(name) == 0)
            continue;
          std::vector<bool> holds(file.nodes.size(), false);
          for (const auto &[point_number, index] : index_of_point)
            for (const auto &range : ranges)
              if (range[0] <= point_number && point_number <= range[1])
                holds[index] = true;
          add_faces_of_nodes(file, holds, group_of({tag_of_surface(name)}));
        }
    }

    void
    NastranReader::finish()
    {
      if (file.nodes.empty() || cells.empty())
        throw InputError(text.name() + " is no mesh or truncated: it has no " +
                         (file.nodes.empty() ? "GRID" : "elements"));
      number_points();
      group_cells();
      for (const Load &load : loads)
        add_face_of(load);
      add_point_sets();
    }
  } // namespace



  MeshFile
  read_nastran_mesh(const std::string              &name,
                    const std::vector<std::string> &sets)
  {
    return NastranReader(name, sets).read();
  }
} // namespace squeal
