// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/number_text.h>
#include <squeal/base/unknown_choice.h>
#include <squeal/base/worst_of.h>
#include <squeal/contact/contact_frames.h>
#include <squeal/contact/mortar_faces.h>
#include <squeal/discretization/face_quadrature.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    using Point  = dealii::Point<3>;
    using Vector = dealii::Tensor<1, 3>;

    /** Components below this part of a unit vector are rounding: they must not
     * mix friction into the normal force. */
    constexpr double rounding = 1e-12;
    /** Largest |V . n| over |V|: it would shift mu by as much. */
    constexpr double normal_speed = 1e-3;
    /** How far, rad, the normals of two faces that touch may be from opposite:
     * of arcs beside facets. */
    constexpr double largest_angle = 0.1;
    /** Of the unit square, by which a point may lie beside a target face. */
    constexpr double margin = 1e-4;
    /** Of the larger of two faces that touch, by which they may be apart beside
     * their bulges: as allowed_distance() of mortar faces. */
    constexpr double touching = 1e-4;
    /** Distance over which the other face is looked for, of the box round the
     * contact points. */
    constexpr double reach = 0.1;

    Vector
    unit(Vector v)
    {
      v /= v.norm();
      for (unsigned int c = 0; c < 3; ++c)
        if (std::abs(v[c]) < rounding)
          v[c] = 0.;
      return v / v.norm();
    }

    Vector
    vector_of(const Vector3 &v)
    {
      return Point(v[0], v[1], v[2]);
    }

    std::string
    text_of(const Vector &v)
    {
      return "(" + rounded_text(v[0], 4) + ", " + rounded_text(v[1], 4) + ", " +
             rounded_text(v[2], 4) + ")";
    }

    bool
    is_meshed(const SceneParameters &scene, const std::string &body)
    {
      return body != "ground" && scene.bodies[body_index(scene, body)].shape !=
                                   BodyParameters::Shape::rigid;
    }



    /** What a line through a point meets; far if nothing. */
    struct Hit
    {
      static constexpr double far = 1e300;

      double depth = far; /**< of the point in the target, m; < 0 outside */
      Vector normal;
      double allowed = 0.; /**< of the depth's size, m */
      double same    = 0.; /**< of two depths that count as one, m */
    };

    /** The largest size and bulge of the faces of a contact's source, m. */
    struct SourceExtent
    {
      double diameter = 0., bulge = 0.;
    };

    SourceExtent
    source_extent(const Discretization         &d,
                  const FaceBasis              &basis,
                  const ContactParameters      &contact,
                  const dealii::BoundingBox<3> &around)
    {
      const auto        &scene = d.scene();
      const unsigned int id    = face_id(
        d.coarse_mesh(), scene, contact.source_body, contact.source_face);
      double mine[2] = {0., 0.}, most[2];
      for (const TargetFace &face : target_faces(
             d, basis, body_index(scene, contact.source_body), around))
        if (face.id == id)
          {
            mine[0] = worst_of(mine[0], face.geometry.diameter());
            mine[1] = worst_of(mine[1], face.geometry.bulge());
          }
      MPI_Allreduce(
        mine, most, 2, MPI_DOUBLE, MPI_MAX, d.space()->communicator());
      return {most[0], most[1]};
    }

    /** All faces of this rank, with the id @p id, that the line through @p x
     * along @p direction meets and that look against it. */
    std::vector<Hit>
    all_met(const std::vector<TargetFace>  &targets,
            const std::vector<std::size_t> &candidates,
            const unsigned int              id,
            const Point                    &x,
            const Vector                   &direction,
            const SourceExtent             &source)
    {
      std::vector<Hit> hits;
      for (const std::size_t k : candidates)
        {
          const SurfaceFace &face = targets[k].geometry;
          if (targets[k].id != id || !(face.normal() * direction < -0.5))
            continue;
          const auto place = face.project(x, direction);
          if (!place)
            continue;
          bool inside = true;
          for (unsigned int c = 0; c < 2; ++c)
            inside = inside && place->unit[c] > -margin &&
                     place->unit[c] < 1. + margin;
          if (!inside)
            continue;
          const Vector area = face.frame(place->unit).area_vector();
          hits.push_back(
            {place->distance,
             area / area.norm(),
             touching * std::max(source.diameter, face.diameter()) +
               source.bulge + face.bulge(),
             touching * face.diameter()});
        }
      return hits;
    }

    /** The nearest of all ranks for each of @p n points. Cells of a round face
     * meet at a small angle: at a point on their edge the normal is the mean of
     * theirs, as rounding alone says which of them is nearer. */
    std::vector<Hit>
    nearest_of_all(const std::vector<double> &mine,
                   const std::size_t          n,
                   const MPI_Comm             comm)
    {
      const std::vector<double>     packed = all_gather(mine, comm);
      std::vector<std::vector<Hit>> met(n);
      for (std::size_t k = 0; k < packed.size(); k += 7)
        met[static_cast<std::size_t>(packed[k])].push_back(
          {packed[k + 1],
           Point(packed[k + 4], packed[k + 5], packed[k + 6]),
           packed[k + 2],
           packed[k + 3]});
      std::vector<Hit> result(n);
      for (std::size_t j = 0; j < n; ++j)
        {
          Hit &best = result[j];
          for (const Hit &hit : met[j])
            if (std::abs(hit.depth) < std::abs(best.depth))
              best = hit;
          Vector sum;
          for (const Hit &hit : met[j])
            if (std::abs(hit.depth - best.depth) <=
                std::max(hit.same, best.same))
              {
                sum += hit.normal;
                best.allowed = std::max(best.allowed, hit.allowed);
              }
          if (!met[j].empty())
            best.normal = sum / sum.norm();
        }
      return result;
    }

    /** Refuses faces of which one stands in or off the other: without a gap of
     * their own they would be taken for faces that touch. */
    void
    require_touching(const ContactParameters &contact,
                     const Point             &x,
                     const Hit               &hit)
    {
      if (std::abs(hit.depth) <= hit.allowed)
        return;
      throw InputError(
        "contact " + contact.name + ": at " + text_of(x) +
        " m the source face '" + contact.source_face + "' of body '" +
        contact.source_body + "' is " +
        rounded_text(1e3 * std::abs(hit.depth), 3) +
        (hit.depth > 0. ? " mm inside body '" : " mm off body '") +
        contact.target_body +
        "': move the bodies or mend their meshes until "
        "the faces touch, within " +
        rounded_text(1e3 * hit.allowed, 3) + " mm there");
    }

    /** What the source looks at from each of its points, on every rank. */
    std::vector<Hit>
    hits_of_source(const Discretization      &d,
                   const ContactParameters   &contact,
                   const std::vector<Point>  &points,
                   const std::vector<Vector> &source_normals)
    {
      const auto                  &scene = d.scene();
      const FaceBasis              basis(d.degree());
      const dealii::BoundingBox<3> all(points);
      const double size = reach * all.get_boundary_points().first.distance(
                                    all.get_boundary_points().second);
      auto around = all;
      around.extend(size);
      const unsigned int id = face_id(
        d.coarse_mesh(), scene, contact.target_body, contact.target_face);
      const auto targets =
        target_faces(d, basis, body_index(scene, contact.target_body), around);
      std::vector<dealii::BoundingBox<3>> boxes;
      for (const auto &target : targets)
        boxes.push_back(bounding_box(target.geometry));
      const auto tree   = dealii::pack_rtree_of_indices(boxes);
      const auto source = source_extent(d, basis, contact, around);

      std::vector<double> mine; // point, depth, allowed, same, normal
      for (std::size_t j = 0; j < points.size(); ++j)
        {
          dealii::BoundingBox<3> box({points[j], points[j]});
          box.extend(size);
          std::vector<std::size_t> near;
          tree.query(boost::geometry::index::intersects(box),
                     std::back_inserter(near));
          std::sort(near.begin(), near.end());
          for (const Hit &hit :
               all_met(targets, near, id, points[j], source_normals[j], source))
            mine.insert(mine.end(),
                        {double(j),
                         hit.depth,
                         hit.allowed,
                         hit.same,
                         hit.normal[0],
                         hit.normal[1],
                         hit.normal[2]});
        }
      const auto all_hits =
        nearest_of_all(mine, points.size(), d.space()->communicator());
      for (std::size_t j = 0; j < points.size(); ++j)
        if (all_hits[j].depth == Hit::far)
          throw InputError(
            "contact " + contact.name + ": the target face '" +
            contact.target_face + "' of body '" + contact.target_body +
            "' is not where the source face '" + contact.source_face +
            "' of body '" + contact.source_body +
            "' looks: the faces do not meet at " + text_of(points[j]) + " m");
      return all_hits;
    }



    void
    require_opposite(const ContactParameters &contact,
                     const Point             &x,
                     const Vector            &source,
                     const Vector            &target)
    {
      if (!(-(source * target) >= std::cos(largest_angle)))
        throw InputError("contact " + contact.name +
                         ": the faces do not look at each other at " +
                         text_of(x) + " m: the outward normals are " +
                         text_of(source) + " of the source and " +
                         text_of(target) + " of the target");
    }

    /** V of the target at @p x, of any length if it is the same everywhere. */
    Vector
    velocity(const SceneParameters   &scene,
             const ContactParameters &contact,
             const Point             &x)
    {
      using Direction = ContactParameters::FrictionDirection;
      switch (contact.friction_direction)
        {
        case Direction::fixed_y:
          return Point(0., 1., 0.);
        case Direction::given:
          return vector_of(contact.sliding_direction);
        case Direction::slip:
          {
            if (contact.target_body == "ground")
              return Point(0., 1., 0.);
            const auto &body =
              scene.bodies[body_index(scene, contact.target_body)];
            const Vector axis = unit(vector_of(body.rotation_axis)),
                         arm  = x - vector_of(body.centre_of_rotation());
            const Vector V    = dealii::cross_product_3d(axis, arm);
            if (!(V.norm() > rounding * arm.norm()))
              throw InputError("Scene/Contact " + contact.name +
                               ": a contact point lies on the disc axis, where "
                               "there is no sliding direction");
            return V;
          }
        }
      unknown_choice("friction direction");
    }

    /** Refuses a sliding direction that leaves the face. That of the turning
     * target does so on facets, and on faces that are no faces of revolution.
     */
    void
    require_sliding_along_face(const ContactParameters &contact,
                               const Point             &x,
                               const Vector            &normal,
                               const Vector            &V)
    {
      const double across = std::abs(V * normal) / V.norm();
      if (across <= normal_speed)
        return;
      const std::string head =
        "contact " + contact.name + ": the sliding direction " +
        text_of(V / V.norm()) + " at " + text_of(x) +
        " m is not along the face, whose normal is " + text_of(normal) + ": ";
      if (contact.friction_direction !=
          ContactParameters::FrictionDirection::slip)
        throw InputError(head + "set 'Scene/Contact " + contact.name +
                         "/Friction direction' to slip, or to given with a "
                         "'Sliding direction' along the face");
      const auto degrees = [](const double sine) {
        return rounded_text(180. / M_PI * std::asin(std::min(sine, 1.)), 2);
      };
      throw InputError(
        head + "the target face '" + contact.target_face + "' of body '" +
        contact.target_body + "' is " + degrees(across) +
        " degrees off a face of revolution about the axis of that body, and "
        "may be " +
        degrees(normal_speed) +
        ": facets of a coarse mesh are so; take more cells round the axis or a "
        "higher 'Discretization/Degree' (mesh files: with mid-side nodes on "
        "the round face), or mend 'Rotation axis' and 'Rotation centre' or "
        "'Position' of the body");
    }

    ContactFrame
    frame_of(const ContactParameters &contact,
             const Point             &x,
             const Vector            &normal,
             const Vector            &V)
    {
      require_sliding_along_face(contact, x, normal, V);
      ContactFrame frame;
      frame.normal  = normal;
      frame.sliding = unit(V - (V * normal) * normal);
      frame.transverse =
        unit(dealii::cross_product_3d(frame.sliding, frame.normal));
      return frame;
    }
  } // namespace



  ContactFrames
  contact_frames(const Discretization      &d,
                 const ContactParameters   &contact,
                 const std::vector<Point>  &points,
                 const std::vector<Vector> &source_normals)
  {
    AssertDimension(points.size(), source_normals.size());
    const auto      &scene = d.scene();
    std::vector<Hit> hits;
    if (is_meshed(scene, contact.target_body) &&
        is_meshed(scene, contact.source_body))
      hits = hits_of_source(d, contact, points, source_normals);

    ContactFrames result;
    double        mean = 0.;
    for (std::size_t j = 0; j < points.size(); ++j)
      {
        const Vector normal =
          unit(hits.empty() ? -source_normals[j] : hits[j].normal);
        require_opposite(contact, points[j], source_normals[j], normal);
        const Vector V = velocity(scene, contact, points[j]);
        result.frames.push_back(frame_of(contact, points[j], normal, V));
        result.speed_ratio.push_back(V.norm());
        mean += V.norm() / points.size();
      }
    for (double &ratio : result.speed_ratio)
      ratio /= mean;
    // Faces that are tilted or bent are told as that, not by how far they are
    // apart somewhere.
    for (std::size_t j = 0; j < hits.size(); ++j)
      require_touching(contact, points[j], hits[j]);
    return result;
  }
} // namespace squeal
