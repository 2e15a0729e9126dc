// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Every member of the structs is set by exactly one entry, and no entry is
// without effect.
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

#include "describe.h"
#include "prm_test.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using prm::Schema;

  /** Parameters with one member "x" in every family, defaults otherwise. */
  prm::PrmTree
  tree_with_members()
  {
    prm::PrmTree tree;
    for (const prm::SectionFamily &family : prm::section_families())
      {
        tree.set({family.list_path(), "x", {"test", 1}, "/"});
        tree.sections.push_back({family.section("x"), {"test", 1}});
      }
    return tree;
  }



  /** A value that differs from @p text, for one element of a list too. */
  std::string
  other_element(const Schema::Entry &entry, const std::string &text)
  {
    using Kind = prm::Allowed::Kind;
    switch (entry.allowed.kind())
      {
      case Kind::flag:
        return text == "true" ? "false" : "true";
      case Kind::choice:
        return text == entry.allowed.choices().front()
                 ? entry.allowed.choices().back()
                 : entry.allowed.choices().front();
      case Kind::integer:
        // Some start at 2.
        return text.empty() || text == "1" ? "2"
               : entry.allowed.is_list() || entry.allowed.matches("1")
                 ? "1"
                 : std::to_string(std::stoi(text) + 1);
      case Kind::number:
        {
          if (text.empty() || text == "0")
            return "0.5";
          // The ends of the range may be near.
          const double value = prm::parse_number(text).value();
          for (const double factor : {0.5, 1.25, 0.9})
            if (const auto other = prm::format_number(factor * value);
                entry.allowed.is_list() || entry.allowed.matches(other))
              return other;
          return "/no other value";
        }
      case Kind::text:
      case Kind::file:
        break;
      }
    return "/another";
  }



  std::string
  other_value(const Schema::Entry &entry)
  {
    if (!entry.allowed.is_list())
      return other_element(entry, entry.default_value);
    std::vector<std::string> elements = prm::split(entry.default_value, ',');
    if (elements.empty())
      // one element where any number is allowed, else a vector
      elements.resize(entry.allowed.canonical("1", "/") ||
                          !entry.allowed.choices().empty()
                        ? 1
                        : 3);
    for (std::string &element : elements)
      element = other_element(entry, element);
    return prm::join(elements, ", ");
  }



  std::vector<std::size_t>
  changed_lines(const std::vector<std::string> &a,
                const std::vector<std::string> &b)
  {
    check(a.size() == b.size(), "same members");
    std::vector<std::size_t> lines;
    for (std::size_t i = 0; i < a.size(); ++i)
      if (a[i] != b[i])
        lines.push_back(i);
    return lines;
  }
} // namespace

int
main()
{
  const std::vector<std::string> defaults =
    describe(prm::parse_tree(tree_with_members(), "test"));
  std::vector<unsigned int> n_changes(defaults.size(), 0);

  const prm::GenericSchema schema;
  for (const Schema::Entry &entry : schema->entries())
    {
      bool is_list_of_members = false;
      for (const prm::SectionFamily &family : prm::section_families())
        is_list_of_members =
          is_list_of_members || family.list_path() == entry.path();
      if (is_list_of_members)
        continue;

      std::string       path = entry.path();
      const std::size_t name = path.find("<name>");
      if (name != std::string::npos)
        path.replace(name, 6, "x");
      prm::PrmTree tree = tree_with_members();
      tree.set({path, other_value(entry), {"test", 2}, "/"});
      const std::vector<std::size_t> lines = changed_lines(
        defaults, describe(prm::parse_tree(std::move(tree), "test")));
      // a first point takes the last one with it unless that is set
      const std::size_t expected = entry.name == "First point" ? 2 : 1;
      check(lines.size() == expected,
            "'" + path + " = " + other_value(entry) + "' changes " +
              std::to_string(lines.size()) + " member(s), the first " +
              (lines.empty() ? "none" : defaults[lines[0]]));
      check(!entry.documentation.empty() && !entry.units.empty(),
            "'" + path + "' says what it is and its unit");
      ++n_changes[lines[0]]; // a second one belongs to the last point
    }
  for (std::size_t i = 0; i < defaults.size(); ++i)
    check(n_changes[i] == 1, "'" + defaults[i] + "' is set by one entry");
}
