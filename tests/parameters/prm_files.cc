// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The syntax of parameter files, what includes override, and one clear line
// for every file that is none.
#include <squeal/parameters/prm_tree.h>

#include "prm_test.h"

#include <filesystem>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  namespace fs = std::filesystem;

  std::string
  value(const prm::PrmTree &tree, const std::string &path)
  {
    const prm::RawEntry *entry = tree.find(path);
    return entry == nullptr ? "(not set)" : entry->value;
  }



  prm::PrmTree
  tree_of(const std::string &text)
  {
    write_text("test.prm", text);
    return prm::read_prm_file("test.prm");
  }



  void
  check_file_refused(const std::string              &text,
                     const std::vector<std::string> &parts,
                     const std::string              &claim)
  {
    write_text("test.prm", text);
    check_refused([]() { prm::read_prm_file("test.prm"); }, parts, claim);
  }



  void
  syntax()
  {
    const prm::PrmTree tree = tree_of("\xef\xbb\xbf# \xb5 comment\r\n"
                                      "set A = 1 # why\r\n"
                                      "SET  B  C=x = y\n"
                                      "subsection S  1\n"
                                      "\tset file = c#1.msh\n"
                                      "  subsection T\n"
                                      "    set L = a, \\\n"
                                      "            b # last\n"
                                      "    set E =\n"
                                      "  end\n"
                                      "end");
    check(value(tree, "A") == "1", "comment after a value, CRLF, BOM");
    check(value(tree, "B C") == "x = y", "the first = counts");
    check(value(tree, "S 1/file") == "c#1.msh", "# inside a word");
    check(value(tree, "S 1/T/L") == "a, b", "continued line");
    check(value(tree, "S 1/T/E").empty(), "empty value");
    check(tree.find("S 1/T/E")->location.line == 9,
          "lines are counted through continuations");
    check(tree.find_section("S 1/T")->location.text() == "test.prm:6",
          "location of a section");
  }



  void
  includes()
  {
    fs::create_directories("sub");
    write_text("sub/common.prm", "set A = common\nset B = common\nset C = c\n");
    write_text("sub/first.prm", "include common.prm\nset A = first\n");
    write_text("sub/second.prm", "include common.prm\nset B = second\n");
    write_text("sub/body.prm", "set E = 1\n");
    const prm::PrmTree tree = tree_of("set C = own\n"
                                      "include sub/first.prm\n"
                                      "include sub/second.prm\n"
                                      "subsection Body x\n"
                                      "  include sub/body.prm\n"
                                      "end\n"
                                      "subsection Body y\n"
                                      "  include sub/body.prm\n"
                                      "end\n");
    check(value(tree, "C") == "own",
          "the including file wins even before the include");
    check(value(tree, "A") == "first",
          "a file included twice does not undo an override");
    check(value(tree, "B") == "second", "the later include wins");
    check(value(tree, "Body x/E") == "1" && value(tree, "Body y/E") == "1",
          "includes inside sections");
    check(tree.find("A")->location.text() == "sub/first.prm:2",
          "location in an included file");
    check(tree.find("A")->directory == fs::absolute("sub").string(),
          "file names start from the folder of the file that sets them");
  }



  void
  files_that_are_none()
  {
    const auto refused = [](const std::string &file,
                            const std::string &part,
                            const std::string &claim) {
      check_refused([&]() { prm::read_prm_file(file); }, {file, part}, claim);
    };
    fs::create_directories("folder.prm");
    write_text("empty.prm", "");
    write_text("comments.prm", "# nothing\n\n   \n");
    write_text("binary.prm", std::string("set A = 1\n\x89HDF\0\1\2", 17));
    refused("missing.prm", "no such file", "missing file");
    refused("folder.prm", "directory", "directory");
    write_text("returns.prm", "# nothing\rset A = 1\r");
    refused("empty.prm", "empty", "empty file");
    refused("comments.prm", "are comments", "file of comments");
    refused("returns.prm", "carriage return", "lines without line feeds");
    write_text("returns.prm", "set A = 1\rset B = 2\r");
    refused("returns.prm", "carriage return", "entries without line feeds");
    refused("binary.prm", "binary.prm:2: ", "binary file");
  }



  void
  bad_lines()
  {
    check_file_refused(
      "set A = 1\nend\n", {"test.prm:2: ", "'end'"}, "end without a section");
    check_file_refused("subsection A\nsubsection B\nset C = 1\nend\n",
                       {"test.prm:1: ", "'A'", "no 'end'"},
                       "section without end");
    check_file_refused("set A = 1\n\nsett B = 2\n",
                       {"test.prm:3: ", "'sett B = 2'", "mean 'set'"},
                       "unknown keyword");
    check_file_refused("set A 1\n", {"test.prm:1: ", "no '='"}, "no =");
    check_file_refused("set = 1\n", {"test.prm:1: "}, "no entry");
    check_file_refused("subsection\nend\n", {"test.prm:1: "}, "no name");
    check_file_refused("include\n", {"test.prm:1: "}, "no file");
    check_file_refused("set A = 1 \\\n", {"test.prm:1: "}, "dangling \\");
    check_file_refused("set A = 1\nset B = 20 \xb5m\n",
                       {"test.prm:2: ", "UTF-8"},
                       "letter in another encoding");
    check_file_refused("set A = 1\nsubsection S\nend\nset A = 2\n",
                       {"test.prm:4: ", "'A'", "line 1"},
                       "entry set twice in one file");
    check_file_refused("subsection S\nset A = 1\nend\n"
                       "subsection S\nset A = 1\nend\n",
                       {"test.prm:5: ", "'S/A'", "line 2"},
                       "entry set twice in a reopened section");
  }



  void
  bad_includes()
  {
    write_text("inner.prm", "set A = 1\ninclude outer.prm\n");
    write_text("outer.prm", "\ninclude inner.prm\n");
    write_text("self.prm", "include ./self.prm\n");
    check_refused([]() { prm::read_prm_file("outer.prm"); },
                  {"inner.prm:2: ", "'outer.prm'", "back"},
                  "include cycle");
    check_refused([]() { prm::read_prm_file("self.prm"); },
                  {"self.prm:1: "},
                  "file that includes itself");
    check_file_refused("set A = 1\ninclude nowhere.prm\n",
                       {"test.prm:2: ", "'nowhere.prm'", "no such file"},
                       "missing include");
    check_file_refused("include .\n", {"test.prm:1: ", "directory"}, "folder");
    write_text("shared.prm", "set A = 1\n");
    write_text("through.prm", "include shared.prm\nset A = 2\n");
    const std::vector<std::string> again = {
      "'shared.prm'", "included above already", "not read again"};
    check_file_refused("include shared.prm\ndrop A\ninclude shared.prm\n",
                       again,
                       "a file again, to have back what was dropped");
    check_file_refused("include through.prm\ninclude shared.prm\n",
                       again,
                       "a file again, to undo what another one overrides");
    write_text("broken.prm", "set A = 1\nset A = 2\n");
    check_file_refused(
      "include broken.prm\n", {"broken.prm:2: "}, "fault in an included file");
  }



  void
  drops()
  {
    fs::create_directories("sub");
    write_text("sub/scene.prm",
               "subsection Scene\n"
               "  set Name = brake\n"
               "  set Bodies = disc, pad, support\n"
               "  subsection Body pad\n"
               "    set Density = 1\n"
               "    subsection Deep\n"
               "      set E = 1\n"
               "    end\n"
               "  end\n"
               "  subsection Body pads\n"
               "    set Density = 2\n"
               "  end\n"
               "end\n");
    write_text("sub/pad.prm", "set Shape = block\n");
    const std::string start = "include sub/scene.prm\n";

    prm::PrmTree tree = tree_of(start + "drop Scene/Body pad\n");
    check(value(tree, "Scene/Body pad/Density") == "(not set)" &&
            value(tree, "Scene/Body pad/Deep/E") == "(not set)" &&
            tree.find_section("Scene/Body pad") == nullptr,
          "a section goes with all that is in it");
    check(value(tree, "Scene/Bodies") == "disc, support",
          "and its name leaves the list");
    check(value(tree, "Scene/Body pads/Density") == "2" &&
            value(tree, "Scene/Name") == "brake",
          "what is called alike stays");

    tree = tree_of(start + "subsection Scene\n"
                           "  drop  Body  pad # and a new one\n"
                           "  subsection Body pad\n"
                           "    set Density = 3\n"
                           "  end\n"
                           "end\n");
    check(value(tree, "Scene/Body pad/Density") == "3" &&
            value(tree, "Scene/Body pad/Deep/E") == "(not set)" &&
            value(tree, "Scene/Bodies") == "disc, pad, support",
          "a section that is written again replaces the former one");

    tree = tree_of(start + "subsection Scene\n"
                           "  drop Body pad\n"
                           "  subsection Body pad\n"
                           "    include sub/pad.prm\n"
                           "  end\n"
                           "end\n");
    check(value(tree, "Scene/Body pad/Shape") == "block" &&
            value(tree, "Scene/Body pad/Density") == "(not set)",
          "or one that is included behind the line");

    tree = tree_of(start + "drop Scene/Name\n");
    check(value(tree, "Scene/Name") == "(not set)" &&
            value(tree, "Scene/Bodies") == "disc, pad, support",
          "an entry goes alone");

    write_text("sub/without.prm", "include scene.prm\ndrop Scene/Body pad\n");
    tree = tree_of("include sub/without.prm\n"
                   "subsection Scene\n  set Name = mine\nend\n");
    check(value(tree, "Scene/Bodies") == "disc, support" &&
            value(tree, "Scene/Name") == "mine",
          "what an included file has dropped is not there");

    check_file_refused(
      start + "drop Scene/Body padd\n",
      {"test.prm:2: ", "'Scene/Body padd'", "'Scene/Body pad'"},
      "a name that was not included, with the nearest one");
    check_file_refused(start + "subsection Scene\ndrop Body suport\nend\n",
                       {"test.prm:3: ", "'Scene/Body suport'", "was included"},
                       "a body without a section");
    check_file_refused("drop Scene/Body pad\n" + start,
                       {"test.prm:1: ", "before this line"},
                       "a drop before the include");
    check_file_refused(start + "drop Scene/Name\ndrop Scene/Name\n",
                       {"test.prm:3: ", "'Scene/Name'"},
                       "a second drop");
    check_file_refused("set A = 1\ndrop A\n",
                       {"test.prm:2: ", "'A'"},
                       "an entry of the file itself");
    check_file_refused(start + "drop\n", {"test.prm:2: "}, "no name");
  }



  void
  overrides()
  {
    const prm::RawEntry entry =
      prm::parse_override(" Scene / Body  x /A =  b = c ");
    check(entry.path == "Scene/Body x/A", "path of an override");
    check(entry.value == "b = c", "value of an override");
    check(entry.location.text() == "--set", "location of an override");
    for (const char *text :
         {"Scene/A", "= 1", "", "A = 1\nset B = 2", "A = x #y", "A = x\\"})
      check_refused([&]() { prm::parse_override(text); },
                    {"--set"},
                    "override '" + std::string(text) + "'");
  }
} // namespace

int
main()
{
  syntax();
  includes();
  files_that_are_none();
  bad_lines();
  bad_includes();
  drops();
  overrides();
}
