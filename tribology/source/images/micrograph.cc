// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/images/stored_pixels.h>

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>

namespace squeal::tribology
{
  namespace
  {
    /** Part of the pixels of a data bar that are its background: texts and the
     * scale bar are small. Saturated rows of a picture have less. */
    constexpr double mostly_background = 0.7;

    /** Part of a row that is the background of a data bar and not of the row
     * above it, at least. */
    constexpr double least_drop = 0.2;

    /** Wider than any brake, um. */
    constexpr double widest_view = 1e6;

    // Of the pixels, brightness of which most of a picture is darker.
    constexpr double nearly_all = 0.99, nearly_black = 24.;

    /** Bits that a picture of 16 uses, @p least at least; 0 of another depth.
     * Cameras of 10, 12 or 14 bits leave the upper ones unused; a single hot
     * pixel does not use them. */
    int
    used_bits(const cv::Mat &values, const int least)
    {
      if (values.depth() != CV_16U)
        return 0;
      cv::Mat without_hot_pixels;
      cv::medianBlur(values, without_hot_pixels, 3);
      double most = 0.;
      cv::minMaxLoc(without_hot_pixels, nullptr, &most);
      int bits = least;
      while (bits < 16 && most >= std::pow(2., bits))
        ++bits;
      return bits;
    }



    /** Factor from stored values to 0..255, where 8 bits are the upper ones of
     * those that are used. */
    double
    to_bytes(const int bits)
    {
      return bits == 0 ? 1. : bits == 16 ? 1. / 257. : std::pow(2., 8 - bits);
    }



    /** A warning for stored @p values, of which 0 is white, that leave upper
     * bits unused; "" where they do not. Of black as 0 an unknown range is a
     * factor, which no depth of a crack depends on. Of white as 0 it is where
     * black lies, which all of them depend on, and nothing in the values tells
     * it. */
    std::string
    warning_of_unknown_black(const cv::Mat &values)
    {
      constexpr int camera = 14; // most bits of one that does not use them all
      const int     bits   = used_bits(values, 8);
      if (bits > camera)
        return "";
      const std::string n = std::to_string(bits);
      return "white is stored as 0, and of its 16 bits the picture uses " + n +
             ": black is taken as 65535, which leaves cracks little contrast; "
             "if it comes from a camera of " +
             n + " bits, subtract its values from " +
             std::to_string((1 << bits) - 1) + " and store it with black as 0";
    }



    cv::Mat
    scaled_grey(const cv::Mat &values, const double factor)
    {
      cv::Mat grey;
      values.convertTo(grey, CV_32F, factor);
      if (factor != 1.)
        cv::min(grey, 255., grey);
      return grey;
    }

  } // namespace



  std::string
  size_text(const cv::Size &size)
  {
    return std::to_string(size.width) + " x " + std::to_string(size.height);
  }



  cv::Mat
  read_grey(const std::string &path, const double largest)
  {
    const cv::Mat raw = read_raw(path, largest);
    return scaled_grey(raw, to_bytes(used_bits(raw, 8)));
  }



  float
  quantile_of(const cv::Mat &grey, const double share)
  {
    std::vector<float> values;
    for (int y = 0; y < grey.rows; ++y)
      values.insert(
        values.end(), grey.ptr<float>(y), grey.ptr<float>(y) + grey.cols);
    const auto nth =
      values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
  }



  namespace
  {
    /** The most frequent value of a row and how many pixels have it. */
    std::pair<float, int>
    most_frequent(const float *row, const int n)
    {
      std::map<float, int>  counts;
      std::pair<float, int> most(0.f, 0);
      for (int x = 0; x < n; ++x)
        if (const int count = ++counts[row[x]]; count > most.second)
          most = {row[x], count};
      return most;
    }



    /** Whether a bar of that background has an upper edge at row @p top: the
     * black corner of a turned picture gets narrower row by row. */
    bool
    ends_at_once(const cv::Mat              &grey,
                 const int                   top,
                 const std::optional<float> &background)
    {
      if (!background || top == 0)
        return true;
      const auto share_in = [&](const int y) {
        return cv::countNonZero(grey.row(y) == *background) / double(grey.cols);
      };
      return most_frequent(grey.ptr<float>(top), grey.cols).first !=
               *background ||
             share_in(top) - share_in(top - 1) >= least_drop;
    }
  } // namespace



  int
  rows_above_data_bar(const cv::Mat &grey)
  {
    std::optional<float> background;
    int                  top = grey.rows;
    double               sum = 0.;
    for (int y = grey.rows - 1; y >= 0; --y)
      {
        const auto [value, n] = most_frequent(grey.ptr<float>(y), grey.cols);
        // A row of another value is a frame line of the bar.
        const bool is_line = 10 * n > 9 * grey.cols;
        if (!background && !is_line)
          background = value;
        if (2 * n <= grey.cols || (!is_line && value != *background))
          break;
        sum += double(n) / grey.cols;
        top = y;
      }
    const int    n     = grey.rows - top;
    const double share = double(n) / grey.rows;
    return share >= 0.02 && share <= 0.2 && sum >= mostly_background * n &&
               ends_at_once(grey, top, background)
             ? top
             : grey.rows;
  }



