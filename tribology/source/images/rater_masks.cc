// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/tribology/images/rater_masks.h>

#include <cctype>
#include <cmath>
#include <filesystem>
#include <set>

namespace squeal::tribology
{
  namespace
  {
    constexpr double      most_marked = 0.5; // of the pixels
    constexpr std::size_t n_shown     = 6;   // values of a mask in an error

    std::string
    stem_of(const std::string &path)
    {
      return std::filesystem::path(path).stem().string();
    }



    bool
    belongs(const std::string &mask, const std::string &image)
    {
      return mask.compare(0, image.size(), image) == 0 &&
             (mask.size() == image.size() ||
              std::isalnum(static_cast<unsigned char>(mask[image.size()])) ==
                0);
    }



    /** What is left of the mask's stem without its separators; the folder where
     * nothing is. */
    std::string
    rater_of(const std::string &mask, const std::string &image)
    {
      const std::string stem = stem_of(mask);
      std::size_t       i    = image.size();
      while (i < stem.size() &&
             std::isalnum(static_cast<unsigned char>(stem[i])) == 0)
        ++i;
      if (i < stem.size())
        return stem.substr(i);
      const std::string folder =
        std::filesystem::absolute(mask).parent_path().filename().string();
      return folder.empty() ? "mask" : folder;
    }



    std::string
    size_text(const cv::Size &size)
    {
      return std::to_string(size.width) + " x " + std::to_string(size.height);
    }



    std::string
    list_of(const std::set<int> &values)
    {
      std::string text;
      std::size_t n = 0;
      for (const int v : values)
        if (++n <= n_shown)
          text += (n > 1 ? ", " : "") + std::to_string(v);
      return values.size() > n_shown ? text + ", ..." : text;
    }



    /** The value of marked pixels; -1: none is marked. */
    int
    marked_value(const std::string &path, const cv::Mat &raw, const int value)
    {
      std::set<int> values;
      for (int y = 0; y < raw.rows; ++y)
        for (int x = 0; x < raw.cols; ++x)
          values.insert(raw.depth() == CV_8U ? raw.at<uchar>(y, x)
                                             : raw.at<ushort>(y, x));
      if (values == std::set<int>{0} && value != 0)
        return -1;
      if (value >= 0)
        {
          if (values.count(value) == 0)
            throw InputError(path + " has no pixel of 'Mask value' " +
                             std::to_string(value) +
                             ", its values are: " + list_of(values));
          return value;
        }
      if (values.size() != 2)
        throw InputError(path + " has " + std::to_string(values.size()) +
                         " values (" + list_of(values) +
                         "): set 'Mask value' to that of marked pixels");
      return *values.rbegin();
    }
  } // namespace



  std::vector<std::vector<RaterMask>>
  assign_masks(const std::vector<std::string> &masks,
               const std::vector<std::string> &images)
  {
    std::vector<std::vector<RaterMask>> result(images.size());
    for (const std::string &mask : masks)
      {
        std::size_t owner = images.size(), longest = 0;
        for (std::size_t i = 0; i < images.size(); ++i)
          {
            const std::string image = stem_of(images[i]);
            if (belongs(stem_of(mask), image) && image.size() > longest)
              {
                owner   = i;
                longest = image.size();
              }
          }
        if (owner == images.size())
          throw InputError(mask + " belongs to no image: the name of a mask "
                                  "begins with that of its image");
        const std::string rater = rater_of(mask, stem_of(images[owner]));
        for (const RaterMask &other : result[owner])
          if (other.rater == rater)
            throw InputError(mask + " and " + other.path + " are both by '" +
                             rater + "' on " + images[owner] +
                             ": name them apart, or put them into folders "
                             "named after the raters");
        result[owner].push_back({mask, rater});
      }
    return result;
  }



  cv::Mat
  read_mask(const std::string &path,
            const Micrograph  &image,
            const int          value,
            const double       largest)
  {
    cv::Mat raw = read_raw(path, largest);
    if (raw.size() == image.grey.size())
      raw = raw(image.frame);
    else if (raw.size() != image.frame.size())
      throw InputError(path + " has " + size_text(raw.size()) +
                       " pixels, its image " + image.path + " has " +
                       size_text(image.grey.size()) +
                       ": draw masks on the image as it is");
    const int marked = marked_value(path, raw, value);
    if (marked < 0)
      return cv::Mat::zeros(raw.size(), CV_8U);
    const cv::Mat mask = raw == marked;
    const double  part = cv::countNonZero(mask) / double(mask.total());
    if (part > most_marked)
      throw InputError(
        path + " marks " + std::to_string(std::lround(100. * part)) +
        " % of the image (value " + std::to_string(marked) +
        "): if it is inverted set 'Mask value' to the other value");
    return mask;
  }
} // namespace squeal::tribology
