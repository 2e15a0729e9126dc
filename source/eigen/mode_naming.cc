// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/mode_naming.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <map>
#include <numeric>

namespace squeal
{
  namespace
  {
    bool
    is_annulus(const SceneParameters &scene, const unsigned int body)
    {
      return scene.bodies[body].shape == BodyParameters::Shape::annulus;
    }

    /** The disc whose axis directions refer to: that of the first contact pair,
     * else the first one, else -1u. */
    unsigned int
    main_disc(const SceneParameters &scene)
    {
      unsigned int first = -1u;
      for (unsigned int b = scene.bodies.size(); b-- > 0;)
        if (is_annulus(scene, b))
          first = b;
      if (!scene.contacts.empty())
        for (const auto &name :
             {scene.contacts[0].source_body, scene.contacts[0].target_body})
          for (unsigned int b = 0; b < scene.bodies.size(); ++b)
            if (scene.bodies[b].name == name && is_annulus(scene, b))
              first = b;
      return first;
    }

    /** Angle about the disc axis of the first contact pair's other body. */
    double
    contact_angle(const Discretization &d, const unsigned int disc)
    {
      const auto &scene = d.scene();
      if (disc == -1u || scene.contacts.empty())
        return 0.;
      for (const auto &name :
           {scene.contacts[0].source_body, scene.contacts[0].target_body})
        for (unsigned int b = 0; b < scene.bodies.size(); ++b)
          if (scene.bodies[b].name == name && !is_annulus(scene, b))
            {
              const auto   centre = body_centre(d, b);
              const auto  &axis   = scene.bodies[disc].position;
              const double x = centre[0] - axis[0], y = centre[1] - axis[1];
              // On the axis there is no angle: rounding must not make one up.
              const double r = scene.bodies[disc].outer_radius;
              return std::hypot(x, y) > 1e-6 * r ? std::atan2(y, x) : 0.;
            }
      return 0.;
    }

    /** Numbers of the motions of bodies: modes that move a body alike, as the
     * two of a coalesced pair do, have one number. */
    class MotionNumbers
    {
    public:
      unsigned int
      number(const unsigned int      body,
             const std::string      &family,
             const Eigen::VectorXcd &coordinates)
      {
        auto &known = motions[{body, family}];
        for (unsigned int i = 0; i < known.size(); ++i)
          if (std::norm(known[i].dot(coordinates)) >
              same_motion * known[i].squaredNorm() * coordinates.squaredNorm())
            return i + 1;
        known.push_back(coordinates);
        return known.size();
      }

    private:
      static constexpr double same_motion = 0.7; /* as MAC */
      std::map<std::pair<unsigned int, std::string>,
               std::vector<Eigen::VectorXcd>>
        motions;
    };

    /** The last column of each run of neighbours closer than the tolerance. */
    std::vector<unsigned int>
    ends_of_clusters(const std::vector<double> &frequencies,
                     const double               tolerance)
    {
      std::vector<unsigned int> ends;
      for (unsigned int i = 0; i < frequencies.size(); ++i)
        if (i + 1 == frequencies.size() ||
            std::abs(frequencies[i + 1] - frequencies[i]) >
              tolerance * std::abs(frequencies[i + 1]))
          ends.push_back(i + 1);
      return ends;
    }

    /** +1 or -1 such that the first of the largest entries becomes positive. */
    double
    sign_of(const Eigen::VectorXd &coordinates)
    {
      const double limit = 0.999 * coordinates.cwiseAbs().maxCoeff();
      for (const double value : coordinates)
        if (std::abs(value) >= limit)
          return value < 0. ? -1. : 1.;
      return 1.;
    }
  } // namespace



  ModeNamer::ModeNamer() = default;

