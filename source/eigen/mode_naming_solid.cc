// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/mode_naming_choice.h>
#include <squeal/eigen/mode_naming_profile.h>
#include <squeal/eigen/mode_naming_solid.h>
#include <squeal/scene/turning.h>

#include <deal.II/distributed/tria.h>

#include <algorithm>

namespace squeal
{
  namespace
  {
    using Point  = dealii::Point<3>;
    using Slices = std::vector<std::vector<Point>>;

    constexpr unsigned int n_slices_slender = 15;
    constexpr unsigned int n_slices_compact = 5;
    /** Points taken of a body without a known cross section. */
    constexpr unsigned int max_points = 300;

    struct Box
    {
      Point lower{1e300, 1e300, 1e300};
      Point upper{-1e300, -1e300, -1e300};
    };

    Box
    bounding_box(const Discretization &d, const unsigned int body)
    {
      Box         box;
      const auto &mesh = d.coarse_mesh();
      for (const auto &cell : mesh.cells)
        if (cell.material_id == body)
          for (const unsigned int v : cell.vertices)
            for (unsigned int c = 0; c < 3; ++c)
              {
                box.lower[c] = std::min(box.lower[c], mesh.vertices[v][c]);
                box.upper[c] = std::max(box.upper[c], mesh.vertices[v][c]);
              }
      return box;
    }

    double
    volume(const Discretization &d, const unsigned int body)
    {
      Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(1, 1);
      for (const auto &cell : d.triangulation().active_cell_iterators())
        if (cell->is_locally_owned() && cell->material_id() == body)
          sum(0, 0) += cell->measure();
      d.space()->sum(sum);
      return sum(0, 0);
    }

    /** The longest side if it is at least twice the others, else the one along
     * @p normal. */
    unsigned int
    long_axis(const dealii::Tensor<1, 3> &size,
              const dealii::Tensor<1, 3> &normal)
    {
      for (unsigned int a = 0; a < 3; ++a)
        if (size[a] >= 2. * std::max(size[(a + 1) % 3], size[(a + 2) % 3]))
          return a;
      unsigned int along = 2;
      for (unsigned int a = 0; a < 2; ++a)
        if (std::abs(normal[a]) > std::abs(normal[along]) + 1e-6)
          along = a;
      return along;
    }

    /** Four points on the cross of the axes of every cross section, at 0.4 of
     * the sides: the radius of gyration of a rectangle within 2 %. */
    Slices
    regular_slices(const Box         &box,
                   const unsigned int axis,
                   const unsigned int n_slices)
    {
      const dealii::Tensor<1, 3> size   = box.upper - box.lower;
      const Point                centre = box.lower + 0.5 * size;
      Slices                     slices(n_slices);
      for (unsigned int s = 0; s < n_slices; ++s)
        for (const unsigned int side : {(axis + 1) % 3, (axis + 2) % 3})
          for (const double sign : {-1., 1.})
            {
              Point p = centre;
              p[axis] = box.lower[axis] + size[axis] * (s + 0.5) / n_slices;
              p[side] += sign * 0.4 * size[side];
              slices[s].push_back(p);
            }
      return slices;
    }

    /** Centres of coarse cells, which lie inside whatever the shape is. Empty
     * slices are left out. */
    Slices
    cell_slices(const Discretization &d,
                const unsigned int    body,
                const Box            &box,
                const unsigned int    axis,
                const unsigned int    n_slices)
    {
      const auto        &mesh = d.coarse_mesh();
      std::vector<Point> centres;
      for (const auto &cell : mesh.cells)
        if (cell.material_id == body)
          {
            Point sum;
            for (const unsigned int v : cell.vertices)
              sum += mesh.vertices[v];
            centres.push_back(sum / double(cell.vertices.size()));
          }
      const std::size_t stride = (centres.size() - 1) / max_points + 1;
      Slices            slices(n_slices);
      for (std::size_t i = 0; i < centres.size(); i += stride)
        {
          const double s = (centres[i][axis] - box.lower[axis]) /
                           (box.upper[axis] - box.lower[axis]);
          slices[std::min<unsigned int>(n_slices - 1, s * n_slices)].push_back(
            centres[i]);
        }
      slices.erase(std::remove_if(slices.begin(),
                                  slices.end(),
                                  [](const auto &s) { return s.empty(); }),
                   slices.end());
      return slices;
    }

    /** Sign of a rotation about a coordinate axis under the mirror at the plane
     * through the disc's axis and the radial direction, which @p tangential is
     * normal to: a rotation about an axis across that plane is kept, others are
     * turned round. */
    double
    rotation_mirror(const unsigned int          axis,
                    const dealii::Tensor<1, 3> &tangential)
    {
      return std::abs(tangential[axis]) > std::sqrt(0.5) ? 1. : -1.;
    }

