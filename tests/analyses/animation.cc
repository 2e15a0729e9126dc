// SPDX-License-Identifier: LGPL-2.1-or-later

// The animation of a transient, read back from its files: what bodies and
// contact nodes do there is what the tables say, by each integrator and over a
// stop in the middle. The forces of portraits are those of every step.
// Arguments: the program, the folder of parameter files.

#include <squeal/analyses/transient/transient_results.h>
#include <squeal/base/timers.h>

#include <deal.II/base/mpi.h>

#include "../results/read_vtu.h"
#include "program.h"
#include "worst.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr std::size_t n_frames = 6;

  /** A coarse brake in full squeal, struck by a hammer. The probes of the
   * reduced model leave out how a blow bends the pad while it lasts, its frames
   * do not: there the blow is over. */
  std::vector<std::string>
  settings(const std::string &integrator)
  {
    return {"Scene/Body disc/Cells = 16, 3, 1",
            "Scene/Body pad/Cells = 2, 2, 2",
            "Scene/Body support/Cells = 2, 2, 4",
            "Scene/Support top/Kind = free",
            "Transient/Integrator = " + integrator,
            "Transient/Disturbance = 1e-5",
            "Transient/Time step = 2e-6",
            "Transient/End time = 2e-3",
            "Transient/History start = 0",
            "Transient/Animation frames = " + std::to_string(n_frames),
            "Transient/Hammer/Body = pad",
            "Transient/Hammer/Face = y_min",
            "Transient/Hammer/Force = 0, 30, 0",
            "Transient/Hammer/Time = " +
              std::string(integrator == "reduced" ? "1e-3" : "1.8e-3"),
            "Output/Plots = false"};
  }

  /** Names and times of a collection. */
  std::vector<std::pair<double, std::string>>
  steps_of(const std::string &pvd)
  {
    std::vector<std::pair<double, std::string>> steps;
    const auto value = [&](const std::string &key, const std::size_t from) {
      const std::size_t begin = pvd.find(key + "=\"", from) + key.size() + 2;
      return pvd.substr(begin, pvd.find('"', begin) - begin);
    };
    for (std::size_t at = 0;
         (at = pvd.find("<DataSet", at)) != std::string::npos;
         ++at)
      steps.emplace_back(std::stod(value("timestep", at)), value("file", at));
    return steps;
  }

  /** The point nearest to @p place. */
  std::size_t
  point_at(const std::vector<float> &points, const double (&place)[3])
  {
    std::size_t best  = 0;
    double      least = 1e300;
    for (std::size_t p = 0; 3 * p < points.size(); ++p)
      {
        double square = 0.;
        for (unsigned int c = 0; c < 3; ++c)
          square += std::pow(points[3 * p + c] - place[c], 2);
        if (square < least)
          {
            least = square;
            best  = p;
          }
      }
    check(least < 1e-10, "a point at the centre of the pad");
    return best;
  }

  /** Checks the frames of the contact against @p forces. Returns the widest gap
   * under a pressure, m. */
  double
  check_contact(const std::string &directory, const Table &forces)
  {
    const std::string pvd   = text_of(directory + "/contact.pvd");
    const auto        steps = steps_of(pvd);
    check_xml(pvd, "contact.pvd");
    check(steps.size() == n_frames, "a file of the contact for each frame");
    const std::size_t first = forces.n_rows() - n_frames;
    Worst             most_slip;
    Worst             gap_under_pressure;
    Worst             worst;
    bool              same_time = true, same_status = true;
    for (std::size_t k = 0; k < n_frames; ++k)
      {
        const std::string vtu = text_of(directory + "/" + steps[k].second);
        check_xml(vtu, steps[k].second);
        const auto area     = vtu_array<double>(vtu, "area"),
                   pressure = vtu_array<double>(vtu, "pressure"),
                   traction = vtu_array<double>(vtu, "traction"),
                   slip     = vtu_array<double>(vtu, "slip_rate"),
                   gap      = vtu_array<double>(vtu, "gap"),
                   status   = vtu_array<double>(vtu, "status");
        double sum[3] = {}, n_open = 0.;
        for (std::size_t j = 0; j < area.size(); ++j)
          {
            for (unsigned int c = 0; c < 2; ++c)
              sum[c] += area[j] * traction[3 * j + c];
            sum[2] += area[j] * pressure[j];
            n_open += status[j] == 0.;
            most_slip.add(std::abs(slip[3 * j + 1]));
            if (pressure[j] >= 1.)
              gap_under_pressure.add(gap[j]);
          }
        const char *const names[] = {"radial_n", "tangential_n", "normal_n"};
        for (unsigned int c = 0; c < 3; ++c)
          worst.add(std::abs(sum[c] - forces.real(first + k, names[c])));
        same_time =
          same_time && steps[k].first == forces.real(first + k, "time_s");
        same_status = same_status && n_open == forces.real(first + k, "n_open");
      }
    check(same_time, "the times of the last samples");
    check(same_status, "the open nodes of forces.csv");
    check(most_slip.largest() > 0.05, "the nodes slide");
    check(worst.largest() < 1e-8,
          "pressures and tractions sum up to forces.csv: " +
            std::to_string(worst.largest()) + " N");
    return gap_under_pressure.largest();
  }

  void
  check_motion(const std::string &directory, const Table &probes)
  {
    const std::string pvd   = text_of(directory + "/motion.pvd");
    const auto        steps = steps_of(pvd);
    check_xml(pvd, "motion.pvd");
    check(steps.size() == n_frames, "a file of the bodies for each frame");
    const std::size_t   first = probes.n_rows() - n_frames;
    Worst               worst;
    Worst               largest;
    Worst               largest_deviation;
    Worst               inconsistent;
    double              factor = 0.;
    std::vector<double> sum;
    std::vector<float>  start, start_deviation;
    for (std::size_t k = 0; k < n_frames; ++k)
      {
        const std::string vtu = text_of(directory + "/" + steps[k].second);
        check_xml(vtu, steps[k].second);
        const auto points    = vtu_array<float>(vtu, "Points"),
                   u         = vtu_array<float>(vtu, "displacement"),
                   deviation = vtu_array<float>(vtu, "deviation");
        check(u.size() == points.size() && deviation.size() == points.size(),
              "a vector for each point");
        const std::size_t p       = point_at(points, {0.1075, 0., 0.005});
        const char *const names[] = {"pad_x_m", "pad_y_m", "pad_z_m"};
        for (unsigned int c = 0; c < 3; ++c)
          worst.add(std::abs(u[3 * p + c] - probes.real(first + k, names[c])));
        sum.resize(u.size());
        if (k == 0)
          {
            start           = u;
            start_deviation = deviation;
          }
        for (std::size_t i = 0; i < u.size(); ++i)
          {
            sum[i] += deviation[i];
            largest.add(std::abs(double(u[i])));
            largest_deviation.add(std::abs(double(deviation[i])));
            inconsistent.add(
              std::abs(double(u[i]) - start[i] -
                       (double(deviation[i]) - start_deviation[i])));
          }
        factor = vtu_number(vtu, "display_factor");
      }
    Worst mean;
    for (const double s : sum)
      mean.add(std::abs(s) / n_frames);
    check(worst.largest() < 2e-6 * largest.largest(),
          "the pad's centre moves as in probes.csv: " +
            std::to_string(worst.largest() / largest.largest()));
    check(inconsistent.largest() < 2e-6 * largest.largest(),
          "displacement and deviation differ by a constant");
    check(mean.largest() < 1e-5 * largest_deviation.largest(),
          "the deviation has no mean");
    check(factor * largest_deviation.largest() > 0.005 &&
            factor * largest_deviation.largest() < 0.05,
          "the warp is drawn at a visible size: " +
            std::to_string(factor * largest_deviation.largest()) + " m");
  }

  /** Runs and checks all files. Returns the widest gap under a pressure, m. */
  double
  files(const std::string              &program,
        const std::string              &folder,
        const std::string              &integrator,
        const std::vector<std::string> &further = {})
  {
    std::vector<std::string> words = {program}, all = settings(integrator);
    all.insert(all.end(), further.begin(), further.end());
    for (const std::string &setting : all)
      words.insert(words.end(), {"--set", setting});
    words.insert(words.end(),
                 {"--set",
                  "Output directory = " + integrator,
                  folder + "/tribobrake/transient.prm"});
    std::filesystem::remove_all(integrator);
    const Outcome outcome = run_program(words);
    check(outcome.code == 0, integrator + " runs: " + outcome.errors);
    check(outcome.output.find("motion.pvd") != std::string::npos,
          "the program says what to open");
    const double gap =
      check_contact(integrator, read_csv(integrator + "/forces.csv"));
    check_motion(integrator, read_csv(integrator + "/probes.csv"));
    return gap;
  }

  /** A run that can be stopped, and what it is about. */
  struct Runs
  {
    Runs(const std::string &folder, const std::vector<std::string> &settings)
      : p(read_parameters(folder + "/tribobrake/transient.prm", settings))
      , model(p, timers)
      , prepared(PressedModel(p,
                              *model.discretization(),
                              model.body_matrices(),
                              p.transient.cut_off,
                              timers),
                 p,
                 timers)
    {
    }

    TransientRun
    start() const
    {
      return {prepared.pressed, prepared.steady, prepared.linear, {}, p};
    }

    const Parameters        p;
    Timers                  timers;
    Model                   model;
    const PreparedTransient prepared;
  };

  /** Portraits are drawn from every step, however few the samples are. */
  void
  every_step(const std::string &folder)
  {
    std::vector<std::string> all = settings("reduced");
    all.insert(all.end(),
               {"Transient/Sample interval = 4e-5",
                "Scene/Contact pad_disc/Contact state = full"});
    const Runs   runs(folder, all);
    TransientRun run = runs.start();
    check(run.advance(), "to the end");
    const double           step   = 2e-6;
    const TransientRecord &record = run.record();
    check(record.last_steps.size() == 1000, "every step of the run");
    Worst off;
    for (std::size_t k = 1; k < record.samples.size(); ++k)
      {
        const TransientSample &sample = record.samples[k];
        const StepForces      &same   = record.last_steps[20 * k - 1];
        off.add(std::abs(same.time - sample.time) / step);
        off.add(std::abs(same.normal - sample.normal));
        off.add(std::abs(same.tangential - sample.tangential));
      }
    check_within(off, 1e-9, "they are the samples where there are samples");
    const double     frequency = 10e3;
    const ForceCurve drawn     = last_periods(record, frequency);
    Worst            spacing;
    for (std::size_t i = 1; i < drawn.time.size(); ++i)
      spacing.add(std::abs(drawn.time[i] - drawn.time[i - 1] - step) / step);
    check_within(spacing, 1e-9, "drawn are neighbouring steps");
    check(drawn.time.size() == 301 &&
            drawn.time.back() == record.samples.back().time,
          "six periods up to the end");
    for (const Chart &chart : portraits(drawn))
      check(chart.series[0].x.size() >= 299 &&
              chart.series[0].x.size() == chart.series[0].y.size(),
            chart.title + " has them all");
    check(last_periods(record, 10.).time.size() == 1000,
          "no more than there are");
  }

  /** The run stopped amid the frames gives the same frames. */
  void
  restart(const std::string &folder, const std::string &integrator)
  {
    std::vector<std::string> all = settings(integrator);
    all.insert(all.end(),
               {"Transient/Sample interval = 2e-6",
                "Transient/End time = 4e-4",
                "Transient/Hammer/Time = 1e-4",
                "Transient/Animation frames = 120",
                "Scene/Contact pad_disc/Contact state = full"});
    const Runs   runs(folder, all);
    TransientRun whole = runs.start(), stopped = runs.start(),
                 resumed = runs.start();
    check(whole.advance(), "to the end");
    check(!stopped.advance([&](const unsigned int) {
      return stopped.record().frames.size() > 40;
    }),
          "stopped amid the frames");
    resumed.restore(stopped.memory());
    check(resumed.record().frames.size() > 40, "with the frames before it");
    check(resumed.advance(), "continues to the end");
    const auto &a = whole.record(), &b = resumed.record();
    check(a.frames.size() == 120 && b.frames.size() == 120, "all frames");
    bool same = true;
    for (std::size_t k = 0; k < a.frames.size(); ++k)
      same = same && a.frames[k].time == b.frames[k].time &&
             a.frames[k].coordinates == b.frames[k].coordinates &&
             a.frames[k].forces == b.frames[k].forces &&
             a.frames[k].unknowns == b.frames[k].unknowns;
    check(same && a.frame_nodes[0].pressure == b.frame_nodes[0].pressure &&
            a.frame_nodes[0].slip_rate == b.frame_nodes[0].slip_rate,
          "every bit of the frames, " + integrator);
    bool same_forces = a.last_steps.size() == 200 && b.last_steps.size() == 200;
    for (std::size_t k = 0; same_forces && k < a.last_steps.size(); ++k)
      same_forces = a.last_steps[k].time == b.last_steps[k].time &&
                    a.last_steps[k].normal == b.last_steps[k].normal &&
                    a.last_steps[k].tangential == b.last_steps[k].tangential;
    check(same_forces, "every bit of the forces after each step");
    check((integrator == "implicit") == (a.frames[0].unknowns.size() > 0),
          "a full model gives all its unknowns");
  }
} // namespace

int
main(int argc, char *argv[])
{
  check(argc == 3, "two arguments: program and folder");
  const std::string program = argv[1], folder = argv[2];
  check(files(program, folder, "reduced") < 1e-12,
        "reduced: no pressure across a gap");
  // The implicit integrator closes gaps by velocities: a node that touches down
  // within a step still has the gap of its way through the step.
  std::vector<double> gaps;
  for (const char *step : {"4e-6", "2e-6"})
    gaps.push_back(files(program,
                         folder,
                         "implicit",
                         {"Transient/Time step = " + std::string(step),
                          "Transient/Sample interval = 8e-6"}));
  std::printf("gaps under a pressure: %.2e m, %.2e m with half the step\n",
              gaps[0],
              gaps[1]);
  check(gaps[0] < 1e-7, "implicit: gaps under a pressure are small");
  check(gaps[1] < 0.6 * gaps[0], "and fall with the time step");
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  every_step(folder);
  restart(folder, "reduced");
  restart(folder, "implicit");
}
