// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/scene/import_contact.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace squeal
{
  namespace import
  {
    namespace
    {
      using Side      = ContactTerm::Side;
      using Direction = ContactTerm::Direction;

      constexpr std::array<Direction, 3> directions{
        {Direction::normal, Direction::sliding, Direction::transverse}};

      const char *
      name_of(const Direction direction)
      {
        return direction == Direction::normal    ? "normal"
               : direction == Direction::sliding ? "sliding"
                                                 : "transverse";
      }

      /** The lines of one row: all of one pair and direction. */
      struct RowTerms
      {
        std::map<unsigned int, double> weights;  /**< with the side's sign */
        std::map<unsigned int, double> sides[2]; /**< source, target; plain */
        Vector3 direction{{0., 0., 0.}};         /**< by the sums of one side */
        /** Sums of the weights by component (0: components unknown). */
        std::map<unsigned int, double> sums;
        double                         largest    = 0.;
        bool                           has_source = false, has_target = false;
        unsigned int                   line = 0;
      };

      using Pair = std::array<RowTerms, 3>;

      std::string
      place(const std::string &file, const unsigned int line)
      {
        return file + ":" + std::to_string(line) + ": ";
      }

      unsigned int
      find_dof(const ContactTerm &term,
               const Numbering   &numbering,
               const std::string &file)
      {
        if (term.dof > 0)
          {
            if (term.dof > static_cast<long>(numbering.n_dofs()))
              throw InputError(place(file, term.line) + "dof " +
                               std::to_string(term.dof) +
                               " does not exist; the model has " +
                               std::to_string(numbering.n_dofs()));
            return static_cast<unsigned int>(term.dof - 1);
          }
        const auto dof = numbering.find(term.label);
        if (!dof)
          throw InputError(place(file, term.line) +
                           squeal::describe(term.label) +
                           " is not in the matrices" +
                           (numbering.labels().empty()
                              ? ", which have no names: use column dof or give "
                                "a node table"
                              : ""));
        return *dof;
      }

      void
      add_term(const ContactTerm &term,
               const Numbering   &numbering,
               const std::string &file,
               Pair              &pair)
      {
        const bool   target = term.side == Side::target;
        const double weight = target ? term.weight : -term.weight;
        RowTerms    &row    = pair[static_cast<unsigned int>(term.direction)];
        unsigned int component = term.label.component;
        if (!term.is_held)
          {
            const unsigned int dof = find_dof(term, numbering, file);
            if (!row.weights.emplace(dof, weight).second)
              throw InputError(
                place(file, term.line) + numbering.describe(dof) +
                " is given twice in the " + name_of(term.direction) +
                " row of pair " + std::to_string(term.pair));
            row.sides[target ? 1 : 0].emplace(dof, term.weight);
            component = numbering.labels().empty()
                          ? 0
                          : numbering.labels()[dof].component;
          }
        else if (numbering.labels().empty())
          component = 0;
        if (!target && component >= 1 && component <= 3)
          row.direction[component - 1] += term.weight;
        row.sums[component] += weight;
        row.largest = std::max(row.largest, std::abs(weight));
        (target ? row.has_target : row.has_source) = true;
        row.line                                   = term.line;
      }

      /** A pair between two bodies must not feel a rigid translation; one side
       * alone is a contact with the ground. Rotations have no such sum. */
      void
      check_balance(const RowTerms    &row,
                    const Direction    direction,
                    const long         pair,
                    const std::string &file)
      {
        if (!row.has_source || !row.has_target)
          return;
        for (const auto &[component, sum] : row.sums)
          if (component <= 3 && std::abs(sum) > 1e-6 * row.largest)
            throw InputError(
              place(file, row.line) + "the " + name_of(direction) +
              " weights of target and source of pair " + std::to_string(pair) +
              " do not add up to the same" +
              (component == 0 ? ""
                              : " in component " + std::to_string(component)) +
              ": a rigid translation would act on the contact, or the "
              "share of unknowns that supports hold ('held x', 'held y', "
              "'held z') is missing");
      }

      void
      check_pair(const Pair        &pair,
                 const long         number,
                 const bool         has_transverse,
                 const std::string &file)
      {
        for (const Direction direction : directions)
          {
            const RowTerms &row = pair[static_cast<unsigned int>(direction)];
            if (!row.weights.empty())
              check_balance(row, direction, number, file);
            else if (direction != Direction::transverse || has_transverse)
              throw InputError(file + ": pair " + std::to_string(number) +
                               " has no " + name_of(direction) + " row");
          }
      }

      ImportedContact::Row
      row_of(const RowTerms &terms)
      {
        return {terms.weights.begin(), terms.weights.end()};
      }
    } // namespace



    ImportedContact
    assemble_contact(const std::vector<ContactTerm> &terms,
                     const Numbering                &numbering,
                     const std::string              &file_name)
    {
      std::map<long, Pair>   pairs;
      std::map<long, double> factors;
      bool                   has_transverse = false;
      for (const ContactTerm &term : terms)
        {
          add_term(term, numbering, file_name, pairs[term.pair]);
          factors[term.pair] = term.stiffness_factor;
          has_transverse |= term.direction == Direction::transverse;
        }

      ImportedContact contact;
      for (const auto &[number, pair] : pairs)
        {
          check_pair(pair, number, has_transverse, file_name);
          contact.pairs.push_back(number);
          contact.normal.push_back(row_of(pair[0]));
          contact.sliding.push_back(row_of(pair[1]));
          if (has_transverse)
            contact.transverse.push_back(row_of(pair[2]));
          contact.stiffness_factors.push_back(factors[number]);
        }
      return contact;
    }



    namespace
    {
      double
      product(const Vector3 &a, const Vector3 &b)
      {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
      }

      /** What a pair of a named contact touches with one row it touches with
       * all. */
      void
      check_sides(const Pair &pair, const long number, const std::string &file)
      {
        for (const RowTerms &row : pair)
          if (!row.weights.empty() && (row.has_source != pair[0].has_source ||
                                       row.has_target != pair[0].has_target))
            throw InputError(place(file, row.line) + "pair " +
                             std::to_string(number) +
                             " has weights of target and source in some of its "
                             "rows and of one of them in others");
      }

      /** Normal, sliding and transverse direction of the rows of a pair. */
      std::array<Vector3, 3>
      directions_of(const Pair        &pair,
                    const long         number,
                    const std::string &file)
      {
        // What is left of rounding in a file of few digits.
        constexpr double             tolerance = 1e-5;
        const std::array<Vector3, 3> d{
          {pair[0].direction, pair[1].direction, pair[2].direction}};
        const Vector3 across{{d[1][1] * d[0][2] - d[1][2] * d[0][1],
                              d[1][2] * d[0][0] - d[1][0] * d[0][2],
                              d[1][0] * d[0][1] - d[1][1] * d[0][0]}};
        const bool is_frame = std::abs(product(d[0], d[0]) - 1.) < tolerance &&
                              std::abs(product(d[1], d[1]) - 1.) < tolerance &&
                              std::abs(product(d[0], d[1])) < tolerance &&
                              std::abs(product(d[2], across) - 1.) < tolerance;
        if (!is_frame)
          throw InputError(
            place(file, pair[0].line) + "the source weights of pair " +
            std::to_string(number) +
            " do not add up to three orthogonal unit vectors, normal n, "
            "sliding t and transverse s = t x n");
        return d;
      }

      void
      add_places(const std::vector<ContactTerm> &terms,
                 const Numbering                &numbering,
                 const std::string              &file,
                 ImportedContact                &contact)
      {
        std::map<long, Pair>                pairs;
        std::map<long, const ContactTerm *> first;
        for (const ContactTerm &term : terms)
          {
            add_term(term, numbering, file, pairs[term.pair]);
            first.emplace(term.pair, &term);
          }
        for (const long number : contact.pairs)
          {
            const Pair        &pair = pairs.at(number);
            const ContactTerm &term = *first.at(number);
            check_sides(pair, number, file);
            contact.target.emplace_back();
            contact.source.emplace_back();
            for (unsigned int k = 0; k < 3; ++k)
              for (const unsigned int side : {0, 1})
                (side == 0 ? contact.source : contact.target).back()[k] = {
                  pair[k].sides[side].begin(), pair[k].sides[side].end()};
            contact.directions.push_back(directions_of(pair, number, file));
            contact.points.push_back(term.position);
            contact.areas.push_back(term.area);
            contact.speed_ratio.push_back(term.speed_ratio);
          }
      }
    } // namespace



    std::vector<ImportedContact>
    assemble_contacts(const std::vector<ContactTerm> &terms,
                      const std::vector<std::string> &contacts,
                      const Numbering                &numbering,
                      const std::string              &file_name)
    {
      std::map<std::string, std::vector<ContactTerm>> of_contact;
      for (const ContactTerm &term : terms)
        {
          if (std::find(contacts.begin(), contacts.end(), term.contact) ==
              contacts.end())
            throw InputError(place(file_name, term.line) + "contact '" +
                             term.contact + "' is not one of 'Scene/Contacts'");
          of_contact[term.contact].push_back(term);
        }
      std::vector<ImportedContact> result;
      for (const std::string &name : contacts)
        {
          if (of_contact[name].empty())
            throw InputError(file_name + ": contact '" + name +
                             "' of the scene has no pair");
          result.push_back(
            assemble_contact(of_contact[name], numbering, file_name));
          if (result.back().transverse.empty())
            throw InputError(file_name + ": contact '" + name +
                             "' has no transverse rows");
          add_places(of_contact[name], numbering, file_name, result.back());
        }
      return result;
    }
  } // namespace import
} // namespace squeal
