// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/child_process.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/input_file.h>
#include <squeal/base/sealed_file.h>
#include <squeal/results/contact_history.h>
#include <squeal/results/history_times.h>
#include <squeal/results/table.h>

#include <algorithm>
#include <cmath>
#include <fstream>

namespace squeal
{
  namespace
  {
    [[noreturn]] void
    refuse(const std::string &file, const std::string &what)
    {
      throw InputError("'" + file + "' " + what);
    }



    void
    check_format(const Hdf5File &file)
    {
      if (!file.has_attribute("format") ||
          file.text_attribute("format") != "squeal contact history")
        refuse(file.path(), "is no contact history (attribute 'format')");
      const double version = file.number_attribute("format_version");
      if (version != HistoryWriter::format_version &&
          version != HistoryWriter::version_of_pairs)
        refuse(file.path(),
               "has format version " + shortest_text(version) +
                 "; this program reads " +
                 std::to_string(HistoryWriter::format_version) + " and " +
                 std::to_string(HistoryWriter::version_of_pairs));
      if (!file.has_attribute("complete") ||
          file.number_attribute("complete") != 1.)
        refuse(file.path(),
               "is incomplete: the run that wrote it has not "
               "ended; make it again");
    }



    /**
     * Whether the 512 bytes in front of the HDF5 part of a file are those of a
     * history of squeal (sealed_file.h) with a damaged mark, so that
     * is_sealed_file() does not know it: at least half of the bytes of the mark
     * are there, or one of the words behind it. Blocks of other programs
     * (MATLAB), and empty ones as HDF5 itself makes them, are none.
     */
    bool
    has_damaged_mark(const std::string &path)
    {
      constexpr std::size_t size        = 512;
      constexpr char        signature[] = {'\x89', 'H', 'D', 'F'};
      if (!input_file_fault(path).empty())
        return false;
      std::string   block(size, ' ');
      std::ifstream in(path, std::ios::binary);
      if (!in.read(block.data(), size) ||
          block.compare(0, sizeof(signature), signature, sizeof(signature)) ==
            0)
        return false;
      const std::string mark =
        std::string("squeal ") + HistoryWriter::sealed_kind + "\n";
      std::size_t n_alike = 0;
      for (std::size_t i = 0; i < mark.size(); ++i)
        n_alike += block[i] == mark[i];
      return 2 * n_alike >= mark.size() ||
             block.find(" bytes\n") != std::string::npos ||
             block.find("checksum ") != std::string::npos;
    }



    /** Names of the pairs, of groups and of files; none in version 1. */
    std::vector<std::string>
    pair_names(const Hdf5File &file)
    {
      if (file.number_attribute("format_version") ==
          HistoryWriter::format_version)
        return {};
      const auto names = file.read_texts("pair_names");
      for (auto name = names.begin(); name != names.end(); ++name)
        if (name->empty() || *name == "." || *name == ".." ||
            name->find('/') != std::string::npos)
          refuse(file.path(),
                 "has the contact pair '" + *name +
                   "': the name is that of a group and of files, without '/'");
        else if (std::find(names.begin(), name, *name) != name)
          refuse(file.path(), "has two contact pairs '" + *name + "'");
      return names;
    }

    /** Where the pair asked for is. */
    std::string
    group_of(const Hdf5File &file, const std::string &pair)
    {
      const auto  names = pair_names(file);
      std::string known;
      for (const std::string &name : names)
        known += (known.empty() ? "" : ", ") + name;
      if (names.empty())
        {
          if (!pair.empty())
            refuse(file.path(),
                   "has one contact pair without a name, not '" + pair + "'");
          return "";
        }
      if (std::find(names.begin(), names.end(), pair) == names.end())
        refuse(file.path(),
               pair.empty()
                 ? "has several contact pairs: name one of " + known
                 : "has no contact pair '" + pair + "'; there are " + known);
      return "pairs/" + pair + "/";
    }



