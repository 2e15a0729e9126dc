// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/model/imported_system.h>
#include <squeal/output/cea_quantities.h>
#include <squeal/output/pair_table.h>
#include <squeal/parameters/choices.h>

#include <cmath>

namespace squeal
{
  double
  total_mass(const Model &model, const SceneParameters &scene)
  {
    if (const ImportedModel *const imported = model.imported())
      {
        const Block rigid = translations(*imported);
        return rigid
          .cwiseProduct(imported_mass(*imported, scene)->multiply(rigid))
          .colwise()
          .sum()
          .maxCoeff();
      }
    double sum = 0.;
    for (unsigned int b = 0; b < model.body_matrices().size(); ++b)
      sum += scene.bodies[b].shape == BodyParameters::Shape::rigid
               ? scene.bodies[b].mass
               : scene.bodies[b].density * model.body_matrices()[b].volume;
    for (const auto &lumped : scene.lumped_masses)
      sum += lumped.mass;
    return sum;
  }



  ContactMotion
  contact_motion(const Model &model, const unsigned int number)
  {
    const ContactGeometry        &g = model.linearized().contacts[number];
    std::vector<Functionals::Row> source, target;
    for (std::size_t p = 0; p < g.points.size(); ++p)
      {
        const auto &t = g.frames[p].sliding, &n = g.frames[p].normal;
        const auto &s = g.source_rows[p], &d = g.target_rows[p];
        source.push_back(
          combine({{t[0], &s[0]}, {t[1], &s[1]}, {t[2], &s[2]}}));
        target.push_back(
          combine({{n[0], &d[0]}, {n[1], &d[1]}, {n[2], &d[2]}}));
      }
    const auto &space = model.discretization() != nullptr
                          ? model.discretization()->space()
                          : model.linearized().system.space;
    return {std::make_shared<Functionals>(space, std::move(source)),
            std::make_shared<Functionals>(space, std::move(target))};
  }



  namespace
  {
    using Complex = std::complex<double>;

    Eigen::VectorXd
    modal_masses(const Pencil &pencil, const ComplexBlock &X, ComplexBlock &MX)
    {
      Block both(X.rows(), 2 * X.cols());
      both << X.real(), X.imag();
      const Block product = pencil.multiply_mass(both);
      MX.resize(X.rows(), X.cols());
      MX.real() = product.leftCols(X.cols());
      MX.imag() = product.rightCols(X.cols());
      Eigen::MatrixXd squares =
        X.conjugate().cwiseProduct(MX).real().colwise().sum();
      pencil.space()->sum(squares);
      return squares.row(0);
    }

    /** -2 pi Im(x^H (K_f + lambda C_f) x) over |lambda|^2 x^H M x. */
    std::vector<double>
    friction_energies(const Model           &model,
                      const ComplexPairs    &pairs,
                      const Eigen::VectorXd &masses)
    {
      Block both(pairs.right.rows(), 2 * pairs.right.cols());
      both << pairs.right.real(), pairs.right.imag();
      const Eigen::Index n   = pairs.size();
      Eigen::MatrixXd    sum = Eigen::MatrixXd::Zero(1, n);
      const Pencil       friction(friction_terms(model.linearized().system),
                            model.parameters().scene);
      for (const auto &part : friction.parts())
        {
          const Block &F = part.matrix->multiply(both);
          const auto  &c = part.coefficients;
          for (Eigen::Index j = 0; j < n; ++j)
            {
              ComplexBlock f(F.rows(), 1);
              f.real()             = F.col(j);
              f.imag()             = F.col(n + j);
              const Complex lambda = pairs.lambda[j];
              const Complex work =
                (lambda * lambda * c.mass + lambda * c.damping + c.stiffness) *
                (pairs.right.col(j).adjoint() * f)(0);
              sum(0, j) -= 2. * M_PI * work.imag();
            }
        }
      friction.space()->sum(sum);
      std::vector<double> result;
      for (Eigen::Index j = 0; j < n; ++j)
        result.push_back(sum(0, j) / (std::norm(pairs.lambda[j]) * masses[j]));
      return result;
    }

    std::vector<double>
    contact_participations(const Model           &model,
                           const ComplexPairs    &pairs,
                           const Eigen::VectorXd &masses)
    {
      const Eigen::Index n          = pairs.size();
      Eigen::VectorXd    tangential = Eigen::VectorXd::Zero(n);
      Eigen::VectorXd    normal     = tangential;
      unsigned int       n_points   = 0;
      const auto        &contacts   = model.linearized().contacts;
      if (contacts.empty())
        return std::vector<double>(n, std::nan(""));
      ComplexBlock full;
      for (const bool imaginary : {false, true})
        {
          const Block part = model.linearized().expand(
            imaginary ? Block(pairs.right.imag()) : Block(pairs.right.real()));
          if (!imaginary)
            full = part.cast<Complex>();
          else
            full.imag() = part;
        }
      for (unsigned int i = 0; i < contacts.size(); ++i)
        {
          const ContactMotion motion = contact_motion(model, i);
          tangential += motion.tangential_source->apply(full)
                          .cwiseAbs2()
                          .colwise()
                          .sum()
                          .transpose();
          normal += motion.normal_target->apply(full)
                      .cwiseAbs2()
                      .colwise()
                      .sum()
                      .transpose();
          n_points += contacts[i].points.size();
        }
      const double        mass = total_mass(model, model.parameters().scene);
      std::vector<double> result;
      for (Eigen::Index j = 0; j < n; ++j)
        result.push_back(mass * std::sqrt(tangential[j] * normal[j]) /
                         (n_points * masses[j]));
      return result;
    }
  } // namespace



