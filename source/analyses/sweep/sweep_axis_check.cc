// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/sweep/sweep_axis_check.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/parameters/text.h>

#include <random>
#include <set>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** Whether the contact state of a point differs from that of its neighbour
     * along axis @p a anywhere on the grid. */
    bool
    changes_states(const SweepGrid &grid, const unsigned int a)
    {
      if (grid.n_states() < 2)
        return false;
      const std::vector<unsigned int> &state  = grid.states();
      const std::size_t                n      = grid.coordinates(a).size();
      std::size_t                      stride = 1;
      for (unsigned int b = 0; b < a; ++b)
        stride *= grid.coordinates(b).size();
      for (std::size_t i = 0; i + stride < state.size(); ++i)
        if (i / stride % n + 1 < n && state[i] != state[i + stride])
          return true;
      return false;
    }

    bool
    are_equal(const TermCoefficients &a, const TermCoefficients &b)
    {
      return a.mass == b.mass && a.damping == b.damping &&
             a.stiffness == b.stiffness;
    }

    /** The parts whose coefficients change along axis @p a from @p point. */
    void
    add_changed_parts(const SweepGrid        &grid,
                      const ParametricSystem &system,
                      const unsigned int      a,
                      SweepPoint              point,
                      std::set<std::size_t>  &parts)
    {
      point[a]         = grid.coordinates(a).front();
      const auto first = system.coefficients(point);
      for (const double x : grid.coordinates(a))
        {
          point[a]       = x;
          const auto now = system.coefficients(point);
          for (std::size_t i = 0; i < now.size(); ++i)
            if (!are_equal(now[i], first[i]))
              parts.insert(i);
        }
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

    bool
    acts(const SweepGrid        &grid,
         const ParametricSystem &system,
         const unsigned int      a)
    {
      if (grid.coordinates(a).size() < 2 || changes_states(grid, a))
        return true;
      // At both ends and in the middle of the others, as a factor of theirs
      // may be zero at one of them.
      std::set<std::size_t> parts;
      for (const double share : {0., .5, 1.})
        {
          SweepPoint point(grid.n_axes());
          for (unsigned int b = 0; b < grid.n_axes(); ++b)
            point[b] = grid.lower(b) + share * (grid.upper(b) - grid.lower(b));
          add_changed_parts(grid, system, a, point, parts);
        }
      for (const std::size_t i : parts)
        if (is_nonzero(*system.merged().terms[i].matrix,
                       *system.merged().space))
          return true;
      return false;
    }



    /** Whether a tenth more of entry @p e beside the axes changes anything; one
     * that is 0 has no tenth. */
    bool
    acts_beside(const SweepGrid        &grid,
                const ParametricSystem &system,
                const unsigned int      e)
    {
      const unsigned int n_own  = grid.entries().size();
      const SweepPoint   centre = grid.spread(1).back();
      if (grid.entry_value(centre, n_own + e) == 0.)
        return true;
      for (const double share : {0., .5, 1.})
        {
          SweepPoint point(grid.n_axes());
          for (unsigned int b = 0; b < grid.n_axes(); ++b)
            point[b] = grid.lower(b) + share * (grid.upper(b) - grid.lower(b));
          const auto before = system.coefficients(point);
          const auto after =
            system.coefficients(grid.scene(point, n_own + e, 1.1));
          for (std::size_t i = 0; i < before.size(); ++i)
            if (!are_equal(before[i], after[i]) &&
                is_nonzero(*system.merged().terms[i].matrix,
                           *system.merged().space))
              return true;
        }
      return false;
    }

    bool
    ends_with(const std::string &text, const std::string &end)
    {
      return text.size() >= end.size() &&
             text.compare(text.size() - end.size(), end.size(), end) == 0;
    }

    /** Where damping of the scene comes from, for an entry of damping. */
    std::string
    reason_of_damping(const SceneParameters &scene, const std::string &entry)
    {
      using Model       = DampingParameters::Model;
      const bool is_own = entry.rfind("Scene/Damping/", 0) != 0;
      switch (scene.damping.model)
        {
        case Model::none:
          return "'Scene/Damping/Model = none' leaves all damping out";
        case Model::whole_model:
          if (is_own)
            return "'Scene/Damping/Model = whole model' takes damping from the "
                   "section Scene/Damping; 'per part' takes that of each part";
          break;
        case Model::per_part:
          if (!is_own)
            return "'Scene/Damping/Model = per part' takes the damping of each "
                   "part, not that of the section Scene/Damping";
          break;
        }
      return "nothing that it damps has stiffness or mass here";
    }

    /** What is likely behind an entry that changes nothing. */
    std::string
    reason_of(const SceneParameters &scene, const std::string &entry)
    {
      if (ends_with(entry, " damping"))
        return reason_of_damping(scene, entry);
      if (ends_with(entry, "/Tangential stiffness"))
        return "it acts where nodes stick, and in steady sliding none does";
      if (ends_with(entry, "/Normal stiffness per area"))
        return "it belongs to springs of the layout 'quadrature'";
      if (ends_with(entry, "/Normal stiffness"))
        return "it belongs to springs of the layout 'grid'";
      if (ends_with(entry, "/Sliding speed"))
        return "friction does not depend on speed here: its law is constant "
               "and 'Transverse slip term' is off, or 'Normal force' is 0";
      if (ends_with(entry, "/Friction slope") ||
          ends_with(entry, "/Normal force"))
        return "a slope of friction and the transverse slip term act by "
               "'Normal force', and one factor is 0 or the term is off";
      if (ends_with(entry, "/Friction coefficient"))
        return "no node of the contact slides, or its friction comes by "
               "another entry";
      return "nothing of the scene depends on it as it stands";
    }
  } // namespace



  void
  check_axes_of_sweep(const SweepGrid &grid, const ParametricSystem &system)
  {
    for (unsigned int a = 0; a < grid.n_axes(); ++a)
      {
        if (acts(grid, system, a))
          continue;
        const SceneParameters &scene = grid.scene(grid.spread(1).back());
        std::ostringstream     text;
        text << "Sweep/Axis " << grid.axis(a).name
             << ": neither mass nor damping nor stiffness changes from "
             << grid.value(a, grid.lower(a)) << " to "
             << grid.value(a, grid.upper(a));
        for (const std::string &entry : grid.axis(a).entries)
          text << "; '" << entry << "': " << reason_of(scene, entry);
        throw InputError(text.str());
      }
    for (unsigned int e = 0; e < grid.other_entries().size(); ++e)
      if (!acts_beside(grid, system, e))
        throw InputError(
          "Sweep: '" + grid.other_entries()[e] +
          "' is to be varied beside the axes, but neither mass nor damping nor "
          "stiffness changes with it: " +
          reason_of(grid.scene(grid.spread(1).back()),
                    grid.other_entries()[e]));
  }
} // namespace squeal
