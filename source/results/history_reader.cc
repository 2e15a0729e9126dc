// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/child_process.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/input_file.h>
#include <squeal/base/sealed_file.h>
#include <squeal/results/contact_history.h>
#include <squeal/results/table.h>

#include <algorithm>
#include <cmath>

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
      if (version != HistoryWriter::format_version)
        refuse(file.path(),
               "has format version " + shortest_text(version) +
                 "; this program reads " +
                 std::to_string(HistoryWriter::format_version));
      if (!file.has_attribute("complete") ||
          file.number_attribute("complete") != 1.)
        refuse(file.path(),
               "is incomplete: the run that wrote it has not "
               "ended; make it again");
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
    else if (input_file_fault(path).empty() && ends_by_signal([&]() {
               HistoryReader(path, Accepted()).read_to_end();
             }))
      refuse(path, "is damaged: the HDF5 library crashes when it reads it");
    return path;
  }



  HistoryReader::HistoryReader(const std::string &path)
    : HistoryReader(accepted(path), Accepted())
  {
  }



  HistoryReader::HistoryReader(const std::string &path, Accepted)
    : file(path, Hdf5File::Mode::read)
  {
    check_format(file);
    what.name = file.has_attribute("name") ? file.text_attribute("name") : "";
    const std::vector<double> points = file.read("nodes/coordinates");
    what.areas                       = file.read("nodes/area");
    const std::uint64_t n            = what.areas.size();
    if (n == 0)
      refuse(path, "has no contact nodes");
    if (file.dimensions("nodes/coordinates") != Hdf5File::Dimensions({n, 3}))
      refuse(path, "has another number of coordinates than of areas");
    check_numbers(path, "nodes/coordinates", points);
    for (std::uint64_t i = 0; i < n; ++i)
      {
        if (!(what.areas[i] > 0.) || !std::isfinite(what.areas[i]))
          refuse(path,
                 "has a node with an area that is not positive: node " +
                   std::to_string(i));
        what.points.push_back(
          {{points[3 * i], points[3 * i + 1], points[3 * i + 2]}});
      }

    const Hdf5File::Dimensions times = file.dimensions("samples/time");
    samples                          = times.empty() ? 0 : times[0];
    if (samples < 2)
      refuse(path, "has fewer than two samples");
    check_shape("samples/time", {});
    check_shape("samples/pressure", {n});
    check_shape("samples/traction", {n, 2});
    what.has_slip_rate  = file.has("samples/slip_rate");
    what.has_gap        = file.has("samples/gap");
    what.has_status     = file.has("samples/status");
    what.has_resultants = file.has("samples/resultants");
    if (what.has_slip_rate)
      check_shape("samples/slip_rate", {n, 2});
    if (what.has_gap)
      check_shape("samples/gap", {n});
    if (what.has_status)
      check_shape("samples/status", {n});
    if (what.has_resultants)
      check_shape("samples/resultants", {3});
    if (file.has("probes/values"))
      {
        what.probe_names = file.read_texts("probes/names");
        check_shape("probes/values", {what.probe_names.size()});
      }
    if (file.has("energies/values"))
      {
        what.energy_names = file.read_texts("energies/names");
        check_shape("energies/values", {what.energy_names.size()});
      }
  }



  void
  HistoryReader::check_shape(const std::string          &name,
                             const Hdf5File::Dimensions &row) const
  {
    Hdf5File::Dimensions expected = row;
    expected.insert(expected.begin(), samples);
    if (file.dimensions(name) != expected)
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
    file.read_rows("samples/time", 0, 1, first);
    file.read_rows("samples/time", samples - 1, 1, last);
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
        file.read_rows("samples/time", middle, 1, value);
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
    const auto get = [&](const std::string   &name,
                         const bool           is_there,
                         std::vector<double> &values) {
      if (!is_there)
        return;
      file.read_rows(name, first, n, values);
      check_numbers(file.path(), name, values);
    };
    get("samples/time", true, s.time);
    for (std::size_t i = 1; i < s.time.size(); ++i)
      if (!(s.time[i] > s.time[i - 1]))
        refuse(file.path(),
               "has times that do not increase, at " +
                 shortest_text(s.time[i]) + " s");
    get("samples/pressure", true, s.pressure);
    get("samples/traction", true, s.traction);
    get("samples/slip_rate", what.has_slip_rate, s.slip_rate);
    get("samples/gap", what.has_gap, s.gap);
    get("samples/status", what.has_status, s.status);
    check_states(file.path(), s.status, s);
    get("samples/resultants", what.has_resultants, s.resultants);
    get("probes/values", !what.probe_names.empty(), s.probes);
    get("energies/values", !what.energy_names.empty(), s.energies);
  }



  std::vector<StatusChange>
  HistoryReader::status_changes() const
  {
    if (!file.has("status_changes/time"))
      return {};
    const std::vector<double> times  = file.read("status_changes/time");
    const std::vector<double> nodes  = file.read("status_changes/node");
    const std::vector<double> states = file.read("status_changes/status");
    if (nodes.size() != times.size() || states.size() != times.size())
      refuse(file.path(), "has status changes of different numbers");
    std::vector<StatusChange> changes(times.size());
    for (std::size_t i = 0; i < times.size(); ++i)
      {
        if (!(nodes[i] >= 0. && nodes[i] < what.n_nodes()) ||
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
