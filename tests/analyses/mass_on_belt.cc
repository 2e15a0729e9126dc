// SPDX-License-Identifier: LGPL-2.1-or-later

// A mass of three unknowns from matrices that slides on a belt: its limit cycle
// is the same in files of any consistent units, also of those in which all
// frequencies are small numbers; steps that are too short for friction that
// falls with the slip rate are warned of, none where it rises; its history has
// no force where it is open, and no changes from before its start. Arguments:
// the program and the claim.

#include <squeal/results/contact_history.h>
#include <squeal/results/table.h>

#include "program.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  /** How many units of the files a metre, a second and a kilogram are. */
  struct Units
  {
    double metre = 1., second = 1., kilogram = 1.;
  };

  std::string
  number(const double x)
  {
    std::ostringstream text;
    text.precision(17);
    text << x;
    return text.str();
  }

  void
  write_symmetric(const std::string &file, const std::vector<double> &lower)
  {
    std::string text =
      "%%MatrixMarket matrix coordinate real symmetric\n3 3 6\n";
    unsigned int k = 0;
    for (unsigned int i = 1; i <= 3; ++i)
      for (unsigned int j = 1; j <= i; ++j)
        text += std::to_string(i) + " " + std::to_string(j) + " " +
                number(lower[k++]) + "\n";
    write_text(file, text);
  }

  void
  write_files(const Units &u)
  {
    const double stiffness = u.kilogram / (u.second * u.second),
                 force = stiffness * u.metre, m = .1 * u.kilogram;
    write_symmetric("M.mtx", {m, 0., m, 0., 0., m});
    std::vector<double> K = {3631234.8706482691,
                             515453.23818839953,
                             3997226.5672543352,
                             -301259.25792361051,
                             -961549.47100799216,
                             1971538.5620973955};
    for (double &k : K)
      k *= stiffness;
    write_symmetric("K.mtx", K);
    write_text("contact.csv",
               "contact,pair,side,direction,node,component,weight,x,y,z,area\n"
               "belt,1,source,normal,1,3,1,0,0,0,1e-4\n"
               "belt,1,source,sliding,1,1,0.44721359549995793,0,0,0,1e-4\n"
               "belt,1,source,sliding,1,2,0.89442719099991586,0,0,0,1e-4\n"
               "belt,1,source,transverse,1,1,0.89442719099991586,0,0,0,1e-4\n"
               "belt,1,source,transverse,1,2,-0.44721359549995793,0,0,0,"
               "1e-4\n");
    write_text("nodes.csv",
               "dof,node,component,x,y,z,body,load_press\n"
               "1,1,1,0,0,0,mass,0\n2,1,2,0,0,0,mass,0\n3,1,3,0,0,0,mass,-" +
                 number(100. * force) + "\n");
  }

  /** The scene in @p u, with @p friction as further entries of the contact and
   * @p behind as further sections. */
  Outcome
  run(const std::string &program,
      const Units       &u,
      const std::string &analysis,
      const std::string &friction,
      const std::string &behind)
  {
    write_files(u);
    const double stiffness = u.kilogram / (u.second * u.second);
    write_text(
      "belt.prm",
      "set Analysis = " + analysis +
        "\nset Output directory = out\nset Overwrite = true\n"
        "subsection Output\n set Plots = false\n set Report = false\nend\n"
        "subsection Scene\n set Kind = matrices\n"
        " set Matrix parts = mass, stiffness\n set Contacts = belt\n"
        " set Loads = press\n set Contact pattern file = contact.csv\n"
        " set Node table file = nodes.csv\n"
        " subsection Matrix part mass\n  set File = M.mtx\n"
        "  set Role = mass\n end\n"
        " subsection Matrix part stiffness\n  set File = K.mtx\n"
        "  set Role = stiffness\n end\n subsection Load press\n end\n"
        " subsection Contact belt\n  set Source body = mass\n"
        "  set Formulation = springs\n  set Normal stiffness = " +
        number(2.5e6 * stiffness) +
        "\n  set Tangential stiffness = " + number(5e6 * stiffness) +
        "\n  set Contact state = preload\n"
        "  set Transverse slip term = true\n  set Sliding speed = " +
        number(.5 * u.metre / u.second) + "\n  set Normal force = " +
        number(100. * stiffness * u.metre) + "\n" + friction +
        " end\n subsection Damping\n  set Model = whole model\n"
        "  set Mass damping = " +
        number(20. / u.second) +
        "\n  set Stiffness damping = " + number(2e-6 * u.second) +
        "\n end\nend\nsubsection Eigenvalues\n set Lowest frequency = " +
        number(100. / u.second) + "\n set Highest frequency = " +
        number(5000. / u.second) + "\nend\n" + behind);
    return run_program({program, "belt.prm"});
  }

  /** Frequency in Hz and rms of the normal force in N of the limit cycle. */
  std::pair<double, double>
  cycle_in(const std::string &program, const Units &u)
  {
    const Outcome o =
      run(program,
          u,
          "limit cycle",
          "  set Friction coefficient = 0.6\n",
          "subsection Transient\n set Cut-off = " + number(2e4 / u.second) +
            "\nend\nsubsection Limit cycle\n set Run time = " +
            number(.1 * u.second) + "\nend\n");
    check(o.code == 0, "a limit cycle in any units: " + o.errors);
    const Table table = read_csv("out/limit_cycle.csv");
    check(table.text(0, "cycle_status") == "periodic", "it is periodic");
    return {table.real(0, "frequency_hz") * u.second,
            table.real(0, "rms_normal_n") * u.second * u.second /
              (u.metre * u.kilogram)};
  }

  void
  units(const std::string &program)
  {
    const auto si = cycle_in(program, {});
    for (const Units &u : {Units{1e3, 1e3, 1.},   // mm, ms, kg
                           Units{1e3, 1., 1e-3},  // mm, s, tonne
                           Units{1e6, 1e6, 1e6}}) // um, us, mg
      {
        const auto cycle = cycle_in(program, u);
        std::printf("%.4f Hz and %.4f N, in SI units %.4f Hz and %.4f N\n",
                    cycle.first,
                    cycle.second,
                    si.first,
                    si.second);
        check_close(cycle.first, si.first, 1e-3, "frequency of the cycle");
        check_close(cycle.second, si.second, 5e-3, "rms of the cycle");
      }
  }

  /** -dmu/dv of 0.75 s/m at rest and 0.215 s/m at the sliding speed, 2e-7 m/N
   * and some 56 N: 8.4 and 2.4 us. */
  void
  short_lag(const std::string &program)
  {
    const std::string exponential = "  set Friction coefficient = 0.3\n"
                                    "  set Friction law = exponential\n"
                                    "  set Static friction coefficient = 0.6\n"
                                    "  set Decay speed = 0.4\n",
                      // 1 s/m, from 0.6 m/s on: above the sliding speed.
      table = "  set Friction law = table\n"
              "  set Friction speeds = 0, 0.6, 0.8\n"
              "  set Friction coefficients = 0.5, 0.5, 0.3\n",
                      // 0.4 s/m: the flexibility times the force makes 4.5 us.
      rising         = "  set Friction law = table\n"
                       "  set Friction speeds = 0, 0.5, 1\n"
                       "  set Friction coefficients = 0.3, 0.5, 0.7\n";
    const auto warns = [&](const std::string &friction,
                           const std::string &step,
                           const std::string &final_ratio) {
      const Outcome o =
        run(program,
            {},
            "transient",
            friction,
            "subsection Transient\n set Cut-off = 20000\n"
            " set Start = steady sliding\n set Time step = " +
              step + "\n set Final speed ratio = " + final_ratio +
              "\n set End time = 0.002\n"
              " set Sample interval = 2e-5\nend\n");
      check(o.code == 0, "the motion is computed: " + o.errors);
      std::printf("%s\n", o.errors.c_str());
      return unbroken(o.errors + o.output)
               .find("that friction which falls so steeply needs") !=
             std::string::npos;
    };
    check(warns(exponential, "1e-6", "1"),
          "steps below the limit are warned of");
    check(!warns(exponential, "1e-5", "1"), "steps above it are not");
    check(!warns(table, "1e-6", "1"), "a fall that is not reached is not");
    check(warns(table, "1e-6", "2"), "one that the speed rises through is");
    check(warns(table, "1e-6", "-2"), "and so after it has turned back");
    check(!warns(table, "1e-6", "-1.1"), "but not below it");
    check(!warns(rising, "1e-6", "1"), "no step is too short where it rises");
  }

  /** A blow lifts the mass off the belt again and again. */
  void
  history_of_open_contact(const std::string &program)
  {
    constexpr double start = .01;
    const Outcome    o =
      run(program,
          {},
          "transient",
          "  set Friction coefficient = 0.3\n",
          "subsection Transient\n set Cut-off = 20000\n"
          " set Start = steady sliding\n set Disturbance = 0.1\n"
          " set Time step = 1e-5\n set Sample interval = 1e-5\n"
          " set End time = 0.02\n set History start = 0.01\nend\n");
    check(o.code == 0, "the motion is computed: " + o.errors);
    const HistoryReader reader("out/contact_history.h5");
    HistorySamples      s;
    reader.read(0, reader.n_samples(), s);
    unsigned int n_open = 0, n_pressed = 0, n_pulled = 0;
    for (std::size_t i = 0; i < s.n_samples(); ++i)
      if (static_cast<ContactStatus>(s.status[i]) == ContactStatus::open)
        {
          ++n_open;
          n_pressed += s.pressure[i] != 0.;
          n_pulled += s.traction[2 * i] != 0. || s.traction[2 * i + 1] != 0.;
        }
    std::printf("%u of %zu samples are open\n", n_open, s.n_samples());
    check(n_open > 50 && n_open + 50 < s.n_samples(), "it opens and closes");
    check(n_pressed == 0 && n_pulled == 0, "an open contact has no forces");
    const auto changes = reader.status_changes();
    check(changes.size() > 2, "changes of status are written");
    check(changes.front().time >= start - 1e-9, "none from before the start");
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc > 2, "arguments: the program and the claim");
  const std::string claim = argv[2];
  if (claim == "units")
    units(argv[1]);
  else if (claim == "short_lag")
    short_lag(argv[1]);
  else if (claim == "open")
    history_of_open_contact(argv[1]);
  else
    check(false, "a claim: units, short_lag or open");
}
