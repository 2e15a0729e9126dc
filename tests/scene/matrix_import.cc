// SPDX-License-Identifier: LGPL-2.1-or-later
//
// Every notation of the three formats gives the matrix that was meant.
#include <squeal/scene/matrix_import.h>

#include "../check.h"
#include "import_helpers.h"

using namespace squeal;
using namespace squeal::testing;
using Role     = MatrixPartParameters::Role;
using Symmetry = ImportedMatrix::Symmetry;

namespace
{
  /** Stiffness of two equal springs in a row, the first one to the ground. */
  const EntryMap two_springs = {{{0, 0}, 2e5},
                                {{0, 1}, -1e5},
                                {{1, 0}, -1e5},
                                {{1, 1}, 1e5}};

  void
  check_text(const std::string &claim,
             const std::string &text,
             const EntryMap    &expected    = two_springs,
             const Role         role        = Role::stiffness,
             const std::string &matrix_name = "")
  {
    const std::string    file   = write_text("matrix.txt", text);
    const ImportedMatrix matrix = read_matrix(part_of(file, role, matrix_name));
    check(entries_of(matrix) == expected, claim);
    bool is_sorted = true;
    for (std::size_t k = 1; k < matrix.rows.size(); ++k)
      is_sorted =
        is_sorted && std::tie(matrix.rows[k - 1], matrix.columns[k - 1]) <
                       std::tie(matrix.rows[k], matrix.columns[k]);
    check(is_sorted, claim + ": sorted, no place twice");
  }

  void
  test_matrix_market()
  {
    check_text("MatrixMarket, lower half",
               "%%MatrixMarket matrix coordinate real symmetric\n"
               "% a comment\n\n2 2 3\n1 1 2e5\n2 1 -1.0E5\n2 2 1e+05\n");
    check_text("MatrixMarket, upper half, Windows line ends",
               "%%matrixmarket MATRIX Coordinate Integer Symmetric\r\n"
               "2 2 3\r\n1 1 200000\r\n1 2 -100000\r\n2 2 +100000\r\n");
    check_text("MatrixMarket, general",
               "%%MatrixMarket matrix coordinate real general\n"
               "2 2 4\n1 1 2e5\n2 1 -1e5\n2 2 1e5\n1 2 -1e5\n");
    check_text("MatrixMarket, mirror images equal to printed digits",
               "%%MatrixMarket matrix coordinate real general\n"
               "2 2 4\n1 1 2e5\n2 1 -1.0000000004e5\n2 2 1e5\n"
               "1 2 -0.9999999996e5\n");
    check_text("MatrixMarket, skew-symmetric",
               "%%MatrixMarket matrix coordinate real skew-symmetric\n"
               "3 3 1\n3 1 4\n",
               {{{2, 0}, 4.}, {{0, 2}, -4.}},
               Role::damping);
    check_text("MatrixMarket, a friction part is not mirrored",
               "%%MatrixMarket matrix coordinate real general\n"
               "2 2 2\n1 1 0.\n2 1 7\n",
               {{{1, 0}, 7.}},
               Role::friction);
  }

