// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/output/loudest_pairs.h>

namespace squeal
{
  LoudestPairs
  loudest_pairs(const ComplexPairs &pairs)
  {
    if (pairs.size() == 0)
      throw ComputationError("no pair lies in the band from "
                             "Eigenvalues/Lowest frequency to Highest "
                             "frequency: widen it");
    LoudestPairs result;
    unsigned int loudest = 0;
    for (unsigned int i = 1; i < pairs.size(); ++i)
      if (pairs.sigma(i) > pairs.sigma(loudest))
        loudest = i;
    for (unsigned int i = 0; i < pairs.size(); ++i)
      if (is_unstable(pairs, i))
        {
          ++result.n_unstable;
          if (i != loudest)
            result.numbers.push_back(i);
        }
    result.numbers.push_back(loudest);
    return result;
  }



  void
  append_pair_columns(std::vector<Table::Column> &columns)
  {
    using Type = Table::Type;
    columns.insert(
      columns.end(),
      {{"frequency_hz", Type::real, "Hz", "frequency of the pair", 6},
       {"sigma_per_s",
        Type::real,
        "1/s",
        "its growth rate, positive: unstable",
        4},
       {"name", Type::text, "", "name of the pair"},
       {"error_estimate_rel",
        Type::real,
        "",
        "estimated error of the eigenvalue by the basis, relative",
        2}});
  }



  void
  append_pair_cells(std::vector<Cell>           &cells,
                    const ComplexPairs          &pairs,
                    const std::vector<ModeName> &names,
                    const unsigned int           i)
  {
    cells.insert(cells.end(),
                 {pairs.frequency(i),
                  pairs.sigma(i),
                  names[i].text,
                  or_missing(pairs.error_estimate[i])});
  }
} // namespace squeal
