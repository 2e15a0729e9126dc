// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/tribology/images/element_map.h>
#include <squeal/tribology/images/image_files.h>
#include <squeal/tribology/images/stored_pixels.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <cmath>
#include <filesystem>

namespace squeal::tribology
{
  namespace
  {
    /** The shapes (width over height) of a map and its view by so much. */
    constexpr double shape_agreement = 0.02;

    /** Refuses colours, but for those hidden under transparency. */
    void
    require_no_colours(const std::string &path, const cv::Mat &opaque)
    {
      const std::string data  = read_file(path);
      const cv::Mat     whole = cv::imdecode(
        cv::Mat(1, int(data.size()), CV_8U, const_cast<char *>(data.data())),
        cv::IMREAD_ANYDEPTH | cv::IMREAD_COLOR);
      cv::Mat channels[3];
      cv::split(whole, channels);
      for (const int k : {1, 2})
        if (cv::norm(channels[0], channels[k], cv::NORM_INF, opaque) > 0.)
          throw InputError(path +
                           " is a map in colours, which hold no numbers: "
                           "save the counts of the element as a grey "
                           "image");
    }



    void
    resize(ElementMap &map, const cv::Size &size)
    {
      if (map.values.size() == size)
        return;
      if (map.seen.empty())
        {
          cv::resize(map.values, map.values, size, 0., 0., cv::INTER_AREA);
          return;
        }
      cv::Mat share;
      map.seen.convertTo(share, CV_32F, 1. / 255.);
      map.values = map.values.mul(share);
      cv::resize(map.values, map.values, size, 0., 0., cv::INTER_AREA);
      cv::resize(share, share, size, 0., 0., cv::INTER_AREA);
      map.seen = share >= 0.5F;
      cv::divide(map.values, cv::max(share, 0.5F), map.values);
    }
  } // namespace



  ElementMap
  read_element_map(const std::string &path, const double largest)
  {
    const StoredPixels pixels = read_pixels(path, largest);
    if (pixels.is_transparent)
      throw InputError(path + " is transparent everywhere: it has no counts "
                              "of an element");
    require_no_colours(path, pixels.opaque);
    ElementMap map;
    map.name = std::filesystem::path(path).stem();
    pixels.values.convertTo(map.values, CV_32F);
    map.seen        = pixels.opaque;
    map.orientation = pixels.orientation;
    return map;
  }



  ElementMap
  element_map_over(const Micrograph  &image,
                   const std::string &path,
                   const double       largest)
  {
    ElementMap map             = read_element_map(path, largest);
    const auto difference_from = [&map](const cv::Size &size) {
      return std::abs(map.values.cols * double(size.height) /
                        (map.values.rows * double(size.width)) -
                      1.);
    };
    if (map.orientation != image.orientation)
      throw InputError(path + " has the orientation tag " +
                       std::to_string(map.orientation) + ", the view of " +
                       image.path + " " + std::to_string(image.orientation) +
                       ", so that one of them may lie turned over the other: "
                       "save both upright, without the tag");
    const cv::Size whole = image.grey.size(), frame = image.frame.size();
    const bool     with_bar = difference_from(whole) <= difference_from(frame);
    if (difference_from(with_bar ? whole : frame) > shape_agreement)
      throw InputError(path + " has " + size_text(map.values.size()) +
                       " pixels, the view of " + image.path + " " +
                       size_text(whole) +
                       ": an element map of that view has its shape");
    resize(map, with_bar ? whole : frame);
    if (with_bar)
      {
        map.values = map.values(image.frame);
        if (!map.seen.empty())
          map.seen = map.seen(image.frame);
      }
    return map;
  }
} // namespace squeal::tribology
