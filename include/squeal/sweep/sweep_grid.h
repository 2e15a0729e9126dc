// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_sweep_sweep_grid_h
#define squeal_sweep_sweep_grid_h

#include <squeal/parameters/parameters.h>

#include <Eigen/Core>

#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  /** A place in the parameter box, one coordinate an axis. */
  using SweepPoint = Eigen::VectorXd;

  /** Value of an entry of a linear or logarithmic axis at the @p share, 0 to 1,
   * of the way: from its own From to its own To. */
  double entry_value(const SweepAxisParameters &axis,
                     const std::size_t          entry,
                     const double               share);

  /** Value of an entry of a list that has values of its own for each entry, at
   * the value @p value of the axis; straight between those that are listed. */
  double listed_value(const SweepAxisParameters &axis,
                      const std::size_t          entry,
                      const double               value);

  /**
   * The parameter box of a sweep and its grid of points.
   *
   * The coordinate of an axis is the common logarithm of its first entry's
   * value on a logarithmic axis and that value itself otherwise; other entries
   * of the axis follow by the same share of their own range.
   */
  class SweepGrid
  {
  public:
    /** Throws InputError where an entry is not a number of the scene. */
    explicit SweepGrid(const Parameters &parameters);
    ~SweepGrid();

    unsigned int               n_axes() const;
    const SweepAxisParameters &axis(const unsigned int a) const;
    bool                       is_logarithmic(const unsigned int a) const;
    const std::vector<double> &coordinates(const unsigned int a) const;
    /** Lowest and highest coordinate. */
    double lower(const unsigned int a) const;
    double upper(const unsigned int a) const;

    std::size_t n_points() const;
    /** The first axis runs fastest. */
    SweepPoint point(const std::size_t i) const;

    /** Value of the first entry of an axis at a coordinate. */
    double value(const unsigned int a, const double coordinate) const;
    /** Values of all entries of all axes, in order. */
    std::vector<double>      values(const SweepPoint &point) const;
    std::vector<std::string> entries() const;

    /** Contact states: the number of that of every point of the grid. Between
     * them that of the nearest point holds. */
    void set_states(std::vector<unsigned int> state_of_point);
    const std::vector<unsigned int> &states() const;
    unsigned int                     n_states() const;
    unsigned int state_number(const SweepPoint &point) const;
    /** A point of the grid for each state, in the middle of those it has. */
    std::vector<SweepPoint> state_representatives() const;

    /** The scene there; valid until the next call. */
    const SceneParameters &scene(const SweepPoint &point) const;

    /** Entries beside the axes whose influence is asked for. */
    const std::vector<std::string> &other_entries() const;
    /** The scene there with one of the entries() or other_entries(), counted
     * through both lists, multiplied by @p factor; valid until the next call.
     */
    const SceneParameters &scene(const SweepPoint  &point,
                                 const unsigned int entry,
                                 const double       factor) const;
    /** Value of that entry. */
    double entry_value(const SweepPoint &point, const unsigned int entry) const;

    /** Points spread over the box: its corners (of up to six axes), its
     * centre, and a low-discrepancy sequence; @p n in total at least. */
    std::vector<SweepPoint> spread(const std::size_t n) const;

  private:
    double share(const unsigned int a, const double coordinate) const;
    /** The scene of values, with the contact state of @p point. */
    const SceneParameters &scene(const std::vector<double> &all,
                                 const SweepPoint          &point) const;

    std::vector<SweepAxisParameters> axes;
    std::vector<std::vector<double>> grid;
    std::vector<std::string>         others;
    std::vector<double>              other_values;
    std::unique_ptr<NumberSetter>    setter;
    std::vector<unsigned int>        state_of; /**< empty: one state */
    mutable SceneParameters          scene_with_state;
  };

  /** A point in words, "mu = 0.3, log10_e_pad = 10.4". */
  std::string text_of(const SweepGrid &grid, const SweepPoint &point);
} // namespace squeal

#endif
