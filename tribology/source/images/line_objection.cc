// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/tribology/images/line_objection.h>

namespace squeal::tribology
{
  namespace
  {
    /** What a feature tells from cracks. */
    Exclusion
    kind_of(const LineFeature feature)
    {
      using F = LineFeature;
      switch (feature)
        {
        case F::waviness:
        case F::straight_run:
        case F::parallels:
        case F::turning:
        case F::lay:
        case F::groove:
        case F::through:
          return Exclusion::groove;
        case F::asymmetry:
        case F::far_asymmetry:
        case F::narrowness:
        case F::breadth:
        case F::level:
          return Exclusion::border;
        case F::contrast:
        case F::path:
        case F::coarse_path:
        case F::peak_contrast:
        case F::weak_contrast:
        case F::darkness:
        case F::weak_darkness:
        case F::length:
        case F::texture:
        case F::clutter:
        case F::continuity:
        case F::depth_in_texture:
        case F::depth:
          return Exclusion::faint;
        }
      return Exclusion::faint;
    }



    /** The same for each number that a judge looks at. */
    Exclusion
    kind_of(const int k)
    {
      if (k < n_line_features)
        return kind_of(LineFeature(k));
      const int compared = k - n_line_features;
      if (compared < 2 * int(compared_features.size()))
        return kind_of(compared_features[std::size_t(compared) / 2]);
      return k < n_own_features ? Exclusion::faint : Exclusion::alone;
    }
  } // namespace



  const char *
  name_of(const Exclusion reason)
  {
    switch (reason)
      {
      case Exclusion::groove:
        return "groove or scratch";
      case Exclusion::border:
        return "border of a stain or joint";
      case Exclusion::faint:
        return "faint or broken";
      case Exclusion::alone:
        return "nothing goes on from it";
      case Exclusion::small:
        return "too little in all";
      case Exclusion::rim:
        return "rim of an exfoliation";
      case Exclusion::wide:
        return "wide dark band";
      case Exclusion::scan:
        return "dark row of the scan";
      }
    return "";
  }



  Exclusion
  main_objection(const LineJudge                          &judge,
                 const std::array<double, n_all_features> &features)
  {
    constexpr int own   = n_own_features + int(ContextFeature::alone);
    Exclusion     worst = Exclusion::groove;
    double        best  = -1e9;
    for (const Exclusion kind : {Exclusion::groove,
                                 Exclusion::border,
                                 Exclusion::faint,
                                 Exclusion::alone})
      {
        auto as_cracks = features;
        for (int k = 0; k < n_all_features; ++k)
          if (k != own && kind_of(k) == kind)
            as_cracks[k] = judge.typical[k];
        // Its own odds tell nothing about why, but follow from the others.
        as_cracks[own]    = judge.alone(as_cracks);
        const double odds = judge.in_context(as_cracks);
        if (odds > best)
          {
            best  = odds;
            worst = kind;
          }
      }
    return worst;
  }
} // namespace squeal::tribology
