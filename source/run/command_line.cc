// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/blas_kernels.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/base/open_hdf5_files.h>
#include <squeal/base/timers.h>
#include <squeal/base/version.h>
#include <squeal/run/command_line.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <new>

namespace squeal
{
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
          line.action = "--help";
        else if (std::count(actions.begin(), actions.end(), word) > 0)
          line.action = word;
        else if (word.size() > 1 && word[0] == '-')
          throw InputError("unknown option '" + word + "'; see squeal --help");
        else
          line.files.push_back(word);
      }
    return line;
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
    int
    code_of(const bool                   is_root,
            const std::function<void()> &action,
            const std::function<void()> &on_lone_error)
    {
      const auto fail = [is_root](const std::string &text, const int code) {
        if (is_root)
          std::cerr << "squeal: " << text << std::endl;
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
      catch (const std::bad_alloc &)
        {
          std::cerr << "squeal: the memory ran out, "
                    << rounded_text(peak_memory_mb() / 1000., 2)
                    << " GB were in use: a coarser mesh or shorter data, more "
                       "ranks or Eigenvalues/Linear solver = out of core need "
                       "less"
                    << std::endl;
          if (on_lone_error)
            on_lone_error();
          return 3;
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
