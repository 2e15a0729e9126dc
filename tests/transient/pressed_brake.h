// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_transient_pressed_brake_h
#define squeal_tests_transient_pressed_brake_h

#include "scenes.h"

#include <squeal/discretization/load_vector.h>
#include <squeal/transient/full_transient.h>
#include <squeal/transient/linearized_motion.h>

namespace squeal
{
  namespace testing
  {
    constexpr double speed = 0.1126, load = 100.;

    inline SceneParameters
    pressed_brake(const double friction)
    {
      SceneParameters s      = coarse_brake(friction);
      auto           &c      = s.contacts[0];
      c.formulation          = ContactParameters::Formulation::mortar;
      c.transverse_slip_term = true;
      c.sliding_speed        = speed;
      c.normal_force         = load;
      LoadParameters top;
      top.name  = "top";
      top.body  = "support";
      top.face  = "z_max";
      top.force = {{0., 0., -load}};
      s.loads   = {top};
      return s;
    }

    /** The bodies of a brake reduced at a cut-off. */
    struct Reduced
    {
      Reduced(const SceneParameters &s,
              const double           cut_off,
              const double           interface_cut_off = 0.,
              const bool             lumped            = false,
              const unsigned int     degree            = 2)
        : scene(s)
        , discretization(scene, parameters(lumped), degree, MPI_COMM_SELF)
        , bodies(assemble_bodies(discretization))
        , separated(separated_system(discretization, bodies))
        , nodes(scene.contacts, separated.contacts)
        , pencil(separated.system, scene)
        , basis(reduction_basis(
            pencil,
            undamped_modes(
              pencil,
              ShiftedInverse(pencil, std::pow(2. * M_PI * cut_off, 2))),
            nodes.relative_motion(),
            interface_cut_off))
        , model(reduce_contact_model(pencil,
                                     basis,
                                     cut_off,
                                     nodes,
                                     separated.restrict_forces(load_vector(
                                       discretization,
                                       PointEvaluator(discretization),
                                       scene.loads[0]))))
      {
      }

      static DiscretizationParameters
      parameters(const bool lumped)
      {
        DiscretizationParameters p = Model::parameters(0);
        if (lumped)
          p.mass = DiscretizationParameters::Mass::lumped;
        return p;
      }

      SceneParameters           scene;
      Discretization            discretization;
      std::vector<BodyMatrices> bodies;
      LinearizedSystem          separated;
      ContactNodes              nodes;
      Pencil                    pencil;
      ReductionBasis            basis;
      ReducedContactModel       model;
    };

    /** All unknowns of the same brake. */
    inline FullContactModel
    full_model(const Reduced &r)
    {
      FullContactModel full;
      full.pencil = std::make_shared<const Pencil>(r.pencil);
      full.basis  = std::make_shared<const ReductionBasis>(r.basis);
      full.relative_motion =
        std::make_shared<const Functionals>(r.nodes.relative_motion());
      full.load =
        r.separated
          .restrict_forces(load_vector(r.discretization,
                                       PointEvaluator(r.discretization),
                                       r.scene.loads[0]))
          .col(0);
      full.observers     = Block::Zero(full.load.size(), 1);
      full.initial_gap   = r.model.initial_gap;
      full.speed_ratio   = r.model.speed_ratio;
      full.motion_offset = Eigen::VectorXd::Zero(3 * r.model.n_nodes());
      return full;
    }

    /** Eigenvalues of the whole model about the contact state of the reduced
     * one. */
    inline Eigen::VectorXcd
    whole_model(const Reduced &r, const SteadySliding &s)
    {
      ContactState state;
      state.status = s.status;
      for (unsigned int j = 0; j < r.model.n_nodes(); ++j)
        state.force_share.push_back(s.forces[3 * j] / load);
      const LinearizedSystem system =
        linearized_system(r.discretization, r.bodies, {{state}});
      const Pencil         pencil(system.system, r.scene);
      const ShiftedInverse inverse(pencil, std::pow(2. * M_PI * 8e3, 2));
      const UndampedModes  modes = undamped_modes(pencil, inverse);
      CertifiedSolver      solver(pencil, inverse, modes);
      return solver.solve(band(500., 7e3)).lambda;
    }
  } // namespace testing
} // namespace squeal

#endif