    void
    check_states(const std::string         &file,
                 const std::vector<double> &states,
                 const HistorySamples      &s)
    {
      for (std::size_t i = 0; i < states.size(); ++i)
        if (states[i] != 0. && states[i] != 1. && states[i] != 2.)
          refuse(file,
                 "has the status " + shortest_text(states[i]) + " at " +
                   shortest_text(s.time[i / (states.size() / s.n_samples())]) +
                   " s: known are 0 open, 1 stick and 2 slip");
    }



    void
    check_numbers(const std::string         &file,
                  const std::string         &name,
                  const std::vector<double> &values)
    {
      for (const double value : values)
        if (!std::isfinite(value))
          refuse(file, "holds a value that is not a number in '" + name + "'");
    }

    /** Most of the cosine between two axes, and of the length of a mean of unit
     * directions: with the rounding of hand-written numbers. */
    constexpr double largest_cosine = .01, longest_mean = 1.001;

    /** @p axes are three directions, one after the other. */
    void
    check_axes(const std::string &file, const std::vector<double> &axes)
    {
      for (unsigned int i = 0; i < 3; ++i)
        {
          const double *a = &axes[3 * i], *b = &axes[3 * ((i + 1) % 3)];
          const double  lengths =
            std::hypot(a[0], a[1], a[2]) * std::hypot(b[0], b[1], b[2]);
          const double product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
          if (!(std::abs(product) < largest_cosine * lengths))
            refuse(file,
                   "has 'nodes/axes' that are not perpendicular: rows " +
                     std::to_string(i) + " and " + std::to_string((i + 1) % 3));
        }
    }

    /** The pieces of a face of @p n_nodes nodes. */
    std::vector<std::array<unsigned int, 4>>
    quads_of(const Hdf5File    &file,
             const std::string &name,
             const std::size_t  n_nodes)
    {
      const Hdf5File::Dimensions shape = file.dimensions(name);
      if (shape.size() != 2 || shape[1] != 4)
        refuse(file.path(), "has '" + name + "' that are not four nodes each");
      const std::vector<double>                corners = file.read(name);
      std::vector<std::array<unsigned int, 4>> quads(shape[0]);
      for (std::size_t i = 0; i < corners.size(); ++i)
        {
          if (!(corners[i] >= 0. && corners[i] < double(n_nodes)) ||
              corners[i] != std::floor(corners[i]))
            refuse(file.path(),
                   "names a node in '" + name + "' that it does not have");
          quads[i / 4][i % 4] = static_cast<unsigned int>(corners[i]);
        }
      return quads;
    }
  } // namespace



  void
  HistoryReader::read_to_end() const
  {
    constexpr std::uint64_t n_at_once = 1024;
    HistorySamples          values;
    for (std::uint64_t first = 0; first < samples; first += n_at_once)
      read(first, std::min(n_at_once, samples - first), values);
    status_changes();
  }



  const std::string &
  HistoryReader::accepted(const std::string &path)
  {
    if (is_sealed_file(path, HistoryWriter::sealed_kind))
      {
        if (!is_whole_file(path, HistoryWriter::sealed_kind))
          refuse(path,
                 "is damaged: its checksum is another one; make it again");
      }
    else if (has_damaged_mark(path))
      refuse(path,
             "is damaged: the mark of squeal in its first 512 bytes is another "
             "one; make it again");
    else if (input_file_fault(path).empty() && ends_by_signal([&]() {
               const auto names =
                 pair_names(Hdf5File(path, Hdf5File::Mode::read));
               for (const std::string &name :
                    names.empty() ? std::vector<std::string>{""} : names)
                 HistoryReader(path, name, Accepted()).read_to_end();
             }))
      refuse(path, "is damaged: the HDF5 library crashes when it reads it");
    return path;
  }



  HistoryReader::HistoryReader(const std::string &path, const std::string &pair)
    : HistoryReader(accepted(path), pair, Accepted())
  {
  }



