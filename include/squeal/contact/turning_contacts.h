// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_contact_turning_contacts_h
#define squeal_contact_turning_contacts_h

#include <squeal/contact/contact_nodes.h>
#include <squeal/contact/turning_contact.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace squeal
{
  /**
   * The relative motion B of all contact nodes of a scene in which the meshes
   * of targets turn. Pairs at rest keep their B.
   */
  class TurningContacts
  {
  public:
    /** One pair, alone in its scene. */
    TurningContacts(std::shared_ptr<TurningContact> pair);

    /** @p nodes in unknowns of the system, @p geometries of the discretisation,
     * @p reduce and @p knots_per_cell as TurningContact. Throws InputError,
     * naming the pairs, where two pairs turn one body at different rates. */
    TurningContacts(const Discretization         &discretization,
                    const ContactNodes           &nodes,
                    const TurningContact::Reduce &reduce,
                    const unsigned int            knots_per_cell);

    /** B where the drive has moved on by @p way, its speed over time, m. */
    std::shared_ptr<const Functionals> relative_motion(const double way);

    /** Bodies that turn and by how much, rad counterclockwise about z per metre
     * of the drive's way; each once. */
    std::map<std::string, double> rates() const;

    /** All unknowns that some way has to do with, ascending. */
    std::vector<unsigned int> unknowns() const;

  private:
    struct Pair
    {
      std::string                     name;
      std::shared_ptr<TurningContact> turning;          /**< null: at rest */
      double                          speed_ratio = 1.; /**< at its centre */
      std::vector<Functionals::Row>   still; /**< of a pair at rest */
    };

    void require_one_rate() const;

    std::vector<Pair> pairs;
  };
} // namespace squeal

#endif