  void
  test_abaqus()
  {
    check_text("Abaqus COORDINATE, full",
               "1 1 2.000000e+05\n2 1 -1.0e+05\n1 2 -1.0e+05\n2 2 1.0e+05\n");
    check_text("Abaqus COORDINATE, one half of a stiffness",
               "  1   1   2.000000e+05\n 2 1 -1.0e+05\n 2 2 1.0e+05\n");
    check_text("Abaqus COORDINATE, one half of a stiffness in role friction",
               "1 1 2.000000e+05\n2 1 -1.0e+05\n2 2 1.0e+05\n",
               two_springs,
               Role::friction);
    check_text("Abaqus COORDINATE, friction couples two unknowns one way",
               "2 1 5.\n",
               {{{1, 0}, 5.}},
               Role::friction);
    check_text("Abaqus MATRIX INPUT, either half, names in any order",
               "** a comment\n"
               "12,3, 12,3, 1.000000000000000e+05\n"
               "12,3, 4,3, -1.000000000000000e+05\n"
               "4,3, 4,3, 2.000000000000000e+05\n");
    check_text("Abaqus MATRIX INPUT, symmetric but full",
               "*MATRIX INPUT, NAME=K, TYPE=SYMMETRIC\n"
               "4,3, 4,3, 2e5\n12,3, 12,3, 1e5\n"
               "12,3, 4,3, -1e5\n4,3, 12,3, -1e5\n");
    check_text("Abaqus MATRIX INPUT, unsymmetric",
               "*Matrix Input, name=K, type=unsymmetric\n"
               "4,1, 4,1, 2.\n4,1, 4,2, 1.\n4,2, 4,2, 3.\n",
               {{{0, 0}, 2.}, {{0, 1}, 1.}, {{1, 1}, 3.}},
               Role::damping);

    const ImportedMatrix matrix =
      read_matrix(part_of(write_text("names.txt",
                                     "7,6, 7,6, 1.\n7,1, 7,1, 2.\n"
                                     "-3,1, -3,1, 3.\n"),
                          Role::mass));
    const std::vector<DofLabel> names = {{-3, 1}, {7, 1}, {7, 6}};
    check(matrix.labels == names && !matrix.size_is_given,
          "names ascend by node and component, Abaqus' own nodes first");
    check(matrix.values == std::vector<double>({3., 2., 1.}),
          "values follow their names");
    // Their product with anything overflows.
    const ImportedMatrix large =
      read_matrix(part_of(write_text("large_names.txt",
                                     "5218811905693566749,1, "
                                     "5218811905693566749,1, 1.\n"),
                          Role::mass));
    check(large.labels == std::vector<DofLabel>({{5218811905693566749, 1}}),
          "a number of a node may be as large as it is");
  }

  void
  test_nastran()
  {
    const std::string header =
      "DMIG    KAAX           0       6       2       0\n";
    check_text("DMIG, large fields that touch each other",
               "$ punch\n" + header +
                 "DMIG*   KAAX                          21               3\n"
                 "*                     21               3 2.000000000D+05\n"
                 "*                     22               3-1.000000000D+05\n"
                 "DMIG*   KAAX                          22               3\n"
                 "*                     22               3 1.000000000D+05\n");
    check_text("DMIG, small fields, exponents without a letter",
               header +
                 "DMIG    KAAX          21       3              21       3    "
                 "2.+5\n"
                 "*\n"
                 "+             22       3  -1.0+5\n"
                 "DMIG    KAAX          22       3              22       3 "
                 "1.0E+05\nENDDATA\n");
    check_text("DMIG, free fields, other entries in between",
               "GRID,21,,0.,0.,0.\n,99\nDMIG,kaax,0,1,2\n"
               "DMIG,KAAX,21,3,,21,3,2.+5,,+A\n+A,22,3,-1.+5\n"
               "ASET1,3,21,22\n"
               "DMIG*,KAAX,22,3,\n*,21,3,-1.D5,0.\n*,22,3,1.D5\n");
    check_text("DMIG, tabs, scalar points",
               "DMIG\tKAAX\t0\t6\t1\nDMIG\tKAAX\t1\t\t\t1\t\t2.E5\n"
               "\t2\t0\t-1.E5\nDMIG\tKAAX\t2\t0\t\t2\t\t1.E5\n");

    const std::string two =
      header + "DMIG    MAAX           0       6       2       0\n"
               "DMIG    PAX            0       9       2       0\n"
               "DMIG,PAX,1,0,,21,1,3.\n"
               "DMIG,MAAX,21,1,,21,1,5.\nDMIG,KAAX,21,1,,21,1,7.\n";
    check_text(
      "DMIG, the matrix asked for", two, {{{0, 0}, 5.}}, Role::mass, "maax");
    check_text("DMIG, the only square matrix",
               two.substr(0, two.find("DMIG    MAAX")) +
                 two.substr(two.find("DMIG    PAX")),
               {{{0, 0}, 7.}});
  }