  std::vector<std::string>
  HistoryReader::pairs_of(const std::string &path)
  {
    const Hdf5File file(accepted(path), Hdf5File::Mode::read);
    check_format(file);
    return pair_names(file);
  }



  HistoryReader::HistoryReader(const std::string &path,
                               const std::string &pair,
                               Accepted)
    : file(path, Hdf5File::Mode::read)
  {
    check_format(file);
    group     = group_of(file, pair);
    what.pair = pair;
    read_layout();
    check_times(file, pair_names(file));
  }



  void
  HistoryReader::read_layout()
  {
    what.name = file.has_attribute("name") ? file.text_attribute("name") : "";
    const std::vector<double> points = file.read(group + "nodes/coordinates");
    what.areas                       = file.read(group + "nodes/area");
    const std::uint64_t n            = what.areas.size();
    if (n == 0)
      refuse(file.path(), "has no contact nodes");
    if (file.dimensions(group + "nodes/coordinates") !=
        Hdf5File::Dimensions({n, 3}))
      refuse(file.path(), "has another number of coordinates than of areas");
    check_numbers(file.path(), "nodes/coordinates", points);
    if (file.has(group + "nodes/axes"))
      {
        const std::vector<double> axes = file.read(group + "nodes/axes");
        if (axes.size() != 9)
          refuse(file.path(), "has 'nodes/axes' that are not three directions");
        check_numbers(file.path(), "nodes/axes", axes);
        check_axes(file.path(), axes);
        for (unsigned int i = 0; i < 9; ++i)
          what.axes[i / 3][i % 3] = axes[i];
      }
    if (file.has(group + "nodes/sliding"))
      {
        const std::vector<double> sliding = file.read(group + "nodes/sliding");
        if (sliding.size() != 2)
          refuse(file.path(), "has 'nodes/sliding' that are not two numbers");
        check_numbers(file.path(), "nodes/sliding", sliding);
        const double length = std::hypot(sliding[0], sliding[1]);
        if (length > longest_mean)
          refuse(file.path(),
                 "has 'nodes/sliding' of length " + shortest_text(length) +
                   ": it is the mean of unit directions, no speed, and at "
                   "most 1 long");
        what.sliding = {{sliding[0], sliding[1]}};
      }
    for (std::uint64_t i = 0; i < n; ++i)
      {
        if (!(what.areas[i] > 0.) || !std::isfinite(what.areas[i]))
          refuse(file.path(),
                 "has a node with an area that is not positive: node " +
                   std::to_string(i));
        what.points.push_back(
          {{points[3 * i], points[3 * i + 1], points[3 * i + 2]}});
      }

    if (file.has(group + "nodes/quads"))
      what.quads = quads_of(file, group + "nodes/quads", n);

    const Hdf5File::Dimensions times = file.dimensions(group + "samples/time");
    samples                          = times.empty() ? 0 : times[0];
    if (samples < 2)
      refuse(file.path(), "has fewer than two samples");
    check_shape("samples/time", {});
    check_shape("samples/pressure", {n});
    check_shape("samples/traction", {n, 2});
    what.has_slip_rate  = file.has(group + "samples/slip_rate");
    what.has_gap        = file.has(group + "samples/gap");
    what.has_status     = file.has(group + "samples/status");
    what.has_resultants = file.has(group + "samples/resultants");
    if (what.has_slip_rate)
      check_shape("samples/slip_rate", {n, 2});
    if (what.has_gap)
      check_shape("samples/gap", {n});
    if (what.has_status)
      check_shape("samples/status", {n});
    if (what.has_resultants)
      check_shape("samples/resultants", {3});
    if (file.has(group + "probes/values"))
      {
        what.probe_names = file.read_texts(group + "probes/names");
        check_shape("probes/values", {what.probe_names.size()});
      }
    if (file.has("energies/values"))
      {
        what.energy_names             = file.read_texts("energies/names");
        Hdf5File::Dimensions expected = {samples, what.energy_names.size()};
        if (file.dimensions("energies/values") != expected)
          refuse(file.path(),
                 "has a dataset 'energies/values' that does not fit its "
                 "samples");
      }
  }



