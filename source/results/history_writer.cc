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



  namespace
  {
    /** The group of a pair: the root where there is but one. */
    std::string
    group_of(const std::vector<HistoryLayout> &layouts, const std::size_t pair)
    {
      return layouts.size() == 1 ? "" : "pairs/" + layouts[pair].pair + "/";
    }
  } // namespace



  HistoryWriter::HistoryWriter(const std::string   &path,
                               const HistoryLayout &layout)
    : HistoryWriter(path, std::vector<HistoryLayout>{layout})
  {
  }



  HistoryWriter::HistoryWriter(const std::string                &path,
                               const std::vector<HistoryLayout> &pairs)
    : layouts(pairs)
    , target(path)
    , file(std::make_unique<Hdf5File>(target.temporary(),
                                      Hdf5File::Mode::create_sealed))
  {
    Assert(!layouts.empty(), dealii::ExcInternalError());
    const HistoryLayout &any = layouts.back();
    file->write_attribute("format", "squeal contact history");
    file->write_attribute(
      "format_version",
      double(layouts.size() == 1 ? format_version : version_of_pairs));
    file->write_attribute("name", any.name);
    if (layouts.size() > 1)
      {
        std::vector<std::string> names;
        for (const HistoryLayout &layout : layouts)
          names.push_back(layout.pair);
        file->write("pair_names", names);
      }
    for (std::size_t i = 0; i < layouts.size(); ++i)
      create(layouts[i], group_of(layouts, i));
    if (!any.energy_names.empty())
      {
        file->write("energies/names", any.energy_names);
        file->create_growing(
          "energies/values", {any.energy_names.size()}, Kind::real64, 4096);
      }
  }



  void
  HistoryWriter::create(const HistoryLayout &layout, const std::string &group)
  {
    const std::uint64_t n = layout.n_nodes();
    AssertDimension(layout.areas.size(), n);
    std::vector<double> points, axes;
    for (const auto &point : layout.points)
      points.insert(points.end(), point.begin(), point.end());
    for (const auto &axis : layout.axes)
      axes.insert(axes.end(), axis.begin(), axis.end());
    file->write(group + "nodes/coordinates", {n, 3}, points);
    file->write(group + "nodes/area", {n}, layout.areas);
    if (layout.axes != HistoryLayout().axes)
      file->write(group + "nodes/axes", {3, 3}, axes);
    if (layout.sliding != HistoryLayout().sliding)
      file->write(
        group + "nodes/sliding", {2}, {layout.sliding[0], layout.sliding[1]});
    if (!layout.quads.empty())
      {
        std::vector<double> corners;
        for (const auto &quad : layout.quads)
          corners.insert(corners.end(), quad.begin(), quad.end());
        file->write(group + "nodes/quads", {layout.quads.size(), 4}, corners);
      }
    const auto grows = [&](const std::string          &name,
                           const Hdf5File::Dimensions &row,
                           const Kind                  kind,
                           const std::uint64_t         n_together) {
      file->create_growing(group + name, row, kind, n_together);
    };
    grows("samples/time", {}, Kind::real64, 4096);
    grows("samples/pressure", {n}, Kind::real32, n_chunk);
    grows("samples/traction", {n, 2}, Kind::real32, n_chunk);
    if (layout.has_slip_rate)
      grows("samples/slip_rate", {n, 2}, Kind::real32, n_chunk);
    if (layout.has_gap)
      grows("samples/gap", {n}, Kind::real32, n_chunk);
    if (layout.has_status)
      grows("samples/status", {n}, Kind::integer8, n_chunk);
    if (layout.has_resultants)
      grows("samples/resultants", {3}, Kind::real64, 4096);
    if (!layout.probe_names.empty())
      {
        file->write(group + "probes/names", layout.probe_names);
        grows("probes/values", {layout.probe_names.size()}, Kind::real64, 4096);
      }
    grows("status_changes/time", {}, Kind::real64, 4096);
    grows("status_changes/node", {}, Kind::integer32, 4096);
    grows("status_changes/status", {}, Kind::integer8, 4096);
  }



  void
  HistoryWriter::append(const HistorySamples &s, const std::size_t pair)
  {
    const HistoryLayout &layout = layouts[pair];
    const auto           add    = [&](const std::string         &name,
                         const std::vector<double> &values,
                         const std::size_t          row,
                         const bool                 is_there) {
      AssertThrow(
        values.size() == (is_there ? row * s.n_samples() : 0),
        dealii::ExcDimensionMismatch(values.size(), row * s.n_samples()));
      if (is_there)
        file->append(name, values);
    };
    const std::string group = group_of(layouts, pair);
    const std::size_t n     = layout.n_nodes();
    add(group + "samples/time", s.time, 1, true);
    add(group + "samples/pressure", s.pressure, n, true);
    add(group + "samples/traction", s.traction, 2 * n, true);
    add(group + "samples/slip_rate", s.slip_rate, 2 * n, layout.has_slip_rate);
    add(group + "samples/gap", s.gap, n, layout.has_gap);
    add(group + "samples/status", s.status, n, layout.has_status);
    add(group + "samples/resultants", s.resultants, 3, layout.has_resultants);
    add(group + "probes/values",
        s.probes,
        layout.probe_names.size(),
        !layout.probe_names.empty());
    // Those of the system, once.
    if (pair == 0)
      add("energies/values",
          s.energies,
          layout.energy_names.size(),
          !layout.energy_names.empty());
  }



  void
  HistoryWriter::append(const std::vector<StatusChange> &changes,
                        const std::size_t                pair)
  {
    std::vector<double> times, nodes, states;
    for (const StatusChange &change : changes)
      {
        times.push_back(change.time);
        nodes.push_back(static_cast<double>(change.node));
        states.push_back(static_cast<double>(change.status));
      }
    const std::string group = group_of(layouts, pair) + "status_changes/";
    file->append(group + "time", times);
    file->append(group + "node", nodes);
    file->append(group + "status", states);
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
