// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/cell_grid.h>
#include <squeal/tribology/images/line_length.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    bool
    is_shown(const SeenPixels &seen, const cv::Point &p)
    {
      return seen.empty() || seen.at<uchar>(p) != 0;
    }



    /** A component of a direction, 0 where the direction is along the other
     * axis. */
    double
    without_rounding(const double component)
    {
      return std::abs(component) < 1e-15 ? 0. : component;
    }
  } // namespace



  CellGrid::CellGrid(const cv::Size2d &size, const int n_x, const int n_y)
    : size(size)
    , n_x(n_x)
    , n_y(n_y)
    , cells(std::size_t(n_x) * n_y)
  {
  }



  int
  CellGrid::index(const cv::Point2d &p) const
  {
    const int i = int(std::floor((p.x / size.width + 0.5) * n_x));
    const int j = int(std::floor((p.y / size.height + 0.5) * n_y));
    return i < 0 || j < 0 || i >= n_x || j >= n_y ? -1 : j * n_x + i;
  }



  CellGrid::View::View(const cv::Size   &size,
                       const SeenPixels &seen,
                       const Placement  &placement)
    : to_pixel{placement.to_pad.inv(), 0.}
    , size(size)
    , seen(seen)
  {
    const double w = size.width, h = size.height;
    low = high = placement({0., 0.});
    for (const cv::Point2d &corner :
         {cv::Point2d(w, 0.), cv::Point2d(w, h), cv::Point2d(0., h)})
      {
        const cv::Point2d p = placement(corner);
        low                 = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high                = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
  }



  bool
  CellGrid::View::may_show_of(const View &other) const
  {
    return low.x < other.high.x && other.low.x < high.x &&
           low.y < other.high.y && other.low.y < high.y;
  }



  bool
  CellGrid::View::shows(const cv::Point2d &place) const
  {
    const cv::Point2d p = to_pixel(place);
    return p.x >= 0. && p.x < size.width && p.y >= 0. && p.y < size.height &&
           is_shown(seen, {int(p.x), int(p.y)});
  }



  void
  CellGrid::add_crack(Cell             &cell,
                      const PixelOnPad &pixel,
                      const CrackMap   &cracks,
                      const cv::Point  &at,
                      const double      pixel_length) const
  {
    // Along the crack by that direction, across it by what is left of the area.
    const cv::Point2d step   = pixel.step(cracks.direction.at<float>(at));
    const double      along  = cv::norm(step);
    const double      length = pixel_length * along;
    const double      angle  = 2. * (std::atan2(step.y, step.x) - sliding);
    cell.crack_length += length;
    cell.crack_width +=
      length * pixel.area() / along * cracks.width.at<float>(at);
    cell.cosine += length * std::cos(angle);
    cell.sine += length * std::sin(angle);
  }



  void
  CellGrid::add(const Segmentation &s,
                const Placement    &placement,
                const double        direction,
                const bool          image_is_synthetic)
  {
    sliding                          = direction;
    is_synthetic                     = is_synthetic || image_is_synthetic;
    const cv::Mat            &line   = s.cracks.centre_line;
    const cv::Mat             length = pixel_lengths(line);
    const View                view(line.size(), s.seen, placement);
    std::vector<const View *> earlier;
    for (const View &other : views)
      if (other.may_show_of(view))
        earlier.push_back(&other);
    for (int y = 0; y < line.rows; ++y)
      for (int x = 0; x < line.cols; ++x)
        {
          const cv::Point2d centre(x + 0.5, y + 0.5), place = placement(centre);
          const int         i = index(place);
          if (i < 0 || !is_shown(s.seen, {x, y}))
            continue;
          const PixelOnPad pixel(placement, centre);
          const double     area = pixel.area();
          area_of_images += area;
          if (std::any_of(
                earlier.begin(), earlier.end(), [&place](const View *other) {
                  return other->shows(place);
                }))
            continue;
          Cell &cell = cells[i];
          cell.area += area;
          cell.exfoliation += s.areas.exfoliation.at<uchar>(y, x) ? area : 0.;
          cell.plateau += s.areas.plateau.at<uchar>(y, x) ? area : 0.;
          if (line.at<uchar>(y, x) != 0)
            add_crack(cell, pixel, s.cracks, {x, y}, length.at<float>(y, x));
        }
    views.push_back(view);
  }



  CellGrid::SeenOnce
  CellGrid::seen_once() const
  {
    SeenOnce once;
    for (const Cell &c : cells)
      {
        once.area += c.area;
        once.crack_length += c.crack_length;
      }
    once.share = area_of_images > 0. ? once.area / area_of_images : 1.;
    return once;
  }



  void
  CellGrid::add_covariate(const std::string &name,
                          const cv::Mat     &values,
                          const Placement   &placement,
                          const SeenPixels  &seen)
  {
    Covariate c{name,
                std::vector<double>(cells.size(), 0.),
                std::vector<double>(cells.size(), 0.)};
    for (int y = 0; y < values.rows; ++y)
      for (int x = 0; x < values.cols; ++x)
        {
          const cv::Point2d centre(x + 0.5, y + 0.5);
          const int         i = index(placement(centre));
          if (i < 0 || !is_shown(seen, {x, y}))
            continue;
          const double area = PixelOnPad(placement, centre).area();
          c.sum[i] += area * values.at<float>(y, x);
          c.weight[i] += area;
        }
    covariates.push_back(c);
  }



  std::vector<Table::Column>
  CellGrid::columns() const
  {
    using T                           = Table::Type;
    std::vector<Table::Column> result = {
      {"image", T::text, "", "image, or pad when registered"},
      {"cell", T::integer, "", "number of the cell, x fastest"},
      {"x_m", T::real, "m", "centre of the cell"},
      {"y_m", T::real, "m", "centre of the cell"},
      {"coverage",
       T::real,
       "",
       "part of the cell that was observed, at most 1"},
      {"crack_density_per_m", T::real, "1/m", "crack length per area"},
      {"crack_width_m", T::real, "m", "mean width along the length"},
      {"crack_angle_deg",
       T::real,
       "degrees",
       "mean direction against the sliding direction, -90 to 90"},
      {"crack_alignment",
       T::real,
       "",
       "0: every direction alike, 1: all cracks parallel"},
      {"crack_along_sliding",
       T::real,
       "",
       "mean of cos 2a of that angle: 1 along the sliding, -1 across it"},
      {"exfoliation_fraction", T::real, "", "area of exfoliations"},
      {"plateau_fraction", T::real, "", "area of contact plateaus"},
      {"sliding_x", T::real, "", "direction that angles are against"},
      {"sliding_y", T::real, "", "direction that angles are against"},
      {"synthetic", T::integer, "", "1: a made image is among those shown"}};
    for (const Covariate &c : covariates)
      result.push_back({c.name, T::real, "", "mean of the element map"});
    return result;
  }



  void
  CellGrid::append_rows(Table &table, const std::string &image) const
  {
    const squeal::Cell nothing;
    for (int j = 0; j < n_y; ++j)
      for (int i = 0; i < n_x; ++i)
        {
          const std::size_t k    = std::size_t(j) * n_x + i;
          const Cell       &c    = cells[k];
          const bool        seen = c.area > 0., has = c.crack_length > 0.;
          std::vector<squeal::Cell> row = {
            image,
            int(k),
            1e-6 * size.width * ((i + 0.5) / n_x - 0.5),
            1e-6 * size.height * ((j + 0.5) / n_y - 0.5),
            std::min(1., c.area * n_x * n_y / size.area()),
            seen ? squeal::Cell(1e6 * c.crack_length / c.area) : nothing,
            has ? squeal::Cell(1e-6 * c.crack_width / c.crack_length) : nothing,
            has ? squeal::Cell(90. / CV_PI * std::atan2(c.sine, c.cosine))
                : nothing,
            has ? squeal::Cell(std::hypot(c.sine, c.cosine) / c.crack_length)
                : nothing,
            has ? squeal::Cell(c.cosine / c.crack_length) : nothing,
            seen ? squeal::Cell(c.exfoliation / c.area) : nothing,
            seen ? squeal::Cell(c.plateau / c.area) : nothing,
            without_rounding(std::cos(sliding)),
            without_rounding(std::sin(sliding)),
            int(is_synthetic)};
          for (const Covariate &v : covariates)
            row.push_back(v.weight[k] > 0.
                            ? squeal::Cell(v.sum[k] / v.weight[k])
                            : nothing);
          table.add_row(row);
        }
  }
} // namespace squeal::tribology
