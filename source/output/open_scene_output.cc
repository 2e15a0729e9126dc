// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/discretization/load_vector.h>
#include <squeal/model/open_scene.h>
#include <squeal/model/pressed_model.h>
#include <squeal/output/matrix_output.h>
#include <squeal/output/open_scene_output.h>
#include <squeal/parameters/choices.h>
#include <squeal/scene/import_tables.h>
#include <squeal/scene/turning.h>

#include <deal.II/dofs/dof_handler.h>
#include <deal.II/dofs/dof_tools.h>

#include <cmath>
#include <ostream>

namespace squeal
{
  namespace
  {
    /** What the free unknowns of a discretisation are; rows that no degree of
     * freedom of the mesh is alone keep a node of 0. */
    std::vector<NodeTableRow>
    free_unknowns(const Discretization &d)
    {
      const auto               &scene = d.scene();
      std::vector<NodeTableRow> result(d.space()->n_global());
      const auto                enter = [&](const unsigned int row,
                             const long         node,
                             const unsigned int component,
                             const Vector3     &position,
                             const std::string &body) {
        if (result[row].label.node == 0)
          result[row] = {0, {node, component}, position, body, {}, {}, 0};
      };
      const auto                   &dofs = d.dof_handler();
      const auto                   &fe   = dofs.get_fe();
      std::vector<dealii::Point<3>> places(dofs.n_dofs());
      if (dofs.n_dofs() > 0)
        dealii::DoFTools::map_dofs_to_support_points(d.mapping(), dofs, places);
      std::vector<dealii::types::global_dof_index> own(fe.n_dofs_per_cell());
      for (const auto &cell : dofs.active_cell_iterators())
        {
          cell->get_dof_indices(own);
          for (unsigned int i = 0; i < own.size(); ++i)
            {
              const Combination &e = d.expansion(own[i]);
              if (e.size() != 1 || e[0].second != 1.)
                continue;
              const auto [component, base] = fe.system_to_component_index(i);
              const auto  node = own[fe.component_to_system_index(0, base)];
              const auto &x    = places[own[i]];
              enter(e[0].first,
                    static_cast<long>(node) + 1,
                    component + 1,
                    {{x[0], x[1], x[2]}},
                    scene.bodies[cell->material_id()].name);
            }
        }
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        if (scene.bodies[b].shape == BodyParameters::Shape::rigid)
          {
            const dealii::Point<3> x = centre_of_gravity(scene.bodies[b]);
            for (unsigned int motion = 0; motion < 6; ++motion)
              if (const unsigned int row = d.rigid_row(b, motion); row != -1u)
                enter(row,
                      static_cast<long>(dofs.n_dofs()) + b + 1,
                      motion + 1,
                      {{x[0], x[1], x[2]}},
                      scene.bodies[b].name);
          }
      return result;
    }

    /** Those of the system: where ties have taken unknowns out, the free
     * unknown that is each of them alone. */
    std::vector<NodeTableRow>
    unknowns_of(const Model &model)
    {
      const auto  free   = free_unknowns(*model.discretization());
      const auto &system = model.linearized();
      const auto  n      = system.system.space->n_global();
      Block       numbers(n, 1);
      for (unsigned int i = 0; i < n; ++i)
        numbers(i, 0) = i + 1.;
      const Block               expanded = system.expand(numbers);
      std::vector<NodeTableRow> result(n);
      for (unsigned int j = 0; j < free.size(); ++j)
        {
          const double k = std::round(expanded(j, 0));
          if (k == expanded(j, 0) && k >= 1. && k <= n &&
              free[j].label.node != 0 && result[k - 1].label.node == 0)
            {
              result[k - 1]     = free[j];
              result[k - 1].dof = static_cast<long>(k);
            }
        }
      for (const NodeTableRow &row : result)
        AssertThrow(row.label.node != 0, dealii::ExcInternalError());
      return result;
    }

    /** Weights of the mean motion of every far face into @p unknowns. */
    void
    enter_far_faces(const Model               &model,
                    const SceneParameters     &scene,
                    std::vector<NodeTableRow> &unknowns)
    {
      const OpenScene open =
        open_scene(scene, *model.discretization(), model.body_matrices());
      for (unsigned int c = 0; c < scene.contacts.size(); ++c)
        for (std::size_t i = 0; i < unknowns.size(); ++i)
          unknowns[i].far_weights.push_back(open.observed(
            i, PressedModel::observer(c, PressedModel::far_face)));
    }

