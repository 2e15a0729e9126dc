// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/text.h>

#include <squeal/scene/matrix_formats.h>

#include <algorithm>

namespace squeal
{
  namespace import
  {
    namespace
    {
      /** Takes what a keyword line says about the matrix. */
      void
      read_keyword(const TextFile &file, RawMatrix &matrix)
      {
        std::string line = upper_case(file.line());
        for (const char blank : {' ', '\t'})
          line.erase(std::remove(line.begin(), line.end(), blank), line.end());
        if (!prm::starts_with(line, "*MATRIXINPUT"))
          file.fail("keyword " + prm::in_quotes(std::string(file.line())) +
                    " does not belong in a matrix file; only *MATRIX INPUT "
                    "and the data lines of MATRIX OUTPUT do");
        if (!matrix.entries.empty())
          file.fail("a second matrix starts here; one file holds one matrix");
        const std::string key   = "TYPE=";
        const std::size_t place = line.find(key);
        if (place != std::string::npos)
          {
            const std::size_t start = place + key.size();
            const std::string type =
              line.substr(start, line.find(',', start) - start);
            if (type != "UNSYMMETRIC" && type != "SYMMETRIC")
              file.fail("TYPE " + prm::in_quotes(type) +
                        " is not known; write SYMMETRIC or UNSYMMETRIC");
            matrix.storage = type == "SYMMETRIC"
                               ? RawMatrix::Storage::symmetric_or_full
                               : RawMatrix::Storage::general;
          }
        if (line.find("INPUT=") != std::string::npos ||
            line.find("SCALEFACTOR=") != std::string::npos)
          file.fail("INPUT= and SCALE FACTOR= are not followed: name the file "
                    "itself and use the part's factor");
      }

      DofLabel
      read_node_label(const TextFile        &file,
                      const std::string_view node,
                      const std::string_view component)
      {
        DofLabel label;
        label.node = integer_field(file, node, "node number");
        if (label.node == 0)
          file.fail("node number 0 does not exist");
        const long number = integer_field(file, component, "degree of freedom");
        if (number < 1 || number > 1000)
          file.fail("degree of freedom " + std::to_string(number) +
                    " does not exist; displacements are 1 to 3, rotations 4 "
                    "to 6");
        label.component = static_cast<unsigned int>(number);
        return label;
      }

      unsigned int
      read_index(const TextFile        &file,
                 const std::string_view text,
                 const char            *what)
      {
        const long index = integer_field(file, text, what);
        if (index < 1)
          file.fail(std::string(what) + " " + std::to_string(index) +
                    " is not positive; a model with nodes that Abaqus added "
                    "itself needs FORMAT=MATRIX INPUT");
        if (index > 1000000000)
          file.fail(std::string(what) + " " + std::to_string(index) +
                    " is too large");
        return static_cast<unsigned int>(index - 1);
      }
    } // namespace



    RawMatrix
    read_abaqus_matrix(TextFile &file)
    {
      file.check_last_line_is_complete();
      RawMatrix    matrix;
      unsigned int n_fields = 0;
      while (file.next())
        {
          const std::string_view line = trimmed(file.line());
          if (line.empty() || line.substr(0, 2) == "**")
            continue;
          if (line[0] == '*')
            {
              read_keyword(file, matrix);
              continue;
            }
          const Fields entry = split_at_blanks_and_commas(line);
          if (entry.n != 3 && entry.n != 5)
            file.fail("an entry has row, column, value (FORMAT=COORDINATE) or "
                      "node, dof, node, dof, value (FORMAT=MATRIX INPUT)");
          if (n_fields != 0 && entry.n != n_fields)
            file.fail("this entry has " + std::to_string(entry.n) +
                      " fields, those before it " + std::to_string(n_fields));
          n_fields = entry.n;
          const double value =
            real_field(file, entry[n_fields - 1], "matrix entry");
          if (n_fields == 3)
            {
              const unsigned int row    = read_index(file, entry[0], "row");
              const unsigned int column = read_index(file, entry[1], "column");
              matrix.add(row, column, value, file.line_number());
            }
          else
            {
              const DofLabel row    = read_node_label(file, entry[0], entry[1]);
              const DofLabel column = read_node_label(file, entry[2], entry[3]);
              matrix.add(row, column, value, file.line_number());
            }
        }
      if (matrix.entries.empty())
        file.fail("the file holds no matrix entry");
      return matrix;
    }
  } // namespace import
} // namespace squeal
