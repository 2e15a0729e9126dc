// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Every malformed matrix, node table and contact pattern is refused in one line
// that names the file and the line to look at.
#include <squeal/base/exceptions.h>

#include <squeal/scene/import_tables.h>
#include <squeal/scene/matrix_import.h>

#include "../check.h"
#include "import_helpers.h"

#include <filesystem>

using namespace squeal;
using namespace squeal::testing;
using Role = MatrixPartParameters::Role;

namespace
{
  template <typename Action>
  void
  check_refused(const std::string &claim,
                const std::string &part_of_message,
                const Action      &action)
  {
    try
      {
        action();
      }
    catch (const InputError &error)
      {
        const std::string text = error.what();
        check(text.find(part_of_message) != std::string::npos &&
                text.find('\n') == std::string::npos,
              claim + " [" + text + "]");
        return;
      }
    check(false, claim + ": not refused");
  }

  void
  refuse(const std::string &claim,
         const std::string &text,
         const std::string &message,
         const Role         role        = Role::stiffness,
         const std::string &matrix_name = "")
  {
    const std::string file = write_text("bad.txt", text);
    check_refused(
      claim, message, [&]() { read_matrix(part_of(file, role, matrix_name)); });
  }

  const std::string banner = "%%MatrixMarket matrix coordinate real ";

  void
  test_files()
  {
    std::filesystem::create_directory("folder.mtx");
    check_refused("missing file", "no_such_file.mtx", []() {
      read_matrix(part_of("no_such_file.mtx", Role::mass));
    });
    check_refused("directory", "folder.mtx", []() {
      read_matrix(part_of("folder.mtx", Role::mass));
    });
    refuse("empty file", "", "bad.txt is empty");
    refuse("blank file", " \n\n", "bad.txt is empty");
    refuse("binary file",
           std::string("\x7f"
                       "ELF\0\1\2\3",
                       8),
           "bad.txt is not a text file");
    refuse("some other text", "Dear Sir,\nplease find\n", "no matrix in");
    refuse("Harwell-Boeing",
           "title                                           KEY\n"
           "             5             1             1             3\n"
           "RSA                        2             2             3\n"
           "(8I10)          (8I10)          (4E20.12)\n",
           "bad.txt:3: this is a Harwell-Boeing file");
    refuse("Harwell-Boeing with right-hand side",
           "title                                           KEY\n"
           "             6             1             1             3     1\n"
           "RUA                        2             2             3\n",
           "bad.txt:3: this is a Harwell-Boeing file");
  }

