// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/entry_traits.h>
#include <squeal/parameters/prm_tree.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <cctype>
#include <map>

namespace squeal
{
  namespace
  {
    /** The declaration, or null. */
    const prm::Schema::Entry *
    declaration(const std::string &path)
    {
      static const prm::GenericSchema generic;
      return generic->find(
        prm::generic_path(prm::normal_path(path.substr(0, path.find('[')))));
    }

    /** Whether the entry is one of an elastic bed, or of contact springs at
     * quadrature points. */
    bool
    is_given_per_area(const std::string &path, const SceneParameters &scene)
    {
      for (const auto &contact : scene.contacts)
        if (contact.layout == ContactParameters::SpringLayout::quadrature &&
            prm::section_of(path) == "Scene/Contact " + contact.name)
          return true;
      for (const auto &spring : scene.springs)
        if (spring.kind == SpringParameters::Kind::area &&
            prm::section_of(path) == "Scene/Spring " + spring.name)
          return true;
      return false;
    }

    /** The letter for a quantity; empty where there is none that all know. */
    std::string
    letter_of(const std::string &entry)
    {
      static const std::map<std::string, std::string> letters = {
        {"Young modulus", "E"},
        {"Young moduli", "E"},
        {"Shear moduli", "G"},
        {"Poisson ratio", "nu"},
        {"Poisson ratios", "nu"},
        {"Density", "rho"},
        {"Mass damping", "alpha"},
        {"Stiffness damping", "beta"},
        {"Structural damping", "eta"},
        {"Friction coefficient", "mu"},
        {"Static friction coefficient", "mu_s"},
        {"Sliding speed", "v"},
        {"Rotation speed", "Omega"},
        {"Normal force", "N"},
        {"Normal stiffness", "k_n"},
        {"Contact normal stiffness", "k_n"},
        {"Tangential stiffness", "k_t"},
        {"Stiffness", "k"},
        {"Stiffnesses", "k"},
        {"Dashpot", "c"},
        {"Dashpots", "c"},
        {"Mass", "m"}};
      const auto found = letters.find(entry);
      return found == letters.end() ? "" : found->second;
    }

    std::string
    lower_case(std::string text)
    {
      for (char &c : text)
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      return text;
    }

    /** "E_pad", "k_t_pad_disc", "pad position [1]". */
    std::string
    symbol_of(const std::string &path, const SceneParameters &scene)
    {
      const std::size_t bracket = path.find('[');
      const std::string whole   = prm::normal_path(path.substr(0, bracket));
      const std::string component =
        bracket == std::string::npos ? "" : prm::trim(path.substr(bracket));
      const std::string section = prm::entry_of(prm::section_of(whole));
      const std::size_t blank   = section.find(' ');
      const bool        is_only =
        is_friction_entry(path) && scene.contacts.size() == 1;
      const std::string member =
        blank == std::string::npos || is_only ? "" : section.substr(blank + 1);
      const std::string entry  = prm::entry_of(whole);
      const std::string letter = letter_of(entry);
      if (letter.empty())
        return (member.empty() ? "" : member + " ") + lower_case(entry) +
               (component.empty() ? "" : " " + component);
      return letter + (member.empty() ? "" : "_" + member) + component;
    }

    /** Whether these are the coefficients of friction of all contacts. */
    bool
    are_all_frictions(const std::vector<std::string> &paths,
                      const SceneParameters          &scene)
    {
      return paths.size() > 1 && paths.size() == scene.contacts.size() &&
             std::all_of(paths.begin(), paths.end(), &is_friction_entry);
    }
  } // namespace



  std::string
  unit_of_entry(const std::string &path, const SceneParameters &scene)
  {
    const prm::Schema::Entry *entry = declaration(path);
    if (!entry || entry->units == "none")
      return "";
    return !entry->units_per_area.empty() &&
               is_given_per_area(prm::normal_path(path), scene)
             ? entry->units_per_area
             : entry->units;
  }

  std::string
  symbol_of_entries(const std::vector<std::string> &paths,
                    const SceneParameters          &scene)
  {
    if (are_all_frictions(paths, scene))
      return "mu of all contacts";
    const std::string first = symbol_of(paths.at(0), scene);
    if (paths.size() == 1)
      return first;
    return first + " and " + std::to_string(paths.size() - 1) +
           (paths.size() == 2 ? " other" : " others");
  }

  std::string
  axis_title(const std::vector<std::string> &paths,
             const SceneParameters          &scene)
  {
    const std::string unit = unit_of_entry(paths.at(0), scene);
    return symbol_of_entries(paths, scene) +
           (unit.empty() ? "" : " in " + unit);
  }

  bool
  is_affine_entry(const std::string &path)
  {
    const prm::Schema::Entry *entry = declaration(path);
    return entry && entry->is_affine;
  }

  bool
  is_friction_entry(const std::string &path)
  {
    const prm::Schema::Entry *entry = declaration(path);
    return entry && entry->is_friction;
  }

  bool
  is_resolution_entry(const std::string &path)
  {
    const prm::Schema::Entry *entry = declaration(path);
    return entry && entry->is_resolution;
  }
} // namespace squeal
