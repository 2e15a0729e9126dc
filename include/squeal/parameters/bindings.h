// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_bindings_h
#define squeal_parameters_bindings_h

#include <squeal/parameters/choices.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>

#include <array>
#include <string>
#include <type_traits>
#include <vector>

namespace squeal
{
  namespace prm
  {
    /** @name Between members of the structs and values in canonical form, that
     * is, values that an Allowed has already accepted. */
    //@{
    inline std::string
    to_text(const std::string &value)
    {
      return value;
    }

    inline void
    from_text(const std::string &text, std::string &value)
    {
      value = text;
    }

    /** Numbers, flags and enumerations. */
    template <typename T>
    std::string
    to_text(const T &value)
    {
      if constexpr (std::is_same_v<T, bool>)
        return value ? "true" : "false";
      else if constexpr (std::is_enum_v<T>)
        return choice_name(value);
      else if constexpr (std::is_integral_v<T>)
        return std::to_string(value);
      else
        return format_number(value);
    }

    template <typename T>
    void
    from_text(const std::string &text, T &value)
    {
      if constexpr (std::is_same_v<T, bool>)
        value = text == "true";
      else if constexpr (std::is_enum_v<T>)
        {
          for (const auto &choice : choices(value))
            if (choice.first == text)
              value = choice.second;
        }
      else
        value = static_cast<T>(parse_number(text).value());
    }

    template <typename T>
    std::string
    to_text(const std::vector<T> &values)
    {
      std::vector<std::string> texts;
      for (const T &value : values)
        texts.push_back(to_text(value));
      return join(texts, ", ");
    }

    template <typename T>
    void
    from_text(const std::string &text, std::vector<T> &values)
    {
      values.clear();
      for (const std::string &part : split(text, ','))
        {
          T value{};
          from_text(part, value);
          values.push_back(value);
        }
    }

    template <typename T, std::size_t n>
    std::string
    to_text(const std::array<T, n> &values)
    {
      return to_text(std::vector<T>(values.begin(), values.end()));
    }

    template <typename T, std::size_t n>
    void
    from_text(const std::string &text, std::array<T, n> &values)
    {
      std::vector<T> read;
      from_text(text, read);
      for (std::size_t i = 0; i < n; ++i)
        values[i] = read.at(i);
    }
    //@}
  } // namespace prm
} // namespace squeal

#endif
