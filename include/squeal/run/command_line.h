// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_run_command_line_h
#define squeal_run_command_line_h

#include <functional>
#include <string>
#include <vector>

namespace squeal
{
  /** What was typed behind the name of a program. */
  struct CommandLine
  {
    std::string              action = "run"; /**< or the option that says it */
    std::vector<std::string> files, overrides;
    bool                     is_quiet  = false; /**< --quiet */
    bool                     shows_all = false; /**< --all */
  };

  /** Takes the words apart; @p actions are the options that a program knows.
   * Throws InputError. */
  CommandLine read_command_line(int                             argc,
                                char                          **argv,
                                const std::vector<std::string> &actions);

  /** Threads that a rank works with: SQUEAL_THREADS, 1 where it is not set.
   * Throws InputError for what is no whole number from 1 to
   * blas_kernels::most_threads. */
  int threads_of_rank();

  /** Prints "name version (revision, build type)", the compiler and the
   * libraries. */
  void print_version(const std::string &name);

  /**
   * Calls @p action and turns what it throws into one line on stderr (on the
   * root rank: every rank fails alike) and the exit code of the program: 2
   * input, 3 computation or memory, 4 result check, 1 anything else. Memory may
   * run out and anything else may happen on one rank alone: then
   * @p on_lone_error is called.
   */
  int run_guarded(bool                         is_root,
                  const std::function<void()> &action,
                  const std::function<void()> &on_lone_error = {});
} // namespace squeal

#endif
