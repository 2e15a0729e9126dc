// SPDX-License-Identifier: LGPL-2.1-or-later

// The last samples of a transient as an animation for ParaView.

#include <squeal/analyses/transient/motion_output.h>

#include <squeal/base/files.h>
#include <squeal/output/contact_output.h>
#include <squeal/results/motion_writer.h>

#include <algorithm>
#include <ostream>

namespace squeal
{
  namespace
  {
    /** Components @p n of node fields at a sample, padded by zeros to three
     * where there are two: VTK draws arrows of three. */
    std::vector<double>
    at_sample(const std::vector<double> &all,
              const std::size_t          sample,
              const std::size_t          n_nodes,
              const unsigned int         n)
    {
      std::vector<double> result;
      for (std::size_t j = 0; j < n_nodes; ++j)
        {
          for (unsigned int c = 0; c < n; ++c)
            result.push_back(all[n * (n_nodes * sample + j) + c]);
          if (n == 2)
            result.push_back(0.);
        }
      return result;
    }

    /** Fields of the contact nodes: names and units of contact.vtu. */
    void
    write_contact_frames(RunContext            &context,
                         const ContactGeometry &geometry,
                         const HistorySamples  &h)
    {
      const ContactMap                            map = contact_map(geometry);
      const std::size_t                           n   = geometry.points.size();
      std::vector<std::pair<double, std::string>> steps;
      for (std::size_t k = 0; k < h.n_samples(); ++k)
        {
          const std::string file = frame_file("contact", k);
          map.write_vtu(context.output.file(file),
                        {{"pressure", at_sample(h.pressure, k, n, 1)},
                         {"traction", at_sample(h.traction, k, n, 2)},
                         {"slip_rate", at_sample(h.slip_rate, k, n, 2)},
                         {"gap", at_sample(h.gap, k, n, 1)},
                         {"status", at_sample(h.status, k, n, 1)},
                         {"area", geometry.areas}});
          steps.emplace_back(h.time[k], file);
        }
      write_atomically(
        context.output.file("contact.pvd"),
        [&](std::ostream &out) { out << vtk::collection(steps); });
    }
  } // namespace



  Block
  motion_of_frames(const PreparedTransient &prepared,
                   const TransientRecord   &record,
                   const Parameters        &parameters)
  {
    const auto         &frames  = record.frames;
    const Eigen::Index  n       = frames.size();
    const PressedModel &pressed = prepared.pressed;
    if (n > 0 && frames.front().unknowns.size() > 0)
      {
        Block u(frames.front().unknowns.size(), n);
        for (Eigen::Index k = 0; k < n; ++k)
          u.col(k) = frames[k].unknowns;
        return pressed.expand(u);
      }
    const FullContactModel full  = pressed.full_model(prepared.steady);
    const TransientDrive   drive = make_drive(pressed, parameters);
    Eigen::MatrixXd        q(pressed.model().n_modes(), n),
      lambda(3 * pressed.model().n_nodes(), n);
    Block loads = Block::Zero(full.load.size(), n);
    for (Eigen::Index k = 0; k < n; ++k)
      {
        const double time = frames[k].time;
        q.col(k)          = frames[k].coordinates;
        lambda.col(k)     = frames[k].forces;
        loads.col(k)      = drive.load(time) * full.load;
        for (const auto &force : drive.forces)
          loads.col(k) += force.factor(time) * force.force.nodal;
      }
    return pressed.expand(static_motions(
      full, q, loads - full.relative_motion->apply_transposed(lambda)));
  }



  std::string
  write_animation(RunContext              &context,
                  const Model             &model,
                  const PreparedTransient &prepared,
                  const TransientRecord   &record)
  {
    if (record.frames.empty())
      return "";
    Timers::Section section(context.timers, "Write: animation");
    const auto     &p = context.parameters;
    const Block     u = motion_of_frames(prepared, record, p);
    // What steady sliding and loads do is large beside the vibration: the
    // largest deviation is drawn as large as that of a shape.
    const WrittenMotion written =
      write_motion(*model.discretization(),
                   context.output,
                   "motion",
                   record.frame_nodes.time,
                   u,
                   std::min(2u, model.discretization()->degree()),
                   p.output.slip_display_scale);
    if (context.is_root)
      write_contact_frames(
        context, prepared.pressed.geometry(), record.frame_nodes);
    context.record.figures.emplace_back(
      "animation",
      std::to_string(record.frames.size()) + " frames; deviation of at most " +
        rounded_text(written.largest_deviation, 3) +
        " m, to be warped by a factor of " +
        rounded_text(written.display_factor, 2));
    return "motion.pvd";
  }
} // namespace squeal
