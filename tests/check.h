// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_check_h
#define squeal_tests_check_h

#include <cmath>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>

namespace squeal
{
  namespace testing
  {
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

    /** |a - b| <= tolerance * max(|b|, floor). */
    inline void
    check_close(const double       a,
                const double       b,
                const double       tolerance,
                const std::string &text,
                const double       floor = 0.)
    {
      check(std::abs(a - b) <= tolerance * std::max(std::abs(b), floor),
            text + ": got " + std::to_string(a) + ", expected " +
              std::to_string(b));
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
