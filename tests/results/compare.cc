// SPDX-License-Identifier: LGPL-2.1-or-later
// Two runs are compared mode by mode, whatever their order and names.
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/results/compare.h>
#include <squeal/results/run_record.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  const std::string folder = "compare_test/";

  struct Mode
  {
    double      frequency;
    double      sigma;
    std::string name;
    int         shape;              /**< number of its random shape; 0: none */
    double      error_by_mesh = 0.; /**< of sigma, 1/s */
  };

  /** A shape known by its number, with a phase and size that do not matter and
   * a little noise. */
  Signature
  signature(const int number, const double phase)
  {
    std::mt19937                     random(number);
    std::normal_distribution<double> normal;
    Signature                        shape(30);
    for (auto &sample : shape)
      sample = {normal(random), normal(random)};
    std::mt19937 noise(1000 * number + static_cast<int>(10 * phase));
    for (auto &sample : shape)
      {
        sample += 0.05 * std::complex<double>(normal(noise), normal(noise));
        sample *= std::polar(1. + phase, phase);
      }
    return shape;
  }

  /** Ten samples of body beam, twenty of body pin. */
  std::vector<std::string>
  beam_and_pin()
  {
    std::vector<std::string> entries;
    for (int i = 1; i <= 30; ++i)
      entries.push_back(i <= 10 ? "beam_" + std::to_string(i)
                                : "pin_" + std::to_string(i - 10));
    return entries;
  }

  void
  write_run(const std::string       &name,
            const std::vector<Mode> &modes,
            const double             phase,
            const std::string       &friction)
  {
    fs::create_directories(folder + name);
    using Type = Table::Type;
    Table                  table({{"point", Type::integer, "", ""},
                                  {"index", Type::integer, "", ""},
                                  {"sigma_per_s", Type::real, "1/s", ""},
                                  {"frequency_hz", Type::real, "Hz", ""},
                                  {"error_estimate_rel", Type::real, "", ""},
                                  {"sigma_error_mesh_per_s", Type::real, "1/s", ""},
                                  {"name", Type::text, "", ""}});
    std::vector<long long> indices;
    std::vector<Signature> signatures;
    for (const Mode &mode : modes)
      {
        const long long index = indices.size() + 1;
        table.add_row({0,
                       index,
                       mode.sigma,
                       mode.frequency,
                       1e-9,
                       mode.error_by_mesh,
                       mode.name});
        indices.push_back(index);
        if (mode.shape > 0)
          signatures.push_back(signature(mode.shape, phase));
      }
    table.write_csv(folder + name + "/eigenvalues.csv");
    if (!signatures.empty())
      make_signature_table(indices, beam_and_pin(), signatures)
        .write_csv(folder + name + "/signature.csv");
    RunRecord record;
    record.parameters = {{"Scene/Friction coefficient", friction},
                         {"Output directory", name},
                         {"Result checks/Check a/Expected", name},
                         {"Analysis", "cea"}};
    write_run_record(record, folder + name + "/run.json");
  }

  /** The row of @p table whose column a holds @p index, or -1. */
  int
  row_of(const Table &table, const long long index)
  {
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      if (!table.is_missing(r, "a") && table.integer(r, "a") == index)
        return r;
    return -1;
  }

  void
  test_assurance()
  {
    const Signature a = {{1., 0.}, {0., 2.}}, b = {{0., 3.}, {-6., 0.}};
    check_close(modal_assurance(a, b), 1., 1e-14, "MAC ignores phase and size");
    check(modal_assurance({{1., 0.}, {0., 0.}}, {{0., 0.}, {1., 0.}}) == 0. &&
            modal_assurance({}, {}) == 0. &&
            modal_assurance({{0., 0.}}, {{1., 0.}}) == 0.,
          "MAC of unlike and of empty shapes is zero");
  }

  void
  test_by_shape()
  {
    // B: other order, a mode lost, one new, the pair at 5 kHz now coalesced
    write_run("a",
              {{1630., -5., "(0,0)", 1},
               {2594., -13., "(0,3)-", 2},
               {3520., 94., "(0,3)+", 3},
               {4990., -49., "(0,4)+", 4},
               {5010., -49., "support 4", 5}},
              0.,
              "0.3");
    write_run("b",
              {{2600., -13., "(0,3)-", 2},
               {3500., -17., "support 3", 3},
               {4998., 438., "support 4", 4},
               {4998.2, -530., "(0,4)+", 5},
               {6000., -60., "torsion", 6}},
              1.,
              "0.5");
    std::ostringstream  out;
    const RunComparison result = compare_runs(folder + "a", folder + "b", out);
    const Table        &table  = result.table;
    check(result.by_shape, "signatures in both runs are used");
    check(table.n_rows() == 6, "four pairs, one only in A, one only in B");
    const auto b_of = [&](const long long a) {
      const int row = row_of(table, a);
      return table.is_missing(row, "b") ? -1 : table.integer(row, "b");
    };
    check(b_of(2) == 1 && b_of(3) == 2 && b_of(4) == 3 && b_of(5) == 4 &&
            b_of(1) == -1,
          "shapes find each other, also where names changed");
    check(table.real(row_of(table, 4), "mac") > 0.95 &&
            std::abs(table.real(row_of(table, 4), "df_hz") - 8.) < 1e-9 &&
            std::abs(table.real(row_of(table, 4), "dsigma") - 487.) < 1e-9,
          "changes are those from A to B");
    check(result.new_instabilities.size() == 1 &&
            result.new_instabilities[0].find("4998.00 Hz support 4") == 0,
          "a mode that became unstable is new");
    check(result.vanished_instabilities.size() == 1 &&
            result.vanished_instabilities[0].find("3520.00 Hz (0,3)+") == 0,
          "a mode that became stable is gone");
    const std::string text = out.str();
    check(text.find("Scene/Friction coefficient  0.3  0.5") !=
              std::string::npos &&
            text.find("Analysis  ") == std::string::npos &&
            text.find("Output") == std::string::npos &&
            text.find("Result checks") == std::string::npos,
          "the parameter that shapes the result and differs is shown, and no "
          "other");
    check(text.find("NEW INSTABILITY") != std::string::npos &&
            text.find("in B: support 3") != std::string::npos &&
            text.find("only in A") != std::string::npos &&
            text.find("only in B") != std::string::npos,
          "the notes say what happened");
  }

  /** What the mesh leaves open has neither come nor gone. */
  void
  test_open_growth()
  {
    write_run("closed",
              {{1000., -5., "x 1", 1, 2.}, {2000., 8., "x 2", 2, 2.}},
              0.,
              "0.3");
    write_run("open",
              {{1000., 5., "x 1", 1, 50.}, {2000., -8., "x 2", 2, 50.}},
              0.,
              "0.3");
    std::ostringstream out;
    const auto result = compare_runs(folder + "closed", folder + "open", out);
    check(result.new_instabilities.empty() &&
            result.vanished_instabilities.empty() &&
            result.open_growth.size() == 2 &&
            out.str().find("Growth open by the mesh:") != std::string::npos,
          "pairs whose growth is open by the mesh are neither new nor gone: " +
            out.str());
  }

  /** Each side is judged by itself: stable, open and unstable in A against the
   * same in B, in one table of nine pairs. */
  void
  test_changes_of_growth()
  {
    const struct
    {
      double      sigma, error;
      std::string in_a;
    } sides[] = {
      {-400., 2., "stable"}, {-1., -2., "open"}, {500., 2., "grows"}};
    const std::string notes[3][3] = {
      {"", "growth open by the mesh", "NEW INSTABILITY"},
      {"growth decided: stable in B",
       "growth open by the mesh",
       "NEW INSTABILITY; open by the mesh in A"},
      {"instability gone", "growth open by the mesh", "unstable"}};
    for (const double sign : {1., -1.}) // of what is open
      {
        std::vector<Mode> a, b;
        for (int i = 0; i < 3; ++i)
          for (int j = 0; j < 3; ++j)
            {
              const std::string name = "x " + std::to_string(a.size());
              const auto        mode = [&](const int k) {
                return Mode{1000. * (a.size() + 1.),
                            (k == 1 ? sign : 1.) * sides[k].sigma,
                            name,
                            0,
                            sides[k].error};
              };
              const Mode in_a = mode(i), in_b = mode(j);
              a.push_back(in_a);
              b.push_back(in_b);
            }
        write_run("nine_a", a, 0., "0.3");
        write_run("nine_b", b, 0., "0.3");
        std::ostringstream out;
        const auto         result =
          compare_runs(folder + "nine_a", folder + "nine_b", out);
        for (int k = 0; k < 9; ++k)
          {
            const int row = row_of(result.table, k + 1);
            check(result.table.text(row, "note") == notes[k / 3][k % 3],
                  sides[k / 3].in_a + " in A, " + sides[k % 3].in_a +
                    " in B: " + result.table.text(row, "note"));
          }
        check(
          result.new_instabilities ==
              std::vector<std::string>(
                {"3000.00 Hz x 2", "6000.00 Hz x 5, open by the mesh in A"}) &&
            result.vanished_instabilities ==
              std::vector<std::string>({"7000.00 Hz x 6"}) &&
            result.open_growth ==
              std::vector<std::string>(
                {"2000.00 Hz x 1", "5000.00 Hz x 4", "8000.00 Hz x 7"}),
          "the lists say the same: " + out.str());
      }
    write_run("rounding_a", {{1000., 1e-9, "x 1", 0, 3e-9}}, 0., "0.3");
    std::ostringstream out;
    check(compare_runs(folder + "rounding_a", folder + "rounding_a", out)
            .open_growth.empty(),
          "rounding of undamped pairs is no error");
  }

  /** Who writes a signature.csv, and in which order of the bodies. */
  enum class Samples
  {
    beam_first,
    pin_first,
    other_pin, /**< other points on it, as many */
    beam_first_unnamed,
    pin_first_unnamed /**< by an earlier version, which named no bodies */
  };

  /** The two shapes of which every other order of the samples makes something
   * that is more like the other one; @p bodies as in run.json, "" without. */
  void
  write_bodies(const std::string &name,
               const Samples      samples,
               const std::string &bodies)
  {
    const bool is_turned =
      samples == Samples::pin_first || samples == Samples::pin_first_unnamed;
    write_run(
      name, {{1000., 5., "beam 1", 0}, {1010., -5., "beam 1", 0}}, 0., "0.3");
    std::vector<std::string> entries = beam_and_pin();
    if (samples == Samples::other_pin)
      for (std::string &entry : entries)
        if (entry.find("pin_") == 0)
          entry = "pin_about_disc_" + entry.substr(4);
    std::vector<Signature> shapes;
    for (const bool second : {false, true})
      {
        Signature shape(30, second ? -1. : 1.);
        std::fill(shape.begin(), shape.begin() + 10, 1.);
        std::fill(shape.begin() + 20, shape.end(), second ? 1. : -1.);
        if (is_turned)
          std::rotate(shape.begin(), shape.begin() + 10, shape.end());
        shapes.push_back(shape);
      }
    if (is_turned)
      std::rotate(entries.begin(), entries.begin() + 10, entries.end());
    const std::string file = folder + name + "/signature.csv";
    make_signature_table({1, 2}, entries, shapes).write_csv(file);
    if (samples == Samples::beam_first_unnamed ||
        samples == Samples::pin_first_unnamed)
      {
        std::ifstream in(file);
        std::string   line, text = "index";
        std::getline(in, line);
        for (int c = 1; c <= 60; ++c)
          text += ",c" + std::to_string(c);
        while (std::getline(in, line))
          text += "\n" + line;
        in.close();
        std::ofstream(file) << text << '\n';
      }
    fs::remove(folder + name + "/run.json");
    if (bodies.empty())
      return;
    RunRecord record;
    record.parameters = {{"Scene/Bodies", bodies}};
    write_run_record(record, folder + name + "/run.json");
  }

  RunComparison
  compare_bodies(const Samples      a,
                 const Samples      b,
                 const std::string &bodies_a,
                 const std::string &bodies_b,
                 std::string       &printed)
  {
    write_bodies("bodies_a", a, bodies_a);
    write_bodies("bodies_b", b, bodies_b);
    std::ostringstream  out;
    const RunComparison result =
      compare_runs(folder + "bodies_a", folder + "bodies_b", out);
    printed = out.str();
    return result;
  }

  void
  check_equal(const RunComparison &result, const std::string &text)
  {
    const Table &t = result.table;
    check(result.by_shape && t.n_rows() == 2 && t.integer(0, "b") == 1 &&
            t.integer(1, "b") == 2 && t.real(0, "mac") > 1. - 1e-12 &&
            t.real(1, "mac") > 1. - 1e-12 && result.new_instabilities.empty() &&
            result.vanished_instabilities.empty() &&
            result.why_not_by_shape.empty(),
          text);
  }

  void
  test_order_of_bodies()
  {
    std::string printed;
    check_equal(compare_bodies(Samples::beam_first,
                               Samples::pin_first,
                               "beam, pin",
                               "pin, beam",
                               printed),
                "the order of the bodies does not matter");
    check_equal(
      compare_bodies(Samples::pin_first, Samples::beam_first, "", "", printed),
      "nor does it without records of the runs");
    check(printed.find("By name") == std::string::npos,
          "and there is no excuse");

    RunComparison other = compare_bodies(Samples::beam_first,
                                         Samples::other_pin,
                                         "beam, pin",
                                         "beam, pin",
                                         printed);
    check(!other.by_shape && !other.table.has_column("mac") &&
            printed.find("By name: the bodies, or the points that are sampled "
                         "on them, differ.\n") != std::string::npos,
          "other points on a body: by name, and said so");

    check_equal(compare_bodies(Samples::beam_first_unnamed,
                               Samples::beam_first,
                               "beam, pin",
                               "beam, pin",
                               printed),
                "samples without bodies count where both list them alike");
    for (const auto &bodies : {"pin, beam", ""})
      {
        other = compare_bodies(Samples::beam_first_unnamed,
                               Samples::pin_first_unnamed,
                               "beam, pin",
                               bodies,
                               printed);
        check(!other.by_shape && other.table.integer(0, "b") == 1 &&
                other.new_instabilities.empty() &&
                printed.find("By name: a signature.csv of an earlier version "
                             "names no bodies.\n") != std::string::npos,
              "and are not used where they do not, or nothing tells");
      }

    std::ofstream(folder + "bodies_a/signature.csv") << "index,re_a_1\n1,2\n";
    check_throws<InputError>(
      [&] {
        std::ostringstream out;
        compare_runs(folder + "bodies_a", folder + "bodies_b", out);
      },
      "column 're_a_1' is not the real part of a sample",
      "a signature of half a sample");
  }

  void
  test_by_name()
  {
    write_run("c",
              {{1630., -5., "(0,0)", 0},
               {5003.9, 438.6, "(0,4)+", 0},
               {5004.1, -531., "(0,4)+", 0},
               {9000., 1e-7, "noise", 0}},
              0.,
              "0.5");
    write_run("d",
              {{1600., -5., "(0,0)", 0},
               {4900.1, -520., "(0,4)+", 0},
               {4900.2, 430., "(0,4)+", 0},
               {9001., -3., "noise", 0},
               {20000., -3., "far", 0}},
              0.,
              "0.5");
    std::ostringstream  out;
    const RunComparison result = compare_runs(folder + "c", folder + "d", out);
    const Table        &table  = result.table;
    check(!result.by_shape && !table.has_column("mac"),
          "without signatures there is no MAC");
    check(table.integer(row_of(table, 2), "b") == 3 &&
            table.integer(row_of(table, 3), "b") == 2,
          "of two pairs of one name the unstable finds the unstable");
    check(result.new_instabilities.empty() &&
            result.vanished_instabilities.empty(),
          "a growth rate below its own error is no instability");
    check(out.str().find("All parameters that shape the result are the same") !=
            std::string::npos,
          "equal parameters are said to be equal");
  }

  void
  test_modes_only()
  {
    for (const std::string name : {"e", "f"})
      {
        fs::create_directories(folder + name);
        std::ofstream(folder + name + "/modes.csv")
          << "index,frequency_hz,name\n1," << (name == "e" ? 100 : 101)
          << ",support 1\n";
      }
    std::ostringstream  out;
    const RunComparison result = compare_runs(folder + "e", folder + "f", out);
    check(result.table.real(0, "df_percent") == 1. &&
            !result.table.has_column("sigma_a"),
          "undamped modes are compared by frequency");
    check(out.str().find("nstabilities") == std::string::npos,
          "and nothing is said of stability");
  }

  void
  test_sweep()
  {
    for (const std::string name : {"g", "h"})
      {
        fs::create_directories(folder + name);
        std::ofstream(folder + name + "/eigenvalues.csv")
          << "point,index,sigma_per_s,frequency_hz,name\n1,1,-1,100,s\n"
          << "2,1," << (name == "g" ? -1 : 1) << ",200,s\n";
        RunRecord record;
        record.parameters = {{"Sweep/Axis mu/To", name == "g" ? "0.5" : "0.6"}};
        write_run_record(record, folder + name + "/run.json");
      }
    std::ostringstream  out;
    const RunComparison result = compare_runs(folder + "g", folder + "h", out);
    check(result.table.n_rows() == 2 && result.new_instabilities.size() == 1 &&
            result.new_instabilities[0].find("at point 2") != std::string::npos,
          "points of a sweep are compared one by one");
    std::ostringstream whole;
    compare_runs(folder + "g", folder + "h", whole, true);
    for (const std::string &printed : {out.str(), whole.str()})
      check(printed.find("The axes differ") != std::string::npos,
            "points of other axes are told of, however short: " + printed);
  }

  void
  test_summary()
  {
    // two sweeps of 40 points with 20 pairs each that have little in common
    for (const std::string name : {"i", "j"})
      {
        fs::create_directories(folder + name);
        std::ofstream out(folder + name + "/eigenvalues.csv");
        out << "point,index,sigma_per_s,frequency_hz,name\n";
        for (int point = 0; point < 40; ++point)
          for (int k = 1; k <= 20; ++k)
            {
              const bool other = name == "j" && (k > 10 || point == 7);
              out << point << ',' << k << ',' << (other ? 5. : -5.) << ','
                  << 1000. * k * (other && k == 12 && point == 20 ? 1.04 : 1.)
                  << ",s" << k << '\n';
            }
        RunRecord record;
        for (int i = 0; i < 30; ++i)
          record.parameters.emplace_back("Scene/Entry " + std::to_string(i),
                                         std::string(60, name[0]));
        write_run_record(record, folder + name + "/run.json");
      }
    std::ostringstream brief, whole;
    compare_runs(folder + "i", folder + "j", brief);
    const RunComparison result =
      compare_runs(folder + "i", folder + "j", whole, true);
    std::istringstream lines(brief.str());
    std::size_t        n = 0;
    for (std::string line; std::getline(lines, line); ++n)
      check(line.size() <= 80, "a summary has 80 columns: " + line);
    check(n <= 40, "and 40 lines, not " + std::to_string(n));
    check(brief.str().find("800 pairs are in both runs, 390 of them equal") !=
              std::string::npos &&
            brief.str().find("30 parameters differ:") != std::string::npos &&
            brief.str().find("New instabilities: 410") != std::string::npos,
          "it counts what is equal and what differs: " + brief.str());
    const std::size_t largest = brief.str().find("The largest changes:");
    check(brief.str().find("12480", largest) <
            brief.str().find("... and 402 more", largest),
          "and names the largest change");
    const std::string all = whole.str();
    check(result.table.n_rows() == 800 &&
            std::count(all.begin(), all.end(), '\n') > 1200,
          "--all prints every pair");
  }

  void
  test_refusals()
  {
    std::ostringstream out;
    check_throws<InputError>(
      [&] { compare_runs(folder + "a", folder + "none", out); },
      "none' is not the output directory of a run",
      "a directory that is not there");
    fs::create_directories(folder + "empty");
    check_throws<InputError>(
      [&] { compare_runs(folder + "a", folder + "empty", out); },
      "has no modes.csv: --compare takes two eigenvalue analyses",
      "a directory without results");
    fs::create_directories(folder + "bad");
    std::ofstream(folder + "bad/eigenvalues.csv")
      << "index,frequency_hz,name\n1,2,a\n";
    check_throws<InputError>(
      [&] { compare_runs(folder + "a", folder + "bad", out); },
      "the column 'sigma_per_s' is missing",
      "a table without the column");
  }
} // namespace

int
main()
{
  fs::remove_all(folder);
  test_assurance();
  test_by_shape();
  test_open_growth();
  test_changes_of_growth();
  test_order_of_bodies();
  test_by_name();
  test_modes_only();
  test_sweep();
  test_summary();
  test_refusals();
  fs::remove_all(folder);
}
