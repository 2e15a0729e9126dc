// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/analyses/preload/preload_tables.h>
#include <squeal/contact/contact_resultant.h>
#include <squeal/contact/friction_law.h>
#include <squeal/contact/pressure_moments.h>
#include <squeal/contact/summed_pairs.h>
#include <squeal/output/contact_output.h>
#include <squeal/results/json_file.h>

#include <nlohmann/json.hpp>

namespace squeal
{
  namespace
  {
    using Type    = Table::Type;
    using Columns = std::vector<Table::Column>;

    std::vector<std::string>
    names_of_several(const std::vector<ContactParameters> &contacts)
    {
      std::vector<std::string> names;
      for (const auto &contact : contacts)
        if (contacts.size() > 1)
          names.push_back(contact.name);
      return names;
    }

    Columns
    force_columns()
    {
      return {{"normal_n",
               Type::real,
               "N",
               "resultant along the mean normal, compression positive"},
              {"tangential_n",
               Type::real,
               "N",
               "along the mean sliding, target on source"},
              {"radial_n",
               Type::real,
               "N",
               "across the sliding, along t x n, target on source",
               3},
              {"n_open", Type::integer, "", "open nodes"},
              {"n_slip", Type::integer, "", "slipping nodes"},
              {"n_stick", Type::integer, "", "sticking nodes"}};
    }

    /** What only a single pair has. */
    Columns
    face_columns()
    {
      return {{"centre_x_m",
               Type::real,
               "m",
               "of pressure, from the face's, across the sliding",
               4},
              {"centre_y_m",
               Type::real,
               "m",
               "of pressure, from the face's, along the sliding",
               4},
              {"leading_edge_factor",
               Type::real,
               "",
               "pressure at the entry edge over the mean of the face",
               4},
              {"mean_pressure_pa", Type::real, "Pa", "over the whole face", 4},
              {"peak_pressure_pa", Type::real, "Pa", "of a node", 4},
              {"approach_m",
               Type::real,
               "m",
               "of the source's far face to the target",
               4},
              {"secant_stiffness_n_per_m",
               Type::real,
               "N/m",
               "normal force over that approach",
               5},
              {"approach_of_load_m",
               Type::real,
               "m",
               "of the loaded face to the target",
               4},
              {"secant_stiffness_of_load_n_per_m",
               Type::real,
               "N/m",
               "normal force over that approach",
               5}};
    }

    std::vector<Cell>
    force_cells(const ContactPair                &pair,
                const Eigen::VectorXd            &forces,
                const std::vector<ContactStatus> &status)
    {
      const auto force = resultant_force(pair.geometry, forces);
      const auto n     = [&](const ContactStatus asked) {
        return static_cast<unsigned int>(
          std::count(status.begin(), status.end(), asked));
      };
      return {force[2],
              force[1],
              force[0],
              n(ContactStatus::open),
              n(ContactStatus::slip),
              n(ContactStatus::stick)};
    }

    /** @p z: all observed motions. @p is_worn: see LoadSteps. */
    std::vector<Cell>
    face_cells(const ContactPair     &pair,
               const unsigned int     number,
               const Eigen::VectorXd &forces,
               const Eigen::VectorXd &z,
               const bool             is_worn)
    {
      const auto r      = contact_resultant(pair.geometry, forces);
      const auto motion = [&](const PressedModel::Observer what) {
        return z[PressedModel::observer(number, what)];
      };
      // Where open nodes leave the gap behind them to the motion of the face,
      // it is no compression.
      const auto compression = [&](const double of_face) {
        return of_face < 0. && r.force[2] > 0. ? std::nan("") : of_face;
      };
      // All round a shaft nothing approaches along one normal.
      const double target = looks_to_one_side(pair.geometry) && !is_worn
                              ? motion(PressedModel::target_at_contact)
                              : std::nan(""),
                   approach =
                     compression(target - motion(PressedModel::far_face)),
                   of_load =
                     compression(target - motion(PressedModel::loaded_face));
      return {or_missing(r.centre[0]),
              or_missing(r.centre[1]),
              or_missing(r.leading_edge_factor),
              r.mean_pressure,
              r.peak_pressure,
              or_missing(approach),
              or_missing(r.force[2] / approach),
              or_missing(of_load),
              or_missing(r.force[2] / of_load)};
    }

    void
    append(const std::vector<Cell> &cells, std::vector<Cell> &row)
    {
      row.insert(row.end(), cells.begin(), cells.end());
    }

    /** Of all pairs. */
    std::vector<Cell>
    sum_cells(const PressedModel &pressed, const SteadySliding &state)
    {
      double      normal = 0., tangential = 0., across = 0.;
      const auto &pairs  = pressed.nodes().pairs();
      const auto  senses = transverse_senses(pressed.nodes());
      for (std::size_t i = 0; i < pairs.size(); ++i)
        if (is_summed(pressed.nodes(), pairs[i]))
          {
            const auto force =
              resultant_force(pairs[i].geometry, pairs[i].part(state.forces));
            normal += force[2];
            tangential += force[1];
            across += senses[i] * force[0];
          }
      return {normal,
              tangential,
              across,
              state.n_with(ContactStatus::open),
              state.n_with(ContactStatus::slip),
              state.n_with(ContactStatus::stick)};
    }
  } // namespace



