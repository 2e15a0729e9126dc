// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/statistics/feature_place.h>

#include <algorithm>
#include <cmath>

namespace squeal::tribology
{
  namespace
  {
    /** Half a cell lies beyond the outermost nodes: of the face. */
    constexpr double border_of_face = 0.1;

    /** Of the face: its centre is the origin. */
    constexpr double no_shift = 1e-6;

    /** An edge of the face or of what is seen, m. */
    struct Stretch
    {
      double low, high;

      double
      middle() const
      {
        return 0.5 * (low + high);
      }
    };

    template <typename Places>
    Stretch
    stretch_of(const Places &places, const int axis)
    {
      const auto [low, high] = std::minmax_element(
        places.begin(), places.end(), [axis](const auto &a, const auto &b) {
          return a[axis] < b[axis];
        });
      return {(*low)[axis], (*high)[axis]};
    }
  } // namespace



  FeaturePlace
  place_of_features(const std::vector<std::array<double, 3>> &points,
                    const std::vector<std::array<double, 2>> &places,
                    const bool                                from_centre)
  {
    FeaturePlace place;
    if (places.empty())
      return place;
    bool   stands = true, counts = true; // as it stands, from the centre on
    bool   is_whole = true, is_shifted = false;
    double off_standing = 0., off_counted = 0.;
    for (const int axis : {0, 1})
      {
        const Stretch face  = stretch_of(points, axis),
                      seen  = stretch_of(places, axis);
        const double centre = face.middle(),
                     border = border_of_face * (face.high - face.low);
        const auto lies     = [&](const double by) {
          return seen.low + by >= face.low - border &&
                 seen.high + by <= face.high + border;
        };
        stands   = stands && lies(0.);
        counts   = counts && lies(centre);
        is_whole = is_whole &&
                   seen.high - seen.low >= face.high - face.low - 2. * border;
        is_shifted =
          is_shifted || std::abs(centre) > no_shift * (face.high - face.low);
        off_standing += std::abs(seen.middle() - centre);
        off_counted += std::abs(seen.middle());
        place.shift[axis] = centre;
      }
    const bool is_open = !from_centre && stands && counts && is_shifted;
    place.is_assumed   = is_open && !is_whole;
    if (!from_centre && stands &&
        !(is_open && is_whole && off_counted < off_standing))
      place.shift = {{0., 0.}};
    return place;
  }
} // namespace squeal::tribology
