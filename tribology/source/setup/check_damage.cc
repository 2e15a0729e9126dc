// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/checks.h>
#include <squeal/tribology/setup/damage_parameters.h>

#include <algorithm>
#include <initializer_list>

namespace squeal::tribology
{
  namespace
  {
    /** Refuses an entry that somebody set although nothing takes it: the run
     * would tell what it tells without it. */
    void
    refuse_unused(const std::string &section,
                  const std::string &entry,
                  const bool         is_used,
                  const double       value,
                  const double       otherwise,
                  const std::string &users)
    {
      if (!is_used && value != otherwise)
        prm::refuse_entry(section,
                          entry,
                          "is set but not used: it belongs to " + users +
                            "; remove it, or choose one that takes it");
    }



    void
    refuse_unused_strengths(const FatigueParameters &f)
    {
      using M = FatigueParameters::MeanStress;
      const FatigueParameters otherwise;
      const bool has_knee = f.model == FatigueParameters::Model::bilinear;
      const auto refuse   = [](const std::string &entry,
                             const bool         is_used,
                             const double       value,
                             const double       other,
                             const std::string &users) {
        refuse_unused("Fatigue", entry, is_used, value, other, users);
      };
      refuse("Knee stress",
             has_knee,
             f.knee_stress,
             otherwise.knee_stress,
             "'Model = bilinear'");
      refuse("Second exponent",
             has_knee,
             f.second_exponent,
             otherwise.second_exponent,
             "'Model = bilinear'");
      refuse("Ultimate strength",
             f.mean_stress == M::goodman || f.mean_stress == M::gerber,
             f.ultimate_strength,
             otherwise.ultimate_strength,
             "'Mean stress = goodman' and 'gerber'");
      refuse("Strength coefficient",
             f.mean_stress == M::morrow,
             f.strength_coefficient,
             otherwise.strength_coefficient,
             "'Mean stress = morrow'");
      refuse("Walker exponent",
             f.mean_stress == M::walker,
             f.walker_exponent,
             otherwise.walker_exponent,
             "'Mean stress = walker'");
    }



    void
    refuse_unused_limits(const SubsurfaceParameters &s)
    {
      using C        = SubsurfaceParameters::Criterion;
      const auto has = [&s](const std::initializer_list<C> criteria) {
        return std::any_of(criteria.begin(), criteria.end(), [&s](const C c) {
          return std::find(s.criteria.begin(), s.criteria.end(), c) !=
                 s.criteria.end();
        });
      };
      const SubsurfaceParameters otherwise;
      const auto                 refuse = [](const std::string &entry,
                             const bool         is_used,
                             const double       value,
                             const double       other,
                             const std::string &users) {
        refuse_unused("Subsurface", entry, is_used, value, other, users);
      };
      refuse(
        "Torsion ratio",
        has({C::dang_van, C::crossland, C::findley, C::sines, C::fatemi_socie}),
        s.torsion_ratio,
        otherwise.torsion_ratio,
        "the criteria dang van, crossland, findley, sines and fatemi "
        "socie");
      refuse("Repeated limit",
             has({C::sines}),
             s.repeated_limit,
             otherwise.repeated_limit,
             "the criterion sines");
      refuse("Yield stress",
             has({C::fatemi_socie}),
             s.yield_stress,
             otherwise.yield_stress,
             "the criterion fatemi socie");
      refuse("Fatemi Socie factor",
             has({C::fatemi_socie}),
             s.fatemi_socie_k,
             otherwise.fatemi_socie_k,
             "the criterion fatemi socie");
      refuse("Tensile strength",
             has({C::rankine, C::drucker_prager}),
             s.tensile_strength,
             otherwise.tensile_strength,
             "the criteria rankine and drucker prager");
      refuse("Compressive strength",
             has({C::drucker_prager}),
             s.compressive_strength,
             otherwise.compressive_strength,
             "the criterion drucker prager");
      refuse("Plane step",
             has({C::findley, C::swt, C::fatemi_socie}),
             s.plane_step,
             otherwise.plane_step,
             "the criteria findley, swt and fatemi socie");
      refuse("Finest cell",
             s.pad_thickness > 0.,
             s.finest_cell,
             otherwise.finest_cell,
             "a block with 'Pad thickness'");
    }
  } // namespace



  void
  check_fatigue(const FatigueParameters &f)
  {
    const std::string section = "Fatigue";
    if (!f.constants.empty() && f.constants.size() != f.exponents.size())
      prm::refuse_entry(
        section, "Constants", "has not one value for each of 'Exponents'");
    if (f.model == FatigueParameters::Model::bilinear)
      {
        if (f.knee_stress <= 0.)
          prm::refuse_entry(section, "Knee stress", "is needed by 'bilinear'");
        if (f.second_exponent <= 0.)
          prm::refuse_entry(
            section, "Second exponent", "is needed by 'bilinear'");
      }
    using M = FatigueParameters::MeanStress;
    if (f.quantity != FatigueParameters::Quantity::pressure &&
        f.mean_stress != M::none)
      prm::refuse_entry(section,
                        "Mean stress",
                        "is for normal stresses: the mean of a traction has "
                        "the sign of the sliding, not of tension; take 'none', "
                        "or 'Quantity = pressure'");
    if ((f.mean_stress == M::goodman || f.mean_stress == M::gerber) &&
        f.ultimate_strength <= 0.)
      prm::refuse_entry(
        section, "Ultimate strength", "is needed by this 'Mean stress'");
    if (f.mean_stress == M::morrow && f.strength_coefficient <= 0.)
      prm::refuse_entry(
        section, "Strength coefficient", "is needed by 'Mean stress = morrow'");
    if (f.accumulation == FatigueParameters::Accumulation::manson_halford &&
        f.constants.empty())
      prm::refuse_entry(section,
                        "Constants",
                        "are needed by 'Accumulation = manson halford', which "
                        "is not linear");
    refuse_unused_strengths(f);
  }



  void
  check_subsurface(const SubsurfaceParameters &s)
  {
    if (s.compute && s.criteria.empty())
      prm::refuse_entry("Subsurface",
                        "Criteria",
                        "is empty: name one or set 'Compute = false'");
    for (const double depth : s.depths)
      if (s.pad_thickness > 0. && depth >= s.pad_thickness)
        prm::refuse_entry(
          "Subsurface", "Depths", "reach the 'Pad thickness' or beyond");
    if (s.compressive_strength > 0. && s.tensile_strength > 0. &&
        s.compressive_strength < s.tensile_strength)
      prm::refuse_entry(
        "Subsurface", "Compressive strength", "is below 'Tensile strength'");
    if (s.compute)
      refuse_unused_limits(s);
  }
} // namespace squeal::tribology
