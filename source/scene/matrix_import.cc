// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>

#include <squeal/parameters/text.h>

#include <squeal/scene/imported_model.h>
#include <squeal/scene/matrix_formats.h>
#include <squeal/scene/matrix_import.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace squeal
{
  namespace
  {
    using import::RawMatrix;
    using import::TextFile;
    using Entry   = RawMatrix::Entry;
    using Storage = RawMatrix::Storage;
    using Role    = MatrixPartParameters::Role;

    bool
    comes_before(const Entry &a, const Entry &b)
    {
      return std::tie(a.row, a.column, a.line) <
             std::tie(b.row, b.column, b.line);
    }

    bool
    same_place(const Entry &a, const Entry &b)
    {
      return a.row == b.row && a.column == b.column;
    }

    std::string
    describe_place(const RawMatrix &raw, const Entry &entry)
    {
      if (raw.labels.empty())
        return "entry (" + std::to_string(entry.row + 1) + ", " +
               std::to_string(entry.column + 1) + ")";
      return "entry (" + describe(raw.labels[entry.row]) + "; " +
             describe(raw.labels[entry.column]) + ")";
    }

    std::string
    text_of(const double value)
    {
      std::ostringstream text;
      text.precision(10);
      text << value;
      return text.str();
    }

    /** Brings the names into ascending order and renumbers the entries. */
    void
    sort_labels(RawMatrix &raw)
    {
      if (raw.labels.empty())
        return;
      std::vector<unsigned int> order(raw.labels.size());
      std::iota(order.begin(), order.end(), 0);
      std::sort(order.begin(), order.end(), [&](const auto a, const auto b) {
        return raw.labels[a] < raw.labels[b];
      });
      std::vector<unsigned int> new_number(order.size());
      std::vector<DofLabel>     labels(order.size());
      for (unsigned int i = 0; i < order.size(); ++i)
        {
          new_number[order[i]] = i;
          labels[i]            = raw.labels[order[i]];
        }
      for (Entry &entry : raw.entries)
        {
          entry.row    = new_number[entry.row];
          entry.column = new_number[entry.column];
        }
      raw.labels = std::move(labels);
    }

    /** The entry at the mirrored place in sorted @p entries, or null. */
    const Entry *
    mirror_of(const std::vector<Entry> &entries, const Entry &entry)
    {
      const Entry key{entry.column, entry.row, 0, 0.};
      const auto  place =
        std::lower_bound(entries.begin(), entries.end(), key, comes_before);
      return place != entries.end() && same_place(*place, key) ? &*place
                                                               : nullptr;
    }

    void
    refuse_duplicates(const TextFile &file, const RawMatrix &raw)
    {
      const auto &entries = raw.entries;
      const auto  twice =
        std::adjacent_find(entries.begin(), entries.end(), same_place);
      if (twice != entries.end())
        file.fail_at((twice + 1)->line,
                     describe_place(raw, *twice) +
                       " is given twice, first in "
                       "line " +
                       std::to_string(twice->line));
    }

    /** Whether every row and every column of a nonzero entry has a diagonal
     * one. */
    bool
    has_all_diagonals(const RawMatrix &raw)
    {
      std::vector<bool> occurs(raw.n, false), has_diagonal(raw.n, false);
      for (const Entry &entry : raw.entries)
        if (entry.value != 0.)
          {
            occurs[entry.row] = occurs[entry.column] = true;
            if (entry.row == entry.column)
              has_diagonal[entry.row] = true;
          }
      return occurs == has_diagonal;
    }

    /** Whether some off-diagonal entry has its mirror image. With
     * symmetric_or_full storage the two must agree. */
    bool
    has_mirror_images(const TextFile &file, const RawMatrix &raw)
    {
      bool found = false;
      for (const Entry &entry : raw.entries)
        if (entry.row != entry.column)
          if (const Entry *mirror = mirror_of(raw.entries, entry))
            {
              found = true;
              if (raw.storage == Storage::symmetric_or_full &&
                  mirror->value != entry.value)
                file.fail_at(entry.line,
                             describe_place(raw, entry) +
                               " of a symmetric matrix differs from its "
                               "mirror image in line " +
                               std::to_string(mirror->line));
            }
      return found;
    }

    /** Decides what a file that does not say so has left out. Expects sorted
     * entries. */
    Storage
    decide_storage(const TextFile &file, const RawMatrix &raw, const Role role)
    {
      if (raw.storage != Storage::unknown &&
          raw.storage != Storage::symmetric_or_full)
        return raw.storage;
      if (has_mirror_images(file, raw))
        return Storage::general;
      // Friction couples rows along the face with columns across it: it has
      // no mirror images either, but no diagonal.
      const bool may_be_unsymmetric =
        raw.storage == Storage::unknown &&
        (role == Role::friction || role == Role::damping ||
         role == Role::circulatory);
      return may_be_unsymmetric && !has_all_diagonals(raw) ? Storage::general
                                                           : Storage::symmetric;
    }

    /** Adds the entries that the file has left out; sorted before and after. */
    void
    expand(const TextFile &file, RawMatrix &raw)
    {
      if (raw.storage == Storage::general)
        return;
      const bool        skew    = raw.storage == Storage::skew;
      const std::size_t n_given = raw.entries.size();
      for (std::size_t i = 0; i < n_given; ++i)
        {
          const Entry entry = raw.entries[i];
          if (entry.row != entry.column)
            raw.entries.push_back({entry.column,
                                   entry.row,
                                   entry.line,
                                   skew ? -entry.value : entry.value});
          else if (skew)
            file.fail_at(entry.line,
                         describe_place(raw, entry) +
                           " is on the diagonal, "
                           "which is zero in a skew-symmetric matrix");
        }
      std::sort(raw.entries.begin(), raw.entries.end(), comes_before);
      refuse_duplicates(file, raw);
    }

    /** Sizes of diagonal entries, which say how far apart rounding leaves a
     * pair of mirror images. The huge ones that hold unknowns say nothing of
     * the entries of others. */
    class DiagonalSizes
    {
    public:
      explicit DiagonalSizes(const RawMatrix &raw)
      {
        std::vector<double> free;
        for (const Entry &entry : raw.entries)
          if (entry.row == entry.column && entry.value != 0.)
            {
              sizes.emplace_back(entry.row, std::abs(entry.value));
              if (!is_huge(sizes.back().second))
                free.push_back(sizes.back().second);
            }
        if (free.empty())
          return;
        const auto middle = free.begin() + free.size() / 2;
        std::nth_element(free.begin(), middle, free.end());
        median = *middle;
      }

      bool
      hold(const Entry &entry) const
      {
        return is_huge(size_of(entry.row)) || is_huge(size_of(entry.column));
      }

      /** Of a stiffness whose parts cancel in the entry. Positive ones have
       * k_ij^2 <= k_ii k_jj; what was condensed may have less left on the
       * diagonal than was there. */
      double
      at(const Entry &entry) const
      {
        return hold(entry) ? median
                           : std::max(std::sqrt(size_of(entry.row)) *
                                        std::sqrt(size_of(entry.column)),
                                      median);
      }

    private:
      /** By rows, ascending. */
      std::vector<std::pair<unsigned int, double>> sizes;
      double                                       median = 0.;

      static bool
      is_huge(const double size)
      {
        return size >= held_stiffness;
      }

      double
      size_of(const unsigned int row) const
      {
        const auto place =
          std::lower_bound(sizes.begin(), sizes.end(), std::make_pair(row, 0.));
        return place != sizes.end() && place->first == row ? place->second : 0.;
      }
    };

    /** How far entries may be from symmetric: what printing with nine digits
     * leaves, and cancellation in entries of the size @p scale. */
    bool
    nearly_equal(const double a, const double b, const double scale)
    {
      return std::abs(a - b) <=
             1e-8 * std::max(std::abs(a), std::abs(b)) + 1e-14 * scale;
    }

    /** Roles whose matrices are symmetric, and whose held unknowns are taken
     * out of the model. */
    bool
    needs_symmetry(const Role role)
    {
      return role == Role::mass || role == Role::stiffness ||
             role == Role::normal_contact;
    }

    /** Finds the symmetry of expanded, sorted entries, makes it exact, and
     * refuses an unsymmetric matrix where the role needs a symmetric one. */
    ImportedMatrix::Symmetry
    find_symmetry(const TextFile &file, RawMatrix &raw, const Role role)
    {
      const DiagonalSizes diagonal(raw);
      const auto          fits = [&](const Entry &entry, const double sign) {
        const Entry *mirror = mirror_of(raw.entries, entry);
        return (needs_symmetry(role) && diagonal.hold(entry)) ||
               nearly_equal(entry.value,
                            mirror ? sign * mirror->value : 0.,
                            diagonal.at(entry));
      };
      const auto unsymmetric =
        std::find_if_not(raw.entries.begin(),
                         raw.entries.end(),
                         [&](const Entry &entry) { return fits(entry, 1.); });
      if (unsymmetric != raw.entries.end())
        {
          const Entry *mirror = mirror_of(raw.entries, *unsymmetric);
          if (needs_symmetry(role))
            file.fail_at(unsymmetric->line,
                         describe_place(raw, *unsymmetric) + " is " +
                           text_of(unsymmetric->value) + ", its mirror image " +
                           (mirror ? text_of(mirror->value) : "0") +
                           "; this role needs a symmetric matrix: give the "
                           "frictional part as a part of role friction, what "
                           "else is not symmetric as one of role circulatory");
          const bool skew =
            std::all_of(raw.entries.begin(),
                        raw.entries.end(),
                        [&](const Entry &entry) { return fits(entry, -1.); });
          return skew ? ImportedMatrix::Symmetry::skew
                      : ImportedMatrix::Symmetry::general;
        }

      std::vector<double> means(raw.entries.size());
      for (std::size_t i = 0; i < means.size(); ++i)
        {
          const Entry *mirror = mirror_of(raw.entries, raw.entries[i]);
          means[i] = mirror ? .5 * (raw.entries[i].value + mirror->value) : 0.;
        }
      for (std::size_t i = 0; i < means.size(); ++i)
        raw.entries[i].value = means[i];
      return ImportedMatrix::Symmetry::symmetric;
    }

    RawMatrix
    read_raw(TextFile &file, const MatrixPartParameters &part)
    {
      using Format  = MatrixPartParameters::Format;
      Format format = part.format;
      if (format == Format::automatic)
        format = import::detect_format(file);
      if (format != Format::nastran && !part.matrix_name.empty())
        throw InputError(
          file.name() +
          ": 'Matrix name' = " + prm::in_quotes(part.matrix_name) +
          " has no meaning here: files of MatrixMarket and "
          "Abaqus hold one matrix, those with DMIG several: leave "
          "it empty or give the right file");
      if (format == Format::matrix_market)
        return import::read_matrix_market(file);
      if (format == Format::abaqus)
        return import::read_abaqus_matrix(file);
      return import::read_nastran_matrix(file, part.matrix_name);
    }

    ImportedMatrix
    read_part(const MatrixPartParameters &part)
    {
      TextFile  file(part.file);
      RawMatrix raw = read_raw(file, part);
      sort_labels(raw);
      std::sort(raw.entries.begin(), raw.entries.end(), comes_before);
      refuse_duplicates(file, raw);
      if (raw.is_damping && part.role != Role::friction &&
          part.role != Role::damping)
        file.fail(std::string("the file is marked as '") + damping_mark +
                  "': its role is friction");

      ImportedMatrix matrix;
      const bool     is_stated = raw.storage != Storage::unknown;
      raw.storage              = decide_storage(file, raw, part.role);
      matrix.storage           = is_stated ? ImportedMatrix::Storage::stated
                                 : raw.storage == Storage::general
                                   ? ImportedMatrix::Storage::assumed_full
                                   : ImportedMatrix::Storage::assumed_half;
      expand(file, raw);
      matrix.is_damping    = raw.is_damping;
      matrix.name          = part.name;
      matrix.file          = part.file;
      matrix.role          = part.role;
      matrix.factor        = part.factor;
      matrix.n             = raw.n;
      matrix.size_is_given = raw.size_is_given;
      matrix.symmetry      = find_symmetry(file, raw, part.role);
      matrix.labels        = std::move(raw.labels);
      for (const Entry &entry : raw.entries)
        if (entry.value != 0.)
          {
            matrix.rows.push_back(entry.row);
            matrix.columns.push_back(entry.column);
            matrix.values.push_back(entry.value);
          }
      return matrix;
    }
  } // namespace



  std::string
  describe(const DofLabel &label)
  {
    return "node " + std::to_string(label.node) + ", component " +
           std::to_string(label.component);
  }



  ImportedMatrix
  read_matrix(const MatrixPartParameters &part)
  {
    try
      {
        return read_part(part);
      }
    catch (const InputError &error)
      {
        throw InputError("Matrix part " + part.name + ": " + error.what());
      }
  }
} // namespace squeal
