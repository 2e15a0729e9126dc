// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/preload/loaded_scene.h>
#include <squeal/analyses/preload/stiffness_entry_check.h>
#include <squeal/base/exceptions.h>
#include <squeal/contact/friction_law.h>
#include <squeal/contact/spring_stiffness.h>
#include <squeal/parameters/checks.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <array>

namespace squeal
{
  namespace
  {
    /** Speeds at which friction is compared, over the sliding speed: those of
     * nodes differ where the target turns. */
    constexpr std::array<double, 3> speed_ratios{{.5, 1., 1.5}};

    /** What of a pair steady sliding depends on beside its faces. */
    std::vector<double>
    numbers_of_pair(const ContactParameters &c, const bool with_wear)
    {
      const bool          slides = c.sliding_speed > 0.;
      std::vector<double> result{slides ? 1. : 0.};
      if (slides)
        for (const double ratio : speed_ratios)
          result.push_back(signed_coefficient(c, ratio));
      else
        result.push_back(FrictionLaw(c).at_rest());
      if (with_wear)
        result.push_back(c.sliding_speed);
      if (c.formulation == ContactParameters::Formulation::springs)
        {
          result.push_back(normal_stiffness(c));
          // What slips has its friction whatever the springs along it.
          if (!slides)
            result.push_back(tangential_stiffness(c));
        }
      return result;
    }

    bool
    differ(const Parameters &p, const Parameters &q, const Model &model)
    {
      for (const auto &term : model.linearized().system.terms)
        if (term.coefficients(p.scene).stiffness !=
            term.coefficients(q.scene).stiffness)
          return true;
      const bool wears = p.preload.run_in == PreloadParameters::RunIn::archard;
      for (std::size_t i = 0; i < p.scene.contacts.size(); ++i)
        if (numbers_of_pair(p.scene.contacts[i], wears) !=
            numbers_of_pair(q.scene.contacts[i], wears))
          return true;
      return false;
    }

    bool
    ends_with_name(const std::string &path, const std::string &name)
    {
      return path.size() > name.size() &&
             path.compare(path.size() - name.size(), name.size(), name) == 0;
    }

    /** Whether a number is where the modulus table of a body is read, of a body
     * that has none. */
    bool
    is_of_no_table(const SceneParameters &scene, const std::string &path)
    {
      for (const auto &body : scene.bodies)
        for (const char *name : {"/Temperature", "/Pressure"})
          if (path == "Scene/Body " + body.name + name)
            return !body.has_modulus_table();
      return false;
    }

    std::string
    reason_of_no_effect(const std::string &path)
    {
      if (ends_with_name(path, "/Normal force"))
        return "the loads of the scene press the pairs";
      if (ends_with_name(path, "/Normal stiffness"))
        return "it belongs to springs of the layout 'grid'";
      if (ends_with_name(path, "/Normal stiffness per area"))
        return "it belongs to springs of the layout 'quadrature'";
      if (ends_with_name(path, "/Tangential stiffness"))
        return "it acts in pairs of springs that are at rest";
      if (ends_with_name(path, " damping"))
        return "statics have no damping";
      return "nothing of the scene that carries the loads depends on it as it "
             "stands";
    }
  } // namespace



  void
  check_stiffness_entry(const Parameters &p, const Model &model)
  {
    const std::string         &entry  = p.preload.stiffness_entry;
    const std::vector<double> &values = p.preload.stiffness_values;
    if (entry.empty())
      return;
    const std::string no_effect =
      "= " + prm::in_quotes(entry) + ", which has no effect: ";
    if (is_of_no_table(p.scene, entry))
      prm::refuse_entry("Preload",
                        "Stiffness entry",
                        no_effect + "the body has no 'Modulus table file'");
    if (!is_affine_entry(entry))
      return;
    const bool acts =
      std::any_of(values.begin(), values.end(), [&](const double value) {
        return differ(p, loaded_scene(with_value(p, entry, value)), model);
      });
    // All of one value, that of the scene, are nothing to look at.
    const bool has_other =
      std::any_of(values.begin(), values.end(), [&](const double value) {
        return value != get_number(p, entry);
      });
    if (has_other && !acts)
      prm::refuse_entry(
        "Preload", "Stiffness entry", no_effect + reason_of_no_effect(entry));
  }
} // namespace squeal
