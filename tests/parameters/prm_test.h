// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_parameters_prm_test_h
#define squeal_tests_parameters_prm_test_h

#include <squeal/base/exceptions.h>

#include <squeal/parameters/parameters.h>

#include "check.h"

#include <fstream>
#include <string>
#include <vector>

namespace squeal
{
  namespace testing
  {
    inline void
    write_text(const std::string &file, const std::string &text)
    {
      std::ofstream out(file, std::ios::binary);
      out << text;
      out.close();
      check(!out.fail(), "wrote " + file);
    }

    /** Text of the InputError that @p action throws; "" if it throws none. */
    template <typename Action>
    std::string
    message_of(const Action &action)
    {
      try
        {
          action();
        }
      catch (const InputError &e)
        {
          return e.what();
        }
      return "";
    }

    /** Checks that @p action is refused by one line with all @p parts. */
    template <typename Action>
    void
    check_refused(const Action                   &action,
                  const std::vector<std::string> &parts,
                  const std::string              &claim)
    {
      const std::string message = message_of(action);
      check(!message.empty(), claim + ": is refused");
      check(message.find('\n') == std::string::npos, claim + ": in one line");
      for (const std::string &part : parts)
        check(message.find(part) != std::string::npos,
              claim + ": says '" + part + "' (message: " + message + ")");
    }

    /** The same for reading a file with this @p text, called test.prm. */
    inline void
    check_text_refused(const std::string              &text,
                       const std::vector<std::string> &parts,
                       const std::string              &claim)
    {
      write_text("test.prm", text);
      check_refused([]() { read_parameters("test.prm"); }, parts, claim);
    }

    /** The same for reading and checking @p file with one override. */
    inline void
    check_override_refused(const std::string              &file,
                           const std::vector<std::string> &overrides,
                           const std::vector<std::string> &parts,
                           const std::string              &claim)
    {
      check_refused(
        [&]() { read_parameters(file, overrides).check(); }, parts, claim);
    }
  } // namespace testing
} // namespace squeal

#endif