  void
  test_matrix_market()
  {
    refuse("banner cut short", "%%MatrixMarket matrix\n1 1 1\n", "bad.txt:1: ");
    refuse("dense",
           "%%MatrixMarket matrix array real general\n1 1\n1.\n",
           "bad.txt:1: a dense ('array')");
    refuse("complex",
           "%%MatrixMarket matrix coordinate complex general\n1 1 1\n1 1 1 0\n",
           "bad.txt:1: a matrix of kind 'COMPLEX'");
    refuse("pattern",
           "%%MatrixMarket matrix coordinate pattern general\n1 1 1\n1 1\n",
           "bad.txt:1: a matrix of kind 'PATTERN'");
    refuse("Hermitian",
           banner + "hermitian\n1 1 1\n1 1 1\n",
           "bad.txt:1: symmetry 'HERMITIAN'");
    refuse("no size line", banner + "general\n% nothing\n", "is missing");
    refuse("size line cut short",
           banner + "general\n2 2\n",
           "bad.txt:2: this line must give");
    refuse("rectangular",
           banner + "general\n2 3 1\n1 1 1.\n",
           "bad.txt:2: the matrix has 2 rows and 3 columns");
    refuse("no rows", banner + "general\n0 0 0\n", "bad.txt:2: ");
    refuse("truncated",
           banner + "general\n2 2 3\n1 1 1.\n2 2 1.\n",
           "after 2 of 3 entries: it is truncated");
    refuse("too many entries",
           banner + "general\n2 2 1\n1 1 1.\n2 2 1.\n",
           "bad.txt:4: more entries than the 1 announced");
    refuse("entry cut short",
           banner + "general\n2 2 2\n1 1 1.\n2 2\n",
           "bad.txt:4: an entry has");
    refuse("row 0",
           banner + "general\n2 2 1\n0 1 1.\n",
           "bad.txt:3: row 0 is outside 1 to 2");
    refuse("column out of range",
           banner + "general\n2 2 1\n1 3 1.\n",
           "bad.txt:3: column 3 is outside 1 to 2");
    refuse("row that is no integer",
           banner + "general\n2 2 1\n1.5 1 1.\n",
           "bad.txt:3: row '1.5' is not an integer");
    refuse(
      "NaN", banner + "general\n2 2 1\n1 1 nan\n", "bad.txt:3: value 'nan'");
    refuse("infinity",
           banner + "general\n2 2 1\n1 1 -Inf\n",
           "bad.txt:3: value '-Inf' is not finite");
    refuse("number beyond double",
           banner + "general\n2 2 1\n1 1 1e999\n",
           "bad.txt:3: value '1e999' is not finite");
    refuse("not a number",
           banner + "general\n2 2 1\n1 1 1.0.0\n",
           "bad.txt:3: value '1.0.0' is not a number");
    refuse("entry given twice",
           banner + "general\n2 2 3\n1 1 1.\n2 2 1.\n1 1 1.\n",
           "bad.txt:5: entry (1, 1) is given twice, first in line 3");
    refuse("both halves in a symmetric file",
           banner + "symmetric\n2 2 4\n1 1 2\n2 1 1\n1 2 1\n2 2 3\n",
           "bad.txt:5: entry (1, 2) is given twice, first in line 4");
    refuse("diagonal of a skew-symmetric matrix",
           banner + "skew-symmetric\n2 2 1\n1 1 1\n",
           "bad.txt:3: entry (1, 1) is on the diagonal",
           Role::damping);
    refuse("last number cut",
           banner + "general\n1 1 1\n1 1 3200",
           "bad.txt: its last line has no line end");
    const std::string unsymmetric =
      banner + "general\n2 2 4\n1 1 2\n2 1 1\n1 2 1.01\n2 2 3\n";
    for (const Role role : {Role::mass, Role::stiffness, Role::normal_contact})
      refuse("unsymmetric where it must be symmetric",
             unsymmetric,
             "bad.txt:5: entry (1, 2) is 1.01, its mirror image 1",
             role);
    refuse("a part of C as stiffness",
           banner + "symmetric\n% " + damping_mark + "\n1 1 1\n1 1 1\n",
           "its role is friction");
  }

  void
  test_abaqus()
  {
    refuse("unsymmetric beside a held unknown",
           "1,1, 1,1, 2e8\n1,1, 1,2, -1e8\n1,2, 1,1, 1e8\n1,2, 1,2, 2e8\n"
           "2,1, 2,1, 1e36\n",
           "this role needs a symmetric matrix");
    refuse("last line cut",
           "1 1 1.\n2 2 1.",
           "bad.txt: its last line has no line end");
    refuse("format LABELS or other fields",
           "1 1 1.\n1 1 1 1.\n",
           "bad.txt:2: an entry has");
    refuse("formats mixed",
           "1 1 1.\n2,1, 2,1, 1.\n",
           "bad.txt:2: this entry has 5 fields, those before it 3");
    refuse("row 0", "1 1 1.\n0 1 1.\n", "bad.txt:2: row 0 is not positive");
    refuse("Abaqus' own node in COORDINATE",
           "1 1 1.\n-1 -1 1.\n",
           "bad.txt:2: row -1 is not positive");
    refuse("node 0", "0,1, 0,1, 1.\n", "bad.txt:1: node number 0");
    refuse("degree of freedom 0",
           "1,0, 1,0, 1.\n",
           "bad.txt:1: degree of freedom 0 does not exist");
    refuse("NaN", "1,1, 1,1, NaN\n", "bad.txt:1: matrix entry 'NaN'");
    refuse("names of part instances",
           "1,1, PAD-1.4,1, 2.\n",
           "bad.txt:1: node number 'PAD-1.4' is not an integer");
    refuse("entry given twice",
           "1,1, 1,1, 1.\n2,1, 2,1, 1.\n1,1, 1,1, 1.\n",
           "bad.txt:3: entry (node 1, component 1; node 1, component 1)");
    refuse("symmetric that is not",
           "*MATRIX INPUT, NAME=K, TYPE=SYMMETRIC\n1,1, 1,1, 1.\n"
           "2,1, 2,1, 1.\n1,1, 2,1, .5\n2,1, 1,1, .4\n",
           "differs from its mirror image");
    refuse("other keyword",
           "1,1, 1,1, 1.\n*MATRIX ASSEMBLE, STIFFNESS=K\n",
           "bad.txt:2: keyword");
    refuse("second matrix",
           "1,1, 1,1, 1.\n*MATRIX INPUT, NAME=M\n1,1, 1,1, 1.\n",
           "bad.txt:2: a second matrix");
    refuse("no entries", "*MATRIX INPUT, NAME=M\n", "holds no matrix entry");
    for (const char *type : {"SYMMET\xd2IC", "SYMMETRICAL", "", "FULL"})
      refuse("an unknown type",
             std::string("*MATRIX INPUT, NAME=K, TYPE=") + type +
               "\n1,1, 1,1, 1.\n",
             "bad.txt:1: TYPE");
  }

