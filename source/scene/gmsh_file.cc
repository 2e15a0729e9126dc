// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/input_file.h>

#include <squeal/parameters/text.h>

#include <squeal/scene/import_text.h>
#include <squeal/scene/mesh_file.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <unordered_map>

namespace squeal
{
  namespace
  {
    using Kind = MeshFile::Kind;

    /** The kind of Gmsh's element types. */
    Kind
    kind_of_type(const long type)
    {
      static const std::map<Kind, std::vector<long>> types{
        {Kind::low_dimensional, {15, 1, 8, 26, 27, 28, 62, 63, 64, 65, 66}},
        {Kind::quadrilateral, {3, 10, 16}},
        {Kind::other_surface, {2, 9}},
        {Kind::hexahedron, {5, 12, 17}},
        {Kind::higher_order_hexahedron, {92, 93, 94, 95, 96, 97, 98}},
        {Kind::tetrahedron, {4, 11, 29, 30, 31}},
        {Kind::wedge, {6, 13, 18}},
        {Kind::pyramid, {7, 14, 19}}};
      for (const auto &[kind, numbers] : types)
        if (std::find(numbers.begin(), numbers.end(), type) != numbers.end())
          return kind;
      // triangles and quadrilaterals of order 3 to 10
      if ((type >= 20 && type <= 25) || (type >= 36 && type <= 61))
        return Kind::other_surface;
      return Kind::other_volume;
    }



    /** Nodes that are kept of an element of Gmsh's types: of hexahedra and
     * quadrilaterals of first and second order. */
    unsigned int
    n_nodes_read(const long type)
    {
      static const std::map<long, unsigned int> numbers{
        {3, 4}, {16, 8}, {10, 9}, {5, 8}, {17, 20}, {12, 27}};
      const auto it = numbers.find(type);
      return it == numbers.end() ? 0 : it->second;
    }



    class GmshReader
    {
    public:
      explicit GmshReader(const std::string &name)
        : text(name)
        , file_size(std::filesystem::file_size(name))
      {
      }

      MeshFile read();

    private:
      /** The next line that is not blank, to be taken apart by next_...(). */
      void             next_line(const std::string &section);
      std::string_view next_field(const char *what);
      long             next_integer(const char *what);
      double           next_real(const char *what);
      /** A number of entries that the file can hold. */
      std::size_t      next_count(const char *what);
      std::vector<int> next_physical_tags();

      void         read_format();
      void         read_physical_names();
      void         read_entities();
      void         read_nodes();
      void         read_node_block();
      void         read_elements();
      void         read_element_block();
      void         read_element_2();
      void         add_element(const long         tag,
                               const long         type,
                               const unsigned int group);
      void         add_node(const long tag);
      void         skip(const std::string &section);
      unsigned int group_of(const std::vector<int> &physical_tags);

      import::TextFile text;
      std::size_t      file_size;
      std::string_view rest; /**< of the current line */
      MeshFile         file;
      bool version_4 = false, has_nodes = false, has_elements = false;
      std::unordered_map<long, unsigned int>            index_of_node;
      std::map<std::vector<int>, unsigned int>          known_groups;
      std::map<std::pair<long, long>, std::vector<int>> entity_tags;
    };



    MeshFile
    GmshReader::read()
    {
      bool has_format = false;
      while (text.next())
        {
          const std::string section(import::trimmed(text.line()));
          if (section.empty())
            continue;
          if (!has_format && section != "$MeshFormat" && section != "$Comments")
            throw InputError(text.name() + " is no Gmsh mesh: it does not "
                                           "start with $MeshFormat");
          if (section[0] != '$')
            text.fail("expected the start of a section such as $Nodes, got " +
                      prm::in_quotes(section));
          if (section == "$MeshFormat")
            {
              read_format();
              has_format = true;
            }
          else if (section == "$PhysicalNames")
            read_physical_names();
          else if (section == "$Entities")
            read_entities();
          // Version 2 with Mesh.SaveParametric: more numbers behind x, y, z.
          else if (section == "$Nodes" || section == "$ParametricNodes")
            read_nodes();
          else if (section == "$Elements")
            read_elements();
          else if (section == "$PartitionedEntities")
            text.fail("the mesh is partitioned: save it without partitions");
          else
            {
              skip(section);
              continue;
            }
          const std::string end = "$End" + section.substr(1);
          next_line(section);
          if (import::trimmed(text.line()) != end)
            text.fail("expected " + end + ": " + section +
                      " holds more than it says, or is damaged");
        }
      if (!has_nodes || !has_elements)
        throw InputError(text.name() + " is truncated: it has no section " +
                         (has_nodes ? "$Elements" : "$Nodes"));
      return std::move(file);
    }



