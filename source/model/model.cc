// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/run_log.h>
#include <squeal/base/timers.h>
#include <squeal/contact/contact_faces.h>
#include <squeal/contact/friction_law.h>
#include <squeal/contact/mortar.h>
#include <squeal/discretization/face_quadrature.h>
#include <squeal/discretization/ring_remarks.h>
#include <squeal/model/common_parts.h>
#include <squeal/model/drive_warnings.h>
#include <squeal/model/imported_system.h>
#include <squeal/model/model.h>
#include <squeal/model/point_remarks.h>
#include <squeal/model/pressed_model.h>
#include <squeal/model/rotor_symmetry.h>
#include <squeal/model/strain_warnings.h>
#include <squeal/parameters/face_geometry.h>
#include <squeal/results/table.h>
#include <squeal/scene/turning.h>

#include <deal.II/distributed/tria.h>

#include <iomanip>
#include <optional>
#include <sstream>

namespace squeal
{
  namespace
  {
    /** "-5 .. 5, -5 .. 5, 0 .. 10": the box around a body along x, y, z in mm;
     * of a mesh from a file that around its vertices. */
    std::string
    box_text(const Discretization &space, const unsigned int b)
    {
      const auto             &body = space.scene().bodies[b];
      std::optional<prm::Box> box  = prm::box_of(body);
      if (body.has_mesh_file() || body.shape == BodyParameters::Shape::layer)
        {
          box = prm::Box{{{1e300, 1e300, 1e300}}, {{-1e300, -1e300, -1e300}}};
          for (const auto &cell : space.coarse_mesh().cells)
            if (cell.material_id == b)
              for (const unsigned int v : cell.vertices)
                for (unsigned int c = 0; c < 3; ++c)
                  {
                    const double x = space.coarse_mesh().vertices[v][c];
                    box->lower[c]  = std::min(box->lower[c], x);
                    box->upper[c]  = std::max(box->upper[c], x);
                  }
        }
      if (!box)
        return "rigid";
      std::string text;
      for (unsigned int c = 0; c < 3; ++c)
        {
          std::ostringstream part;
          part << std::setprecision(6) << (c ? ", " : "") << 1e3 * box->lower[c]
               << " .. " << 1e3 * box->upper[c];
          text += part.str();
        }
      return text;
    }

    /** Says so where the loads press a pair with another force than its
     * `Normal force`, which steady sliding does not use; else empty. */
    std::string
    remark_on_normal_force(const ContactParameters &contact,
                           const ContactState      &state)
    {
      constexpr double allowed = 0.1; // relative
      if (!state.in_newtons ||
          contact.normal_force == ContactParameters().normal_force)
        return "";
      double force = 0.;
      for (const double f : state.force_share)
        force += f;
      if (std::abs(contact.normal_force - force) <= allowed * force)
        return "";
      return "'Scene/Contact " + contact.name +
             "/Normal force' = " + rounded_text(contact.normal_force, 4) +
             " N has no effect with 'Contact state = preload': the loads press "
             "the pair with " +
             rounded_text(force, 4) + " N";
    }

    /** Columns of sum 1; what does not move has no energy and no shares. */
    Eigen::MatrixXd
    shares_of(Eigen::MatrixXd energy)
    {
      for (Eigen::Index j = 0; j < energy.cols(); ++j)
        if (const double total = energy.col(j).sum(); total > 0.)
          energy.col(j) /= total;
      return energy;
    }
  } // namespace



  Model::Model(const Parameters                 &parameters,
               Timers                           &timers,
               const std::vector<ContactStates> &states,
               const Contacts                    contacts,
               CommonParts                      *common)
    : all_parameters(parameters)
    , given_states(states)
    , what_contacts_do(contacts)
    , common_parts(common)
  {
    if (parameters.scene.kind == SceneParameters::Kind::bodies)
      {
        Timers::Section section(timers, "Setup: mesh and unknowns");
        space =
          std::make_unique<Discretization>(parameters.scene,
                                           parameters.discretization,
                                           parameters.discretization.degree,
                                           MPI_COMM_WORLD);
        // Before the matrices, which take their time.
        check_contact_faces(*space);
        for (const auto &body : parameters.scene.bodies)
          names.push_back(body.name);
      }
    assemble(timers);
  }



  void
  Model::assemble(Timers &timers)
  {
    if (space)
      assemble_bodies_scene(timers);
    else
      assemble_imported(timers);
  }



