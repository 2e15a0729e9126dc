// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/statistics/association.h>
#include <squeal/tribology/statistics/spatial.h>

#include <Eigen/Core>

#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace squeal::tribology
{
  namespace
  {
    /** Class of the distance of two cells: whole mean cells, rounded. A class
     * of its own, 0, is a cell with itself, as cells of a graded grid may lie
     * nearer to each other than half a mean one. */
    Eigen::MatrixXi
    distance_classes(const GridMap &map, const std::vector<std::size_t> &cells)
    {
      const std::size_t n     = cells.size();
      const auto [wide, high] = map.spacing();
      const double    edge    = std::sqrt(wide * high);
      Eigen::MatrixXi classes(n, n);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          {
            const auto a = map.place(cells[i]), b = map.place(cells[j]);
            const long whole =
              std::lround(std::hypot(a[0] - b[0], a[1] - b[1]) / edge);
            classes(i, j) = i == j ? 0 : std::max(1, static_cast<int>(whole));
          }
      return classes;
    }



    /** Covariance matrix with one value for each class of distance. */
    Eigen::MatrixXd
    covariance(const Eigen::VectorXd &values, const Eigen::MatrixXi &classes)
    {
      const int             n_classes = classes.maxCoeff() + 1;
      const Eigen::VectorXd centred   = values.array() - values.mean();
      std::vector<double>   sums(n_classes, 0.), counts(n_classes, 0.);
      for (int j = 0; j < classes.cols(); ++j)
        for (int i = 0; i < classes.rows(); ++i)
          {
            sums[classes(i, j)] += centred(i) * centred(j);
            counts[classes(i, j)] += 1.;
          }
      Eigen::MatrixXd result(classes.rows(), classes.cols());
      for (int j = 0; j < classes.cols(); ++j)
        for (int i = 0; i < classes.rows(); ++i)
          result(i, j) = sums[classes(i, j)] / counts[classes(i, j)];
      return result;
    }



    /** B S B with B = 1 - 1/n. */
    Eigen::MatrixXd
    centred(Eigen::MatrixXd s)
    {
      const Eigen::RowVectorXd columns = s.colwise().mean();
      s.rowwise() -= columns;
      const Eigen::VectorXd rows = s.rowwise().mean();
      s.colwise() -= rows;
      return s;
    }
  } // namespace



  std::array<double, 2>
  GridMap::place(const std::size_t cell) const
  {
    const std::size_t i = cell % n_x, j = cell / n_x;
    return {{xs.empty() ? double(i) : xs[i], ys.empty() ? double(j) : ys[j]}};
  }



  std::array<double, 2>
  GridMap::spacing() const
  {
    const auto mean = [](const std::vector<double> &at) {
      return at.empty()      ? 1.
             : at.size() > 1 ? (at.back() - at.front()) / (at.size() - 1.)
                             : 0.;
    };
    const double wide = mean(xs), high = mean(ys), other = wide + high;
    if (wide > 0. && high > 0.)
      return {{wide, high}};
    return other > 0. ? std::array<double, 2>{{other, other}}
                      : std::array<double, 2>{{1., 1.}};
  }



  std::vector<std::size_t>
  common_cells(const GridMap &x, const GridMap &y)
  {
    std::vector<std::size_t> cells;
    for (std::size_t i = 0; i < x.size(); ++i)
      if (std::isfinite(x.values[i]) && std::isfinite(y.values[i]))
        cells.push_back(i);
    return cells;
  }



  std::array<std::vector<double>, 2>
  common_values(const GridMap &x, const GridMap &y)
  {
    std::array<std::vector<double>, 2> values;
    for (const std::size_t i : common_cells(x, y))
      {
        values[0].push_back(x.values[i]);
        values[1].push_back(y.values[i]);
      }
    return values;
  }



  double
  effective_sample_size(const GridMap &x, const GridMap &y)
  {
    const std::vector<std::size_t> cells = common_cells(x, y);
    const auto [vx, vy]                  = common_values(x, y);
    const std::size_t n                  = cells.size();
    if (n < 4)
      return static_cast<double>(n);
    const Eigen::MatrixXi classes = distance_classes(x, cells);
    const Eigen::MatrixXd sx      = centred(
      covariance(Eigen::Map<const Eigen::VectorXd>(vx.data(), n), classes));
    const Eigen::MatrixXd sy = centred(
      covariance(Eigen::Map<const Eigen::VectorXd>(vy.data(), n), classes));
    const double traces = sx.trace() * sy.trace();
    const double shared = sx.cwiseProduct(sy).sum();
    if (!(traces > 0.) || !(shared > 0.))
      return static_cast<double>(n);
    return std::min(1. + traces / shared, static_cast<double>(n));
  }



  struct PhaseSurrogates::Spectrum
  {
    cv::Mat amplitudes; /**< of the mirrored map */
  };



  PhaseSurrogates::PhaseSurrogates(const GridMap &map)
    : n_x(map.n_x)
    , n_y(map.n_y)
    , mean(std::accumulate(map.values.begin(), map.values.end(), 0.) /
           map.size())
    , spectrum(std::make_unique<Spectrum>())
  {
    const int width = static_cast<int>(n_x), height = static_cast<int>(n_y);
    cv::Mat   mirrored(2 * height, 2 * width, CV_64F);
    for (int j = 0; j < 2 * height; ++j)
      for (int i = 0; i < 2 * width; ++i)
        mirrored.at<double>(j, i) =
          map.values[std::min(i, 2 * width - 1 - i) +
                     n_x * std::min(j, 2 * height - 1 - j)] -
          mean;
    cv::Mat transformed;
    cv::dft(mirrored, transformed, cv::DFT_COMPLEX_OUTPUT);
    spectrum->amplitudes = cv::Mat(2 * height, 2 * width, CV_64F);
    for (int j = 0; j < 2 * height; ++j)
      for (int i = 0; i < 2 * width; ++i)
        {
          const cv::Vec2d c = transformed.at<cv::Vec2d>(j, i);
          spectrum->amplitudes.at<double>(j, i) = std::hypot(c[0], c[1]);
        }
  }



  PhaseSurrogates::~PhaseSurrogates() = default;



  GridMap
  PhaseSurrogates::draw(std::mt19937_64 &generator) const
  {
    const cv::Mat &amplitudes = spectrum->amplitudes;
    const int      rows = amplitudes.rows, columns = amplitudes.cols;
    cv::Mat        transformed(rows, columns, CV_64FC2);
    std::uniform_real_distribution<double> phase(0., 2. * M_PI);
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i)
        {
          const int oj = (rows - j) % rows, oi = (columns - i) % columns;
          // the map is real: a frequency and its opposite are conjugate
          if (std::make_pair(oj, oi) < std::make_pair(j, i))
            continue;
          const double a     = amplitudes.at<double>(j, i);
          const double angle = phase(generator);
          if (oj == j && oi == i)
            transformed.at<cv::Vec2d>(j, i) = {angle < M_PI ? a : -a, 0.};
          else
            {
              const double re = a * std::cos(angle), im = a * std::sin(angle);
              transformed.at<cv::Vec2d>(j, i)   = {re, im};
              transformed.at<cv::Vec2d>(oj, oi) = {re, -im};
            }
        }
    cv::Mat map;
    cv::dft(
      transformed, map, cv::DFT_INVERSE | cv::DFT_SCALE | cv::DFT_REAL_OUTPUT);
    GridMap result{n_x, n_y, {}};
    for (std::size_t j = 0; j < n_y; ++j)
      for (std::size_t i = 0; i < n_x; ++i)
        result.values.push_back(
          mean + map.at<double>(static_cast<int>(j), static_cast<int>(i)));
    return result;
  }



  double
  surrogate_p_value(const GridMap     &x,
                    const GridMap     &y,
                    const unsigned int n,
                    std::mt19937_64   &generator)
  {
    const auto   observed = common_values(x, y);
    const double r        = std::abs(pearson(observed[0], observed[1]));
    if (std::isnan(r))
      return 1.;
    const PhaseSurrogates  surrogates(x);
    constexpr unsigned int enough   = 100;
    constexpr double       same     = 1e-9; // apart by rounding
    unsigned int           n_larger = 0;
    for (unsigned int i = 1; i <= n; ++i)
      {
        const auto   values = common_values(surrogates.draw(generator), y);
        const double other  = pearson(values[0], values[1]);
        if (!(std::abs(other) < r - same) && ++n_larger == enough)
          return static_cast<double>(enough) / i;
      }
    return (1. + n_larger) / (1. + n);
  }



  namespace
  {
    /** A normal kernel of standard deviation length / 2, from -reach to
     * reach, whose squares add up to 1. */
    std::vector<double>
    normal_kernel(const double length)
    {
      const int           reach = static_cast<int>(std::ceil(2. * length));
      std::vector<double> kernel;
      double              squares = 0.;
      for (int k = -reach; k <= reach; ++k)
        {
          kernel.push_back(
            length > 0. ? std::exp(-2. * k * k / (length * length)) : 1.);
          squares += kernel.back() * kernel.back();
        }
      for (double &weight : kernel)
        weight /= std::sqrt(squares);
      return kernel;
    }
  } // namespace



  GridMap
  random_map(const std::size_t            n_x,
             const std::size_t            n_y,
             const std::array<double, 2> &lengths,
             std::mt19937_64             &generator)
  {
    std::normal_distribution<double> normal;
    const std::vector<double>        in_row = normal_kernel(lengths[0]),
                              in_column     = normal_kernel(lengths[1]);
    const int       wide = static_cast<int>(n_x + in_row.size()) - 1;
    const int       high = static_cast<int>(n_y + in_column.size()) - 1;
    Eigen::MatrixXd noise(wide, high);
    for (int j = 0; j < high; ++j)
      for (int i = 0; i < wide; ++i)
        noise(i, j) = normal(generator);
    Eigen::MatrixXd along = Eigen::MatrixXd::Zero(n_x, high);
    for (std::size_t k = 0; k < in_row.size(); ++k)
      along += in_row[k] * noise.middleRows(k, n_x);
    Eigen::MatrixXd both = Eigen::MatrixXd::Zero(n_x, n_y);
    for (std::size_t k = 0; k < in_column.size(); ++k)
      both += in_column[k] * along.middleCols(k, n_y);
    return {n_x, n_y, {both.data(), both.data() + both.size()}};
  }



  GridMap
  random_map(const std::size_t n_x,
             const std::size_t n_y,
             const double      length,
             std::mt19937_64  &generator)
  {
    return random_map(
      n_x, n_y, std::array<double, 2>{{length, length}}, generator);
  }
} // namespace squeal::tribology
