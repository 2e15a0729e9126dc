// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/transient/contact_compliance.h>

#include <algorithm>
#include <sstream>

namespace squeal
{
  namespace
  {
    constexpr double largest_size = 4e9; // bytes
  }                                      // namespace



  ContactCompliance::ContactCompliance(const ShiftedInverse     &inv,
                                       std::vector<unsigned int> r,
                                       const unsigned int        n)
    : inverse(inv)
    , rows(std::move(r))
    , n_unknowns(n)
  {
    const double size = 8. * rows.size() * rows.size();
    if (size <= largest_size)
      return;
    std::ostringstream text;
    text << "Transient/Disc frame: corotating with 'Integrator = implicit' "
            "would keep the flexibility between "
         << rows.size() << " unknowns round the disc, " << size * 1e-9
         << " GB: use a coarser target or 'Integrator = explicit'";
    throw InputError(text.str());
  }

  const Eigen::VectorXd &
  ContactCompliance::column(const unsigned int row)
  {
    const auto found = columns.find(row);
    if (found != columns.end())
      return found->second;
    Block unit               = Block::Zero(n_unknowns, 1);
    unit(row, 0)             = 1.;
    const Block     response = inverse.solve(unit);
    Eigen::VectorXd kept(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      kept[i] = response(rows[i], 0);
    return columns.emplace(row, std::move(kept)).first->second;
  }



  Eigen::MatrixXd
  ContactCompliance::product(const Functionals &B)
  {
    // The unknowns at hand: their places among all.
    std::map<unsigned int, unsigned int> number;
    for (const auto &row : B.rows())
      for (const auto &[unknown, weight] : row)
        number.emplace(unknown, 0);
    std::vector<unsigned int> places;
    for (auto &[unknown, k] : number)
      {
        k = places.size();
        places.push_back(std::lower_bound(rows.begin(), rows.end(), unknown) -
                         rows.begin());
      }
    Eigen::MatrixXd S(places.size(), places.size());
    for (const auto &[unknown, k] : number)
      {
        const Eigen::VectorXd &all = column(unknown);
        for (std::size_t i = 0; i < places.size(); ++i)
          S(i, k) = all[places[i]];
      }
    std::vector<Eigen::Triplet<double>> entries;
    for (unsigned int r = 0; r < B.n_rows(); ++r)
      for (const auto &[unknown, weight] : B.rows()[r])
        entries.emplace_back(r, number.at(unknown), weight);
    Eigen::SparseMatrix<double, Eigen::RowMajor> at_hand(B.n_rows(),
                                                         places.size());
    at_hand.setFromTriplets(entries.begin(), entries.end());
    const Eigen::MatrixXd moved = at_hand * S;
    return at_hand * moved.transpose();
  }

  unsigned int
  ContactCompliance::n_columns() const
  {
    return columns.size();
  }
} // namespace squeal