  LoadSteps::LoadSteps(const std::vector<ContactParameters> &contacts,
                       const bool                            worn)
    : names(names_of_several(contacts))
    , is_worn(worn)
    , steps({{"load_share", Type::real, "", "share of the load", 3}})
  {
    for (const auto &column : force_columns())
      steps.add_column(column);
    if (names.empty())
      for (const auto &column : face_columns())
        steps.add_column(column);
    for (unsigned int i = 0; i < names.size(); ++i)
      for (const Columns &columns : {force_columns(), face_columns()})
        for (Table::Column one : columns)
          {
            one.name = column(i, one.name);
            steps.add_column(one);
          }
    steps.add_column(
      {"newton_iterations", Type::integer, "", "of the last friction step"});
    steps.add_column({"residual_rel", Type::real, "", "of the contact law", 2});
  }



  void
  LoadSteps::add(const PressedModel  &pressed,
                 const SteadySliding &state,
                 const double         share)
  {
    const Eigen::VectorXd z =
      pressed.model().observed.evaluate(state.coordinates, share, state.forces);
    const auto       &pairs = pressed.nodes().pairs();
    std::vector<Cell> row   = {share};
    if (pairs.size() > 1)
      append(sum_cells(pressed, state), row);
    for (unsigned int i = 0; i < pairs.size(); ++i)
      {
        const Eigen::VectorXd forces = pairs[i].part(state.forces);
        append(force_cells(pairs[i], forces, pairs[i].part(state.status)), row);
        append(face_cells(pairs[i], i, forces, z, is_worn), row);
      }
    append({state.report.iterations, state.report.residual}, row);
    steps.add_row(row);
  }



  const Table &
  LoadSteps::table() const
  {
    return steps;
  }

  std::string
  LoadSteps::column(const unsigned int number, const std::string &name) const
  {
    if (names.empty())
      return name;
    const std::string own = name == "radial_n"     ? "transverse_n"
                            : name == "centre_x_m" ? "centre_across_m"
                            : name == "centre_y_m" ? "centre_along_m"
                                                   : name;
    return names[number] + "_" + own;
  }

  std::string
  LoadSteps::at_full_load(const std::string &name) const
  {
    const std::size_t last = steps.n_rows() - 1;
    return steps.is_missing(last, name)
             ? "not defined"
             : steps.display(last, steps.column_index(name));
  }



  void
  LoadSteps::write_json(const std::vector<ContactParameters> &contacts,
                        const std::string                    &path) const
  {
    nlohmann::ordered_json json = {{"format_version", 1}};
    nlohmann::ordered_json pairs;
    for (const auto &contact : contacts)
      {
        const nlohmann::ordered_json pair = {
          {"friction_coefficient", signed_coefficient(contact, 1.)},
          {"sliding_speed_m_per_s", contact.sliding_speed}};
        if (names.empty())
          json.update(pair);
        else
          pairs[contact.name] = pair;
      }
    const auto row = [&](const std::size_t i) {
      nlohmann::ordered_json values;
      for (const auto &one : steps.columns())
        if (steps.is_missing(i, one.name))
          values[one.name] = nullptr;
        else
          values[one.name] = steps.real(i, one.name);
      return values;
    };
    json.update(row(steps.n_rows() - 1));
    if (!names.empty())
      json["pairs"] = pairs;
    json["load_steps"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < steps.n_rows(); ++i)
      json["load_steps"].push_back(row(i));
    squeal::write_json(path, json);
  }



  double
  friction_along_sliding(const ContactPair &pair, const Eigen::VectorXd &forces)
  {
    const ContactGeometry &g = pair.geometry;
    return is_flat(g) ? resultant_force(g, forces)[1]
                      : (sum_rows(g) * forces)[1];
  }

  double
  moment_about_axis(const ContactGeometry &g,
                    const Eigen::VectorXd &forces,
                    const BodyParameters  &target)
  {
    dealii::Tensor<1, 3> axis, centre, moment;
    for (unsigned int c = 0; c < 3; ++c)
      {
        axis[c]   = target.rotation_axis[c];
        centre[c] = target.centre_of_rotation()[c];
      }
    for (std::size_t j = 0; j < g.points.size(); ++j)
      moment +=
        dealii::cross_product_3d(dealii::Tensor<1, 3>(g.points[j]) - centre,
                                 forces[3 * j] * g.frames[j].normal +
                                   forces[3 * j + 1] * g.frames[j].sliding +
                                   forces[3 * j + 2] * g.frames[j].transverse);
    return moment * axis / axis.norm();
  }



  Table
  contact_nodes_table(const PressedModel &pressed, const SteadySliding &state)
  {
    const auto &pairs = pressed.nodes().pairs();
    Table       all;
    for (const ContactPair &pair : pairs)
      {
        Table table = contact_table(pair.geometry,
                                    pair.part(state.forces),
                                    pair.part(state.motion),
                                    pair.part(pressed.model().initial_gap, 1),
                                    pair.part(state.status));
        if (pairs.size() == 1)
          return table;
        if (!table.has_column("traction_z_pa"))
          {
            table.add_column(
              {"traction_z_pa", Type::real, "Pa", "target on source"});
            for (std::size_t j = 0; j < table.n_rows(); ++j)
              table.set(j, "traction_z_pa", 0.);
          }
        table.add_column({"pair", Type::text, "", "contact"});
        for (std::size_t j = 0; j < table.n_rows(); ++j)
          {
            table.set(j, "pair", pair.name());
            table.set(j, "node", pair.first + j);
          }
        all.append(table);
      }
    return all;
  }
} // namespace squeal
