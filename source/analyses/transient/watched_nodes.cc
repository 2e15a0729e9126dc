// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/transient/watched_nodes.h>
#include <squeal/base/worst_of.h>

#include <algorithm>
#include <limits>

namespace squeal
{
  namespace
  {
    /** Nodes whose vibrations differ by less than this share are equally loud:
     * the first of them counts. */
    constexpr double equally_loud = 1e-6;

    /** At most @p most of @p points: the first one, and each time the one that
     * is farthest from those that are there. */
    std::vector<unsigned int>
    spread_over(const std::vector<dealii::Point<3>> &points,
                const unsigned int                   most)
    {
      std::vector<unsigned int> result;
      std::vector<double>       distances(points.size(),
                                    std::numeric_limits<double>::max());
      for (unsigned int next = 0; result.size() < most;)
        {
          result.push_back(next);
          for (std::size_t j = 0; j < points.size(); ++j)
            distances[j] =
              std::min(distances[j], points[j].distance(points[next]));
          const auto farthest =
            std::max_element(distances.begin(), distances.end());
          if (!(*farthest > 0.))
            break;
          next = farthest - distances.begin();
        }
      std::sort(result.begin(), result.end());
      return result;
    }

    /** How often the part of @p values that belongs to the stretches from
     * @p first to @p end changes its sign beside its slow part. */
    unsigned int
    crossings(const std::vector<double> &values,
              const std::size_t          first,
              const std::size_t          end)
    {
      const std::size_t         n = values.size();
      const std::vector<double> rest =
        without_slow_part({values.begin() + n * first / n_force_stretches,
                           values.begin() + n * end / n_force_stretches});
      unsigned int result = 0;
      for (std::size_t k = 1; k < rest.size(); ++k)
        result += (rest[k] > 0.) != (rest[k - 1] > 0.);
      return result;
    }
  } // namespace



  WatchedNodes::WatchedNodes(const ContactNodes &nodes)
  {
    for (const ContactPair &pair : nodes.pairs())
      for (const unsigned int j : spread_over(pair.geometry.points, most_nodes))
        numbers.push_back(pair.first + j);
    pieces.resize(numbers.size() * n_force_stretches);
  }



  void
  WatchedNodes::add_step(const Eigen::VectorXd &forces,
                         const unsigned int     stretch,
                         const bool             is_one_of_the_last)
  {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      {
        const double force = forces[3 * numbers[i]];
        join({1., force, 0., 0.}, pieces[i * n_force_stretches + stretch]);
        if (is_one_of_the_last)
          last_steps.push_back(force);
      }
  }

  void
  WatchedNodes::add_trigger_step(const Eigen::VectorXd &forces,
                                 const unsigned int     stretch)
  {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      join({1., forces[3 * numbers[i]], 0., 0.},
           trigger_pieces[i * n_trigger_stretches + stretch]);
  }

  void
  WatchedNodes::add_sample(const Eigen::VectorXd &forces)
  {
    for (const unsigned int j : numbers)
      samples.push_back(forces[3 * j]);
  }



  std::vector<double>
  WatchedNodes::series(const std::vector<double> &rows,
                       const std::size_t          i) const
  {
    std::vector<double> result;
    for (std::size_t k = i; k < rows.size(); k += numbers.size())
      result.push_back(rows[k]);
    return result;
  }

  std::vector<SignalPiece>
  WatchedNodes::pieces_of(const std::size_t  i,
                          const unsigned int first,
                          const unsigned int end) const
  {
    const auto begin = pieces.begin() + i * n_force_stretches;
    return {begin + first, begin + end};
  }

  double
  WatchedNodes::rms(const std::size_t  i,
                    const unsigned int first,
                    const unsigned int end) const
  {
    SignalPiece all;
    for (const SignalPiece &piece : pieces_of(i, first, end))
      join(piece, all);
    return rms_of(all);
  }



  NodeVibrations
  vibrations_of_nodes(const WatchedNodes &nodes,
                      const ContactPair  &pair,
                      const unsigned int  first,
                      const unsigned int  end)
  {
    NodeVibrations result;
    double         n_watched = 0., largest = 0.;
    for (std::size_t i = 0; i < nodes.numbers.size(); ++i)
      {
        const unsigned int j = nodes.numbers[i];
        if (j < pair.first || j >= pair.first + pair.n_nodes())
          continue;
        n_watched += 1.;
        const std::vector<double> rms =
          rms_beside_slow_part(nodes.pieces_of(i, first, end), 4);
        double most = 0.;
        for (unsigned int q = 0; q < 4; ++q)
          {
            result.all[q] += rms[q];
            most = worst_of(most, rms[q]);
          }
        if (most > (1. + equally_loud) * largest)
          {
            largest           = most;
            result.loudest    = i;
            result.of_loudest = rms;
          }
      }
    for (double &rms : result.all)
      rms *= n_watched > 0. ? pair.n_nodes() / n_watched : 0.;
    if (n_watched > 0.)
      result.n_crossings =
        crossings(nodes.series(nodes.samples, result.loudest), first, end);
    return result;
  }
} // namespace squeal
