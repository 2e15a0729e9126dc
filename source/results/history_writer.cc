// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/sealed_file.h>
#include <squeal/results/contact_history.h>

#include <deal.II/base/exceptions.h>

namespace squeal
{
  namespace
  {
    using Kind = Hdf5File::Kind;

    /** Samples stored together: some 100 kB for a hundred nodes. */
    constexpr std::uint64_t n_chunk = 256;
  } // namespace



  void
  HistorySamples::clear()
  {
    for (std::vector<double> *values : {&time,
                                        &pressure,
                                        &traction,
                                        &slip_rate,
                                        &gap,
                                        &status,
                                        &resultants,
                                        &probes,
                                        &energies})
      values->clear();
  }



  HistoryWriter::HistoryWriter(const std::string &path, const HistoryLayout &l)
    : layout(l)
    , target(path)
    , file(std::make_unique<Hdf5File>(target.temporary(),
                                      Hdf5File::Mode::create_sealed))
  {
    const std::uint64_t n = layout.n_nodes();
    AssertDimension(layout.areas.size(), n);
    file->write_attribute("format", "squeal contact history");
    file->write_attribute("format_version", double(format_version));
    file->write_attribute("name", layout.name);
    std::vector<double> points;
    for (const auto &point : layout.points)
      points.insert(points.end(), point.begin(), point.end());
    file->write("nodes/coordinates", {n, 3}, points);
    file->write("nodes/area", {n}, layout.areas);
    file->create_growing("samples/time", {}, Kind::real64, 4096);
    file->create_growing("samples/pressure", {n}, Kind::real32, n_chunk);
    file->create_growing("samples/traction", {n, 2}, Kind::real32, n_chunk);
    if (layout.has_slip_rate)
      file->create_growing("samples/slip_rate", {n, 2}, Kind::real32, n_chunk);
    if (layout.has_gap)
      file->create_growing("samples/gap", {n}, Kind::real32, n_chunk);
    if (layout.has_status)
      file->create_growing("samples/status", {n}, Kind::integer8, n_chunk);
    if (layout.has_resultants)
      file->create_growing("samples/resultants", {3}, Kind::real64, 4096);
    if (!layout.probe_names.empty())
      {
        file->write("probes/names", layout.probe_names);
        file->create_growing(
          "probes/values", {layout.probe_names.size()}, Kind::real64, 4096);
      }
    if (!layout.energy_names.empty())
      {
        file->write("energies/names", layout.energy_names);
        file->create_growing(
          "energies/values", {layout.energy_names.size()}, Kind::real64, 4096);
      }
    file->create_growing("status_changes/time", {}, Kind::real64, 4096);
    file->create_growing("status_changes/node", {}, Kind::integer32, 4096);
    file->create_growing("status_changes/status", {}, Kind::integer8, 4096);
  }



  void
  HistoryWriter::append(const HistorySamples &s)
  {
    const auto add = [&](const std::string         &name,
                         const std::vector<double> &values,
                         const std::size_t          row,
                         const bool                 is_there) {
      AssertThrow(
        values.size() == (is_there ? row * s.n_samples() : 0),
        dealii::ExcDimensionMismatch(values.size(), row * s.n_samples()));
      if (is_there)
        file->append(name, values);
    };
    const std::size_t n = layout.n_nodes();
    add("samples/time", s.time, 1, true);
    add("samples/pressure", s.pressure, n, true);
    add("samples/traction", s.traction, 2 * n, true);
    add("samples/slip_rate", s.slip_rate, 2 * n, layout.has_slip_rate);
    add("samples/gap", s.gap, n, layout.has_gap);
    add("samples/status", s.status, n, layout.has_status);
    add("samples/resultants", s.resultants, 3, layout.has_resultants);
    add("probes/values",
        s.probes,
        layout.probe_names.size(),
        !layout.probe_names.empty());
    add("energies/values",
        s.energies,
        layout.energy_names.size(),
        !layout.energy_names.empty());
  }



  void
  HistoryWriter::append(const std::vector<StatusChange> &changes)
  {
    std::vector<double> times, nodes, states;
    for (const StatusChange &change : changes)
      {
        times.push_back(change.time);
        nodes.push_back(static_cast<double>(change.node));
        states.push_back(static_cast<double>(change.status));
      }
    file->append("status_changes/time", times);
    file->append("status_changes/node", nodes);
    file->append("status_changes/status", states);
  }



  void
  HistoryWriter::finish()
  {
    file->write_attribute("complete", 1.);
    file->close();
    file.reset();
    seal_file(target.temporary(), sealed_kind);
    target.commit();
  }
} // namespace squeal
