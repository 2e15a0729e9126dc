// SPDX-License-Identifier: LGPL-2.1-or-later
// Names beside points of a chart do not cover each other.
#include <squeal/results/label_layout.h>

#include <random>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  const PixelBox panel{0., 0., 1200., 800.};
  const double   font = 16.;

  bool
  inside(const PixelBox &box)
  {
    return box.x_min >= panel.x_min - 1e-9 && box.x_max <= panel.x_max + 1e-9 &&
           box.y_min >= panel.y_min - 1e-9 && box.y_max <= panel.y_max + 1e-9;
  }

  double
  covered(const std::vector<PointLabel> &labels)
  {
    double sum = 0.;
    for (std::size_t i = 0; i < labels.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        sum += labels[i].box.overlap(labels[j].box);
    return sum;
  }
} // namespace

int
main()
{
  check(PixelBox{0, 0, 2, 2}.overlap({1, 1, 3, 4}) == 1. &&
          PixelBox{0, 0, 2, 2}.overlap({2, 0, 3, 1}) == 0.,
        "the area that two boxes share");
  check(text_width("µµµµ", font) == text_width("oooo", font) &&
          text_width("WWWW", font) > text_width("iiii", font),
        "the width counts letters, not bytes");
  const std::string longest = "2345 Hz  µ pad_u 12 = pad_l 34";
  const std::string cut     = shortened(longest, 200., font);
  check(text_width(cut, font) <= 200. && text_width(cut, font) > 170. &&
          cut.substr(0, 7) == "2345 Hz" && cut.substr(cut.size() - 2) == "34" &&
          cut.find("…") != std::string::npos,
        "a long name keeps its start and its end: " + cut);
  check(shortened(longest, 1000., font) == longest &&
          shortened("µµµ", 1., font) == "…",
        "one that fits stays, and of nothing an ellipsis is left");

  std::vector<PointLabel> one = {{600., 400., "5004 Hz  (0,4)+", {}, false}};
  place_labels(one, {}, panel, font);
  check(one[0].box.x_min > 600. && one[0].box.x_min < 620. &&
          !one[0].needs_leader,
        "a name alone stands right of its point");

  std::vector<PointLabel> corner = {{1200., 800., "5004 Hz", {}, false}};
  place_labels(corner, {}, panel, font);
  check(inside(corner[0].box), "a name in the corner stays inside");

  std::mt19937                           random(5);
  std::uniform_real_distribution<double> unit(0., 1.);
  for (int round = 0; round < 10; ++round)
    {
      std::vector<PointLabel> labels;
      for (int i = 0; i < 12; ++i)
        labels.push_back({500. + 250. * unit(random),
                          250. + 300. * unit(random),
                          "5004 Hz  (0,4)+ / support",
                          {},
                          false});
      place_labels(labels, {}, panel, font);
      bool all_inside = true;
      for (const PointLabel &label : labels)
        all_inside = all_inside && inside(label.box);
      check(covered(labels) == 0. && all_inside,
            "twelve names in a crowd stand apart and inside");
    }

  std::vector<PointLabel> beside = {{600., 400., "5004 Hz", {}, false}};
  const PixelBox          wall{605., 300., 900., 500.};
  place_labels(beside, {wall}, panel, font);
  check(beside[0].box.overlap(wall) == 0., "a name gives way to an obstacle");
}
