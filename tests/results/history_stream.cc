// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact histories that go to files as they come: memory does not grow with
// their samples, a stop at any time and a restart give the same bytes, and
// files that are not those of the checkpoint are refused by name.

#include "check.h"

#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/timers.h>
#include <squeal/results/history_stream.h>

#include <hdf5.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  namespace fs = std::filesystem;

  constexpr std::size_t n_probes = 3, n_energies = 7;

  /** Sample @p k of a pair: any numbers that all differ. */
  HistorySamples
  sample(const std::size_t k, const std::size_t pair, const std::size_t n_nodes)
  {
    HistorySamples s;
    s.time          = {1e-5 * k};
    const auto fill = [&](std::vector<double> &values, const std::size_t n) {
      for (std::size_t j = 0; j < n; ++j)
        values.push_back(
          std::sin(1. + k + 10. * pair + .1 * j + values.size()));
    };
    fill(s.pressure, n_nodes);
    fill(s.traction, 2 * n_nodes);
    fill(s.slip_rate, 2 * n_nodes);
    fill(s.gap, n_nodes);
    for (std::size_t j = 0; j < n_nodes; ++j)
      s.status.push_back((j + k) % 3);
    fill(s.resultants, 3);
    fill(s.probes, n_probes);
    s.energies.assign(n_energies, 1. + k);
    return s;
  }

  std::vector<HistorySamples>
  samples(const std::size_t k, const std::vector<std::size_t> &n_nodes)
  {
    std::vector<HistorySamples> result;
    for (std::size_t i = 0; i < n_nodes.size(); ++i)
      result.push_back(sample(k, i, n_nodes[i]));
    return result;
  }

  std::vector<HistoryLayout>
  layouts(const std::vector<std::size_t> &n_nodes)
  {
    std::vector<HistoryLayout> result;
    for (const std::size_t n : n_nodes)
      {
        HistoryLayout layout;
        layout.name = "made";
        layout.pair = "pair" + std::to_string(result.size());
        for (std::size_t j = 0; j < n; ++j)
          layout.points.push_back({{1e-3 * j, 0., 0.}});
        layout.areas.assign(n, 1e-6);
        layout.probe_names  = {"ax", "ay", "az"};
        layout.energy_names = {"a", "b", "c", "d", "e", "f", "g"};
        result.push_back(layout);
      }
    return result;
  }

  void
  write(const HistoryStream            &stream,
        const std::vector<std::size_t> &n_nodes,
        const std::string              &path)
  {
    HistoryWriter writer(path, layouts(n_nodes));
    stream.write(writer);
    writer.finish();
  }

  /** Samples and changes from @p first to before @p end. */
  void
  run(HistoryStream                  &stream,
      const std::vector<std::size_t> &n_nodes,
      const std::size_t               first,
      const std::size_t               end)
  {
    const std::size_t n_all =
      std::accumulate(n_nodes.begin(), n_nodes.end(), std::size_t(0));
    for (std::size_t k = first; k < end; ++k)
      {
        stream.append(StatusChange{1e-5 * k, k % n_all, ContactStatus::slip});
        stream.append(samples(k, n_nodes));
      }
  }

  const std::vector<std::size_t> two_pairs = {5, 3};

  HistoryStream
  stream_of(const std::string &path, const std::vector<std::size_t> &n_nodes)
  {
    return {path, n_nodes, n_probes, n_energies};
  }



  void
  what_is_read()
  {
    HistoryStream stream = stream_of("read.h5", two_pairs);
    stream.start();
    run(stream, two_pairs, 0, 700);
    write(stream, two_pairs, "read_history.h5");
    for (const std::size_t i : {0u, 1u})
      {
        const HistoryReader reader("read_history.h5",
                                   "pair" + std::to_string(i));
        HistorySamples      s;
        reader.read(699, 1, s);
        const HistorySamples expected = sample(699, i, two_pairs[i]),
                             again    = stream.read(i, 699, 1);
        check(reader.n_samples() == 700, "all samples are in the history");
        check(again.pressure == expected.pressure &&
                again.traction == expected.traction &&
                again.slip_rate == expected.slip_rate &&
                again.gap == expected.gap && again.status == expected.status &&
                again.resultants == expected.resultants &&
                again.probes == expected.probes &&
                again.energies == expected.energies,
              "and are read from the stream");
        check(s.resultants == expected.resultants &&
                s.status == expected.status && s.probes == expected.probes,
              "and from the history");
        for (const StatusChange &change : reader.status_changes())
          check(change.node < two_pairs[i], "nodes count within their pair");
        check(reader.status_changes().size() ==
                (i == 0 ? 5 * 87 + 4 : 700 - 5 * 87 - 4),
              "each pair has the changes of its nodes");
      }
    check(stream.sample_at(0.) == 0 && stream.sample_at(3.5e-5) == 4 &&
            stream.sample_at(1.) == 700,
          "samples are found by their times");
    stream.remove();
    check(!fs::exists("read_samples.bin") && !fs::exists("read_changes.bin"),
          "nothing is left");
  }



  /** After some samples were secured 300 more are written, and lost. */
  void
  stop_and_go_on()
  {
    HistoryStream whole = stream_of("whole.h5", two_pairs);
    whole.start();
    run(whole, two_pairs, 0, 1000);
    write(whole, two_pairs, "whole_history.h5");
    for (const std::size_t kept : {0u, 1u, 256u, 999u})
      {
        NamedNumbers memory;
        {
          HistoryStream stopped = stream_of("stopped.h5", two_pairs);
          stopped.start();
          run(stopped, two_pairs, 0, kept);
          memory = stopped.memory();
          run(stopped, two_pairs, kept, kept + 300);
          // What a kill leaves: some of it is on the disk.
          stopped.read(0, 0, kept > 0 ? 1 : 0);
        }
        HistoryStream stream = stream_of("stopped.h5", two_pairs);
        stream.restore(memory);
        check(stream.n_samples() == kept, "goes on where it was secured");
        run(stream, two_pairs, kept, 1000);
        write(stream, two_pairs, "stopped_history.h5");
        check(read_file("stopped_history.h5") == read_file("whole_history.h5"),
              "the history has the same bytes after " + std::to_string(kept));
      }
  }



  void
  refused(const NamedNumbers &memory,
          const std::string  &text,
          const std::string  &claim)
  {
    HistoryStream stream = stream_of("other.h5", two_pairs);
    try
      {
        stream.restore(memory);
      }
    catch (const InputError &e)
      {
        const std::string what = e.what();
        check(what.find("other_samples.bin") != std::string::npos &&
                what.find(text) != std::string::npos &&
                what.find('\n') == std::string::npos,
              claim + ": " + what);
        return;
      }
    check(false, claim);
  }

  void
  other_files()
  {
    NamedNumbers memory;
    {
      HistoryStream stream = stream_of("other.h5", two_pairs);
      stream.start();
      run(stream, two_pairs, 0, 50);
      memory = stream.memory();
    }
    const std::string bytes = read_file("other_samples.bin");
    const auto        put   = [](const std::string &text) {
      std::ofstream("other_samples.bin", std::ios::binary) << text;
    };
    for (const std::size_t i : {std::size_t(512), bytes.size() - 1})
      {
        std::string wrong = bytes;
        wrong[i]          = static_cast<char>(wrong[i] ^ 1);
        put(wrong);
        refused(memory, "other rows", "a changed bit is refused");
      }
    put(bytes.substr(0, bytes.size() - 1));
    refused(memory, "fewer rows", "a file that is cut is refused");
    put("mine" + bytes.substr(4));
    refused(memory, "not what its name says", "a file of others is refused");
    fs::remove("other_samples.bin");
    refused(memory, "No such file", "a file that is missing is refused");
  }



  /** What the reader says of a file @p path; "" where it takes it. */
  std::string
  refusal(const std::string &path)
  {
    try
      {
        HistoryReader(path, "").status_changes();
      }
    catch (const InputError &e)
      {
        return e.what();
      }
    return "";
  }

  /** Bits of the mark by which squeal knows its files, the whole block, and
   * blocks that are not squeal's. */
  void
  damaged_marks()
  {
    HistoryStream stream = stream_of("mark.h5", {5});
    stream.start();
    run(stream, {5}, 0, 50);
    write(stream, {5}, "mark_history.h5");
    const std::string bytes = read_file("mark_history.h5");
    const auto        of    = [](const std::string &text) {
      std::ofstream("mark_changed.h5", std::ios::binary) << text;
      return refusal("mark_changed.h5");
    };
    check(of(bytes).empty(), "a whole file is read");
    for (std::size_t i = 0; i < 80; ++i)
      {
        std::string wrong = bytes;
        wrong[i]          = static_cast<char>(wrong[i] ^ 1);
        check(of(wrong).find("is damaged") != std::string::npos,
              "a bit of byte " + std::to_string(i) + " is refused");
      }
    check(of(std::string(512, '\0') + bytes.substr(512)).empty(),
          "an empty block, as HDF5 itself makes it, is none");
    std::string other = "MATLAB 7.3 MAT-file, Platform: GLNXA64";
    other.resize(512, ' ');
    check(of(other + bytes.substr(512)).empty(), "a block of others is none");
    check(of(bytes.substr(512)).empty(), "nor is a file without a block");
    fs::remove("mark_changed.h5");
  }

  /** Changes of status, directions and axes that cannot be. */
  void
  values_that_cannot_be()
  {
    HistoryStream stream = stream_of("cannot.h5", {5});
    stream.start();
    run(stream, {5}, 0, 50);
    write(stream, {5}, "cannot_history.h5");
    const std::string bytes = read_file("cannot_history.h5").substr(512);
    const auto        with  = [&](const std::string         &name,
                          const std::vector<double> &values,
                          const bool                 is_refused) {
      std::ofstream("cannot_changed.h5", std::ios::binary) << bytes;
      {
        const hid_t file =
          H5Fopen("cannot_changed.h5", H5F_ACC_RDWR, H5P_DEFAULT);
        const hsize_t size  = values.size();
        const hid_t   space = H5Screate_simple(1, &size, nullptr);
        if (H5Lexists(file, name.c_str(), H5P_DEFAULT) > 0)
          H5Ldelete(file, name.c_str(), H5P_DEFAULT);
        const hid_t data = H5Dcreate2(file,
                                      name.c_str(),
                                      H5T_NATIVE_DOUBLE,
                                      space,
                                      H5P_DEFAULT,
                                      H5P_DEFAULT,
                                      H5P_DEFAULT);
        H5Dwrite(data,
                 H5T_NATIVE_DOUBLE,
                 H5S_ALL,
                 H5S_ALL,
                 H5P_DEFAULT,
                 values.data());
        H5Dclose(data);
        H5Sclose(space);
        H5Fclose(file);
      }
      const std::string said = refusal("cannot_changed.h5");
      check(said.empty() != is_refused, name + ": " + said);
      return said;
    };
    const std::size_t n =
      HistoryReader("cannot_history.h5", "").status_changes().size();
    std::vector<double> times(n, 1e-5), nodes(n, 1.);
    with("status_changes/time", times, false);
    with("status_changes/node", nodes, false);
    times[0] = NAN;
    nodes[0] = .7;
    with("status_changes/time", times, true);
    with("status_changes/node", nodes, true);
    with("nodes/sliding", {.6, .8}, false);
    with("nodes/sliding", {3., 4.}, true);
    with("nodes/axes", {0., 1., 0., -1., 0., 0., 0., 0., 1.}, false);
    with("nodes/axes", {1., 0., 0., 1., 0., 0., 0., 0., 1.}, true);
    fs::remove("cannot_changed.h5");
  }



  /** A hundred and twenty nodes, as many as a pad of the thesis has. */
  void
  memory_does_not_grow()
  {
    const std::vector<std::size_t> n_nodes = {120};
    const double                   row = 8. * (1. + 7. * 120. + 6. + 7.) / 1e6;
    HistoryStream                  stream = stream_of("long.h5", n_nodes);
    stream.start();
    const auto many = [&](const std::size_t first, const std::size_t end) {
      const auto some = samples(first, n_nodes);
      for (std::size_t k = first; k < end; ++k)
        {
          auto next    = some;
          next[0].time = {1e-5 * k};
          stream.append(next);
          stream.append(StatusChange{1e-5 * k, k % 120, ContactStatus::slip});
        }
    };
    many(0, 1000);
    write(stream, n_nodes, "short_history.h5");
    const double before = peak_memory_mb();
    many(1000, 30000);
    write(stream, n_nodes, "long_history.h5");
    const double grown = peak_memory_mb() - before, written = 29000. * row;
    std::printf(
      "%.1f MB more in memory for %.1f MB of samples\n", grown, written);
    check(before > 0. && written > 100. && grown < .05 * written,
          "thirty times the samples take no more memory");
    const std::size_t n = stream.memory().bytes().size();
    check(n < 1000, "and a checkpoint no more bytes: " + std::to_string(n));
    stream.remove();
    fs::remove("long_history.h5");
  }
} // namespace



int
main()
{
  what_is_read();
  stop_and_go_on();
  other_files();
  damaged_marks();
  values_that_cannot_be();
  memory_does_not_grow();
}
