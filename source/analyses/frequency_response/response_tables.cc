// SPDX-License-Identifier: LGPL-2.1-or-later

// Frequency responses as tables, HDF5 and universal files.

#include <squeal/analyses/frequency_response/response_solution.h>
#include <squeal/base/files.h>
#include <squeal/base/worst_of.h>
#include <squeal/results/hdf5_file.h>
#include <squeal/results/universal_file.h>

#include <Eigen/QR>

#include <cmath>
#include <map>

namespace squeal
{
  namespace
  {
    using Type = Table::Type;

    constexpr double format_version = 1.;

    const std::string &
    point_name(const Parameters &p, const unsigned int place)
    {
      return p.measurement.points[place].name;
    }

    std::vector<Table::Column>
    with_points(const std::vector<Table::Column> &columns)
    {
      std::vector<Table::Column> result = {
        {"contact_state", Type::text, "", "of all contact pairs"},
        {"excitation", Type::text, "", "point where the force acts"},
        {"response", Type::text, "", "point that is observed"}};
      result.insert(result.end(), columns.begin(), columns.end());
      return result;
    }

    /** Calls @p action with the places of response and excitation in the grid
     * and the three cells that every row begins with. */
    template <typename Action>
    void
    for_each_pair(const Parameters    &p,
                  const ResponseGrid  &grid,
                  const StateResponse &state,
                  const Action        &action)
    {
      for (unsigned int j = 0; j < grid.excitations.size(); ++j)
        for (unsigned int i = 0; i < grid.responses.size(); ++i)
          action(i,
                 j,
                 std::vector<Cell>{state.state,
                                   point_name(p, grid.excitations[j]),
                                   point_name(p, grid.responses[i])});
    }

    /** For each point, what its signal along its unit direction adds to the
     * motion of its node: the sum over the points of a node is the smallest
     * motion that has their signals. Of directions at right angles these are
     * the directions themselves. */
    std::vector<Vector3>
    dual_directions(const MeasurementParameters &m)
    {
      std::map<unsigned int, std::vector<unsigned int>> points_of_node;
      for (unsigned int i = 0; i < m.points.size(); ++i)
        points_of_node[m.node(i)].push_back(i);
      std::vector<Vector3> result(m.points.size());
      for (const auto &[node, points] : points_of_node)
        {
          Eigen::MatrixXd directions(points.size(), 3);
          for (std::size_t j = 0; j < points.size(); ++j)
            directions.row(j) = Eigen::Map<const Eigen::RowVector3d>(
                                  m.points[points[j]].direction.data())
                                  .stableNormalized();
          Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> split;
          // Directions that agree in six digits are meant to be the same.
          split.setThreshold(1e-6);
          split.compute(directions);
          const Eigen::MatrixXd inverse = split.pseudoInverse();
          for (std::size_t j = 0; j < points.size(); ++j)
            result[points[j]] = {{inverse(0, j), inverse(1, j), inverse(2, j)}};
        }
      return result;
    }

    void
    add_row(Table                            &table,
            std::vector<Cell>                 cells,
            const std::initializer_list<Cell> more)
    {
      cells.insert(cells.end(), more.begin(), more.end());
      table.add_row(std::move(cells));
    }
  } // namespace



  Table
  response_table(const Parameters                 &p,
                 const ResponseGrid               &grid,
                 const std::vector<StateResponse> &states)
  {
    const std::string what = grid.quantity;
    Table             table(
      with_points({{"frequency_hz", Type::real, "Hz", "of the force", 7},
                               {"real", Type::real, grid.unit, what + ", in phase", 6},
                               {"imag", Type::real, grid.unit, what + ", out of phase", 6},
                               {"magnitude", Type::real, grid.unit, what, 6},
                               {"phase_deg", Type::real, "deg", "of the response", 5}}));
    for (const auto &state : states)
      for_each_pair(p,
                    grid,
                    state,
                    [&](const unsigned int       i,
                        const unsigned int       j,
                        const std::vector<Cell> &first) {
                      for (std::size_t k = 0; k < grid.frequencies.size(); ++k)
                        {
                          const std::complex<double> h = state.values[k](i, j);
                          add_row(table,
                                  first,
                                  {grid.frequencies[k],
                                   h.real(),
                                   h.imag(),
                                   std::abs(h),
                                   180. / M_PI * std::arg(h)});
                        }
                    });
    return table;
  }



