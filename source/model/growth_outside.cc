// SPDX-License-Identifier: LGPL-2.1-or-later

// Growth about steady sliding outside the band: which of it the bodies have and
// which the reduced model alone.

#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/base/timers.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/eigen/direct_solver.h>
#include <squeal/model/growth_outside.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace squeal
{
  namespace
  {
    using Owner = MotionOutside::Owner;

    /** Nearest to a motion of the reduced model: enough to reach past it where
     * the modes of bodies are close to each other. */
    constexpr unsigned int n_pairs_near = 20;

    /** Each shift takes a factorisation of all unknowns. */
    constexpr unsigned int most_shifts = 6;

    bool
    is_outside(const std::complex<double> lambda, const EigenParameters &band)
    {
      const double f = lambda.imag() / (2. * M_PI);
      return f < band.lowest_frequency || f > band.highest_frequency;
    }

    /** By more than rounding. */
    bool
    grows(const std::complex<double> lambda)
    {
      return lambda.real() > 1e-9 * std::abs(lambda);
    }

    /** Whether what is left out is a correction that leaves at least half of
     * the growth. Its series goes in (f / f_k)^2 of motions f_k above the
     * cut-off: all of it is less than its first term over 1 - (f / f_c)^2. */
    bool
    is_corrected(const MotionOutside &m, const TransientParameters &t)
    {
      const double r = std::pow(m.lambda.imag() / (2. * M_PI * t.cut_off), 2.);
      return r < 1. &&
             std::abs(m.estimate.real()) < 0.5 * (1. - r) * m.lambda.real();
    }

    /** Of the reduced model or, below the cut-off, by the estimate, 1/s. */
    double
    largest_growth(const MotionOutside &m, const TransientParameters &t)
    {
      return m.lambda.real() +
             (std::abs(m.lambda.imag()) <= 2. * M_PI * t.cut_off
                ? std::max(0., m.estimate.real())
                : 0.);
    }

    /** The motions of the run that grow or may grow outside the band, the
     * fastest first, as far as nothing of the band grows faster. */
    std::vector<MotionOutside>
    growing_outside_band(const LinearizedMotion &linear,
                         const Eigen::VectorXcd &estimate,
                         const Parameters       &p)
    {
      double                     of_band = 0.;
      std::vector<MotionOutside> all, result;
      for (Eigen::Index k = 0; k < linear.lambda.size(); ++k)
        {
          const std::complex<double> lambda = linear.lambda[k];
          if (!is_of_the_run(lambda, p.transient))
            continue;
          if (!is_outside(lambda, p.eigen))
            of_band = std::max(of_band, lambda.real());
          else
            all.push_back(
              {Owner::not_known, k, lambda, estimate[k], lambda, 0., ""});
        }
      const auto growth = [&p](const MotionOutside &m) {
        return largest_growth(m, p.transient);
      };
      for (const MotionOutside &m : all)
        if (grows({growth(m), m.lambda.imag()}) && growth(m) > of_band)
          result.push_back(m);
      std::stable_sort(result.begin(),
                       result.end(),
                       [&](const MotionOutside &a, const MotionOutside &b) {
                         return growth(a) > growth(b);
                       });
      return result;
    }

    /** Answers for motions one after another; what one shift has found serves
     * those near it. */
    class QuestionToBodies
    {
    public:
      QuestionToBodies(const Parameters &p, const MotionsOfBodies &bodies)
        : p(p)
        , bodies(bodies)
      {
      }

      void
      answer(MotionOutside &m)
      {
        if (!failure.empty())
          {
            m.why = failure;
            return;
          }
        for (const Known &near : known)
          if (const double away = std::abs(m.lambda - near.shift);
              away < 0.5 * near.motions.reach)
            return decide(m, near.motions, near.motions.reach - away);
        if (known.size() == most_shifts)
          {
            m.why = "more than " + std::to_string(most_shifts) +
                    " motions grow that only eigenvalues of all unknowns "
                    "can tell";
            return;
          }
        try
          {
            known.push_back({m.lambda, bodies(m.lambda)});
          }
        catch (const InputError &e)
          {
            failure = e.what();
          }
        catch (const ComputationError &e)
          {
            failure = e.what();
          }
        if (failure.empty())
          return decide(m, known.back().motions, known.back().motions.reach);
        m.why = failure;
      }

    private:
      struct Known
      {
        std::complex<double> shift;
        MotionsNear          motions;
      };

      void
      decide(MotionOutside &m, const MotionsNear &near, const double reach)
      {
        std::vector<std::complex<double>> growing, all;
        for (const std::complex<double> lambda : near.lambda)
          if (lambda.imag() >= 0.)
            {
              all.push_back(lambda);
              if (grows(lambda) && is_outside(lambda, p.eigen))
                growing.push_back(lambda);
            }
        m.reach = reach;
        m.owner = growing.empty() ? Owner::reduction : Owner::bodies;
        const auto &candidates = growing.empty() ? all : growing;
        const auto  nearest    = std::min_element(
          candidates.begin(), candidates.end(), [&m](auto a, auto b) {
            return std::abs(a - m.lambda) < std::abs(b - m.lambda);
          });
        if (nearest != candidates.end())
          m.of_bodies = *nearest;
      }

      const Parameters      &p;
      const MotionsOfBodies &bodies;
      std::vector<Known>     known;
      std::string            failure;
    };
  } // namespace



  std::complex<double>
  GrowthOutside::fastest() const
  {
    std::complex<double> result = 0.;
    for (const MotionOutside &m : motions)
      if (m.owner != Owner::reduction && m.of_bodies.real() > result.real())
        result = m.of_bodies;
    return result;
  }

  bool
  GrowthOutside::is_led_by_reduction() const
  {
    return !motions.empty() && motions.front().owner == Owner::reduction;
  }



  GrowthOutside
  growth_outside(const LinearizedMotion &linear,
                 const Eigen::VectorXcd &estimate,
                 const Parameters       &p,
                 const MotionsOfBodies  &bodies)
  {
    GrowthOutside    result;
    QuestionToBodies question(p, bodies);
    for (MotionOutside m : growing_outside_band(linear, estimate, p))
      {
        const bool is_slower =
          largest_growth(m, p.transient) <= result.fastest().real();
        if (is_corrected(m, p.transient))
          m.owner = Owner::bodies;
        else
          question.answer(m);
        // What is slower adds nothing, and what grows nowhere is none.
        if ((m.owner == Owner::not_known && is_slower) ||
            (m.owner == Owner::reduction && !grows(m.lambda)))
          continue;
        result.motions.push_back(m);
      }
    return result;
  }

  namespace
  {
    void
    require_eigenvalues(const SceneParameters &scene)
    {
      for (const ContactParameters &c : scene.contacts)
        if (scene.kind == SceneParameters::Kind::matrices &&
            c.formulation != ContactParameters::Formulation::springs)
          throw InputError("eigenvalues of imported matrices take "
                           "'Formulation = springs'");
    }
  } // namespace

  GrowthOutside
  growth_outside(const SteadyModel      &about,
                 const LinearizedMotion &linear,
                 const Eigen::VectorXcd &estimate,
                 const Parameters       &p,
                 Timers                 &timers)
  {
    Parameters whole = p;
    // In time friction turns with the slip rate.
    for (ContactParameters &c : whole.scene.contacts)
      c.transverse_slip_term = c.sliding_speed > 0.;
    std::unique_ptr<const Model>  model;
    std::unique_ptr<const Pencil> pencil;
    return growth_outside(
      linear,
      estimate,
      p,
      [&](const std::complex<double> shift) -> MotionsNear {
        require_eigenvalues(p.scene);
        if (!model)
          model = std::make_unique<const Model>(
            whole, timers, about.pressed.states_of(about.sliding));
        Timers::Section section(timers, "Solve: growth outside the band");
        if (!pencil)
          pencil = std::make_unique<const Pencil>(model->linearized().system,
                                                  whole.scene);
        const DirectPairs found =
          DirectSolver(*pencil, shift).solve_within(0., n_pairs_near);
        return {found.pairs.lambda, found.reach};
      });
  }



  GrowthOutside
  growth_outside(const SteadyModel      &about,
                 const LinearizedMotion &linear,
                 const Parameters       &p,
                 Timers                 &timers)
  {
    const PressedModel &pressed = about.pressed;
    return growth_outside(about,
                          linear,
                          reduction_error(pressed.model(),
                                          about.sliding,
                                          pressed.sliding_friction(),
                                          pressed.speed(),
                                          linear),
                          p,
                          timers);
  }



  namespace
  {
    std::string
    motion_at(const std::complex<double> lambda)
    {
      return "a motion at " + rounded_text(lambda.imag() / (2. * M_PI), 5) +
             " Hz, outside the band, ";
    }

    std::string
    sigma_text(const std::complex<double> lambda)
    {
      return "sigma of " + rounded_text(lambda.real(), 3) + " 1/s";
    }

    /** The first of an owner in words, and how many others. */
    std::string
    text_of_owner(const GrowthOutside &growth, const Owner owner)
    {
      const MotionOutside *first   = nullptr;
      std::complex<double> fastest = 0.;
      unsigned int         n       = 0;
      for (const MotionOutside &m : growth.motions)
        if (m.owner == owner)
          {
            first = n++ == 0 ? &m : first;
            if (m.of_bodies.real() > fastest.real())
              fastest = m.of_bodies;
          }
      if (first == nullptr)
        return "";
      const std::string others =
        n == 1 ? "" : ", as do " + std::to_string(n - 1) + " slower";
      switch (owner)
        {
        case Owner::bodies:
          return motion_at(fastest) + "grows (" + sigma_text(fastest) + ")";
        case Owner::reduction:
          return motion_at(first->lambda) + "grows in the reduced model (" +
                 sigma_text(first->lambda) + ")" + others +
                 ", but not in the bodies, of which nothing outside the band "
                 "grows within " +
                 rounded_text(first->reach / (2. * M_PI), 2) + " Hz of it";
        case Owner::not_known:
          return motion_at(first->lambda) + "may grow" + others + ": " +
                 sigma_text(first->lambda) +
                 " in the reduced model, to which what that leaves out "
                 "would add about " +
                 rounded_text(first->estimate.real(), 2) +
                 " 1/s; whether the bodies have it is not known (" +
                 first->why + ")";
        }
      return "";
    }
  } // namespace

  std::string
  text_of_growth_outside(const GrowthOutside &growth)
  {
    std::string text;
    for (const Owner owner :
         {Owner::bodies, Owner::not_known, Owner::reduction})
      if (const std::string clause = text_of_owner(growth, owner);
          !clause.empty())
        text += (text.empty() ? "" : "; ") + clause;
    return text;
  }

  std::string
  text_of_growth_of_reduction(const GrowthOutside &growth)
  {
    return text_of_owner(growth, Owner::reduction);
  }
} // namespace squeal
