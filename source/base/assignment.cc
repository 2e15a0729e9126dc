// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/assignment.h>

#include <limits>

namespace squeal
{
  namespace
  {
    /** For at most as many rows as columns. */
    class ShortestPaths
    {
    public:
      explicit ShortestPaths(const std::vector<std::vector<double>> &costs)
        : costs(costs)
        , n_rows(costs.size())
        , n_columns(costs.front().size())
        , row_price(n_rows, 0.)
        , column_price(n_columns, 0.)
        , row_of(n_columns, -1)
      {
      }

      std::vector<int>
      solve()
      {
        for (int row = 0; row < n_rows; ++row)
          add_row(row);
        std::vector<int> column_of(n_rows, -1);
        for (int column = 0; column < n_columns; ++column)
          if (row_of[column] >= 0)
            column_of[row_of[column]] = column;
        return column_of;
      }

    private:
      double
      reduced_cost(const int row, const int column) const
      {
        return costs[row][column] - row_price[row] - column_price[column];
      }

      /** Finds the cheapest chain of exchanges that gives @p new_row a column
       * and carries it out. */
      void
      add_row(const int new_row)
      {
        const double        infinity = std::numeric_limits<double>::infinity();
        std::vector<double> distance(n_columns, infinity);
        std::vector<int>    previous(n_columns, -1);
        std::vector<bool>   done(n_columns, false);
        int                 row = new_row, column = -1;
        double              length = 0.;
        do
          {
            int nearest = -1;
            for (int c = 0; c < n_columns; ++c)
              {
                if (done[c])
                  continue;
                const double through = length + reduced_cost(row, c);
                if (through < distance[c])
                  {
                    distance[c] = through;
                    previous[c] = column;
                  }
                if (nearest < 0 || distance[c] < distance[nearest])
                  nearest = c;
              }
            column       = nearest;
            done[column] = true;
            length       = distance[column];
            row          = row_of[column];
          }
        while (row >= 0);

        row_price[new_row] += length;
        for (int c = 0; c < n_columns; ++c)
          if (done[c] && c != column)
            {
              row_price[row_of[c]] += length - distance[c];
              column_price[c] -= length - distance[c];
            }
        for (int c = column; c >= 0; c = previous[c])
          row_of[c] = previous[c] >= 0 ? row_of[previous[c]] : new_row;
      }

      const std::vector<std::vector<double>> &costs;
      int                                     n_rows, n_columns;
      std::vector<double>                     row_price, column_price;
      std::vector<int>                        row_of;
    };
  } // namespace



  std::vector<int>
  smallest_assignment(const std::vector<std::vector<double>> &costs)
  {
    if (costs.empty() || costs.front().empty())
      return std::vector<int>(costs.size(), -1);
    const std::size_t n_rows = costs.size(), n_columns = costs.front().size();
    if (n_rows <= n_columns)
      return ShortestPaths(costs).solve();

    std::vector<std::vector<double>> turned(n_columns,
                                            std::vector<double>(n_rows));
    for (std::size_t r = 0; r < n_rows; ++r)
      for (std::size_t c = 0; c < n_columns; ++c)
        turned[c][r] = costs[r][c];
    const std::vector<int> row_of = ShortestPaths(turned).solve();
    std::vector<int>       column_of(n_rows, -1);
    for (std::size_t c = 0; c < n_columns; ++c)
      column_of[row_of[c]] = c;
    return column_of;
  }
} // namespace squeal
