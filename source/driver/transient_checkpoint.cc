// SPDX-License-Identifier: LGPL-2.1-or-later

// Checkpoints of a TransientRun.

#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/driver/transient_run.h>
#include <squeal/results/hdf5_file.h>

#include <cstring>
#include <filesystem>

namespace squeal
{
  namespace
  {
    constexpr double format_version = 2.;

    template <typename T>
    constexpr std::size_t n_doubles = sizeof(T) / sizeof(double);

    /** Plain structs of doubles as numbers, and back. */
    template <typename T>
    std::vector<double>
    numbers(const std::vector<T> &list)
    {
      static_assert(sizeof(T) % sizeof(double) == 0, "doubles only");
      std::vector<double> result(list.size() * n_doubles<T>);
      if (!list.empty())
        std::memcpy(result.data(), list.data(), result.size() * sizeof(double));
      return result;
    }

    template <typename T>
    void
    fill(std::vector<T> &list, const std::vector<double> &values)
    {
      list.resize(values.size() / n_doubles<T>);
      if (!list.empty())
        std::memcpy(static_cast<void *>(list.data()),
                    values.data(),
                    values.size() * sizeof(double));
    }

    /** The arrays of a history by name. */
    std::vector<std::pair<std::string, std::vector<double> *>>
    arrays(HistorySamples &h)
    {
      return {{"time", &h.time},
              {"pressure", &h.pressure},
              {"traction", &h.traction},
              {"slip_rate", &h.slip_rate},
              {"gap", &h.gap},
              {"status", &h.status},
              {"resultants", &h.resultants},
              {"probes", &h.probes},
              {"energies", &h.energies}};
    }

    /** The vectors of frames one after the other, all of the same size. */
    std::vector<double>
    joined(const std::vector<MotionFrame> &frames,
           Eigen::VectorXd MotionFrame::*const part)
    {
      std::vector<double> result;
      for (const auto &frame : frames)
        result.insert(result.end(),
                      (frame.*part).data(),
                      (frame.*part).data() + (frame.*part).size());
      return result;
    }

    void
    divide(const std::vector<double> &values,
           std::vector<MotionFrame>  &frames,
           Eigen::VectorXd MotionFrame::*const part)
    {
      const std::size_t n = frames.empty() ? 0 : values.size() / frames.size();
      for (std::size_t k = 0; k < frames.size(); ++k)
        frames[k].*part =
          Eigen::Map<const Eigen::VectorXd>(values.data() + k * n, n);
    }

    std::vector<std::pair<std::string, Eigen::VectorXd MotionFrame::*>>
    frame_parts()
    {
      return {{"coordinates", &MotionFrame::coordinates},
              {"forces", &MotionFrame::forces},
              {"unknowns", &MotionFrame::unknowns}};
    }

    std::vector<double>
    counters_of(const TransientRecord &r)
    {
      return {r.n_steps,
              r.n_iterations,
              r.n_sweeps,
              r.worst_residual,
              r.cpu_seconds,
              r.n_inversions};
    }
  } // namespace



  void
  TransientRun::write_checkpoint(const std::string &path) const
  {
    AtomicFile target(path);
    {
      Hdf5File   file(target.temporary(), Hdf5File::Mode::create);
      const auto write = [&](const std::string         &name,
                             const std::vector<double> &values) {
        if (!values.empty())
          file.write(name, {values.size()}, values);
      };
      file.write_attribute("format", std::string("squeal checkpoint"));
      file.write_attribute("format_version", format_version);
      file.write("key", std::vector<std::string>{key});
      write("memory", motion->memory());
      write("counters", counters_of(kept));
      write("samples", numbers(kept.samples));
      write("amplitudes", numbers(kept.amplitudes));
      write("nodes", numbers(kept.nodes));
      write("last_motion",
            {last_motion.data(), last_motion.data() + last_motion.size()});
      std::vector<double> states, changes;
      for (const ContactStatus s : status)
        states.push_back(static_cast<double>(s));
      for (const StatusChange &c : kept.changes)
        for (const double value : {c.time,
                                   static_cast<double>(c.node),
                                   static_cast<double>(c.status)})
          changes.push_back(value);
      write("status", states);
      write("changes", changes);
      write("linear_since_sample", {linear_since_sample ? 1. : 0.});
      HistorySamples history = kept.history;
      for (const auto &[name, values] : arrays(history))
        write("history/" + name, *values);
      HistorySamples nodes = kept.frame_nodes;
      for (const auto &[name, values] : arrays(nodes))
        write("frames/" + name, *values);
      for (const auto &[name, part] : frame_parts())
        write("frames/" + name, joined(kept.frames, part));
      file.close();
    }
    target.commit();
  }



  bool
  TransientRun::read_checkpoint(const std::string &path)
  {
    if (!std::filesystem::exists(path))
      return false;
    const Hdf5File file(path, Hdf5File::Mode::read);
    if (!file.has_attribute("format") ||
        file.text_attribute("format") != "squeal checkpoint" ||
        file.number_attribute("format_version") != format_version)
      throw InputError("'" + path +
                       "' is no checkpoint that this version can read: remove "
                       "it or set Transient/Resume = false");
    if (file.read_texts("key") != std::vector<std::string>{key})
      return false;
    const auto read = [&](const std::string &name) {
      return file.has(name) ? file.read(name) : std::vector<double>();
    };
    motion->restore(read("memory"));
    const std::vector<double> c = read("counters");
    kept.n_steps                = c.at(0);
    kept.n_iterations           = c.at(1);
    kept.n_sweeps               = c.at(2);
    kept.worst_residual         = c.at(3);
    kept.cpu_seconds            = c.at(4);
    kept.n_inversions           = c.at(5);
    fill(kept.samples, read("samples"));
    fill(kept.amplitudes, read("amplitudes"));
    fill(kept.nodes, read("nodes"));
    const std::vector<double> before = read("last_motion");
    last_motion =
      Eigen::Map<const Eigen::VectorXd>(before.data(), before.size());
    const std::vector<double> states = read("status");
    for (std::size_t j = 0; j < status.size(); ++j)
      status[j] = static_cast<ContactStatus>(static_cast<int>(states.at(j)));
    const std::vector<double> changes = read("changes");
    kept.changes.clear();
    for (std::size_t i = 0; i + 2 < changes.size(); i += 3)
      kept.changes.push_back(
        {changes[i],
         static_cast<std::size_t>(changes[i + 1]),
         static_cast<ContactStatus>(static_cast<int>(changes[i + 2]))});
    linear_since_sample = read("linear_since_sample").at(0) == 1.;
    for (const auto &[name, values] : arrays(kept.history))
      *values = read("history/" + name);
    for (const auto &[name, values] : arrays(kept.frame_nodes))
      *values = read("frames/" + name);
    kept.frames.assign(kept.frame_nodes.n_samples(), MotionFrame());
    for (std::size_t k = 0; k < kept.frames.size(); ++k)
      kept.frames[k].time = kept.frame_nodes.time[k];
    for (const auto &[name, part] : frame_parts())
      divide(read("frames/" + name), kept.frames, part);
    return true;
  }
} // namespace squeal
