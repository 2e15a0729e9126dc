// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_check_h
#define squeal_tests_check_h

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string>

namespace squeal
{
  namespace testing
  {
    namespace internal
    {
      inline std::string
      digits(const double value)
      {
        char text[32];
        std::snprintf(text, sizeof text, "%.9g", value);
        return text;
      }

      /** A test that is started by hand at the top of the source tree would
       * leave its files there. */
      inline const bool is_in_own_directory = []() {
        if (!std::filesystem::exists(".clang-format"))
          return true;
        std::cerr << "FAILED  run the tests by ctest, or in a directory of "
                     "their own: they write files\n";
        std::exit(1);
      }();
    } // namespace internal

    /** Ends the test with exit code 1 and a line on stderr when not @p ok. */
    inline void
    check(const bool ok, const std::string &text)
    {
      if (ok)
        {
          std::cout << "ok      " << text << std::endl;
          return;
        }
      std::cerr << "FAILED  " << text << std::endl;
      std::exit(1);
    }

    /** |a - b| <= tolerance * max(|b|, floor), b finite. */
    inline void
    check_close(const double       a,
                const double       b,
                const double       tolerance,
                const std::string &text,
                const double       floor = 0.)
    {
      check(std::isfinite(b) &&
              std::abs(a - b) <= tolerance * std::max(std::abs(b), floor),
            text + ": got " + internal::digits(a) + ", expected " +
              internal::digits(b));
    }

    /** Checks that @p action throws @p Exception with @p part in its text. */
    template <typename Exception, typename Action>
    void
    check_throws(const Action      &action,
                 const std::string &part,
                 const std::string &text)
    {
      try
        {
          action();
        }
      catch (const Exception &e)
        {
          check(std::string(e.what()).find(part) != std::string::npos,
                text + " (message: " + e.what() + ")");
          return;
        }
      check(false, text + " (nothing thrown)");
    }
  } // namespace testing
} // namespace squeal

#endif