  void
  test_symmetry()
  {
    const auto symmetry_of = [](const std::string &text, const Role role) {
      return read_matrix(part_of(write_text("matrix.txt", text), role))
        .symmetry;
    };
    check(symmetry_of("1 1 1.\n2 2 1.\n1 2 3.\n2 1 3.\n", Role::damping) ==
            Symmetry::symmetric,
          "symmetric damping is seen");
    check(symmetry_of("1 2 3.\n2 1 -3.\n", Role::damping) == Symmetry::skew,
          "skew-symmetric (gyroscopic) damping is seen");
    check(symmetry_of("1 1 1.\n1 2 3.\n2 1 -3.\n", Role::damping) ==
            Symmetry::general,
          "other damping is general");
    // Friction of 4/3 of a stiffness of 1e8, beside a held unknown.
    const std::string held = "2,1, 2,1, 1.0e36\n",
                      mirrored =
                        "1,2, 1,2, 2e8\n1,2, 1,3, -.3333e8\n1,3, 1,2, 1e8\n"
                        "1,3, 1,3, 2e8\n",
                      one_way = "1,2, 1,2, 2e8\n1,3, 1,3, 2e8\n1,3, 1,4, 3e8\n"
                                "1,4, 1,4, 2e8\n1,2, 1,3, 1e8\n1,3, 1,2, 1e8\n";
    for (const Role role : {Role::friction, Role::damping})
      for (const std::string &text : {mirrored, one_way})
        {
          const ImportedMatrix matrix =
            read_matrix(part_of(write_text("matrix.txt", text + held), role));
          const ImportedMatrix free =
            read_matrix(part_of(write_text("matrix.txt", text), role));
          check(matrix.symmetry == Symmetry::general &&
                  matrix.values.size() == free.values.size() + 1 &&
                  std::equal(free.values.begin(),
                             free.values.end(),
                             matrix.values.begin()),
                "a held unknown does not make the others symmetric");
        }
    check(symmetry_of("1,2, 1,2, 2e8\n1,2, 1,3, 1e8\n1,3, 1,2, 1e8\n"
                      "1,3, 1,3, 2e8\n2,1, 1,2, 7.\n1,2, 2,1, 5.\n" +
                        held,
                      Role::stiffness) == Symmetry::symmetric,
          "what couples to a held unknown is taken out and may be anything");
    check(symmetry_of("1 1 2e8\n2 2 2e8\n3 3 1e-5\n1 2 1e8\n2 1 1e8\n"
                      "1 3 1e-8\n3 1 -1e-8\n",
                      Role::stiffness) == Symmetry::symmetric,
          "what cancellation leaves is symmetric");
  }

  void
  test_storage()
  {
    using Storage = ImportedMatrix::Storage;
    // A dashpot between the nodes 1 and 3, as one half; 2 has a zero only.
    const std::string half =
      "1,3, 1,3, 500.\n2,3, 1,3, 0.\n3,3, 1,3, -500.\n3,3, 3,3, 500.\n";
    check_text(
      "Abaqus, one half of a damping matrix with a zero entry",
      half,
      {{{0, 0}, 500.}, {{0, 2}, -500.}, {{2, 0}, -500.}, {{2, 2}, 500.}},
      Role::damping);
    const auto storage_of = [](const std::string &text) {
      return read_matrix(
               part_of(write_text("matrix.txt", text), Role::friction))
        .storage;
    };
    check(storage_of(half) == Storage::assumed_half, "one half is assumed");
    check(storage_of("1,1, 1,1, 0.\n1,2, 1,1, 5.\n1,2, 1,2, 0.\n") ==
            Storage::assumed_full,
          "zeros on the diagonal are no half of a symmetric matrix");
    check(storage_of("*MATRIX INPUT, NAME=K, TYPE=SYMMETRIC\n" + half) ==
            Storage::stated,
          "what a file states is not assumed");
  }
} // namespace

int
main()
{
  test_matrix_market();
  test_abaqus();
  test_nastran();
  test_symmetry();
  test_storage();
}
