// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/number_text.h>
#include <squeal/base/sum_operator.h>
#include <squeal/model/frequency_pencil.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace squeal
{
  namespace
  {
    bool
    are_equal(const TermCoefficients &a, const TermCoefficients &b)
    {
      return a.mass == b.mass && a.damping == b.damping &&
             a.stiffness == b.stiffness;
    }

    /** The body with a table that a term depends on; -1u for none. */
    unsigned int
    body_of(const AffineTerm &term, const SceneParameters &scene)
    {
      const TermCoefficients own = term.coefficients(scene);
      for (unsigned int b = 0; b < scene.bodies.size(); ++b)
        if (scene.bodies[b].has_modulus_table())
          {
            SceneParameters other = scene;
            other.bodies[b].young_modulus *= 2.;
            if (!are_equal(term.coefficients(other), own))
              return b;
          }
      return -1u;
    }

    /** Whether two terms of bodies with tables have the same coefficients at
     * every frequency: those of one table and temperature, by the same
     * function. Friction of an eliminated contact has others than the stiffness
     * that it comes from. */
    bool
    are_alike(const AffineTerm      &a,
              const unsigned int     body_of_a,
              const AffineTerm      &b,
              const unsigned int     body_of_b,
              const SceneParameters &scene)
    {
      const auto &p = scene.bodies[body_of_a], &q = scene.bodies[body_of_b];
      if (p.modulus_table_file != q.modulus_table_file ||
          p.temperature != q.temperature || p.pressure != q.pressure ||
          a.matrix->is_symmetric() != b.matrix->is_symmetric())
        return false;
      for (const double factor : {1., .37, 2.3})
        {
          SceneParameters other = scene;
          for (const unsigned int body : {body_of_a, body_of_b})
            {
              other.bodies[body].young_modulus = factor * p.young_modulus;
              other.bodies[body].table_loss_factor =
                p.table_loss_factor / factor;
            }
          if (!are_equal(a.coefficients(other), b.coefficients(other)))
            return false;
        }
      return true;
    }

    /** A term of the operator @p sum with the coefficients of @p like. */
    AffineTerm
    sum_term(const std::string             &name,
             std::vector<SumOperator::Part> sum,
             const AffineTerm              &like)
    {
      return {
        name, std::make_shared<SumOperator>(std::move(sum)), like.coefficients};
    }
  } // namespace



  FrequencyPencil::FrequencyPencil(const AffineSystem    &system,
                                   const SceneParameters &s,
                                   const ModulusTables   &t)
    : whole(system)
    , scene(s)
    , tables(t)
  {
    AffineSystem constant{system.space, {}};
    std::vector<std::pair<unsigned int, std::vector<const AffineTerm *>>> own;
    for (const AffineTerm &term : system.terms)
      {
        const unsigned int b = body_of(term, scene);
        if (b == -1u)
          {
            constant.terms.push_back(term);
            continue;
          }
        const auto same = std::find_if(own.begin(), own.end(), [&](auto &o) {
          return are_alike(*o.second.front(), o.first, term, b, scene);
        });
        if (same == own.end())
          own.push_back({b, {&term}});
        else
          same->second.push_back(&term);
      }
    grouped.space = system.space;
    const Pencil merged(constant, scene);
    for (const auto &part : merged.parts())
      grouped.terms.push_back(
        {"constant", part.matrix, [c = part.coefficients](const auto &) {
           return c;
         }});
    for (const auto &[body, terms] : own)
      {
        std::vector<SumOperator::Part> sum;
        for (const AffineTerm *term : terms)
          sum.emplace_back(1., term->matrix);
        grouped.terms.push_back(
          sum_term("stiffness of " + scene.bodies[body].name,
                   std::move(sum),
                   *terms.front()));
      }
    all = std::make_unique<Pencil>(Pencil::unmerged(grouped, scene));
  }

  const Pencil &
  FrequencyPencil::pencil() const
  {
    return *all;
  }

  FrequencyDependentPairs::Coefficients
  FrequencyPencil::coefficients() const
  {
    return [this](const double omega) {
      const SceneParameters here = tables.at(scene, omega / (2. * M_PI));
      std::vector<TermCoefficients> result;
      for (const AffineTerm &term : grouped.terms)
        result.push_back(term.coefficients(here));
      return result;
    };
  }

  Pencil
  FrequencyPencil::merged_at(const double frequency) const
  {
    return Pencil(whole, tables.at(scene, frequency));
  }

  unsigned int
  FrequencyPencil::n_modes_below(const ReducedBasis &basis,
                                 const double        frequency) const
  {
    const double    omega = 2. * M_PI * frequency;
    const auto      c     = coefficients()(omega);
    const auto     &parts = basis.parts();
    Eigen::MatrixXd A =
      Eigen::MatrixXd::Zero(parts[0].matrix.rows(), parts[0].matrix.rows());
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (all->parts()[i].symmetric)
        A +=
          (c[i].stiffness.real() - omega * omega * c[i].mass) * parts[i].matrix;
    return (Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
              0.5 * (A + A.transpose()), Eigen::EigenvaluesOnly)
              .eigenvalues()
              .array() < 0.)
      .count();
  }



  Table
  moduli_table(const SceneParameters &scene, const ComplexPairs &pairs)
  {
    using Type = Table::Type;
    Table table(
      {{"pair", Type::integer, "", "number of the pair in eigenvalues.csv"},
       {"body", Type::text, "", "body with a modulus table"},
       {"frequency_hz", Type::real, "Hz", "frequency of the pair", 7},
       {"temperature_c", Type::real, "degrees Celsius", "of the table", 5},
       {"pressure_pa", Type::real, "Pa", "of a table that has pressures", 6},
       {"storage_modulus_pa", Type::real, "Pa", "at that frequency", 6},
       {"loss_factor", Type::real, "", "at that frequency", 5}});
    const ModulusTables tables(scene);
    for (unsigned int i = 0; i < pairs.size(); ++i)
      {
        const SceneParameters here = tables.at(scene, pairs.frequency(i));
        for (const BodyParameters &body : here.bodies)
          if (body.has_modulus_table())
            table.add_row(
              {i + 1,
               body.name,
               pairs.frequency(i),
               body.temperature,
               tables.depend_on_pressure(body) ? Cell(body.pressure) : Cell(),
               body.young_modulus,
               body.table_loss_factor});
      }
    return table;
  }

  std::string
  moduli_text(const SceneParameters &scene, const ComplexPairs &pairs)
  {
    const ModulusTables tables(scene);
    std::string         text;
    for (std::size_t b = 0; b < scene.bodies.size() && pairs.size() > 0; ++b)
      {
        if (!scene.bodies[b].has_modulus_table())
          continue;
        std::vector<double> storage, loss;
        for (unsigned int i = 0; i < pairs.size(); ++i)
          {
            const auto body = tables.at(scene, pairs.frequency(i)).bodies[b];
            storage.push_back(body.young_modulus);
            loss.push_back(body.table_loss_factor);
          }
        const auto range = [](const std::vector<double> &values) {
          const auto [low, high] =
            std::minmax_element(values.begin(), values.end());
          const std::string first = rounded_text(*low, 3),
                            last  = rounded_text(*high, 3);
          return first == last ? first : first + " to " + last;
        };
        text += (text.empty() ? "" : "; ") + scene.bodies[b].name + " " +
                range(storage) + " Pa, loss factor " + range(loss);
      }
    return text;
  }
} // namespace squeal
