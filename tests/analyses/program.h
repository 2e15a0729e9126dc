// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_analyses_program_h
#define squeal_tests_analyses_program_h

#include "../check.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

// Without PROGRAMS of squeal_add_test() they are null.
__attribute__((weak)) int main_of_squeal(int argc, char **argv);
__attribute__((weak)) int main_of_squeal_tribology(int argc, char **argv);

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

    inline std::string
    text_of(const std::string &file)
    {
      std::ifstream      in(file, std::ios::binary);
      std::ostringstream text;
      text << in.rdbuf();
      return text.str();
    }

    /** How a program ended: exit code (128 + signal if it was killed) and what
     * it printed. */
    struct Outcome
    {
      int         code;
      std::string output, errors;
    };

    /** What a run has printed with its long lines in one piece again. */
    inline std::string
    unbroken(const std::string &text)
    {
      std::string result;
      for (std::size_t i = 0; i < text.size(); ++i)
        if (text.compare(i, 3, "\n  ") == 0)
          {
            result += ' ';
            i = text.find_first_not_of(' ', i + 1) - 1;
          }
        else
          result += text[i];
      return result;
    }

    /**
     * The main function of a program if it is part of this test, see PROGRAMS
     * of squeal_add_test() in cmake/tests.cmake; else none. run_program() calls
     * it in a copy of this process: to start a program takes half a second, in
     * which its libraries are loaded, and here they are. Not where signals that
     * are ignored from the start on matter.
     */
    inline int (*linked_main(const std::string &program))(int, char **)
    {
      const std::string name = std::filesystem::path(program).filename();
      return name == "squeal"             ? &main_of_squeal
             : name == "squeal-tribology" ? &main_of_squeal_tribology
                                          : nullptr;
    }

    /** Whether run_program() starts programs anew even so. */
    inline bool programs_start_anew = false;

    /** Never returns. A program that finds no kernels of the BLAS set would
     * begin anew, see include/squeal/base/blas_kernels.h: as this test. */
    inline void
    become_program(const std::vector<std::string> &words)
    {
      std::vector<char *> arguments;
      for (const std::string &word : words)
        arguments.push_back(const_cast<char *>(word.c_str()));
      arguments.push_back(nullptr);
      int (*const main)(int, char **) = linked_main(words[0]);
      if (programs_start_anew || !main || !std::getenv("OPENBLAS_CORETYPE"))
        {
          ::execvp(arguments[0], arguments.data());
          ::_exit(127);
        }
      const int code = main(static_cast<int>(words.size()), arguments.data());
      std::cout.flush();
      std::fflush(nullptr);
      ::_exit(code);
    }

    /**
     * Runs a program to its end. @p before (optional) is called in the new
     * process before the program starts, @p during in this one, with the
     * process number, while it runs.
     */
    inline Outcome
    run_program(const std::vector<std::string>            &words,
                const std::function<void()>               &before = {},
                const std::function<void(const pid_t id)> &during = {})
    {
      // Else the copy would print it once more.
      std::cout.flush();
      std::fflush(nullptr);
      const pid_t id = ::fork();
      check(id >= 0, "started " + words[0]);
      if (id == 0)
        {
          for (const auto &[name, stream] :
               {std::pair{"stdout.txt", 1}, {"stderr.txt", 2}})
            ::dup2(::open(name, O_WRONLY | O_CREAT | O_TRUNC, 0666), stream);
          if (before)
            before();
          become_program(words);
        }
      if (during)
        during(id);
      int status = 0;
      ::waitpid(id, &status, 0);
      return {WIFSIGNALED(status) ? 128 + WTERMSIG(status)
                                  : WEXITSTATUS(status),
              text_of("stdout.txt"),
              text_of("stderr.txt")};
    }

    /** Runs @p program on a file of @p text over earlier results, with @p
     * settings, "entry = value" each. */
    inline Outcome
    run_text(const std::string              &program,
             const std::string              &text,
             const std::vector<std::string> &settings = {})
    {
      write_text("run.prm", text);
      std::vector<std::string> words = {program, "--set", "Overwrite = true"};
      for (const std::string &setting : settings)
        words.insert(words.end(), {"--set", setting});
      words.push_back("run.prm");
      return run_program(words);
    }

    /**
     * The command of a transient that takes seconds:
     * prm/tribobrake/transient.prm on coarse meshes with a pad that squeals.
     *
     * @param words      the program, behind what starts it
     * @param folder     the shipped parameter files
     * @param directory  of the results
     * @param settings   further ones, "Section/Entry = value"
     */
    inline std::vector<std::string>
    coarse_transient(std::vector<std::string>        words,
                     const std::string              &folder,
                     const std::string              &directory,
                     const std::vector<std::string> &settings)
    {
      std::vector<std::string> all = {"Scene/Body disc/Cells = 16, 3, 1",
                                      "Scene/Body pad/Cells = 2, 2, 2",
                                      "Scene/Body support/Cells = 2, 2, 6",
                                      "Scene/Support top/Kind = free",
                                      "Scene/Body pad/Young modulus = 1.6e10",
                                      "Transient/Time step = 1e-6",
                                      "Output/Plots = false",
                                      "Output directory = " + directory};
      all.insert(all.end(), settings.begin(), settings.end());
      for (const std::string &setting : all)
        words.insert(words.end(), {"--set", setting});
      words.push_back(folder + "/tribobrake/transient.prm");
      return words;
    }

    /** Path, size and time of every file below @p directory. */
    inline std::map<std::string, std::string>
    files_below(const std::string &directory)
    {
      namespace fs = std::filesystem;
      std::map<std::string, std::string> files;
      if (fs::is_directory(directory))
        for (const auto &entry : fs::recursive_directory_iterator(directory))
          if (entry.is_regular_file())
            files[fs::relative(entry.path(), directory).string()] =
              text_of(entry.path().string());
      return files;
    }

    /** A small brake: a coarse disc, a pad of one cell and 2 x 2 springs. */
    inline const std::string small_brake = R"(set Analysis         = cea
set Output directory = out

subsection Scene
  set Name     = small_brake
  set Bodies   = disc, pad
  set Supports = inner_edge, top
  set Contacts = pad_disc
  subsection Body disc
    set Shape         = annulus
    set Position      = 0, 0, -0.01
    set Cells         = 8, 1, 1
  end
  subsection Body pad
    set Shape         = block
    set Size          = 0.01, 0.01, 0.01
    set Position      = 0.1, 0, 0
    set Cells         = 1, 1, 1
    set Young modulus = 2e10
    set Density       = 2500
    set Poisson ratio = 0.3
  end
  subsection Support inner_edge
    set Body = disc
    set Face = inner
  end
  subsection Support top
    set Body       = pad
    set Face       = z_max
    set Kind       = components
    set Components = x, y
  end
  subsection Contact pad_disc
    set Source body          = pad
    set Source face          = z_min
    set Target body          = disc
    set Target face          = top
    set Grid                 = 2, 2
    set Friction coefficient = 0.3
  end
end
subsection Discretization
  set Degree = 1
end
subsection Eigenvalues
  set Highest frequency = 6000
end
subsection Output
  set Shapes = none
  set Plots  = false
  set Report = false
end
)";

    inline std::string
    replaced_in(std::string text, const std::string &old, const std::string &by)
    {
      const auto at = text.find(old);
      check(at != std::string::npos, "the test changes '" + old + "'");
      return text.replace(at, old.size(), by);
    }
  } // namespace testing
} // namespace squeal

#endif
