// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/base64.h>
#include <squeal/base/files.h>
#include <squeal/results/motion_view.h>

#include <deal.II/base/exceptions.h>

#include "motion_view_script.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace squeal
{
  namespace
  {
    constexpr double largest_short = 32767.;

    /** In the bytes of the processors that browsers run on: lowest first. */
    template <typename T>
    void
    add_bytes(std::string &bytes, const T value)
    {
      for (unsigned int b = 0; b < sizeof(T); ++b)
        bytes.push_back(static_cast<char>((value >> (8 * b)) & 0xff));
    }

    /** Closes no script: "</" has another spelling in JSON. */
    std::string
    inside_script(std::string json)
    {
      for (std::size_t i = 0; (i = json.find("</", i)) != std::string::npos;)
        json.replace(i, 2, "<\\/");
      return json;
    }

    std::string
    escaped_caption(const std::string &text)
    {
      std::string result;
      for (const char c : text)
        result += c == '&'   ? "&amp;"
                  : c == '<' ? "&lt;"
                  : c == '>' ? "&gt;"
                             : std::string(1, c);
      return result;
    }
  } // namespace



  MotionView::MotionView(const std::vector<SurfaceQuad> &quads,
                         const std::vector<std::string> &bodies,
                         const double                    drawn_largest)
    : body_names(bodies)
    , drawn(drawn_largest)
    , quads_of(bodies.size())
    , n_quads(quads.size())
  {
    std::array<double, 3> low, high;
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (const SurfaceQuad &quad : quads)
      for (const auto &corner : quad.corners)
        for (unsigned int c = 0; c < 3; ++c)
          {
            low[c]  = std::min(low[c], corner[c]);
            high[c] = std::max(high[c], corner[c]);
          }
    for (unsigned int c = 0; c < 3 && !quads.empty(); ++c)
      reach = std::max(reach, 0.5 * (high[c] - low[c]));

    // Corners that coincide on a body are one point.
    std::map<std::array<std::int64_t, 4>, std::uint32_t> number_of;
    for (std::size_t i = 0; i < quads.size(); ++i)
      for (unsigned int k = 0; k < 4; ++k)
        {
          std::array<std::int64_t, 4> key{{quads[i].body}};
          std::array<double, 3>       x;
          for (unsigned int c = 0; c < 3; ++c)
            {
              x[c]       = quads[i].corners[k][c] - 0.5 * (low[c] + high[c]);
              key[c + 1] = std::llround(x[c] / reach * 1e6);
            }
          const auto [place, is_new] =
            number_of.emplace(key, static_cast<std::uint32_t>(source.size()));
          if (is_new)
            {
              source.emplace_back(i, k);
              points.insert(points.end(), x.begin(), x.end());
            }
          quads_of[quads[i].body].push_back(place->second);
        }
  }



  std::vector<double>
  MotionView::at_points(const std::vector<SurfaceQuad> &quads) const
  {
    AssertThrow(quads.size() == n_quads,
                dealii::ExcDimensionMismatch(quads.size(), n_quads));
    std::vector<double> result;
    for (const auto &[quad, corner] : source)
      result.insert(result.end(),
                    quads[quad].displacements[corner].begin(),
                    quads[quad].displacements[corner].end());
    return result;
  }

  std::string
  MotionView::packed(const std::vector<double> &values, const double largest)
  {
    std::string bytes;
    for (const double value : values)
      add_bytes(
        bytes,
        static_cast<std::uint16_t>(static_cast<std::int16_t>(
          largest > 0. ? std::lround(value / largest * largest_short) : 0)));
    return base64(bytes);
  }



  void
  MotionView::add_harmonic(const std::string              &name,
                           const std::vector<SurfaceQuad> &real,
                           const std::vector<SurfaceQuad> &imaginary)
  {
    const std::vector<double> re = at_points(real), im = at_points(imaginary);
    double                    largest = 0.;
    for (std::size_t i = 0; i < re.size(); ++i)
      largest = std::max(largest, std::hypot(re[i], im[i]));
    motions.push_back({name, true, {packed(re, largest), packed(im, largest)}});
  }

  void
  MotionView::add_frames(const std::string                           &name,
                         const std::vector<std::vector<SurfaceQuad>> &frames)
  {
    std::vector<std::vector<double>> all;
    double                           largest = 0.;
    for (const auto &frame : frames)
      {
        all.push_back(at_points(frame));
        for (const double value : all.back())
          largest = std::max(largest, std::abs(value));
      }
    Motion motion{name, false, {}};
    for (const auto &values : all)
      motion.frames.push_back(packed(values, largest));
    motions.push_back(motion);
  }



  std::size_t
  MotionView::n_motions() const
  {
    return motions.size();
  }

  std::size_t
  MotionView::n_points() const
  {
    return source.size();
  }



  std::string
  MotionView::markup(const std::string &caption, const std::string &still) const
  {
    using Json  = nlohmann::ordered_json;
    Json bodies = Json::array(), moving = Json::array();
    for (std::size_t b = 0; b < body_names.size(); ++b)
      {
        std::string bytes;
        for (const std::uint32_t point : quads_of[b])
          add_bytes(bytes, point);
        bodies.push_back({{"name", body_names[b]}, {"quads", base64(bytes)}});
      }
    for (const Motion &motion : motions)
      moving.push_back({{"name", motion.name},
                        {"harmonic", motion.harmonic},
                        {"frames", motion.frames}});
    const Json data = {{"reach", reach},
                       {"drawn", drawn},
                       {"points", packed(points, reach)},
                       {"bodies", bodies},
                       {"motions", moving}};
    return "<figure class=\"motion\"><div class=\"still\">" + still +
           "</div><script type=\"application/json\">" +
           inside_script(data.dump()) + "</script><figcaption>" +
           escaped_caption(caption) + "</figcaption></figure>\n";
  }



  std::string
  MotionView::script()
  {
    const std::string path = SQUEAL_THREE_JS;
    std::error_code   ignored;
    if (!std::filesystem::is_regular_file(path, ignored))
      return "";
    return "<script>/* three.js, copyright its authors, MIT licence: "
           "https://github.com/mrdoob/three.js/blob/dev/LICENSE */\n" +
           read_file(path) + "</script>\n<script>" + motion_view_script +
           "</script>\n<style>" + motion_view_style + "</style>\n";
  }
} // namespace squeal
