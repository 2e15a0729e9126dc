// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/output/open_signs.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace squeal
{
  namespace
  {
    /** Of |lambda|; an error below it is rounding. */
    constexpr double rounding_of_rates = 1e-8;
    /** So many pairs are named. */
    constexpr std::size_t most_named = 3;
  } // namespace



  OpenSigns
  open_signs(const Table &pairs)
  {
    struct Open
    {
      std::size_t row;
      double      sigma, error;
    };
    std::vector<Open> open;
    OpenSigns         result;
    for (std::size_t i = 0; i < pairs.n_rows(); ++i)
      {
        if (pairs.is_missing(i, "sigma_error_mesh_per_s"))
          continue;
        const double sigma = pairs.real(i, "sigma_per_s"),
                     error = std::abs(pairs.real(i, "sigma_error_mesh_per_s")),
                     size  = 2. * M_PI * pairs.real(i, "frequency_hz");
        if (!(error > rounding_of_rates * size) || error < std::abs(sigma))
          continue;
        open.push_back({i, sigma, error});
        ++(sigma > 0. ? result.n_growing : result.n_decaying);
      }
    if (open.empty())
      return result;
    std::stable_sort(
      open.begin(), open.end(), [](const auto &a, const auto &b) {
        return a.sigma + a.error > b.sigma + b.error;
      });
    result.text = "the mesh leaves open whether " +
                  std::string(open.size() == 1
                                ? "1 pair grows"
                                : std::to_string(open.size()) + " pairs grow") +
                  ": ";
    for (std::size_t k = 0; k < std::min(open.size(), most_named); ++k)
      result.text += (k == 0 ? "" : "; ") + pairs.text(open[k].row, "name") +
                     " at " +
                     rounded_text(pairs.real(open[k].row, "frequency_hz"), 5) +
                     " Hz, sigma " + rounded_text(open[k].sigma, 4) + " +- " +
                     rounded_text(open[k].error, 2) + " 1/s";
    if (open.size() > most_named)
      result.text +=
        "; and " + std::to_string(open.size() - most_named) + " more";
    return result;
  }
} // namespace squeal
