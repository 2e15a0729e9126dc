// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/names.h>
#include <squeal/parameters/text.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      std::string
      lower_case(std::string text)
      {
        for (char &c : text)
          c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        return text;
      }
    } // namespace



    unsigned int
    edit_distance(const std::string &first, const std::string &second)
    {
      const std::string a = lower_case(first);
      const std::string b = lower_case(second);

      // rows of the distance table for one, two letters of a less
      std::vector<unsigned int> before_last, last(b.size() + 1), row;
      for (std::size_t j = 0; j <= b.size(); ++j)
        last[j] = static_cast<unsigned int>(j);
      for (std::size_t i = 1; i <= a.size(); ++i)
        {
          row.assign(b.size() + 1, static_cast<unsigned int>(i));
          for (std::size_t j = 1; j <= b.size(); ++j)
            {
              const unsigned int replace = a[i - 1] == b[j - 1] ? 0 : 1;
              row[j] =
                std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + replace});
              if (i > 1 && j > 1 && a[i - 1] == b[j - 2] &&
                  a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before_last[j - 2] + 1);
            }
          before_last.swap(last);
          last.swap(row);
        }
      return last[b.size()];
    }



    std::string
    nearest_name(const std::string              &name,
                 const std::vector<std::string> &candidates)
    {
      std::string nearest;
      // a third of the letters, but two of a short name
      unsigned int smallest = std::max<unsigned int>(
        3, static_cast<unsigned int>(name.size() / 3) + 1);
      for (const std::string &candidate : candidates)
        {
          // no word is nearer than the difference of the lengths
          const std::size_t longer  = std::max(name.size(), candidate.size());
          const std::size_t shorter = std::min(name.size(), candidate.size());
          if (longer - shorter >= smallest)
            continue;
          const unsigned int distance = edit_distance(name, candidate);
          if (distance < smallest && distance < name.size())
            {
              smallest = distance;
              nearest  = candidate;
            }
        }
      return nearest;
    }



    std::string
    did_you_mean(const std::string              &name,
                 const std::vector<std::string> &candidates)
    {
      const std::string nearest = nearest_name(name, candidates);
      return nearest.empty() ? ""
                             : "; did you mean " + in_quotes(nearest) + "?";
    }



    bool
    is_identifier(const std::string &name)
    {
      const auto is_letter = [](const char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
      };
      const auto may_follow = [&is_letter](const char c) {
        return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
      };
      return !name.empty() && is_letter(name[0]) &&
             std::all_of(name.begin(), name.end(), may_follow);
    }



    std::string
    fault_of_names(const std::vector<std::string> &names)
    {
      std::set<std::string> seen;
      for (const std::string &name : names)
        {
          if (!is_identifier(name))
            return in_quotes(name) + " is not a name: use letters, digits and "
                                     "'_', first a letter";
          if (!seen.insert(name).second)
            return in_quotes(name) + " is there twice";
        }
      return "";
    }
  } // namespace prm
} // namespace squeal