  ModeNamer::ModeNamer(const Discretization &d)
  {
    const auto        &scene = d.scene();
    const unsigned int disc  = main_disc(scene);
    angle                    = contact_angle(d, disc);

    const PointEvaluator          evaluator(d);
    std::vector<Functionals::Row> rows, reduced;
    bodies.resize(scene.bodies.size());
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        Body &body            = bodies[b];
        body.name             = scene.bodies[b].name;
        body.first_sample     = rows.size();
        body.first_coordinate = total_coordinates;
        if (is_annulus(scene, b))
          {
            ++n_discs;
            body.disc =
              std::make_unique<DiscShapes>(d, evaluator, b, angle, rows);
            total_coordinates += body.disc->n_coordinates();
            for (const auto &[row, factor] : body.disc->signature())
              reduced.push_back(
                combine({{factor, &rows[body.first_sample + row]}}));
          }
        else
          {
            body.solid =
              std::make_unique<SolidShapes>(d, evaluator, b, disc, rows);
            total_coordinates += body.solid->n_coordinates();
            reduced.insert(
              reduced.end(), rows.begin() + body.first_sample, rows.end());
          }
      }
    if (bodies.empty())
      return;
    samples        = std::make_shared<Functionals>(d.space(), std::move(rows));
    signature_rows = std::make_shared<Functionals>(d.space(), reduced);
  }



  std::shared_ptr<const Functionals>
  ModeNamer::signature() const
  {
    return signature_rows;
  }

  double
  ModeNamer::reference_angle() const
  {
    return angle;
  }

  unsigned int
  ModeNamer::n_coordinates() const
  {
    return total_coordinates;
  }



  Eigen::MatrixXd
  ModeNamer::coordinates(const Block &vectors) const
  {
    Eigen::MatrixXd result(total_coordinates, vectors.cols());
    if (bodies.empty())
      return result;
    const Eigen::MatrixXd values = samples->apply(vectors);
    for (const auto &body : bodies)
      if (body.disc)
        result.middleRows(body.first_coordinate, body.disc->n_coordinates()) =
          body.disc->coordinates(
            values.middleRows(body.first_sample, body.disc->n_samples()));
      else
        result.middleRows(body.first_coordinate, body.solid->n_coordinates()) =
          values.middleRows(body.first_sample, body.solid->n_coordinates());
    return result;
  }



  std::vector<ModeName>
  ModeNamer::name(const Block           &modes,
                  const Eigen::MatrixXd &energy_shares) const
  {
    return name_coordinates(coordinates(modes).cast<std::complex<double>>(),
                            energy_shares);
  }

  std::vector<ModeName>
  ModeNamer::name(const ComplexBlock    &modes,
                  const Eigen::MatrixXd &energy_shares) const
  {
    Eigen::MatrixXcd all(total_coordinates, modes.cols());
    all.real() = coordinates(modes.real());
    all.imag() = coordinates(modes.imag());
    return name_coordinates(all, energy_shares);
  }



  std::vector<ModeName>
  ModeNamer::name_coordinates(const Eigen::MatrixXcd &coordinates,
                              const Eigen::MatrixXd  &energy_shares) const
  {
    const unsigned int    n_modes = coordinates.cols();
    std::vector<ModeName> names(n_modes);
    if (bodies.empty())
      {
        for (unsigned int i = 0; i < n_modes; ++i)
          names[i].text = "mode " + std::to_string(i + 1);
        return names;
      }
    AssertDimension(coordinates.rows(), total_coordinates);
    AssertDimension(energy_shares.rows(), bodies.size());
    AssertDimension(energy_shares.cols(), n_modes);
    MotionNumbers motions;
    for (unsigned int i = 0; i < n_modes; ++i)
      {
        ModeName &name = names[i];
        name           = describe(coordinates.col(i), energy_shares.col(i));
        if (name.solid == -1u)
          continue;
        const Body &body = bodies[name.solid];
        name.solid_number =
          motions.number(name.solid,
                         name.solid_family,
                         coordinates.col(i).segment(
                           body.first_coordinate, body.solid->n_coordinates()));
        name.text += " " + std::to_string(name.solid_number);
      }
    return names;
  }



  ModeName
  ModeNamer::describe(const Eigen::VectorXcd &coordinates,
                      const Eigen::VectorXd  &energy_shares) const
  {
    ModeName     name;
    unsigned int disc = -1u, solid = -1u;
    energy_shares.maxCoeff(&name.body);
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        unsigned int &largest = bodies[b].disc ? disc : solid;
        if (largest == -1u || energy_shares[b] > energy_shares[largest])
          largest = b;
      }

    if (disc != -1u && (disc == name.body || energy_shares[disc] >= disc_share))
      {
        const Body     &body  = bodies[disc];
        const DiscShape shape = body.disc->classify(coordinates.segment(
          body.first_coordinate, body.disc->n_coordinates()));
        name.is_disc          = true;
        name.nodal_circles    = shape.nodal_circles;
        name.nodal_diameters  = shape.nodal_diameters;
        name.parity           = shape.parity;
        name.family           = to_string(shape.family);
        name.text = (n_discs > 1 ? body.name + " " : "") + shape.text();
      }
    if (solid != -1u &&
        (solid == name.body || energy_shares[solid] >= solid_share))
      {
        const Body      &body  = bodies[solid];
        const SolidShape shape = body.solid->classify(coordinates.segment(
          body.first_coordinate, body.solid->n_coordinates()));
        name.solid             = solid;
        name.solid_family      = shape.family.empty() ? "motion" : shape.family;
        name.solid_nodes       = shape.n_nodes;
        name.text +=
          (name.is_disc ? " " : "") + body.name + " " + name.solid_family;
        if (!name.is_disc)
          name.family = name.solid_family;
      }
    return name;
  }



  Eigen::VectorXd
  ModeNamer::mirror_weights() const
  {
    Eigen::VectorXd weights(total_coordinates);
    for (const auto &body : bodies)
      {
        const Eigen::VectorXd part = body.disc ? body.disc->mirror_weights()
                                               : body.solid->mirror_weights();
        weights.segment(body.first_coordinate, part.size()) = part;
      }
    return weights;
  }



  std::vector<unsigned int>
  ModeNamer::order_of_shapes(const Eigen::MatrixXd &coordinates) const
  {
    std::vector<unsigned int> order(coordinates.cols());
    std::iota(order.begin(), order.end(), 0);
    std::vector<std::pair<unsigned int, std::string>> keys(order.size());
    for (const auto &body : bodies)
      if (body.disc)
        for (unsigned int i = 0; i < order.size(); ++i)
          {
            const Eigen::VectorXd own = coordinates.col(i).segment(
              body.first_coordinate, body.disc->n_coordinates());
            // Motions of other bodies come first and stay as they are.
            if (own.squaredNorm() < 0.5 * coordinates.col(i).squaredNorm())
              continue;
            const auto shape =
              body.disc->classify(own.cast<std::complex<double>>());
            // "+" sorts before "-".
            keys[i] = {1 + shape.nodal_diameters, shape.parity};
          }
    std::stable_sort(order.begin(),
                     order.end(),
                     [&](const unsigned int a, const unsigned int b) {
                       return keys[a] < keys[b];
                     });
    return order;
  }



  Block
  ModeNamer::separate_multiple(const Block               &modes,
                               const std::vector<double> &frequencies,
                               const double               tolerance) const
  {
    AssertDimension(frequencies.size(), modes.cols());
    Block result = modes;
    if (bodies.empty())
      return result;
    const Eigen::VectorXd weights = mirror_weights();
    unsigned int          begin   = 0;
    for (const unsigned int end : ends_of_clusters(frequencies, tolerance))
      {
        const unsigned int n = end - begin;
        if (n > 1)
          {
            const Block           cluster = modes.middleCols(begin, n);
            const Eigen::MatrixXd C       = coordinates(cluster);
            const Eigen::MatrixXd form =
              C.transpose() * weights.asDiagonal() * C;
            const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(form);
            Eigen::MatrixXd R = eigen.eigenvectors().rowwise().reverse();
            for (unsigned int i = 0; i < n; ++i)
              R.col(i) *= sign_of(C * R.col(i));
            const auto order = order_of_shapes(C * R);
            for (unsigned int i = 0; i < n; ++i)
              result.col(begin + i) = cluster * R.col(order[i]);
          }
        begin = end;
      }
    return result;
  }
} // namespace squeal
