// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_analyses_exported_scenes_h
#define squeal_tests_analyses_exported_scenes_h

#include "../worst.h"
#include "program.h"
#include "two_pins.h"

#include <squeal/results/table.h>

#include <cmath>

namespace squeal
{
  namespace testing
  {
    /** Settings that a scene and its export share. */
    inline const std::vector<std::string> common_settings = {
      "Output/Plots = false",
      "Output/Report = false",
      "Output/Shapes = none",
      "Overwrite = true",
      "Discretization/Estimate error = false",
      "Eigenvalues/Lowest frequency = 900",
      "Eigenvalues/Highest frequency = 7000",
      "Transient/Disturbance = 1e-8",
      "Transient/Cut-off = 30e3",
      "Transient/Time step = 2e-6",
      "Transient/Sample interval = 2e-5",
      "Transient/End time = 0.02",
      "Transient/History start = 0.005"};

    inline Outcome
    outcome_of(const std::string              &program,
               const std::string              &scene,
               const std::string              &analysis,
               const std::string              &directory,
               const std::vector<std::string> &settings = {})
    {
      write_text("run.prm", scene);
      std::vector<std::string> words = {program};
      for (const auto &list :
           {common_settings,
            {"Analysis = " + analysis, "Output directory = " + directory},
            settings})
        for (const std::string &setting : list)
          words.insert(words.end(), {"--set", setting});
      words.push_back("run.prm");
      return run_program(words);
    }

    inline void
    run_scene(const std::string              &program,
              const std::string              &scene,
              const std::string              &analysis,
              const std::string              &directory,
              const std::vector<std::string> &settings = {})
    {
      const Outcome o =
        outcome_of(program, scene, analysis, directory, settings);
      check(o.code == 0, directory + " runs: " + o.errors);
    }

    /** Largest difference of a column between two tables, over its largest. */
    inline double
    difference(const std::string &a,
               const std::string &b,
               const std::string &name)
    {
      const Table s = read_csv(a), t = read_csv(b);
      check(s.n_rows() == t.n_rows() && s.n_rows() > 0, "as many rows in " + b);
      Worst worst, largest;
      for (std::size_t i = 0; i < s.n_rows(); ++i)
        largest.add(std::abs(s.real(i, name)));
      check(largest.largest() > 0., name + " of " + a + " is not zero");
      for (std::size_t i = 0; i < s.n_rows(); ++i)
        worst.add(std::abs(s.real(i, name) - t.real(i, name)) /
                  largest.largest());
      return worst.largest();
    }

    inline void
    check_same(const std::string              &a,
               const std::string              &b,
               const std::vector<std::string> &columns,
               const double                    tolerance)
    {
      for (const std::string &column : columns)
        {
          const double d = difference(a, b, column);
          check(d <= tolerance,
                column + " of " + b + " differs by " +
                  std::to_string(d / 1e-12) + "e-12 of the largest");
        }
    }

    inline std::string
    replaced(std::string text, const std::string &old, const std::string &own)
    {
      check(text.find(old) != std::string::npos, "'" + old + "' is there");
      for (std::size_t at = 0; (at = text.find(old, at)) != std::string::npos;
           at += own.size())
        text.replace(at, old.size(), own);
      return text;
    }

    /** With springs, and so much friction above that it squeals. */
    inline std::string
    squealing_pins()
    {
      return replaced(replaced(two_pins,
                               "set Formulation          = mortar",
                               "set Formulation          = springs\n"
                               "    set Grid                 = 5, 5\n"
                               "    set Normal stiffness     = 1e8"),
                      "set Friction coefficient = 0.3",
                      "set Friction coefficient = 0.6");
    }
  } // namespace testing
} // namespace squeal

#endif
