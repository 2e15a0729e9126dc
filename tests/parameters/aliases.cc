// SPDX-License-Identifier: LGPL-2.1-or-later
//
// An entry that has been renamed is still read, with a note, unless both names
// are set.
#include <squeal/parameters/aliases.h>
#include <squeal/parameters/declarations.h>

#include "prm_test.h"

using namespace squeal;
using namespace squeal::testing;

int
main()
{
  const std::vector<prm::EntryAlias> aliases = {
    {"Scene/Body <name>/E modulus", "Young modulus"},
    {"Output/Images", "Plots"}};

  write_text("test.prm",
             "subsection Scene\n"
             "  set Bodies = pad\n"
             "  subsection Body pad\n"
             "    set E modulus = 1e9\n"
             "  end\n"
             "end\n"
             "subsection Output\n"
             "  set Images = false\n"
             "end\n");
  prm::PrmTree                   tree  = prm::read_prm_file("test.prm");
  const std::vector<std::string> notes = prm::apply_aliases(tree, aliases);
  check(notes.size() == 2, "one note for each former name");
  check(notes[0].find("test.prm:4: ") == 0 &&
          notes[0].find("'Young modulus'") != std::string::npos,
        "the note says where and what: " + notes[0]);
  const Parameters p = prm::parse_tree(tree, "test.prm");
  check(p.scene.bodies[0].young_modulus == 1e9, "former name in a family");
  check(!p.output.plots, "former name in a plain section");

  write_text("both.prm",
             "subsection Scene\n"
             "  subsection Body pad\n"
             "    set Young modulus = 1e9\n"
             "    set E modulus = 1e9\n"
             "  end\n"
             "end\n");
  check_refused(
    [&]() {
      prm::PrmTree both = prm::read_prm_file("both.prm");
      prm::apply_aliases(both, aliases);
    },
    {"both.prm:4: ", "former name of 'Young modulus'", "both.prm:3"},
    "both names");

  for (const prm::EntryAlias &alias : prm::entry_aliases())
    {
      const prm::GenericSchema schema;
      const std::string        section =
        alias.former.substr(0, alias.former.rfind('/') + 1);
      check(schema->find(section + alias.present) != nullptr,
            alias.former + " has become an entry that exists");
      check(schema->find(alias.former) == nullptr,
            alias.former + " is no entry any more");
    }
}
