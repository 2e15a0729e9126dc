// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/parameters/schema.h>
#include <squeal/tribology/setup/damage_parameters.h>
#include <squeal/tribology/setup/unused_entries.h>

#include <tuple>

namespace squeal::tribology
{
  using prm::Allowed;



  namespace
  {
    /** What only the generator or only the table takes. */
    void
    refuse_other_source(const RecordedHistoryParameters &r)
    {
      const RecordedHistoryParameters otherwise;
      const bool                      is_made =
        r.source == RecordedHistoryParameters::Source::clipped_sine;
      const auto refuse =
        [&](const std::string &entry, const bool is_set, const bool is_used) {
          refuse_without_effect("Recorded history",
                                entry,
                                is_set,
                                is_used,
                                std::string("with 'Source = ") +
                                  (is_made
                                     ? "clipped sine', which makes all samples"
                                     : "csv', whose tables tell it") +
                                  ": change that or remove it");
        };
      refuse("Samples", !r.samples.empty(), !is_made);
      refuse("Nodes", !r.nodes.empty(), !is_made);
      refuse("Run", r.run != otherwise.run, is_made);
      for (const auto &[entry, value, other] :
           {std::tuple("Duration", r.duration, otherwise.duration),
            std::tuple("Rate", r.rate, otherwise.rate),
            std::tuple("Frequency", r.frequency, otherwise.frequency),
            std::tuple("Mean pressure", r.pressure, otherwise.pressure),
            std::tuple("Leading edge factor", r.leading, otherwise.leading),
            std::tuple("Slip speed", r.slip_speed, otherwise.slip_speed),
            std::tuple("Friction coefficient", r.friction, otherwise.friction),
            std::tuple("Noise", r.noise, otherwise.noise),
            std::tuple("Pad length", r.pad_length, otherwise.pad_length),
            std::tuple(
              "Nodes per edge", double(r.n_nodes), double(otherwise.n_nodes)),
            std::tuple("Seed", double(r.seed), double(otherwise.seed))})
        refuse(entry, value != other, is_made);
    }
  } // namespace



  void
  declare_history(prm::Schema &schema, HistoryParameters &h)
  {
    schema.enter_section("History",
                         "Contact histories (HDF5, doc/history_format.md).");
    schema.add("File",
               h.file,
               Allowed::file(),
               "History of the run whose damage is computed.");
    schema.add("Silent file",
               h.silent_file,
               Allowed::file(),
               "History of a run without squeal that it is compared with; "
               "empty: none.");
    schema.add("Contact pair",
               h.pair,
               Allowed::text(),
               "The pair of a history with several whose damage is computed; "
               "empty: all of them, one after the other.");
    schema.add("Start time",
               h.start_time,
               Allowed::number(),
               "Samples before are left out; by default none.",
               "s");
    schema.add("End time",
               h.end_time,
               Allowed::number(),
               "Samples after are left out; by default none.",
               "s");
    schema.add("Chunk",
               h.chunk,
               Allowed::integer(1, 1 << 24),
               "Samples that are in memory at a time; changes no digit of the "
               "result.",
               "samples");
    schema.leave_section();
  }



  void
  declare_recorded_history(prm::Schema &schema, RecordedHistoryParameters &r)
  {
    schema.enter_section("Recorded history",
                         "A history file from a generator or a table.");
    schema.add("Source",
               r.source,
               "A generator (p = max(0, mean + amplitude sin) at each node, "
               "with the published pressure factors), or a CSV of samples.");
    schema.add("Run",
               r.run,
               "What the generator makes: a squealing run, or the same pad "
               "with steady pressure.");
    schema.add("File",
               r.file,
               Allowed::text(),
               "Name of the history file in the output directory.");
    schema.add("Samples",
               r.samples,
               Allowed::file(),
               "CSV with the columns time_s, node, pressure_pa, "
               "traction_x_pa, traction_y_pa and, if known, "
               "slip_rate_x_m_per_s, slip_rate_y_m_per_s, gap_m, status; rows "
               "in order of time, at each time one row for each node.");
    schema.add("Nodes",
               r.nodes,
               Allowed::file(),
               "CSV with the columns node, x_m, y_m, area_m2.");
    schema.add("Duration",
               r.duration,
               Allowed::positive(),
               "Length of the generated history.",
               "s");
    schema.add(
      "Rate", r.rate, Allowed::positive(), "Samples per second.", "1/s");
    schema.add("Frequency",
               r.frequency,
               Allowed::positive(),
               "Squeal frequency of the generator.",
               "Hz");
    schema.add("Mean pressure",
               r.pressure,
               Allowed::positive(),
               "Time and face mean of the pressure.",
               "Pa");
    schema.add("Leading edge factor",
               r.leading,
               Allowed::positive(),
               "Largest pressure at the leading edge over the mean of the pad "
               "while it squeals.");
    schema.add("Slip speed",
               r.slip_speed,
               Allowed::number(0.),
               "Speed of the disc under the pad, along +y.",
               "m/s");
    schema.add("Friction coefficient",
               r.friction,
               Allowed::number(0., 10.),
               "Traction over pressure where the contact slips.");
    schema.add("Noise",
               r.noise,
               Allowed::number(0., 1.),
               "Slow random modulation of the amplitude, rms, relative.");
    schema.add("Pad length",
               r.pad_length,
               Allowed::positive(),
               "Edge of the square pad face.",
               "m");
    schema.add("Nodes per edge",
               r.n_nodes,
               Allowed::integer(2, 1000),
               "Contact nodes along each edge of the face.");
    schema.add(
      "Seed", r.seed, Allowed::integer(0), "Start of the random numbers.");
    schema.leave_section();
  }



  void
  check_history(const HistoryParameters &h)
  {
    if (h.file.empty())
      prm::refuse_entry("History", "File", "is empty: name a history");
    if (h.end_time <= h.start_time)
      prm::refuse_entry("History", "End time", "is not after 'Start time'");
  }



  void
  check_recorded_history(const RecordedHistoryParameters &r)
  {
    const std::string section = "Recorded history";
    if (r.file.empty() || r.file.find('/') != std::string::npos)
      prm::refuse_entry(
        section, "File", "is not a name within the output directory");
    if (r.source == RecordedHistoryParameters::Source::csv)
      {
        if (r.samples.empty() || r.nodes.empty())
          prm::refuse_entry(section,
                            r.samples.empty() ? "Samples" : "Nodes",
                            "is empty: name a table");
      }
    else
      {
        if (r.rate < 4. * r.frequency)
          prm::refuse_entry(
            section, "Rate", "is below four samples a period of 'Frequency'");
        if (r.duration * r.rate > 1e9)
          prm::refuse_entry(
            section, "Duration", "gives more than 1e9 samples at 'Rate'");
      }
    refuse_other_source(r);
  }
} // namespace squeal::tribology
