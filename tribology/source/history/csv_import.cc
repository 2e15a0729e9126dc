// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/exceptions.h>
#include <squeal/base/input_file.h>
#include <squeal/parameters/names.h>
#include <squeal/parameters/numbers.h>
#include <squeal/parameters/text.h>
#include <squeal/results/csv_dialect.h>
#include <squeal/results/table.h>
#include <squeal/tribology/history/csv_import.h>
#include <squeal/tribology/history/face_areas.h>

#include <algorithm>
#include <fstream>

namespace squeal::tribology
{
  namespace
  {
    /** Reads a table of numbers line by line. */
    class LineReader
    {
    public:
      explicit LineReader(const std::string &path)
        : path(path)
      {
        require_input_file(path);
        in.open(path);
        if (!in.is_open())
          throw InputError("'" + path + "' cannot be read");
        std::string line;
        if (!std::getline(in, line))
          throw InputError("'" + path + "' is empty");
        trim(line);
        line    = without_byte_order_mark(line, path);
        dialect = CsvDialect(line);
        names   = prm::split(line, dialect.separator());
        for (std::size_t i = 0; i < names.size(); ++i)
          if (std::count(names.begin(), names.begin() + i, names[i]) > 0)
            throw InputError(path + ":1: column '" + names[i] +
                             "' is there twice");
      }

      /** What is not read is refused: a column that is misspelt would count as
       * absent. */
      void
      require_known(const std::vector<std::string> &known) const
      {
        for (const std::string &name : names)
          if (std::find(known.begin(), known.end(), name) == known.end())
            throw InputError(path + ":1: column '" + name + "' is not read" +
                             prm::did_you_mean(name, known));
      }

      /** Position of a column, or -1 where it may be absent. */
      int
      column(const std::string &name, const bool is_needed) const
      {
        const auto place = std::find(names.begin(), names.end(), name);
        if (place != names.end())
          return static_cast<int>(place - names.begin());
        if (is_needed)
          throw InputError(path + ":1: column '" + name + "' is missing" +
                           prm::did_you_mean(name, names));
        return -1;
      }

      /** The next line as numbers; false at the end. */
      bool
      next(std::vector<double> &values)
      {
        std::string line;
        do
          {
            if (!std::getline(in, line))
              return false;
            ++number;
            // A file that was cut may end within a number, which would still
            // be one.
            if (in.eof())
              refuse("the line does not end: the file may have been cut; if it "
                     "is whole, add a newline");
            trim(line);
          }
        while (line.empty());
        const std::vector<std::string> cells =
          prm::split(line, dialect.separator());
        if (cells.size() != names.size())
          refuse("has " + std::to_string(cells.size()) + " cells, the header " +
                 std::to_string(names.size()) +
                 dialect.hint(cells.size(), names.size()));
        values.clear();
        for (std::size_t i = 0; i < cells.size(); ++i)
          {
            const std::optional<double> value = prm::parse_number(
              dialect.number(cells[i], path + ":" + std::to_string(number)));
            if (!value)
              refuse("column '" + names[i] + "': " + prm::in_quotes(cells[i]) +
                     " is not a number");
            values.push_back(*value);
          }
        return true;
      }

      [[noreturn]] void
      refuse(const std::string &what) const
      {
        throw InputError(path + ":" + std::to_string(number) + ": " + what);
      }

    private:
      void
      trim(std::string &line) const
      {
        if (!line.empty() && line.back() == '\r')
          line.pop_back();
        if (line.find('\r') != std::string::npos)
          refuse("a carriage return within the line: lines must end with a "
                 "newline");
      }

      std::string              path;
      std::ifstream            in;
      CsvDialect               dialect;
      std::vector<std::string> names;
      unsigned long            number = 1;
    };



