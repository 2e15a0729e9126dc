// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_matrix_formats_h
#define squeal_scene_matrix_formats_h

#include <squeal/scene/import_text.h>
#include <squeal/scene/matrix_import.h>

#include <unordered_map>

namespace squeal
{
  namespace import
  {
    /**
     * The entries of a matrix as they stand in a file, one reader a format.
     */
    struct RawMatrix
    {
      /** What the file says about the entries that it leaves out. */
      enum class Storage
      {
        unknown,
        general,           /**< nothing is left out */
        symmetric,         /**< one of a_ij and a_ji is there */
        symmetric_or_full, /**< one of them or both, alike */
        skew               /**< one of a_ij and a_ji = -a_ij is there */
      };
      struct Entry
      {
        unsigned int row, column, line;
        double       value;
      };

      Storage            storage = Storage::unknown;
      std::vector<Entry> entries;
      unsigned int       n             = 0;
      bool               size_is_given = false;
      /** Whether damping_mark is among the comments. */
      bool is_damping = false;

      /** Names of the rows in the order in which they were met; empty in a
       * file of numbers. */
      std::vector<DofLabel> labels;

      /** Adds an entry of numbered rows and columns (from 0). */
      void add(unsigned int row,
               unsigned int column,
               double       value,
               unsigned     line);

      /** Adds an entry of named rows and columns. */
      void add(const DofLabel &row,
               const DofLabel &column,
               double          value,
               unsigned int    line);

    private:
      struct Hash
      {
        std::size_t
        operator()(const DofLabel &label) const
        {
          // of any number in a file, without overflow
          return std::hash<std::size_t>()(
            static_cast<std::size_t>(label.node) * 8 + label.component);
        }
      };
      std::unordered_map<DofLabel, unsigned int, Hash> index_of;

      unsigned int index(const DofLabel &label);
    };

    /** MatrixMarket coordinate format. */
    RawMatrix read_matrix_market(TextFile &file);

    /** Abaqus' formats MATRIX INPUT and COORDINATE. */
    RawMatrix read_abaqus_matrix(TextFile &file);

    /** The DMIG matrix @p name, or the only square one if @p name is empty. */
    RawMatrix read_nastran_matrix(TextFile &file, const std::string &name);

    /** The format of a file from its first lines; throws InputError for a
     * Harwell-Boeing file and for anything not known. */
    MatrixPartParameters::Format detect_format(TextFile &file);
  } // namespace import
} // namespace squeal

#endif
