// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/mass_basis.h>
#include <squeal/transient/statics_by_part.h>

#include "sliding_flexibility.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace squeal
{
  namespace
  {
    /** Numbers that are the same but for rounding. */
    constexpr double rounding_of_ratio = 1e-12;

    /** Right-hand sides of one solve. */
    constexpr Eigen::Index responses_at_once = 128;

    /** Statics go by the symmetric parts, as the undamped pencil does. */
    bool
    counts_in_statics(const AffineTerm &term, const TermCoefficients &c)
    {
      return term.matrix->is_symmetric() && (c.mass != 0. || c.stiffness != 0.);
    }

    /** The number of the set that each of @p n things belongs to, where
     * @p are_joined tells of two of them whether they do. */
    template <typename Joined>
    std::vector<unsigned int>
    joined_sets(const unsigned int n, const Joined &are_joined)
    {
      std::vector<unsigned int> set(n);
      std::iota(set.begin(), set.end(), 0u);
      for (unsigned int i = 0; i < n; ++i)
        for (unsigned int j = 0; j < i; ++j)
          if (are_joined(i, j) && set[i] != set[j])
            std::replace(set.begin(), set.end(), set[i], set[j]);
      return set;
    }

    bool
    pairs_slide_alike(const ContactNodes &a, const ContactNodes &b)
    {
      return std::equal(a.pairs().begin(),
                        a.pairs().end(),
                        b.pairs().begin(),
                        b.pairs().end(),
                        [](const ContactPair &one, const ContactPair &other) {
                          return one.slides() == other.slides() &&
                                 one.n_nodes() == other.n_nodes();
                        });
    }
  } // namespace



  StaticsByPart::StaticsByPart(const AffineSystem    &s,
                               const SceneParameters &scene,
                               const ReductionBasis  &basis,
                               const double           cut_off,
                               const ContactNodes    &nodes,
                               const Block           &loads)
    : system(s)
    , contact_nodes(nodes)
    , solved_loads(loads)
  {
    for (const AffineTerm &term : system.terms)
      coefficients.push_back(term.coefficients(scene));
    find_parts();

    const Pencil           pencil(system, scene);
    const RowSpace        &space = *system.space;
    const ResidualResponse residual(pencil, basis, shift_of_sliding * cut_off);
    const Functionals      B = contact_nodes.relative_motion();
    const Eigen::Index     n_free =
      (basis.omega_squared.array() == 0.).cast<int>().sum();
    const auto free    = basis.shapes.leftCols(n_free);
    const auto elastic = basis.shapes.rightCols(basis.shapes.cols() - n_free);
    participation      = B.apply(Block(free));
    modal_loads        = inner_products(space, free, loads);
    const Eigen::VectorXd compliance =
      basis.omega_squared.tail(elastic.cols()).cwiseInverse();
    const auto of_modes = [&](const Block &forces) -> Block {
      return elastic *
             (compliance.asDiagonal() * inner_products(space, elastic, forces));
    };

    const SlidingFlexibility     sliding(contact_nodes);
    const Eigen::MatrixXd        unit = sliding.forces();
    std::vector<Eigen::MatrixXd> columns(
      parts.size(), Eigen::MatrixXd(unit.rows(), unit.cols()));
    for (Eigen::Index first = 0; first < unit.cols();
         first += responses_at_once)
      {
        const Eigen::Index m = std::min(responses_at_once, unit.cols() - first);
        const Block        f =
          B.apply_transposed(Eigen::MatrixXd(unit.middleCols(first, m)));
        const auto moved =
          motions_of_parts(B, residual.approximate(f) + of_modes(f));
        for (std::size_t b = 0; b < parts.size(); ++b)
          columns[b].middleCols(first, m) = moved[b];
      }
    const auto by_loads =
      motions_of_parts(B, residual(loads) + of_modes(loads));
    for (std::size_t b = 0; b < parts.size(); ++b)
      parts[b] = {sliding.complete(columns[b]), by_loads[b]};
  }



  void
  StaticsByPart::find_parts()
  {
    const RowSpace    &space   = *system.space;
    const unsigned int n_terms = system.terms.size();
    const Block        one     = Block::Ones(space.n_owned(), 1);
    Block              touched = Block::Zero(space.n_owned(), n_terms);
    for (unsigned int t = 0; t < n_terms; ++t)
      if (counts_in_statics(system.terms[t], coefficients[t]))
        touched.col(t) =
          (system.terms[t].matrix->multiply_absolute(one).array() != 0.)
            .cast<double>();
    const Eigen::MatrixXd common = inner_products(space, touched, touched);
    part_of_term =
      joined_sets(n_terms, [&](const unsigned int i, const unsigned int j) {
        return common(i, j) > 0.;
      });
    std::vector<unsigned int> number(n_terms, 0);
    unsigned int              n_parts = 0;
    for (unsigned int t = 0; t < n_terms; ++t)
      if (part_of_term[t] == t)
        number[t] = n_parts++;
    for (unsigned int &part : part_of_term)
      part = number[part];
    parts.resize(n_parts);
    part_of_row.assign(space.n_owned(), 0);
    for (unsigned int t = 0; t < n_terms; ++t)
      for (unsigned int i = 0; i < space.n_owned(); ++i)
        if (touched(i, t) != 0.)
          part_of_row[i] = part_of_term[t];
  }

  std::vector<Eigen::MatrixXd>
  StaticsByPart::motions_of_parts(const Functionals &B, const Block &x) const
  {
    std::vector<Eigen::MatrixXd> result;
    for (std::size_t b = 0; b < parts.size(); ++b)
      {
        Block own = x;
        for (std::size_t i = 0; i < part_of_row.size(); ++i)
          if (part_of_row[i] != b)
            own.row(i).setZero();
        result.push_back(B.apply(own));
      }
    return result;
  }



  std::optional<std::vector<double>>
  StaticsByPart::stiffness_ratios(const SceneParameters &scene) const
  {
    std::vector<std::optional<double>> ratio(parts.size());
    for (std::size_t t = 0; t < system.terms.size(); ++t)
      {
        const TermCoefficients &old   = coefficients[t];
        const TermCoefficients  other = system.terms[t].coefficients(scene);
        const double            k     = old.stiffness.real();
        if (!system.terms[t].matrix->is_symmetric())
          continue;
        if (other.mass != old.mass)
          return std::nullopt;
        if (k == 0. && other.stiffness.real() == 0.)
          continue;
        const double           r   = other.stiffness.real() / k;
        std::optional<double> &own = ratio[part_of_term[t]];
        if (!own)
          own = r;
        if (!(r > 0. && std::isfinite(r) &&
              std::abs(r - *own) <= rounding_of_ratio * *own))
          return std::nullopt;
      }
    std::vector<double> result;
    for (const std::optional<double> &r : ratio)
      result.push_back(r.value_or(1.));
    return result;
  }

  std::optional<Eigen::VectorXd>
  StaticsByPart::load_ratios(const Block &loads) const
  {
    if (loads.cols() != solved_loads.cols())
      return std::nullopt;
    const RowSpace       &space = *system.space;
    const Eigen::MatrixXd own   = inner_products(space, solved_loads, loads),
                          old =
                            inner_products(space, solved_loads, solved_loads);
    Eigen::VectorXd ratio(loads.cols());
    for (Eigen::Index l = 0; l < loads.cols(); ++l)
      ratio[l] = old(l, l) > 0. ? own(l, l) / old(l, l) : 0.;
    const Eigen::VectorXd sizes = space.norms(loads),
                          rest  = space.norms(
                            Block(loads - solved_loads * ratio.asDiagonal()));
    for (Eigen::Index l = 0; l < loads.cols(); ++l)
      if (!(rest[l] <= rounding_of_ratio * sizes[l]))
        return std::nullopt;
    return ratio;
  }



  std::optional<ReducedContactModel>
  StaticsByPart::at(const SceneParameters &scene,
                    const Block           &loads,
                    const ContactNodes    &nodes) const
  {
    const auto stiffness = stiffness_ratios(scene);
    const auto size      = load_ratios(loads);
    if (!stiffness || !size || !pairs_slide_alike(contact_nodes, nodes))
      return std::nullopt;
    ReducedContactModel model;
    const Eigen::Index  n_free = participation.cols(),
                       n_rows  = participation.rows();
    model.cut_off              = 0.;
    model.omega_squared        = Eigen::VectorXd::Zero(n_free);
    model.damping              = Eigen::VectorXd::Zero(n_free);
    model.participation        = participation;
    model.load                 = modal_loads * *size;
    model.flexibility          = Eigen::MatrixXd::Zero(n_rows, n_rows);
    model.load_motion          = Eigen::VectorXd::Zero(n_rows);
    for (std::size_t b = 0; b < parts.size(); ++b)
      {
        model.flexibility += parts[b].flexibility / (*stiffness)[b];
        model.load_motion += parts[b].load_motion * *size / (*stiffness)[b];
      }
    model.flexibility.diagonal() += nodes.compliance();
    model.initial_gap = Eigen::VectorXd::Zero(nodes.n_nodes());
    model.speed_ratio = nodes.speed_ratio();
    model.turn_back(nodes.turned_back_from(contact_nodes));
    return model;
  }
} // namespace squeal
