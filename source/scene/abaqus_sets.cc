// SPDX-License-Identifier: LGPL-2.1-or-later
#include "abaqus_keywords.h"
#include "abaqus_reader.h"

#include <squeal/parameters/text.h>

#include <algorithm>

// Sets and surfaces of an Abaqus input file.

namespace squeal
{
  using import::upper_case;

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
    const bool is_range        = has_option("GENERATE");
    Sets      &sets     = of_nodes ? current->node_sets : current->element_sets;
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
    std::string       type = upper_case(option("TYPE"));
    const std::string name = needed("NAME");
    for (const char *whole : {"ELEMENT", "NODE"})
      if (abaqus::may_stand_for(type, whole))
        type = whole;
    // Others are rigid or made of surfaces: they have no faces of cells.
    if ((!type.empty() && type != "ELEMENT" && type != "NODE") ||
        has_option("COMBINE"))
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
} // namespace squeal
