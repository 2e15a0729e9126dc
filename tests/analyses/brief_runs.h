// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_analyses_brief_runs_h
#define squeal_tests_analyses_brief_runs_h

#include "program.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <thread>

namespace squeal
{
  namespace testing
  {
    /** A pin on a beam, coarse, until @p end_time, s. @p more goes to the end of
     * the file. */
    inline std::string
    pin_on_beam(const std::string &folder,
                const std::string &more,
                const std::string &end_time = "0.03")
    {
      return "include " + folder + R"(/pin_on_beam/scene.prm
set Analysis         = transient
set Output directory = out
set Overwrite        = true
subsection Scene
  subsection Body beam
    set Cells = 2, 16, 1
  end
  subsection Body pin
    set Cells = 2, 2, 4
  end
end
subsection Transient
  set Disturbance         = 1e-6
  set Cut-off             = 80e3
  set Time step           = 1e-6
  set Sample interval     = 2e-6
  set End time            = )" +
             end_time +
             R"(
  set History start       = 0
  set Checkpoint interval = 0.05
end
subsection Output
  set Plots = false
end
)" + more;
    }

    /** Three frictions of it. */
    inline std::string
    pin_campaign(const std::string &folder)
    {
      return pin_on_beam(folder,
                         R"(subsection Sweep
  set Axes = mu
  subsection Axis mu
    set Entries = Scene/Contact pin_beam/Friction coefficient
    set Scale   = list
    set Values  = 0.1, 0.2, 0.3, 0.4
  end
end
)",
                         "0.004");
    }

    /** The stability map of the TriboBrake, coarse, about its pair of 5 kHz. */
    inline std::string
    brake_sweep(const std::string &folder)
    {
      return "include " + folder + R"(/tribobrake/calibrated.prm
set Analysis         = sweep
set Output directory = out
set Overwrite        = true
subsection Scene
  subsection Body disc
    set Cells = 16, 3, 1
  end
  subsection Body pad
    set Cells = 2, 2, 2
  end
  subsection Body support
    set Cells = 2, 2, 6
  end
end
subsection Eigenvalues
  set Lowest frequency  = 4400
  set Highest frequency = 5600
end
subsection Sweep
  set Axes            = e_pad, mu
  set Sigma tolerance = 0.5
  subsection Axis e_pad
    set Entries = Scene/Body pad/Young modulus
    set Scale   = logarithmic
    set From    = 10^10
    set To      = 10^10.8
    set Number  = 21
  end
  subsection Axis mu
    set Entries = Scene/Contact pad_disc/Friction coefficient
    set Scale   = list
    set Values  = 0.2, 0.5
  end
end
subsection Output
  set Plots = false
end
)";
    }

    /** Runs @p file in @p directory; @p during as of run_program(). */
    inline Outcome
    run_in(const std::string                         &directory,
           const std::string                         &program,
           const std::string                         &file,
           const std::function<void(const pid_t id)> &during   = {},
           const std::vector<std::string>            &settings = {})
    {
      std::vector<std::string> words = {program};
      for (const std::string &setting : settings)
        words.insert(words.end(), {"--set", setting});
      words.push_back(std::filesystem::absolute(file).string());
      return run_program(
        words,
        [&]() {
          if (::chdir(directory.c_str()) != 0)
            ::_exit(126);
        },
        during);
    }

    /** A CSV file without its column @p name. */
    inline std::string
    without_column(const std::string &csv, const std::string &name)
    {
      std::istringstream in(csv);
      std::string        result;
      std::size_t        column  = std::string::npos;
      bool               is_head = true;
      for (std::string line; std::getline(in, line);)
        {
          if (line.empty() || line[0] == '#')
            {
              result += line + "\n";
              continue;
            }
          std::istringstream cells(line);
          std::size_t        i = 0;
          for (std::string cell; std::getline(cells, cell, ','); ++i)
            {
              if (is_head && cell == name)
                column = i;
              if (i != column)
                result += cell + ",";
            }
          is_head = false;
          result += "\n";
        }
      return result;
    }

    /** @p text without the lines that hold @p part. */
    inline std::string
    without_line(const std::string &text, const std::string &part)
    {
      std::istringstream in(text);
      std::string        result;
      for (std::string line; std::getline(in, line);)
        if (line.find(part) == std::string::npos)
          result += line + "\n";
      return result;
    }

    /** run.json without times, memory and where a basis comes from. */
    inline std::string
    without_times(const std::string &text)
    {
      auto record = nlohmann::ordered_json::parse(text);
      for (const char *name : {"wall_s", "cpu_s", "peak_memory_mb", "timings"})
        record.erase(name);
      for (const char *name :
           {"basis", "steps per second", "CPU seconds until here"})
        record["figures"].erase(name);
      return record.dump(1);
    }

    /**
     * What a run in the directory has left, by file, as it can be compared with
     * that of another one, byte by byte. Left out: times (in run.json
     * and transient.json, the column steps_per_second of tables, the whole of
     * run.log and report.html), the owner in the list of files, and the files
     * that a later run continues from (basis.h5, runs.json), which hold times
     * as well.
     */
    inline std::map<std::string, std::string>
    comparable_results(const std::string &directory)
    {
      auto files = files_below(directory);
      for (const char *name :
           {"run.log", "report.html", "basis.h5", "runs.json"})
        {
          check(name == std::string("basis.h5") ||
                  name == std::string("runs.json") || files.count(name) == 1,
                directory + " has " + name);
          files.erase(name);
        }
      for (auto &[name, text] : files)
        if (name == "run.json")
          text = without_times(text);
        else if (name == "transient.json")
          text = without_line(text, "\"steps_per_second\"");
        else if (name == ".squeal_files")
          text = without_line(text, "# owner");
        else if (name.size() > 4 && name.substr(name.size() - 4) == ".csv")
          text = without_column(text, "steps_per_second");
      check(files.size() >= 4, "results in " + directory);
      return files;
    }

    /** Checks that both hold the same files with the same bytes. */
    inline void
    check_same_results(const std::map<std::string, std::string> &a,
                       const std::map<std::string, std::string> &b,
                       const std::string                        &claim)
    {
      for (const auto &[name, text] : a)
        {
          check(b.count(name) == 1, claim + ": there is " + name);
          check(b.at(name) == text, claim + ": every byte of " + name);
        }
      for (const auto &[name, text] : b)
        check(a.count(name) == 1, claim + ": no further file " + name);
    }

    /** Waits until @p text stands in the log of a run, half a minute at most. */
    inline void
    wait_for_log(const std::string &log, const std::string &text)
    {
      for (unsigned int i = 0; i < 3000; ++i)
        {
          if (text_of(log).find(text) != std::string::npos)
            return;
          std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
      check(false, "'" + text + "' appears in " + log);
    }
  } // namespace testing
} // namespace squeal

#endif
