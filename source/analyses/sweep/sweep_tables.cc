// SPDX-License-Identifier: LGPL-2.1-or-later

// eigenvalues.csv, unstable_ranges.csv and exceptional_points.csv of a sweep.

#include <squeal/analyses/sweep/sweep_solution.h>
#include <squeal/base/dense_products.h>
#include <squeal/output/cea_quantities.h>
#include <squeal/output/pair_table.h>
#include <squeal/sweep/contact_cells.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace squeal
{
  namespace
  {
    using Complex = std::complex<double>;
    using Type    = Table::Type;

    /** -2 pi Im(x^H (K_f + lambda C_f) x) over |lambda|^2 x^H M x, with
     * x^H M x = 1. */
    std::vector<double>
    friction_energies(const SweepModel                    &model,
                      const std::vector<TermCoefficients> &coefficients,
                      const ComplexPairs                  &pairs)
    {
      std::vector<double> result(pairs.size(), 0.);
      for (std::size_t p = 0; p < coefficients.size(); ++p)
        {
          if (!model.system().merged().terms[p].is_friction ||
              coefficients[p].is_zero())
            continue;
          const Eigen::MatrixXcd F =
            times(model.reduced().parts[p], pairs.right);
          const auto &c = coefficients[p];
          for (unsigned int j = 0; j < pairs.size(); ++j)
            {
              const Complex lambda = pairs.lambda[j];
              const Complex work =
                (lambda * lambda * c.mass + lambda * c.damping + c.stiffness) *
                pairs.right.col(j).dot(F.col(j));
              result[j] -= 2. * M_PI * work.imag() / std::norm(lambda);
            }
        }
      return result;
    }

    /** Empty where the bodies touch nowhere. */
    std::vector<Cell>
    contact_participations(const SweepModel   &model,
                           const ComplexPairs &pairs,
                           const double        mass)
    {
      Eigen::VectorXd sliding = Eigen::VectorXd::Zero(pairs.size());
      Eigen::VectorXd normal  = sliding;
      double          n       = 0.;
      for (const auto &[name, rows] : model.reduced().functionals)
        {
          const bool is_source = name.rfind("source sliding", 0) == 0;
          const bool is_target = name.rfind("target normal", 0) == 0;
          if (!is_source && !is_target)
            continue;
          const Eigen::VectorXd squares =
            times(rows, pairs.right).cwiseAbs2().colwise().sum().transpose();
          (is_source ? sliding : normal) += squares;
          if (is_source)
            n += rows.rows();
        }
      std::vector<Cell> result(pairs.size());
      for (unsigned int j = 0; j < pairs.size() && n > 0.; ++j)
        result[j] = mass * std::sqrt(sliding[j] * normal[j]) / n;
      return result;
    }

    /** Undamped modes are the same for every friction coefficient. */
    class ModeCache
    {
    public:
      explicit ModeCache(const SweepModel &m)
        : model(m)
      {
      }

      const SweepModel::Modes &
      at(const SweepPoint                    &point,
         const std::vector<TermCoefficients> &coefficients)
      {
        std::vector<double> key;
        for (std::size_t i = 0; i < coefficients.size(); ++i)
          if (model.symmetric_parts()[i])
            {
              key.push_back(coefficients[i].mass);
              key.push_back(coefficients[i].stiffness.real());
            }
        auto found = known.find(key);
        if (found == known.end())
          found = known.emplace(key, model.undamped(point)).first;
        return found->second;
      }

    private:
      const SweepModel                                &model;
      std::map<std::vector<double>, SweepModel::Modes> known;
    };

    /** M x of each pair, with the mass at the point. */
    Eigen::MatrixXcd
    mass_products(const SweepModel                    &model,
                  const std::vector<TermCoefficients> &coefficients,
                  const ComplexPairs                  &pairs)
    {
      Eigen::MatrixXcd result =
        Eigen::MatrixXcd::Zero(pairs.right.rows(), pairs.right.cols());
      for (std::size_t p = 0; p < coefficients.size(); ++p)
        if (coefficients[p].mass != 0.)
          result +=
            coefficients[p].mass * times(model.reduced().parts[p], pairs.right);
      return result;
    }

    /** The two undamped modes with the largest MAC. */
    struct Partners
    {
      int    mode[2] = {-1, -1};
      double mac[2]  = {0., 0.};
    };

    Partners
    partners_of(const Eigen::VectorXcd &Mx, const ReducedModes &modes)
    {
      const Eigen::VectorXd mac =
        times(modes.shapes.transpose(), Mx).cwiseAbs2();
      Partners result;
      for (Eigen::Index i = 0; i < mac.size(); ++i)
        if (result.mode[0] < 0 || mac[i] > result.mac[0])
          {
            result.mode[1] = result.mode[0];
            result.mac[1]  = result.mac[0];
            result.mode[0] = i;
            result.mac[0]  = mac[i];
          }
        else if (result.mode[1] < 0 || mac[i] > result.mac[1])
          {
            result.mode[1] = i;
            result.mac[1]  = mac[i];
          }
      return result;
    }

    std::string
    partner_text(const SweepModel::Modes &modes, const Partners &p, const int k)
    {
      const int i = p.mode[k];
      return i < 0 ? ""
                   : modes.names[i].text + " " +
                       rounded_text(
                         std::sqrt(std::max(modes.modes.omega_squared[i], 0.)) /
                           (2. * M_PI),
                         5) +
                       " Hz, MAC " + rounded_text(p.mac[k], 2);
    }

    double
    mesh_error(const SweepModel::Modes &modes, const Partners &p)
    {
      double error = 0., weight = 0.;
      for (int k = 0; k < 2; ++k)
        if (p.mode[k] >= 0 && std::isfinite(modes.mesh_errors[p.mode[k]]))
          {
            error += p.mac[k] * modes.mesh_errors[p.mode[k]];
            weight += p.mac[k];
          }
      return weight > 0.5 ? error / weight : std::nan("");
    }

    /** eigenvalues.csv without rows: the axes in front, their logarithms and
     * the contact state at the end. */
    PairTable
    empty_table(const SweepModel &model)
    {
      const SweepGrid           &grid = model.grid();
      std::vector<Table::Column> axes, at_end;
      for (unsigned int a = 0; a < grid.n_axes(); ++a)
        {
          axes.push_back(
            {grid.axis(a).name, Type::real, "", grid.axis(a).entries[0], 7});
          if (grid.is_logarithmic(a))
            at_end.push_back({"log10_" + grid.axis(a).name,
                              Type::real,
                              "",
                              "common logarithm",
                              7});
        }
      if (model.has_contact_states())
        at_end.push_back(
          {"closed_points", Type::integer, "", "of the contact, there"});
      return {model.model().body_names(), axes, at_end};
    }
  } // namespace



  Table
  sweep_eigenvalue_table(const SweepModel &model, const SweepSolution &solution)
  {
    PairTable        table = empty_table(model);
    ModeCache        modes(model);
    const SweepGrid &grid  = model.grid();
    std::size_t      count = 0;
    for (const auto &line : solution.lines)
      for (const auto &at : line.points)
        {
          if (!at.asked)
            continue;
          SweepPoint point                 = line.start;
          point[0]                         = at.coordinate;
          const ComplexPairs &pairs        = at.pairs;
          const auto          coefficients = model.system().coefficients(point);
          const auto         &undamped     = modes.at(point, coefficients);
          const auto          shares = model.energy_shares(point, pairs.right);
          const auto names    = model.names(pairs.right, shares, pairs.lambda);
          const auto energies = friction_energies(model, coefficients, pairs);
          const auto contacts = contact_participations(
            model, pairs, total_mass(model.model(), grid.scene(point)));
          const Eigen::MatrixXcd Mx = mass_products(model, coefficients, pairs);
          const Eigen::VectorXd  residuals = model.residuals(point, pairs);
          const std::string      state = contact_state_text(grid.scene(point));
          std::vector<Cell>      axes, at_end;
          for (unsigned int a = 0; a < grid.n_axes(); ++a)
            {
              axes.emplace_back(grid.value(a, point[a]));
              if (grid.is_logarithmic(a))
                at_end.emplace_back(point[a]);
            }
          if (model.has_contact_states())
            at_end.emplace_back(model.n_closed(point));
          for (unsigned int j = 0; j < pairs.size(); ++j)
            {
              const Partners partners = partners_of(Mx.col(j), undamped.modes);
              PairRow        row(pairs, j);
              row.point    = count;
              row.branch   = line.branch_names[at.branch[j]];
              row.residual = residuals.size() > 0 ? Cell(residuals[j]) : Cell();
              row.name     = names[j].text;
              for (Eigen::Index b = 0; b < shares.rows(); ++b)
                row.energy_shares.push_back(shares(b, j));
              row.energy_per_cycle      = energies[j];
              row.contact_participation = contacts[j];
              for (unsigned int k = 0; k < 2; ++k)
                row.partners[k] = partner_text(undamped, partners, k);
              row.contact_state        = state;
              row.discretisation_error = mesh_error(undamped, partners);
              table.add(row, axes, at_end);
            }
          ++count;
        }
    return table.table();
  }



  void
  add_fixed_axes(Table &table, const SweepGrid &grid)
  {
    for (unsigned int a = 1; a < grid.n_axes(); ++a)
      table.add_column(
        {grid.axis(a).name, Type::real, "", grid.axis(a).entries[0], 5});
  }

  std::vector<Cell>
  fixed_values(const SweepGrid &grid, const SweepPoint &start)
  {
    std::vector<Cell> cells;
    for (unsigned int a = 1; a < grid.n_axes(); ++a)
      cells.emplace_back(grid.value(a, start[a]));
    return cells;
  }



  Table
  unstable_range_table(const SweepModel &model, const SweepSolution &solution)
  {
    const SweepGrid &grid = model.grid();
    Table            table;
    add_fixed_axes(table, grid);
    for (const Table::Column &column : std::vector<Table::Column>{
           {"branch", Type::text, "", "names at the far ends of the branch"},
           {"parameter", Type::text, "", "that is swept"},
           {"lower", Type::real, "", "sigma = 0, or the last point seen", 6},
           {"upper", Type::real, "", "sigma = 0, or the last point seen", 6},
           {"at_lower_limit", Type::integer, "", "1: goes on below"},
           {"at_upper_limit", Type::integer, "", "1: goes on above"},
           {"peak_sigma_per_s", Type::real, "1/s", "largest sigma", 5},
           {"peak_at", Type::real, "", "there", 6},
           {"frequency_at_peak_hz", Type::real, "Hz", "there", 6},
           {"lower_coordinate", Type::real, "", "logarithm on such an axis", 7},
           {"upper_coordinate", Type::real, "", "logarithm on such an axis", 7},
           {"peak_coordinate", Type::real, "", "logarithm on such an axis", 6},
           {"lower_error_reduction",
            Type::real,
            "",
            "of the coordinate, by the basis",
            2},
           {"upper_error_reduction",
            Type::real,
            "",
            "of the coordinate, by the basis",
            2},
           {"edge_error_discretisation",
            Type::real,
            "",
            "of the coordinates, by the mesh",
            2}})
      table.add_column(column);
    if (model.has_contact_states())
      for (const std::string edge : {"lower", "upper"})
        {
          table.add_column({edge + "_at_contact_change",
                            Type::integer,
                            "",
                            "1: the edge is where the contact state changes, "
                            "between two points"});
          table.add_column({edge + "_error_contact",
                            Type::real,
                            "",
                            "of the coordinate, where the contact state "
                            "changes between two points",
                            2});
        }
    for (const std::string side : {"below", "above"})
      table.add_column({"leaves_band_" + side,
                        Type::integer,
                        "",
                        "1: goes on " + side + ", outside the frequency band"});
    for (const auto &line : solution.lines)
      for (std::size_t i = 0; i < line.ranges.size(); ++i)
        {
          const UnstableRange &r     = line.ranges[i];
          std::vector<Cell>    row   = fixed_values(grid, line.start);
          const auto           error = [&](const double slope) {
            return slope == 0. ? Cell() : Cell(r.sigma_error / std::abs(slope));
          };
          row.insert(row.end(),
                     {line.branch_names[r.branch],
                      grid.axis(0).name,
                      grid.value(0, r.lower),
                      grid.value(0, r.upper),
                      r.at_lower_limit ? 1 : 0,
                      r.at_upper_limit ? 1 : 0,
                      r.peak_sigma,
                      grid.value(0, r.peak_at),
                      r.peak_frequency,
                      r.lower,
                      r.upper,
                      r.peak_at,
                      error(r.lower_slope),
                      error(r.upper_slope),
                      or_missing(line.mesh_errors_of_edges[i])});
          if (model.has_contact_states())
            for (const auto &[x, is_edge] :
                 {std::make_pair(r.lower, r.has_lower_edge()),
                  {r.upper, r.has_upper_edge()}})
              {
                SweepPoint edge = line.start;
                edge[0]         = x;
                row.emplace_back(model.is_at_contact_change(edge) ? 1 : 0);
                row.push_back(is_edge ? Cell(error_by_held_contact(grid, edge))
                                      : Cell());
              }
          row.emplace_back(r.leaves_band_below ? 1 : 0);
          row.emplace_back(r.leaves_band_above ? 1 : 0);
          table.add_row(row);
        }
    return table;
  }



  Table
  exceptional_point_table(const SweepModel    &model,
                          const SweepSolution &solution)
  {
    const SweepGrid &grid = model.grid();
    Table            table;
    add_fixed_axes(table, grid);
    for (const Table::Column &column : std::vector<Table::Column>{
           {"branch_1", Type::text, "", "of the two that coalesce"},
           {"branch_2", Type::text, "", "of the two that coalesce"},
           {"kind", Type::text, "", "for an ascending parameter"},
           {"parameter", Type::text, "", "that is swept"},
           {"coordinate_real", Type::real, "", "logarithm on such an axis", 9},
           {"coordinate_imaginary", Type::real, "", "0 on the real axis", 3},
           {"frequency_hz", Type::real, "Hz", "of both", 7},
           {"sigma_per_s", Type::real, "1/s", "of both", 5},
           {"condition",
            Type::real,
            "",
            "of the eigenvalues at the real part of the coordinate",
            3}})
      table.add_column(column);
    for (const auto &line : solution.lines)
      for (const auto &e : line.exceptional)
        {
          std::vector<Cell> row = fixed_values(grid, line.start);
          row.insert(
            row.end(),
            {line.branch_names[e.branch_1],
             line.branch_names[e.branch_2],
             e.is_lock_in ? "lock-in" : "lock-out",
             grid.axis(0).name,
             e.coordinate.real(),
             e.coordinate.imag(),
             e.frequency,
             e.sigma,
             std::isnan(e.condition) ? Cell() : unbounded(e.condition)});
          table.add_row(row);
        }
    return table;
  }
} // namespace squeal
