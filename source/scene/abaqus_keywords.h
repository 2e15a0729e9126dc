// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_source_scene_abaqus_keywords_h
#define squeal_source_scene_abaqus_keywords_h

#include <string>
#include <vector>

namespace squeal
{
  namespace abaqus
  {
    /** What to do instead of a keyword that makes nodes or elements in ways
     * that are not read; null for all other keywords. */
    const char *way_out_of(const std::string &keyword);

    /** Whether a keyword holds, ties, loads or damps parts of the model or adds
     * mass or stiffness to them. */
    bool changes_model(const std::string &keyword);

    /**
     * The keywords with a meaning here that @p written, in capitals, may stand
     * for: blanks do not count, and at least three letters from the start are
     * enough. The keyword itself where it is spelled out; empty where it has no
     * meaning here.
     */
    std::vector<std::string> full_keywords(const std::string &written);

    /** Whether @p written, in capitals, is @p word or its start. */
    bool may_stand_for(const std::string &written, const std::string &word);

    /** Without its blanks. */
    std::string without_blanks(std::string text);
  } // namespace abaqus
} // namespace squeal

#endif
