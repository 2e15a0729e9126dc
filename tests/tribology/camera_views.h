// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_tribology_camera_views_h
#define squeal_tests_tribology_camera_views_h

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <string>
#include <vector>

namespace squeal::testing
{
  /** The same surface through another camera. */
  struct CameraView
  {
    std::string name;
    cv::Mat     grey;       /**< CV_32F, 0 to 255 */
    cv::Mat     mask;       /**< CV_8U; 128: not part of the surface */
    double      scale = 1.; /**< its pixels in one of the surface */
  };

  inline CameraView
  scaled_view(const cv::Mat &grey, const cv::Mat &mask, const double scale)
  {
    CameraView view{
      scale < 1. ? "half resolution" : "double resolution", {}, {}, scale};
    cv::resize(grey,
               view.grey,
               cv::Size(),
               scale,
               scale,
               scale < 1. ? cv::INTER_AREA : cv::INTER_CUBIC);
    cv::resize(mask, view.mask, view.grey.size(), 0., 0., cv::INTER_NEAREST);
    return view;
  }



  inline CameraView
  gamma_view(const cv::Mat &grey, const cv::Mat &mask, const double gamma)
  {
    CameraView view{
      "gamma " + std::to_string(gamma).substr(0, 4), {}, mask.clone()};
    cv::Mat share = grey / 255.;
    cv::max(share, 0., share);
    cv::pow(share, gamma, view.grey);
    view.grey *= 255.;
    return view;
  }



  inline CameraView
  jpeg_view(const cv::Mat &grey, const cv::Mat &mask, const int quality)
  {
    CameraView view{
      "JPEG of quality " + std::to_string(quality), {}, mask.clone()};
    std::vector<uchar> file;
    cv::Mat            bytes;
    grey.convertTo(bytes, CV_8U);
    cv::imencode(".jpg", bytes, file, {cv::IMWRITE_JPEG_QUALITY, quality});
    cv::imdecode(file, cv::IMREAD_GRAYSCALE).convertTo(view.grey, CV_32F);
    return view;
  }



  inline CameraView
  quarter_turn_view(const cv::Mat &grey, const cv::Mat &mask)
  {
    CameraView view{"turned by 90 degrees", {}, {}};
    cv::rotate(grey, view.grey, cv::ROTATE_90_CLOCKWISE);
    cv::rotate(mask, view.mask, cv::ROTATE_90_CLOCKWISE);
    return view;
  }



  /** Turned about the middle in a frame of the same size; what comes from
   * outside is mirrored and left out of every count. */
  inline CameraView
  turned_view(const cv::Mat &grey, const cv::Mat &mask, const double degrees)
  {
    CameraView view{
      "turned by " + std::to_string(int(degrees)) + " degrees", {}, {}};
    const cv::Mat turn = cv::getRotationMatrix2D(
      cv::Point2f(0.5F * float(grey.cols), 0.5F * float(grey.rows)),
      degrees,
      1.);
    cv::warpAffine(grey,
                   view.grey,
                   turn,
                   grey.size(),
                   cv::INTER_CUBIC,
                   cv::BORDER_REFLECT_101);
    cv::warpAffine(mask,
                   view.mask,
                   turn,
                   mask.size(),
                   cv::INTER_NEAREST,
                   cv::BORDER_CONSTANT,
                   128);
    return view;
  }



  /** White noise of the deviation, grey levels. */
  inline CameraView
  noisy_view(const cv::Mat &grey,
             const cv::Mat &mask,
             const double   deviation,
             const int      seed)
  {
    CameraView view{"noise of " + std::to_string(int(deviation)) + " levels",
                    {},
                    mask.clone()};
    cv::Mat    noise(grey.size(), CV_32F);
    cv::RNG(std::uint64_t(seed)).fill(noise, cv::RNG::NORMAL, 0., deviation);
    view.grey = grey + noise;
    cv::max(view.grey, 0., view.grey);
    cv::min(view.grey, 255., view.grey);
    return view;
  }
} // namespace squeal::testing

#endif
