// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/interrupt.h>
#include <squeal/base/output_directory.h>
#include <squeal/base/stop_signals.h>

#include <array>
#include <cstring>

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

namespace squeal
{
  namespace
  {
    constexpr std::size_t longest_name = 4096;

    /** What the handler needs, without allocation: a handler has no other way
     * to reach it than a static object. */
    struct InterruptedRun
    {
      std::array<char, longest_name> directory;
      pthread_t                      main_thread;
      int                            folder;
      SignalActions                  former;
    };
    InterruptedRun interrupted_run;

    /** Appends as much of @p text as there is room for. */
    void
    append(char *buffer, std::size_t &size, const char *text)
    {
      while (*text != '\0' && size + 1 < longest_name)
        buffer[size++] = *text++;
      buffer[size] = '\0';
    }

    /** Removes a listed file and its unfinished copy (see AtomicFile). */
    void
    remove_listed(const char *name)
    {
      if (name[0] == '\0' || name[0] == '#' || name[0] == '/' ||
          std::strstr(name, "..") || std::strcmp(name, log_file_name) == 0)
        return;
      ::unlinkat(interrupted_run.folder, name, 0);
      char        partial[longest_name];
      std::size_t size  = 0;
      const char *slash = std::strrchr(name, '/');
      for (const char *c = name; slash && c <= slash; ++c)
        append(partial, size, std::array<char, 2>{{*c, '\0'}}.data());
      append(partial, size, partial_file_prefix);
      append(partial, size, slash ? slash + 1 : name);
      ::unlinkat(interrupted_run.folder, partial, 0);
      if (slash)
        {
          partial[slash - name] = '\0';
          // fails as long as the folder holds something
          ::unlinkat(interrupted_run.folder, partial, AT_REMOVEDIR);
        }
    }

    void
    remove_listed_files()
    {
      const int manifest = ::openat(
        interrupted_run.folder, manifest_file_name, O_RDONLY | O_NONBLOCK);
      char        name[longest_name], buffer[4096];
      std::size_t size = 0;
      for (ssize_t n; (n = ::read(manifest, buffer, sizeof buffer)) > 0;)
        for (ssize_t i = 0; i < n; ++i)
          if (buffer[i] == '\n')
            {
              name[size] = '\0';
              remove_listed(name);
              size = 0;
            }
          else if (size + 1 < longest_name)
            name[size++] = buffer[i];
      ::close(manifest);
    }

    const char *
    name_of(const int signal_number)
    {
      for (const StopSignal &signal : stop_signals)
        if (signal.number == signal_number)
          return signal.name;
      return "a signal";
    }

    void
    end_in_order(const int signal_number)
    {
      if (!::pthread_equal(::pthread_self(), interrupted_run.main_thread))
        {
          ::pthread_kill(interrupted_run.main_thread, signal_number);
          return;
        }
      if (interrupted_run.folder >= 0)
        {
          remove_listed_files();
          char        line[longest_name];
          std::size_t size = 0;
          append(line, size, "squeal: stopped by ");
          append(line, size, name_of(signal_number));
          append(line, size, ": the results in '");
          append(line, size, interrupted_run.directory.data());
          append(line, size, "' were removed, run.log is kept\n");
          // Nothing is left to be done when nobody hears it.
          const ssize_t ignored = ::write(STDERR_FILENO, line, size);
          static_cast<void>(ignored);
        }
      ::_exit(128 + signal_number);
    }
  } // namespace



  InterruptGuard::InterruptGuard(const std::string &directory,
                                 const bool         is_root)
  {
    std::size_t size = 0;
    append(interrupted_run.directory.data(), size, directory.c_str());
    interrupted_run.main_thread = ::pthread_self();
    interrupted_run.folder =
      is_root ? ::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)
              : -1;
    if (is_root && interrupted_run.folder < 0)
      throw InputError("cannot read output directory '" + directory + "'");
    interrupted_run.former = handle_stop_signals(end_in_order);
  }



  InterruptGuard::~InterruptGuard()
  {
    restore_signals(interrupted_run.former);
    if (interrupted_run.folder >= 0)
      ::close(interrupted_run.folder);
  }
} // namespace squeal