  Table
  participation_table(const Parameters                 &p,
                      const ResponseGrid               &grid,
                      const std::vector<StateResponse> &states)
  {
    Table table(with_points(
      {{"index", Type::integer, "", "number of the mode, from 1"},
       {"frequency_hz", Type::real, "Hz", "of the mode", 6},
       {"sigma_per_s", Type::real, "1/s", "of the mode", 5},
       {"damping_ratio", Type::real, "", "-sigma / |lambda|", 4},
       {"name", Type::text, "", "of the mode"},
       {"residue_real", Type::real, "m/(N s)", "of the receptance", 5},
       {"residue_imag", Type::real, "m/(N s)", "of the receptance", 5},
       {"peak",
        Type::real,
        grid.unit,
        "of this mode alone at its own frequency; nothing without damping",
        5},
       {"share",
        Type::real,
        "",
        "of the sum of the magnitudes of all modes there; nothing without "
        "damping",
        4}}));
    for (const auto &state : states)
      for_each_pair(
        p,
        grid,
        state,
        [&](const unsigned int       i,
            const unsigned int       j,
            const std::vector<Cell> &first) {
          const Eigen::VectorXcd r = state.residues[j].row(i).transpose();
          for (unsigned int k = 0; k < state.pairs.size(); ++k)
            {
              const double f = state.pairs.frequency(k);
              if (f < grid.frequencies.front() || f > grid.frequencies.back())
                continue;
              const bool                 has_bound = !state.is_undamped(k);
              const std::complex<double> s(0., 2. * M_PI * f);
              const Eigen::ArrayXd       sizes =
                (r.array() / (s - state.pairs.lambda.array())).abs();
              const double total = sizes.sum();
              add_row(
                table,
                first,
                {k + 1,
                 f,
                 state.pairs.sigma(k),
                 state.pairs.damping_ratio(k),
                 state.names[k].text,
                 r[k].real(),
                 r[k].imag(),
                 has_bound ? Cell(std::abs(grid.factor(f)) * sizes[k]) : Cell(),
                 has_bound && total > 0. ? Cell(sizes[k] / total) : Cell()});
            }
        });
    return table;
  }



  namespace
  {
    /** Name of mode @p k; the second and later modes of one name have their
     * number in it too, so that a shape can be found by its title. Long names
     * leave room for that, and count as one where they differ behind it. */
    std::string
    title_of(const StateResponse &state, const unsigned int k)
    {
      constexpr std::size_t room      = universal_title_length - 6;
      const auto            beginning = [&](const unsigned int i) {
        return state.names[i].text.substr(0, room);
      };
      unsigned int n = 1;
      for (unsigned int i = 0; i < k; ++i)
        n += beginning(i) == beginning(k);
      return n == 1 ? state.names[k].text
                    : beginning(k) + " #" + std::to_string(n);
    }
  } // namespace



