// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/output/open_signs.h>
#include <squeal/results/open_growth.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace squeal
{
  namespace
  {
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
    result.is_open.assign(pairs.n_rows(), false);
    for (std::size_t i = 0; i < pairs.n_rows(); ++i)
      {
        if (pairs.is_missing(i, "sigma_error_mesh_per_s"))
          continue;
        const double sigma = pairs.real(i, "sigma_per_s"),
                     error = std::abs(pairs.real(i, "sigma_error_mesh_per_s"));
        if (!is_growth_open(sigma, error, pairs.real(i, "frequency_hz")))
          continue;
        open.push_back({i, sigma, error});
        result.is_open[i] = true;
        ++(sigma > 0. ? result.n_growing : result.n_decaying);
      }
    if (open.empty())
      return result;
    std::stable_sort(
      open.begin(), open.end(), [](const auto &a, const auto &b) {
        return a.sigma + a.error > b.sigma + b.error;
      });
    for (std::size_t k = 0; k < std::min(open.size(), most_named); ++k)
      result.pairs += (k == 0 ? "" : "; ") + pairs.text(open[k].row, "name") +
                      " at " +
                      rounded_text(pairs.real(open[k].row, "frequency_hz"), 5) +
                      " Hz, sigma " + rounded_text(open[k].sigma, 4) + " +- " +
                      rounded_text(open[k].error, 2) + " 1/s";
    if (open.size() > most_named)
      result.pairs +=
        "; and " + std::to_string(open.size() - most_named) + " more";
    result.text = "the mesh leaves open whether " +
                  std::string(open.size() == 1
                                ? "1 pair grows"
                                : std::to_string(open.size()) + " pairs grow") +
                  ": " + result.pairs;
    return result;
  }



  OpenSigns
  open_signs(const ComplexPairs          &pairs,
             const std::vector<ModeName> &names,
             const Eigen::VectorXcd      &errors)
  {
    Table table({{"frequency_hz", Table::Type::real, "Hz", ""},
                 {"sigma_per_s", Table::Type::real, "1/s", ""},
                 {"name", Table::Type::text, "", ""},
                 {"sigma_error_mesh_per_s", Table::Type::real, "1/s", ""}});
    for (unsigned int i = 0; i < pairs.size(); ++i)
      table.add_row({pairs.frequency(i),
                     pairs.sigma(i),
                     names[i].text,
                     or_missing(errors[i].real())});
    return open_signs(table);
  }



  bool
  has_mesh_error(const Model &model)
  {
    return !model.discretization() || model.discretization()->has_mesh();
  }

  bool
  is_growth_error_known(const Model &model, const std::complex<double> error)
  {
    return !has_mesh_error(model) || !std::isnan(error.real());
  }



  void
  GrowthOfMany::add(const std::string &where,
                    const OpenSigns   &open,
                    const unsigned int n_unstable,
                    const bool         is_estimated,
                    const std::string &outside)
  {
    ++n_places;
    if (!outside.empty() && n_outside++ == 0)
      first_outside = where + ": " + outside;
    n_decided += n_unstable > open.n_growing;
    n_unstable_places += n_unstable > 0;
    all_estimated = all_estimated && is_estimated;
    if (!open.any())
      return;
    if (n_open++ == 0)
      first_open = where + ": " + open.pairs;
  }

  std::string
  GrowthOfMany::at(const unsigned int n) const
  {
    return preposition + " " + std::to_string(n) + " of " +
           std::to_string(n_places) + " " + noun + " ";
  }

  std::string
  GrowthOfMany::left_open() const
  {
    if (n_open == 0)
      return "";
    return at(n_open) + "the mesh leaves open whether a pair grows (" +
           first_open + ")";
  }

  std::string
  GrowthOfMany::reservations() const
  {
    std::string text;
    if (n_outside > 0)
      text += "; " + at(n_outside) +
              "something grows that is not in the tables (" + first_outside +
              ")";
    if (n_open > 0)
      text += "; " + left_open();
    if (n_unstable_places == 0 && !all_estimated)
      text += std::string("; ") + growth_error_unknown;
    if (!is_complete)
      text += "; the direct solver need not have all pairs of the band";
    return text;
  }

  HtmlReport::Verdict
  GrowthOfMany::verdict() const
  {
    if (n_decided > 0 || n_outside > 0)
      return HtmlReport::Verdict::bad;
    return n_open > 0 || !all_estimated || !is_complete
             ? HtmlReport::Verdict::neutral
             : HtmlReport::Verdict::good;
  }
} // namespace squeal
