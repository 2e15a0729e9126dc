// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/sweep/sweep_scene_check.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/worst_of.h>
#include <squeal/model/contact_states.h>
#include <squeal/parameters/number_access.h>
#include <squeal/parameters/text.h>

#include <random>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** Of products with a vector: far above rounding, far below what one node
     * of a contact does. */
    constexpr double largest_difference = 1e-11;

    /** The end of all axes that is not the scene of the file. */
    SweepPoint
    point_to_check(const Parameters &parameters, const SweepGrid &grid)
    {
      SweepPoint lower(grid.n_axes()), upper(grid.n_axes());
      for (unsigned int a = 0; a < grid.n_axes(); ++a)
        {
          lower[a] = grid.lower(a);
          upper[a] = grid.upper(a);
        }
      const std::vector<std::string> entries = grid.entries();
      const std::vector<double>      values  = grid.values(upper);
      for (std::size_t e = 0; e < entries.size(); ++e)
        if (values[e] != get_number(parameters, entries[e]))
          return upper;
      return lower;
    }

    ComplexBlock
    random_vectors(const Eigen::Index n)
    {
      std::mt19937                     generator(1);
      std::normal_distribution<double> normal;
      return ComplexBlock::NullaryExpr(n, 2, [&]() {
        const double re = normal(generator);
        return std::complex<double>(re, normal(generator));
      });
    }

    /** Of the columns of @p y from those of @p x, over their size. */
    double
    difference(const RowSpace     &space,
               const ComplexBlock &x,
               const ComplexBlock &y)
    {
      const Eigen::VectorXd size   = space.norms(x),
                            change = space.norms(ComplexBlock(y - x));
      double result                = 0.;
      for (Eigen::Index i = 0; i < size.size(); ++i)
        if (change[i] > 0.)
          result = worst_of(result, change[i] / std::max(size[i], 1e-300));
      return result;
    }
  } // namespace



  void
  check_scene_of_sweep(const Parameters                 &parameters,
                       const SweepGrid                  &grid,
                       const ParametricSystem           &system,
                       const std::vector<ContactStates> &states,
                       Timers                           &timers)
  {
    const SweepPoint           point = point_to_check(parameters, grid);
    std::vector<ContactStates> here =
      contact_of_number(states, grid.state_number(point));
    // Without the checks of the file: the axes need not suit this scene.
    Parameters p = parameters;
    p.scene      = grid.scene(point);
    const Model            model(p, timers, here);
    const Pencil           own(model.linearized().system, p.scene);
    const Pencil           swept(system.merged(), grid.scene(point));
    const RowSpace        &space = *own.space();
    const ComplexBlock     X     = random_vectors(space.n_owned());
    const Pencil::Products a = own.apply(X), b = swept.apply(X);
    double                 worst = 0.;
    for (const auto &[x, y] : {std::make_pair(&a.mass, &b.mass),
                               std::make_pair(&a.damping, &b.damping),
                               std::make_pair(&a.stiffness, &b.stiffness)})
      worst = worst_of(worst, difference(space, *x, *y));
    if (!(worst <= largest_difference))
      {
        std::ostringstream text;
        text << "Sweep/Axes: at " << text_of(grid, point)
             << " the matrices of the sweep are not those of the scene (they "
                "differ by "
             << worst
             << "): what is swept changes more than factors of the matrices of "
                "the file, such as the share that nodes of different sliding "
                "speed have in a friction law; set the scene itself to a point "
                "inside the axes, or run the points one by one";
        throw InputError(text.str());
      }
  }
} // namespace squeal
