// SPDX-License-Identifier: LGPL-2.1-or-later

// A modulus table is met at its entries, monotone and smooth between them,
// refused beyond them, and whatever damages it is named in one line.

#include <squeal/scene/modulus_table.h>

#include "../parameters/prm_test.h"

#include <cmath>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using E = BodyParameters::ModulusExtrapolation;

  const std::string header =
    "frequency_Hz, temperature_C, storage_modulus_Pa, loss_factor\n";
  const std::string good = "# a rubber\n" + header +
                           "100, 20, 1e6, 0.2\n"
                           "1000, 20, 4e6, 0.8\n"
                           "\n"
                           "3000, 20, 9e6, 0.8\n"
                           "10000, 20, 3e7, 0.5\n"
                           "100, 60, 5e5, 0.1\n"
                           "10000, 60, 2e6, 0.3\n";

  ModulusTable
  table(const std::string &text)
  {
    write_text("table.csv", text);
    return ModulusTable("table.csv");
  }

  void
  values()
  {
    const ModulusTable t = table(good);
    check_close(
      t.at(1000., 20., 0., E::refused).storage, 4e6, 1e-14, "an entry");
    check_close(
      t.at(1000., 20., 0., E::refused).loss_factor, .8, 1e-14, "its loss");
    check_close(
      t.at(1e4, 60., 0., E::refused).storage, 2e6, 1e-14, "the last one");
    check_close(t.at(100., 30., 0., E::refused).storage,
                1e6 * std::pow(.5, .25),
                1e-13,
                "between temperatures, log E is linear");
    check_close(t.at(1000., 60., 0., E::refused).storage,
                1e6,
                1e-13,
                "of two entries log E is linear over log f");
    double before = 0., slope_before = -1.;
    bool   rises = true, is_smooth = true;
    for (double f = 100.; f < 1e4; f *= 1.001)
      {
        const double e = std::log(t.at(f, 20., 0., E::refused).storage);
        if (before > 0.)
          {
            rises = rises && e > before;
            // no corner: the slope per step changes by little
            if (slope_before > 0.)
              is_smooth =
                is_smooth && std::abs(e - before - slope_before) < 2e-5;
            slope_before = e - before;
          }
        before = e;
      }
    check(rises, "the storage modulus rises where its entries do");
    check(is_smooth, "without corners");
    for (double f = 1000.; f < 3000.; f *= 1.1)
      check_close(t.at(f, 20., 0., E::refused).loss_factor,
                  .8,
                  1e-13,
                  "a loss factor that is constant between equal entries");
    check_close(t.at(1., 20., 0., E::constant).storage, 1e6, 1e-14, "below");
    check_close(
      t.at(1e6, 90., 0., E::constant).storage, 2e6, 1e-14, "beyond both");
    const ModulusTable c = table(header + "1, 20, 3.3e7, 0.4\n"
                                          "10, 20, 3.3e7, 0.4\n"
                                          "1e5, 20, 3.3e7, 0.4\n");
    for (const double f : {2., 77., 5432.1})
      check_close(
        c.at(f, 20., 0., E::refused).storage, 3.3e7, 2e-14, "constant");
  }

  void
  pressures()
  {
    const std::string with_pressure =
      "pressure_Pa, frequency_Hz, temperature_C, storage_modulus_Pa, "
      "loss_factor\n";
    // A lining that its pressure stiffens, more so when it is cold.
    const ModulusTable t = table(with_pressure + "1e6, 100, 20, 2e9, 0.1\n"
                                                 "1e6, 10000, 20, 2e9, 0.1\n"
                                                 "3e6, 100, 20, 8e9, 0.3\n"
                                                 "3e6, 10000, 20, 8e9, 0.3\n"
                                                 "1e6, 100, 100, 1e9, 0.2\n"
                                                 "1e6, 10000, 100, 1e9, 0.2\n"
                                                 "3e6, 1000, 100, 1e9, 0.2\n"
                                                 "3e6, 10000, 100, 1e9, 0.2\n");
    check(t.depends_on_pressure(), "a table with pressures");
    check(!table(good).depends_on_pressure(), "one without");
    check_close(
      t.at(2e3, 20., 3e6, E::refused).storage, 8e9, 1e-14, "an entry");
    check_close(t.at(2e3, 20., 1.5e6, E::refused).storage,
                2e9 * std::pow(4., .25),
                1e-13,
                "between pressures log E is linear");
    check_close(t.at(2e3, 20., 1.5e6, E::refused).loss_factor,
                .15,
                1e-13,
                "and the loss factor");
    check_close(t.at(2e3, 60., 2e6, E::refused).storage,
                std::sqrt(std::sqrt(2e9 * 1e9) * std::sqrt(8e9 * 1e9)),
                1e-13,
                "between temperatures at either pressure");
    check_close(
      t.at(2e3, 20., 9e6, E::constant).storage, 8e9, 1e-14, "beyond the last");
    check_refused([&]() { t.at(2e3, 20., 9e6, E::refused); },
                  {"from 1e6 to 3e6 Pa", "9e6"},
                  "a pressure beyond the table");
    check_refused([&]() { t.at(500., 60., 2e6, E::refused); },
                  {"1000", "at 3e6 Pa", "500 Hz"},
                  "a frequency that one of two pressures has not");
    check_refused(
      [&]() {
        table(with_pressure + "-1, 100, 20, 2e9, 0.1\n1, 200, 20, 2e9, 0.1\n");
      },
      {"table.csv:2", "at least 0"},
      "a pressure below 0");
    check_refused([&]() { table(with_pressure + "1, 100, 20, 2e9\n"); },
                  {"table.csv:2", "4 values, the header 5"},
                  "a line without its pressure");
  }

  void
  refusals()
  {
    const auto refuses = [](const std::string              &text,
                            const std::vector<std::string> &parts) {
      check_refused([&]() { table(text); }, parts, parts.back());
    };
    refuses("", {"table.csv", "empty"});
    refuses("frequency_Hz, temperature_C, storage_modulus_Pa\n1, 2, 3\n",
            {"table.csv:1", "'loss_factor' is missing"});
    refuses("frequency_Hz, temperature_C, storage_modulus_Pa, eta\n",
            {"table.csv:1", "'eta' is not known"});
    refuses(header + "1, 20, 3\n", {"table.csv:2", "3 values"});
    refuses(header + "1, 20, 3e6, x\n", {"table.csv:2", "loss_factor"});
    refuses(header + "1, 20, nan, 0.1\n",
            {"table.csv:2", "storage_modulus_Pa"});
    refuses(header + "0, 20, 3e6, 0.1\n", {"table.csv:2", "frequency_Hz"});
    refuses(header + "1, 20, 0, 0.1\n", {"table.csv:2", "greater than 0"});
    refuses(header + "1, 20, 3e6, -0.1\n", {"table.csv:2", "from 0 to 10"});
    refuses(header + "1, 20, 3e6, 0.1\n1, 20, 4e6, 0.1\n",
            {"table.csv:3", "already"});
    refuses(header + "1, 20, 3e6, 0.1\n", {"at least two"});
    refuses(header, {"no rows"});
    refuses(header + "1, 20, 3e6, 0.1\n2, 20, 1.2e7, 0.1\n",
            {"rises like the power 2 "});
    refuses(header + "1, 20, 3e6, 0.1\n2, 20, 3e6, 0.",
            {"table.csv", "truncated"});
    const ModulusTable t = table(good);
    check_refused([&]() { t.at(99., 20., 0., E::refused); },
                  {"from 100 to 10000 Hz", "99 Hz"},
                  "a frequency below the table");
    check_refused([&]() { t.at(1000., 61., 0., E::refused); },
                  {"from 20 to 60 degrees", "61"},
                  "a temperature above it");
  }

  /** What a scene does with its table. */
  void
  scenes()
  {
    write_text("table.csv", good);
    write_text("layer.prm",
               "set Analysis = cea\nset Output directory = out\n"
               "subsection Scene\nset Bodies = pad, shim\nset Supports = hold\n"
               "subsection Body pad\nend\n"
               "subsection Body shim\nset Shape = layer\nset Layer body = pad\n"
               "set Layer face = z_max\nset Modulus table file = table.csv\n"
               "end\n"
               "subsection Support hold\nset Body = pad\nset Face = z_min\n"
               "end\nend\n"
               "subsection Eigenvalues\nset Lowest frequency = 400\n"
               "set Highest frequency = 6400\nend\n");
    const auto read = [](const std::vector<std::string> &overrides) {
      Parameters p = read_parameters("layer.prm", overrides);
      p.check();
      take_modulus_tables(p);
      return p;
    };
    const Parameters     p = read({});
    const ComplexModulus there =
      ModulusTable("table.csv").at(1600., 20., 0., E::refused);
    check(p.scene.bodies[1].young_modulus == there.storage &&
            p.scene.bodies[1].table_loss_factor == there.loss_factor,
          "bodies have the modulus in the middle of the band");
    const auto refuses = [&](const std::string              &entry,
                             const std::vector<std::string> &parts) {
      check_refused([&]() { read({entry}); }, parts, entry);
    };
    refuses("Analysis = modes", {"for 'modes'"});
    refuses("Analysis = transient", {"for 'transient'"});
    refuses("Analysis = sweep", {"for 'sweep'"});
    refuses("Eigenvalues/Solver = direct", {"Eigenvalues/Solver", "shim"});
    refuses("Eigenvalues/Compare with direct = true",
            {"Compare with direct", "shim"});
    refuses("Output/Export matrices = true", {"Export matrices", "shim"});
    refuses("Eigenvalues/Highest frequency = 20000",
            {"body 'shim'", "table.csv", "20000 Hz"});
    refuses("Scene/Body shim/Temperature = 80", {"body 'shim'", "80"});
    read({"Scene/Body shim/Temperature = 80",
          "Scene/Body shim/Modulus extrapolation = constant"});
    refuses("Scene/Body shim/Modulus table file = none.csv",
            {"none.csv", "no such file"});
    refuses("Scene/Body shim/Material model = orthotropic", {"orthotropic"});
    check_refused(
      [&]() {
        read({"Scene/Damping/Model = per part",
              "Scene/Body shim/Structural damping = 0.1"});
      },
      {"Structural damping", "would be ignored"},
      "a loss factor beside the table");
  }
} // namespace

int
main()
{
  values();
  pressures();
  refusals();
  scenes();
}
