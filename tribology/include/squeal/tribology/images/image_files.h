// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_image_files_h
#define squeal_tribology_images_image_files_h

#include <opencv2/core.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace squeal::tribology
{
  /** Whether a file ends in .tif, .tiff, .png, .jpg, .jpeg or .bmp, in any
   * case.
   */
  bool is_image_name(const std::filesystem::path &path);

  /** The files that names and wildcards stand for, each once, sorted within a
   * wildcard. The name of a file that there is stands for that file, whatever
   * it has of *, ? and [. Throws InputError, naming @p entry, when a name or wildcard
   * matches nothing. */
  std::vector<std::string> expand_names(const std::vector<std::string> &names,
                                        const std::string              &entry);

  /** The same for 'Images'. Throws InputError also when two files have the same
   * stem, as their results would. */
  std::vector<std::string> expand_wildcards(
    const std::vector<std::string> &names);

  /**
   * What wildcards miss: for each folder in which one of @p names has a
   * wildcard, a line with the images there that are not among @p files, as
   * SLIDE.TIF beside *.tif. Images are what is_image_name() says.
   */
  std::vector<std::string> missed_images(const std::vector<std::string> &names,
                                         const std::vector<std::string> &files);

  /** Writes a PNG, complete or not at all; @p text goes into a text chunk
   * with the key "squeal". Throws InputError when it cannot be written. */
  void write_png(const std::string &path,
                 const cv::Mat     &image,
                 const std::string &text = "");
} // namespace squeal::tribology

#endif
