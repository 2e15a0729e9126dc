// SPDX-License-Identifier: LGPL-2.1-or-later

// The history file of a transient.

#include <squeal/analyses/transient/transient_results.h>

namespace squeal
{
  namespace
  {
    /** Of a pair: the acceleration of its source. */
    constexpr std::size_t n_probes = 3;

    const std::vector<std::string> energy_names = {"kinetic_j",
                                                   "elastic_j",
                                                   "damping_j",
                                                   "friction_j",
                                                   "driving_j",
                                                   "load_j",
                                                   "numerical_j"};

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
      layout.sliding = axes.sliding();
      for (const auto &x : pair.geometry.points)
        layout.points.push_back(axes.place(x));
      layout.areas = pair.geometry.areas;
      layout.quads = pair.geometry.quads;
      for (const char *axis : {"x", "y", "z"})
        layout.probe_names.push_back(probe + "_a" + axis + "_m_per_s2");
      layout.energy_names = energy_names;
      return layout;
    }

  } // namespace



  std::unique_ptr<HistoryStream>
  make_history_stream(const ContactNodes &nodes, const std::string &checkpoint)
  {
    std::vector<std::size_t> n_nodes;
    for (const ContactPair &pair : nodes.pairs())
      n_nodes.push_back(pair.n_nodes());
    return std::make_unique<HistoryStream>(
      checkpoint, n_nodes, n_probes, energy_names.size());
  }



  void
  write_contact_history(const PreparedTransient &prepared,
                        const HistoryStream     &history,
                        const std::string       &name,
                        const std::string       &path)
  {
    const auto                &pairs = prepared.pressed.nodes().pairs();
    std::vector<HistoryLayout> layouts;
    for (const ContactPair &pair : pairs)
      layouts.push_back(
        history_layout(pair, name, pairs.size() == 1 ? "pad" : pair.name()));
    HistoryWriter writer(path, layouts);
    history.write(writer);
    writer.finish();
  }
} // namespace squeal