  namespace
  {
    /** Fills in the picture, its frame and what is odd about them. */
    void
    read_pixels_of(Micrograph  &m,
                   const int    data_bar,
                   const double largest,
                   const int    least_bits)
    {
      const StoredPixels pixels = read_pixels(m.path, largest);
      if (pixels.is_transparent)
        throw InputError(m.path + " is transparent everywhere: save it without "
                                  "an alpha channel");
      const cv::Mat &values = pixels.values;
      if (data_bar >= values.rows)
        throw InputError(m.path + " has " + std::to_string(values.rows) +
                         " rows, no more than 'Data bar'");
      m.frame       = {0,
                       0,
                       values.cols,
                 data_bar < 0 ? rows_above_data_bar(scaled_grey(values, 1.))
                                    : values.rows - data_bar};
      m.bits        = used_bits(values(m.frame), least_bits);
      m.grey        = scaled_grey(values, to_bytes(m.bits));
      m.seen        = pixels.opaque;
      m.orientation = pixels.orientation;
      if (m.bits > 0 && m.bits < 16)
        m.notes.push_back("of its 16 bits the picture uses " +
                          std::to_string(m.bits) +
                          ": these are taken for black to white");
      if (pixels.is_inverted)
        if (const std::string warning =
              warning_of_unknown_black(cv::Scalar(65535) - values(m.frame));
            !warning.empty())
          m.warnings.push_back(warning);
      if (m.orientation != 1)
        m.notes.push_back("a tag says that it is stored turned (orientation " +
                          std::to_string(m.orientation) +
                          "): it is turned upright, and so are all results");
      if (const float most = quantile_of(m.grey(m.frame), nearly_all);
          most < nearly_black)
        m.warnings.push_back(
          "nearly black: " + rounded_text(100. * nearly_all, 2) +
          " % of the pixels are darker than " + rounded_text(most + 1., 2) +
          " of 255, where few grey levels are left to tell cracks by: export "
          "it with its full range");
    }



    /** Edge of a pixel over that of the picture of which the metadata tell the
     * size: 1 where it has as many columns. Nothing where the picture, with its
     * data bar or without, is no smaller or larger copy of that one. */
    std::optional<double>
    scale_against_metadata(const Micrograph &m)
    {
      if (!m.metadata.size)
        return 1.;
      const bool     is_turned = m.orientation > 4;
      const cv::Size stated    = *m.metadata.size;
      const int      columns   = is_turned ? m.grey.rows : m.grey.cols;
      if (columns == stated.width)
        return 1.;
      const double scale = double(stated.width) / columns;
      const auto   fits  = [&](const int rows) {
        const double wanted = stated.height / scale;
        return std::abs(rows - wanted) <= 1. + wanted / columns;
      };
      if (!fits(is_turned ? m.grey.cols : m.grey.rows) && !fits(m.frame.height))
        return std::nullopt;
      return scale;
    }



    /** Makes the pixel size of the metadata that of the pixels at hand, or
     * none where nothing tells it. Returns what is to be told of that. */
    std::string
    fit_metadata_to_size(Micrograph &m)
    {
      const auto scale = scale_against_metadata(m);
      if (!m.metadata.pixel_size || scale == 1.)
        return "";
      const std::string sizes =
        "its metadata are of " + size_text(*m.metadata.size) +
        " pixels, the image has " + size_text(m.grey.size());
      if (!scale)
        {
          m.metadata.pixel_size.reset();
          return sizes + " and is no smaller or larger copy of that";
        }
      *m.metadata.pixel_size *= *scale;
      return sizes +
             ": it is taken for a copy of another size, with pixels of " +
             rounded_text(*m.metadata.pixel_size, 4) +
             " um; set 'Pixel size' if it was cut out";
    }
  } // namespace



  Micrograph
  read_micrograph(const std::string &path,
                  const double       pixel_size,
                  const ScaleBar    &bar,
                  const double       largest,
                  const int          data_bar,
                  const int          least_bits)
  {
    Micrograph m;
    m.path     = path;
    m.stem     = std::filesystem::path(path).stem().string();
    m.metadata = read_metadata(path);
    read_pixels_of(m, data_bar, largest, least_bits);
    const std::string other_size = fit_metadata_to_size(m);
    if (pixel_size > 0.)
      {
        m.pixel_size   = pixel_size;
        m.scale_source = "parameter file";
      }
    else if (bar.length > 0.)
      {
        m.pixel_size   = bar.length / scale_bar_pixels(m.grey, bar.box, path);
        m.scale_source = "scale bar";
        m.scale_bar    = scale_bar_place(m.grey, bar.box);
      }
    else if (m.metadata.pixel_size)
      {
        m.pixel_size   = *m.metadata.pixel_size;
        m.scale_source = m.metadata.source;
        if (!other_size.empty())
          m.warnings.push_back(other_size);
        if (!m.metadata.size && !m.metadata.is_synthetic)
          m.notes.push_back("its metadata do not state how many pixels it had: "
                            "nothing tells whether it is a copy of another "
                            "size");
      }
    else
      throw InputError(
        path +
        (!m.metadata.without_scale.empty() ? ": " + m.metadata.without_scale
         : other_size.empty()              ? " has no scale"
                                           : ": " + other_size) +
        ": set 'Pixel size', or 'Scale bar' with its box and length");
    if (!(m.pixel_size > 0.) || !std::isfinite(m.pixel_size))
      throw InputError(path + ": the pixel size of its metadata is not "
                              "positive: set 'Pixel size'");
    const double width = m.pixel_size * std::max(m.frame.width, m.frame.height);
    if (width > widest_view)
      m.warnings.push_back("it shows " + rounded_text(1e-6 * width, 3) +
                           " m, more than any brake has, by pixels of " +
                           rounded_text(m.pixel_size, 4) + " um (" +
                           m.scale_source + "): check the unit of that");
    double darkest, brightest;
    cv::minMaxLoc(m.grey(m.frame), &darkest, &brightest);
    if (darkest == brightest)
      m.warnings.push_back("all pixels have one value, " +
                           rounded_text(brightest, 4) +
                           ": the image shows nothing, and what is found in it "
                           "says nothing");
    return m;
  }
} // namespace squeal::tribology
