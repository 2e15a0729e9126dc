// SPDX-License-Identifier: LGPL-2.1-or-later

// Imported matrices with eigenvalues in closed form. Three masses, one of which
// a negative stiffness pushes away: that is no free motion, and its growth rate
// is sqrt(-k/m), however fast that is beside the band; the direct solver finds
// it, too, and a sweep. A chain of masses with an unknown without mass between
// any two. Two masses that friction couples grow by 0.1 1/s in a band that is
// wide. Pairs that friction or gyroscopic terms bring into the band from modes
// far above it, decoupled from all others, are found, and a direct pair without
// a certified one is told. Argument: the program.

#include <squeal/eigen/direct_solver.h>
#include <squeal/results/table.h>

#include "program.h"
#include "worst.h"

#include <cmath>
#include <complex>
#include <vector>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Entries = std::map<std::pair<unsigned int, unsigned int>, double>;

  /** The lower half of a symmetric matrix; rows and columns from 0. */
  void
  write_matrix(const std::string &file,
               const unsigned int n,
               const Entries     &entries)
  {
    std::ostringstream text;
    text.precision(17);
    text << "%%MatrixMarket matrix coordinate real symmetric\n"
         << n << " " << n << " " << entries.size() << "\n";
    for (const auto &[place, value] : entries)
      text << place.first + 1 << " " << place.second + 1 << " " << value
           << "\n";
    write_text(file, text.str());
  }

  /** Eigenvalues of mass.mtx and stiffness.mtx below @p highest, with further
   * settings of the section of eigenvalues, and others behind it. */
  Table
  solved(const std::string &program,
         const std::string &highest,
         const std::string &more     = "",
         const std::string &analysis = "cea",
         const std::string &behind   = "")
  {
    write_text("matrices.prm",
               "set Analysis = " + analysis +
                 "\nset Output directory = out\n"
                 "set Overwrite = true\n"
                 "subsection Output\n set Plots = false\n"
                 " set Report = false\nend\n"
                 "subsection Scene\n set Kind = matrices\n"
                 " set Matrix parts = m, k\n"
                 " subsection Matrix part m\n  set File = mass.mtx\n"
                 "  set Role = mass\n end\n"
                 " subsection Matrix part k\n  set File = stiffness.mtx\n"
                 "  set Role = stiffness\n end\nend\n"
                 "subsection Eigenvalues\n set Highest frequency = " +
                 highest + "\n" + more + "end\n" + behind);
    const Outcome o = run_program({program, "matrices.prm"});
    check(o.code == 0, "the matrices are solved: " + o.errors);
    return read_csv("out/eigenvalues.csv");
  }

  void
  negative_stiffness(const std::string &program)
  {
    write_matrix("mass.mtx", 3, {{{0, 0}, 2.}, {{1, 1}, 2.}, {{2, 2}, 2.}});
    write_matrix(
      "stiffness.mtx", 3, {{{0, 0}, -8e6}, {{1, 1}, 2e7}, {{2, 2}, 5e7}});
    for (const std::string solver : {"certified", "direct"})
      {
        const Table table =
          solved(program, "1000", " set Solver = " + solver + "\n");
        check(table.n_rows() == 4, solver + ": two motions at 0 Hz");
        Worst sigma, frequency;
        for (std::size_t r = 0; r < table.n_rows(); ++r)
          {
            sigma.add(table.real(r, "sigma_per_s"));
            if (std::abs(table.real(r, "sigma_per_s")) > 1.)
              frequency.add(std::abs(table.real(r, "frequency_hz")));
          }
        check_close(
          sigma.largest(), 2000., 1e-8, solver + ": it diverges by sqrt(-k/m)");
        check_close(
          sigma.smallest(), -2000., 1e-8, solver + ": and comes back as fast");
        check_within(frequency, 0., solver + ": without any frequency");
      }
    // 2000 1/s is more than 4 pi times 100 Hz.
    const Table fast = solved(program, "100");
    check(fast.n_rows() == 1, "growth counts however fast it is");
    check_close(fast.real(0, "sigma_per_s"), 2000., 1e-8, "beside the band");
  }

  /** Twelve masses, of which one diverges by sqrt(-k/m); all stiffness grows
   * along the axis. Half of the others are in the band in the end. */
  void
  fast_divergence(const std::string &program)
  {
    constexpr unsigned int n = 12;
    Entries                m, k;
    for (unsigned int i = 0; i < n; ++i)
      {
        m[{i, i}] = 2.;
        k[{i, i}] =
          i == 0 ? -8e6 : 2. * std::pow(2. * M_PI * (20. + 15. * i), 2);
      }
    write_matrix("mass.mtx", n, m);
    write_matrix("stiffness.mtx", n, k);
    const Table table =
      solved(program,
             "100",
             "",
             "sweep",
             "subsection Sweep\n set Axes = s\n set Direct checks = 6\n"
             " subsection Axis s\n"
             "  set Entries = Scene/Matrix part k/Factor\n"
             "  set Scale = logarithmic\n  set From = 0.01\n  set To = 1\n"
             "  set Number = 5\n end\nend\n");
    unsigned int n_diverging = 0;
    Worst        off;
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      if (table.real(r, "sigma_per_s") > 1.)
        {
          ++n_diverging;
          off.add(std::abs(table.real(r, "sigma_per_s") /
                             std::sqrt(4e6 * table.real(r, "s")) -
                           1.));
        }
    check(n_diverging == 5, "it diverges all along the axis");
    check_within(off, 1e-6, "by sqrt(-k/m)");
    const Table checks = read_csv("out/direct_check.csv");
    Worst       errors, decay;
    for (std::size_t r = 0; r < checks.n_rows(); ++r)
      {
        errors.add(checks.real(r, "error_rel"));
        decay.add(checks.real(r, "sigma_per_s"));
      }
    check(decay.smallest() < -500., "some decay faster than the band is wide");
    check_within(errors, 1e-6, "and the direct solver agrees");
  }

  /** lambda^2 + c lambda + omega^2 +- i mu k = 0 grows from mu = c omega / k
   * on, by some 0.1 1/s at most. */
  void
  slow_growth_in_a_wide_band(const std::string &program)
  {
    constexpr double omega = 200. * M_PI, c = .02, k = .42 * M_PI * 100.;
    write_matrix("mass.mtx", 2, {{{0, 0}, 1.}, {{1, 1}, 1.}});
    write_matrix(
      "stiffness.mtx", 2, {{{0, 0}, omega * omega}, {{1, 1}, omega * omega}});
    std::ostringstream friction;
    friction.precision(17);
    friction << "%%MatrixMarket matrix coordinate real general\n2 2 2\n2 1 "
             << -k << "\n1 2 " << k << "\n";
    write_text("friction.mtx", friction.str());
    write_text("wide.prm",
               "set Analysis = sweep\nset Output directory = wide\n"
               "set Overwrite = true\n"
               "subsection Output\n set Plots = false\n"
               " set Report = false\nend\n"
               "subsection Scene\n set Kind = matrices\n"
               " set Matrix parts = m, k, n\n set Friction coefficient = 0.9\n"
               " subsection Matrix part m\n  set File = mass.mtx\n"
               "  set Role = mass\n end\n"
               " subsection Matrix part k\n  set File = stiffness.mtx\n end\n"
               " subsection Matrix part n\n  set File = friction.mtx\n"
               "  set Role = friction\n end\n"
               " subsection Damping\n  set Model = whole model\n"
               "  set Mass damping = 0.02\n end\nend\n"
               "subsection Eigenvalues\n set Lowest frequency = 20\n"
               " set Highest frequency = 100000\nend\n"
               "subsection Sweep\n set Axes = mu\n set Direct checks = 2\n"
               " set Scatter samples = 100\n"
               " subsection Axis mu\n"
               "  set Entries = Scene/Friction coefficient\n"
               "  set From = 0\n  set To = 0.9\n  set Number = 10\n"
               " end\nend\n");
    const Outcome o = run_program({program, "wide.prm"});
    check(o.code == 0, "a sweep of a wide band: " + o.errors);
    const Table  pairs      = read_csv("wide/eigenvalues.csv");
    unsigned int n_unstable = 0;
    for (std::size_t r = 0; r < pairs.n_rows(); ++r)
      n_unstable += pairs.integer(r, "unstable");
    check(n_unstable == 9, "it grows at all points but the first");
    const Table ranges = read_csv("wide/unstable_ranges.csv");
    check(ranges.n_rows() == 1, "in one range");
    check_close(ranges.real(0, "lower"),
                c * omega / k,
                1e-4,
                "from the friction of the closed form on");
    check(read_csv("wide/scatter.csv").real(0, "probability") > .7,
          "and most of what scatters over it");
  }

  /** Between two masses there are two springs and an unknown without mass,
   * which leaves half of the stiffness of one. */
  void
  without_mass(const std::string &program, const std::string &highest)
  {
    constexpr unsigned int n_masses = 30, n = 2 * n_masses + 1;
    constexpr double       mass = 1., spring = 1e7;
    Entries                m, k;
    for (unsigned int i = 0; i < n; ++i)
      {
        k[{i, i}] = 2. * spring;
        if (i > 0)
          k[{i, i - 1}] = -spring;
        if (i % 2 == 1)
          m[{i, i}] = mass;
      }
    write_matrix("mass.mtx", n, m);
    write_matrix("stiffness.mtx", n, k);
    const Table table     = solved(program, highest);
    const auto  frequency = [&](const unsigned int i) {
      return std::sqrt(.5 * spring / mass) *
             std::sin((i + 1) * M_PI / (2. * (n_masses + 1))) / M_PI;
    };
    Worst        off;
    unsigned int expected = 0;
    while (expected < n_masses && frequency(expected) < std::stod(highest))
      ++expected;
    check(table.n_rows() == expected,
          std::to_string(expected) + " pairs below " + highest + " Hz");
    for (unsigned int i = 0; i < expected; ++i)
      off.add(std::abs(table.real(i, "frequency_hz") / frequency(i) - 1.));
    check_within(off, 1e-9, "the chain of half the stiffness");
  }

  /** Entries of a matrix that is not symmetric. */
  void
  write_general(const std::string &file,
                const unsigned int n,
                const Entries     &entries)
  {
    std::ostringstream text;
    text.precision(17);
    text << "%%MatrixMarket matrix coordinate real general\n"
         << n << " " << n << " " << entries.size() << "\n";
    for (const auto &[place, value] : entries)
      text << place.first + 1 << " " << place.second + 1 << " " << value
           << "\n";
    write_text(file, text.str());
  }

  /** Forty masses on springs of their own, four of them in a band to 100 Hz,
   * and @p copies of two masses at 3000 Hz each, which friction couples by
   * @p attraction times their stiffness, and gyroscopic terms and negative
   * damping where @p gyroscopic. Returns the first table of the run. */
  Table
  with_hidden_masses(const std::string &program,
                     const unsigned int copies,
                     const double       attraction,
                     const bool         gyroscopic,
                     const std::string &analysis,
                     const std::string &behind)
  {
    constexpr unsigned int n_seen = 40;
    constexpr double       k_high = 36e6 * M_PI * M_PI, omega = 100. * M_PI,
                     gyro = (k_high - omega * omega) / omega;
    const unsigned int n  = n_seen + 2 * copies;
    Entries            m, k, c, f;
    for (unsigned int i = 0; i < n; ++i)
      {
        const double own =
          2. * M_PI * (i < 4 ? 20. + 20. * i : 300. * std::pow(1.15, i - 4.));
        m[{i, i}] = 1.;
        k[{i, i}] = i < n_seen ? own * own : k_high;
        c[{i, i}] = i < n_seen ? .02 * own : gyroscopic ? -1. : 0.;
      }
    f[{0, 1}] = 1.; // one way: changes no eigenvalue
    for (unsigned int i = n_seen; i < n; i += 2)
      {
        f[{i, i + 1}] = f[{i + 1, i}] = attraction * k_high;
        c[{i, i + 1}]                 = gyroscopic ? gyro : 0.;
        c[{i + 1, i}]                 = -c[{i, i + 1}];
      }
    write_matrix("mass.mtx", n, m);
    write_matrix("stiffness.mtx", n, k);
    write_general("damping.mtx", n, c);
    write_general("friction.mtx", n, f);
    write_text("hidden.prm",
               "set Analysis = " + analysis +
                 "\nset Output directory = hidden\nset Overwrite = true\n"
                 "subsection Output\n set Plots = false\n"
                 " set Report = false\nend\n"
                 "subsection Scene\n set Kind = matrices\n"
                 " set Matrix parts = m, k, c, n\n"
                 " set Friction coefficient = 1\n"
                 " subsection Matrix part m\n  set File = mass.mtx\n"
                 "  set Role = mass\n end\n"
                 " subsection Matrix part k\n  set File = stiffness.mtx\n end\n"
                 " subsection Matrix part c\n  set File = damping.mtx\n"
                 "  set Role = damping\n end\n"
                 " subsection Matrix part n\n  set File = friction.mtx\n"
                 "  set Role = friction\n end\nend\n"
                 "subsection Eigenvalues\n set Highest frequency = 100\nend\n" +
                 behind);
    const Outcome o = run_program({program, "hidden.prm"});
    check(o.code == 0, "decoupled masses: " + o.errors);
    return read_csv("hidden/eigenvalues.csv");
  }

  void
  check_growth(const Table       &table,
               const unsigned int n_expected,
               const double       sigma,
               const std::string &name)
  {
    unsigned int n = 0;
    Worst        off;
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      if (table.integer(r, "unstable") == 1)
        {
          ++n;
          off.add(std::abs(table.real(r, "sigma_per_s") / sigma - 1.));
        }
    check(n == n_expected,
          name + ": " + std::to_string(n_expected) + " that grow, not " +
            std::to_string(n));
    check_within(off, 1e-6, name + ": as the closed form");
  }

  void
  decoupled_masses(const std::string &program)
  {
    // lambda^2 = (attraction - 1) k
    const double fast = .1 * 6000. * M_PI;
    for (const unsigned int copies : {1u, 6u})
      check_growth(with_hidden_masses(program, copies, 1.01, false, "cea", ""),
                   copies,
                   fast,
                   std::to_string(copies) +
                     " divergences by friction far above the band");
    // lambda^2 - (1 + i g) lambda + k = 0, the root near 50 Hz
    const double               k = 36e6 * M_PI * M_PI, omega = 100. * M_PI;
    const std::complex<double> b(-1., -(k - omega * omega) / omega);
    const std::complex<double> root = std::sqrt(b * b - 4. * k),
                               far  = std::abs(root - b) > std::abs(root + b)
                                        ? .5 * (root - b)
                                        : -.5 * (root + b);
    check_growth(with_hidden_masses(program, 1, 0., true, "cea", ""),
                 1,
                 (k / far).real(),
                 "whirl with negative damping far above the band");
    const Table table =
      with_hidden_masses(program,
                         1,
                         1.,
                         false,
                         "sweep",
                         "subsection Sweep\n set Axes = mu\n"
                         " subsection Axis mu\n"
                         "  set Entries = Scene/Friction coefficient\n"
                         "  set From = 0.9\n  set To = 1.01\n"
                         "  set Number = 11\n end\nend\n");
    check_growth(table, 1, fast, "divergence at the last point of a sweep");
  }

  void
  missing_pairs()
  {
    DirectPairs direct;
    direct.pairs.lambda.resize(5);
    direct.pairs.lambda << std::complex<double>(-1., 100.), 30., 0.,
      std::complex<double>(2., 200.), std::complex<double>(0., 900.);
    direct.pairs.residual = Eigen::VectorXd::Zero(5);
    Eigen::VectorXcd known(1);
    known << std::complex<double>(-1.00001, 100.);
    const auto missing = pairs_missing(known, direct, 0., 800. / (2. * M_PI));
    check(missing == std::vector<unsigned int>({1, 3}),
          "direct pairs without a certified one, in the band");
    const std::string text = text_of_missing(direct.pairs.lambda(missing));
    check(text.find("2 pairs") != std::string::npos &&
            text.find("0 Hz with sigma 30") != std::string::npos,
          "are named, the fastest first: " + text);
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc == 2, "the program");
  negative_stiffness(argv[1]);
  fast_divergence(argv[1]);
  slow_growth_in_a_wide_band(argv[1]);
  for (const std::string highest : {"200", "500", "1000"})
    without_mass(argv[1], highest);
  decoupled_masses(argv[1]);
  missing_pairs();
}
