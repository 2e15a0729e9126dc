// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/mode_naming.h>
#include <squeal/eigen/mode_naming_choice.h>
#include <squeal/parameters/text.h>

#include <boost/algorithm/string/split.hpp>

#include <algorithm>
#include <utility>

namespace squeal
{
  namespace
  {
    using Rings = std::vector<std::optional<DiscRing>>;

    /** Unit vector from the disc's axis to @p body, in the two directions of the
     * ring; zero where it is on the axis: rounding must not make up a
     * direction. */
    Eigen::Vector2d
    direction_to(const Discretization &d,
                 const DiscRing       &ring,
                 const unsigned int    body)
    {
      const auto            r = body_centre(d, body) - ring.centre;
      const Eigen::Vector2d across(r * ring.directions[0],
                                   r * ring.directions[1]);
      if (across.norm() > 1e-6 * ring.outer_radius)
        return across.normalized();
      return Eigen::Vector2d::Zero();
    }

    /** Angle about the disc's axis of the middle of the bodies that touch it:
     * two pads beside each other share an antinode between them. Bodies all
     * round the disc have no middle, and the first one counts. */
    double
    contact_angle(const Discretization &d,
                  const Rings          &rings,
                  const unsigned int    disc)
    {
      const auto &scene = d.scene();
      if (disc == -1u)
        return 0.;
      const std::string           &own = scene.bodies[disc].name;
      std::vector<Eigen::Vector2d> directions;
      for (const auto &contact : scene.contacts)
        if (own == contact.source_body || own == contact.target_body)
          for (const auto &name : {contact.source_body, contact.target_body})
            for (unsigned int b = 0; b < scene.bodies.size(); ++b)
              if (scene.bodies[b].name == name && !rings[b])
                directions.push_back(direction_to(d, *rings[disc], b));
      if (directions.empty())
        return 0.;
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      for (const auto &direction : directions)
        sum += direction;
      const Eigen::Vector2d middle =
        sum.norm() > 0.5 * directions.size() ? sum : directions[0];
      return std::atan2(middle[1], middle[0]);
    }

    /** What all @p values agree on, else @p otherwise. */
    template <typename T>
    T
    agreed(const std::vector<T> &values, const T &otherwise)
    {
      for (const T &value : values)
        if (value != values[0])
          return otherwise;
      return values.empty() ? otherwise : values[0];
    }

    /** Fills the columns of disc and other body from the parts of the
     * alternatives that have them. */
    template <typename Parts>
    void
    set_columns(const Parts &found, ModeName &name)
    {
      std::vector<int>          circles, diameters;
      std::vector<std::string>  parities, families, motions;
      std::vector<unsigned int> solids, nodes;
      for (const auto &[disc, solid] : found)
        {
          families.push_back(disc ? to_string(disc->shape.family)
                                  : solid->shape.name());
          if (disc)
            {
              circles.push_back(disc->shape.nodal_circles);
              diameters.push_back(disc->shape.nodal_diameters);
              parities.push_back(disc->shape.parity);
            }
          if (solid)
            {
              solids.push_back(solid->body);
              motions.push_back(solid->shape.name());
              nodes.push_back(solid->shape.n_nodes);
            }
        }
      name.is_disc         = !circles.empty();
      name.nodal_circles   = agreed(circles, -1);
      name.nodal_diameters = agreed(diameters, -1);
      name.parity          = agreed(parities, std::string());
      name.family          = agreed(families, std::string());
      name.solid           = agreed(solids, -1u);
      name.solid_family    = agreed(motions, std::string());
      name.solid_nodes     = agreed(nodes, 0u);
      name.solid_number    = nodes.empty() ? 0 : agreed(nodes, -1u) + 1;
    }
  } // namespace



  std::string
  explanation_of_names()
  {
    return "Names: (n,m) is a disc that bends with n nodal circles and m "
           "nodal\n"
           "diameters; + has an antinode at the pad, - a node; T and R move "
           "in\n"
           "the plane, tangentially and radially. A body, a direction and a\n"
           "number say how it moves: 1 as one, 2 about one node, 3 about two\n"
           "nodes along it. A|B is a near tie of A and B.";
  }

