// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/text.h>

#include <squeal/scene/abaqus_part.h>
#include <squeal/scene/import_text.h>
#include <squeal/scene/mesh_cell.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace squeal
{
  namespace
  {
    using dealii::Point;
    using dealii::Tensor;
    using import::upper_case;
    using Kind = MeshFile::Kind;

    bool
    begins(const std::string &text, const char *start)
    {
      return text.compare(0, std::string(start).size(), start) == 0;
    }

    /** The kind of an element type and how many nodes are read of it. */
    std::pair<Kind, unsigned int>
    kind_of(const std::string &type)
    {
      static const std::vector<std::pair<const char *, std::pair<Kind, int>>>
        types{{"C3D8", {Kind::hexahedron, 8}},
              {"C3D20", {Kind::hexahedron, 20}},
              {"C3D27", {Kind::hexahedron, 27}},
              {"C3D4", {Kind::tetrahedron, 0}},
              {"C3D10", {Kind::tetrahedron, 0}},
              {"C3D6", {Kind::wedge, 0}},
              {"C3D15", {Kind::wedge, 0}},
              {"C3D5", {Kind::pyramid, 0}},
              {"C3D13", {Kind::pyramid, 0}}};
      for (const auto &[name, kind] : types)
        if (begins(type, name) &&
            type.find_first_of("0123456789", std::string(name).size()) ==
              std::string::npos)
          return kind;
      for (const char *name : {"S", "M3D", "STRI", "R3D", "DS", "DSAX"})
        // continuum shells, SC8R, are volumes
        if (begins(type, name) && !begins(type, "SPRING") &&
            !begins(type, "SC"))
          return {Kind::other_surface, 0};
      for (const char *name : {"B2",
                               "B3",
                               "T2D",
                               "T3D",
                               "SPRING",
                               "DASHPOT",
                               "MASS",
                               "ROTARYI",
                               "CONN",
                               "GAP",
                               "DCOUP",
                               "HEATCAP",
                               "RB3D",
                               "PIPE",
                               "FRAME"})
        if (begins(type, name))
          return {Kind::low_dimensional, 0};
      return {Kind::other_volume, 0};
    }

    /** Keywords that make nodes or elements in ways that are not read. */
    const char *
    way_out_of(const std::string &keyword)
    {
      static const std::map<std::string, const char *> ways{
        {"INCLUDE", "put the files together"},
        {"IMPORT", "write the mesh itself"},
        {"NGEN", "list the nodes"},
        {"NFILL", "list the nodes"},
        {"NCOPY", "list the nodes"},
        {"NMAP", "list the nodes"},
        {"SYSTEM", "write the nodes in the global system"},
        {"ELGEN", "list the elements"},
        {"ELCOPY", "list the elements"},
        {"PARAMETER", "write the numbers themselves"}};
      const auto it = ways.find(keyword);
      return it == ways.end() ? nullptr : it->second;
    }

    /** Keywords that hold or tie parts of the model. */
    bool
    couples(const std::string &keyword)
    {
      static const std::set<std::string> names{"BOUNDARY",
                                               "CONNECTOR SECTION",
                                               "CONTACT",
                                               "CONTACT PAIR",
                                               "COUPLING",
                                               "CYCLIC SYMMETRY MODEL",
                                               "DASHPOT",
                                               "DISTRIBUTING COUPLING",
                                               "EMBEDDED ELEMENT",
                                               "EQUATION",
                                               "FASTENER",
                                               "KINEMATIC COUPLING",
                                               "MASS",
                                               "MPC",
                                               "PRE-TENSION SECTION",
                                               "RIGID BODY",
                                               "ROTARY INERTIA",
                                               "SHELL TO SOLID COUPLING",
                                               "SPRING",
                                               "SURFACE INTERACTION"};
      return names.count(keyword) > 0;
    }



    class AbaqusReader
    {
    public:
      AbaqusReader(const std::string              &name,
                   const std::vector<std::string> &wanted)
        : text(name)
        , wanted(wanted)
      {
      }

      MeshFile read();

    private:
      struct Keyword
      {
        std::string                        name;    /**< in capitals */
        std::map<std::string, std::string> options; /**< keys in capitals */
        unsigned int                       line = 0;
      };
      /** Nodes and elements of an instance by their numbers. */
      struct Instance
      {
        AbaqusPart::Numbers nodes, elements;
      };
      using Sets = std::map<std::string, AbaqusPart::Set>;

      bool        next_line();
      bool        next_keyword();
      void        add_options(const std::string &line);
      bool        next_data();
      std::string option(const char *key) const;
      std::string needed(const char *key) const;
      long        integer(const std::size_t i, const char *what) const;
      double      real(const std::size_t i, const char *what) const;
      std::string data(const std::size_t i) const;

      void take();
      void begin_part();
      void end_part();
      void begin_instance();
      void end_instance();
      void read_nodes();
      void read_elements();
      void read_element(const std::string &type,
                        const Kind         kind,
                        const unsigned int n_nodes,
                        AbaqusPart::Set   *set);
      void read_set(const bool of_nodes);
      void read_range(const AbaqusPart::Numbers &numbers, AbaqusPart::Set &set);
      std::vector<unsigned int> members(const std::string &entry,
                                        const bool         of_nodes,
                                        const std::string &instance) const;
      void                      read_surface();
      void                      read_section();
      void                      read_elastic();
      void                      read_density();
      void                      read_tie();
      void                      read_step();
      void                      finish();

      import::TextFile               text;
      const std::vector<std::string> wanted;
      bool                           is_held = false; /**< line not yet used */
      Keyword                        keyword;
      std::vector<std::string>       fields;
      bool                           ends_with_comma = false;
      MeshFile                       file;
      AbaqusPart                     model, draft;
      AbaqusPart                    *current = &model;
      std::string                    open_part, open_instance;
      bool                           is_assembly_open = false;
      std::map<std::string, AbaqusPart> parts;
      std::map<std::string, Instance>   instances;
      std::map<std::string, int>        materials;
    };



    /** Moves to the next line that is neither blank nor a comment. */
    bool
    AbaqusReader::next_line()
    {
      if (is_held)
        {
          is_held = false;
          return true;
        }
      while (text.next())
        {
          const auto line = import::trimmed(text.line());
          if (!line.empty() && line.substr(0, 2) != "**")
            return true;
        }
      return false;
    }

    void
    AbaqusReader::add_options(const std::string &line)
    {
      const auto plain = [](std::string t) {
        t = std::string(import::trimmed(t));
        if (t.size() > 1 && t.front() == '"' && t.back() == '"')
          t = t.substr(1, t.size() - 2);
        return t;
      };
      for (const std::string &part : prm::split(line, ','))
        {
          const auto equals = part.find('=');
          const auto key    = upper_case(plain(part.substr(0, equals)));
          if (!key.empty())
            keyword.options[key] =
              equals == std::string::npos ? "" : plain(part.substr(equals + 1));
        }
    }

    bool
    AbaqusReader::next_keyword()
    {
      while (next_line())
        {
          std::string line(import::trimmed(text.line()));
          if (line[0] != '*')
            continue; // data of a keyword that is not read
          keyword            = {};
          keyword.line       = text.line_number();
          const auto   comma = std::min(line.find(','), line.size());
          std::string &name  = keyword.name;
          for (const char c : upper_case(line.substr(1, comma - 1)))
            if (c != ' ' || (!name.empty() && name.back() != ' '))
              name += c;
          while (!name.empty() && name.back() == ' ')
            name.pop_back();
          std::string options = line.substr(comma);
          while (!options.empty() && line.back() == ',' && next_line())
            {
              line = import::trimmed(text.line());
              options += line;
            }
          add_options(options);
          return true;
        }
      return false;
    }

    bool
    AbaqusReader::next_data()
    {
      if (!next_line())
        return false;
      const auto line = import::trimmed(text.line());
      if (line[0] == '*')
        {
          is_held = true;
          return false;
        }
      fields.clear();
      ends_with_comma = line.back() == ',';
      for (std::size_t begin = 0; begin <= line.size();)
        {
          const auto end = std::min(line.find(',', begin), line.size());
          fields.emplace_back(import::trimmed(line.substr(begin, end - begin)));
          begin = end + 1;
        }
      if (ends_with_comma)
        fields.pop_back();
      return true;
    }



    std::string
    AbaqusReader::option(const char *key) const
    {
      const auto it = keyword.options.find(key);
      return it == keyword.options.end() ? "" : it->second;
    }

    std::string
    AbaqusReader::needed(const char *key) const
    {
      const std::string value = option(key);
      if (value.empty())
        text.fail_at(keyword.line,
                     "*" + keyword.name + " needs " + key + "=...");
      return value;
    }

    std::string
    AbaqusReader::data(const std::size_t i) const
    {
      return i < fields.size() ? fields[i] : "";
    }

    long
    AbaqusReader::integer(const std::size_t i, const char *what) const
    {
      return import::integer_field(text, data(i), what);
    }

    double
    AbaqusReader::real(const std::size_t i, const char *what) const
    {
      return data(i).empty() ? 0. : import::real_field(text, data(i), what);
    }



    MeshFile
    AbaqusReader::read()
    {
      bool has_keyword = false;
      while (next_keyword())
        {
          has_keyword = true;
          take();
        }
      if (!has_keyword)
        throw InputError(text.name() +
                         " is no Abaqus input file: it has no keywords");
      for (const auto &[is_open, what] :
           {std::pair(!open_part.empty(), "*PART"),
            std::pair(!open_instance.empty(), "*INSTANCE"),
            std::pair(is_assembly_open, "*ASSEMBLY")})
        if (is_open)
          throw InputError(text.name() + " is truncated: it ends inside " +
                           what);
      text.check_last_line_is_complete();
      finish();
      return std::move(file);
    }



    void
    AbaqusReader::take()
    {
      const std::string &name = keyword.name;
      if (const char *way = way_out_of(name))
        text.fail_at(keyword.line, "*" + name + " is not read: " + way);
      if (keyword.options.count("INPUT") > 0)
        text.fail_at(keyword.line,
                     "*" + name +
                       ", INPUT=... is not followed: put the files together");
      if (name == "PART")
        begin_part();
      else if (name == "END PART")
        end_part();
      else if (name == "ASSEMBLY")
        is_assembly_open = true;
      else if (name == "END ASSEMBLY")
        is_assembly_open = false;
      else if (name == "INSTANCE")
        begin_instance();
      else if (name == "END INSTANCE")
        end_instance();
      else if (name == "NODE")
        read_nodes();
      else if (name == "ELEMENT")
        read_elements();
      else if (name == "NSET" || name == "ELSET")
        read_set(name == "NSET");
      else if (name == "SURFACE")
        read_surface();
      else if (name == "SOLID SECTION")
        read_section();
      else if (name == "MATERIAL")
        {
          if (!materials
                 .emplace(upper_case(needed("NAME")), file.materials.size())
                 .second)
            text.fail_at(keyword.line,
                         "material " + prm::in_quotes(needed("NAME")) +
                           " is there twice");
          file.materials.push_back({needed("NAME"), "", 0., 0., 0.});
        }
      else if (name == "ELASTIC")
        read_elastic();
      else if (name == "DENSITY")
        read_density();
      else if (name == "TIE")
        read_tie();
      else if (name == "STEP")
        read_step();
      else if (couples(name))
        file.passed_over.insert("*" + name);
    }



    void
    AbaqusReader::begin_part()
    {
      if (!open_part.empty() || is_assembly_open)
        text.fail_at(keyword.line, "*PART within another one or the assembly");
      open_part = upper_case(needed("NAME"));
      if (parts.count(open_part) > 0)
        text.fail_at(keyword.line,
                     "part " + prm::in_quotes(needed("NAME")) +
                       " is there twice");
      current = &parts[open_part];
    }

    void
    AbaqusReader::end_part()
    {
      if (open_part.empty())
        text.fail_at(keyword.line, "*END PART without *PART");
      open_part.clear();
      current = &model;
    }

    void
    AbaqusReader::begin_instance()
    {
      if (!open_part.empty() || !open_instance.empty())
        text.fail_at(keyword.line, "*INSTANCE within a part or an instance");
      open_instance         = needed("NAME");
      const auto         it = parts.find(upper_case(needed("PART")));
      const unsigned int n  = keyword.line;
      if (it == parts.end())
        text.fail_at(n,
                     "there is no part " + prm::in_quotes(option("PART")) +
                       " before this line");
      if (instances.count(upper_case(open_instance)) > 0)
        text.fail_at(
          n, "instance " + prm::in_quotes(open_instance) + " is there twice");
      draft = it->second;
      Tensor<1, 3>          shift;
      std::array<double, 7> turn{};
      if (next_data())
        {
          for (unsigned int c = 0; c < 3; ++c)
            shift[c] = real(c, "translation");
          if (next_data())
            {
              if (fields.size() != 7)
                text.fail("a rotation has 7 numbers: two points and an angle");
              for (unsigned int c = 0; c < 7; ++c)
                turn[c] = real(c, "rotation");
              if (turn[0] == turn[3] && turn[1] == turn[4] &&
                  turn[2] == turn[5])
                text.fail("the two points of the rotation's axis are the same");
            }
        }
      place_instance(draft, shift, turn);
      current = &draft;
    }

    void
    AbaqusReader::end_instance()
    {
      if (open_instance.empty())
        text.fail_at(keyword.line, "*END INSTANCE without *INSTANCE");
      Instance  &instance      = instances[upper_case(open_instance)];
      const auto first_node    = model.points.size(),
                 first_element = model.elements.size();
      for (const auto &[number, i] : draft.number_of_node)
        instance.nodes[number] = first_node + i;
      for (const auto &[number, i] : draft.number_of_element)
        instance.elements[number] = first_element + i;
      add_instance(model, draft, open_instance);
      open_instance.clear();
      current = &model;
    }



    void
    AbaqusReader::read_nodes()
    {
      if (const auto system = option("SYSTEM");
          !system.empty() && upper_case(system) != "R")
        text.fail_at(keyword.line,
                     "*NODE, SYSTEM=" + system +
                       " is not read: write the nodes in x, y, z");
      AbaqusPart::Set *set = nullptr;
      if (const auto name = option("NSET"); !name.empty())
        {
          set = &current->node_sets[upper_case(name)];
          if (set->name.empty())
            set->name = name;
        }
      while (next_data())
        {
          const long number = integer(0, "node number");
          if (!current->number_of_node.emplace(number, current->points.size())
                 .second)
            text.fail("node " + std::to_string(number) + " is there twice");
          if (set)
            set->members.push_back(current->points.size());
          current->points.emplace_back(real(1, "coordinate"),
                                       real(2, "coordinate"),
                                       real(3, "coordinate"));
        }
    }

    void
    AbaqusReader::read_elements()
    {
      const std::string type     = upper_case(needed("TYPE"));
      const auto [kind, n_nodes] = kind_of(type);
      AbaqusPart::Set *set       = nullptr;
      if (const auto name = option("ELSET"); !name.empty())
        {
          set = &current->element_sets[upper_case(name)];
          if (set->name.empty())
            set->name = name;
        }
      while (next_data())
        read_element(type, kind, n_nodes, set);
    }

    void
    AbaqusReader::read_element(const std::string &type,
                               const Kind         kind,
                               const unsigned int n_nodes,
                               AbaqusPart::Set   *set)
    {
      const long        number = integer(0, "element number");
      std::vector<long> numbers;
      std::size_t       first = 1;
      do
        {
          for (std::size_t i = first; i < fields.size(); ++i)
            numbers.push_back(integer(i, "node number"));
          first = 0;
        }
      while ((numbers.size() < n_nodes || (ends_with_comma && n_nodes == 0)) &&
             next_data());
      MeshFile::Element element{number, kind, 0, {}, -1};
      if (n_nodes > 0 && numbers.size() != n_nodes)
        text.fail("element " + std::to_string(number) + " of type " + type +
                  " has " + std::to_string(numbers.size()) +
                  " nodes instead of " + std::to_string(n_nodes));
      std::vector<unsigned int> nodes;
      for (std::size_t i = 0; i < n_nodes; ++i)
        {
          const auto it = current->number_of_node.find(numbers[i]);
          if (it == current->number_of_node.end())
            text.fail("element " + std::to_string(number) + " refers to node " +
                      std::to_string(numbers[i]) +
                      ", which is not in the file above");
          nodes.push_back(it->second);
        }
      element.nodes = in_gmsh_order(nodes, NodeOrder::abaqus);
      if (!current->number_of_element.emplace(number, current->elements.size())
             .second)
        text.fail("element " + std::to_string(number) + " is there twice");
      if (set)
        set->members.push_back(current->elements.size());
      current->elements.push_back(std::move(element));
    }



    /** What an entry of a set or a surface stands for: a number or the name of
     * a set, of an instance where one is named. */
    std::vector<unsigned int>
    AbaqusReader::members(const std::string &entry,
                          const bool         of_nodes,
                          const std::string &instance) const
    {
      const Sets &sets = of_nodes ? current->node_sets : current->element_sets;
      const std::string in_front =
        instance.empty() ? "" : upper_case(instance) + ".";
      if (const auto it = sets.find(in_front + upper_case(entry));
          it != sets.end())
        return it->second.members;
      const auto  dot    = entry.rfind('.');
      std::string owner  = instance;
      std::string digits = entry;
      if (instance.empty() && dot != std::string::npos)
        {
          owner  = entry.substr(0, dot);
          digits = entry.substr(dot + 1);
        }
      const AbaqusPart::Numbers *numbers =
        of_nodes ? &current->number_of_node : &current->number_of_element;
      if (!owner.empty())
        {
          const auto it = instances.find(upper_case(owner));
          if (it == instances.end())
            text.fail("there is no instance " + prm::in_quotes(owner));
          numbers = of_nodes ? &it->second.nodes : &it->second.elements;
        }
      const char *const what   = of_nodes ? "node" : "element";
      long              number = 0;
      if (!import::parse_integer(digits, number))
        text.fail(std::string("there is no set of ") + what + "s " +
                  prm::in_quotes(entry) + " above");
      const auto it = numbers->find(number);
      if (it == numbers->end())
        text.fail(std::string(what) + " " + std::to_string(number) +
                  " is not there");
      return {it->second};
    }

    void
    AbaqusReader::read_range(const AbaqusPart::Numbers &numbers,
                             AbaqusPart::Set           &set)
    {
      const long first = integer(0, "first number"),
                 last  = data(1).empty() ? first : integer(1, "last number"),
                 step  = data(2).empty() ? 1 : integer(2, "increment");
      if (step < 1 || last < first)
        text.fail("a range needs an increment of at least 1 and a last number "
                  "that is not below the first");
      bool is_empty = true;
      for (auto it = numbers.lower_bound(first);
           it != numbers.end() && it->first <= last;
           ++it)
        if ((static_cast<unsigned long>(it->first) -
             static_cast<unsigned long>(first)) %
              static_cast<unsigned long>(step) ==
            0)
          {
            set.members.push_back(it->second);
            is_empty = false;
          }
      if (is_empty)
        text.fail("nothing in the file above has a number of this range");
    }

    void
    AbaqusReader::read_set(const bool of_nodes)
    {
      const std::string name     = needed(of_nodes ? "NSET" : "ELSET"),
                        instance = option("INSTANCE");
      const bool is_range        = keyword.options.count("GENERATE") > 0;
      Sets      &sets = of_nodes ? current->node_sets : current->element_sets;
      AbaqusPart::Set set = sets[upper_case(name)];
      if (set.name.empty())
        set.name = name;
      const AbaqusPart::Numbers *numbers =
        of_nodes ? &current->number_of_node : &current->number_of_element;
      if (!instance.empty())
        {
          const auto it = instances.find(upper_case(instance));
          if (it == instances.end())
            text.fail_at(keyword.line,
                         "there is no instance " + prm::in_quotes(instance));
          numbers = of_nodes ? &it->second.nodes : &it->second.elements;
        }
      if (const auto cells = option("ELSET"); of_nodes && !cells.empty())
        for (const unsigned int e : members(cells, false, instance))
          for (const unsigned int n : current->elements[e].nodes)
            set.members.push_back(n);
      while (next_data())
        if (is_range)
          read_range(*numbers, set);
        else
          for (const auto &field : fields)
            if (!field.empty())
              for (const unsigned int m : members(field, of_nodes, instance))
                set.members.push_back(m);
      std::sort(set.members.begin(), set.members.end());
      set.members.erase(std::unique(set.members.begin(), set.members.end()),
                        set.members.end());
      sets[upper_case(name)] = std::move(set);
    }



    void
    AbaqusReader::read_surface()
    {
      const std::string type = upper_case(option("TYPE"));
      const std::string name = needed("NAME");
      // Others are rigid or made of surfaces: they have no faces of cells.
      if ((!type.empty() && type != "ELEMENT" && type != "NODE") ||
          keyword.options.count("COMBINE") > 0)
        return;
      AbaqusPart::Surface surface;
      surface.name = name;
      while (next_data())
        if (type == "NODE")
          for (const unsigned int n : members(data(0), true, ""))
            surface.nodes.push_back(n);
        else
          {
            const std::string label = upper_case(data(1));
            unsigned int      face  = 6;
            if (label.size() == 2 && label[0] == 'S' && label[1] >= '1' &&
                label[1] <= '6')
              face = label[1] - '1';
            else if (label == "SPOS" || label == "SNEG" || label == "EDGE" ||
                     (label.size() == 2 && label[0] == 'E'))
              continue; // of shells
            else if (!label.empty())
              text.fail("a face of an element is S1 to S6, not " +
                        prm::in_quotes(data(1)));
            for (const unsigned int e : members(data(0), false, ""))
              surface.faces.push_back({{e, face}});
          }
      if (!current->surfaces.emplace(upper_case(name), surface).second)
        text.fail_at(keyword.line,
                     "surface " + prm::in_quotes(name) + " is there twice");
    }

    void
    AbaqusReader::read_section()
    {
      const std::string cells = needed("ELSET");
      const auto        it    = current->element_sets.find(upper_case(cells));
      if (it == current->element_sets.end())
        text.fail_at(keyword.line,
                     "there is no set of elements " + prm::in_quotes(cells) +
                       " above");
      current->sections.push_back({it->second.members,
                                   upper_case(needed("MATERIAL")),
                                   !option("ORIENTATION").empty()});
    }

    void
    AbaqusReader::read_elastic()
    {
      if (file.materials.empty())
        text.fail_at(keyword.line, "*ELASTIC without *MATERIAL");
      auto      &material = file.materials.back();
      const auto type     = upper_case(option("TYPE"));
      if (!type.empty() && type.compare(0, 3, "ISO") != 0)
        material.fault = "is not isotropic (*ELASTIC, TYPE=" + type + ")";
      if (!next_data())
        text.fail_at(keyword.line, "*ELASTIC without numbers");
      material.young_modulus = real(0, "Young's modulus");
      material.poisson_ratio = real(1, "Poisson's ratio");
      if (next_data() && material.fault.empty())
        material.fault = "depends on temperature";
    }

    void
    AbaqusReader::read_density()
    {
      if (file.materials.empty())
        text.fail_at(keyword.line, "*DENSITY without *MATERIAL");
      auto &material = file.materials.back();
      if (!next_data())
        text.fail_at(keyword.line, "*DENSITY without a number");
      material.density = real(0, "density");
      if (next_data() && material.fault.empty())
        material.fault = "depends on temperature";
    }

    void
    AbaqusReader::read_tie()
    {
      const std::string name = option("NAME");
      while (next_data())
        {
          if (data(0).empty() || data(1).empty())
            text.fail("a tie needs the names of two surfaces");
          file.ties.push_back({name, data(0), data(1)});
        }
    }

    /** Steps say what is analysed; only their end is looked for. */
    void
    AbaqusReader::read_step()
    {
      const unsigned int line = keyword.line;
      while (next_keyword())
        if (keyword.name == "END STEP")
          return;
      throw InputError(text.name() +
                       " is truncated: it ends inside the *STEP of line " +
                       std::to_string(line));
    }



    void
    AbaqusReader::finish()
    {
      if (model.points.empty() || model.elements.empty())
        throw InputError(
          text.name() + " is truncated or holds no mesh: it has no " +
          (model.points.empty() ? "nodes" : "elements") +
          (parts.empty() ? "" : "; its parts need an *ASSEMBLY of instances"));
      // Sums of large numbers and axes of rotation of almost no length.
      for (const auto &x : model.points)
        if (!std::isfinite(x.norm_square()))
          throw InputError(text.name() +
                           ": an instance is moved or turned to places that "
                           "are no numbers");
      for (const auto &section : model.sections)
        if (section.is_oriented)
          {
            if (const auto it = materials.find(section.material);
                it != materials.end() &&
                file.materials[it->second].fault.empty())
              file.materials[it->second].fault = "has axes of its own";
          }
      add_to_mesh(model, wanted, materials, file);
    }
  } // namespace



  MeshFile
  read_abaqus_mesh(const std::string              &name,
                   const std::vector<std::string> &sets)
  {
    return AbaqusReader(name, sets).read();
  }
} // namespace squeal
