// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_tribology_lessons_h
#define squeal_tests_tribology_lessons_h

#include <squeal/tribology/images/line_judge.h>
#include <squeal/tribology/images/micrograph.h>
#include <squeal/tribology/images/specimen.h>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <cctype>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "tribology/camera_views.h"
#include "tribology/straight_scenes.h"

namespace squeal::testing
{
  constexpr double narrow_filters = 0.7; // pixels

  /** An image to learn from: its lines, and which of them are cracks. */
  struct Lesson
  {
    static constexpr double on_crack = 3.;   // pixels from the true line
    static constexpr double rest     = 0.02; // of all lines, beside true
    static constexpr int    shortest = 4;    // pixels, of a line that
                                             // teaches

    Lesson(const std::string &name,
           const std::string &specimen,
           const CameraView  &view,
           const double       weight)
      : name(name)
      , specimen(specimen)
      , is_original(view.name.empty())
      , lines(view.grey, tribology::filter_ridges(view.grey, 2, narrow_filters))
    {
      lines.darkness.release();
      if (is_original)
        {
          grey = view.grey;
          mask = view.mask;
        }
      cv::Mat1f     distance(view.grey.size(), 1e3F);
      const cv::Mat line = tribology::thin(view.mask >= 200);
      if (cv::countNonZero(line) > 0)
        cv::distanceTransform(~line, distance, cv::DIST_L2, 5);
      const double within = on_crack * (view.scale < 1. ? 0.75 : view.scale);
      double       all = 0., good = 0.;
      for (const tribology::PixelPath &core : lines.cores)
        {
          double near = 0., ignored = 0.;
          for (const cv::Point &p : core)
            {
              const uchar m = view.mask.at<uchar>(p);
              near += distance(p) <= within;
              ignored += m > 100 && m < 200;
            }
          const double n = double(core.size());
          is_crack.push_back(2. * near > n);
          weights.push_back(
            int(core.size()) < shortest || 2. * ignored > n ? 0. : n);
          all += n;
          good += is_crack.back() ? n : 0.;
        }
      for (double &w : weights)
        w *= weight / (good + rest * all);
    }

    std::string            name, specimen;
    bool                   is_original; /**< no view through another camera */
    cv::Mat                grey, mask;  /**< of originals */
    tribology::JudgedLines lines;
    std::vector<double>    alone; /**< log odds of each line without context */
    std::vector<char>      is_crack;
    std::vector<double>    weights;
  };
  using Lessons = std::vector<std::unique_ptr<Lesson>>;



  /** Images of one object have one name, in both sets. */
  inline std::string
  specimen_of(const std::string &stem)
  {
    // The light on a tile changes, its number is about the same.
    static const std::map<std::string, std::string> tiles = {{"265", "tile A"},
                                                             {"116", "tile B"},
                                                             {"3", "tile C"},
                                                             {"276", "tile D"},
                                                             {"339", "tile E"},
                                                             {"85", "tile F"},
                                                             {"86", "tile F"}};
    if (stem.rfind("mt_exp", 0) == 0)
      {
        const std::string number = stem.substr(stem.rfind('_') + 1);
        return tiles.at(number.substr(0, number.size() - 3));
      }
    // Pieces of one photograph differ by a letter.
    return stem.rfind("uav_", 0) == 0 && std::isdigit(stem.back()) == 0
             ? stem.substr(0, stem.size() - 1)
             : stem;
  }



  /** An image, which has no name, and through other cameras: what is a crack
   * does not depend on them. */
  inline std::vector<CameraView>
  views_of(const cv::Mat &grey, const cv::Mat &mask)
  {
    return {{"", grey, mask, 1.},
            scaled_view(grey, mask, 0.5),
            scaled_view(grey, mask, 2.),
            gamma_view(grey, mask, 0.7),
            gamma_view(grey, mask, 1.4),
            jpeg_view(grey, mask, 50),
            quarter_turn_view(grey, mask),
            noisy_view(grey, mask, 4., 77)};
  }



  /** An image with its mask; none is no crack. */
  struct MaskedImage
  {
    std::string stem;
    cv::Mat     grey, mask;
  };

  inline std::vector<MaskedImage>
  masked_images(const std::filesystem::path &folder)
  {
    std::vector<MaskedImage> images;
    for (const char *kind : {"cracks", "negatives"})
      {
        std::vector<cv::String> files;
        cv::glob((folder / kind / "images" / "*.jpg").string(), files);
        for (const std::string &file : files)
          {
            MaskedImage image;
            image.stem      = std::filesystem::path(file).stem();
            image.grey      = tribology::read_grey(file);
            const auto path = folder / kind / "masks" / (image.stem + ".png");
            image.mask      = std::filesystem::exists(path)
                                ? cv::imread(path.string(), cv::IMREAD_GRAYSCALE)
                                : cv::Mat(cv::Mat::zeros(image.grey.size(), CV_8U));
            images.push_back(image);
          }
      }
    return images;
  }



  inline void
  add_images(Lessons &lessons, const std::filesystem::path &folder)
  {
    const std::vector<MaskedImage> images = masked_images(folder);
    std::vector<Lessons>           found(images.size());
    cv::parallel_for_(cv::Range(0, int(images.size())), [&](const cv::Range r) {
      for (int i = r.start; i < r.end; ++i)
        {
          const auto &[stem, grey, mask]      = images[i];
          const std::vector<CameraView> views = views_of(grey, mask);
          for (const CameraView &view : views)
            found[i].push_back(std::make_unique<Lesson>(
              stem, specimen_of(stem), view, 1. / double(views.size())));
        }
    });
    for (Lessons &of_image : found)
      for (auto &lesson : of_image)
        lessons.push_back(std::move(lesson));
  }



  /** A made specimen, with cracks or without. The weights of lines are shares
   * of the true ones: where there are none they would count for many. */
  inline void
  add_made(Lessons           &lessons,
           const unsigned int seed,
           const double       pixel_size,
           const bool         has_cracks)
  {
    tribology::SpecimenSettings settings;
    settings.seed       = seed;
    settings.pixel_size = pixel_size;
    settings.data_bar   = false;
    if (!has_cracks)
      settings.crack_density = 0.;
    if (pixel_size < 1.)
      {
        settings.width  = 512.;
        settings.height = 384.;
      }
    const tribology::Specimen made = tribology::make_specimen(settings);
    cv::Mat                   grey;
    made.image.convertTo(grey, CV_32F);
    lessons.push_back(
      std::make_unique<Lesson>("made",
                               "",
                               CameraView{"made", grey, made.cracks},
                               has_cracks ? 0.5 : 0.1));
  }



  /** Made specimens and drawn scenes, which are of no specimen. */
  inline void
  add_made(Lessons &lessons)
  {
    unsigned int seed = 900000;
    for (const double pixel_size : {1., 1., 1., 2., 2., 0.5, 0.5, 0.5})
      add_made(lessons, seed++, pixel_size, true);
    seed = 900200;
    for (const double pixel_size : {1., 1., 2., 0.5})
      add_made(lessons, seed++, pixel_size, false);
    for (unsigned int i = 0; i < 8; ++i)
      {
        const StraightScene scene = straight_scene(900100 + i, i % 2 == 1);
        lessons.push_back(std::make_unique<Lesson>(
          "straight", "", CameraView{"drawn", scene.grey, scene.cracks}, 0.5));
      }
  }
} // namespace squeal::testing

#endif
