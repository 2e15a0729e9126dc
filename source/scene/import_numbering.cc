// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/scene/import_numbering.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace squeal
{
  namespace import
  {
    namespace
    {
      std::string
      describe_part(const ImportedMatrix &matrix)
      {
        return "Matrix part " + matrix.name + " (" + matrix.file + ")";
      }
    } // namespace



    Numbering::Numbering(const std::vector<ImportedMatrix> &matrices,
                         const std::vector<NodeTableRow>   &table,
                         const std::string                 &table_name)
    {
      const auto has_names = [](const ImportedMatrix &matrix) {
        return !matrix.labels.empty();
      };
      const bool some_named =
        std::any_of(matrices.begin(), matrices.end(), has_names);
      const bool all_named =
        std::all_of(matrices.begin(), matrices.end(), has_names);
      if (!table.empty())
        {
          if (!all_named && table[0].dof == 0)
            throw InputError(table_name +
                             ":1: column 'dof' is missing; matrices without "
                             "node names need it");
          number_by_table(matrices, table, table_name);
        }
      else if (all_named)
        number_by_names(matrices);
      else if (!some_named)
        number_by_size(matrices);
      else
        {
          const auto unnamed =
            std::find_if_not(matrices.begin(), matrices.end(), has_names);
          throw InputError(describe_part(*unnamed) +
                           " has row numbers, another part node names: give "
                           "a node table that joins them");
        }
    }



    void
    Numbering::number_by_table(const std::vector<ImportedMatrix> &matrices,
                               const std::vector<NodeTableRow>   &table,
                               const std::string                 &table_name)
    {
      n = table.size();
      names.resize(n);
      for (unsigned int i = 0; i < n; ++i)
        {
          if (table[i].dof > static_cast<long>(n))
            throw InputError(table_name + ":" + std::to_string(table[i].line) +
                             ": dof " + std::to_string(table[i].dof) +
                             ", but the table has only " + std::to_string(n) +
                             " lines; every unknown needs one");
          names[table[i].dof > 0 ? table[i].dof - 1 : i] = table[i].label;
        }
      if (table[0].dof == 0)
        std::sort(names.begin(), names.end());
      sort_names();
      check_sizes(matrices, true);
      for (const ImportedMatrix &matrix : matrices)
        for (const DofLabel &label : matrix.labels)
          if (!find(label))
            throw InputError(describe_part(matrix) + ": " +
                             squeal::describe(label) +
                             " is not in the node table " + table_name);
    }



    void
    Numbering::number_by_names(const std::vector<ImportedMatrix> &matrices)
    {
      std::set<DofLabel> all;
      for (const ImportedMatrix &matrix : matrices)
        all.insert(matrix.labels.begin(), matrix.labels.end());
      names.assign(all.begin(), all.end());
      n = names.size();
      sort_names();
    }



    void
    Numbering::number_by_size(const std::vector<ImportedMatrix> &matrices)
    {
      for (const ImportedMatrix &matrix : matrices)
        n = std::max(n, matrix.n);
      check_sizes(matrices, false);
    }



    void
    Numbering::sort_names()
    {
      by_name.clear();
      for (unsigned int i = 0; i < n; ++i)
        by_name.emplace_back(names[i], i);
      std::sort(by_name.begin(), by_name.end());
    }



    void
    Numbering::check_sizes(const std::vector<ImportedMatrix> &matrices,
                           const bool                         has_table) const
    {
      using Role = MatrixPartParameters::Role;
      for (const ImportedMatrix &matrix : matrices)
        {
          if (!matrix.labels.empty())
            continue;
          // A file that does not give its size may end before the last
          // unknown, but hardly that of a mass or a stiffness.
          const bool is_exact =
            matrix.size_is_given ||
            (!has_table &&
             (matrix.role == Role::mass || matrix.role == Role::stiffness));
          if (matrix.n > n || (is_exact && matrix.n != n))
            throw InputError(
              describe_part(matrix) + " has " + std::to_string(matrix.n) +
              " rows, " + (has_table ? "the node table " : "another part ") +
              std::to_string(n) + "; all must have the same unknowns" +
              (matrix.size_is_given || has_table ? ""
                                                 : " (or give a node table)"));
        }
    }



    unsigned int
    Numbering::n_dofs() const
    {
      return n;
    }



    const std::vector<DofLabel> &
    Numbering::labels() const
    {
      return names;
    }



    std::string
    Numbering::describe(const unsigned int dof) const
    {
      return "unknown " + std::to_string(dof + 1) +
             (names.empty() ? "" : " (" + squeal::describe(names[dof]) + ")");
    }



    std::optional<unsigned int>
    Numbering::find(const DofLabel &label) const
    {
      const auto place = std::lower_bound(
        by_name.begin(), by_name.end(), std::make_pair(label, 0U));
      if (place == by_name.end() || !(place->first == label))
        return {};
      return place->second;
    }



    void
    Numbering::renumber(ImportedMatrix &matrix) const
    {
      if (!matrix.labels.empty())
        {
          std::vector<unsigned int> new_numbers;
          for (const DofLabel &label : matrix.labels)
            new_numbers.push_back(find(label).value());
          renumber_entries(matrix, new_numbers, n);
          matrix.labels.clear();
        }
      matrix.n             = n;
      matrix.size_is_given = true;
    }



    void
    renumber_entries(ImportedMatrix                  &matrix,
                     const std::vector<unsigned int> &new_numbers,
                     const unsigned int               n_new)
    {
      struct Entry
      {
        unsigned int row, column;
        double       value;
      };
      std::vector<Entry> entries;
      for (std::size_t k = 0; k < matrix.values.size(); ++k)
        {
          const unsigned int row    = new_numbers[matrix.rows[k]];
          const unsigned int column = new_numbers[matrix.columns[k]];
          if (row < n_new && column < n_new)
            entries.push_back({row, column, matrix.values[k]});
        }
      std::sort(
        entries.begin(), entries.end(), [](const Entry &a, const Entry &b) {
          return std::tie(a.row, a.column) < std::tie(b.row, b.column);
        });
      matrix.rows.resize(entries.size());
      matrix.columns.resize(entries.size());
      matrix.values.resize(entries.size());
      for (std::size_t k = 0; k < entries.size(); ++k)
        {
          matrix.rows[k]    = entries[k].row;
          matrix.columns[k] = entries[k].column;
          matrix.values[k]  = entries[k].value;
        }
      matrix.n = n_new;
    }
  } // namespace import
} // namespace squeal
