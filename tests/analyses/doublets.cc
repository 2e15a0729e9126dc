// SPDX-License-Identifier: LGPL-2.1-or-later
//
// The table of doublets: pairs of one family, circles and diameters; of several
// modes of one name the two closest to each other.
#include <squeal/model/doublets.h>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;

int
main()
{
  using Type = Table::Type;
  Table      modes({{"frequency_hz", Type::real, "Hz", ""},
                    {"name", Type::text, "", ""},
                    {"nodal_circles", Type::integer, "", ""},
                    {"nodal_diameters", Type::integer, "", ""},
                    {"parity", Type::text, "", ""}});
  const auto add = [&](const double       f,
                       const std::string &name,
                       const int          diameters,
                       const std::string &parity) {
    modes.add_row({f, name, 0, diameters, parity});
  };
  add(1000., "(0,3+)", 3, "+");
  add(1100., "(0,3-) support radial 1", 3, "-");
  add(1900., "(0,3+) support normal 1", 3, "+");
  add(5000., "T(0,3+)", 3, "+");
  add(5001., "T(0,3-)", 3, "-");
  add(2000., "(0,0)", 0, "");
  add(3000., "(0,4+)", 4, "+");
  // Near ties: of the parity, next to a "+", and of everything.
  add(3001., "(0,4+)|(0,4-)", 4, "");
  modes.add_row({5000.5, "(0,9+)|T(0,3-)", Cell(), Cell(), ""});
  const Table doublets = doublet_table(modes);
  check(doublets.n_rows() == 2,
        "a mode without partner, or a near tie, is no doublet");
  check(doublets.text(0, "family") == "bending" &&
          doublets.text(1, "family") == "tangential",
        "bending and in-plane modes of one name are kept apart");
  check_close(
    doublets.real(0, "split_hz"), -100., 1e-12, "the two that are closest");
  check_close(doublets.real(1, "split_hz"), -1., 1e-9, "in the plane");
}
