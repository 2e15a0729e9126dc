// SPDX-License-Identifier: LGPL-2.1-or-later
#include "arpack_modes.h"

#include <squeal/base/exceptions.h>

#include <parpack.h>

#include <algorithm>
#include <numeric>

namespace squeal
{
  namespace
  {
    /** dsaupd's reverse communication for OP = (K - shift M)^-1 M. */
    struct Arpack
    {
      Arpack(const Pencil         &pencil,
             const ShiftedInverse &inverse,
             const unsigned int    n_wanted,
             const unsigned int    n_vectors)
        : pencil(pencil)
        , inverse(inverse)
        , n(static_cast<a_int>(pencil.space()->n_owned()))
        , nev(static_cast<a_int>(n_wanted))
        , ncv(static_cast<a_int>(n_vectors))
        , comm(MPI_Comm_c2f(pencil.space()->communicator()))
        , residual(n)
        , V(n, ncv)
        , work(3 * n)
        , small_work(ncv * (ncv + 8))
      {
        // A fixed start, the same for any number of ranks.
        for (a_int i = 0; i < n; ++i)
          residual[i] =
            1. + 0.5 * std::sin(1.7 * (pencil.space()->first_owned() + i));
        parameters[0] = 1;
        parameters[2] = 500;
        parameters[3] = 1;
        parameters[6] = 3;
      }

      void
      iterate(const double tolerance)
      {
        a_int ido = 0;
        info      = 1;
        while (true)
          {
            pdsaupd_c(comm,
                      &ido,
                      "G",
                      n,
                      "LM",
                      nev,
                      tolerance,
                      residual.data(),
                      ncv,
                      V.data(),
                      n,
                      parameters,
                      pointers,
                      work.data(),
                      small_work.data(),
                      static_cast<a_int>(small_work.size()),
                      &info);
            if (ido == 99)
              break;
            const auto column = [&](const int p) {
              return Eigen::Map<Eigen::VectorXd>(work.data() + pointers[p] - 1,
                                                 n);
            };
            if (ido == -1)
              column(1) = inverse.solve(pencil.multiply_mass(column(0)));
            else if (ido == 1)
              column(1) = inverse.solve(column(2));
            else
              column(1) = pencil.multiply_mass(column(0));
          }
        if (info != 0)
          throw ComputationError(
            "ARPACK did not converge (info = " + std::to_string(info) + ")");
      }

      UndampedModes
      extract(const double tolerance)
      {
        std::vector<a_int> select(ncv);
        Eigen::VectorXd    values(nev);
        Block              Z(n, nev);
        pdseupd_c(comm,
                  1,
                  "A",
                  select.data(),
                  values.data(),
                  Z.data(),
                  n,
                  inverse.shift(),
                  "G",
                  n,
                  "LM",
                  nev,
                  tolerance,
                  residual.data(),
                  ncv,
                  V.data(),
                  n,
                  parameters,
                  pointers,
                  work.data(),
                  small_work.data(),
                  static_cast<a_int>(small_work.size()),
                  &info);
        std::vector<int> order(nev);
        std::iota(order.begin(), order.end(), 0);
        std::sort(order.begin(), order.end(), [&](const int a, const int b) {
          return values[a] < values[b];
        });
        UndampedModes modes;
        modes.omega_squared.resize(nev);
        modes.shapes.resize(n, nev);
        modes.supplement.resize(n, 0);
        for (a_int k = 0; k < nev; ++k)
          {
            modes.omega_squared[k] = values[order[k]];
            modes.shapes.col(k)    = Z.col(order[k]);
          }
        modes.mass_products = pencil.multiply_mass(modes.shapes);
        modes.stiffness_products =
          pencil.multiply_undamped_stiffness(modes.shapes);
        set_residuals(modes, *pencil.space());
        return modes;
      }

      const Pencil         &pencil;
      const ShiftedInverse &inverse;
      const a_int           n, nev, ncv;
      const MPI_Fint        comm;
      a_int                 info = 0, parameters[11]{}, pointers[14]{};
      Eigen::VectorXd       residual;
      Eigen::MatrixXd       V;
      std::vector<double>   work, small_work;
    };
  } // namespace



  UndampedModes
  arpack_modes(const Pencil         &pencil,
               const ShiftedInverse &inverse,
               const ModeOptions    &options)
  {
    // The modes nearest to the shift are on both sides of it: ask for more
    // until all below are among them.
    const unsigned int n_total  = pencil.space()->n_global();
    const unsigned int n_below  = inverse.n_modes_below();
    unsigned int       n_wanted = n_below + n_below / 2 + 4;
    while (true)
      {
        n_wanted                     = std::min(n_wanted, n_total - 1);
        const unsigned int n_vectors = std::min(2 * n_wanted + 20, n_total);
        Arpack             arpack(pencil, inverse, n_wanted, n_vectors);
        arpack.iterate(options.tolerance);
        UndampedModes modes = arpack.extract(options.tolerance);
        const auto    found =
          (modes.omega_squared.array() < inverse.shift()).count();
        if (found >= n_below || n_wanted >= n_total - 1)
          return modes;
        n_wanted *= 2;
      }
  }
} // namespace squeal