    void
    write_nodes(std::ostream                    &out,
                const std::vector<NodeTableRow> &rows,
                const SceneParameters           &scene)
    {
      out << "dof,node,component,x,y,z,body";
      for (const LoadParameters &load : scene.loads)
        out << ",load_" << load.name;
      for (const ContactParameters &contact : scene.contacts)
        out << ",far_" << contact.name;
      out << '\n';
      for (const NodeTableRow &row : rows)
        {
          out << row.dof << ',' << row.label.node << ',' << row.label.component;
          for (const double x : row.position)
            out << ',' << shortest_text(x);
          out << ',' << row.body;
          for (const auto &values : {row.forces, row.far_weights})
            for (const double value : values)
              out << ',' << shortest_text(value);
          out << '\n';
        }
    }

    /** The motion of a side of all points along one of their directions. */
    Functionals
    along(const LinearizedSystem                             &system,
          const std::vector<std::array<Functionals::Row, 3>> &side,
          const std::vector<dealii::Tensor<1, 3>>            &directions,
          const std::shared_ptr<const RowSpace>              &space)
    {
      std::vector<Functionals::Row> rows;
      for (std::size_t j = 0; j < side.size(); ++j)
        rows.push_back(combine({{directions[j][0], &side[j][0]},
                                {directions[j][1], &side[j][1]},
                                {directions[j][2], &side[j][2]}}));
      const Functionals plain(space, std::move(rows));
      return system.reduce ? *system.reduce(plain) : plain;
    }

    /** Shares below this are rounding. */
    constexpr double rounding_of_weights = 1e-10;

    /** What of the unit vector @p direction the weights of a side have not: the
     * share of what supports hold, which has no unknown. */
    dealii::Tensor<1, 3>
    held_share(const Functionals::Row          &row,
               const dealii::Tensor<1, 3>      &direction,
               const std::vector<NodeTableRow> &unknowns)
    {
      dealii::Tensor<1, 3> share = direction;
      for (const auto &[dof, weight] : row)
        if (const unsigned int c = unknowns[dof].label.component;
            c >= 1 && c <= 3)
          share[c - 1] -= weight;
      return share;
    }

    void
    write_contact(std::ostream                    &out,
                  const Model                     &model,
                  const std::string               &name,
                  const ContactGeometry           &g,
                  const std::vector<NodeTableRow> &unknowns,
                  const bool                       has_target)
    {
      const auto &space = model.discretization()->space();
      for (unsigned int k = 0; k < 3; ++k)
        {
          std::vector<dealii::Tensor<1, 3>> directions;
          for (const ContactFrame &f : g.frames)
            directions.push_back(k == 0   ? f.normal
                                 : k == 1 ? f.sliding
                                          : f.transverse);
          for (const bool target : {true, false})
            {
              const Functionals rows =
                along(model.linearized(),
                      target ? g.target_rows : g.source_rows,
                      directions,
                      space);
              if (target && !has_target)
                continue;
              for (std::size_t j = 0; j < g.points.size(); ++j)
                {
                  const auto write = [&](const std::string &unknown,
                                         const double       weight) {
                    out << name << ',' << j + 1 << ','
                        << (target ? "target" : "source") << ','
                        << (k == 0   ? "normal"
                            : k == 1 ? "sliding"
                                     : "transverse")
                        << ',' << unknown << ',' << shortest_text(weight);
                    for (unsigned int c = 0; c < 3; ++c)
                      out << ',' << shortest_text(g.points[j][c]);
                    out << ',' << shortest_text(g.areas[j]) << ','
                        << shortest_text(g.speed_ratio[j]) << '\n';
                  };
                  const Functionals::Row &row = rows.rows()[j];
                  for (const auto &[dof, weight] : row)
                    if (weight != 0.)
                      write(std::to_string(dof + 1), weight);
                  const auto held = held_share(row, directions[j], unknowns);
                  for (unsigned int c = 0; c < 3; ++c)
                    if (std::abs(held[c]) > rounding_of_weights)
                      write(std::string("held ") + "xyz"[c], held[c]);
                }
            }
        }
    }

    std::string
    list_text(const std::vector<double> &values)
    {
      std::string text;
      for (const double value : values)
        text += (text.empty() ? "" : ", ") + shortest_text(value);
      return text;
    }

    void
    write_section(std::ostream &out, const ContactParameters &c)
    {
      const auto set = [&](const std::string &name, const std::string &value) {
        out << "    set " << name << " = " << value << '\n';
      };
      const auto number = [&](const std::string &name, const double value) {
        set(name, shortest_text(value));
      };
      out << "  subsection Contact " << c.name << '\n';
      set("Source body", c.source_body);
      set("Formulation", choice_name(c.formulation));
      set("Spring layout", choice_name(c.layout));
      number("Normal stiffness", c.normal_stiffness);
      number("Tangential stiffness", c.tangential_stiffness);
      number("Normal stiffness per area", c.normal_stiffness_per_area);
      set("Contact state", choice_name(c.state));
      number("Friction coefficient", c.friction_coefficient);
      set("Friction law", choice_name(c.friction_law));
      number("Static friction coefficient", c.static_friction_coefficient);
      number("Decay speed", c.decay_speed);
      set("Friction speeds", list_text(c.friction_speeds));
      set("Friction coefficients", list_text(c.friction_coefficients));
      set("Transverse slip term", c.transverse_slip_term ? "true" : "false");
      number("Sliding speed", c.sliding_speed);
      number("Normal force", c.normal_force);
      number("Friction slope", c.friction_slope);
      out << "  end\n";
    }