  Table
  response_check_table(const Parameters                 &p,
                       const ResponseGrid               &grid,
                       const std::vector<StateResponse> &states)
  {
    Table table(with_points(
      {{"frequency_hz", Type::real, "Hz", "of the force", 7},
       {"direct_real", Type::real, grid.unit, "full dynamic stiffness", 6},
       {"direct_imag", Type::real, grid.unit, "full dynamic stiffness", 6},
       {"real", Type::real, grid.unit, "superposed modes", 6},
       {"imag", Type::real, grid.unit, "superposed modes", 6},
       {"difference_rel",
        Type::real,
        "",
        "over the largest response at that frequency",
        2},
       {"difference_of_own_rel",
        Type::real,
        "",
        "over the root mean square of this response at all frequencies here; "
        "empty where that is rounding of others",
        2},
       {"difference_of_value_rel",
        Type::real,
        "",
        "over this value itself, which is small next to antiresonances; empty "
        "where the response is rounding of others",
        2}}));
    for (const auto &state : states)
      for_each_pair(
        p,
        grid,
        state,
        [&](const unsigned int       i,
            const unsigned int       j,
            const std::vector<Cell> &first) {
          if (state.checks.empty())
            return;
          const double size = state.size_of_functions()(i, j);
          for (const auto &check : state.checks)
            {
              const auto a = check.exact(i, j), b = check.superposed(i, j);
              add_row(
                table,
                first,
                {check.frequency,
                 a.real(),
                 a.imag(),
                 b.real(),
                 b.imag(),
                 std::abs(b - a) / worst_of(check.exact.cwiseAbs()),
                 std::isfinite(size) ? Cell(std::abs(b - a) / size) : Cell(),
                 std::isfinite(size) && a != 0. ? Cell(std::abs(b / a - 1.))
                                                : Cell()});
            }
        });
    return table;
  }



  Table
  comac_table(const Parameters &p, const std::vector<StateResponse> &states)
  {
    Table table({{"contact_state", Type::text, "", "of all contact pairs"},
                 {"point", Type::text, "", "of Measurement/Points"},
                 {"body", Type::text, "", "of the point"},
                 {"comac",
                  Type::real,
                  "",
                  "agreement there of all measured shapes with the modes most "
                  "like them",
                  4}});
    for (const auto &state : states)
      for (Eigen::Index i = 0; i < state.comac.size(); ++i)
        if (std::isfinite(state.comac[i]))
          table.add_row({state.state,
                         p.measurement.points[i].name,
                         p.measurement.points[i].body,
                         state.comac[i]});
    return table;
  }



  Table
  mac_table(const std::vector<MeasuredShape> &measured,
            const std::vector<StateResponse> &states)
  {
    Table table(
      {{"contact_state", Type::text, "", "of all contact pairs"},
       {"shape", Type::text, "", "measured shape"},
       {"measured_frequency_hz", Type::real, "Hz", "its frequency", 6},
       {"index", Type::integer, "", "number of the mode, from 1"},
       {"frequency_hz", Type::real, "Hz", "of the mode", 6},
       {"name", Type::text, "", "of the mode"},
       {"mac", Type::real, "", "modal assurance criterion", 4},
       {"best", Type::integer, "", "1: the mode most like the shape"}});
    for (const auto &state : states)
      for (std::size_t m = 0; m < measured.size(); ++m)
        {
          Eigen::Index best = -1;
          if (state.mac.cols() > 0)
            state.mac.row(m).maxCoeff(&best);
          for (Eigen::Index k = 0; k < state.mac.cols(); ++k)
            table.add_row({state.state,
                           measured[m].name,
                           measured[m].frequency,
                           k + 1,
                           state.pairs.frequency(k),
                           state.names[k].text,
                           state.mac(m, k),
                           k == best ? 1 : 0});
        }
    return table;
  }