  void
  test_nastran()
  {
    const std::string header = "DMIG,K,0,6,2\n", term = "DMIG,K,1,1,,1,1,5.\n";
    refuse("last line cut", header + "DMIG,K,1,1,,1,1,5.", "no line end");
    refuse("no header", term, "no DMIG header entry");
    refuse("two headers", header + header + term, "bad.txt:2: DMIG K has a");
    refuse("name that is not there",
           header + term,
           "no DMIG matrix 'MAAX'; there are K",
           Role::mass,
           "MAAX");
    refuse("a name where the format has none",
           banner + "general\n1 1 1\n1 1 1.\n",
           "'Matrix name' = 'MAAX' has no meaning here",
           Role::mass,
           "MAAX");
    refuse("a name where the format has none",
           "1,1, 1,1, 1.\n",
           "Abaqus hold one matrix",
           Role::mass,
           "MAAX");
    refuse("replication",
           header + term + "=,=,*(1),=,=,*(1),==\n",
           "bad.txt:3: replication");
    refuse("several matrices",
           header + "DMIG,M,0,6,2\n" + term,
           "which of the DMIG matrices K, M to take");
    refuse("rectangular",
           "DMIG,K,0,9,2,,,,3\n" + term,
           "bad.txt:1: DMIG K has form 9",
           Role::stiffness,
           "K");
    refuse("complex", "DMIG,K,0,6,4\n" + term, "bad.txt:1: DMIG K has type 4");
    refuse("no terms", header, "DMIG K has no terms");
    refuse("column without terms",
           header + "DMIG*,K,1,1,\nDMIG,K,2,1,,2,1,3.\n",
           "bad.txt:2: this column of DMIG K has no terms");
    refuse("term without value",
           header + "DMIG,K,1,1,,1,1\n",
           "bad.txt:2: matrix term '' is not a number");
    refuse("component 7",
           header + "DMIG,K,1,7,,1,1,5.\n",
           "bad.txt:2: component 7 does not exist");
    refuse("grid point 0 as a row",
           header + "DMIG,K,1,1,,0,1,5.\n",
           "bad.txt:2: grid point 0 does not exist");
    refuse("imaginary part",
           header + "DMIG,K,1,1,,1,1,5.,2.\n",
           "bad.txt:2: the term has an imaginary part");
    refuse("field 5 not blank",
           header + "DMIG,K,1,1,1,1,1,5.\n",
           "bad.txt:2: field 5");
    refuse("too many fields",
           header + "DMIG,K,1,1,,1,1,5.,,,2,1,3.\n",
           "bad.txt:2: too many fields");
    refuse("both halves of a symmetric matrix",
           header + "DMIG,K,1,1,,1,1,5.\n,2,1,3.\nDMIG,K,2,1,,1,1,3.\n",
           "is given twice");
    refuse("value not finite",
           header + "DMIG,K,1,1,,1,1,inf\n",
           "bad.txt:2: matrix term 'inf' is not finite");
  }