  void
  HistoryReader::check_shape(const std::string          &name,
                             const Hdf5File::Dimensions &row) const
  {
    Hdf5File::Dimensions expected = row;
    expected.insert(expected.begin(), samples);
    if (file.dimensions(group + name) != expected)
      refuse(file.path(),
             "has a dataset '" + name +
               "' that does not fit its nodes and samples");
  }



  const HistoryLayout &
  HistoryReader::layout() const
  {
    return what;
  }



  std::uint64_t
  HistoryReader::n_samples() const
  {
    return samples;
  }



  const std::string &
  HistoryReader::path() const
  {
    return file.path();
  }



  std::array<double, 2>
  HistoryReader::time_range() const
  {
    std::vector<double> first, last;
    file.read_rows(group + "samples/time", 0, 1, first);
    file.read_rows(group + "samples/time", samples - 1, 1, last);
    return {{first[0], last[0]}};
  }



  std::uint64_t
  HistoryReader::sample_at(const double time) const
  {
    std::uint64_t       lower = 0, upper = samples;
    std::vector<double> value;
    while (lower < upper)
      {
        const std::uint64_t middle = (lower + upper) / 2;
        file.read_rows(group + "samples/time", middle, 1, value);
        if (value[0] < time)
          lower = middle + 1;
        else
          upper = middle;
      }
    return lower;
  }



  void
  HistoryReader::read(const std::uint64_t first,
                      const std::uint64_t n,
                      HistorySamples     &s) const
  {
    s.clear();
    const auto get_at = [&](const std::string   &name,
                            const bool           is_there,
                            std::vector<double> &values) {
      if (!is_there)
        return;
      file.read_rows(name, first, n, values);
      check_numbers(file.path(), name, values);
    };
    const auto get = [&](const std::string   &name,
                         const bool           is_there,
                         std::vector<double> &values) {
      get_at(group + name, is_there, values);
    };
    get("samples/time", true, s.time);
    get("samples/pressure", true, s.pressure);
    get("samples/traction", true, s.traction);
    get("samples/slip_rate", what.has_slip_rate, s.slip_rate);
    get("samples/gap", what.has_gap, s.gap);
    get("samples/status", what.has_status, s.status);
    check_states(file.path(), s.status, s);
    get("samples/resultants", what.has_resultants, s.resultants);
    get("probes/values", !what.probe_names.empty(), s.probes);
    get_at("energies/values", !what.energy_names.empty(), s.energies);
  }



  std::vector<StatusChange>
  HistoryReader::status_changes() const
  {
    const std::string of_pair = group + "status_changes/";
    if (!file.has(of_pair + "time"))
      return {};
    const std::vector<double> times  = file.read(of_pair + "time");
    const std::vector<double> nodes  = file.read(of_pair + "node");
    const std::vector<double> states = file.read(of_pair + "status");
    if (nodes.size() != times.size() || states.size() != times.size())
      refuse(file.path(), "has status changes of different numbers");
    check_numbers(file.path(), of_pair + "time", times);
    std::vector<StatusChange> changes(times.size());
    for (std::size_t i = 0; i < times.size(); ++i)
      {
        if (!(nodes[i] >= 0. && nodes[i] < what.n_nodes()) ||
            nodes[i] != std::floor(nodes[i]) ||
            (states[i] != 0. && states[i] != 1. && states[i] != 2.))
          refuse(file.path(),
                 "has a status change of an unknown node or state");
        changes[i] = {times[i],
                      static_cast<std::size_t>(nodes[i]),
                      static_cast<ContactStatus>(states[i])};
      }
    return changes;
  }
} // namespace squeal