  void
  Model::assemble_bodies_scene(Timers &timers)
  {
    refuse_turning_without_axis(*space);
    {
      Timers::Section section(timers, "Assemble: bodies");
      bodies =
        common_parts ? common_parts->bodies(*space) : assemble_bodies(*space);
      inertia_parts = inertia_of_bodies(*space, bodies);
    }
    if (what_contacts_do == Contacts::open)
      {
        Timers::Section section(timers, "Assemble: springs and contact");
        system = separated_system(*space, bodies);
      }
    else
      {
        std::vector<ContactStates> states = given_states;
        for (const auto &contact : all_parameters.scene.contacts)
          if (states.empty() &&
              contact.state == ContactParameters::State::preload)
            states = preload_states(all_parameters, *space, bodies, timers);
        Timers::Section section(timers, "Assemble: springs and contact");
        system = linearized_system(
          *space,
          bodies,
          states,
          common_parts ? &common_parts->couplings(*space) : nullptr);
      }
    Timers::Section section(timers, "Setup: names of modes");
    mode_namer = std::make_unique<ModeNamer>(*space);
  }



  void
  Model::assemble_imported(Timers &timers)
  {
    {
      Timers::Section section(timers, "Setup: import of matrices");
      import_of = std::make_shared<const ImportedModel>(
        read_imported_model(all_parameters.scene));
      system = imported_parts(*import_of);
      names  = import_of->bodies;
      inertia_parts.clear();
      const auto mass = imported_mass(*import_of);
      for (unsigned int b = 0; b < names.size(); ++b)
        inertia_parts.push_back(
          {b, {"mass of " + names[b], mass, [](const SceneParameters &) {
                 return TermCoefficients{1., 0., 0.};
               }}});
    }
    mode_namer = std::make_unique<ModeNamer>();
    if (what_contacts_do == Contacts::open)
      return add_open_contacts(*import_of, system);
    std::vector<ContactStates> states = given_states;
    for (const auto &contact : all_parameters.scene.contacts)
      if (states.empty() && contact.state == ContactParameters::State::preload)
        states = preload_states(all_parameters, *import_of, timers);
    add_imported_contact(all_parameters.scene, *import_of, states, system);
  }

  const ImportedModel *
  Model::imported() const
  {
    return import_of.get();
  }



  Discretization *
  Model::discretization() const
  {
    return space.get();
  }

  const LinearizedSystem &
  Model::linearized() const
  {
    return system;
  }

  const std::vector<BodyMatrices> &
  Model::body_matrices() const
  {
    return bodies;
  }

  const ModeNamer &
  Model::namer() const
  {
    return *mode_namer;
  }

  const std::vector<std::string> &
  Model::body_names() const
  {
    return names;
  }

  unsigned int
  Model::n_unknowns() const
  {
    return system.system.space->n_global();
  }

  const Parameters &
  Model::parameters() const
  {
    return all_parameters;
  }



  const std::vector<BodyInertia> &
  Model::inertia() const
  {
    return inertia_parts;
  }

  Block
  Model::momentum(const BodyInertia &part, const Block &full) const
  {
    Block product = part.term.matrix->multiply(full);
    if (import_of)
      for (Eigen::Index i = 0; i < product.rows(); ++i)
        if (import_of->body_of[i] != part.body)
          product.row(i).setZero();
    return product;
  }

  void
  Model::sum(Eigen::MatrixXd &values) const
  {
    (space ? *space->space() : *system.system.space).sum(values);
  }

  Eigen::MatrixXd
  Model::energies(const Block &shapes) const
  {
    Eigen::MatrixXd energy = Eigen::MatrixXd::Zero(names.size(), shapes.cols());
    const Block     full   = system.expand(shapes);
    for (const auto &part : inertia_parts)
      energy.row(part.body) +=
        part.term.coefficients(all_parameters.scene).mass *
        full.cwiseProduct(momentum(part, full)).colwise().sum();
    sum(energy);
    return energy;
  }

  std::vector<Eigen::MatrixXd>
  Model::energy_forms(const Block &basis) const
  {
    std::vector<Eigen::MatrixXd> forms;
    const Block                  full = system.expand(basis);
    for (const auto &part : inertia_parts)
      {
        Eigen::MatrixXd form = full.transpose() * momentum(part, full);
        sum(form);
        forms.push_back(0.5 * (form + form.transpose()));
      }
    return forms;
  }

  Eigen::MatrixXd
  Model::energy_shares(const Block &shapes) const
  {
    return shares_of(energies(shapes));
  }

  Eigen::MatrixXd
  Model::energy_shares(const ComplexBlock &shapes) const
  {
    return shares_of(energies(Block(shapes.real())) +
                     energies(Block(shapes.imag())));
  }



