// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_open_signs_h
#define squeal_output_open_signs_h

#include <squeal/output/cea_quantities.h>
#include <squeal/results/html_report.h>
#include <squeal/results/table.h>

#include <complex>
#include <string>
#include <vector>

namespace squeal
{
  /** Pairs of which the mesh does not tell whether they grow or decay: their
   * growth rate is no larger than its estimated error by the mesh. */
  struct OpenSigns
  {
    unsigned int n_growing = 0, n_decaying = 0;
    /** A clause with those that may grow fastest, or nothing: names,
     * frequencies, growth rates with that error. */
    std::string text;
    /** The list in that clause. */
    std::string pairs;
    /** Whether a pair is one of these, in the order of the pairs. */
    std::vector<bool> is_open;

    bool
    any() const
    {
      return n_growing + n_decaying > 0;
    }
  };

  /**
   * Of a table of pairs with the columns frequency_hz, sigma_per_s (1/s), name
   * and sigma_error_mesh_per_s. Rows without that error do not count, nor do
   * pairs whose error is rounding beside their frequency, as without damping
   * and friction.
   */
  OpenSigns open_signs(const Table &pairs);

  /** The same of pairs with @p names, @p errors being those of lambda by the
   * mesh, 1/s, NaN where they are not known. */
  OpenSigns open_signs(const ComplexPairs          &pairs,
                       const std::vector<ModeName> &names,
                       const Eigen::VectorXcd      &errors);

  /** Beside a verdict that nothing grows. */
  constexpr const char *growth_error_unknown =
    "the error of growth rates by the mesh is not estimated";

  /** Bodies without a mesh have no error of one; what a mesh did to matrices of
   * another program is not known. */
  bool has_mesh_error(const Model &model);

  /** Whether @p error, that of an eigenvalue by the mesh, is known, or there is
   * none to know. */
  bool is_growth_error_known(const Model               &model,
                             const std::complex<double> error);

  /** What the pairs of many models say together, those of all angles or
   * conditions, the places. */
  class GrowthOfMany
  {
  public:
    /** The places in words, "under conditions" or "at angles"; @p is_complete:
     * no pair of the bands is missing. */
    GrowthOfMany(const std::string &preposition,
                 const std::string &noun,
                 const bool         is_complete)
      : preposition(preposition)
      , noun(noun)
      , is_complete(is_complete)
    {
    }

    /** @p is_estimated: the errors of growth rates by the mesh are known, or
     * there is no mesh. @p outside tells what grows there beside the pairs,
     * text_of_growth_outside(); nothing where nothing does. */
    void add(const std::string &where,
             const OpenSigns   &open,
             const unsigned int n_unstable,
             const bool         is_estimated,
             const std::string &outside = "");

    /** At how many of the places growth is left open, with the pairs of the
     * first; nothing where it is at none. */
    std::string left_open() const;

    /** Clauses that a verdict is to be read with, each behind "; ": what
     * grows beside the pairs, is left open, not estimated, or may be missing.
     */
    std::string reservations() const;

    /** Bad where a pair grows whatever its error or something beside the pairs
     * grows, good where nothing may. */
    HtmlReport::Verdict verdict() const;

  private:
    std::string  preposition, noun;
    bool         is_complete;
    bool         all_estimated = true;
    unsigned int n_places = 0, n_open = 0, n_decided = 0, n_unstable_places = 0,
                 n_outside = 0;
    std::string first_open, first_outside;

    /** "at 2 of 3 angles ". */
    std::string at(const unsigned int n) const;
  };
} // namespace squeal

#endif
