// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/results/table.h>
#include <squeal/tribology/driver/analyses.h>
#include <squeal/tribology/history/clipped_sine.h>
#include <squeal/tribology/history/csv_import.h>
#include <squeal/tribology/history/face_areas.h>

#include <algorithm>

namespace squeal::tribology
{
  namespace
  {
    void
    generate(Context &context, const std::string &path)
    {
      ClippedSineGenerator      generator(context.parameters.recorded_history);
      HistoryWriter             writer(path, generator.layout());
      HistorySamples            samples;
      std::vector<StatusChange> changes;
      const std::uint64_t       n = generator.n_samples();
      Progress                  progress(context.log, "history", n);
      for (std::uint64_t done = 0; done < n;)
        {
          const std::size_t m = std::min<std::uint64_t>(4096, n - done);
          generator.next(m, samples, changes);
          writer.append(samples);
          writer.append(changes);
          done += m;
          progress.advance(m);
        }
      writer.finish();
    }
  } // namespace



  void
  run_recorded_history(Context &context)
  {
    const RecordedHistoryParameters &p = context.parameters.recorded_history;
    if (p.source == RecordedHistoryParameters::Source::csv)
      {
        prm::require_file(p.samples, "Recorded history", "Samples", true);
        prm::require_file(p.nodes, "Recorded history", "Nodes", true);
      }
    const std::string path = context.output.file(p.file);
    {
      Timers::Section section(context.timers, "Write: history");
      if (p.source == RecordedHistoryParameters::Source::csv)
        import_csv_history(p.nodes, p.samples, path);
      else
        generate(context, path);
    }
    const HistoryReader reader(path);
    const std::string   nodes =
      p.source == RecordedHistoryParameters::Source::csv ? p.nodes : path;
    if (const std::string doubt = doubt_of_length(reader.layout(), nodes);
        !doubt.empty())
      context.log.warning(doubt);
    const auto [first, last] = reader.time_range();
    Table table({{"nodes", Table::Type::integer, "", "contact nodes"},
                 {"samples", Table::Type::integer, "", "samples"},
                 {"start_s", Table::Type::real, "s", "first time"},
                 {"end_s", Table::Type::real, "s", "last time"},
                 {"status_changes",
                  Table::Type::integer,
                  "",
                  "recorded times at which a node opened or closed"}});
    table.add_row({reader.layout().n_nodes(),
                   reader.n_samples(),
                   first,
                   last,
                   reader.status_changes().size()});
    context.write_table("history.csv", table);
    context.record.figures = {{"nodes", table.text(0, "nodes")},
                              {"samples", table.text(0, "samples")},
                              {"seconds", rounded_text(last - first, 6)}};
    HtmlReport report("Contact history " + reader.layout().name, p.file);
    report.set_verdict(HtmlReport::Verdict::neutral,
                       table.text(0, "samples") + " samples at " +
                         table.text(0, "nodes") + " nodes",
                       context.record.figures);
    report.paragraph("The file " + p.file +
                     " follows doc/history_format.md; 'Analysis = damage' "
                     "reads it.");
    context.finish(context.parameters.output.report ? &report : nullptr, "");
  }
} // namespace squeal::tribology
