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
        std::map<unsigned int, double> weights; /**< with the side's sign */
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
        const unsigned int dof    = find_dof(term, numbering, file);
        const bool         target = term.side == Side::target;
        const double       weight = target ? term.weight : -term.weight;
        RowTerms &row = pair[static_cast<unsigned int>(term.direction)];
        if (!row.weights.emplace(dof, weight).second)
          throw InputError(place(file, term.line) + numbering.describe(dof) +
                           " is given twice in the " + name_of(term.direction) +
                           " row of pair " + std::to_string(term.pair));
        const unsigned int component =
          numbering.labels().empty() ? 0 : numbering.labels()[dof].component;
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
              ": a rigid translation would act on the contact");
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
  } // namespace import
} // namespace squeal
