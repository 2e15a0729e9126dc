// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/blas_kernels.h>
#include <squeal/base/inputs_read.h>
#include <squeal/base/program_id.h>
#include <squeal/base/version.h>
#include <squeal/parameters/declarations.h>
#include <squeal/parameters/text.h>
#include <squeal/run/fingerprint.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <sstream>

#include <mpi.h>

namespace squeal
{
  namespace
  {
    constexpr std::size_t longest_value = 60;

    /** Values in one line for a person. */
    std::string
    shortened(const std::string &value)
    {
      return value.size() <= longest_value
               ? value
               : value.substr(0, longest_value) + "...";
    }

    bool
    is_left_out(const std::string &path, const Fingerprint::Purpose purpose)
    {
      const std::string generic = prm::generic_path(path);
      return std::any_of(
        left_out().begin(), left_out().end(), [&](const LeftOut &l) {
          const bool is_section = l.entry.back() == '/';
          return (purpose == Fingerprint::Purpose::motion ? l.of_motion
                                                          : l.of_basis) &&
                 (is_section ? prm::starts_with(generic, l.entry)
                             : generic == l.entry);
        });
    }

    bool
    is_file_entry(const prm::Schema &schema, const std::string &path)
    {
      const prm::Schema::Entry *entry = schema.find(prm::generic_path(path));
      return entry && entry->allowed.kind() == prm::Allowed::Kind::file;
    }

    std::map<std::string, std::string>
    by_name(const std::string &text)
    {
      std::map<std::string, std::string> result;
      std::istringstream                 in(text);
      for (std::string line; std::getline(in, line);)
        {
          const std::size_t sign = line.find(" = ");
          if (sign != std::string::npos)
            result[line.substr(0, sign)] = line.substr(sign + 3);
        }
      return result;
    }
  } // namespace



  const std::vector<LeftOut> &
  left_out()
  {
    static const std::string written = "what is written, not what is computed";
    static const std::string others  = "of other analyses";
    static const std::string saved   = "where and when it is saved";
    static const std::string grid =
      "the range of an axis counts, not the values in it";
    static const std::string after =
      "what is computed from the basis when it is there";
    static const std::string axes =
      "each run counts with its own values of the entries";
    static const std::vector<LeftOut> all = {
      {"Output directory", true, true, "the files lie in it"},
      {"Overwrite", true, true, written},
      {"Output/", true, true, written},
      {"Result checks/", true, true, "what is compared, not what is computed"},
      {"Eigenvalues/Damping threshold", true, true, "a line in a chart"},
      {"Work precision/", true, true, others},
      {"Measurement/", true, true, others},
      {"Frequency response/", true, true, others},
      {"Updating/", true, true, others},
      {"Transient/Checkpoint file", true, true, saved},
      {"Transient/Checkpoint interval", true, true, saved},
      {"Transient/Resume", true, true, saved},
      {"Transient/Threads", true, true, "runs at a time, each by itself"},
      {"Transient/Campaign table", true, true, written},
      {"Transient/Tops", true, true, axes},
      {"Transient/Top support", true, true, axes},
      {"Transient/Integrators", true, true, axes},
      {"Transient/", false, true, others},
      {"Sweep/", true, false, axes},
      {"Sweep/Basis file", true, true, saved},
      {"Sweep/Reuse basis", true, true, saved},
      {"Sweep/Edge tolerance", true, true, after},
      {"Sweep/Exceptional points", true, true, after},
      {"Sweep/Boundary tolerance", true, true, after},
      {"Sweep/Direct checks", true, true, after},
      {"Sweep/Compare", true, true, after},
      {"Sweep/Suggestions", true, true, after},
      {"Sweep/Largest change", true, true, after},
      {"Sweep/Scatter samples", true, true, after},
      {"Sweep/Scatter seed", true, true, after},
      {"Sweep/Axis <name>/Scale", true, true, grid},
      {"Sweep/Axis <name>/From", true, true, grid},
      {"Sweep/Axis <name>/To", true, true, grid},
      {"Sweep/Axis <name>/Number", true, true, grid},
      {"Sweep/Axis <name>/Values", true, true, grid},
      {"Sweep/Axis <name>/Distribution", true, true, after},
      {"Sweep/Axis <name>/Mean", true, true, after},
      {"Sweep/Axis <name>/Deviation", true, true, after}};
    return all;
  }



  Fingerprint::Fingerprint(const Parameters &p, const Purpose purpose)
  {
    add("version of squeal", version::program);
    add("revision of squeal", version::revision);
    add("build of squeal", program_id());
    int n_ranks;
    MPI_Comm_size(MPI_COMM_WORLD, &n_ranks);
    add("ranks", std::to_string(n_ranks));
    add("kernels of OpenBLAS", blas_kernels::in_use());
    const prm::GenericSchema           schema;
    std::map<std::string, std::string> files;
    for (const auto &[path, value] : p.used)
      if (is_left_out(path, purpose))
        {
          // files of other analyses may be there or not
          if (is_file_entry(*schema, path) && !value.empty())
            files[value] = "";
        }
      else if (is_file_entry(*schema, path) && !value.empty())
        {
          files[value] = path;
          add(path, content_of_input(value));
        }
      else
        add(path, value);
    for (const auto &[file, content] : inputs_read())
      if (files.count(file) == 0)
        add("file " + std::filesystem::path(file).filename().string(), content);
  }



  void
  Fingerprint::add(const std::string &name, const std::string &value)
  {
    std::string line = value;
    std::replace(line.begin(), line.end(), '\n', ' ');
    lines.emplace_back(name, line);
  }

  std::string
  Fingerprint::text() const
  {
    std::string result;
    for (const auto &[name, value] : lines)
      result += name + " = " + value + "\n";
    return result;
  }



  std::string
  Fingerprint::difference(const std::string &other) const
  {
    if (other == text())
      return "";
    const auto before = by_name(other);
    // the program is the last thing to be blamed: it often differs as well
    std::string program;
    for (const auto &[name, value] : lines)
      {
        const auto  found = before.find(name);
        std::string said;
        if (found == before.end())
          said = name + " is " + shortened(value) + ", it was not there";
        else if (found->second != value)
          said = name + " is " + shortened(value) + ", it was " +
                 shortened(found->second);
        else
          continue;
        const std::string end = " of squeal";
        if (name.size() < end.size() ||
            name.compare(name.size() - end.size(), end.size(), end) != 0)
          return said;
        if (program.empty())
          program = said;
      }
    if (!program.empty())
      return program;
    const auto now = by_name(text());
    for (const auto &[name, value] : before)
      if (now.count(name) == 0)
        return name + " was " + shortened(value) + ", it is not there any more";
    return "its description is another one";
  }

  std::size_t
  Fingerprint::n_differences(const std::string &other) const
  {
    const auto  before = by_name(other), now = by_name(text());
    std::size_t n = 0;
    for (const auto &[name, value] : now)
      {
        const auto found = before.find(name);
        n += found == before.end() || found->second != value;
      }
    for (const auto &[name, value] : before)
      n += now.count(name) == 0;
    return n;
  }
} // namespace squeal
