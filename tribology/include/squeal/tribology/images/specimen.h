// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_specimen_h
#define squeal_tribology_images_specimen_h

#include <opencv2/core.hpp>

#include <functional>
#include <vector>

namespace squeal::tribology
{
  /** What a synthetic specimen shows. Lengths in um, y is the sliding
   * direction and points down in the image. */
  struct SpecimenSettings
  {
    double       width         = 1024.; /**< um, field of view */
    double       height        = 768.;  /**< um */
    double       pixel_size    = 1.;    /**< um */
    double       feature_size  = 1.;    /**< multiplies every feature length */
    double       crack_density = 12.;  /**< cracks per mm^2 at feature size 1 */
    double       exfoliated    = 0.05; /**< share of the area, about */
    double       plateaus      = 0.15; /**< share of the area, about */
    double       noise         = 5.;   /**< grey levels of 255, rms */
    double       shading       = 0.15; /**< brightness change over the field */
    bool         data_bar      = true;
    unsigned int seed          = 1;
    /** Relative rate of cracks at (x, y) in shares of width and height, about
     * 1 on average; empty: the same everywhere. */
    std::function<double(double, double)> rate;
  };

  /** A picture and what is in it. */
  struct Specimen
  {
    cv::Mat  image;       /**< CV_8U, with data bar */
    cv::Mat  cracks;      /**< CV_8U, 255 = crack, size of the image */
    cv::Mat  exfoliation; /**< CV_8U, as above */
    cv::Mat  plateau;     /**< CV_8U, as above */
    cv::Rect scale_bar;   /**< pixels, around the bar; empty: no data bar */
    double   scale_bar_length = 0.; /**< um */
    double   crack_length     = 0.; /**< um, see seen_crack_length() */
    double   crack_area       = 0.; /**< um^2 */
    double   exfoliated_area  = 0.; /**< um^2 */
    int      n_cracks         = 0;
  };

  /**
   * Makes a picture like one of a scanning electron microscope: a bulk with
   * texture of several sizes, bright smooth plateaus, dark rough exfoliations
   * with bright rims, fibres, grooves along the sliding direction, cracks with
   * branches whose width and depth vary, shading, blur, noise of the detector,
   * and a data bar with a scale bar. The same seed gives the same features at
   * every pixel size.
   */
  Specimen make_specimen(const SpecimenSettings &settings);
} // namespace squeal::tribology

#endif