    Functionals::Row
    scaled(const double factor, const Functionals::Row &row)
    {
      return combine({{factor, &row}});
    }

    /** Three rows of displacements along the three directions. */
    void
    add_displacements(const std::array<Functionals::Row, 3>     &xyz,
                      const std::array<dealii::Tensor<1, 3>, 3> &directions,
                      const double                               factor,
                      std::vector<Functionals::Row>             &rows)
    {
      for (const auto &direction : directions)
        {
          std::vector<std::pair<double, const Functionals::Row *>> parts;
          for (unsigned int c = 0; c < 3; ++c)
            if (direction[c] != 0.)
              parts.emplace_back(factor * direction[c], &xyz[c]);
          rows.push_back(combine(parts));
        }
    }



    using Parts = std::vector<std::pair<double, const Functionals::Row *>>;

    /** Rows of a slice's rotation about the @p axis and, orthogonal to it, of
     * its five changes of shape, from the means of x_a u and x_b u (for the
     * three components of u) and of x_a^2 and x_b^2, where a and b follow the
     * axis. The coordinate of a rotation omega is r omega, with r the radius of
     * gyration. */
    void
    add_linear_rows(const std::array<std::array<Parts, 3>, 2> &means,
                    const std::array<double, 2>               &squares,
                    const unsigned int                         axis,
                    const double                               factor,
                    std::vector<Functionals::Row>             &rows)
    {
      const unsigned int a = (axis + 1) % 3, b = (axis + 2) % 3;
      std::array<std::array<Functionals::Row, 3>, 2> sums;
      for (unsigned int d = 0; d < 2; ++d)
        for (unsigned int c = 0; c < 3; ++c)
          sums[d][c] = combine(means[d][c]);
      const auto add = [&](const double square, const Parts &parts) {
        rows.push_back(square > 0.
                         ? scaled(factor / std::sqrt(square), combine(parts))
                         : Functionals::Row());
      };
      const double both = squares[0] + squares[1];
      add(both, {{1., &sums[0][b]}, {-1., &sums[1][a]}});
      for (unsigned int d = 0; d < 2; ++d)
        {
          add(squares[d], {{1., &sums[d][d == 0 ? a : b]}});
          add(squares[d], {{1., &sums[d][axis]}});
        }
      const bool   is_plane = squares[0] > 0. && squares[1] > 0.;
      const double ratio = is_plane ? std::sqrt(squares[1] / squares[0]) : 1.;
      add(is_plane ? both : 0.,
          {{ratio, &sums[0][b]}, {1. / ratio, &sums[1][a]}});
    }
  } // namespace



  Point
  body_centre(const Discretization &d, const unsigned int body)
  {
    const auto &b = d.scene().bodies[body];
    if (b.shape == BodyParameters::Shape::rigid)
      return centre_of_gravity(b);
    const Box box = bounding_box(d, body);
    return box.lower + 0.5 * (box.upper - box.lower);
  }



  std::string
  SolidShape::name() const
  {
    return family.empty() ? "motion" : family;
  }

  std::string
  SolidShape::text() const
  {
    return name() + " " + std::to_string(n_nodes + 1);
  }



