// SPDX-License-Identifier: LGPL-2.1-or-later

// Bounded least squares by NLopt, and what it says about the numbers.

#include <squeal/analyses/updating/updating_model.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/run_log.h>

#include <boost/math/distributions/students_t.hpp>

#include <Eigen/SVD>

#include <nlopt.h>

#include <cmath>
#include <exception>
#include <limits>

namespace squeal
{
  namespace
  {
    /** Directions in the space of the numbers that change the frequencies less
     * than this share of the most influential one count as unknown. */
    constexpr double unknown_direction = 1e-3;

    /** What NLopt calls. The variables are logarithms over scales that give
     * every residual's slope the size 1. */
    struct Problem
    {
      UpdatingModel                  &model;
      RunLog                         &log;
      Eigen::VectorXd                 scales;
      std::vector<UpdatingEvaluation> history;
      std::size_t                     best      = 0;
      nlopt_opt                       optimizer = nullptr;
      std::exception_ptr              error     = nullptr;

      const UpdatingEvaluation &
      at(const Eigen::VectorXd &logarithms)
      {
        for (const auto &known : history)
          if (known.logarithms == logarithms)
            return known;
        history.push_back(model.evaluate(logarithms));
        if (history.back().objective() < history[best].objective())
          best = history.size() - 1;
        const auto &r = history.back().residuals;
        log.info("  evaluation " + std::to_string(history.size()) +
                 ": rms of the weighted errors " +
                 rounded_text(100. * std::sqrt(r.squaredNorm() / r.size()), 4) +
                 " %");
        return history.back();
      }
    };

    double
    objective(unsigned n, const double *x, double *gradient, void *data)
    {
      Problem &problem = *static_cast<Problem *>(data);
      try
        {
          const Eigen::VectorXd logarithms =
            Eigen::Map<const Eigen::VectorXd>(x, n).cwiseProduct(
              problem.scales);
          const UpdatingEvaluation &e = problem.at(logarithms);
          if (gradient)
            Eigen::Map<Eigen::VectorXd>(gradient, n) =
              (e.jacobian.transpose() * e.residuals)
                .cwiseProduct(problem.scales);
          return e.objective();
        }
      catch (...) // must not pass through NLopt's C code
        {
          problem.error = std::current_exception();
          nlopt_force_stop(problem.optimizer);
          return std::numeric_limits<double>::max();
        }
    }

    std::string
    ending(const nlopt_result code, bool &has_converged)
    {
      has_converged = code == NLOPT_SUCCESS || code == NLOPT_STOPVAL_REACHED ||
                      code == NLOPT_FTOL_REACHED || code == NLOPT_XTOL_REACHED;
      // Rounding stops a descent only where it has arrived.
      if (code == NLOPT_ROUNDOFF_LIMITED)
        {
          has_converged = true;
          return "rounding allows no further step";
        }
      if (code == NLOPT_MAXEVAL_REACHED)
        return "the allowed evaluations are used up";
      return has_converged ? "the numbers change no more"
                           : "NLopt ended with " +
                               std::string(nlopt_result_to_string(code));
    }

    void
    minimize(Problem                  &problem,
             const UpdatingParameters &parameters,
             UpdatingFit              &fit)
    {
      const unsigned int n = problem.model.n_numbers();
      const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> optimizer(
        nlopt_create(NLOPT_LD_SLSQP, n), &nlopt_destroy);
      problem.optimizer = optimizer.get();
      std::vector<double> lower, upper, tolerance;
      for (unsigned int i = 0; i < n; ++i)
        {
          lower.push_back(problem.model.lower(i) / problem.scales[i]);
          upper.push_back(problem.model.upper(i) / problem.scales[i]);
          tolerance.push_back(parameters.tolerance / problem.scales[i]);
        }
      nlopt_set_min_objective(optimizer.get(), &objective, &problem);
      nlopt_set_lower_bounds(optimizer.get(), lower.data());
      nlopt_set_upper_bounds(optimizer.get(), upper.data());
      nlopt_set_xtol_abs(optimizer.get(), tolerance.data());
      nlopt_set_maxeval(optimizer.get(), parameters.maximum_evaluations);
      // Frequencies are not known to better than a part in 1e10.
      nlopt_set_stopval(optimizer.get(), 1e-20);
      std::vector<double> x(n, 0.);
      double              value;
      const nlopt_result  code =
        nlopt_optimize(optimizer.get(), x.data(), &value);
      if (problem.error)
        std::rethrow_exception(problem.error);
      fit.ended = ending(code, fit.has_converged);
    }

    /** Part of a number in directions that the data do not tell from which it
     * is not known. */
    constexpr double unknown_part = 0.1;

