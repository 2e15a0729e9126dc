// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_exceptions_h
#define squeal_base_exceptions_h

#include <stdexcept>
#include <string>

namespace squeal
{
  /**
   * Something the user can mend: a wrong entry, an unreadable file, a scene
   * that cannot stand. The text is one line, names the parameter or the file
   * to change, and is printed as it is on stderr; the program then ends with
   * exit code 2 and leaves no half-written result behind.
   */
  class InputError : public std::runtime_error
  {
  public:
    explicit InputError(const std::string &text)
      : std::runtime_error(text)
    {
    }
  };

  /**
   * A computation that did not reach what was asked for (no convergence,
   * singular factor, mode count that contradicts the inertia). The text says
   * which setting to change; exit code 3.
   */
  class ComputationError : public std::runtime_error
  {
  public:
    explicit ComputationError(const std::string &text)
      : std::runtime_error(text)
    {
    }
  };

  /**
   * A result check of the parameter file that failed; exit code 4. The result
   * files are complete when it is thrown.
   */
  class CheckError : public std::runtime_error
  {
  public:
    explicit CheckError(const std::string &text)
      : std::runtime_error(text)
    {
    }
  };
} // namespace squeal

#endif