  void
  refuse_table(const std::string &claim,
               const std::string &text,
               const std::string &message)
  {
    const std::string file = write_text("nodes.csv", text);
    check_refused(claim, message, [&]() { read_node_table(file); });
  }

  void
  test_node_table()
  {
    const std::string header = "dof,node,component,x,y,z,body\n";
    refuse_table("no lines", header, "nodes.csv:1: the table has no lines");
    refuse_table("missing column",
                 "dof,node,component,x,y,body\n1,1,1,0,0,pad\n",
                 "nodes.csv:1: column 'z' is missing");
    refuse_table("unknown column",
                 "dof,node,component,x,y,z,body,colour\n",
                 "nodes.csv:1: column 'colour' is not known");
    refuse_table("column twice",
                 "dof,node,component,x,y,z,body,x\n",
                 "nodes.csv:1: column 'x' is there twice");
    refuse_table("line cut short",
                 header + "1,1,1,0,0,0,pad\n2,1,2,0,0\n",
                 "nodes.csv:3: this line has 5 values, the header 7");
    refuse_table("last number cut",
                 header + "1,1,1,0,0,0,pad",
                 "nodes.csv: its last line has no line end");
    refuse_table("NaN",
                 header + "1,1,1,nan,0,0,pad\n",
                 "nodes.csv:2: x 'nan' is not finite");
    refuse_table("dof 0", header + "0,1,1,0,0,0,pad\n", "nodes.csv:2: dof 0");
    refuse_table("dof twice",
                 header + "1,1,1,0,0,0,pad\n1,1,2,0,0,0,pad\n",
                 "nodes.csv:3: dof 1 is given twice");
    refuse_table("name twice",
                 header + "1,1,1,0,0,0,pad\n2,1,1,0,0,0,pad\n",
                 "nodes.csv:3: node 1, component 1 is given twice");
    refuse_table("no body", header + "1,1,1,0,0,0,\n", "nodes.csv:2: the body");
  }

  void
  refuse_pattern(const std::string &claim,
                 const std::string &text,
                 const std::string &message)
  {
    const std::string file = write_text("contact.csv", text);
    check_refused(claim, message, [&]() { read_contact_pattern(file); });
  }

  void
  test_contact_pattern()
  {
    const std::string header = "pair,side,direction,dof,weight\n";
    refuse_pattern(
      "no lines", header, "contact.csv:1: the pattern has no lines");
    refuse_pattern("neither dof nor node",
                   "pair,side,direction,weight\n1,source,normal,1\n",
                   "contact.csv:1: the header line needs either dof or node");
    refuse_pattern("both dof and node",
                   "pair,side,direction,dof,node,component,weight\n",
                   "contact.csv:1: the header line needs either dof or node");
    refuse_pattern("unknown side",
                   header + "1,disc,normal,1,1\n",
                   "contact.csv:2: side 'disc' is not known");
    refuse_pattern("unknown direction",
                   header + "1,source,z,1,1\n",
                   "contact.csv:2: direction 'z' is not known");
    refuse_pattern("weight not finite",
                   header + "1,source,normal,1,inf\n",
                   "contact.csv:2: weight 'inf' is not finite");
    const std::string with_factor =
      "pair,side,direction,dof,weight,stiffness_factor\n";
    refuse_pattern("stiffness factor 0",
                   with_factor + "1,source,normal,1,1,0\n",
                   "contact.csv:2: the stiffness factor must be positive");
    refuse_pattern("two stiffness factors",
                   with_factor + "1,source,normal,1,1,1\n"
                                 "1,source,sliding,1,1,2\n",
                   "contact.csv:3: pair 1 has two different");
  }
} // namespace

int
main()
{
  test_files();
  test_matrix_market();
  test_abaqus();
  test_nastran();
  test_node_table();
  test_contact_pattern();
}
