// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/checksum.h>
#include <squeal/eigen/mass_basis.h>
#include <squeal/transient/saved_modes.h>

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <random>

namespace squeal
{
  namespace
  {
    constexpr Eigen::Index n_loads = 64, loads_at_once = 16;

    /** Motions whose frequencies differ by a smaller share may be mixed: modes
     * are known to some 1e-10 over the share that parts them from others. The
     * smaller ones serve where modes lie so close that a cluster is too large.
     */
    constexpr double shares_of_cluster[] = {1e-3, 1e-4, 1e-5};

    /** So many can be told apart by the loads with a good condition. */
    constexpr Eigen::Index largest_cluster = n_loads / 2;

    /** How closely the motions must be combinations of the others, and their
     * frequencies the same. */
    constexpr double closeness = 1e-6;

    /** Adds the clusters of the motions from @p first to @p end, of ascending
     * frequencies: the first motion of each and how many it has. */
    void
    add_clusters(const double           share,
                 const Eigen::VectorXd &omega_squared,
                 const Eigen::Index     first,
                 const Eigen::Index     end,
                 std::vector<std::pair<Eigen::Index, Eigen::Index>> &clusters)
    {
      for (Eigen::Index k = first; k < end; ++k)
        if (k > first &&
            std::sqrt(omega_squared[k]) - std::sqrt(omega_squared[k - 1]) <=
              share * std::sqrt(omega_squared[k]))
          ++clusters.back().second;
        else
          clusters.emplace_back(k, 1);
    }

    /** The rotation that makes @p now the nearest to @p then, columns of which
     * are shares of the loads; empty where that is not near. */
    Eigen::MatrixXd
    rotation_of(const Eigen::MatrixXd &now, const Eigen::MatrixXd &then)
    {
      if (now.cols() > largest_cluster)
        return {};
      const Eigen::MatrixXd combination =
        now.jacobiSvd(Eigen::ComputeThinU | Eigen::ComputeThinV).solve(then);
      const Eigen::JacobiSVD<Eigen::MatrixXd> polar(
        combination, Eigen::ComputeFullU | Eigen::ComputeFullV);
      const Eigen::MatrixXd rotation =
        polar.matrixU() * polar.matrixV().transpose();
      if (!((now * rotation - then).norm() <= closeness * then.norm()))
        return {};
      return rotation;
    }

    /** Block by block, of clusters by @p share; empty where the motions are none
     * of the same. */
    Eigen::MatrixXd
    rotation_of(const SavedModes &now,
                const SavedModes &then,
                const double      share)
    {
      const Eigen::Index n = now.omega_squared.size();
      if (then.omega_squared.size() != n || then.n_modes != now.n_modes ||
          then.shares.rows() != now.shares.rows() || then.shares.cols() != n)
        return {};
      for (Eigen::Index k = 0; k < n; ++k)
        if (!(std::abs(now.omega_squared[k] - then.omega_squared[k]) <=
              closeness * then.omega_squared[k]))
          return {};
      std::vector<std::pair<Eigen::Index, Eigen::Index>> clusters;
      add_clusters(share, now.omega_squared, 0, now.n_modes, clusters);
      add_clusters(share, now.omega_squared, now.n_modes, n, clusters);
      Eigen::MatrixXd rotation = Eigen::MatrixXd::Zero(n, n);
      for (const auto &[first, size] : clusters)
        {
          const Eigen::MatrixXd block =
            rotation_of(now.shares.middleCols(first, size),
                        then.shares.middleCols(first, size));
          if (block.size() == 0)
            return {};
          rotation.block(first, first, size, size) = block;
        }
      return rotation;
    }
  } // namespace



  std::string
  SavedModes::checksum() const
  {
    std::string bytes;
    for (const Eigen::MatrixXd &values :
         {Eigen::MatrixXd(omega_squared), shares})
      bytes.append(reinterpret_cast<const char *>(values.data()),
                   values.size() * sizeof(double));
    return checksum_of(bytes);
  }

  NamedNumbers
  SavedModes::numbers() const
  {
    NamedNumbers result;
    result.set("omega_squared", Eigen::MatrixXd(omega_squared));
    result.set("n_modes", n_modes);
    result.set("shares", shares);
    return result;
  }

  std::optional<SavedModes>
  SavedModes::from_numbers(const NamedNumbers &numbers)
  {
    if (numbers.all().empty())
      return std::nullopt;
    SavedModes         result;
    const Eigen::Index n      = numbers.get("omega_squared").size();
    const Eigen::Index n_kept = numbers.get("shares").size();
    result.omega_squared      = numbers.vector("omega_squared", n);
    result.n_modes            = numbers.count("n_modes", n);
    result.shares = numbers.matrix("shares", n > 0 ? n_kept / n : 0, n);
    return result;
  }



  SavedModes
  saved_modes(const ReductionBasis &basis, const RowSpace &space)
  {
    SavedModes result;
    result.omega_squared = basis.omega_squared;
    result.n_modes       = basis.n_modes;
    result.shares.resize(n_loads, basis.shapes.cols());
    std::mt19937_64                        generator(space.first_owned());
    std::uniform_real_distribution<double> between(-1., 1.);
    for (Eigen::Index first = 0; first < n_loads; first += loads_at_once)
      {
        const Block loads = Block::NullaryExpr(
          space.n_owned(), loads_at_once, [&]() { return between(generator); });
        result.shares.middleRows(first, loads_at_once) =
          inner_products(space, loads, basis.shapes);
      }
    return result;
  }

  bool
  turn_into(ReductionBasis   &basis,
            const SavedModes &saved,
            const Pencil     &pencil)
  {
    const SavedModes now = saved_modes(basis, *pencil.space());
    Eigen::MatrixXd  rotation;
    for (const double share : shares_of_cluster)
      if (rotation.size() == 0)
        rotation = rotation_of(now, saved, share);
    if (rotation.size() == 0)
      return false;
    basis.shapes        = Block(basis.shapes * rotation);
    basis.mass_shapes   = Block(basis.mass_shapes * rotation);
    basis.omega_squared = saved.omega_squared;
    return true;
  }
} // namespace squeal
