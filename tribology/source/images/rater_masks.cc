// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/tribology/images/image_files.h>
#include <squeal/tribology/images/rater_masks.h>
#include <squeal/tribology/images/stored_pixels.h>

#include <algorithm>
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
    list_of(const std::set<int> &values)
    {
      std::string text;
      std::size_t n = 0;
      for (const int v : values)
        if (++n <= n_shown)
          text += (n > 1 ? ", " : "") + std::to_string(v);
      return values.size() > n_shown ? text + ", ..." : text;
    }



    /** The values of a mask, where @p opaque says so if it is not empty. */
    std::set<int>
    values_in(const cv::Mat &raw, const cv::Mat &opaque)
    {
      std::set<int> values;
      for (int y = 0; y < raw.rows; ++y)
        for (int x = 0; x < raw.cols; ++x)
          if (opaque.empty() || opaque.at<uchar>(y, x) != 0)
            values.insert(raw.depth() == CV_8U ? raw.at<uchar>(y, x)
                                               : raw.at<ushort>(y, x));
      return values;
    }



    void
    require_value(const std::string   &path,
                  const std::set<int> &values,
                  const int            value)
    {
      if (values.count(value) == 0)
        throw InputError(path + " has no pixel of 'Mask value' " +
                         std::to_string(value) +
                         ", its values are: " + list_of(values));
    }



    /** The value of marked pixels; -1: none is marked. */
    int
    marked_value(const std::string &path, const cv::Mat &raw, const int value)
    {
      const std::set<int> values = values_in(raw, cv::Mat());
      if (values == std::set<int>{0} && value != 0)
        return -1;
      if (value >= 0)
        {
          require_value(path, values, value);
          return value;
        }
      if (values.size() != 2)
        throw InputError(path + " has " + std::to_string(values.size()) +
                         " values (" + list_of(values) +
                         "): set 'Mask value' to that of marked pixels");
      return *values.rbegin();
    }



    /** What is drawn on a transparent layer, which may be black. */
    cv::Mat
    marks_on_layer(const std::string &path,
                   const cv::Mat     &raw,
                   const cv::Mat     &opaque,
                   const int          value)
    {
      const std::set<int> values = values_in(raw, opaque);
      if (value >= 0)
        {
          require_value(path, values, value);
          return (raw == value) & opaque;
        }
      if (values.size() > 1)
        throw InputError(path + " is a layer with marks of " +
                         std::to_string(values.size()) + " values (" +
                         list_of(values) +
                         "): set 'Mask value' to that of marked pixels, or "
                         "draw them in one colour");
      return opaque.clone();
    }



    cv::Mat
    marks_in(const std::string  &path,
             const StoredPixels &pixels,
             const int           value)
    {
      const cv::Mat &raw = pixels.values;
      if (pixels.is_transparent)
        return cv::Mat::zeros(raw.size(), CV_8U);
      if (!pixels.opaque.empty())
        return marks_on_layer(path, raw, pixels.opaque, value);
      const int marked = marked_value(path, raw, value);
      return marked < 0 ? cv::Mat(cv::Mat::zeros(raw.size(), CV_8U))
                        : cv::Mat(raw == marked);
    }



    /** Refuses a mask that an image beside its own, none of @p masks, has the
     * better claim to. */
    void
    require_no_other_image(const std::string              &mask,
                           const std::string              &image,
                           const std::vector<std::string> &masks)
    {
      namespace fs           = std::filesystem;
      const std::string stem = stem_of(mask), own = stem_of(image);
      const fs::path    folder = fs::path(image).parent_path();
      std::error_code   none;
      for (const auto &entry : fs::directory_iterator(
             folder.empty() ? fs::path(".") : folder, none))
        {
          const std::string other    = stem_of(entry.path());
          const auto        is_entry = [&](const std::string &path) {
            return fs::equivalent(path, entry.path(), none);
          };
          if (other.size() > own.size() && belongs(other, own) &&
              belongs(stem, other) && entry.is_regular_file(none) &&
              is_image_name(entry.path()) &&
              std::none_of(masks.begin(), masks.end(), is_entry))
            throw InputError(mask + " may be a mask of " +
                             entry.path().string() + " as well as of " + image +
                             ": name that file among 'Images', too, leave its "
                             "masks out, or move it away if it is no image");
        }
    }



    /** Refuses raters of one image like 'anna' and '2_anna': two persons or
     * one, in two images. */
    void
    require_names_apart(const std::vector<RaterMask> &masks,
                        const std::string            &image)
    {
      for (const RaterMask &a : masks)
        for (const RaterMask &b : masks)
          if (const std::size_t n = b.rater.size() - a.rater.size();
              b.rater.size() > a.rater.size() &&
              b.rater.compare(n, std::string::npos, a.rater) == 0 &&
              std::isalnum(static_cast<unsigned char>(b.rater[n - 1])) == 0)
            throw InputError(b.path + " is by '" + b.rater + "' on " + image +
                             ", or by '" + a.rater +
                             "' on another image: rename it, as " + a.path +
                             " is named, or leave it out");
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
        require_no_other_image(mask, images[owner], masks);
        result[owner].push_back({mask, rater});
      }
    for (std::size_t i = 0; i < images.size(); ++i)
      require_names_apart(result[i], images[i]);
    return result;
  }



  cv::Mat
  read_mask(const std::string &path,
            const Micrograph  &image,
            const int          value,
            const double       largest)
  {
    StoredPixels pixels = read_pixels(path, largest);
    if (pixels.orientation != image.orientation)
      throw InputError(path + " has the orientation tag " +
                       std::to_string(pixels.orientation) + ", its image " +
                       image.path + " " + std::to_string(image.orientation) +
                       ", so that one of them may lie turned over the other: "
                       "save the image upright, without the tag, and draw "
                       "masks on that");
    cv::Mat mask = marks_in(path, pixels, value);
    if (mask.size() == image.grey.size())
      mask = mask(image.frame).clone();
    else if (mask.size() != image.frame.size())
      throw InputError(path + " has " + size_text(mask.size()) +
                       " pixels, its image " + image.path + " has " +
                       size_text(image.grey.size()) +
                       ": draw masks on the image as it is");
    const double part = cv::countNonZero(mask) / double(mask.total());
    if (part > most_marked)
      throw InputError(
        path + " marks " + std::to_string(std::lround(100. * part)) +
        " % of the image: if it is inverted set 'Mask value' to the other "
        "value");
    return mask;
  }
} // namespace squeal::tribology