  bool
  is_called(const std::string &text, const std::string &wanted)
  {
    const auto               is_bar = [](const char c) { return c == '|'; };
    std::vector<std::string> names, choices;
    boost::split(names, text, is_bar);
    // A tie that is wanted is any of its names.
    boost::split(choices, wanted, is_bar);
    return std::any_of(
      names.begin(), names.end(), [&](const std::string &name) {
        return std::any_of(
          choices.begin(), choices.end(), [&](const std::string &choice) {
            return name == choice || prm::starts_with(name, choice + " ");
          });
      });
  }



  ModeNamer::ModeNamer() = default;

  ModeNamer::ModeNamer(const Discretization &d)
  {
    const auto &scene = d.scene();
    const Rings rings = disc_rings(d);
    main_body         = main_disc(scene, rings);
    angle             = contact_angle(d, rings, main_body);
    if (main_body != -1u)
      main_ring = rings[main_body];

    const PointEvaluator          evaluator(d);
    std::vector<Functionals::Row> rows, reduced;
    bodies.resize(scene.bodies.size());
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        Body &body            = bodies[b];
        body.name             = scene.bodies[b].name;
        body.first_sample     = rows.size();
        body.first_coordinate = total_coordinates;
        if (rings[b])
          {
            ++n_discs;
            body.disc = std::make_unique<DiscShapes>(
              *rings[b], scene.bodies[b].density, evaluator, b, angle, rows);
            total_coordinates += body.disc->n_coordinates();
            for (const auto &[row, factor] : body.disc->signature())
              reduced.push_back(
                combine({{factor, &rows[body.first_sample + row]}}));
          }
        else
          {
            body.solid =
              std::make_unique<SolidShapes>(d, evaluator, b, ring(), rows);
            total_coordinates += body.solid->n_coordinates();
            reduced.insert(
              reduced.end(), rows.begin() + body.first_sample, rows.end());
          }
        std::string owner = body.name;
        if (main_body != -1u && main_body != b)
          owner += "_about_" + scene.bodies[main_body].name;
        for (unsigned int i = 1; entries.size() < reduced.size(); ++i)
          entries.push_back(owner + "_" + std::to_string(i));
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

  const std::vector<std::string> &
  ModeNamer::signature_entries() const
  {
    return entries;
  }

  double
  ModeNamer::reference_angle() const
  {
    return angle;
  }

  unsigned int
  ModeNamer::disc() const
  {
    return main_body;
  }

  const DiscRing *
  ModeNamer::ring() const
  {
    return main_ring ? &*main_ring : nullptr;
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
  ModeNamer::name(const Block            &modes,
                  const Eigen::MatrixXd  &energy_shares,
                  const Eigen::VectorXcd &eigenvalues) const
  {
    return name_coordinates(coordinates(modes).cast<std::complex<double>>(),
                            energy_shares,
                            eigenvalues);
  }

  std::vector<ModeName>
  ModeNamer::name(const ComplexBlock     &modes,
                  const Eigen::MatrixXd  &energy_shares,
                  const Eigen::VectorXcd &eigenvalues) const
  {
    Eigen::MatrixXcd all(total_coordinates, modes.cols());
    all.real() = coordinates(modes.real());
    all.imag() = coordinates(modes.imag());
    return name_coordinates(all, energy_shares, eigenvalues);
  }



  std::vector<ModeName>
  ModeNamer::name_coordinates(const Eigen::MatrixXcd &coordinates,
                              const Eigen::MatrixXd  &energy_shares,
                              const Eigen::VectorXcd &eigenvalues) const
  {
    const unsigned int    n_modes = coordinates.cols();
    std::vector<ModeName> names(n_modes);
    if (bodies.empty())
      {
        for (unsigned int i = 0; i < n_modes; ++i)
          {
            names[i].text         = "mode " + std::to_string(i + 1);
            names[i].alternatives = {names[i].text};
          }
        return names;
      }
    AssertDimension(coordinates.rows(), total_coordinates);
    AssertDimension(energy_shares.rows(), bodies.size());
    AssertDimension(energy_shares.cols(), n_modes);
    const Eigen::MatrixXcd single = separated(coordinates, eigenvalues);
    for (unsigned int i = 0; i < n_modes; ++i)
      names[i] = describe(single.col(i), energy_shares.col(i));
    return names;
  }



  std::vector<unsigned int>
  ModeNamer::largest_bodies(const Eigen::VectorXd &shares,
                            const bool             discs) const
  {
    std::vector<unsigned int> result;
    std::vector<double>       values;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      if (bool(bodies[b].disc) == discs)
        {
          result.push_back(b);
          values.push_back(shares[b]);
        }
    std::vector<unsigned int> largest;
    for (const unsigned int i :
         naming::near_largest(values, naming::family_margin))
      largest.push_back(result[i]);
    return largest;
  }



  std::vector<ModeNamer::DiscPart>
  ModeNamer::disc_parts(const Eigen::VectorXcd &coordinates,
                        const Eigen::VectorXd  &shares) const
  {
    std::vector<DiscPart> parts;
    for (const unsigned int b : largest_bodies(shares, true))
      for (const auto &shape : bodies[b].disc->classify(coordinates.segment(
             bodies[b].first_coordinate, bodies[b].disc->n_coordinates())))
        parts.push_back({b, shape});
    return parts;
  }

  std::vector<ModeNamer::SolidPart>
  ModeNamer::solid_parts(const Eigen::VectorXcd &coordinates,
                         const Eigen::VectorXd  &shares) const
  {
    std::vector<SolidPart> parts;
    for (const unsigned int b : largest_bodies(shares, false))
      for (const auto &shape : bodies[b].solid->classify(coordinates.segment(
             bodies[b].first_coordinate, bodies[b].solid->n_coordinates())))
        parts.push_back({b, shape});
    return parts;
  }



  std::string
  ModeNamer::text_of(const DiscPart *disc, const SolidPart *solid) const
  {
    std::string text;
    if (disc)
      text =
        (n_discs > 1 ? bodies[disc->body].name + " " : "") + disc->shape.text();
    if (solid)
      text += (disc ? " " : "") + bodies[solid->body].name + " " +
              solid->shape.text();
    return text;
  }



  ModeName
  ModeNamer::describe(const Eigen::VectorXcd &coordinates,
                      const Eigen::VectorXd  &energy_shares) const
  {
    const auto discs  = disc_parts(coordinates, energy_shares);
    const auto solids = solid_parts(coordinates, energy_shares);
    const auto share  = [&](const auto &parts) {
      return parts.empty() ? 0. : energy_shares[parts[0].body];
    };
    const bool may_have_disc =
      !discs.empty() && naming::may_exceed(share(discs), naming::disc_share);
    const bool may_lack_disc =
      !may_have_disc ||
      naming::may_fall_short(share(discs), naming::disc_share);
    double all_solids = 0.;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      if (bodies[b].solid)
        all_solids += energy_shares[b];
    const bool may_have_solid =
      naming::may_exceed(share(solids), naming::solid_share) ||
      naming::may_exceed(all_solids, naming::solids_share);
    const bool may_lack_solid =
      naming::may_fall_short(share(solids), naming::solid_share) &&
      naming::may_fall_short(all_solids, naming::solids_share);

    // A name has one of the two at least.
    std::vector<std::pair<const DiscPart *, const SolidPart *>> found;
    if (may_have_disc || solids.empty())
      for (const auto &disc : discs)
        {
          if (may_lack_solid || solids.empty())
            found.emplace_back(&disc, nullptr);
          if (may_have_solid)
            for (const auto &solid : solids)
              found.emplace_back(&disc, &solid);
        }
    if (may_lack_disc)
      for (const auto &solid : solids)
        found.emplace_back(nullptr, &solid);

    ModeName name;
    energy_shares.maxCoeff(&name.body);
    for (const auto &[disc, solid] : found)
      {
        name.alternatives.push_back(text_of(disc, solid));
        name.text += (name.text.empty() ? "" : "|") + name.alternatives.back();
      }
    set_columns(found, name);
    return name;
  }
} // namespace squeal