    void
    GmshReader::next_line(const std::string &section)
    {
      do
        if (!text.next())
          throw InputError(text.name() + " is truncated: it ends inside " +
                           section);
      while (import::trimmed(text.line()).empty());
      rest = text.line();
    }



    std::string_view
    GmshReader::next_field(const char *what)
    {
      rest             = import::trimmed(rest);
      const auto end   = std::min(rest.find_first_of(" \t"), rest.size());
      const auto field = rest.substr(0, end);
      rest.remove_prefix(end);
      if (field.empty() || field[0] == '$')
        text.fail(std::string("expected ") + what + ", found " +
                  (field.empty() ? "the end of the line" : std::string(field)) +
                  ": the section is truncated or damaged");
      return field;
    }

    long
    GmshReader::next_integer(const char *what)
    {
      return import::integer_field(text, next_field(what), what);
    }

    double
    GmshReader::next_real(const char *what)
    {
      return import::real_field(text, next_field(what), what);
    }

    std::size_t
    GmshReader::next_count(const char *what)
    {
      const long n = next_integer(what);
      if (n < 0 || n > static_cast<long>(file_size))
        text.fail(std::string(what) + " " + std::to_string(n) +
                  " cannot be right");
      return n;
    }

    std::vector<int>
    GmshReader::next_physical_tags()
    {
      std::vector<int> tags;
      for (std::size_t n = next_count("number of physical tags"); n > 0; --n)
        // a negative tag is the group with its orientation reversed
        tags.push_back(std::abs(next_integer("physical tag")));
      return tags;
    }



    void
    GmshReader::read_format()
    {
      next_line("$MeshFormat");
      const std::string version(next_field("version"));
      const long        type = next_integer("file type");
      version_4              = version == "4.1";
      file.repeats_cells     = !version_4;
      if (!version_4 && version != "2" && version != "2.1" && version != "2.2")
        text.fail("format " + prm::in_quotes(version) +
                  " is not read: save the mesh as version 4.1 or 2.2 "
                  "(Mesh.MshFileVersion)");
      if (type != 0)
        text.fail("the file is binary: save it as ASCII (Mesh.Binary = 0)");
    }



    void
    GmshReader::read_physical_names()
    {
      next_line("$PhysicalNames");
      for (std::size_t n = next_count("number of names"); n > 0; --n)
        {
          next_line("$PhysicalNames");
          const long       dimension = next_integer("dimension");
          const long       tag       = next_integer("physical tag");
          std::string_view name      = import::trimmed(rest);
          if (name.size() < 2 || name.front() != '"' || name.back() != '"')
            text.fail("expected a physical name in double quotes");
          name = name.substr(1, name.size() - 2);
          if (dimension == 2)
            file.surface_names[std::abs(tag)] = name;
          if (dimension == 3)
            file.volume_names[std::abs(tag)] = name;
        }
    }



    void
    GmshReader::read_entities()
    {
      next_line("$Entities");
      std::array<std::size_t, 4> n;
      for (auto &count : n)
        count = next_count("number of entities");
      for (unsigned int dimension = 0; dimension < 4; ++dimension)
        for (std::size_t i = 0; i < n[dimension]; ++i)
          {
            next_line("$Entities");
            const long tag = next_integer("entity");
            for (unsigned int c = 0; c < (dimension == 0 ? 3 : 6); ++c)
              next_real("coordinate");
            entity_tags[{dimension, tag}] = next_physical_tags();
          }
    }



    void
    GmshReader::add_node(const long tag)
    {
      std::array<double, 3> x;
      for (auto &coordinate : x)
        coordinate = next_real("coordinate");
      if (!index_of_node.emplace(tag, file.nodes.size()).second)
        text.fail("node " + std::to_string(tag) + " is there twice");
      file.nodes.emplace_back(x[0], x[1], x[2]);
    }

