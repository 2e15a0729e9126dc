// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/contact/contact_faces.h>
#include <squeal/discretization/face_quadrature.h>

#include <deal.II/base/quadrature_lib.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace squeal
{
  namespace
  {
    using Normal = dealii::Tensor<1, 3>;

    /** How far a unit normal may be from +-z: of faces whose coordinates are
     * rounded in a mesh file. */
    constexpr double normal_tolerance = 1e-3;

    /** Of lengths over the size of the source face: what only touches it from
     * the side does not lie under it; how far below it the target may be. */
    constexpr double inset = 1e-6, reach = 0.1;

    /** The face of one cell: its box, m, and the normal in it that is farthest
     * from the wanted one. */
    struct Piece
    {
      double lower[3] = {1e300, 1e300, 1e300},
             upper[3] = {-1e300, -1e300, -1e300};
      Normal worst;
      double off = -1.;
    };

    void
    include(const dealii::Point<3> &x, Piece &piece)
    {
      for (unsigned int c = 0; c < 3; ++c)
        {
          piece.lower[c] = std::min(piece.lower[c], x[c]);
          piece.upper[c] = std::max(piece.upper[c], x[c]);
        }
    }

    /** The pieces of a face, the same on every rank. @p sign: that of z in the
     * normal that is wanted. */
    std::vector<Piece>
    pieces_of(const Discretization &d, const unsigned int id, const double sign)
    {
      const dealii::QGauss<2> quadrature(d.degree() + 1);
      dealii::FEFaceValues<3> values(d.mapping(),
                                     d.dof_handler().get_fe(),
                                     quadrature,
                                     dealii::update_quadrature_points |
                                       dealii::update_normal_vectors);
      Normal                  wanted;
      wanted[2] = sign;
      std::vector<double> mine;
      for (const auto &cell : d.dof_handler().active_cell_iterators())
        if (cell->is_locally_owned())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() &&
                cell->face(f)->boundary_id() == id)
              {
                values.reinit(cell, f);
                Piece piece;
                for (unsigned int v = 0; v < 4; ++v)
                  include(cell->face(f)->vertex(v), piece);
                for (const unsigned int q : values.quadrature_point_indices())
                  {
                    include(values.quadrature_point(q), piece);
                    const Normal n   = values.normal_vector(q);
                    const double off = (n - wanted).norm();
                    if (!(off <= piece.off))
                      {
                        piece.off   = off;
                        piece.worst = n;
                      }
                  }
                for (unsigned int c = 0; c < 3; ++c)
                  mine.insert(mine.end(),
                              {piece.lower[c], piece.upper[c], piece.worst[c]});
                mine.push_back(piece.off);
              }
      std::vector<Piece> result;
      const auto         all = all_gather(mine, d.space()->communicator());
      for (std::size_t k = 0; k < all.size();)
        {
          Piece piece;
          for (unsigned int c = 0; c < 3; ++c)
            {
              piece.lower[c] = all[k++];
              piece.upper[c] = all[k++];
              piece.worst[c] = all[k++];
            }
          piece.off = all[k++];
          result.push_back(piece);
        }
      return result;
    }

    /** Pieces of the target face under the source face. */
    std::vector<Piece>
    under(const std::vector<Piece> &source, const std::vector<Piece> &target)
    {
      std::vector<Piece> result;
      std::copy_if(
        target.begin(),
        target.end(),
        std::back_inserter(result),
        [&](const Piece &t) {
          return std::any_of(source.begin(), source.end(), [&](const Piece &s) {
            double size = 0.;
            for (unsigned int c = 0; c < 3; ++c)
              size = std::max(size, s.upper[c] - s.lower[c]);
            bool meets = true;
            for (unsigned int c = 0; c < 3; ++c)
              {
                const double room = c == 2 ? reach * size : -inset * size;
                meets             = meets && t.lower[c] < s.upper[c] + room &&
                        t.upper[c] > s.lower[c] - room;
              }
            return meets;
          });
        });
      return result;
    }

    std::string
    face_text(const std::string &side,
              const std::string &face,
              const std::string &body)
    {
      return "the " + side + " face '" + face + "' of body '" + body + "'";
    }

    void
    require_normal(const std::vector<Piece> &pieces,
                   const ContactParameters  &contact,
                   const std::string        &face,
                   const std::string        &wanted)
    {
      const auto worst = std::max_element(
        pieces.begin(), pieces.end(), [](const Piece &a, const Piece &b) {
          return !(b.off <= a.off);
        });
      if (worst->off <= normal_tolerance)
        return;
      std::ostringstream normal;
      normal << std::setprecision(3);
      for (unsigned int c = 0; c < 3; ++c)
        normal << (c ? ", " : "(")
               << (std::abs(worst->worst[c]) < 1e-9 ? 0. : worst->worst[c]);
      throw InputError("contact " + contact.name + ": " + face +
                       " has the outward normal " + normal.str() +
                       ") at one place, and the signs of contact and friction "
                       "hold for " +
                       wanted +
                       " only: turn the scene until the target lies flat under "
                       "its source");
    }
  } // namespace



  void
  check_contact_faces(const Discretization &d)
  {
    const auto &scene = d.scene();
    for (const auto &contact : scene.contacts)
      {
        const unsigned int body = body_index(scene, contact.source_body);
        if (scene.bodies[body].shape == BodyParameters::Shape::rigid)
          continue;
        const auto source = pieces_of(
          d,
          face_id(
            d.coarse_mesh(), scene, contact.source_body, contact.source_face),
          -1.);
        const std::string name =
          face_text("source", contact.source_face, contact.source_body);
        if (source.empty())
          throw InputError("contact " + contact.name + ": " + name +
                           " is empty: a tie has taken it, or no cell of the "
                           "body has it");
        require_normal(source, contact, name, "-z");
        if (contact.target_body == "ground" ||
            scene.bodies[body_index(scene, contact.target_body)].shape ==
              BodyParameters::Shape::rigid)
          continue;
        const auto        target = under(source,
                                  pieces_of(d,
                                            face_id(d.coarse_mesh(),
                                                    scene,
                                                    contact.target_body,
                                                    contact.target_face),
                                            1.));
        const std::string other =
          face_text("target", contact.target_face, contact.target_body);
        if (target.empty())
          throw InputError("contact " + contact.name + ": no part of " + other +
                           " lies under " + name + ": the faces do not meet");
        require_normal(target, contact, other, "+z");
      }
  }
} // namespace squeal
