// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_model_h
#define squeal_model_model_h

#include <squeal/contact/contact_terms.h>
#include <squeal/eigen/mode_naming.h>
#include <squeal/parameters/parameters.h>

#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  class CommonParts;
  struct ImportedModel;
  class RunLog;
  class Timers;

  /**
   * A scene made ready for the linear analyses, whatever it comes from: meshed
   * and rigid bodies, or matrices of another code.
   */
  class Model
  {
  public:
    /** What the contact pairs do. */
    enum class Contacts
    {
      closed, /**< linearised about a contact state */
      open    /**< cut open, whatever their states */
    };

    /** Discretises and assembles. The states of closed contacts are those of
     * the parameters (`preload`: of the steady sliding) unless they are given,
     * a list for each pair. @p common: what it shares with other scenes on the
     * same mesh, or null; kept. Throws InputError. */
    Model(const Parameters                 &parameters,
          Timers                           &timers,
          const std::vector<ContactStates> &states   = {},
          const Contacts                    contacts = Contacts::closed,
          CommonParts                      *common   = nullptr);

    /** Assembles again on a (refined) mesh. */
    void assemble(Timers &timers);

    /** Null for imported models. */
    Discretization *discretization() const;
    /** Null for bodies. */
    const ImportedModel             *imported() const;
    const LinearizedSystem          &linearized() const;
    const std::vector<BodyMatrices> &body_matrices() const;
    const ModeNamer                 &namer() const;
    const std::vector<std::string>  &body_names() const;
    /** Unknowns of the system that is solved. */
    unsigned int      n_unknowns() const;
    const Parameters &parameters() const;

    /** What the kinetic energy consists of: the inertia of bodies and of the
     * lumped masses on them. Of an imported model each body has the whole mass
     * matrix, of which its rows count. */
    const std::vector<BodyInertia> &inertia() const;

    /** Share of the kinetic energy of every body, the lumped masses that it
     * carries included, in real or complex shapes of the system: bodies x
     * shapes, columns of sum 1. Of a complex shape it is the mean over a
     * period: that of the real plus that of the imaginary part. */
    Eigen::MatrixXd energy_shares(const Block &shapes) const;
    Eigen::MatrixXd energy_shares(const ComplexBlock &shapes) const;

    /** x^T M x of every part of inertia() on the vectors of a basis, with
     * densities and lumped masses taken out: the kinetic energies of
     * combinations follow without the full vectors. */
    std::vector<Eigen::MatrixXd> energy_forms(const Block &basis) const;

    /** Masses, centres, sizes, contact areas and unknowns. */
    void print_summary(RunLog &log) const;

  private:
    void assemble_bodies_scene(Timers &timers);
    void assemble_imported(Timers &timers);
    /** M X of a part of inertia(), X in the unknowns of the discretisation. */
    Block momentum(const BodyInertia &part, const Block &full) const;
    /** Sums over all ranks. */
    void sum(Eigen::MatrixXd &values) const;
    /** Twice the kinetic energies at unit frequency: bodies x shapes. */
    Eigen::MatrixXd energies(const Block &shapes) const;

    const Parameters                    &all_parameters;
    const std::vector<ContactStates>     given_states;
    const Contacts                       what_contacts_do;
    CommonParts *const                   common_parts; /**< or null */
    std::unique_ptr<Discretization>      space;
    std::vector<BodyMatrices>            bodies;
    LinearizedSystem                     system;
    std::unique_ptr<ModeNamer>           mode_namer;
    std::vector<std::string>             names;
    std::shared_ptr<const ImportedModel> import_of; /**< imported models */
    std::vector<BodyInertia>             inertia_parts;
  };
} // namespace squeal

#endif
