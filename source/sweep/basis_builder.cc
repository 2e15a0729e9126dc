// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/memory.h>
#include <squeal/base/number_text.h>
#include <squeal/base/timers.h>
#include <squeal/base/worst_of.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/eigen/free_motion.h>
#include <squeal/eigen/hidden_directions.h>
#include <squeal/sweep/basis_builder.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;

    /** Relative shift of an eigenvalue below which a direction is left out. */
    constexpr double smallest_direction = 1e-14;

    /** The basis before the last round is to be this much better than the
     * tolerance: with that round it can judge its leading part. */
    constexpr double judge_quality = 0.1;

    /** Real columns that span the complex ones; a column that is real but for
     * a common phase gives one, others two. */
    Block
    real_columns(const RowSpace &space, ComplexBlock Z)
    {
      Eigen::MatrixXcd squares(1, Z.cols());
      Eigen::MatrixXd  sums(4, Z.cols());
      const auto       sum_squares = [&]() {
        for (Eigen::Index j = 0; j < Z.cols(); ++j)
          {
            const Complex s = Z.col(j).cwiseProduct(Z.col(j)).sum();
            sums.col(j) << s.real(), s.imag(), Z.col(j).real().squaredNorm(),
              Z.col(j).imag().squaredNorm();
          }
        space.sum(sums);
      };
      sum_squares();
      for (Eigen::Index j = 0; j < Z.cols(); ++j)
        if (const Complex s(sums(0, j), sums(1, j)); s != 0.)
          Z.col(j) /= std::sqrt(s / std::abs(s));
      sum_squares();
      Block        result(Z.rows(), 2 * Z.cols());
      Eigen::Index n = 0;
      for (Eigen::Index j = 0; j < Z.cols(); ++j)
        {
          result.col(n++) = Z.col(j).real();
          if (sums(3, j) > 1e-16 * sums(2, j))
            result.col(n++) = Z.col(j).imag();
        }
      result.conservativeResize(Eigen::NoChange, n);
      return result;
    }

    /** Names the fastest motion that grows beyond the band, which may be what
     * a basis does not come to terms with; empty where none does. */
    std::string
    text_of_growth_beyond(const std::vector<ComplexPairs> &all,
                          const double                     highest)
    {
      Complex fastest = 0.;
      for (const ComplexPairs &pairs : all)
        for (const Complex l : pairs.lambda)
          if (grows_beyond_band(l, highest) && l.real() > fastest.real())
            fastest = l;
      return fastest == 0.
               ? ""
               : "; a motion at " +
                   rounded_text(fastest.imag() / (2. * M_PI), 5) +
                   " Hz grows by about " + rounded_text(fastest.real(), 3) +
                   " 1/s there, faster than the band vibrates";
    }
  } // namespace



  struct BasisBuilder::Anchor
  {
    SweepPoint                    point;
    std::vector<TermCoefficients> coefficients;
    Pencil                        pencil;
    ShiftedInverse                inverse;
    SlidingInverse                sliding;

    Anchor(const ParametricSystem &system,
           const SweepPoint       &p,
           const double            shift,
           const FactorStorage    &storage)
      : point(p)
      , coefficients(system.coefficients(p))
      , pencil(system.merged(), system.grid().scene(p))
      , inverse(pencil, shift, storage)
      , sliding(unmerged(system, p), inverse)
    {
    }

    static Pencil
    unmerged(const ParametricSystem &system, const SweepPoint &p)
    {
      return Pencil::unmerged(system.merged(), system.grid().scene(p));
    }
  };



  namespace
  {
    /** What the modes do not carry at a point of the box. */
    template <typename Anchor>
    void
    extend_by_hidden(const Pencil &at_point,
                     const Anchor &anchor,
                     const Pencil &reference,
                     ReducedBasis &basis)
    {
      const SlidingInverse inverse(at_point, anchor.sliding);
      HiddenSearch{
        at_point, inverse, std::sqrt(anchor.inverse.shift()), reference}
        .extend(basis);
    }
  } // namespace



  BasisBuilder::BasisBuilder(const ParametricSystem &s, const BasisOptions &o)
    : system(s)
    , options(o)
    , reference(
        Pencil::unmerged(s.merged(), s.grid().scene(s.grid().spread(1).back())))
    , reduced(reference)
  {
    for (const auto &part : reference.parts())
      symmetric.push_back(part.symmetric);
    const SweepGrid &grid = system.grid();
    training              = grid.spread(70);
    for (const auto &point : grid.state_representatives())
      training.push_back(point);
    training_errors.assign(training.size(), 1.);
  }

  BasisBuilder::~BasisBuilder() = default;

  const std::vector<BasisRound> &
  BasisBuilder::history() const
  {
    return rounds;
  }

  const std::vector<std::unique_ptr<BasisBuilder::Anchor>> &
  BasisBuilder::anchors() const
  {
    return anchor_list;
  }

  unsigned int
  BasisBuilder::n_factors_on_disk() const
  {
    return std::count_if(
      anchor_list.begin(), anchor_list.end(), [](const auto &anchor) {
        return anchor->inverse.place() == FactorPlace::disk;
      });
  }

  const std::vector<SweepPoint> &
  BasisBuilder::training_points() const
  {
    return training;
  }

  Eigen::Map<const Block>
  BasisBuilder::vectors() const
  {
    return reduced.vectors();
  }



  double
  BasisBuilder::distance(const std::vector<TermCoefficients> &a,
                         const std::vector<TermCoefficients> &b) const
  {
    double result = 0.;
    for (std::size_t i = 0; i < a.size(); ++i)
      {
        // The inverses follow the contact states.
        if (!symmetric[i] || system.is_switched(i))
          continue;
        const auto add = [&](const double x, const double y) {
          if (x * y > 0.)
            result = std::max(result, std::abs(std::log10(x / y)));
          else if (x != y)
            result = std::max(result, 1.);
        };
        add(a[i].stiffness.real(), b[i].stiffness.real());
        add(a[i].mass, b[i].mass);
      }
    return result;
  }

  BasisBuilder::Anchor &
  BasisBuilder::add_anchor(const SweepPoint &point)
  {
    const double omega = 2. * M_PI * options.band.highest;
    anchor_list.push_back(std::make_unique<Anchor>(
      system, point, omega * omega, options.factor_storage));
    return_freed_memory();
    return *anchor_list.back();
  }

  BasisBuilder::Anchor &
  BasisBuilder::anchor_for(const SweepPoint &point)
  {
    const auto coefficients = system.coefficients(point);
    Anchor    *best         = nullptr;
    double     nearest      = options.anchor_spacing;
    for (auto &anchor : anchor_list)
      if (const double d = distance(coefficients, anchor->coefficients);
          d <= nearest)
        {
          nearest = d;
          best    = anchor.get();
        }
    return best ? *best : add_anchor(point);
  }



  Block
  BasisBuilder::responses(const PairResiduals    &residuals,
                          const Eigen::VectorXcd &lambda,
                          const SlidingInverse   &inverse,
                          const bool              transposed) const
  {
    const RowSpace &space = *reference.space();
    // r^T S r of these is the relative shift of the eigenvalue.
    ComplexBlock weighted = residuals.vectors;
    for (Eigen::Index j = 0; j < weighted.cols(); ++j)
      weighted.col(j) *= weight_of(lambda[j]) / std::sqrt(2.);
    const Block R = real_columns(space, weighted);
    const Block E = transposed ? inverse.solve_transposed(R) : inverse.solve(R);
    Eigen::MatrixXd gram = inner_products(space, R, E);
    gram                 = 0.5 * (gram + gram.transpose()).eval();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(gram);
    Eigen::MatrixXd kept(gram.rows(), gram.rows());
    Eigen::Index    n = 0;
    for (Eigen::Index i = 0; i < gram.rows(); ++i)
      if (const double v = std::abs(solver.eigenvalues()[i]);
          v > smallest_direction)
        kept.col(n++) = solver.eigenvectors().col(i) / std::sqrt(v);
    return E * kept.leftCols(n);
  }

  Block
  BasisBuilder::corrections(const SweepPoint &point)
  {
    const auto         coefficients = system.coefficients(point);
    const Anchor      &anchor       = anchor_for(point);
    const ComplexPairs pairs =
      solve_point_in_full(model, coefficients, options.band);
    if (pairs.size() == 0)
      return Block(reference.space()->n_owned(), 0);
    const SlidingInverse inverse(
      Pencil::unmerged(system.merged(), system.grid().scene(point)),
      anchor.sliding);
    const Block right = responses(
      reduced.residuals(coefficients, pairs.lambda, pairs.right, false),
      pairs.lambda,
      inverse,
      false);
    const Block left =
      responses(reduced.residuals(coefficients, pairs.lambda, pairs.left, true),
                pairs.lambda,
                inverse,
                true);
    Block both(right.rows(), right.cols() + left.cols());
    both << right, left;
    return both;
  }



  void
  BasisBuilder::update_model(const unsigned int n_basis)
  {
    model.parts.clear();
    for (const auto &part : reduced.parts())
      model.parts.push_back(part.matrix);
    model.n_basis = n_basis;
  }

  std::vector<SweepPoint>
  BasisBuilder::choose_points(const unsigned int round)
  {
    // The first rounds look everywhere; later ones where the errors are, but
    // not twice at one place.
    std::vector<std::size_t> order(training.size());
    std::iota(order.begin(), order.end(), 0);
    if (round > 0)
      std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) {
        return training_errors[a] > training_errors[b];
      });
    const SweepGrid        &grid = system.grid();
    std::vector<SweepPoint> result;
    for (double apart = 0.12; result.size() < options.points_per_round;
         apart *= 0.5)
      {
        for (const std::size_t i : order)
          {
            bool is_new = result.size() < options.points_per_round;
            for (const auto &other : result)
              {
                double d = 0.;
                for (unsigned int a = 0; a < grid.n_axes(); ++a)
                  if (grid.upper(a) > grid.lower(a))
                    d = std::max(d,
                                 std::abs(other[a] - training[i][a]) /
                                   (grid.upper(a) - grid.lower(a)));
                is_new = is_new && d > apart;
              }
            if (is_new)
              result.push_back(training[i]);
          }
        if (apart < 1e-6)
          break;
      }
    return result;
  }

  void
  BasisBuilder::evaluate_training()
  {
    BasisRound round{
      model.n_basis, static_cast<unsigned int>(anchor_list.size()), {}};
    snapshots.clear();
    for (std::size_t i = 0; i < training.size(); ++i)
      {
        // What lies below the band is not asked for, but a basis without it
        // has eigenvalues inside the band that stand for it.
        WorstError own;
        snapshots.push_back(solve_point(model,
                                        system.coefficients(training[i]),
                                        {0., options.band.highest},
                                        true));
        std::vector<int> inside;
        for (unsigned int j = 0; j < snapshots.back().size(); ++j)
          if (snapshots.back().frequency(j) >= options.band.lowest)
            inside.push_back(j);
        add_to_worst(select_pairs(snapshots.back(), inside), training[i], own);
        training_errors[i]   = own.relative;
        round.worst.relative = worst_of(round.worst.relative, own.relative);
        if (is_worse(own.frequency, round.worst.frequency))
          {
            round.worst.frequency    = own.frequency;
            round.worst.frequency_at = training[i];
          }
        if (is_worse(own.sigma, round.worst.sigma))
          {
            round.worst.sigma    = own.sigma;
            round.worst.sigma_at = training[i];
          }
      }
    rounds.push_back(round);
  }



  void
  BasisBuilder::check_inertia()
  {
    for (const auto &anchor : anchor_list)
      {
        const unsigned int found = n_modes_below(model.parts,
                                                 anchor->coefficients,
                                                 symmetric,
                                                 anchor->inverse.shift());
        if (found == anchor->inverse.n_modes_below())
          continue;
        // Modes that no residual asked for: all of them, from this factor.
        ModeOptions mode_options;
        mode_options.tolerance = options.mode_tolerance;
        const UndampedModes modes =
          undamped_modes(anchor->pencil, anchor->inverse, mode_options);
        reduced.extend(modes.shapes);
        update_model(reduced.size());
      }
  }



  void
  BasisBuilder::require_held(const UndampedModes &modes,
                             const double         shift) const
  {
    if (options.band.lowest > 0.)
      return;
    // lambda = 0 is defective there: what it becomes is rounding. The parts may
    // have been read from files.
    const FreeMotions free = find_free_motions(
      anchor_list.front()->pencil, modes, shift, rounding_of_read_stiffness);
    if (free.shapes.cols() > 0)
      throw InputError(
        free.text() +
        ": raise Eigenvalues/Lowest frequency above 0, or hold the bodies by "
        "Scene/Supports or Scene/Springs");
  }



  ReducedModel
  BasisBuilder::build(const std::function<void(const BasisRound &)> &report,
                      const Block                                   &start)
  {
    const double start_seconds = cpu_seconds();
    {
      Anchor     &first = add_anchor(system.grid().spread(1).back());
      ModeOptions mode_options;
      mode_options.tolerance = options.mode_tolerance;
      const UndampedModes modes =
        undamped_modes(first.pencil, first.inverse, mode_options);
      require_held(modes, first.inverse.shift());
      reduced.extend(modes.shapes);
      reduced.extend(modes.supplement);
      for (const SweepPoint &point : system.grid().spread(1))
        extend_by_hidden(Anchor::unmerged(system, point),
                         anchor_for(point),
                         reference,
                         reduced);
      if (start.rows() == modes.shapes.rows())
        reduced.extend(start);
      update_model(reduced.size());
    }
    for (unsigned int round = 0;; ++round)
      {
        const unsigned int before      = reduced.size();
        const double       seconds_now = cpu_seconds() - start_seconds;
        for (const auto &point : choose_points(round))
          {
            reduced.extend(corrections(point));
            update_model(reduced.size());
          }
        check_inertia();
        update_model(before);
        evaluate_training();
        rounds.back().cpu_seconds = seconds_now;
        // Nothing left to add: the basis is all there is.
        if (reduced.size() == before)
          break;
        if (report)
          report(rounds.back());
        update_model(reduced.size());
        if (excess(rounds.back().worst, options) <= judge_quality)
          break;
        if (reduced.size() > options.maximum_basis ||
            round >= options.maximum_rounds)
          {
            std::ostringstream text;
            text << "the basis of the sweep has " << reduced.size()
                 << " vectors and still an error of "
                 << rounds.back().worst.relative
                 << ": raise Sweep/Maximum basis or narrow the ranges"
                 << text_of_growth_beyond(snapshots, options.band.highest);
            throw ComputationError(text.str());
          }
      }
    result.parts = model.parts;
    // Those of many contact states would be more than all the rest.
    for (std::size_t i = 0;
         system.grid().n_states() == 1 && i < result.parts.size();
         ++i)
      for (std::size_t j = i; j < result.parts.size(); ++j)
        result.grams.push_back(reduced.product_gram(i, j));
    result.cells = make_cells();
    for (auto &cell : result.cells)
      fit_cell(cell);
    return result;
  }
} // namespace squeal
