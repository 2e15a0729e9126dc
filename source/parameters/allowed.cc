// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/allowed.h>
#include <squeal/parameters/names.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

#include <deal.II/base/patterns.h>

#include <cmath>
#include <filesystem>

namespace squeal
{
  namespace prm
  {
    namespace
    {
      namespace Patterns = dealii::Patterns;

      const double lowest  = std::numeric_limits<double>::lowest();
      const double highest = std::numeric_limits<double>::max();

      std::string
      words_of_bounds(const std::string &what,
                      const double       lower,
                      const double       upper)
      {
        const bool has_upper = upper < highest;
        if (lower == lowest && !has_upper)
          return what;
        if (!has_upper)
          return what + " of at least " + format_number(lower);
        if (lower == lowest)
          return what + " of at most " + format_number(upper);
        return what + " from " + format_number(lower) + " to " +
               format_number(upper);
      }



      std::string
      words_of_count(const unsigned int smallest, const unsigned int largest)
      {
        if (smallest == largest)
          return std::to_string(smallest) + " values";
        return smallest == 0 ? "any number of values"
                             : "at least " + std::to_string(smallest) +
                                 (smallest == 1 ? " value" : " values");
      }
    } // namespace



    Allowed::Allowed(const Kind         kind,
                     const Pattern     &pattern,
                     const std::string &words)
      : element_kind(kind)
      , element_pattern(pattern)
      , value_pattern(pattern)
      , description(words)
    {
    }



    Allowed
    Allowed::number(const double lower, const double upper)
    {
      return Allowed(Kind::number,
                     std::make_shared<Patterns::Double>(lower, upper),
                     words_of_bounds("a number", lower, upper));
    }



    Allowed
    Allowed::positive(const double upper)
    {
      const double smallest = std::numeric_limits<double>::min();
      return Allowed(
        Kind::number,
        std::make_shared<Patterns::Double>(smallest, upper),
        std::string("a number greater than 0") +
          (upper < highest ? " and at most " + format_number(upper) : ""));
    }



    Allowed
    Allowed::integer(const int lower, const int upper)
    {
      const bool has_upper = upper < std::numeric_limits<int>::max();
      return Allowed(
        Kind::integer,
        std::make_shared<Patterns::Integer>(lower, upper),
        words_of_bounds("a whole number", lower, has_upper ? upper : highest));
    }



    Allowed
    Allowed::one_of(const std::vector<std::string> &names)
    {
      Allowed allowed(Kind::choice,
                      std::make_shared<Patterns::Selection>(join(names, "|")),
                      "one of " + join(names, ", "));
      allowed.choice_names = names;
      return allowed;
    }



    Allowed
    Allowed::flag()
    {
      return Allowed(
        Kind::flag, std::make_shared<Patterns::Bool>(), "true or false");
    }



    Allowed
    Allowed::text()
    {
      return Allowed(
        Kind::text, std::make_shared<Patterns::Anything>(), "a text");
    }



    Allowed
    Allowed::file()
    {
      return Allowed(Kind::file,
                     std::make_shared<Patterns::Anything>(),
                     "the name of a file");
    }



    Allowed
    Allowed::names()
    {
      Allowed allowed       = list(text());
      allowed.must_be_names = true;
      allowed.description   = "names separated by commas, each once";
      return allowed;
    }



    Allowed
    Allowed::list(const Allowed     &element,
                  const unsigned int smallest,
                  const unsigned int largest)
    {
      Allowed allowed = element;
      allowed.value_pattern =
        std::make_shared<Patterns::List>(element.pattern(), smallest, largest);
      allowed.description = words_of_count(smallest, largest) +
                            " separated by commas, each " + element.words();
      allowed.has_elements   = true;
      allowed.least_elements = smallest;
      allowed.most_elements  = largest;
      return allowed;
    }



    Allowed
    Allowed::vector()
    {
      return list(number(), 3, 3);
    }



    Allowed
    Allowed::direction()
    {
      Allowed allowed      = vector();
      allowed.refuses_zero = true;
      allowed.description += ", not all 0";
      return allowed;
    }



    Allowed
    Allowed::or_empty(const std::string &meaning) const
    {
      Allowed allowed      = *this;
      allowed.may_be_empty = true;
      // canonical() counts the elements
      allowed.value_pattern =
        std::make_shared<Patterns::List>(*element_pattern, 0, most_elements);
      allowed.description += ", or nothing: " + meaning;
      return allowed;
    }



    std::optional<std::string>
    Allowed::canonical_element(const std::string &value,
                               const std::string &directory) const
    {
      switch (element_kind)
        {
        case Kind::number:
          {
            const std::optional<double> number = parse_number(value);
            if (!number)
              return {};
            return format_number(*number);
          }
        case Kind::integer:
          {
            const std::optional<double> number = parse_number(value);
            if (!number || *number != std::floor(*number) ||
                std::abs(*number) > std::numeric_limits<int>::max())
              return {};
            return std::to_string(static_cast<long>(*number));
          }
        case Kind::flag:
          if (value == "yes" || value == "true")
            return "true";
          if (value == "no" || value == "false")
            return "false";
          return {};
        case Kind::choice:
          return collapse_blanks(value);
        case Kind::file:
          if (value.empty())
            return "";
          return (std::filesystem::path(directory) / value)
            .lexically_normal()
            .string();
        case Kind::text:
          return value;
        }
      return {};
    }



    std::optional<std::string>
    Allowed::canonical(const std::string &value,
                       const std::string &directory) const
    {
      if (!has_elements)
        return canonical_element(value, directory);

      std::vector<std::string> elements = split(value, ',');
      if (may_be_empty && elements.empty())
        return "";
      if (elements.size() < least_elements || elements.size() > most_elements)
        return {};
      bool all_zero = true;
      for (std::string &element : elements)
        {
          const std::optional<std::string> text =
            canonical_element(element, directory);
          if (!text)
            return {};
          element  = *text;
          all_zero = all_zero && element == "0";
        }
      if ((refuses_zero && all_zero) ||
          (must_be_names && !fault_of_names(elements).empty()))
        return {};
      return join(elements, ", ");
    }



    bool
    Allowed::matches(const std::string &canonical) const
    {
      return value_pattern->match(canonical);
    }



    const dealii::Patterns::PatternBase &
    Allowed::pattern() const
    {
      return *value_pattern;
    }



    const std::string &
    Allowed::words() const
    {
      return description;
    }



    Allowed::Kind
    Allowed::kind() const
    {
      return element_kind;
    }



    bool
    Allowed::is_list() const
    {
      return has_elements;
    }



    const std::vector<std::string> &
    Allowed::choices() const
    {
      return choice_names;
    }
  } // namespace prm
} // namespace squeal