  void
  Model::print_summary(RunLog &log) const
  {
    log.heading("Scene " + all_parameters.scene.name);
    warn_of_kinks(all_parameters.scene, log);
    if (!space)
      {
        log.key_values({{"unknowns", std::to_string(n_unknowns())}});
        for (const ImportedMatrix &part : import_of->parts)
          if (part.storage != ImportedMatrix::Storage::stated)
            log.info("  " + part.file + " does not say what it leaves out; " +
                     (part.storage == ImportedMatrix::Storage::assumed_full
                        ? "taken as a full matrix"
                        : "taken as one half of a symmetric matrix"));
        return;
      }
    const auto &scene = all_parameters.scene;
    Table       table({{"body", Table::Type::text, "", ""},
                       {"mass_kg", Table::Type::real, "kg", "", 6},
                       {"centre_x_mm", Table::Type::real, "mm", "", 5},
                       {"centre_y_mm", Table::Type::real, "mm", "", 5},
                       {"centre_z_mm", Table::Type::real, "mm", "", 5},
                       {"box_mm", Table::Type::text, "mm", ""},
                       {"unknowns", Table::Type::integer, "", ""}});
    const auto  mm = [](const double x) {
      return std::abs(x) < 1e-9 ? 0. : 1e3 * x;
    };
    double           total_mass = 0.;
    dealii::Point<3> total_centre;
    for (unsigned int b = 0; b < names.size(); ++b)
      {
        const auto  &p     = scene.bodies[b];
        const bool   rigid = p.shape == BodyParameters::Shape::rigid;
        const double mass  = rigid ? p.mass : p.density * bodies[b].volume;
        total_mass += mass;
        total_centre += mass * bodies[b].centre;
        table.add_row({names[b],
                       mass,
                       mm(bodies[b].centre[0]),
                       mm(bodies[b].centre[1]),
                       mm(bodies[b].centre[2]),
                       box_text(*space, b),
                       space->n_free_of_body()[b]});
      }
    for (const auto &lumped : scene.lumped_masses)
      {
        total_mass += lumped.mass;
        const dealii::Point<3> point = place_of(scene, lumped);
        for (unsigned int c = 0; c < 3; ++c)
          total_centre[c] += lumped.mass * point[c];
        table.add_row({lumped.name,
                       lumped.mass,
                       mm(point[0]),
                       mm(point[1]),
                       mm(point[2]),
                       "point on " + lumped.body,
                       Cell()});
      }
    total_centre /= total_mass;
    table.add_row({"all",
                   total_mass,
                   mm(total_centre[0]),
                   mm(total_centre[1]),
                   mm(total_centre[2]),
                   "",
                   n_unknowns()});
    std::ostringstream text;
    table.print(text);
    log.info(text.str());
    for (const auto &remark : space->coarse_mesh().remarks)
      log.warning(remark);
    for (const auto &remark : remarks_on_ties(*space))
      log.warning(remark);
    for (const auto &remark : remarks_on_rings(*space))
      log.info("  " + remark);
    for (const auto &remark : remarks_on_points(*this))
      log.warning(remark);
    // Given states are those of other numbers than the scene's.
    for (unsigned int i = 0; i < scene.contacts.size(); ++i)
      if (const std::string remark =
            remark_on_normal_force(scene.contacts[i], system.states[i]);
          given_states.empty() && !remark.empty())
        log.warning(remark);
    warn_of_large_strains(scene, system.contacts, system.states, log);
    RunLog::Lines lines;
    for (unsigned int i = 0; i < scene.contacts.size(); ++i)
      {
        const auto &c    = scene.contacts[i];
        double      area = 0.;
        const bool  is_rigid =
          scene.bodies[body_index(scene, c.source_body)].shape ==
          BodyParameters::Shape::rigid;
        for (const double a : system.contacts[i].areas)
          area += a;
        lines.emplace_back(
          "contact " + c.name,
          std::to_string(system.contacts[i].points.size()) + " points" +
            (is_rigid ? "" : ", " + rounded_text(1e6 * area, 6) + " mm2") +
            ", " + text_of_friction(c) +
            (what_contacts_do != Contacts::open &&
                 c.state == ContactParameters::State::full &&
                 status_of_face(c) == ContactStatus::stick
               ? ", at rest: sticks"
               : ""));
      }
    lines.emplace_back("degree of the elements",
                       std::to_string(space->degree()));
    lines.emplace_back("degrees of freedom", std::to_string(space->n_dofs()));
    lines.emplace_back("free unknowns", std::to_string(n_unknowns()));
    log.key_values(lines);
  }
} // namespace squeal
