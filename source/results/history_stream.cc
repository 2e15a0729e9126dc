// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/state_files.h>
#include <squeal/results/history_stream.h>

#include <deal.II/base/exceptions.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

namespace squeal
{
  namespace
  {
    /** Rows that are in memory at a time: some MB. */
    constexpr std::size_t samples_together = 256, changes_together = 65536;
    constexpr std::size_t change_columns = 3;

    /** A field of a pair in a row: member and numbers a sample. */
    struct Field
    {
      std::vector<double> HistorySamples::*member;
      std::size_t                          size;
    };

    /** What a row has of a pair, in this order. */
    std::vector<Field>
    fields_of(const std::size_t n_nodes, const std::size_t n_probes)
    {
      return {{&HistorySamples::pressure, n_nodes},
              {&HistorySamples::traction, 2 * n_nodes},
              {&HistorySamples::slip_rate, 2 * n_nodes},
              {&HistorySamples::gap, n_nodes},
              {&HistorySamples::status, n_nodes},
              {&HistorySamples::resultants, 3},
              {&HistorySamples::probes, n_probes}};
    }

    /** The time comes first, then pair after pair, then the energies. */
    std::vector<std::size_t>
    first_columns(const std::vector<std::size_t> &n_nodes,
                  const std::size_t               n_probes)
    {
      std::vector<std::size_t> result = {1};
      for (const std::size_t n : n_nodes)
        {
          result.push_back(result.back());
          for (const Field &field : fields_of(n, n_probes))
            result.back() += field.size;
        }
      return result;
    }

    std::string
    name_beside(const std::string &path, const std::string &what)
    {
      const std::filesystem::path file(path);
      return (file.parent_path() / (file.stem().string() + "_" + what + ".bin"))
        .string();
    }
  } // namespace



  HistoryStream::HistoryStream(const std::string              &path,
                               const std::vector<std::size_t> &nodes,
                               const std::size_t               probes,
                               const std::size_t               energies)
    : n_nodes(nodes)
    , n_probes(probes)
    , n_energies(energies)
    , first_column(first_columns(nodes, probes))
    , samples(samples_name(path),
              state_kind::samples,
              first_column.back() + energies)
    , changes(changes_name(path), state_kind::changes, change_columns)
  {
  }

  std::string
  HistoryStream::samples_name(const std::string &path)
  {
    return name_beside(path, "samples");
  }

  std::string
  HistoryStream::changes_name(const std::string &path)
  {
    return name_beside(path, "changes");
  }



  void
  HistoryStream::start()
  {
    samples.start();
    changes.start();
  }



  void
  HistoryStream::append(const std::vector<HistorySamples> &of_pairs)
  {
    AssertDimension(of_pairs.size(), n_nodes.size());
    const HistorySamples &any = of_pairs[0];
    AssertDimension(any.n_samples(), 1);
    AssertDimension(any.energies.size(), n_energies);
    std::vector<double> row = any.time;
    for (std::size_t i = 0; i < of_pairs.size(); ++i)
      for (const Field &field : fields_of(n_nodes[i], n_probes))
        {
          const auto &values = of_pairs[i].*field.member;
          AssertDimension(values.size(), field.size);
          row.insert(row.end(), values.begin(), values.end());
        }
    row.insert(row.end(), any.energies.begin(), any.energies.end());
    samples.append(row);
  }

  void
  HistoryStream::append(const StatusChange &change)
  {
    changes.append({change.time,
                    static_cast<double>(change.node),
                    static_cast<double>(change.status)});
  }



  std::size_t
  HistoryStream::n_samples() const
  {
    return samples.n_rows();
  }



  HistorySamples
  HistoryStream::read(const std::size_t pair,
                      const std::size_t first,
                      const std::size_t n) const
  {
    const std::vector<double> rows      = samples.read(first, n);
    const std::size_t         n_columns = first_column.back() + n_energies;
    HistorySamples            result;
    for (std::size_t k = 0; k < n; ++k)
      {
        const double *row = rows.data() + k * n_columns;
        result.time.push_back(row[0]);
        const double *part = row + first_column[pair];
        for (const Field &field : fields_of(n_nodes[pair], n_probes))
          {
            auto &values = result.*field.member;
            values.insert(values.end(), part, part + field.size);
            part += field.size;
          }
        result.energies.insert(
          result.energies.end(), row + first_column.back(), row + n_columns);
      }
    return result;
  }



  std::size_t
  HistoryStream::sample_at(const double time) const
  {
    std::size_t first = 0;
    for (std::size_t n = n_samples(); n > 0;)
      {
        const std::size_t middle = n / 2;
        if (samples.read(first + middle, 1)[0] < time)
          {
            first += middle + 1;
            n -= middle + 1;
          }
        else
          n = middle;
      }
    return first;
  }



  void
  HistoryStream::write(HistoryWriter &writer) const
  {
    for (std::size_t first = 0; first < n_samples(); first += samples_together)
      for (std::size_t i = 0; i < n_nodes.size(); ++i)
        writer.append(
          read(i, first, std::min(samples_together, n_samples() - first)), i);
    write_changes(writer);
  }

  void
  HistoryStream::write_changes(HistoryWriter &writer) const
  {
    for (std::size_t first = 0; first < changes.n_rows();
         first += changes_together)
      {
        const std::vector<double> rows = changes.read(
          first, std::min(changes_together, changes.n_rows() - first));
        std::vector<std::vector<StatusChange>> of_pair(n_nodes.size());
        for (std::size_t k = 0; k < rows.size(); k += change_columns)
          {
            auto        node = static_cast<std::size_t>(rows[k + 1]);
            std::size_t pair = 0;
            for (; node >= n_nodes[pair]; ++pair)
              node -= n_nodes[pair];
            of_pair[pair].push_back(
              {rows[k], node, static_cast<ContactStatus>(int(rows[k + 2]))});
          }
        for (std::size_t i = 0; i < of_pair.size(); ++i)
          writer.append(of_pair[i], i);
      }
  }



  NamedNumbers
  HistoryStream::memory()
  {
    NamedNumbers result;
    result.set("samples", samples.memory());
    result.set("changes", changes.memory());
    return result;
  }

  void
  HistoryStream::restore(const NamedNumbers &memory)
  {
    samples.restore(memory.group("samples"));
    changes.restore(memory.group("changes"));
  }

  void
  HistoryStream::remove()
  {
    samples.remove();
    changes.remove();
  }
} // namespace squeal
