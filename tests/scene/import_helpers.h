// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_scene_import_helpers_h
#define squeal_tests_scene_import_helpers_h

#include <squeal/scene/matrix_import.h>

#include <fstream>
#include <map>
#include <string>
#include <utility>

namespace squeal
{
  namespace testing
  {
    /** Writes @p content to @p name in the test's own directory. */
    inline std::string
    write_text(const std::string &name, const std::string &content)
    {
      std::ofstream(name, std::ios::binary) << content;
      return name;
    }

    inline MatrixPartParameters
    part_of(const std::string               &file,
            const MatrixPartParameters::Role role,
            const std::string               &matrix_name = "")
    {
      MatrixPartParameters part;
      part.name        = "K";
      part.file        = file;
      part.role        = role;
      part.matrix_name = matrix_name;
      return part;
    }

    /** Entries by row and column, counted from 0. */
    using EntryMap = std::map<std::pair<unsigned int, unsigned int>, double>;

    inline EntryMap
    entries_of(const ImportedMatrix &matrix)
    {
      EntryMap entries;
      for (std::size_t k = 0; k < matrix.values.size(); ++k)
        entries[{matrix.rows[k], matrix.columns[k]}] = matrix.values[k];
      return entries;
    }
  } // namespace testing
} // namespace squeal

#endif
