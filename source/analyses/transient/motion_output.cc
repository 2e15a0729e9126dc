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
    /** Numbers of nodes at a sample. */
    std::vector<double>
    numbers_at(const std::vector<double> &all,
               const std::size_t          sample,
               const std::size_t          n_nodes)
    {
      return {all.begin() + n_nodes * sample,
              all.begin() + n_nodes * (sample + 1)};
    }

    /** Vectors of nodes at a sample, which have two components in the face, as
     * x, y and z. */
    std::vector<double>
    vectors_at(const std::vector<double> &all,
               const std::size_t          sample,
               const std::size_t          n_nodes,
               const FaceAxes            &axes)
    {
      const auto         &d = axes.directions();
      std::vector<double> result;
      for (std::size_t j = n_nodes * sample; j < n_nodes * (sample + 1); ++j)
        for (unsigned int c = 0; c < 3; ++c)
          result.push_back(d[0][c] * all[2 * j] + d[1][c] * all[2 * j + 1]);
      return result;
    }

    /** Fields of the contact nodes of a pair: names and units of
     * contact.vtu. */
    void
    write_contact_frames(RunContext            &context,
                         const std::string     &name,
                         const ContactGeometry &geometry,
                         const HistorySamples  &h)
    {
      const ContactMap                            map = contact_map(geometry);
      const FaceAxes                              axes(geometry);
      const std::size_t                           n = geometry.points.size();
      std::vector<std::pair<double, std::string>> steps;
      for (std::size_t k = 0; k < h.n_samples(); ++k)
        {
          const std::string file = frame_file(name, k);
          map.write_vtu(context.output.file(file),
                        {{"pressure", numbers_at(h.pressure, k, n)},
                         {"traction", vectors_at(h.traction, k, n, axes)},
                         {"slip_rate", vectors_at(h.slip_rate, k, n, axes)},
                         {"gap", numbers_at(h.gap, k, n)},
                         {"status", numbers_at(h.status, k, n)},
                         {"area", geometry.areas}});
          steps.emplace_back(h.time[k], file);
        }
      write_atomically(
        context.output.file(name + ".pvd"),
        [&](std::ostream &out) { out << vtk::collection(steps); });
    }
  } // namespace



  namespace
  {
    /** The bodies whose meshes turn, and how far they have at @p times. The
     * speed of the drive is linear in time. */
    std::vector<TurnedBody>
    turned_bodies(const PreparedTransient   &prepared,
                  const Parameters          &p,
                  const std::vector<double> &times)
    {
      std::vector<TurnedBody> result;
      if (p.transient.disc_frame != TransientParameters::DiscFrame::corotating)
        return result;
      const TransientDrive   drive = make_drive(prepared.pressed, p);
      const FullContactModel full =
        prepared.pressed.full_model(prepared.steady);
      for (const auto &[name, rate] : full.turning->rates())
        for (unsigned int b = 0; b < p.scene.bodies.size(); ++b)
          if (p.scene.bodies[b].name == name)
            {
              const auto axis = p.scene.bodies[b].centre_of_rotation();
              TurnedBody body{b, axis[0], axis[1], {}};
              for (const double time : times)
                body.angles.push_back(rate * time * drive.speed(0.5 * time));
              result.push_back(body);
            }
      return result;
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
                  const TransientRecord   &record,
                  const Block             &u)
  {
    if (record.frames.empty())
      return "";
    Timers::Section     section(context.timers, "Write: animation");
    const auto         &p = context.parameters;
    std::vector<double> times;
    for (const MotionFrame &frame : record.frames)
      times.push_back(frame.time);
    // What steady sliding and loads do is large beside the vibration: the
    // largest deviation is drawn as large as that of a shape.
    const WrittenMotion written =
      write_motion(*model.discretization(),
                   context.output,
                   "motion",
                   times,
                   u,
                   std::min(2u, model.discretization()->degree()),
                   p.output.slip_display_scale,
                   turned_bodies(prepared, p, times));
    const auto &pairs = prepared.pressed.nodes().pairs();
    for (std::size_t i = 0; i < pairs.size() && context.is_root; ++i)
      write_contact_frames(context,
                           pairs.size() == 1 ? "contact"
                                             : "contact_" + pairs[i].name(),
                           pairs[i].geometry,
                           record.frame_nodes[i]);
    context.record.figures.emplace_back(
      "animation",
      std::to_string(record.frames.size()) + " frames; deviation of at most " +
        rounded_text(written.largest_deviation, 3) +
        " m, to be warped by a factor of " +
        rounded_text(written.display_factor, 2));
    return "motion.pvd";
  }
} // namespace squeal