    HistoryLayout
    read_nodes(const std::string &path)
    {
      LineReader          lines(path);
      const int           node = lines.column("node", true);
      const int           x    = lines.column("x_m", true);
      const int           y    = lines.column("y_m", true);
      const int           area = lines.column("area_m2", true);
      HistoryLayout       layout;
      std::vector<double> row;
      while (lines.next(row))
        {
          if (row[node] != layout.n_nodes())
            lines.refuse("expected node " + std::to_string(layout.n_nodes()));
          if (row[area] <= 0.)
            lines.refuse("the area is not positive");
          layout.points.push_back({{row[x], row[y], 0.}});
          layout.areas.push_back(row[area]);
        }
      if (layout.n_nodes() == 0)
        throw InputError("'" + path + "' has no nodes");
      require_areas_of_face(layout, path);
      return layout;
    }



    /** Columns of the table of samples. */
    struct SampleColumns
    {
      static inline const std::vector<std::string> names = {
        "time_s",
        "node",
        "pressure_pa",
        "traction_x_pa",
        "traction_y_pa",
        "slip_rate_x_m_per_s",
        "slip_rate_y_m_per_s",
        "gap_m",
        "status"};

      explicit SampleColumns(const LineReader &lines)
        : time(lines.column("time_s", true))
        , node(lines.column("node", true))
        , pressure(lines.column("pressure_pa", true))
        , traction_x(lines.column("traction_x_pa", true))
        , traction_y(lines.column("traction_y_pa", true))
        , slip_x(lines.column("slip_rate_x_m_per_s",
                              lines.column("slip_rate_y_m_per_s", false) >= 0))
        , slip_y(lines.column("slip_rate_y_m_per_s", slip_x >= 0))
        , gap(lines.column("gap_m", false))
        , status(lines.column("status", false))
      {
      }

      int time, node, pressure, traction_x, traction_y, slip_x, slip_y, gap,
        status;
    };
  } // namespace



  std::uint64_t
  import_csv_history(const std::string &nodes,
                     const std::string &samples,
                     const std::string &history)
  {
    HistoryLayout       layout = read_nodes(nodes);
    LineReader          lines(samples);
    const SampleColumns column(lines);
    lines.require_known(SampleColumns::names);
    layout.name           = samples;
    layout.has_slip_rate  = column.slip_x >= 0;
    layout.has_gap        = column.gap >= 0;
    layout.has_status     = column.status >= 0;
    layout.has_resultants = false;

    HistoryWriter       writer(history, layout);
    HistorySamples      s;
    std::vector<double> row;
    std::uint64_t       n_done = 0;
    std::size_t         node   = 0;
    double              last   = 0.;
    while (lines.next(row))
      {
        if (row[column.node] != node)
          lines.refuse("expected node " + std::to_string(node) +
                       ": each time has a line for each node, in their order");
        if (node == 0)
          {
            if (n_done + s.n_samples() > 0 && row[column.time] <= last)
              lines.refuse("the time does not increase");
            last = row[column.time];
            s.time.push_back(last);
          }
        else if (row[column.time] != last)
          lines.refuse("the time changes before all nodes had their line");
        if (row[column.pressure] < 0.)
          lines.refuse("the pressure is negative: compression is positive");
        s.pressure.push_back(row[column.pressure]);
        s.traction.insert(s.traction.end(),
                          {row[column.traction_x], row[column.traction_y]});
        if (layout.has_slip_rate)
          s.slip_rate.insert(s.slip_rate.end(),
                             {row[column.slip_x], row[column.slip_y]});
        if (layout.has_gap)
          s.gap.push_back(row[column.gap]);
        if (layout.has_status)
          {
            const double status = row[column.status];
            if (status != 0. && status != 1. && status != 2.)
              lines.refuse("the status is not 0 open, 1 stick or 2 slip");
            s.status.push_back(status);
          }
        node = (node + 1) % layout.n_nodes();
        if (node == 0 && s.n_samples() == 1024)
          {
            n_done += s.n_samples();
            writer.append(s);
            s.clear();
          }
      }
    if (node != 0)
      lines.refuse("the last sample lacks nodes from " + std::to_string(node) +
                   " on");
    n_done += s.n_samples();
    if (n_done < 2)
      throw InputError("'" + samples + "' has fewer than two samples");
    writer.append(s);
    writer.finish();
    return n_done;
  }
} // namespace squeal::tribology
