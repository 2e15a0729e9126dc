// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_import_numbering_h
#define squeal_scene_import_numbering_h

#include <squeal/scene/import_tables.h>

#include <optional>

namespace squeal
{
  namespace import
  {
    /**
     * The common numbering of the unknowns of several matrices (see
     * ImportedModel).
     */
    class Numbering
    {
    public:
      /** From the matrices and the lines of a node table, if there is one; its
       * name is for error texts. Throws InputError when they contradict each
       * other. */
      Numbering(const std::vector<ImportedMatrix> &matrices,
                const std::vector<NodeTableRow>   &table,
                const std::string                 &table_name);

      unsigned int n_dofs() const;

      /** Name of every unknown, or nothing. */
      const std::vector<DofLabel> &labels() const;

      /** "unknown 7 (node 3, component 1)", counted from 1. */
      std::string describe(unsigned int dof) const;

      /** The unknown of that name, if there is one. */
      std::optional<unsigned int> find(const DofLabel &label) const;

      /** Turns the matrix into this numbering, sorted as before. */
      void renumber(ImportedMatrix &matrix) const;

    private:
      unsigned int          n = 0;
      std::vector<DofLabel> names;
      /** Names ascending, with their unknowns. */
      std::vector<std::pair<DofLabel, unsigned int>> by_name;

      void number_by_table(const std::vector<ImportedMatrix> &matrices,
                           const std::vector<NodeTableRow>   &table,
                           const std::string                 &table_name);
      void number_by_names(const std::vector<ImportedMatrix> &matrices);
      void number_by_size(const std::vector<ImportedMatrix> &matrices);
      void sort_names();
      void check_sizes(const std::vector<ImportedMatrix> &matrices,
                       bool                               has_table) const;
    };

    /** Applies new numbers to rows and columns, leaves out those that have
     * none (n_new or more), and sorts. */
    void renumber_entries(ImportedMatrix                  &matrix,
                          const std::vector<unsigned int> &new_numbers,
                          unsigned int                     n_new);
  } // namespace import
} // namespace squeal

#endif
