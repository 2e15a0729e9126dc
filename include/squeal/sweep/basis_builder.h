// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_sweep_basis_builder_h
#define squeal_sweep_basis_builder_h

#include <squeal/base/mumps.h>
#include <squeal/eigen/reduced_basis.h>
#include <squeal/eigen/sliding_inverse.h>
#include <squeal/sweep/parametric_system.h>
#include <squeal/sweep/point_solver.h>

#include <complex>
#include <functional>
#include <memory>
#include <vector>

namespace squeal
{
  struct BasisOptions
  {
    Band         band{0., 20e3};
    double       frequency_tolerance = 1e-6; /**< relative */
    double       sigma_tolerance     = 0.5;  /**< 1/s */
    double       mode_tolerance      = 1e-8; /**< of the first anchor's modes */
    unsigned int maximum_basis       = 2000;
    unsigned int maximum_rounds      = 40;
    unsigned int points_per_round    = 8;
    /** Decades by which a coefficient may differ from the nearest factor. */
    double anchor_spacing = 0.7;
    /** The same from one end of a cell to the other. */
    double cell_size = 0.15;
    /** Share of the tolerance that the bases of cells are chosen for. */
    double safety = 0.3;
    /** Where the factors may be; several are held at a time. */
    FactorStorage factor_storage = {};
  };

  /** Largest error of a set of pairs, and where it is. */
  struct WorstError
  {
    double     frequency = 0.; /**< over |lambda| / 2 pi */
    double     sigma     = 0.; /**< 1/s */
    double     relative  = 0.; /**< |dlambda| / |lambda| */
    SweepPoint frequency_at, sigma_at;
  };

  /** One round of the greedy iteration. */
  struct BasisRound
  {
    unsigned int basis_size; /**< before the round */
    unsigned int n_factors;
    WorstError   worst; /**< of that basis, from what the round added */
    double       cpu_seconds = 0.; /**< until that basis was there */
  };

  /**
   * Builds the certified basis of a parameter box by a greedy iteration.
   *
   * A few factors of the frictionless problem ("anchors"), placed where the
   * coefficients are far from those of the others, serve as inverses all over
   * the box, each with the friction of the point at hand. Every round solves
   * the reduced problem at the points with the largest errors, evaluates the
   * full residuals of the right and left vectors there, and adds the responses
   * to them. The shift of every eigenvalue of the training points by what a
   * round adds is the error of the basis before it. When the shifts are far
   * below the tolerance the basis is turned so that its leading vectors V reach
   * the tolerance; the rest, W, serves the error estimate of later solutions.
   */
  class BasisBuilder
  {
  public:
    BasisBuilder(const ParametricSystem &system, const BasisOptions &options);
    ~BasisBuilder();

    /** Starts with the vectors @p start of a box alike, such as that of the
     * same mesh with other dimensions, if there are as many rows. Throws
     * ComputationError where the tolerance is not met within the allowed rounds
     * or vectors. */
    ReducedModel build(
      const std::function<void(const BasisRound &)> &report = {},
      const Block                                   &start  = Block());

    const std::vector<BasisRound> &history() const;

    /** The common basis of the result of build(). */
    Eigen::Map<const Block> vectors() const;
    /** Frequencies of the anchors' factors: what is proven complete. */
    struct Anchor;
    const std::vector<std::unique_ptr<Anchor>> &anchors() const;
    /** How many of their factors are on disk. */
    unsigned int n_factors_on_disk() const;
    /** Points that the errors are judged at while building. */
    const std::vector<SweepPoint> &training_points() const;

  private:
    Anchor &anchor_for(const SweepPoint &point);
    Anchor &add_anchor(const SweepPoint &point);
    double  distance(const std::vector<TermCoefficients> &a,
                     const std::vector<TermCoefficients> &b) const;
    /** Responses to the residuals at a point: right, then left ones. */
    Block                   corrections(const SweepPoint &point);
    Block                   responses(const PairResiduals    &residuals,
                                      const Eigen::VectorXcd &lambda,
                                      const SlidingInverse   &inverse,
                                      const bool              transposed) const;
    void                    update_model(const unsigned int n_basis);
    std::vector<SweepPoint> choose_points(const unsigned int round);
    void                    evaluate_training();
    /** Reduced counts of modes against the inertia of the factors. */
    void check_inertia();
    /** Throws InputError where motions at 0 Hz belong to the band. */
    void require_held(const UndampedModes &modes, const double shift) const;
    std::vector<ModelCell> make_cells() const;
    /** Weight of an error of @p lambda: 1 / |lambda|, in s, at most that of a
     * hundredth of the lower end of the band. */
    double weight_of(const std::complex<double> lambda) const;
    /** Numbers of the training points in and around @p cell. */
    std::vector<unsigned int> training_near(const ModelCell &cell) const;
    /** Motions that nothing holds without friction, coordinates in the common
     * basis. */
    Eigen::MatrixXd free_motions(const SweepPoint &point) const;
    /** Orthonormal columns: the free motions, then the directions of the
     * snapshots @p own that shift eigenvalues by more than @p floor, relative
     * and squared, the most needed first. */
    Eigen::MatrixXd directions_of(const ModelCell                 &cell,
                                  const std::vector<unsigned int> &own,
                                  const double                     floor) const;
    /** Cuts the directions of @p cell to [V W] and sets the size of V; false
     * where they do not suffice. */
    bool choose_sizes(ModelCell                       &cell,
                      const std::vector<unsigned int> &own) const;
    void fit_cell(ModelCell &cell) const;
    /** K + omega^2 M of the symmetric parts, omega the end of the band. */
    Eigen::MatrixXd energy_matrix(const SweepPoint &point) const;

    const ParametricSystem              &system;
    const BasisOptions                   options;
    Pencil                               reference;
    std::vector<bool>                    symmetric;
    ReducedBasis                         reduced;
    LocalModel                           model;
    ReducedModel                         result;
    std::vector<std::unique_ptr<Anchor>> anchor_list;
    std::vector<SweepPoint>              training;
    std::vector<double>                  training_errors;
    std::vector<ComplexPairs>            snapshots; /**< of the last round */
    std::vector<BasisRound>              rounds;
  };

  /** Error over tolerance, the larger of frequency and sigma. */
  double excess(const WorstError &worst, const BasisOptions &options);

  /** Largest frequency and sigma errors of pairs with estimates. */
  void add_to_worst(const ComplexPairs &pairs,
                    const SweepPoint   &point,
                    WorstError         &worst);
} // namespace squeal

#endif
