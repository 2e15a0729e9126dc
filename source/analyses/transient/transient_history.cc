// SPDX-License-Identifier: LGPL-2.1-or-later

// The history file of a transient.

#include <squeal/analyses/transient/transient_results.h>

namespace squeal
{
  namespace
  {
    /** @p probe: what the motions of its source are called. */
    HistoryLayout
    history_layout(const ContactPair &pair,
                   const std::string &name,
                   const std::string &probe)
    {
      const FaceAxes axes(pair.geometry);
      HistoryLayout  layout;
      layout.name = name;
      layout.pair = pair.name();
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int k = 0; k < 3; ++k)
          layout.axes[c][k] = axes.directions()[c][k];
      for (const auto &x : pair.geometry.points)
        layout.points.push_back(axes.place(x));
      layout.areas = pair.geometry.areas;
      layout.quads = pair.geometry.quads;
      for (const char *axis : {"x", "y", "z"})
        layout.probe_names.push_back(probe + "_a" + axis + "_m_per_s2");
      layout.energy_names = {"kinetic_j",
                             "elastic_j",
                             "damping_j",
                             "friction_j",
                             "driving_j",
                             "load_j",
                             "numerical_j"};
      return layout;
    }

    /** Those of the nodes of one pair, numbered within it. */
    std::vector<StatusChange>
    changes_of(const ContactPair &pair, const std::vector<StatusChange> &all)
    {
      std::vector<StatusChange> result;
      for (StatusChange change : all)
        if (change.node >= pair.first &&
            change.node < pair.first + pair.n_nodes())
          {
            change.node -= pair.first;
            result.push_back(change);
          }
      return result;
    }
  } // namespace



  void
  write_contact_history(const PreparedTransient &prepared,
                        const TransientRecord   &record,
                        const std::string       &name,
                        const std::string       &path)
  {
    const auto                &pairs = prepared.pressed.nodes().pairs();
    std::vector<HistoryLayout> layouts;
    for (const ContactPair &pair : pairs)
      layouts.push_back(
        history_layout(pair, name, pairs.size() == 1 ? "pad" : pair.name()));
    HistoryWriter writer(path, layouts);
    for (std::size_t i = 0; i < pairs.size(); ++i)
      {
        writer.append(record.histories[i], i);
        writer.append(changes_of(pairs[i], record.changes), i);
      }
    writer.finish();
  }
} // namespace squeal
