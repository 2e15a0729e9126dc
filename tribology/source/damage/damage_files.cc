// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/files.h>
#include <squeal/results/hdf5_file.h>
#include <squeal/tribology/damage/damage_files.h>

namespace squeal::tribology
{
  void
  write_damage_hdf5(const std::string   &path,
                    const Table         &table,
                    const HistoryDamage &damage)
  {
    AtomicFile target(path);
    Hdf5File   file(target.temporary(), Hdf5File::Mode::create);
    file.write_attribute("format", "squeal damage map");
    file.write_attribute("format_version", 1.);
    file.write_attribute("duration_s", damage.duration);
    const std::uint64_t n = table.n_rows();
    for (const Table::Column &column : table.columns())
      file.write("nodes/" + column.name, {n}, table.reals(column.name));
    const std::uint64_t m = damage.matrices[0].n_classes();
    std::vector<double> ranges, means, counts;
    for (std::uint64_t i = 0; i < m; ++i)
      {
        ranges.push_back(damage.matrices[0].range(i));
        means.push_back(damage.matrices[0].mean(i));
      }
    for (const RangeMeanMatrix &matrix : damage.matrices)
      counts.insert(
        counts.end(), matrix.values().begin(), matrix.values().end());
    file.write("range_mean/range_pa", {m}, ranges);
    file.write("range_mean/mean_pa", {m}, means);
    file.write("range_mean/cycles", {n, m, m}, counts);
    file.close();
    target.commit();
  }

} // namespace squeal::tribology
