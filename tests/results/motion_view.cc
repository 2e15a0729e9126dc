// SPDX-License-Identifier: LGPL-2.1-or-later
//
// A view that moves holds its surfaces and motions to the bits that it says,
// and needs nothing outside the page.
#include <squeal/results/motion_view.h>

#include "check.h"
#include "worst.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string
  decoded(const std::string &text)
  {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrst"
                               "uvwxyz0123456789+/";
    std::string       bytes;
    unsigned int      buffer = 0, n_bits = 0;
    for (const char c : text)
      if (const auto digit = digits.find(c); digit != std::string::npos)
        {
          buffer = (buffer << 6) | static_cast<unsigned int>(digit);
          if ((n_bits += 6) >= 8)
            bytes.push_back(static_cast<char>(buffer >> (n_bits -= 8)));
        }
    return bytes;
  }

  std::vector<double>
  shorts(const std::string &text, const double largest)
  {
    const std::string   bytes = decoded(text);
    std::vector<double> values;
    for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
      values.push_back(static_cast<std::int16_t>(
                         static_cast<unsigned char>(bytes[i]) |
                         static_cast<unsigned char>(bytes[i + 1]) << 8) /
                       32767. * largest);
    return values;
  }

  std::vector<std::uint32_t>
  numbers(const std::string &text)
  {
    const std::string          bytes = decoded(text);
    std::vector<std::uint32_t> values;
    for (std::size_t i = 0; i + 3 < bytes.size(); i += 4)
      {
        values.push_back(0);
        for (unsigned int b = 0; b < 4; ++b)
          values.back() |=
            std::uint32_t(static_cast<unsigned char>(bytes[i + b])) << (8 * b);
      }
    return values;
  }

  /** A strip of two quads of one body and one of another above it; corners
   * move by @p factor times their place, turned. */
  std::vector<SurfaceQuad>
  strip(const double factor)
  {
    std::vector<SurfaceQuad> quads;
    for (const auto &[x, z, body] : std::vector<std::array<double, 3>>{
           {0., 0., 0.}, {0.1, 0., 0.}, {0.1, 0.04, 1.}})
      {
        SurfaceQuad quad;
        quad.body    = static_cast<unsigned int>(body);
        quad.corners = {{{{x, 0., z}},
                         {{x + 0.1, 0., z}},
                         {{x + 0.1, 0.05, z}},
                         {{x, 0.05, z}}}};
        for (unsigned int k = 0; k < 4; ++k)
          for (unsigned int c = 0; c < 3; ++c)
            quad.displacements[k][c] = factor * quad.corners[k][(c + 1) % 3];
        quads.push_back(quad);
      }
    return quads;
  }

  nlohmann::json
  data_of(const std::string &markup)
  {
    const std::string begin = "<script type=\"application/json\">",
                      end   = "</script>";
    const auto from         = markup.find(begin) + begin.size();
    const auto to           = markup.find(end, from);
    check(markup.find(end, to + 1) == std::string::npos,
          "no name closes the script");
    return nlohmann::json::parse(markup.substr(from, to - from));
  }
} // namespace

int
main()
{
  const auto rest = strip(0.);
  MotionView view(rest, {"disc", "pad </script>"}, 0.004);
  check(view.n_points() == 10,
        "corners that bodies share with themselves only");
  view.add_harmonic("5003 Hz", strip(1e-6), strip(-2e-6));
  view.add_frames("moments", {strip(0.), strip(3e-6), strip(-5e-6)});
  check(view.n_motions() == 2, "two motions");
  check_throws<dealii::ExceptionBase>(
    [&]() { view.add_harmonic("", {rest[0]}, {rest[0]}); },
    "",
    "other surfaces are refused");

  const std::string markup =
    view.markup("growing & <b>moving</b>", "<img alt=\"still\">");
  check(markup.find("growing &amp; &lt;b&gt;") != std::string::npos,
        "the caption is text");
  const auto   data  = data_of(markup);
  const double reach = data["reach"];
  check_close(reach, 0.1, 1e-12, "half of the longest side");
  check_close(double(data["drawn"]), 0.004, 1e-12, "drawn as far as asked");
  check(data["bodies"][1]["name"] == "pad </script>", "names of bodies");

  const auto points = shorts(data["points"], reach);
  const auto first  = shorts(data["motions"][0]["frames"][0], 1.),
             second = shorts(data["motions"][0]["frames"][1], 1.),
             moment = shorts(data["motions"][1]["frames"][1], 1.);
  check(points.size() == 30 && first.size() == 30 && second.size() == 30,
        "three numbers a point");
  const double largest = std::sqrt(5.) * 1e-6 * 0.2, longest = 5e-6 * 0.2;
  Worst        place, motion, moved;
  std::size_t  quad = 0;
  for (unsigned int body = 0; body < 2; ++body)
    {
      const auto corners = numbers(data["bodies"][body]["quads"]);
      check(corners.size() == (body == 0 ? 8u : 4u), "quads of the body");
      for (std::size_t i = 0; i < corners.size(); ++i)
        for (unsigned int c = 0; c < 3; ++c)
          {
            const auto  &x        = rest[quad + i / 4].corners[i % 4];
            const double middle[] = {0.1, 0.025, 0.02};
            const double turned   = x[(c + 1) % 3];
            const auto   at       = 3 * corners[i] + c;
            place.add(std::abs(points[at] - (x[c] - middle[c])) / reach);
            motion.add(std::abs(first[at] - 1e-6 * turned / largest));
            motion.add(std::abs(second[at] + 2e-6 * turned / largest));
            moved.add(std::abs(moment[at] - 3e-6 * turned / longest));
          }
      quad += corners.size() / 4;
    }
  const double bits = 1.001 * std::pow(2., -16);
  check(place.largest() <= bits, "places to 2^-15 of the scene");
  check(motion.largest() <= bits, "displacements to 2^-15 of the largest");
  check(moved.largest() <= bits, "moments on one scale");

  const std::string script = MotionView::script();
  check(!script.empty(), "three.js is installed (package libjs-three)");
  check(script.find("<script src") == std::string::npos &&
          script.find("import(") == std::string::npos,
        "the page loads no script");
  check(script.find("MIT licence") != std::string::npos, "with its licence");
}
