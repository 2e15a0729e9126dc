// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/certified_solver.h>
#include <squeal/eigen/same_operators.h>
#include <squeal/model/second_solutions.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace squeal
{
  namespace
  {
    /** Of the band, up to which there are modes for other directions. */
    constexpr double reach_of_band = 0.15;

    CertifiedOptions
    options_about(const ComplexPairs    &pairs,
                  const double           below,
                  const double           above,
                  const EigenParameters &p)
    {
      double lowest = std::numeric_limits<double>::infinity(), highest = 0.;
      for (unsigned int k = 0; k < pairs.size(); ++k)
        {
          lowest  = std::min(lowest, pairs.frequency(k));
          highest = std::max(highest, pairs.frequency(k));
        }
      CertifiedOptions options;
      options.lowest_frequency    = (1. - below) * lowest;
      options.highest_frequency   = (1. + above) * highest;
      options.residual_tolerance  = std::max(1e-6, p.residual_tolerance);
      options.error_tolerance     = std::max(1e-6, p.error_tolerance);
      options.maximum_enrichments = p.maximum_enrichments;
      return options;
    }
  } // namespace



  /** A scene, its modes up to a frequency, and its pairs. */
  struct SecondSolutions::Solved
  {
    Solved(std::shared_ptr<const OtherDegree> other,
           const double                       highest,
           const CertifiedOptions            &options,
           const double                       mode_tolerance)
      : scene(std::move(other))
      , highest_frequency(highest)
      , inverse(*scene->pencil, std::pow(2. * M_PI * highest, 2))
    {
      ModeOptions of_modes;
      of_modes.tolerance = mode_tolerance;
      modes              = undamped_modes(*scene->pencil, inverse, of_modes);
      if (modes.shapes.cols() == 0)
        return;
      solver =
        std::make_unique<CertifiedSolver>(*scene->pencil, inverse, modes);
      modes.release_start();
      pairs = solver->solve(options);
    }

    const std::shared_ptr<const OtherDegree> scene;
    const double                             highest_frequency; /**< Hz */
    const ShiftedInverse                     inverse;
    UndampedModes                            modes;
    std::unique_ptr<CertifiedSolver>         solver;
    ComplexPairs                             pairs;
  };



  SecondSolutions::SecondSolutions()  = default;
  SecondSolutions::~SecondSolutions() = default;

  void
  SecondSolutions::of_bodies(const std::size_t bodies)
  {
    if (!pressed)
      {
        parts   = std::make_unique<CommonParts>();
        pressed = std::make_unique<PressedConditions>();
      }
    if (bodies != bodies_of_scene)
      last.reset();
    bodies_of_scene = bodies;
  }

  std::unique_ptr<const Pencil>
  SecondSolutions::pencil_on_last(const OtherDegree     &scene,
                                  const SceneParameters &parameters) const
  {
    auto result =
      std::make_unique<const Pencil>(last->scene->system.system, parameters);
    if (!same_operators(*result, *scene.pencil) ||
        !same_symmetric_operators(*result, *last->scene->pencil))
      return nullptr;
    return result;
  }

  SecondSolutions::Solution
  SecondSolutions::solve(const Model        &model,
                         const unsigned int  degree,
                         const ComplexPairs &pairs,
                         const double        below,
                         const double        above,
                         Timers             &timers)
  {
    const Parameters &p = model.parameters();
    const bool shares   = pressed && CommonParts::exist_for(p.discretization);
    const SharedByScenes shared{parts.get(), pressed.get(), bodies_of_scene};
    const auto           scene = std::make_shared<const OtherDegree>(
      with_degree(model, degree, timers, shares ? &shared : nullptr));
    const CertifiedOptions options =
      options_about(pairs, below, above, p.eigen);
    if (shares && last && last->pairs.size() > 0 &&
        options.highest_frequency <= last->highest_frequency)
      if (const auto pencil = pencil_on_last(*scene, p.scene))
        {
          CertifiedSolver from_there(
            *pencil, *last->solver, last->modes, last->pairs);
          return {scene, from_there.solve(options)};
        }
    // Modes for the other directions, which may grow at higher frequencies.
    const double highest =
      shares ? std::max(options.highest_frequency,
                        (1. + reach_of_band) * p.eigen.highest_frequency)
             : options.highest_frequency;
    auto solved = std::make_unique<const Solved>(
      scene, highest, options, p.eigen.mode_tolerance);
    Solution result{scene, solved->pairs};
    if (shares)
      last = std::move(solved);
    return result;
  }
} // namespace squeal
