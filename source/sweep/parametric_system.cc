// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/sum_operator.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/sweep/parametric_system.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace squeal
{
  namespace
  {
    /** Coefficients of one term at all samples, one after the other. */
    Eigen::VectorXd
    profile(const std::vector<TermCoefficients> &samples)
    {
      Eigen::VectorXd result(4 * samples.size());
      for (std::size_t i = 0; i < samples.size(); ++i)
        result.segment<4>(4 * i) << samples[i].mass, samples[i].damping,
          samples[i].stiffness.real(), samples[i].stiffness.imag();
      return result;
    }

    /** The factor f with a = f b everywhere, or 0. */
    double
    common_factor(const Eigen::VectorXd &a, const Eigen::VectorXd &b)
    {
      Eigen::Index largest;
      b.cwiseAbs().maxCoeff(&largest);
      const double f = a[largest] / b[largest];
      return ((a - f * b).array().abs() <= 1e-13 * a.array().abs()).all() ? f
                                                                          : 0.;
    }

    bool
    are_equal(const TermCoefficients &a, const TermCoefficients &b)
    {
      return a.mass == b.mass && a.damping == b.damping &&
             a.stiffness == b.stiffness;
    }

    /** Whether a matrix is more than zeros, by its product with a random
     * vector. */
    bool
    is_nonzero(const LinearOperator &matrix, const RowSpace &space)
    {
      std::mt19937                     generator(1);
      std::normal_distribution<double> normal;
      const Block                      x = Block::NullaryExpr(
        space.n_owned(), 1, [&]() { return normal(generator); });
      return space.norms(matrix.multiply(x))[0] > 0.;
    }

    /** Places spread over the box, and every value of the axes that are lists,
     * with the others at both ends and in the middle: entries may follow each a
     * law of its own, which bends at these values. */
    std::vector<SweepPoint>
    sampled_points(const SweepGrid &grid)
    {
      std::vector<SweepPoint> result = grid.spread(12 + (1u << grid.n_axes()));
      SweepPoint              low(grid.n_axes()), high(grid.n_axes());
      for (unsigned int a = 0; a < grid.n_axes(); ++a)
        {
          low[a]  = grid.lower(a);
          high[a] = grid.upper(a);
        }
      for (unsigned int a = 0; a < grid.n_axes(); ++a)
        if (grid.axis(a).scale == SweepAxisParameters::Scale::list)
          for (const double value : grid.coordinates(a))
            for (const double share : {0., 0.5, 1.})
              {
                result.push_back((1. - share) * low + share * high);
                result.back()[a] = value;
              }
      return result;
    }
  } // namespace



  void
  require_affine(const std::string &section, const std::string &path)
  {
    if (!is_affine_entry(path))
      throw InputError("'" + section + "' contains '" + path +
                       "', which changes the matrices themselves and not "
                       "only their factors");
  }

  bool
  change_matrices(const AffineSystem    &system,
                  const SceneParameters &a,
                  const SceneParameters &b)
  {
    for (const auto &term : system.terms)
      if (!are_equal(term.coefficients(a), term.coefficients(b)) &&
          is_nonzero(*term.matrix, *system.space))
        return true;
    return false;
  }



  ParametricSystem::ParametricSystem(const AffineSystem &system,
                                     const SweepGrid    &grid)
    : sweep_grid(grid)
  {
    for (unsigned int a = 0; a < grid.n_axes(); ++a)
      for (const auto &path : grid.axis(a).entries)
        require_affine("Sweep/Axis " + grid.axis(a).name + "/Entries", path);

    std::vector<std::vector<TermCoefficients>> samples(system.terms.size());
    // In every contact state, whichever holds there.
    std::vector<unsigned int> state_of_sample;
    for (const auto &point : sampled_points(grid))
      {
        SceneParameters scene = grid.scene(point);
        for (unsigned int k = 0; k < grid.n_states(); ++k)
          {
            for (auto &contact : scene.contacts)
              contact.state_number = k;
            state_of_sample.push_back(k);
            for (std::size_t i = 0; i < system.terms.size(); ++i)
              samples[i].push_back(system.terms[i].coefficients(scene));
          }
      }
    // What is to be varied beside the axes must come apart too.
    const SweepPoint   centre = grid.spread(1).back();
    const unsigned int n_own  = grid.entries().size();
    for (unsigned int e = 0; e < grid.other_entries().size(); ++e)
      {
        require_affine("Sweep/Sensitivities", grid.other_entries()[e]);
        const SceneParameters &scene = grid.scene(centre, n_own + e, 1.1);
        for (std::size_t i = 0; i < system.terms.size(); ++i)
          samples[i].push_back(system.terms[i].coefficients(scene));
      }
    struct Group
    {
      Eigen::VectorXd                profile;
      bool                           symmetric, is_friction;
      std::size_t                    first;
      std::vector<SumOperator::Part> operators;
    };
    std::vector<Group> groups;
    for (std::size_t i = 0; i < system.terms.size(); ++i)
      {
        const Eigen::VectorXd p = profile(samples[i]);
        if (p.isZero(0.))
          continue;
        const bool symmetric   = system.terms[i].matrix->is_symmetric();
        const bool is_friction = system.terms[i].is_friction;
        bool       placed      = false;
        for (auto &group : groups)
          if (const double f = common_factor(p, group.profile);
              f != 0. && symmetric == group.symmetric &&
              is_friction == group.is_friction)
            {
              group.operators.emplace_back(f, system.terms[i].matrix);
              placed = true;
              break;
            }
        if (!placed)
          groups.push_back(
            {p, symmetric, is_friction, i, {{1., system.terms[i].matrix}}});
      }
    parts.space = system.space;
    for (auto &group : groups)
      parts.terms.push_back(
        {system.terms[group.first].name,
         std::make_shared<SumOperator>(std::move(group.operators)),
         system.terms[group.first].coefficients,
         group.is_friction});
    for (const auto &group : groups)
      {
        is_there.emplace_back(grid.n_states(), false);
        for (std::size_t i = 0; i < state_of_sample.size(); ++i)
          if (!group.profile.segment<4>(4 * i).isZero(0.))
            is_there.back()[state_of_sample[i]] = true;
      }
  }

  bool
  ParametricSystem::is_switched(const std::size_t part) const
  {
    const auto &there = is_there[part];
    return std::find(there.begin(), there.end(), false) != there.end();
  }

  const AffineSystem &
  ParametricSystem::merged() const
  {
    return parts;
  }

  const SweepGrid &
  ParametricSystem::grid() const
  {
    return sweep_grid;
  }

  std::vector<TermCoefficients>
  ParametricSystem::coefficients(const SceneParameters &scene) const
  {
    std::vector<TermCoefficients> result;
    for (const auto &term : parts.terms)
      result.push_back(term.coefficients(scene));
    return result;
  }

  std::vector<TermCoefficients>
  ParametricSystem::coefficients(const SweepPoint &point) const
  {
    return coefficients(sweep_grid.scene(point));
  }
} // namespace squeal
