// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/blas_kernels.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/base/open_hdf5_files.h>
#include <squeal/base/printable_text.h>
#include <squeal/base/timers.h>
#include <squeal/base/version.h>
#include <squeal/run/command_line.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <iostream>
#include <new>

namespace squeal
{
  namespace
  {
    const std::string run_action = CommandLine().action;

    void
    take_action(CommandLine &line, const std::string &action)
    {
      if (line.action != run_action && line.action != action)
        throw InputError("give one of " + line.action + " and " + action);
      line.action = action;
    }

    /** Refuses what the action would pass over. */
    void
    check_words_are_used(const CommandLine &line)
    {
      const std::string &action    = line.action;
      const bool         is_run    = action == run_action;
      const bool         reads_prm = is_run || action == "--validate";
      const auto         refuse    = [&action](const std::string &word) {
        throw InputError("'" + word + "' has no meaning beside " + action +
                         "; see squeal --help");
      };
      if (!reads_prm && !line.overrides.empty())
        refuse("--set");
      if (!reads_prm && action != "--compare" && !line.files.empty())
        refuse(line.files.front());
      if (!is_run && line.is_quiet)
        refuse("--quiet");
      if (action != "--compare" && line.shows_all)
        throw InputError("'--all' has no meaning without --compare; see "
                         "squeal --help");
    }
  } // namespace



  CommandLine
  read_command_line(const int                       argc,
                    char                          **argv,
                    const std::vector<std::string> &actions)
  {
    CommandLine line;
    for (int i = 1; i < argc; ++i)
      {
        const std::string word = argv[i];
        if (word == "--set")
          {
            if (++i == argc)
              throw InputError("--set needs 'Section/Entry = value'");
            line.overrides.push_back(argv[i]);
          }
        else if (word == "--quiet")
          line.is_quiet = true;
        else if (word == "--all")
          line.shows_all = true;
        else if (word == "-h")
          take_action(line, "--help");
        else if (std::count(actions.begin(), actions.end(), word) > 0)
          take_action(line, word);
        else if (word.size() > 1 && word[0] == '-')
          throw InputError("unknown option '" + word + "'; see squeal --help");
        else
          line.files.push_back(word);
      }
    check_words_are_used(line);
    return line;
  }



  int
  threads_of_rank()
  {
    const char *const variable = std::getenv("SQUEAL_THREADS");
    const std::string text     = variable ? variable : "";
    if (text.empty())
      return 1;
    int               number = 0;
    const char *const end    = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || stop != end || number < 1 ||
        number > blas_kernels::most_threads)
      throw InputError("SQUEAL_THREADS = '" + text +
                       "' is not allowed; give a whole number from 1 to " +
                       std::to_string(blas_kernels::most_threads));
    return number;
  }



  void
  print_version(const std::string &name)
  {
    std::cout << name << " " << version::program << " (" << version::revision
              << ", " << version::build_type << ")\n  compiler "
              << version::compiler << "\n";
    for (const auto &[library, number] : version::libraries)
      std::cout << "  " << library << " " << number << "\n";
    std::cout << "  OpenBLAS kernels " << blas_kernels::in_use() << "\n";
  }



  namespace
  {
    /** Where the memory ran out, threads of OpenBLAS may wait for theirs for
     * ever, and an orderly end would wait for them. */
    [[noreturn]] void
    end_without_memory(const std::string           &text,
                       const std::function<void()> &on_lone_error)
    {
      std::cout.flush();
      std::cerr << "squeal: " << text << std::endl;
      if (on_lone_error)
        on_lone_error();
      std::_Exit(3);
    }

    int
    code_of(const bool                   is_root,
            const std::function<void()> &action,
            const std::function<void()> &on_lone_error)
    {
      const auto fail = [is_root](const std::string &text, const int code) {
        if (is_root)
          std::cerr << "squeal: " << printable_text(text) << std::endl;
        return code;
      };
      try
        {
          action();
        }
      catch (const InputError &e)
        {
          return fail(e.what(), 2);
        }
      catch (const ComputationError &e)
        {
          return fail(e.what(), 3);
        }
      catch (const CheckError &e)
        {
          return fail(e.what(), 4);
        }
      catch (const blas_kernels::NoWorkMemory &e)
        {
          end_without_memory(e.what(), on_lone_error);
        }
      catch (const std::bad_alloc &)
        {
          end_without_memory(
            "the memory ran out, " + rounded_text(peak_memory_mb() / 1000., 2) +
              " GB were in use: a coarser mesh or shorter data, more ranks or "
              "Eigenvalues/Linear solver = out of core need less",
            on_lone_error);
        }
      catch (const std::exception &e)
        {
          std::cerr << "squeal: internal error: " << e.what() << std::endl;
          if (on_lone_error)
            on_lone_error();
          return 1;
        }
      return 0;
    }
  } // namespace



  int
  run_guarded(const bool                   is_root,
              const std::function<void()> &action,
              const std::function<void()> &on_lone_error)
  {
    const int code = code_of(is_root, action, on_lone_error);
    if (hdf5_cannot_end())
      {
        std::cout.flush();
        std::_Exit(code);
      }
    return code;
  }
} // namespace squeal
