// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/tribology/images/decoder_messages.h>
#include <squeal/tribology/images/image_tags.h>
#include <squeal/tribology/images/stored_pixels.h>

#include <opencv2/imgcodecs.hpp>

#include <algorithm>

namespace squeal::tribology
{
  namespace
  {
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
      throw InputError(path + " is no PNG, TIFF, JPEG or BMP image, or it "
                              "is damaged");
    }



    ImageSize
    promised_size(const std::string &data, const std::string &path)
    {
      const auto size = image_size(data);
      for (const std::string &begin :
           {std::string("II+\0", 4), std::string("MM\0+", 4)})
        if (data.compare(0, 4, begin) == 0)
          throw InputError(path +
                           " is a BigTIFF, which is not read: save it as "
                           "classic TIFF or PNG");
      if (!size)
        refuse_format(path);
      return *size;
    }



    cv::Mat
    decode(const std::string &data, const std::string &path, const int flags)
    {
      cv::Mat           image;
      const std::string messages = messages_of([&] {
        try
          {
            image = cv::imdecode(
              cv::Mat(1, int(data.size()), CV_8U, const_cast<char *>(&data[0])),
              flags);
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



    void
    require_one_image(const ImageTags &tags, const std::string &path)
    {
      if (tags.n_images > 1)
        throw InputError(path + " is a stack of " +
                         std::to_string(tags.n_images) +
                         " images: save the one that is meant in a file of its "
                         "own");
    }



    /** Fills in what the alpha channel of a file says. */
    void
    read_alpha(const std::string &data,
               const std::string &path,
               const ImageTags   &tags,
               StoredPixels      &pixels)
    {
      const cv::Mat whole = decode(data, path, cv::IMREAD_UNCHANGED);
      // The decoder leaves out what stands beside the grey values of a TIFF.
      if (whole.channels() != 4 && tags.has_extra_samples)
        throw InputError(path + " is a TIFF with transparency or other samples "
                                "beside its grey values, which are not read: "
                                "save it as PNG, or without them");
      if (whole.channels() != 4)
        return;
      cv::Mat alpha;
      double  least, most;
      cv::extractChannel(whole, alpha, 3);
      cv::minMaxLoc(alpha, &least, &most);
      pixels.is_transparent = most == 0.;
      if (least == most)
        return;
      // The decoder turns grey values by the tag, but no alpha.
      if (pixels.orientation != 1)
        throw InputError(path + " is turned by its orientation tag (" +
                         std::to_string(pixels.orientation) +
                         ") and transparent in part: save it upright, without "
                         "the tag");
      pixels.opaque = alpha >= (alpha.depth() == CV_16U ? 32768 : 128);
    }



    /** Of grey images the decoder gives no alpha channel, whatever their tags
     * say. */
    void
    leave_grey(const int transparent, StoredPixels &pixels)
    {
      const cv::Mat opaque  = pixels.values != transparent;
      const int     n       = cv::countNonZero(opaque);
      pixels.is_transparent = n == 0;
      if (n > 0 && n < int(opaque.total()))
        pixels.opaque = opaque;
    }
  } // namespace



  StoredPixels
  read_pixels(const std::string &path, const double largest)
  {
    const std::string data = read_file(path);
    if (data.empty())
      throw InputError(path + " is empty: it has no image");
    require_end_mark(data, path);
    require_room(path, promised_size(data, path), largest);
    const ImageTags tags = image_tags(data);
    require_one_image(tags, path);
    StoredPixels pixels;
    pixels.values =
      decode(data, path, cv::IMREAD_ANYDEPTH | cv::IMREAD_GRAYSCALE);
    const cv::Mat &image = pixels.values;
    if (image.rows < 32 || image.cols < 32)
      throw InputError(path + " has " + std::to_string(image.cols) + " x " +
                       std::to_string(image.rows) +
                       " pixels: at least 32 x 32 are needed");
    if (image.depth() != CV_8U && image.depth() != CV_16U)
      throw InputError(path + ": only images of 8 and 16 bit are read");
    // The decoder inverts images of 8 bit, but none of 16.
    pixels.is_inverted = tags.white_is_zero && image.depth() == CV_16U;
    if (pixels.is_inverted)
      pixels.values = cv::Scalar(65535) - pixels.values;
    pixels.orientation = tags.orientation;
    if (tags.transparent_grey)
      leave_grey(*tags.transparent_grey, pixels);
    else if (tags.may_have_alpha)
      read_alpha(data, path, tags, pixels);
    return pixels;
  }



  cv::Mat
  read_raw(const std::string &path, const double largest)
  {
    return read_pixels(path, largest).values;
  }

} // namespace squeal::tribology
