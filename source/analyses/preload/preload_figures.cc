// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/preload/loaded_scene.h>
#include <squeal/analyses/preload/preload_tables.h>
#include <squeal/analyses/run_figures.h>
#include <squeal/base/timers.h>
#include <squeal/model/pressed_model.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace squeal
{
  namespace
  {
    /** Of the last row of a table, NaN where it has none. */
    double
    last_step_of(const Table &table, const std::string &column)
    {
      const std::size_t row = table.n_rows() - 1;
      return table.is_missing(row, column) ? std::nan("not there")
                                           : table.real(row, column);
    }

    /** Diagonal of the box about the points of a contact pair, m. */
    double
    extent_of(const ContactGeometry &geometry)
    {
      dealii::Point<3> low = geometry.points.front(), high = low;
      for (const dealii::Point<3> &x : geometry.points)
        for (unsigned int c = 0; c < 3; ++c)
          {
            low[c]  = std::min(low[c], x[c]);
            high[c] = std::max(high[c], x[c]);
          }
      return low.distance(high);
    }
  } // namespace



  RunFigures
  figures_of_preload(const Parameters &parameters, Timers &timers)
  {
    RunFigures        run;
    const Parameters  p = loaded_scene(parameters);
    Model             model(p, timers, {}, Model::Contacts::open);
    const SteadyModel full =
      pressed_model(p, model, p.eigen.highest_frequency, timers)
        .steady(p.preload.tolerance, timers);
    const auto &contacts = p.scene.contacts;
    LoadSteps   steps(contacts);
    steps.add(full.pressed, full.sliding, 1.);
    const Table &t = steps.table();
    run.n_unknowns = model.n_unknowns();
    run.verdict    = last_step_of(t, "n_open") > 0. ? "part of the face is open"
                                                    : "the whole face is closed";
    run.figures.push_back({"tangential_n", last_step_of(t, "tangential_n")});
    for (unsigned int i = 0; i < contacts.size(); ++i)
      for (const char *name : {"secant_stiffness_n_per_m",
                               "centre_x_m",
                               "centre_y_m",
                               "leading_edge_factor",
                               "peak_pressure_pa"})
        {
          const std::string column = steps.column(i, name);
          RunFigure         figure{column, last_step_of(t, column)};
          if (std::string(name).rfind("centre_", 0) == 0)
            figure.scale = extent_of(full.pressed.nodes().pairs()[i].geometry);
          run.figures.push_back(figure);
        }
    return run;
  }
} // namespace squeal
