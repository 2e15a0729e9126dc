// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_allowed_h
#define squeal_parameters_allowed_h

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

// deal.II's header costs seconds in every file that reads it
namespace dealii
{
  namespace Patterns
  {
    class PatternBase;
  }
} // namespace dealii

namespace squeal
{
  namespace prm
  {
    /**
     * What the value of an entry may be: a deal.II pattern, the same in words,
     * and the one way to write a value that the pattern and the structs read
     * (numbers as shortest decimals, "10^3" as "1000"; lists as "a, b"; "yes"
     * as "true"; file names as absolute paths).
     */
    class Allowed
    {
    public:
      enum class Kind
      {
        number,
        integer,
        choice,
        flag,
        text,
        file
      };

      /** A finite number within closed bounds. */
      static Allowed number(
        double lower = std::numeric_limits<double>::lowest(),
        double upper = std::numeric_limits<double>::max());

      /** A finite number greater than 0, up to @p upper. */
      static Allowed positive(
        double upper = std::numeric_limits<double>::max());

      /** A whole number within closed bounds; "2e5" is one. */
      static Allowed integer(int lower,
                             int upper = std::numeric_limits<int>::max());

      /** One of the names. */
      static Allowed one_of(const std::vector<std::string> &names);

      /** true, yes, false or no. */
      static Allowed flag();

      /** Any text. */
      static Allowed text();

      /** The name of a file, made absolute; empty: none. */
      static Allowed file();

      /** A list of unique identifiers, may be empty. */
      static Allowed names();

      /** Between @p smallest and @p largest elements with commas between. */
      static Allowed list(const Allowed &element,
                          unsigned int   smallest = 0,
                          unsigned int   largest  = 1000);

      /** Three numbers. */
      static Allowed vector();

      /** Three numbers that are not all 0. */
      static Allowed direction();

      /** The same as a list that may also be left empty. */
      Allowed or_empty(const std::string &meaning) const;

      /**
       * @p value in the one way described above, ready for the pattern, or
       * nothing if it is not of this kind. Bounds and choices are left to the
       * pattern. Relative file names start from @p directory.
       */
      std::optional<std::string> canonical(const std::string &value,
                                           const std::string &directory) const;

      /** Whether a value in canonical form is allowed. */
      bool matches(const std::string &canonical) const;

      /** The pattern for a ParameterHandler. */
      const dealii::Patterns::PatternBase &pattern() const;

      /** The same in words: "a number from 0 to 0.4999". */
      const std::string &words() const;

      /** Kind of the value or of the elements of the list. */
      Kind kind() const;

      /** Whether it is a list. */
      bool is_list() const;

      /** The choices, if it is one_of() or a list of such. */
      const std::vector<std::string> &choices() const;

    private:
      using Pattern = std::shared_ptr<const dealii::Patterns::PatternBase>;

      Allowed(Kind kind, const Pattern &pattern, const std::string &words);

      std::optional<std::string> canonical_element(
        const std::string &value,
        const std::string &directory) const;

      Kind                     element_kind;
      Pattern                  element_pattern;
      Pattern                  value_pattern;
      std::string              description;
      std::vector<std::string> choice_names;
      bool                     has_elements   = false;
      bool                     may_be_empty   = false;
      bool                     must_be_names  = false;
      bool                     refuses_zero   = false;
      unsigned int             least_elements = 1;
      unsigned int             most_elements  = 1;
    };
  } // namespace prm
} // namespace squeal

#endif
