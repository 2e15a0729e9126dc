// SPDX-License-Identifier: LGPL-2.1-or-later
//
// What is printed can be read back, reproduces the run, and leaves nothing
// out.
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/text.h>

#include "describe.h"
#include "example_scene.h"

#include <filesystem>
#include <sstream>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  namespace fs = std::filesystem;

  void
  replace_all(std::string &text, const std::string &from, const std::string &to)
  {
    for (std::size_t at = text.find(from); at != std::string::npos;
         at             = text.find(from, at + to.size()))
      text.replace(at, from.size(), to);
  }



  std::string
  defaults_text()
  {
    std::ostringstream out;
    print_defaults(out);
    return out.str();
  }



  void
  defaults_are_read_back()
  {
    write_text("defaults.prm", defaults_text());
    const Parameters p = read_parameters("defaults.prm");
    check(describe(p) == describe(Parameters()), "defaults are read back");
    std::ostringstream out;
    print_parameters(p, out);
    check(out.str().find('\n') == out.str().size() - 1,
          "none of them differs from the default");
  }



  void
  families_of_the_defaults_are_read_back()
  {
    std::string text = defaults_text();
    for (const char *word : {"set ", "subsection ", "end"})
      replace_all(text, "#" + std::string(word), word);
    replace_all(text, "<name>", "x");
    Parameters expected;
    for (const prm::SectionFamily &family : prm::section_families())
      {
        replace_all(
          text, "set " + family.list + " =\n", "set " + family.list + " = x\n");
        prm::name_members(expected, family, {"x"});
      }
    // An entry of the name of a family's list.
    expected.triggers.points = {"x"};
    write_text("families.prm", text);
    check(describe(read_parameters("families.prm")) == describe(expected),
          "the sections in comments are read back too");
  }



  void
  used_parameters_reproduce_the_run()
  {
    fs::create_directories("sub/meshes");
    fs::create_directories("out");
    write_text("sub/scene.prm",
               std::string(example_scene()) +
                 "subsection Scene\nsubsection Body pad\n"
                 "set Mesh file = meshes/a#1.msh\nend\nend\n");
    const Parameters p =
      read_parameters("sub/scene.prm", {"Scene/Body pad/Density = 2^11"});
    check(p.scene.bodies[1].density == 2048., "override");
    write_used_parameters(p, "out/used.prm");
    const Parameters again = read_parameters("out/used.prm");
    check(describe(again) == describe(p), "identical structs");
    check(again.used == p.used, "identical entries");

    std::ifstream     in("out/used.prm");
    const std::string text((std::istreambuf_iterator<char>(in)), {});
    check(text.find("set Mesh file = ../sub/meshes/a#1.msh\n") !=
            std::string::npos,
          "names of files are relative to the file that is written");
    unsigned int n_files = 0;
    for (const auto &entry : fs::directory_iterator("out"))
      n_files += entry.is_regular_file() ? 1 : 0;
    check(n_files == 1, "no temporary file is left");
    write_used_parameters(again, "out/used.prm");
    check(read_parameters("out/used.prm").used == p.used, "written again");
  }



  void
  what_cannot_be_written()
  {
    const Parameters p = read_parameters(write_example());
    check_refused([&]() { write_used_parameters(p, "nowhere/used.prm"); },
                  {"nowhere/used.prm"},
                  "folder that does not exist");
    fs::create_directories("is_a_folder");
    check_refused([&]() { write_used_parameters(p, "is_a_folder"); },
                  {"is_a_folder"},
                  "folder in place of the file");
  }



  void
  the_table_shows_what_was_set()
  {
    std::ostringstream out;
    print_parameters(read_parameters(write_example()), out);
    std::istringstream       in(out.str());
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
      lines.push_back(line);
    const std::size_t value    = lines.at(0).find("value");
    const std::size_t standard = lines.at(0).find("default");
    bool              found    = false;
    std::string       section;
    for (const std::string &line : lines)
      {
        check(line.find("  ", 2) == std::string::npos ||
                (line.at(value - 1) == ' ' && line.at(value) != ' '),
              "aligned: " + line);
        if (line[0] != ' ')
          section = line;
        if (section == "Scene/Body pad" && prm::starts_with(line, "  Density "))
          found =
            line.substr(value, 5) == "2500 " && line.substr(standard) == "7800";
        // as the default
        check(section != "Scene/Body disc" ||
                !prm::starts_with(line, "  Height"),
              "only what differs: " + line);
      }
    check(found, "entry, value and default of the pad's density");
  }



  void
  documentation_is_complete()
  {
    std::ostringstream out;
    print_parameter_documentation(out);
    std::istringstream in(out.str());
    std::string        section, line;
    std::size_t        n_rows = 0, n_sections = 0;
    while (std::getline(in, line))
      {
        if (prm::starts_with(line, "## "))
          ++n_sections;
        if (!prm::starts_with(line, "| ") ||
            line == "| --- | --- | --- | --- |" ||
            line == "| entry | default | allowed | meaning |")
          continue;
        ++n_rows;
        replace_all(line, "\\|", "");
        check(line.find(" Units: ") != std::string::npos, line);
        check(prm::split(line, '|').size() == 6, "four columns: " + line);
      }
    const prm::GenericSchema schema;
    check(n_rows == schema->entries().size(), "one row for every entry");
    check(n_sections == schema->sections().size(), "a table each section");
    check(out.str().find("## `Scene/Body <name>`") != std::string::npos,
          "families are shown once");
  }
} // namespace

int
main()
{
  defaults_are_read_back();
  families_of_the_defaults_are_read_back();
  used_parameters_reproduce_the_run();
  what_cannot_be_written();
  the_table_shows_what_was_set();
  documentation_is_complete();
}