    /** Sets the number that each is most correlated with. Of two that are not
     * known it is their share in the directions that the data do not tell,
     * along which their variance is without bound: a number without influence
     * has such a direction for itself and no partner. What is left of it in
     * other directions says nothing about its correlation with what is known.
     */
    void
    set_partners(const Eigen::MatrixXd     &covariance,
                 const Eigen::MatrixXd     &unknown,
                 std::vector<FittedNumber> &numbers)
    {
      const unsigned int n      = numbers.size();
      const auto         shares = [&](const unsigned int i) {
        return unknown(i, i) > unknown_part;
      };
      for (unsigned int i = 0; i < n; ++i)
        {
          numbers[i].partner     = -1;
          numbers[i].correlation = 0.;
          for (unsigned int j = 0; j < n; ++j)
            {
              const bool is_known =
                !numbers[i].is_unknown && !numbers[j].is_unknown;
              if (j == i || !(is_known || (shares(i) && shares(j))))
                continue;
              const Eigen::MatrixXd &of    = is_known ? covariance : unknown;
              const double           scale = std::sqrt(of(i, i) * of(j, j));
              if (scale > 0. &&
                  std::abs(of(i, j)) / scale > std::abs(numbers[i].correlation))
                {
                  numbers[i].partner     = j;
                  numbers[i].correlation = of(i, j) / scale;
                }
            }
        }
    }

    /** Intervals, correlations and what the data do not tell. */
    std::vector<FittedNumber>
    statistics(const UpdatingModel      &model,
               const UpdatingParameters &parameters,
               const UpdatingEvaluation &best)
    {
      const double       not_known = std::numeric_limits<double>::quiet_NaN();
      const unsigned int n         = model.n_numbers();
      const Eigen::Index n_free    = best.residuals.size() - n;
      const Eigen::JacobiSVD<Eigen::MatrixXd> svd(
        best.jacobian, Eigen::ComputeThinU | Eigen::ComputeThinV);
      const Eigen::VectorXd &sizes = svd.singularValues();
      const double cut = unknown_direction * std::max(sizes[0], 1e-300);
      // Covariance over the variance of the data, of known directions.
      Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(n, n);
      Eigen::MatrixXd unknown    = Eigen::MatrixXd::Zero(n, n);
      for (unsigned int k = 0; k < n; ++k)
        {
          const Eigen::VectorXd v = svd.matrixV().col(k);
          if (sizes[k] > cut)
            covariance += v * v.transpose() / (sizes[k] * sizes[k]);
          else
            unknown += v * v.transpose();
        }
      double reach = not_known; // quantile times deviation of one residual
      if (n_free > 0)
        reach =
          boost::math::quantile(boost::math::students_t(n_free),
                                0.5 + 0.005 * parameters.confidence_percent) *
          std::sqrt(best.residuals.squaredNorm() / n_free);
      std::vector<FittedNumber> result;
      for (unsigned int i = 0; i < n; ++i)
        {
          FittedNumber number;
          const double u     = best.logarithms[i];
          number.start       = model.start_value(i);
          number.value       = number.start * std::exp(u);
          number.lower       = number.start * std::exp(model.lower(i));
          number.upper       = number.start * std::exp(model.upper(i));
          number.sensitivity = best.jacobian.col(i).norm();
          const double slack = 1e-6 + parameters.tolerance;
          number.is_at_bound =
            u <= model.lower(i) + slack || u >= model.upper(i) - slack;
          // Of a number of almost no influence, the variance may overflow.
          number.is_unknown =
            unknown(i, i) > unknown_part || !std::isfinite(covariance(i, i));
          const double half =
            number.is_unknown ? not_known : reach * std::sqrt(covariance(i, i));
          number.interval_lower = number.value * std::exp(-half);
          number.interval_upper = number.value * std::exp(half);
          if (!std::isfinite(number.interval_upper)) // tells nothing
            number.interval_lower = number.interval_upper = not_known;
          // Without an interval nothing says that it is.
          number.is_identified = 2. * half <= model.upper(i) - model.lower(i);
          result.push_back(number);
        }
      set_partners(covariance, unknown, result);
      return result;
    }
  } // namespace



  UpdatingFit
  fit_numbers(UpdatingModel            &model,
              const UpdatingParameters &parameters,
              RunLog                   &log)
  {
    UpdatingFit fit;
    Problem     problem{model, log, {}, {}};
    fit.first = problem.at(Eigen::VectorXd::Zero(model.n_numbers()));
    const Eigen::VectorXd slopes = fit.first.jacobian.colwise().norm();
    // A number without influence gets the scale of one with little.
    problem.scales =
      slopes.cwiseMax(1e-3 * slopes.maxCoeff()).cwiseMax(1e-300).cwiseInverse();
    minimize(problem, parameters, fit);
    fit.best    = problem.history[problem.best];
    fit.history = std::move(problem.history);
    fit.numbers = statistics(model, parameters, fit.best);
    fit.has_no_spare =
      fit.best.residuals.size() == Eigen::Index(model.n_numbers());
    return fit;
  }
} // namespace squeal
