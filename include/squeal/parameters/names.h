// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_names_h
#define squeal_parameters_names_h

#include <string>
#include <vector>

namespace squeal
{
  namespace prm
  {
    /**
     * Number of insertions, deletions, replacements and swaps of neighbours
     * that turn @p a into @p b, upper and lower case alike (optimal string
     * alignment distance).
     */
    unsigned int edit_distance(const std::string &a, const std::string &b);

    /** The candidate with the smallest edit distance to @p name, the first
     * one of several; empty if none is close enough to be what was meant (more
     * than a third of the letters, at least two, differ). */
    std::string nearest_name(const std::string              &name,
                             const std::vector<std::string> &candidates);

    /** "; did you mean 'x'?" with the nearest candidate, or nothing. */
    std::string did_you_mean(const std::string              &name,
                             const std::vector<std::string> &candidates);

    /** Whether @p name is a letter followed by letters, digits and '_': what
     * bodies and the like may be called, since their names become columns of
     * tables and parts of file names. */
    bool is_identifier(const std::string &name);

    /** Says what is wrong with a list of names, or nothing: each has to be an
     * identifier and may appear once. */
    std::string fault_of_names(const std::vector<std::string> &names);
  } // namespace prm
} // namespace squeal

#endif