  namespace
  {
    std::vector<ModeName>
    names_of(const Model           &model,
             const ComplexPairs    &pairs,
             const Eigen::MatrixXd &energy_shares)
    {
      const Block re = model.linearized().expand(Block(pairs.right.real())),
                  im = model.linearized().expand(Block(pairs.right.imag()));
      ComplexBlock full(re.rows(), re.cols());
      full.real() = re;
      full.imag() = im;
      return model.namer().name(full, energy_shares, pairs.lambda);
    }
  } // namespace

  std::vector<ModeName>
  pair_names(const Model &model, const ComplexPairs &pairs)
  {
    return names_of(model, pairs, model.energy_shares(pairs.right));
  }

  PairQuantities
  pair_quantities(const Model        &model,
                  const ModeSolution &modes,
                  const ComplexPairs &pairs)
  {
    PairQuantities  q;
    ComplexBlock    MX;
    const auto      masses  = modal_masses(*modes.pencil, pairs.right, MX);
    const RowSpace &space   = *modes.pencil->space();
    q.energy_shares         = model.energy_shares(pairs.right);
    q.names                 = names_of(model, pairs, q.energy_shares);
    q.energy_per_cycle      = friction_energies(model, pairs, masses);
    q.contact_participation = contact_participations(model, pairs, masses);

    const ComplexBlock     shapes       = modes.modes.shapes.cast<Complex>();
    const Eigen::MatrixXcd coefficients = space.dot(shapes, MX);
    for (unsigned int j = 0; j < pairs.size(); ++j)
      {
        const Eigen::VectorXd mac = coefficients.col(j).cwiseAbs2() / masses[j];
        std::array<int, 2>    best{{-1, -1}};
        for (Eigen::Index i = 0; i < mac.size(); ++i)
          if (best[0] < 0 || mac[i] > mac[best[0]])
            best = {{static_cast<int>(i), best[0]}};
          else if (best[1] < 0 || mac[i] > mac[best[1]])
            best[1] = i;
        q.partners.push_back(best);
        q.partner_mac.push_back(
          {{best[0] < 0 ? 0. : mac[best[0]], best[1] < 0 ? 0. : mac[best[1]]}});
        // The mesh's error of the pair, weighed by what it is made of.
        double error = 0., weight = 0.;
        for (const int i : best)
          if (i >= 0 && std::isfinite(modes.discretisation_error[i]))
            {
              error += mac[i] * modes.discretisation_error[i];
              weight += mac[i];
            }
        q.discretisation_error.push_back(weight > 0.5 ? error / weight
                                                      : std::nan(""));
      }
    return q;
  }



  std::string
  contact_state_text(const SceneParameters &scene)
  {
    std::string text;
    for (const auto &contact : scene.contacts)
      if (const std::string state = choice_name(contact.state);
          text.find(state) == std::string::npos)
        text += (text.empty() ? "" : ", ") + state;
    return text.empty() ? "none" : text;
  }



  Table
  eigenvalue_table(const Model          &model,
                   const ModeSolution   &modes,
                   const ComplexPairs   &pairs,
                   const PairQuantities &q)
  {
    PairTable         table(model.body_names());
    const std::string state = contact_state_text(model.parameters().scene);
    const auto partner      = [&](const unsigned int j, const unsigned int k) {
      const int i = q.partners[j][k];
      return i < 0 ? std::string()
                        : modes.names[i].text + " " +
                       rounded_text(modes.modes.frequency(i), 5) + " Hz, MAC " +
                       rounded_text(q.partner_mac[j][k], 2);
    };
    for (unsigned int j = 0; j < pairs.size(); ++j)
      {
        PairRow row(pairs, j);
        row.name = q.names[j].text;
        for (Eigen::Index b = 0; b < q.energy_shares.rows(); ++b)
          row.energy_shares.push_back(q.energy_shares(b, j));
        row.energy_per_cycle = q.energy_per_cycle[j];
        if (!model.linearized().contacts.empty())
          row.contact_participation = q.contact_participation[j];
        for (unsigned int k = 0; k < 2; ++k)
          row.partners[k] = partner(j, k);
        row.contact_state        = state;
        row.discretisation_error = q.discretisation_error[j];
        if (q.mesh_error.size() > j)
          row.mesh_error = q.mesh_error[j];
        table.add(row);
      }
    return table.table();
  }
} // namespace squeal