  void
  write_response_hdf5(const std::string                &path,
                      const Parameters                 &p,
                      const ResponseGrid               &grid,
                      const std::vector<StateResponse> &states)
  {
    AtomicFile target(path);
    Hdf5File   file(target.temporary(), Hdf5File::Mode::create);
    file.write_attribute("format", "squeal frequency response");
    file.write_attribute("format_version", format_version);
    file.write_attribute("quantity", grid.quantity);
    file.write_attribute("unit", grid.unit);
    const std::size_t n = grid.frequencies.size();
    file.write("frequency_hz", {n}, grid.frequencies);
    for (const auto &[name, list] :
         {std::make_pair("excitations", &grid.excitations),
          std::make_pair("responses", &grid.responses)})
      {
        std::vector<std::string> names;
        std::vector<double>      nodes, positions, directions;
        for (const unsigned int i : *list)
          {
            const auto &point = p.measurement.points[i];
            names.push_back(point.name);
            nodes.push_back(p.measurement.node(i));
            positions.insert(
              positions.end(), point.position.begin(), point.position.end());
            directions.insert(
              directions.end(), point.direction.begin(), point.direction.end());
          }
        const std::string group = name;
        file.write(group + "/name", names);
        file.write(
          group + "/node", {nodes.size()}, nodes, Hdf5File::Kind::integer32);
        file.write(group + "/position", {nodes.size(), 3}, positions);
        file.write(group + "/direction", {nodes.size(), 3}, directions);
      }
    for (const auto &state : states)
      {
        std::vector<double> real, imag;
        for (unsigned int j = 0; j < grid.excitations.size(); ++j)
          for (unsigned int i = 0; i < grid.responses.size(); ++i)
            for (const auto &value : state.values)
              {
                real.push_back(value(i, j).real());
                imag.push_back(value(i, j).imag());
              }
        const Hdf5File::Dimensions size = {
          grid.excitations.size(), grid.responses.size(), n};
        file.write(state.state + "/real", size, real);
        file.write(state.state + "/imag", size, imag);
      }
    file.close();
    target.commit();
  }



  void
  write_response_universal(const std::string   &path,
                           const Parameters    &p,
                           const ResponseGrid  &grid,
                           const StateResponse &state)
  {
    using Quantity = UniversalFunction::Quantity;
    const auto &m  = p.measurement;
    const auto  at = [&](const unsigned int place) {
      return UniversalPoint{m.points[place].name,
                            m.node(place),
                            universal_direction(m.points[place].direction)};
    };
    std::map<unsigned int, Vector3> nodes;
    for (unsigned int i = 0; i < m.points.size(); ++i)
      nodes.insert({m.node(i), m.points[i].position});
    std::vector<unsigned int> numbers;
    std::vector<Vector3>      positions;
    for (const auto &[number, position] : nodes)
      {
        numbers.push_back(number);
        positions.push_back(position);
      }
    write_atomically(path, [&](std::ostream &out) {
      write_universal_units(out);
      write_universal_nodes(out, numbers, positions);
      for_each_pair(
        p,
        grid,
        state,
        [&](const unsigned int i,
            const unsigned int j,
            const std::vector<Cell> &) {
          UniversalFunction f;
          f.response    = at(grid.responses[i]);
          f.reference   = at(grid.excitations[j]);
          f.quantity    = grid.quantity == "receptance" ? Quantity::displacement
                          : grid.quantity == "mobility" ? Quantity::velocity
                                                        : Quantity::acceleration;
          f.titles      = {{"squeal: " + grid.quantity + " of " + p.scene.name +
                              ", contact state " + state.state,
                            f.response.name + " / " + f.reference.name}};
          f.frequencies = grid.frequencies;
          f.evenly      = grid.is_even;
          for (const auto &value : state.values)
            f.values.push_back(value(i, j));
          write_universal_function(out, f);
        });
      // What the directions at a node show of the motion of each mode.
      const std::vector<Vector3> duals = dual_directions(m);
      for (unsigned int k = 0; k < state.pairs.size(); ++k)
        {
          UniversalShape shape;
          shape.title      = title_of(state, k);
          shape.number     = k + 1;
          shape.eigenvalue = state.pairs.lambda[k];
          shape.nodes      = numbers;
          shape.values.resize(numbers.size());
          for (unsigned int i = 0; i < m.points.size(); ++i)
            {
              const std::size_t place =
                std::distance(nodes.begin(), nodes.find(m.node(i)));
              for (unsigned int c = 0; c < 3; ++c)
                shape.values[place][c] += duals[i][c] * state.shapes(i, k);
            }
          write_universal_shape(out, shape);
        }
    });
  }
} // namespace squeal
