// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/parameters/schema.h>
#include <squeal/tribology/setup/feature_columns.h>
#include <squeal/tribology/setup/unused_entries.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace squeal::tribology
{
  using prm::Allowed;

  namespace
  {
    const char *const correlation_section = "Correlation";

    /** Whether nothing that is measured varies in a table, as on a pad without
     * any crack: features that are not asked for tell pads apart, too. */
    bool
    are_features_constant(const std::string           &file,
                          const CorrelationParameters &c)
    {
      const Table           table    = read_csv(file);
      CorrelationParameters measured = c;
      measured.features.clear();
      for (const std::string &name : feature_columns(table, measured))
        {
          std::set<std::string> values;
          for (std::size_t row = 0; row < table.n_rows(); ++row)
            if (!table.is_missing(row, name))
              values.insert(table.text(row, name));
          if (values.size() > 1)
            return false;
        }
      return true;
    }



    /** Whether two files are one, or alike to the last byte where what is
     * measured varies: two pads without cracks look alike. */
    bool
    are_one_table(const std::string           &a,
                  const std::string           &b,
                  const CorrelationParameters &c)
    {
      namespace fs = std::filesystem;
      std::error_code none;
      if (!fs::is_regular_file(a, none) || !fs::is_regular_file(b, none))
        return a == b;
      if (fs::equivalent(a, b, none))
        return true;
      if (fs::file_size(a, none) != fs::file_size(b, none))
        return false;
      using Bytes = std::istreambuf_iterator<char>;
      std::ifstream first(a, std::ios::binary), second(b, std::ios::binary);
      return std::equal(Bytes(first), Bytes(), Bytes(second)) &&
             !are_features_constant(a, c);
    }



    /** A pad is one sample, however often its table is named. */
    void
    require_other_pads(const CorrelationParameters &c)
    {
      const std::vector<std::string> &tables = c.feature_tables;
      for (std::size_t i = 0; i < tables.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          if (are_one_table(tables[i], tables[j], c))
            prm::refuse_entry(
              correlation_section,
              "Feature tables",
              "names the same pad twice: '" + tables[j] + "' and '" +
                tables[i] +
                "' hold the same; a pad counts as one sample, so name each "
                "once");
    }



    void
    refuse_entries_of_test(const CorrelationParameters &c)
    {
      const CorrelationParameters otherwise;
      const std::string           without_test =
        "without 'Self test = true': set that or remove it";
      refuse_without_effect(correlation_section,
                            "Test pairs",
                            c.n_test_pairs != otherwise.n_test_pairs,
                            c.self_test,
                            without_test);
      refuse_without_effect(correlation_section,
                            "Test lengths",
                            c.test_lengths != otherwise.test_lengths,
                            c.self_test,
                            without_test);
      refuse_without_effect(correlation_section,
                            "Test patterns",
                            c.test_patterns != otherwise.test_patterns,
                            c.self_test,
                            without_test);
    }
  } // namespace



  void
  declare_correlation(prm::Schema &schema, CorrelationParameters &c)
  {
    schema.enter_section(correlation_section,
                         "Damage maps against maps of features, cell by cell.");
    schema.add("Damage tables",
               c.damage_tables,
               Allowed::list(Allowed::file()),
               "Tables damage.csv, one for each pad, whose cells form a "
               "rectangular grid; doc/theory/correlation.md (Limits) says what "
               "to do with sectors of a ring and round pads.");
    schema.add("Feature tables",
               c.feature_tables,
               Allowed::list(Allowed::file()),
               "Tables of features on the same cells (columns x_m and y_m), "
               "one for each pad in the same order.");
    schema.add("Indices",
               c.indices,
               Allowed::list(Allowed::text()),
               "Columns of the damage tables; empty: all indices.");
    schema.add("Features",
               c.features,
               Allowed::list(Allowed::text()),
               "Columns of the feature tables; empty: all features.");
    schema.add("Groups",
               c.groups,
               Allowed::list(Allowed::one_of({"silent", "squealing"})),
               "Which group each pad belongs to; empty: all squealed.");
    schema.add("Runs",
               c.runs,
               Allowed::list(Allowed::file()),
               "Output directories of the runs that led to the tables, in "
               "their order; report.html then tells the whole study.");
    schema.add(
      "Level", c.level, Allowed::number(1e-4, 0.5), "Level of significance.");
    schema.add("Surrogates",
               c.n_surrogates,
               Allowed::integer(99, 1000000),
               "Phase-randomised maps behind each p-value, at least; more are "
               "drawn where many links are tested, so that the corrected level "
               "can be reached.");
    schema.add(
      "Bootstraps",
      c.n_bootstraps,
      Allowed::integer(0, 1000000),
      "Resamplings behind each bootstrap interval, of what cells have "
      "of their own once causes and neighbours are taken out, at least "
      "20; 0: no such interval.");
    schema.add(
      "Shared causes",
      c.shared_causes,
      Allowed::list(prm::Schema::allowed_choices(SharedCause::position)),
      "What is taken out of both maps before the test that decides: "
      "place along and across the sliding direction, distance to the "
      "rim, nearness to the edges. Empty: nothing, and maps that both "
      "concentrate at a rim look linked.");
    schema.add("Leading edge",
               c.leading_edge,
               "Where the disc enters under the pad. 'automatic': the edge "
               "that the sliding direction of each damage table tells, and the "
               "lowest y for a table without one. An edge that contradicts a "
               "table is refused.");
    schema.add("Covariates",
               c.covariates,
               Allowed::list(Allowed::text()),
               "Columns of the damage or feature tables that are taken out of "
               "both maps as well: mean pressure, plateaus, place of the "
               "stage, anything measured. They are no longer indices or "
               "features. Of a name that both tables have both columns are "
               "taken out.");
    schema.add(
      "Least coverage",
      c.least_coverage,
      Allowed::number(0., 1.),
      "Part of a cell that images must show for it to count in links: "
      "densities of cells of which next to nothing was seen are noise. "
      "0: all cells.");
    schema.add(
      "Seed", c.seed, Allowed::integer(0), "Start of the random numbers.");
    schema.add("Wanted power",
               c.wanted_power,
               Allowed::number(0.1, 0.9999),
               "Below this power a link that is not found is undecided.");
    schema.add("Relevant link",
               c.relevant_link,
               Allowed::number(0.01, 0.99),
               "Smallest correlation that is worth finding: the power is that "
               "of finding it.");
    schema.add("Synthetic",
               c.is_synthetic,
               "The images were made by the generator: every verdict says so. "
               "It does so as well where a column 'synthetic' of a table of "
               "features says it.");
    schema.add("Self test",
               c.self_test,
               "Test the test: rate of false positives on pairs of independent "
               "maps, and power against the strength of a link.");
    schema.add("Test pairs",
               c.n_test_pairs,
               Allowed::integer(100, 1000000),
               "Pairs of maps in the self test at each length.");
    schema.add("Test lengths",
               c.test_lengths,
               Allowed::list(Allowed::number(0., 100.)),
               "Correlation lengths of these maps.",
               "nodes");
    schema.add(
      "Test patterns",
      c.test_patterns,
      Allowed::list(prm::Schema::allowed_choices(SharedPattern::none), 1),
      "What both maps share without a link. Streaks share nothing: they are "
      "bands, four times the length along the sliding direction and a quarter "
      "of it across.");
    schema.leave_section();
  }



  void
  check_correlation(const CorrelationParameters &c)
  {
    const std::string section = correlation_section;
    if (c.damage_tables.empty() && !c.self_test)
      prm::refuse_entry(section,
                        "Damage tables",
                        "is empty: name tables, or set 'Self test = true'");
    if (c.damage_tables.size() != c.feature_tables.size())
      prm::refuse_entry(section,
                        "Feature tables",
                        "has not one table for each of 'Damage tables'");
    require_other_pads(c);
    refuse_entries_of_test(c);
    for (const std::string &name : c.covariates)
      for (const auto *list : {&c.indices, &c.features})
        if (std::find(list->begin(), list->end(), name) != list->end())
          prm::refuse_entry(section,
                            "Covariates",
                            "names '" + name +
                              "', which is among 'Indices' or 'Features': "
                              "remove it from one of them");
    if (c.n_bootstraps > 0 && c.n_bootstraps < c.least_bootstraps)
      prm::refuse_entry(section,
                        "Bootstraps",
                        "is " + std::to_string(c.n_bootstraps) +
                          ", from which no interval can be made: 0 or at "
                          "least " +
                          std::to_string(c.least_bootstraps));
    if (!c.groups.empty() && c.groups.size() != c.damage_tables.size())
      prm::refuse_entry(
        section, "Groups", "has not one group for each of 'Damage tables'");
  }
} // namespace squeal::tribology
