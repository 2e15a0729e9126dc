// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/tribology/images/decoder_messages.h>
#include <squeal/tribology/images/micrograph.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

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

    /** The decoders fill what a cut file lacks with grey; its end mark tells.
     */
    void
    require_end_mark(const std::string &data, const std::string &path)
    {
      const auto begins = [&](const std::string &mark) {
        return data.compare(0, mark.size(), mark) == 0;
      };
      const auto ends_with = [&](const std::string &mark) {
        return data.find(mark,
                         data.size() -
                           std::min<std::size_t>(data.size(), 4096)) !=
               std::string::npos;
      };
      if ((begins("\x89PNG") && !ends_with("IEND")) ||
          (begins("\xff\xd8") && !ends_with("\xff\xd9")))
        throw InputError(path + " is truncated: copy the image again");
    }



    [[noreturn]] void
    refuse_format(const std::string &path)
    {
      throw InputError(path + " is no PNG, TIFF or JPEG image, or it is "
                              "damaged");
    }



    ImageSize
    promised_size(const std::string &data, const std::string &path)
    {
      const auto size = image_size(data);
      if (!size)
        refuse_format(path);
      return *size;
    }



    cv::Mat
    decode(const std::string &data, const std::string &path)
    {
      cv::Mat           image;
      const std::string messages = messages_of([&] {
        try
          {
            image = cv::imdecode(
              cv::Mat(1, int(data.size()), CV_8U, const_cast<char *>(&data[0])),
              cv::IMREAD_ANYDEPTH | cv::IMREAD_GRAYSCALE);
          }
        catch (const cv::Exception &)
          {
            image.release();
          }
      });
      if (image.empty())
        refuse_format(path);
      if (const std::string damage = damage_in(messages); !damage.empty())
        throw InputError(path + " is damaged: its decoder says '" + damage +
                         "'");
      return image;
    }
  } // namespace



  cv::Mat
  read_raw(const std::string &path, const double largest)
  {
    const std::string data = read_file(path);
    if (data.empty())
      throw InputError(path + " is empty: it has no image");
    require_end_mark(data, path);
    require_room(path, promised_size(data, path), largest);
    const cv::Mat image = decode(data, path);
    if (image.rows < 32 || image.cols < 32)
      throw InputError(path + " has " + std::to_string(image.cols) + " x " +
                       std::to_string(image.rows) +
                       " pixels: at least 32 x 32 are needed");
    if (image.depth() != CV_8U && image.depth() != CV_16U)
      throw InputError(path + ": only images of 8 and 16 bit are read");
    return image;
  }



  cv::Mat
  read_grey(const std::string &path, const double largest)
  {
    const cv::Mat raw = read_raw(path, largest);
    cv::Mat       grey;
    raw.convertTo(grey, CV_32F, raw.depth() == CV_16U ? 1. / 257. : 1.);
    return grey;
  }



  cv::Mat
  read_element_map(const std::string &path, const double largest)
  {
    cv::Mat values;
    read_raw(path, largest).convertTo(values, CV_32F);
    const std::string data  = read_file(path);
    const cv::Mat     whole = cv::imdecode(
      cv::Mat(1, int(data.size()), CV_8U, const_cast<char *>(data.data())),
      cv::IMREAD_ANYDEPTH | cv::IMREAD_COLOR);
    cv::Mat channels[3];
    cv::split(whole, channels);
    if (cv::norm(channels[0], channels[1], cv::NORM_INF) > 0. ||
        cv::norm(channels[0], channels[2], cv::NORM_INF) > 0.)
      throw InputError(path + " is a map in colours, which hold no numbers: "
                              "save the counts of the element as a grey "
                              "image");
    return values;
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
    return share >= 0.02 && share <= 0.2 && sum >= mostly_background * n
             ? top
             : grey.rows;
  }



  namespace
  {
    /** True where most pixels at the border of a mask are set. */
    bool
    most_of_border(const cv::Mat &mask)
    {
      const int n_set = cv::countNonZero(mask.row(0)) +
                        cv::countNonZero(mask.row(mask.rows - 1)) +
                        cv::countNonZero(mask.col(0)) +
                        cv::countNonZero(mask.col(mask.cols - 1));
      return n_set > mask.rows + mask.cols;
    }

    /** Pixels in a row that are set. */
    struct Run
    {
      int first = 0, length = 0;
    };

    Run
    longest_run(const cv::Mat &mask)
    {
      Run longest;
      for (int y = 0; y < mask.rows; ++y)
        {
          Run run;
          for (int x = 0; x < mask.cols; ++x)
            {
              if (mask.at<unsigned char>(y, x) == 0)
                run = {x + 1, 0};
              else if (++run.length > longest.length)
                longest = run;
            }
        }
      return longest;
    }
  } // namespace



  double
  scale_bar_pixels(const cv::Mat     &grey,
                   const cv::Rect    &box,
                   const std::string &path)
  {
    if ((box & cv::Rect({0, 0}, grey.size())) != box || box.area() == 0)
      throw InputError(path + ": the box of 'Scale bar' is not in the image");
    double        low, high;
    const cv::Mat part = grey(box);
    cv::minMaxLoc(part, &low, &high);
    const cv::Mat bright = part > 0.5 * (low + high);
    const cv::Mat bar    = most_of_border(bright) ? cv::Mat(~bright) : bright;
    const Run     run    = longest_run(bar);
    if (run.length < 10 || high - low < 30.)
      throw InputError(path + ": there is no bar in the box of 'Scale bar'");
    if (run.first == 0 || run.first + run.length == part.cols)
      throw InputError(path + ": the bar reaches the left or the right border "
                              "of the box of 'Scale bar': draw the box wider "
                              "than the bar, with its background around it");
    return run.length;
  }



  Micrograph
  read_micrograph(const std::string &path,
                  const double       pixel_size,
                  const ScaleBar    &bar,
                  const double       largest,
                  const int          data_bar)
  {
    Micrograph m;
    m.path     = path;
    m.stem     = std::filesystem::path(path).stem().string();
    m.grey     = read_grey(path, largest);
    m.metadata = read_metadata(path);
    if (data_bar >= m.grey.rows)
      throw InputError(path + " has " + std::to_string(m.grey.rows) +
                       " rows, no more than 'Data bar'");
    m.frame = {0,
               0,
               m.grey.cols,
               data_bar < 0 ? rows_above_data_bar(m.grey)
                            : m.grey.rows - data_bar};
    if (pixel_size > 0.)
      {
        m.pixel_size   = pixel_size;
        m.scale_source = "parameter file";
      }
    else if (bar.length > 0.)
      {
        m.pixel_size   = bar.length / scale_bar_pixels(m.grey, bar.box, path);
        m.scale_source = "scale bar";
      }
    else if (m.metadata.pixel_size)
      {
        m.pixel_size   = *m.metadata.pixel_size;
        m.scale_source = m.metadata.source;
      }
    else
      throw InputError(path + " has no scale: set 'Pixel size', or 'Scale bar' "
                              "with its box and length");
    if (!(m.pixel_size > 0.) || !std::isfinite(m.pixel_size))
      throw InputError(path + ": the pixel size of its metadata is not "
                              "positive: set 'Pixel size'");
    return m;
  }
} // namespace squeal::tribology