    void
    write_prm(std::ostream &out, const SceneParameters &scene)
    {
      const auto names = [](const auto &sections) {
        std::string text;
        for (const auto &section : sections)
          text += (text.empty() ? "" : ", ") + section.name;
        return text;
      };
      out << "# The scene " << scene.name
          << " as matrices with its contacts cut open, to be included.\n"
          << "subsection Scene\n  set Name = " << scene.name << "\n"
          << "  set Kind = matrices\n"
          << "  set Matrix parts = mass, stiffness\n"
          << "  set Contacts = " << names(scene.contacts) << '\n'
          << "  set Loads = " << names(scene.loads) << '\n'
          << "  set Contact pattern file = contact.csv\n"
          << "  set Node table file = nodes.csv\n";
      for (const char *part : {"mass", "stiffness"})
        out << "  subsection Matrix part " << part
            << "\n    set File = " << part << ".mtx\n    set Role = " << part
            << "\n  end\n";
      for (const LoadParameters &load : scene.loads)
        out << "  subsection Load " << load.name
            << "\n    set Ramp time = " << shortest_text(load.ramp_time)
            << "\n  end\n";
      for (const ContactParameters &contact : scene.contacts)
        write_section(out, contact);
      const DampingParameters &damping = scene.damping;
      out << "  subsection Damping\n    set Model = "
          << choice_name(damping.model)
          << "\n    set Mass damping = " << shortest_text(damping.mass_damping)
          << "\n    set Stiffness damping = "
          << shortest_text(damping.stiffness_damping) << "\n  end\nend\n";
    }

    void
    refuse_what_matrices_lack(const Model           &model,
                              const Pencil          &pencil,
                              const SceneParameters &scene)
    {
      const auto fail = [](const std::string &text) {
        throw InputError("Output/Export matrices: " + text);
      };
      if (model.discretization()->space()->n_ranks() > 1)
        fail("a scene with open contacts is written by one rank");
      if (has_held_support(scene))
        fail("a held support cannot be written as matrices");
      double alpha, beta;
      if (scene.damping.model == DampingParameters::Model::per_part ||
          !pencil.is_rayleigh_damped(alpha, beta))
        fail("with open contacts the damping must be that of the whole model, "
             "C = alpha M + beta K, or none");
    }
  } // namespace



  void
  write_open_scene(RunContext        &context,
                   const Model       &model,
                   const std::string &folder)
  {
    if (model.discretization() == nullptr)
      return; // its files are there already
    // The states of the contacts are those that were asked for, not those that
    // opening them leaves.
    const SceneParameters &scene  = context.parameters.scene;
    const auto            &system = model.linearized();
    const Pencil           pencil(system.system, scene);
    refuse_what_matrices_lack(model, pencil, scene);
    write_matrices(context, pencil, folder);
    Timers::Section      section(context.timers, "Write: matrices");
    auto                 unknowns = unknowns_of(model);
    const PointEvaluator evaluator(*model.discretization());
    for (const LoadParameters &load : scene.loads)
      {
        const Block force = system.restrict_forces(
          load_vector(*model.discretization(), evaluator, load));
        for (std::size_t i = 0; i < unknowns.size(); ++i)
          unknowns[i].forces.push_back(force(i, 0));
      }
    enter_far_faces(model, scene, unknowns);
    write_atomically(
      context.output.file(folder + "/nodes.csv"),
      [&](std::ostream &out) { write_nodes(out, unknowns, scene); });
    write_atomically(
      context.output.file(folder + "/contact.csv"), [&](std::ostream &out) {
        out
          << "contact,pair,side,direction,dof,weight,x,y,z,area,speed_ratio\n";
        for (std::size_t i = 0; i < scene.contacts.size(); ++i)
          write_contact(out,
                        model,
                        scene.contacts[i].name,
                        system.contacts[i],
                        unknowns,
                        scene.contacts[i].target_body != "ground");
      });
    write_atomically(context.output.file(folder + "/scene.prm"),
                     [&](std::ostream &out) { write_prm(out, scene); });
  }
} // namespace squeal
