// SPDX-License-Identifier: LGPL-2.1-or-later
#include "abaqus_keywords.h"

#include <algorithm>
#include <map>
#include <set>

// Abaqus takes keywords, options and most words in the place of their values by
// their first letters, and no notice of blanks in them.

namespace squeal
{
  namespace abaqus
  {
    namespace
    {
      /** Shorter ones are no keyword of a file that Abaqus takes. */
      constexpr std::size_t fewest_letters = 3;

      const std::map<std::string, const char *> &
      ways_out()
      {
        static const std::map<std::string, const char *> ways{
          {"INCLUDE", "put the files together"},
          {"IMPORT", "write the mesh itself"},
          {"NGEN", "list the nodes"},
          {"NFILL", "list the nodes"},
          {"NCOPY", "list the nodes"},
          {"NMAP", "list the nodes"},
          {"SYSTEM", "write the nodes in the global system"},
          {"ELGEN", "list the elements"},
          {"ELCOPY", "list the elements"},
          {"IMPERFECTION", "write the moved nodes"},
          {"PARAMETER", "write the numbers themselves"}};
        return ways;
      }

      const std::set<std::string> &
      model_changing()
      {
        static const std::set<std::string> names{"BOUNDARY",
                                                 "CLOAD",
                                                 "COMPOSITE MODAL DAMPING",
                                                 "CONNECTOR SECTION",
                                                 "CONTACT",
                                                 "CONTACT PAIR",
                                                 "COUPLING",
                                                 "CYCLIC SYMMETRY MODEL",
                                                 "DAMPING",
                                                 "DASHPOT",
                                                 "DISTRIBUTING COUPLING",
                                                 "DLOAD",
                                                 "DSLOAD",
                                                 "EMBEDDED ELEMENT",
                                                 "EQUATION",
                                                 "EXPANSION",
                                                 "FASTENER",
                                                 "FOUNDATION",
                                                 "GLOBAL DAMPING",
                                                 "INITIAL CONDITIONS",
                                                 "JOINT",
                                                 "KINEMATIC COUPLING",
                                                 "MASS",
                                                 "MASS ADJUST",
                                                 "MATRIX ASSEMBLE",
                                                 "MATRIX INPUT",
                                                 "MODAL DAMPING",
                                                 "MODEL CHANGE",
                                                 "MPC",
                                                 "NONSTRUCTURAL MASS",
                                                 "PRE-TENSION SECTION",
                                                 "RIGID BODY",
                                                 "ROTARY INERTIA",
                                                 "SHELL TO SOLID COUPLING",
                                                 "SPRING",
                                                 "SUBSTRUCTURE PROPERTY",
                                                 "SURFACE INTERACTION",
                                                 "TEMPERATURE",
                                                 "USER ELEMENT"};
        return names;
      }

      /** Those that are read. */
      const std::set<std::string> &
      read_keywords()
      {
        static const std::set<std::string> names{"PART",
                                                 "END PART",
                                                 "ASSEMBLY",
                                                 "END ASSEMBLY",
                                                 "INSTANCE",
                                                 "NODE",
                                                 "ELEMENT",
                                                 "NSET",
                                                 "END INSTANCE",
                                                 "ELSET",
                                                 "SURFACE",
                                                 "MATERIAL",
                                                 "ELASTIC",
                                                 "SOLID SECTION",
                                                 "DENSITY",
                                                 "TIE",
                                                 "STEP",
                                                 "END STEP",
                                                 "VISCOELASTIC"};
        return names;
      }
    } // namespace



    const char *
    way_out_of(const std::string &keyword)
    {
      const auto it = ways_out().find(keyword);
      return it == ways_out().end() ? nullptr : it->second;
    }

    bool
    changes_model(const std::string &keyword)
    {
      return model_changing().count(keyword) > 0;
    }

    std::string
    without_blanks(std::string text)
    {
      text.erase(
        std::remove_if(text.begin(),
                       text.end(),
                       [](const char c) { return c == ' ' || c == '\t'; }),
        text.end());
      return text;
    }

    bool
    may_stand_for(const std::string &written, const std::string &word)
    {
      return !written.empty() && word.compare(0, written.size(), written) == 0;
    }

    std::vector<std::string>
    full_keywords(const std::string &written)
    {
      const std::string        letters = without_blanks(written);
      std::vector<std::string> found;
      const auto               look_at = [&](const std::string &name) {
        const std::string whole = without_blanks(name);
        if (whole == letters)
          found = {name};
        else if (letters.size() >= fewest_letters &&
                 may_stand_for(letters, whole) &&
                 (found.empty() || without_blanks(found[0]) != letters))
          found.push_back(name);
      };
      for (const auto &[name, way] : ways_out())
        look_at(name);
      for (const std::string &name : model_changing())
        look_at(name);
      for (const std::string &name : read_keywords())
        look_at(name);
      return found;
    }
  } // namespace abaqus
} // namespace squeal
