// SPDX-License-Identifier: LGPL-2.1-or-later

// What a branch goes on from.

#include <squeal/base/exceptions.h>
#include <squeal/cycle/branch_run.h>
#include <squeal/cycle/period_equations.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    constexpr std::size_t last_status =
      static_cast<std::size_t>(ContactStatus::slip);
    /** More than any branch has, so that a damaged number is told. */
    constexpr std::size_t most_points = 100000;

    using State = std::pair<const char *, Eigen::VectorXd MotionState::*>;
    const State states[] = {{"coordinates", &MotionState::coordinates},
                            {"velocities", &MotionState::velocities},
                            {"forces", &MotionState::forces}};

    using Past = std::pair<const char *, Eigen::VectorXd ContactPast::*>;
    const Past pasts[] = {
      {"force_change", &ContactPast::force_change},
      {"motion_change", &ContactPast::motion_change},
      {"motion_change_before", &ContactPast::motion_change_before}};

    using Statuses =
      std::pair<const char *, std::vector<ContactStatus> ContactPast::*>;
    const Statuses statuses[] = {
      {"status", &ContactPast::status},
      {"status_before", &ContactPast::status_before}};

    using Corrections =
      std::pair<const char *, std::vector<Eigen::VectorXd> StepCorrections::*>;
    const Corrections corrections[] = {
      {"slip", &StepCorrections::slip},
      {"position", &StepCorrections::position},
      {"velocity", &StepCorrections::velocity}};

    /** Vectors of a length that differs, as lengths and numbers. */
    void
    set_vectors(NamedNumbers                       &numbers,
                const std::string                  &name,
                const std::vector<Eigen::VectorXd> &vectors)
    {
      std::vector<double> sizes, values;
      for (const Eigen::VectorXd &x : vectors)
        {
          sizes.push_back(static_cast<double>(x.size()));
          values.insert(values.end(), x.data(), x.data() + x.size());
        }
      numbers.set(name + "/sizes", sizes);
      numbers.set(name + "/values", values);
    }

    /** @p n vectors, each of @p size numbers or of none. */
    std::vector<Eigen::VectorXd>
    vectors_from(const NamedNumbers &numbers,
                 const std::string  &name,
                 const std::size_t   n,
                 const Eigen::Index  size)
    {
      std::vector<Eigen::VectorXd> result;
      std::size_t                  at     = 0;
      const auto                  &values = numbers.get(name + "/values");
      for (const double x : numbers.get(name + "/sizes", n))
        {
          if (x != 0. && x != static_cast<double>(size))
            throw InputError(name + "/sizes: not those of this branch");
          const Eigen::Index length = x != 0. ? size : 0;
          if (at + length > values.size())
            throw InputError(name + "/values: too few");
          result.push_back(
            Eigen::Map<const Eigen::VectorXd>(values.data() + at, length));
          at += length;
        }
      numbers.get(name + "/values", at);
      return result;
    }

    NamedNumbers
    numbers_of(const BranchPoint &x)
    {
      const Orbit &orbit = x.motion.orbit;
      NamedNumbers result;
      result.set("parameter", x.parameter);
      result.set("period", x.motion.period);
      result.set("iterations", x.motion.iterations);
      result.set("history", x.motion.history);
      result.set("is_held", x.motion.is_held ? 1. : 0.);
      for (const auto &[name, member] : states)
        result.set(std::string("start/") + name,
                   Eigen::MatrixXd(orbit.states.front().*member));
      for (const auto &[name, member] : pasts)
        result.set(std::string("past/") + name,
                   Eigen::MatrixXd(orbit.past.*member));
      for (const auto &[name, member] : statuses)
        {
          std::vector<double> values;
          for (const ContactStatus s : orbit.past.*member)
            values.push_back(static_cast<double>(s));
          result.set(std::string("past/") + name, values);
        }
      if (x.motion.is_held)
        for (const auto &[name, member] : corrections)
          set_vectors(
            result, std::string("held/") + name, orbit.corrections.*member);
      return result;
    }
  } // namespace



  NamedNumbers
  BranchRun::memory() const
  {
    NamedNumbers result;
    for (std::size_t i = 0; i < sides.size(); ++i)
      {
        const Side  &side = sides[i];
        NamedNumbers numbers;
        numbers.set("n_points", static_cast<double>(side.points.size()));
        numbers.set("steps", side.steps);
        numbers.set("is_lost", side.is_lost ? 1. : 0.);
        numbers.set("turns", side.turns ? 1. : 0.);
        // The first one is the start, which is there.
        for (std::size_t k = 1; k < side.points.size(); ++k)
          numbers.set(std::to_string(k), numbers_of(side.points[k]));
        result.set(std::to_string(i), numbers);
      }
    return result;
  }



  NamedNumbers
  BranchRun::start_memory() const
  {
    return numbers_of(start());
  }



  BranchPoint
  BranchRun::point_from(const NamedNumbers &numbers) const
  {
    const double       parameter = numbers.number("parameter");
    const auto         map       = maps(parameter);
    const Eigen::Index n_modes   = map->reduced_model().n_modes(),
                       n_nodes   = map->reduced_model().n_nodes();
    const unsigned int n_steps   = settings.shooting.n_steps;
    MotionState        start;
    for (const auto &[name, member] : states)
      start.*member =
        numbers.vector(std::string("start/") + name,
                       member == &MotionState::forces ? 3 * n_nodes : n_modes);
    ContactPast past;
    for (const auto &[name, member] : pasts)
      past.*member = numbers.vector(std::string("past/") + name, 3 * n_nodes);
    for (const auto &[name, member] : statuses)
      for (const double s : numbers.get(std::string("past/") + name, n_nodes))
        (past.*member)
          .push_back(static_cast<ContactStatus>(
            whole_number(s, last_status, std::string("past/") + name)));
    StepCorrections held;
    PeriodicMotion  motion;
    motion.is_held = numbers.count("is_held", 1) == 1;
    if (motion.is_held)
      for (const auto &[name, member] : corrections)
        held.*member = vectors_from(
          numbers,
          std::string("held/") + name,
          n_steps,
          member == &StepCorrections::slip ? 2 * n_nodes : n_modes);
    motion.period  = numbers.number("period");
    motion.history = numbers.get("history");
    motion.iterations =
      numbers.count("iterations", settings.shooting.iterations);
    // What its steps miss now tells whether it is a motion of this branch.
    if (!try_orbit(*map,
                   start,
                   motion.period,
                   n_steps,
                   past,
                   motion.is_held ? &held : nullptr,
                   motion) ||
        !(motion.residual <= settings.shooting.tolerance))
      throw InputError("parameter " + std::to_string(parameter) +
                       ": not a periodic motion of this branch");
    motion.status = CycleStatus::converged;
    if (motion.is_held)
      if (const auto located = located_anew(*map, motion))
        motion.left_open.residual = located->residual;
    return point_of(*map, std::move(motion), parameter);
  }

  void
  BranchRun::restore(const NamedNumbers &memory)
  {
    for (std::size_t i = 0; i < sides.size(); ++i)
      {
        Side              &side    = sides[i];
        const NamedNumbers numbers = memory.group(std::to_string(i));
        const std::size_t  stored  = numbers.count("n_points", most_points),
                          n        = std::min<std::size_t>(stored,
                                                    settings.n_points + 1);
        if (n == 0)
          throw InputError("n_points: a branch has one at least");
        side.steps = numbers.get("steps", stored);
        side.steps.resize(n);
        // With fewer points than before it ends before it was lost.
        const bool is_whole = n == stored;
        side.is_lost        = is_whole && numbers.count("is_lost", 1) == 1;
        side.turns          = is_whole && numbers.count("turns", 1) == 1;
        side.points.resize(1);
        for (std::size_t k = 1; k < n; ++k)
          side.points.push_back(point_from(numbers.group(std::to_string(k))));
      }
  }
} // namespace squeal
