// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_sweep_reduced_model_h
#define squeal_sweep_reduced_model_h

#include <squeal/discretization/affine_system.h>

#include <Eigen/Core>

#include <map>
#include <string>
#include <vector>

namespace squeal
{
  /** The affine parts on a basis [V W]: problems are solved in V, its first
   * n_basis vectors; W holds what is missing from V somewhere and serves the
   * error estimate alone. */
  struct LocalModel
  {
    std::vector<Eigen::MatrixXd> parts; /**< of [V W] */
    unsigned int                 n_basis = 0;

    unsigned int n_total() const;
  };

  /** A cell of the parameter box with a basis [V W] of its own. */
  struct ModelCell
  {
    Eigen::VectorXd lower, upper; /**< coordinates of the axes */
    Eigen::MatrixXd turn;         /**< [V W] in the common basis */
    LocalModel      local;

    bool contains(const Eigen::VectorXd &point, const double margin) const;
  };

  /**
   * All that the solution at a parameter point needs: the affine parts on the
   * common basis and, for each cell of the parameter box, the small basis that
   * its solutions need.
   */
  struct ReducedModel
  {
    std::vector<Eigen::MatrixXd> parts; /**< on the common basis */
    std::vector<ModelCell>       cells;
    /** (A V)^T (B V) of all pairs of parts, row by row of the upper triangle;
     * none where contact states change. */
    std::vector<Eigen::MatrixXd> grams;
    /** Quadratic forms x^H A x by name: twice the kinetic energy of a body over
     * |lambda|^2, ... */
    std::map<std::string, Eigen::MatrixXd> forms;
    /** Linear functionals of x by name, one a row: displacements at contact
     * points, coordinates of the names, ... */
    std::map<std::string, Eigen::MatrixXd> functionals;
    /** Numbers that are known of the full model, by name. */
    std::map<std::string, Eigen::MatrixXd> numbers;

    unsigned int n_total() const;
    /** Largest V of the cells. */
    unsigned int largest_basis() const;
    /** The cell of a point; the nearest one outside the box. */
    const ModelCell &cell_of(const Eigen::VectorXd &point) const;
    ModelCell       &cell_of(const Eigen::VectorXd &point);
    /** Projects the parts on the basis of a cell. */
    void project(ModelCell &cell) const;
  };

  /** Writes a sealed HDF5 file (see sealed_file.h) with a @p key that says what
   * the model depends on. Throws InputError where it cannot be written. */
  void write_reduced_model(const ReducedModel &model,
                           const std::string  &key,
                           const std::string  &file);

  /** The key of what write_reduced_model() wrote, of any format version. Throws
   * InputError for a file that squeal has not written or that is damaged. */
  std::string key_of_reduced_model(const std::string &file);

  /**
   * Reads what write_reduced_model() wrote. @p key receives that of the file.
   * Throws InputError for a file that squeal has not written, that is damaged
   * in any byte or of another format version.
   */
  ReducedModel read_reduced_model(const std::string &file, std::string &key);
} // namespace squeal

#endif
