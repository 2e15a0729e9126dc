// SPDX-License-Identifier: LGPL-2.1-or-later

// A wobble that goes round a ring leaves the sum of its normal forces alone: it
// is judged by their moments, in closed form, and a wave by a node, where a pad
// that rocks while its sum vibrates keeps the sum. Friction of a curved face is
// told without the part that pressure has along the mean sliding.

#include "check.h"

#include <squeal/analyses/preload/preload_tables.h>
#include <squeal/analyses/transient/transient_results.h>
#include <squeal/analyses/transient/transient_verdict.h>
#include <squeal/contact/pressure_moments.h>
#include <squeal/transient/slow_part.h>

#include <cmath>
#include <functional>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double       pi      = 3.14159265358979323846;
  constexpr unsigned int n_round = 32, n_steps = 20000, stride = 10;
  constexpr double       total = 1000., mu = .3;

  using Vector = dealii::Tensor<1, 3>;

  Vector
  direction(const double angle)
  {
    return Vector({std::cos(angle), std::sin(angle), 0.});
  }

  double
  angle_of(const unsigned int j, const double all_round = 2. * pi)
  {
    return all_round * (j + .5) / n_round;
  }

  /** Nodes on an arc about the axis z, sliding along it, below a target or
   * inside one. */
  ContactGeometry
  arc(const double all_round, const bool is_flat)
  {
    ContactGeometry g;
    for (unsigned int j = 0; j < n_round; ++j)
      {
        const double angle = angle_of(j, all_round);
        ContactFrame frame;
        frame.normal  = is_flat ? Vector({0., 0., 1.}) : -1. * direction(angle);
        frame.sliding = direction(angle + .5 * pi);
        frame.transverse =
          dealii::cross_product_3d(frame.sliding, frame.normal);
        g.points.emplace_back(
          .2 + .075 * direction(angle)[0], .075 * direction(angle)[1], .01);
        g.areas.push_back(1e-4);
        g.frames.push_back(frame);
        g.speed_ratio.push_back(1.);
      }
    return g;
  }

  ContactNodes
  nodes_of(const ContactGeometry &g)
  {
    ContactParameters contact;
    contact.name                 = "c";
    contact.friction_coefficient = mu;
    return ContactNodes({contact}, {g});
  }

  /** Forces of nodes that slip, @p pressing times the even one at an angle. */
  Eigen::VectorXd
  forces_of(const std::function<double(double)> &pressing)
  {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(3 * n_round);
    for (unsigned int j = 0; j < n_round; ++j)
      {
        forces[3 * j]     = total / n_round * pressing(angle_of(j));
        forces[3 * j + 1] = mu * forces[3 * j];
      }
    return forces;
  }

  void
  moments()
  {
    const ContactGeometry ring  = arc(2. * pi, true),
                          shaft = arc(2. * pi, false);
    check(is_flat(ring) && !is_flat(shaft), "a ring is flat, a bush is not");
    constexpr double at      = .4;
    const auto       towards = [](const double angle) {
      return 1. + .5 * std::cos(angle - at);
    };
    for (const auto &[g, sign, first] :
         {std::make_tuple(&ring, 1., std::string("about x")),
          std::make_tuple(&shaft, -1., std::string("along x"))})
      {
        const PressureMoments m = pressure_moments(*g);
        check(m.names[0].find(first) != std::string::npos, m.names[0]);
        const Eigen::VectorXd even =
          m.rows * forces_of([](double) { return 1.; });
        check(even.norm() < 1e-9 * total, "an even pressure has none");
        const Eigen::VectorXd one_sided = m.rows * forces_of(towards);
        // The mean square of a cosine is 1/2: its root is the width.
        const double size = total * .5 / std::sqrt(2.);
        const bool   arms = sign > 0.; // an arm along y is about x
        check_close(one_sided[arms ? 0 : 1],
                    sign * size * std::sin(at),
                    1e-10,
                    "along y");
        check_close(one_sided[arms ? 1 : 0],
                    sign * size * std::cos(at),
                    1e-10,
                    "along x");
      }
  }

  /** How much a ring is pressed at an angle and a time from 0 to 1. */
  using Pressing = std::function<double(double, double)>;

  TransientRecord
  record_of(const ContactNodes &nodes, const Pressing &pressing)
  {
    const ForceSums sums(nodes);
    TransientRecord record;
    record.stretches.resize(n_force_stretches);
    record.n_steps = n_steps;
    record.watched = WatchedNodes(nodes);
    for (unsigned int k = 0; k < n_steps; ++k)
      {
        const double          t = (k + 1.) / n_steps;
        const Eigen::VectorXd forces =
          forces_of([&](const double angle) { return pressing(angle, t); });
        const StepSums    now = sums.of(forces);
        const std::size_t stretch =
          std::size_t(k) * n_force_stretches / n_steps;
        record.stretches[stretch].add(now, false);
        record.watched.add_step(
          forces, stretch, n_steps - k <= WatchedNodes::most_last_steps);
        record.last_steps.push_back(
          {t, now.normal, now.tangential, now.first_moment, now.second_moment});
        if (k % stride != 0)
          continue;
        record.watched.add_sample(forces);
        TransientSample s;
        s.time = t;
        record.samples.push_back(s);
        PairSample pair;
        pair.normal = pair.pressing = now.normal;
        pair.pulling                = now.tangential;
        pair.first_moment           = now.first_moment;
        pair.second_moment          = now.second_moment;
        record.pairs.push_back(pair);
      }
    return record;
  }

  double
  line_of(const TransientRecord &record, const TransientFigures &f)
  {
    const double interval = double(stride) / n_steps;
    return power_spectrum(without_slow_part(samples_of(record, f.loudest)),
                          interval)
      .peak(5., highest_line(interval));
  }

  constexpr double frequency = 40.;

  /** It goes round, and the sum has a small line of its own. */
  double
  wobble(const double angle, const double t)
  {
    return 1. + .8 * std::cos(angle - 2. * pi * frequency * t) +
           .01 * std::cos(2. * pi * 16. * frequency * t);
  }

  void
  wobbling()
  {
    const ContactNodes    nodes  = nodes_of(arc(2. * pi, true));
    const TransientRecord record = record_of(nodes, wobble);
    TransientFigures      f;
    evaluate_forces(nodes, record, f);
    check(f.loudest.is_by_moment(), "a wobble is judged by a moment");
    check_close(
      f.rms_normal, .4 * total, 1e-4, "the rms of a cosine round the ring");
    check_close(
      f.most_rms_of_sum, .01 * total / std::sqrt(2.), 1e-2, "of the sum");
    check_close(f.mean_normal, total, 1e-6, "the mean force is the sum's");
    check(f.least_rms > .9 * f.most_rms && !nothing_vibrates(f) && !f.is_silent,
          "it vibrates evenly");
    check_close(
      line_of(record, f), frequency, 1e-3, "its line goes round once");
    check(line_beyond_samples(record, f.loudest, 5., 1. / 200.) == 0.,
          "samples of that line tell it");
    check_close(line_beyond_samples(record, f.loudest, 5., 1. / 50.),
                frequency,
                1e-2,
                "and the steps where they do not");
    f.has_limit_cycle      = true;
    const std::string text = limit_cycle_text(f);
    check(text.find("of the moment of the normal forces about") !=
            std::string::npos,
          text);
    check(transient_table(f).text(0, "judged_force") == f.loudest.force_name,
          "the table names it");
    check_close(rms_of_pressure(f.loudest, record, 100, 200),
                f.rms_normal,
                1e-12,
                "of a stretch");
  }

  TransientFigures
  figures_of(const ContactNodes &nodes, const Pressing &pressing)
  {
    TransientFigures f;
    evaluate_forces(nodes, record_of(nodes, pressing), f);
    return f;
  }

  /** A rock that stands is as large about every axis. */
  void
  turned()
  {
    const ContactNodes nodes = nodes_of(arc(2. * pi, true));
    const auto         rock  = [](const double at) {
      return [at](const double angle, const double t) {
        return 1. + .8 * std::cos(2. * pi * frequency * t) *
                      std::cos(angle - at * pi / 180.);
      };
    };
    for (const auto &[at, axis] :
         {std::make_pair(0., "about y"),
          std::make_pair(90., "about x"),
          std::make_pair(45., "about an axis -45 deg from x towards y"),
          std::make_pair(-60., "about an axis 30 deg from x towards y")})
      {
        const TransientRecord record = record_of(nodes, rock(at));
        TransientFigures      f;
        evaluate_forces(nodes, record, f);
        check(f.loudest.force_name ==
                std::string("moment of the normal forces ") + axis,
              f.loudest.force_name);
        check_close(f.rms_normal, .4 * total, 1e-9, "the rms of the rock");
        check_close(f.most_rms, .4 * total, 5e-2, "and of its quarters");
        check_close(rms_of_pressure(f.loudest, record, 100, 200),
                    .4 * total,
                    1e-9,
                    "and of a stretch");
        check_close(line_of(record, f), frequency, 1e-3, "its line");
        double square = 0.;
        for (const double x : samples_of(record, f.loudest))
          square += x * x;
        check_close(std::sqrt(square / record.samples.size()),
                    .4 * total,
                    1e-3,
                    "its samples are of the same axis");
      }
    const TransientFigures round =
      figures_of(nodes, [](const double angle, const double t) {
        return 1. + .8 * std::cos(angle - 2. * pi * 40.13 * t);
      });
    check(round.loudest.force_name == "moment of the normal forces about x",
          "what goes round has no axis: " + round.loudest.force_name);
  }

  /** Two wave lengths round the ring: steady sum and moments. */
  void
  waves()
  {
    const ContactNodes nodes = nodes_of(arc(2. * pi, true));
    const double       even  = total / n_round,
                 // No node is at the largest of a wave that stands.
      nearest = std::cos(2. * angle_of(0));
    for (const double at : {0., .25 * pi})
      for (const bool stands : {false, true})
        {
          const Pressing wave = [&](const double angle, const double t) {
            const double where = 2. * (angle - at),
                         when  = 2. * pi * frequency * t;
            return 1. + .5 * (stands ? std::cos(where) * std::cos(when)
                                     : std::cos(where - when));
          };
          const TransientRecord record = record_of(nodes, wave);
          TransientFigures      f;
          evaluate_forces(nodes, record, f);
          check(f.loudest.force == JudgedForce::node &&
                  f.loudest.force_name.find("normal force of node") == 0,
                f.loudest.force_name);
          check(!f.is_silent && !nothing_vibrates(f), "it vibrates");
          const double rms =
            .5 * even / std::sqrt(2.) * (stands ? nearest : 1.);
          check_close(
            f.rms_normal, rms, 1e-6, "by the rms of its loudest node");
          check(f.least_rms > .9 * f.most_rms && f.most_rms < 1.05 * rms,
                "evenly");
          check_close(line_of(record, f), frequency, 1e-3, "with its line");
          check_close(line_beyond_samples(record, f.loudest, 5., 1. / 50.),
                      frequency,
                      2e-2,
                      "and that of the steps");
          const std::string text = text_of_moment(f);
          check(text.find("both moments are as steady") != std::string::npos,
                text);
          check(transient_table(f).text(0, "judged_force") ==
                  f.loudest.force_name,
                "the table names the node");
        }
  }

  /** Where the sum is a fair judge, and where nothing vibrates. */
  void
  no_waves()
  {
    const ContactNodes     nodes = nodes_of(arc(2. * pi, true));
    const TransientFigures each =
      figures_of(nodes, [](const double angle, const double t) {
        const double own = 20. + 7. * std::fmod(13. * angle, 5.);
        return 1. + .1 * std::cos(2. * pi * own * t + 9. * angle);
      });
    check(each.loudest.force != JudgedForce::node,
          "nodes that vibrate each on its own: " + each.loudest.force_name);
    const TransientFigures wanders =
      figures_of(nodes, [](const double angle, const double t) {
        return 1. + .3 * std::tanh(20. * (t - .7)) * std::cos(2. * angle);
      });
    check(wanders.loudest.force == JudgedForce::normal && wanders.is_silent,
          "pressure that wanders once: " + wanders.loudest.force_name);
  }

  /** A face of 8 x 4 points, 100 x 30 mm, turned by an angle. */
  ContactGeometry
  strip(const double turn)
  {
    ContactGeometry g = arc(2. * pi, true);
    for (unsigned int j = 0; j < n_round; ++j)
      g.points[j] = dealii::Point<3>(
        Vector({.2, 0., .01}) + .1 * (j % 8 / 7. - .5) * direction(turn) +
        .03 * (j / 8 / 3. - .5) * direction(turn + .5 * pi));
    return g;
  }

  void
  turned_strip()
  {
    const Pressing rock = [](const double angle, const double t) {
      const auto j = static_cast<unsigned int>(angle * n_round / (2. * pi));
      return 1. + std::cos(2. * pi * frequency * t) *
                    ((j % 8 - 3.5) / 7. + .4 * (j / 8 - 1.5) / 3.);
    };
    const double along = figures_of(nodes_of(strip(0.)), rock).rms_normal;
    for (const double turn : {.25 * pi, .5 * pi, 2.})
      check_close(figures_of(nodes_of(strip(turn)), rock).rms_normal,
                  along,
                  1e-9,
                  "the moment of a long face turns with it");
  }

  void
  growing()
  {
    const ContactNodes    nodes  = nodes_of(arc(2. * pi, true));
    const TransientRecord record = record_of(nodes, [](double angle, double t) {
      return 1. + 1e-2 * std::exp(3. * (t - 1.)) *
                    std::cos(angle - 2. * pi * frequency * t);
    });
    TransientFigures      f;
    evaluate_forces(nodes, record, f);
    check(!nothing_vibrates(f) && f.least_rms < .5 * f.most_rms,
          "a wobble that grows vibrates though its sum is steady");
    check(reason_for_no_cycle(f).find("moment of the normal forces") !=
            std::string::npos,
          reason_for_no_cycle(f));
  }

  /** A pad whose pressure rocks by more than its sum vibrates. */
  void
  rocking()
  {
    const ContactNodes    nodes  = nodes_of(arc(2. * pi, true));
    const TransientRecord record = record_of(nodes, [](double angle, double t) {
      const double swing = std::cos(2. * pi * frequency * t);
      return 1. + .1 * swing + .7 * swing * std::cos(angle);
    });
    TransientFigures      f;
    evaluate_forces(nodes, record, f);
    check(f.loudest.force == JudgedForce::normal &&
            f.loudest.force_name == "normal force",
          "a pad that rocks keeps its sum");
    check_close(f.rms_normal, .1 * total / std::sqrt(2.), 1e-4, "and its rms");
    check(!transient_table(f).has_column("judged_force"), "and its table");
  }

  /** Stick-slip round the ring beside a normal force that rings by @p ring. */
  TransientFigures
  sticking(const double ring)
  {
    const ContactNodes nodes = nodes_of(arc(2. * pi, true));
    TransientFigures   f;
    TransientRecord    record = record_of(nodes, [ring](double, double t) {
      return 1. + ring * std::cos(2. * pi * 16.3 * frequency * t);
    });
    record.stretches.assign(n_force_stretches, {});
    for (unsigned int k = 0; k < n_steps; ++k)
      {
        const StepForces &step = record.last_steps[k];
        StepSums          sums;
        sums.normal = step.normal;
        sums.tangential =
          .3 * total * std::cos(2. * pi * frequency * step.time);
        record.stretches[std::size_t(k) * n_force_stretches / n_steps].add(
          sums, false);
      }
    evaluate_forces(nodes, record, f);
    return f;
  }

  void
  stick_slip()
  {
    for (const auto &[ring, force] :
         {std::make_pair(0., JudgedForce::tangential),
          {1e-3, JudgedForce::tangential},
          {.1, JudgedForce::normal}})
      check(sticking(ring).loudest.force == force, "by what is far louder");
  }

  std::string
  outcome_of(const double decay)
  {
    const ContactNodes    nodes = nodes_of(arc(2. * pi, true));
    const TransientRecord record =
      record_of(nodes, [decay](double angle, double t) {
        return t < .1 ? 1.
                      : 1. + .8 * std::exp(-decay * (t - .1)) *
                               std::cos(angle - 2. * pi * frequency * t);
      });
    TransientFigures f;
    f.verdict = "stable";
    evaluate_forces(nodes, record, f);
    TransientParameters t;
    t.end_time        = 1.;
    t.hammer.body     = "ring";
    t.hammer.time     = .1;
    t.hammer.duration = .01;
    return evaluate_trigger(record, f, t).text;
  }

  void
  triggered()
  {
    check(outcome_of(0.) == "squeal after the trigger",
          "a wobble that stays: " + outcome_of(0.));
    check(outcome_of(40.) == "temporary after the trigger",
          "a wobble that has died out: " + outcome_of(40.));
  }

  /** A shoe in a drum: all nodes slip, and press unevenly. */
  void
  curved()
  {
    const ContactNodes    nodes = nodes_of(arc(.4 * pi, false));
    const ForceSums       sums(nodes);
    const Eigen::VectorXd forces =
      forces_of([](const double angle) { return 1. + .9 * std::sin(angle); });
    check_close(sums.of(forces).tangential,
                mu * total,
                1e-12,
                "friction is mu times what presses on the nodes");
    check_close(friction_along_sliding(nodes.pairs()[0], forces),
                mu * total,
                1e-12,
                "and so in the summary of a preload");
    BodyParameters drum;
    drum.rotation_axis   = {{0., 0., -2.}};
    drum.rotation_centre = Vector3{{.2, 0., 0.}};
    check_close(moment_about_axis(nodes.pairs()[0].geometry, forces, drum),
                -.075 * mu * total,
                1e-12,
                "whose moment about the axis is the radius times it");
    const ForceSums flat(nodes_of(arc(.4 * pi, true)));
    check(flat.of(forces).tangential < .99 * mu * total,
          "on a flat face it is the resultant");
  }
} // namespace

int
main()
{
  moments();
  wobbling();
  growing();
  turned();
  turned_strip();
  waves();
  no_waves();
  rocking();
  stick_slip();
  triggered();
  curved();
}
