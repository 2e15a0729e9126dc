// SPDX-License-Identifier: LGPL-2.1-or-later

// Steady sliding of the coarse brake under other moduli and loads, from the
// responses of one condition kept part by part, beside models of their own.

#include "transient/pressed_brake.h"
#include "worst.h"

#include <squeal/transient/statics_by_part.h>

#include <deal.II/base/mpi.h>

#include <functional>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  constexpr double cut_off = 5e3, mu = .4;

  Block
  loads_of(const Reduced &r, const SceneParameters &scene)
  {
    Block                loads(r.separated.system.space->n_owned(), 0);
    const PointEvaluator evaluator(r.discretization);
    for (const LoadParameters &one : scene.loads)
      {
        loads.conservativeResize(Eigen::NoChange, loads.cols() + 1);
        loads.rightCols(1) = r.separated.restrict_forces(
          load_vector(r.discretization, evaluator, one));
      }
    return loads;
  }

  StaticsByPart
  statics_of(const Reduced &r)
  {
    return {r.separated.system,
            r.scene,
            r.basis,
            cut_off,
            r.nodes,
            loads_of(r, r.scene)};
  }

  using Change = std::function<void(SceneParameters &)>;

  std::optional<ReducedContactModel>
  changed_model(const StaticsByPart &statics,
                const Reduced       &r,
                const Change        &change)
  {
    SceneParameters scene = r.scene;
    change(scene);
    return statics.at(scene,
                      loads_of(r, scene),
                      ContactNodes(scene.contacts, r.separated.contacts));
  }

  void
  same_as_own(const StaticsByPart &statics,
              const Reduced       &r,
              const Change        &change,
              const std::string   &name)
  {
    SceneParameters scene = r.scene;
    change(scene);
    const Reduced own(scene, cut_off);
    const auto    model = changed_model(statics, r, change);
    check(model.has_value(), name + ": a model is there");
    if (!model)
      return;
    const SteadySliding expected = steady_sliding(own.model, mu),
                        found    = steady_sliding(*model, mu);
    const double load            = expected.resultant()[0];
    check_below((found.forces - expected.forces)
                    .cwiseAbs()
                    .maxCoeff<Eigen::PropagateNaN>() /
                  load,
                1e-6,
                name + ": forces on the nodes as those of a model of its own");
    check(found.status == expected.status, name + ": and states");
  }

  void
  other_conditions()
  {
    const Reduced       r(pressed_brake(mu), cut_off);
    const StaticsByPart statics   = statics_of(r);
    const SteadySliding unchanged = steady_sliding(r.model, mu);
    const Change        soft_disc = [](SceneParameters &s) {
      s.bodies[0].young_modulus *= .03;
    };
    // Ties and springs make the pad, its support and the ground one part.
    const Change stiff_pad = [](SceneParameters &s) {
      s.bodies[1].young_modulus *= 3.;
      s.bodies[2].young_modulus *= 3.;
      for (SpringParameters &spring : s.springs)
        spring.stiffness *= 3.;
    };
    same_as_own(
      statics, r, [](SceneParameters &) {}, "the same");
    same_as_own(statics, r, soft_disc, "a softer disc");
    same_as_own(statics, r, stiff_pad, "a stiffer pad with its support");
    same_as_own(
      statics,
      r,
      [&](SceneParameters &s) {
        soft_disc(s);
        stiff_pad(s);
        for (double &f : s.loads[0].force)
          f *= 3.;
        s.contacts[0].friction_coefficient *= -1.;
      },
      "both, under three times the load, backward");
    const auto soft = changed_model(statics, r, soft_disc);
    check(soft && (steady_sliding(*soft, mu).forces - unchanged.forces)
                      .cwiseAbs()
                      .maxCoeff<Eigen::PropagateNaN>() >
                    1e-2 * unchanged.resultant()[0],
          "a softer disc has another pressure");
  }

  void
  what_is_not_of_that_kind()
  {
    const Reduced       r(pressed_brake(mu), cut_off);
    const StaticsByPart statics = statics_of(r);
    const auto refused = [&](const Change &change, const std::string &name) {
      check(!changed_model(statics, r, change), name + " asks for a model");
    };
    refused([](SceneParameters &s) { s.bodies[0].density *= 1.1; },
            "another mass");
    refused(
      [](SceneParameters &s) {
        s.loads[0].force = {{1., 2., 3.}};
      },
      "a load in another direction");
    refused([](SceneParameters &s) { s.loads.clear(); }, "a load less");
    refused([](SceneParameters &s) { s.contacts[0].sliding_speed = 0.; },
            "a pair that comes to rest");
    refused([](SceneParameters &s) { s.bodies[0].young_modulus = 0.; },
            "a body without stiffness");
    refused([](SceneParameters &s) { s.bodies[1].young_modulus *= 1.1; },
            "a stiffer body of a part that springs join");
  }
} // namespace



int
main(int argc, char **argv)
{
  const dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  other_conditions();
  what_is_not_of_that_kind();
}