  SolidShapes::SolidShapes(const Discretization          &d,
                           const PointEvaluator          &evaluator,
                           const unsigned int             body,
                           const DiscRing                *ring,
                           std::vector<Functionals::Row> &rows)
    : families({"x", "y", "z"})
    , mirror({1., -1., 1.})
  {
    using Shape            = BodyParameters::Shape;
    const auto &parameters = d.scene().bodies[body];
    for (unsigned int c = 0; c < 3; ++c)
      directions[c][c] = 1.;
    if (ring)
      {
        families           = {"radial", "tangential", "normal"};
        const double angle = ring->angle_of(body_centre(d, body));
        directions         = {
                  {ring->radial(angle), ring->tangential(angle), ring->directions[2]}};
      }

    if (parameters.shape == Shape::rigid)
      {
        n_slices = 1;
        families.insert(families.end(),
                        {"rotation x", "rotation y", "rotation z"});
        for (unsigned int c = 0; c < 3; ++c)
          mirror.push_back(rotation_mirror(c, directions[1]));
        add_rigid_rows(d, body, rows);
        return;
      }

    const Box                  box  = bounding_box(d, body);
    const dealii::Tensor<1, 3> size = box.upper - box.lower;
    axis                            = long_axis(size, directions[2]);
    const bool slender =
      size[axis] >= 2. * std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]);
    const unsigned int n    = slender ? n_slices_slender : n_slices_compact;
    const bool         free = parameters.has_mesh_file();
    const Slices       slices =
      free ? cell_slices(d, body, box, axis, n) : regular_slices(box, axis, n);
    n_slices        = slices.size();
    n_shape_changes = 5;
    families.push_back("torsion");
    mirror.push_back(rotation_mirror(axis, directions[1]));
    add_slice_rows(
      evaluator, body, slices, parameters.density * volume(d, body), rows);
  }



  void
  SolidShapes::add_rigid_rows(const Discretization          &d,
                              const unsigned int             body,
                              std::vector<Functionals::Row> &rows) const
  {
    const auto                     &b = d.scene().bodies[body];
    std::array<Functionals::Row, 6> motions;
    for (unsigned int i = 0; i < 6; ++i)
      if (const unsigned int row = d.rigid_row(body, i); row != -1u)
        motions[i].emplace_back(row, 1.);
    add_displacements({{motions[0], motions[1], motions[2]}},
                      directions,
                      std::sqrt(b.mass),
                      rows);
    // The root of the inertia: the squares of the rows are the energy.
    const auto root = turned_tensor(b,
                                    {{std::sqrt(b.inertia[0]),
                                      std::sqrt(b.inertia[1]),
                                      std::sqrt(b.inertia[2])}});
    for (unsigned int c = 0; c < 3; ++c)
      {
        Parts parts;
        for (unsigned int k = 0; k < 3; ++k)
          if (root[c][k] != 0.)
            parts.emplace_back(root[c][k], &motions[3 + k]);
        rows.push_back(combine(parts));
      }
  }



  void
  SolidShapes::add_slice_rows(const PointEvaluator          &evaluator,
                              const unsigned int             body,
                              const Slices                  &slices,
                              const double                   mass,
                              std::vector<Functionals::Row> &rows) const
  {
    std::vector<Point> points;
    for (const auto &slice : slices)
      points.insert(points.end(), slice.begin(), slice.end());
    const auto result = evaluator.displacements(body, points, 1e-2);

    const unsigned int a = (axis + 1) % 3, b = (axis + 2) % 3;
    const double       factor = std::sqrt(mass / slices.size());
    unsigned int       first  = 0;
    for (const auto &slice : slices)
      {
        const double n = slice.size();
        Point        centre;
        for (const auto &p : slice)
          centre += p / n;
        std::array<Parts, 3>                mean;
        std::array<std::array<Parts, 3>, 2> linear;
        std::array<double, 2>               squares{{0., 0.}};
        for (unsigned int i = 0; i < slice.size(); ++i)
          {
            const auto &u = result.rows[first + i];
            const auto  x = slice[i] - centre;
            for (unsigned int c = 0; c < 3; ++c)
              {
                mean[c].emplace_back(1. / n, &u[c]);
                linear[0][c].emplace_back(x[a] / n, &u[c]);
                linear[1][c].emplace_back(x[b] / n, &u[c]);
              }
            squares[0] += x[a] * x[a] / n;
            squares[1] += x[b] * x[b] / n;
          }
        first += slice.size();

        add_displacements(
          {{combine(mean[0]), combine(mean[1]), combine(mean[2])}},
          directions,
          factor,
          rows);
        add_linear_rows(linear, squares, axis, factor, rows);
      }
  }



  unsigned int
  SolidShapes::n_rows() const
  {
    return families.size() + n_shape_changes;
  }

  unsigned int
  SolidShapes::n_coordinates() const
  {
    return n_slices * n_rows();
  }



  std::vector<SolidShape>
  SolidShapes::classify(
    const Eigen::Ref<const Eigen::VectorXcd> &coordinates) const
  {
    AssertDimension(coordinates.size(), n_coordinates());
    if (coordinates.isZero(0.))
      return {SolidShape()};
    const Eigen::Map<const Eigen::MatrixXcd> motions(
      coordinates.data(), n_rows(), n_slices);
    const Eigen::VectorXd   all      = motions.rowwise().squaredNorm();
    const Eigen::VectorXd   energies = all.head(families.size());
    const double            share    = energies.sum() / all.sum();
    std::vector<SolidShape> shapes;
    if (naming::may_fall_short(share, naming::moving_share))
      shapes.emplace_back();
    if (!naming::may_exceed(share, naming::moving_share))
      return shapes;
    for (const unsigned int f : naming::near_largest(
           {energies.data(), energies.data() + energies.size()},
           naming::family_margin))
      for (const unsigned int n :
           naming::numbers_of_nodes(most_real_part(motions.row(f).transpose())))
        {
          shapes.emplace_back();
          shapes.back().family  = families[f];
          shapes.back().n_nodes = n;
        }
    return shapes;
  }



  Eigen::VectorXd
  SolidShapes::mirror_weights() const
  {
    Eigen::VectorXd slice = Eigen::VectorXd::Zero(n_rows());
    std::copy(mirror.begin(), mirror.end(), slice.data());
    return slice.replicate(n_slices, 1);
  }
} // namespace squeal
