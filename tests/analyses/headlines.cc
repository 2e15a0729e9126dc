// SPDX-License-Identifier: LGPL-2.1-or-later

// What the first screen says: the largest of all errors with its source, and
// verdicts that do not contradict what stands beside them.

#include "check.h"

#include <squeal/analyses/transient/force_statistics.h>
#include <squeal/analyses/transient/transient_verdict.h>
#include <squeal/output/headline_error.h>
#include <squeal/output/headlines.h>
#include <squeal/output/open_signs.h>
#include <squeal/parameters/entry_traits.h>

#include <cmath>
#include <limits>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const double unknown = std::numeric_limits<double>::quiet_NaN();

  bool
  has(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }

  void
  errors()
  {
    check(headline_error({{"reduction", 1e-9}, {"mesh", 2e-3}}) ==
            rounded_text(0.2, 2) + " % (mesh)",
          "the mesh's error is the headline where it is the largest");
    check(headline_error({{"reduction", 1e-9}}) ==
            rounded_text(1e-9, 2) + " (reduction)",
          "small ones are no per cents");
    check(has(headline_error({{"mesh", 2e-3}, {"reduction", 5e-3}}, " Hz"),
              rounded_text(5e-3, 2) + " Hz (reduction)"),
          "another one where that is");
    const std::string without =
      headline_error({{"reduction", 1e-9}, {"mesh", unknown}});
    check(has(without, "(reduction)") &&
            has(without, "mesh error not estimated"),
          "a mesh error that is not estimated is said: " + without);
    check(headline_error({{"mesh", unknown}}) == "mesh error not estimated",
          "alone too");

    Table table({{"error", Table::Type::real, "", ""}});
    check(std::isnan(error_of_column("mesh", table, "error").second) &&
            std::isnan(error_of_column("mesh", table, "none").second),
          "an empty or missing column knows nothing");
    table.add_row({1e-3});
    table.add_row({Cell()});
    table.add_row({4e-3});
    table.add_row({Cell()});
    const ErrorSource source = error_of_column("mesh", table, "error");
    check(source.second == 4e-3 && source.first == "mesh, known for 2 of 4",
          "the largest of a column, and of how many: " + source.first);
  }

  /** A growth rate no larger than its error by the mesh says nothing of whether
   * the pair grows. */
  void
  signs()
  {
    const auto table = [](const std::vector<std::pair<double, Cell>> &rates) {
      Table result({{"frequency_hz", Table::Type::real, "", ""},
                    {"sigma_per_s", Table::Type::real, "", ""},
                    {"name", Table::Type::text, "", ""},
                    {"sigma_error_mesh_per_s", Table::Type::real, "", ""}});
      for (const auto &[sigma, error] : rates)
        result.add_row(
          {1000., sigma, "pair " + std::to_string(result.n_rows()), error});
      return result;
    };
    check(!open_signs(table({{9.4, -9.3}, {-3., 2.9}, {-2., Cell()}})).any(),
          "rates beyond their errors are decided, those without one are not "
          "asked");
    check(!open_signs(table({{1e-11, 3e-11}})).any(),
          "rounding of undamped pairs is no error");
    const OpenSigns open =
      open_signs(table({{9.4, -24.}, {-3., -25.}, {40., 1.}}));
    check(open.n_growing == 1 && open.n_decaying == 1 &&
            has(open.text, "pair 0") && has(open.text, "pair 1") &&
            !has(open.text, "pair 2"),
          "one of each kind is open: " + open.text);
    check(open.text.find("pair 0") < open.text.find("pair 1"),
          "the one that may grow faster first");
  }

  /** What many models say together hangs on the one that says least. */
  void
  signs_of_many()
  {
    using Verdict = HtmlReport::Verdict;
    OpenSigns decaying, growing;
    decaying.n_decaying = growing.n_growing = 1;
    decaying.pairs                          = "beam at 5000 Hz";
    GrowthOfMany growth("at", "angles", true);
    growth.add("0 deg", {}, 0, true);
    check(growth.verdict() == Verdict::good && growth.reservations().empty(),
          "nothing grows and nothing is open");
    growth.add("10 deg", decaying, 0, true);
    check(growth.verdict() == Verdict::neutral, "one decays as it seems");
    growth.add("20 deg", growing, 1, true);
    check(growth.verdict() == Verdict::neutral, "one grows as it seems");
    check(growth.left_open() == "at 2 of 3 angles the mesh leaves open whether "
                                "a pair grows (10 deg: beam at 5000 Hz)",
          "says where: " + growth.left_open());
    growth.add("30 deg", growing, 2, true);
    check(growth.verdict() == Verdict::bad, "one grows for certain");

    GrowthOfMany outside("under", "conditions", true);
    outside.add("forward", {}, 0, true);
    outside.add("backward", {}, 0, true, "a motion grows");
    outside.add("faster", {}, 0, true, "another one grows");
    check(outside.verdict() == Verdict::bad &&
            outside.reservations() ==
              "; under 2 of 3 conditions something grows that is not in the "
              "tables (backward: a motion grows)",
          "what grows beside the pairs counts: " + outside.reservations());

    GrowthOfMany unknown("under", "conditions", true);
    unknown.add("forward", {}, 0, false);
    check(unknown.verdict() == Verdict::neutral &&
            has(unknown.reservations(), "is not estimated"),
          "stable without an estimate is not good");
    GrowthOfMany some("under", "conditions", false);
    some.add("forward", {}, 0, true);
    check(some.verdict() == Verdict::neutral &&
            has(some.reservations(), "need not have all pairs"),
          "nor is it where pairs may be missing");
  }

  void
  verdicts()
  {
    TransientFigures f;
    TriggerOutcome   none, squeal, temporary;
    squeal.text    = "squeal after the trigger";
    temporary.text = "temporary after the trigger";
    f.verdict      = "stable";
    check(explained_verdict(f, none) == "stable" &&
            explained_verdict(f, temporary) == "stable" && !squeals(f, none),
          "stable is stable where nothing else is there");
    const std::string both = explained_verdict(f, squeal);
    check(has(both, "stable about steady sliding") &&
            has(both, "squeals after the trigger") &&
            has(both, "a vibration that lasts stands beside it") &&
            squeals(f, squeal),
          "beside a squeal after the trigger it is explained, and no limit "
          "cycle is said where there is none: " +
            both);
    f.has_limit_cycle = true;
    f.repetition      = 1.;
    check(has(explained_verdict(f, squeal),
              "squeals after the trigger: a limit cycle stands beside it"),
          "a limit cycle where there is one");
    check(has(explained_verdict(f, none), "a limit cycle stands beside it"),
          "and beside a limit cycle");
    f.has_unseen_motions = true;
    check(has(explained_verdict(f, none), "unless a motion above the cut-off"),
          "where not all motions are known, not for certain");
    f.has_unseen_motions = false;
    f.verdict            = "unstable";
    check(explained_verdict(f, squeal) == "unstable", "unstable says it all");
    f.frequency  = 3400.;
    f.repetition = .99;
    check(has(transient_headline(f, none), "limit cycle at 3400"),
          "what repeats itself is a limit cycle");
    f.repetition = .25;
    check(has(transient_headline(f, none), "without a period at 3400"),
          "what does not is none: " + transient_headline(f, none));
    f.has_limit_cycle = false;
    f.verdict         = "undecided";
    f.min_normal      = 63.;
    f.max_normal      = 82.;
    f.mean_normal     = 68.;
    check(has(transient_headline(f, none), "no limit cycle") &&
            has(transient_headline(f, none), "63.0 to 82.0 N"),
          "a forced motion says the range of the force");
  }

  /** Lines of samples that are too far apart for what grows are not those of
   * the motion. */
  void
  growth_beyond_samples()
  {
    LinearizedMotion motion;
    motion.lambda.resize(2);
    motion.lambda << std::complex<double>(700., 2. * M_PI * 30e3),
      std::complex<double>(20., 2. * M_PI * 3e3);
    TransientParameters t;
    t.integrator    = TransientParameters::Integrator::reduced;
    t.end_time      = .05;
    const auto told = [&](const double interval) {
      return !(frequency_beyond_samples(motion, t, interval) > 0.);
    };
    check(told(1. / 67e3) && !told(1. / 66e3),
          "two samples a period and a margin");
    t.end_time = .005;
    check(told(1. / 59e3), "what has no time to grow stays small");
    motion.lambda[0] = -motion.lambda[0];
    t.end_time       = .05;
    check(told(1. / 59e3), "what decays does not count");

    TransientFigures f;
    f.verdict         = "undecided";
    f.growing_outside = "a motion at 30000 Hz, outside the band, grows";
    f.has_limit_cycle = true;
    f.beyond_samples  = 30e3;
    f.repetition      = unknown;
    f.most_rms = f.mean_normal = 1.;
    const std::string text     = transient_headline(f, {});
    check(has(text,
              "a sustained vibration stands beside it of a frequency that its "
              "samples do not tell"),
          "the frequency is left open: " + text);
    const Table table = transient_table(f);
    for (const char *column :
         {"limit_cycle_frequency_hz", "largest_line_hz", "repetition"})
      check(table.is_missing(0, column), std::string(column) + " is empty");
  }

  void
  changes_of_rms()
  {
    // sqrt((1 + 49)/2) = 5 and sqrt((16 + 184)/2) = 10.
    const std::vector<double> rising  = {1., 7., 4., std::sqrt(184.)},
                              falling = {4., std::sqrt(184.), 1., 7.};
    check(std::abs(change_of_rms(rising) - 5.) < 1e-12 &&
            std::abs(change_of_rms(falling) + 5.) < 1e-12,
          "rms of the last two quarters less that of the first two");
    check(std::abs(share_of_change(rising) - .5) < 1e-12 &&
            std::abs(share_of_change(falling) + .5) < 1e-12 &&
            share_of_change({0., 0., 0., 0.}) == 0.,
          "over the larger one");
  }

  using Type = Table::Type;

  /** A table with columns of numbers or, where the name starts with '$' or '#',
   * of texts or whole numbers. */
  Table
  table_of(const std::vector<std::string>       &names,
           const std::vector<std::vector<Cell>> &rows)
  {
    Table table;
    for (const std::string &name : names)
      table.add_column({name.substr(name[0] == '$' || name[0] == '#' ? 1 : 0),
                        name[0] == '$'   ? Type::text
                        : name[0] == '#' ? Type::integer
                                         : Type::real,
                        "",
                        ""});
    for (const auto &row : rows)
      table.add_row(row);
    return table;
  }

  SweepAxisParameters
  axis(const std::string &name, const std::vector<std::string> &entries)
  {
    SweepAxisParameters a;
    a.name    = name;
    a.entries = entries;
    return a;
  }

  void
  says(const std::string              &text,
       const std::vector<std::string> &parts,
       const std::string              &claim)
  {
    for (const std::string &part : parts)
      check(has(text, part), claim + ": '" + part + "' in: " + text);
  }

  void
  answers()
  {
    SceneParameters scene;
    scene.contacts.resize(1);
    scene.contacts[0].name  = "pad_disc";
    const std::string mu    = "Scene/Contact pad_disc/Friction coefficient",
                      e_pad = "Scene/Body pad/Young modulus";
    SweepParameters sweep;
    sweep.axes = {axis("e", {e_pad}), axis("mu", {mu})};

    says(scatter_headline(table_of({"$event",
                                    "#samples",
                                    "probability",
                                    "lower_95",
                                    "upper_95",
                                    "undecided"},
                                   {{"any", 400, 0.7025, 0.656, 0.745, 0.01},
                                    {"one", 400, 0.3, 0.25, 0.35, 0.}})),
         {"70.2 %", "of 400 samples", "65.6 to 74.5 %", "1.00 %"},
         "scatter says the probability with its interval");

    const std::vector<std::string> suggested = {"frequency_hz",
                                                "sigma_per_s",
                                                "$entry",
                                                "change_percent",
                                                "direct_sigma_per_s",
                                                "$verdict",
                                                "$tunes_in"};
    const std::string              density   = "Scene/Body disc/Density";
    says(suggestion_headline(
           table_of(suggested,
                    {{5024., 80., e_pad, 1., 3., "still unstable", ""},
                     {5024., 80., density, -2.7, -1., "stable", "3533 Hz"}}),
           scene),
         {"-2.70 % of rho_disc", "5024.0 Hz", "tunes in on the way 3533 Hz"},
         "what to change says the first change that holds");
    says(suggestion_headline(
           table_of(suggested,
                    {{5024., 80., e_pad, 1., 3., "still unstable", ""}}),
           scene),
         {"no single change", "5024.0 Hz"},
         "or that there is none");

    const std::vector<std::string> triggered = {
      "mu", "$top", "$outcome", "worst_imbalance"};
    says(trigger_headline(
           table_of(triggered,
                    {{0.5, "", "squeal by itself", 1e-6},
                     {0.3, "", "squeal after the trigger", 3e-5},
                     {0.2, "", "temporary after the trigger", Cell()},
                     {0.1, "", "temporary after the trigger", 1e-7}}),
           sweep,
           scene),
         {"of 4 runs 1 squeals by itself (mu = 0.5)",
          "1 squeals after the trigger alone (mu = 0.3)",
          "2 vibrate for a while after the trigger",
          "3.0e-05"},
         "triggered squeal says which run squeals after what");
    says(trigger_headline(
           table_of(triggered, {{0.1, "", "none", 1e-7}}), sweep, scene),
         {"none of 1 run squeals"},
         "or that none does");

    says(
      comparison_headline(table_of(
        {"rate_difference", "frequency_difference_rel", "growth_rate_ci_per_s"},
        {{0.3, 1e-4, 0.1}, {1.2, 2e-4, 0.2}, {Cell(), Cell(), Cell()}})),
      {"1 of 2 growth rates", "1.2 of that", "0.020 %", "1 run without"},
      "time against eigenvalues says the largest difference");

    says(
      campaign_headline(table_of({"$stable",
                                  "$limit_cycle",
                                  "frequency_hz",
                                  "frequency_ci_hz",
                                  "worst_imbalance"},
                                 {{"no", "yes", 3100., 2., 1e-6},
                                  {"no", "yes", 3400., 7., 1e-6},
                                  {"yes", "no", Cell(), Cell(), 2e-6}})),
      {"2 of 3 runs unstable", "2 with a limit cycle", "3100 to 3400", "7.0"},
      "a campaign says what its runs end in");

    SweepParameters over_speed;
    over_speed.axes = {axis("v", {"Scene/Contact pad_disc/Sliding speed"}),
                       axis("mu", {mu})};
    const Table       friction = table_of({"v", "mu", "macroscopic_friction"},
                                    {{0.1, 0.2, 0.2},
                                           {0.1, 0.6, 0.5},
                                           {0.3, 0.2, 0.2},
                                           {0.3, 0.6, 0.4},
                                           {2., 0.6, 0.55},
                                           {2., 0.7, Cell()}});
    const std::string seen     = friction_headline(friction, over_speed, scene);
    says(seen,
         {rounded_text(0.2, 3) + " throughout",
          rounded_text(0.4, 3) + " (at 0.3 m/s) to " + rounded_text(0.55, 3) +
            " (at 2 m/s)"},
         "one over the speed says the friction that is seen from outside");
    check(!has(seen, "0.7"), "and nothing where none is known: " + seen);
    check(friction_headline(table_of({"v", "mu", "macroscopic_friction"}, {}),
                            over_speed,
                            scene)
            .empty(),
          "nor of no runs");
    says(least_friction_text(
           table_of({"speed_m_per_s", "macroscopic_friction"},
                    {{0.1, 0.3}, {0.2, 0.1}, {0.3, Cell()}, {0.4, 0.2}})),
         {rounded_text(0.1, 3) + ", at " + rounded_text(0.2, 3) + " m/s"},
         "a run whose speed rises says where friction is least");

    says(work_headline(table_of(
           {"$ladder",
            "error_rel",
            "dofs",
            "dofs_over_least",
            "seconds",
            "$found"},
           {{"uniform", 1e-3, 3e5, 6.5, 70., "beyond"},
            {"adaptive", 1e-3, 47600., 1., 12., "between"},
            {"degree", 1e-3, Cell(), Cell(), Cell(), "-"},
            {"basis", 1e-3, Cell(), Cell(), Cell(), "by every rung"}})),
         {"0.100 %",
          "47600 unknowns and 12.0 s by the ladder 'adaptive' (between)",
          "6.50 times as many unknowns by 'uniform'",
          "'degree' does not reach it",
          "every rung of 'basis' is within it"},
         "work says what the asked error takes");
    says(work_headline(table_of({"$ladder", "dofs"}, {{"a", Cell()}})),
         {"no ladder"},
         "or that nothing is known");

    says(resonance_headline(table_of({"frequency_hz", "$name", "peak"},
                                     {{1610., "(0,0)", 1e-7},
                                      {1600., "(0,0)", 3e-7},
                                      {5003., "(0,4)", 9e-7},
                                      {2594., "(0,3)", Cell()}}),
                            "m/N"),
         {"resonances: 5003.0 Hz ((0,4), 9.00e-07 m/N), 1600.0 Hz ((0,0), "
          "3.00e-07 m/N); without damping, so that their peaks have no bound: "
          "2594.0 Hz ((0,3))"},
         "responses name each resonance once, the largest first");

    const std::vector<std::string> ranges = {"mu",
                                             "lower",
                                             "upper",
                                             "at_lower_limit",
                                             "at_upper_limit",
                                             "peak_sigma_per_s",
                                             "frequency_at_peak_hz"};
    Table                          table;
    for (const std::string &name : ranges)
      table.add_column(
        {name, has(name, "limit") ? Type::integer : Type::real, "", ""});
    check(range_headline(table, sweep, scene, false) ==
            "stable over the whole range of E_pad",
          "no range is said, too");
    says(range_headline(table, sweep, scene, true),
         {"stable over the whole range of E_pad on this mesh",
          "error of growth rates by the mesh is not estimated"},
         "a sweep does not know what the mesh does to growth rates");
    table.add_row({0.2, 1e10, 2e10, 0, 0, 12., 3500.});
    table.add_row({0.5, 2.5e10, 5e10, 0, 1, 437., 5003.});
    says(range_headline(table, sweep, scene, true),
         {"E_pad from 2.5e+10 to 5e+10 Pa (to the highest tried)",
          "at mu = 0.5:",
          "437 1/s at 5003.0 Hz"},
         "a sweep says the loudest range in words");
  }

  void
  symbols()
  {
    SceneParameters scene;
    scene.contacts.resize(2);
    scene.contacts[0].name  = "lower";
    scene.contacts[1].name  = "upper";
    const std::string lower = "Scene/Contact lower/Friction coefficient",
                      upper = "Scene/Contact upper/Friction coefficient";
    check(axis_title({"Scene/Body pad/Young modulus"}, scene) == "E_pad in Pa",
          "symbol with body and unit");
    check(
      axis_title({"Scene/Body pad/Young modulus", "Scene/Spring a/Stiffness"},
                 scene) == "E_pad and 1 other in Pa",
      "numbers that move together");
    check(axis_title({lower}, scene) == "mu_lower" &&
            axis_title({lower, upper}, scene) == "mu of all contacts",
          "friction of one of two contacts, and of both");
    scene.contacts.resize(1);
    check(axis_title({lower}, scene) == "mu", "and of the only one");
    check(axis_title({"Scene/Body pad/Position[1]"}, scene) ==
            "pad position [1] in m",
          "words where there is no letter");
    check(axis_title({"Transient/Time step"}, scene) == "time step in s",
          "of the analysis itself");
  }

  void
  rates()
  {
    TransientFigures f;
    BranchResult     good, bad;
    good.fit.rate     = 1220.;
    good.fit.rate_ci  = 0.5;
    good.fit.end      = 0.01;
    good.fit.is_valid = true;
    bad               = good;
    bad.frequency     = 6636.7;
    bad.fit.rate      = 861.4;
    bad.fit.rate_ci   = 1082.;
    bad.fit.is_valid  = false;
    f.branches        = {good};
    f.leading         = 0;
    check(left_out_text(f).empty(), "nothing is left out of good fits");
    check(has(growth_text(f), "grows by 1220 +- 0.50 1/s"),
          "a rate is told with its error: " + growth_text(f));
    f.branches.push_back(bad);
    check(has(left_out_text(f), "1 of 2 pairs") &&
            has(left_out_text(f), "6636.7 Hz"),
          "what is left out is named: " + left_out_text(f));
    f.leading = 1;
    check(growth_text(f).empty(), "a fit that tells no rate is none");
    check(has(reason_for_no_rate(f), "861.4 +- 1082 1/s"),
          "and why the leading pair has no rate: " + reason_for_no_rate(f));
    f.branches[1].fit = GrowthFit();
    check(has(reason_for_no_rate(f), "no linear phase"),
          "which is another reason than that it has no linear phase");
  }
} // namespace



int
main()
{
  errors();
  signs();
  signs_of_many();
  verdicts();
  growth_beyond_samples();
  changes_of_rms();
  answers();
  symbols();
  rates();
}
