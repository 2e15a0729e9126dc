// SPDX-License-Identifier: LGPL-2.1-or-later

// What is packed comes out as it was, message ends are noticed, and all ranks
// get the bytes of all.

#include "check.h"

#include <squeal/base/packing.h>

#include <deal.II/base/mpi.h>

#include <limits>
#include <stdexcept>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  struct Plain
  {
    int    a;
    double b;
  };

  void
  test_round_trip()
  {
    const std::vector<std::string> texts{"", "one", std::string("a\0b", 3)};
    const std::vector<std::vector<double>> nested{
      {}, {1., -0., std::numeric_limits<double>::infinity()}, {2.5}};
    const Eigen::MatrixXd  matrix = Eigen::MatrixXd::Random(3, 2);
    const Eigen::MatrixXd  flat(0, 3);
    const Eigen::MatrixXcd lines = Eigen::MatrixXcd::Random(2, 5);
    Packer                 packer;
    packer.put(Plain{7, .1});
    packer.put(texts);
    packer.put(nested);
    packer.put(matrix);
    packer.put(flat);
    packer.put(lines);
    packer.put(std::string());
    packer.put(-3L);

    Unpacker                         unpacker(packer.bytes());
    Plain                            plain;
    std::vector<std::string>         texts_out{"left over"};
    std::vector<std::vector<double>> nested_out;
    Eigen::MatrixXd                  matrix_out, flat_out(4, 4);
    Eigen::MatrixXcd                 lines_out;
    std::string                      empty = "left over";
    long                             last  = 0;
    check(!unpacker.is_empty(), "full at first");
    unpacker.get(plain);
    unpacker.get(texts_out);
    unpacker.get(nested_out);
    unpacker.get(matrix_out);
    unpacker.get(flat_out);
    unpacker.get(lines_out);
    unpacker.get(empty);
    check(!unpacker.is_empty(), "and while something is left");
    unpacker.get(last);
    check(unpacker.is_empty(), "empty in the end");
    check(plain.a == 7 && plain.b == .1, "a plain structure");
    check(texts_out == texts, "texts, with zeros in them");
    check(nested_out == nested && std::signbit(nested_out[1][1]),
          "vectors of vectors to the bit");
    check(matrix_out == matrix, "a matrix");
    check(flat_out.rows() == 0 && flat_out.cols() == 3, "one without rows");
    check(lines_out == lines, "a complex matrix");
    check(empty.empty() && last == -3L, "an empty text, a number");
  }

  void
  test_ends()
  {
    const std::vector<char> nothing = Packer().bytes();
    check(nothing.empty() && Unpacker(nothing).is_empty(), "nothing packed");
    Packer packer;
    packer.put(std::string("twelve bytes"));
    std::vector<char> bytes = packer.bytes();
    bytes.pop_back();
    check_throws<std::out_of_range>(
      [&] {
        std::string text;
        Unpacker(bytes).get(text);
      },
      "",
      "a text cut short is refused");
    check_throws<std::out_of_range>(
      [&] {
        double x;
        Unpacker(nothing).get(x);
      },
      "",
      "a number that is not there is refused");
  }

  /** Rank r has r texts, so the first one has few bytes. */
  void
  test_ranks()
  {
    const int rank = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD),
              n    = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    std::vector<char> own(3 * rank, static_cast<char>('a' + rank));
    const auto        all = gather_on_all(MPI_COMM_WORLD, own);
    check(static_cast<int>(all.size()) == n, "one list a rank");
    for (int r = 0; r < n; ++r)
      check(all[r] == std::vector<char>(3 * r, static_cast<char>('a' + r)),
            "the bytes of rank " + std::to_string(r));
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize init(argc, argv, 1);
  test_round_trip();
  test_ends();
  test_ranks();
}