    void
    GmshReader::read_node_block()
    {
      next_line("$Nodes");
      next_integer("dimension");
      next_integer("entity");
      next_integer("parametric flag");
      std::vector<long> tags(next_count("number of nodes"));
      for (auto &tag : tags)
        {
          next_line("$Nodes");
          tag = next_integer("node");
        }
      for (const long tag : tags)
        {
          next_line("$Nodes");
          add_node(tag);
        }
    }

    void
    GmshReader::read_nodes()
    {
      has_nodes = true;
      next_line("$Nodes");
      std::size_t n = next_count("number of nodes or blocks");
      for (; n > 0; --n)
        if (version_4)
          read_node_block();
        else
          {
            next_line("$Nodes");
            add_node(next_integer("node"));
          }
    }



    unsigned int
    GmshReader::group_of(const std::vector<int> &physical_tags)
    {
      const auto found =
        known_groups.emplace(physical_tags, file.groups.size());
      if (found.second)
        file.groups.push_back(physical_tags);
      return found.first->second;
    }

    void
    GmshReader::add_element(const long         tag,
                            const long         type,
                            const unsigned int group)
    {
      MeshFile::Element element{tag, kind_of_type(type), group, {}};
      if (element.kind == Kind::low_dimensional)
        return;
      for (unsigned int v = 0; v < n_nodes_read(type); ++v)
        {
          const long node = next_integer("node");
          const auto it   = index_of_node.find(node);
          if (it == index_of_node.end())
            text.fail("element " + std::to_string(tag) + " refers to node " +
                      std::to_string(node) + ", which is not in the file");
          element.nodes.push_back(it->second);
        }
      if (!element.nodes.empty() && !import::trimmed(rest).empty())
        text.fail("element " + std::to_string(tag) + " has more than the " +
                  std::to_string(element.nodes.size()) +
                  " nodes of its type: " + prm::in_quotes(std::string(rest)));
      file.elements.push_back(std::move(element));
    }

    void
    GmshReader::read_element_block()
    {
      next_line("$Elements");
      const long         dimension = next_integer("dimension");
      const long         entity    = next_integer("entity");
      const long         type      = next_integer("element type");
      const auto         it        = entity_tags.find({dimension, entity});
      const unsigned int group =
        group_of(it == entity_tags.end() ? std::vector<int>() : it->second);
      for (std::size_t n = next_count("number of elements"); n > 0; --n)
        {
          next_line("$Elements");
          add_element(next_integer("element"), type, group);
        }
    }

    void
    GmshReader::read_element_2()
    {
      next_line("$Elements");
      const long       tag    = next_integer("element");
      const long       type   = next_integer("element type");
      const auto       n_tags = next_count("number of tags");
      std::vector<int> physical;
      for (unsigned int i = 0; i < n_tags; ++i)
        {
          const long value = next_integer("tag");
          if (i == 0 && value != 0)
            physical.push_back(std::abs(value));
        }
      add_element(tag, type, group_of(physical));
    }

    void
    GmshReader::read_elements()
    {
      if (!has_nodes)
        text.fail("$Elements must come after $Nodes");
      has_elements = true;
      next_line("$Elements");
      std::size_t n = next_count("number of elements or blocks");
      for (; n > 0; --n)
        if (version_4)
          read_element_block();
        else
          read_element_2();
    }



    void
    GmshReader::skip(const std::string &section)
    {
      const std::string end = "$End" + section.substr(1);
      do
        next_line(section);
      while (import::trimmed(text.line()) != end);
    }



    /** Binary files deserve a better word than "not a text file". */
    void
    refuse_binary(const std::string &name)
    {
      std::ifstream in(name, std::ios::binary);
      std::string   section, version, type;
      if (in >> section >> version >> type && section == "$MeshFormat" &&
          type == "1")
        throw InputError(name + ": the mesh is binary: save it as ASCII "
                                "(Mesh.Binary = 0)");
    }
  } // namespace



  MeshFile
  read_gmsh_file(const std::string &name)
  {
    require_input_file(name);
    refuse_binary(name);
    return GmshReader(name).read();
  }
} // namespace squeal
