// SPDX-License-Identifier: LGPL-2.1-or-later

// Contact histories: what is written is read, and faults are refused in one
// line.
#include <squeal/base/child_process.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/tribology/damage/history_damage.h>
#include <squeal/tribology/history/clipped_sine.h>
#include <squeal/tribology/history/csv_import.h>

#include <hdf5.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <random>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
using namespace squeal::tribology;
namespace fs = std::filesystem;

namespace
{
  void
  write_text(const std::string &file, const std::string &text)
  {
    std::ofstream(file) << text;
  }

  HistoryLayout
  two_nodes()
  {
    HistoryLayout layout;
    layout.name         = "two nodes";
    layout.points       = {{{0., 0., 0.}}, {{1e-3, 0., 0.}}};
    layout.areas        = {1e-6, 2e-6};
    layout.quads        = {{{0, 1, 1, 0}}};
    layout.probe_names  = {"top_m"};
    layout.energy_names = {"kinetic_j", "elastic_j"};
    return layout;
  }

  HistorySamples
  some_samples(const double start, const std::size_t n)
  {
    HistorySamples s;
    for (std::size_t i = 0; i < n; ++i)
      {
        const double t = start + i;
        s.time.push_back(t);
        s.pressure.insert(s.pressure.end(), {t, 2. * t});
        s.traction.insert(s.traction.end(), {0., t, .5, -t});
        s.slip_rate.insert(s.slip_rate.end(), {0., 1., 2., 3.});
        s.gap.insert(s.gap.end(), {0., .25});
        s.status.insert(s.status.end(), {2., 0.});
        s.resultants.insert(s.resultants.end(), {t, 0., -t});
        s.probes.push_back(1e-9 * t);
        s.energies.insert(s.energies.end(), {t, 1. / (1. + t)});
      }
    return s;
  }

  void
  write_good(const std::string &path)
  {
    fs::remove(path);
    HistoryWriter writer(path, two_nodes());
    writer.append(some_samples(0., 700));
    writer.append(std::vector<StatusChange>{{.5, 1, ContactStatus::stick}});
    writer.append(some_samples(700., 300));
    check(!fs::exists(path), "the file has no name before it is complete");
    writer.finish();
  }

  /** Version 2: a group a pair, energies once. */
  void
  several_pairs()
  {
    HistoryLayout upper = two_nodes(), lower = two_nodes();
    upper.pair  = "upper";
    lower.pair  = "lower";
    lower.axes  = {{{{1., 0., 0.}}, {{0., -1., 0.}}, {{0., 0., -1.}}}};
    lower.areas = {3e-6, 4e-6};
    fs::remove("pairs.h5");
    {
      HistoryWriter writer("pairs.h5", {upper, lower});
      writer.append(some_samples(0., 5), 0);
      writer.append(some_samples(0., 5), 1);
      writer.append(std::vector<StatusChange>{{.5, 1, ContactStatus::stick}},
                    1);
      writer.finish();
    }
    check(HistoryReader::pairs_of("pairs.h5") ==
            std::vector<std::string>{"upper", "lower"},
          "the names of the pairs, in order");
    for (const HistoryLayout &expected : {upper, lower})
      {
        const HistoryReader reader("pairs.h5", expected.pair);
        check(reader.layout().pair == expected.pair &&
                reader.layout().areas == expected.areas &&
                reader.layout().axes == expected.axes &&
                reader.layout().energy_names == expected.energy_names,
              "the layout of " + expected.pair);
        HistorySamples s;
        reader.read(1, 4, s);
        check(s.pressure == some_samples(1., 4).pressure &&
                s.energies == some_samples(1., 4).energies,
              "the samples of " + expected.pair);
        check(reader.status_changes().size() ==
                (expected.pair == "lower" ? 1u : 0u),
              "the changes of " + expected.pair);
      }
    check_throws<InputError>([] { HistoryReader reader("pairs.h5"); },
                             "several contact pairs: name one of upper, lower",
                             "without a name");
    check_throws<InputError>([] { HistoryReader reader("pairs.h5", "middle"); },
                             "no contact pair 'middle'; there are upper, lower",
                             "another name");
    write_good("good.h5");
    check(HistoryReader::pairs_of("good.h5").empty(),
          "version 1 has a pair without a name");
    check_throws<InputError>([] { HistoryReader reader("good.h5", "upper"); },
                             "one contact pair without a name",
                             "a name where there is none");
  }

  void
  round_trip()
  {
    write_good("good.h5");
    const HistoryReader reader("good.h5");
    check(reader.n_samples() == 1000 && reader.layout().n_nodes() == 2 &&
            reader.layout().name == "two nodes" &&
            reader.layout().areas == two_nodes().areas &&
            reader.layout().points == two_nodes().points &&
            reader.layout().quads == two_nodes().quads &&
            reader.layout().probe_names == two_nodes().probe_names &&
            reader.layout().energy_names == two_nodes().energy_names,
          "the layout comes back");
    HistorySamples       s;
    const HistorySamples expected = some_samples(699., 3);
    reader.read(699, 3, s);
    check(s.time == expected.time && s.pressure == expected.pressure &&
            s.traction == expected.traction &&
            s.slip_rate == expected.slip_rate && s.gap == expected.gap &&
            s.status == expected.status &&
            s.resultants == expected.resultants &&
            s.probes == expected.probes && s.energies == expected.energies,
          "samples across two pieces come back");
    const std::vector<StatusChange> changes = reader.status_changes();
    check(changes.size() == 1 && changes[0].time == .5 &&
            changes[0].node == 1 && changes[0].status == ContactStatus::stick,
          "changes of status come back");
    check(reader.sample_at(-1.) == 0 && reader.sample_at(500.) == 500 &&
            reader.sample_at(500.5) == 501 && reader.sample_at(1e9) == 1000,
          "a sample is found by its time");
  }

  /** "bad.h5": the good file without the mark of squeal, as from elsewhere; its
   * checksum does not count then. */
  void
  copy_without_mark()
  {
    fs::copy_file("good.h5", "bad.h5", fs::copy_options::overwrite_existing);
    std::fstream      file("bad.h5",
                      std::ios::in | std::ios::out | std::ios::binary);
    const std::string nothing(512, '\0');
    file.write(nothing.data(), nothing.size());
    check(file.good(), "the test takes the mark away");
  }

  /** A copy of the good file, changed by @p change, is refused. */
  template <typename Change>
  void
  refuses(const Change      &change,
          const std::string &part,
          const std::string &claim)
  {
    copy_without_mark();
    change();
    const auto read = [] {
      const HistoryReader reader("bad.h5");
      HistorySamples      s;
      reader.read(0, reader.n_samples(), s);
    };
    check_throws<InputError>(read, part, claim);
    try
      {
        read();
      }
    catch (const InputError &e)
      {
        check(std::string(e.what()).find("bad.h5") != std::string::npos &&
                std::string(e.what()).find('\n') == std::string::npos,
              claim + ": one line that names the file");
      }
  }

  /** Changes one number of a dataset. */
  void
  poke(const char *dataset, const hsize_t place, const double value)
  {
    const hid_t   file      = H5Fopen("bad.h5", H5F_ACC_RDWR, H5P_DEFAULT);
    const hid_t   data      = H5Dopen2(file, dataset, H5P_DEFAULT);
    const hid_t   space     = H5Dget_space(data);
    hsize_t       extent[3] = {1, 1, 1};
    const int     n         = H5Sget_simple_extent_dims(space, extent, nullptr);
    hsize_t       point[3]  = {place, 0, 0};
    const hsize_t one       = 1;
    H5Sselect_elements(space, H5S_SELECT_SET, 1, point);
    const hid_t memory = H5Screate_simple(1, &one, nullptr);
    check(n > 0 &&
            H5Dwrite(
              data, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, &value) >= 0,
          std::string("the test changes ") + dataset);
    H5Sclose(memory);
    H5Sclose(space);
    H5Dclose(data);
    H5Fclose(file);
  }

  void
  remove_link(const char *name, const bool is_attribute)
  {
    const hid_t file = H5Fopen("bad.h5", H5F_ACC_RDWR, H5P_DEFAULT);
    check((is_attribute ? H5Adelete(file, name)
                        : H5Ldelete(file, name, H5P_DEFAULT)) >= 0,
          std::string("the test removes ") + name);
    H5Fclose(file);
  }

  /** Puts a dataset of @p n rows in the place of another; none is stored. */
  void
  claim_rows(const char *dataset, const hsize_t n)
  {
    const hid_t   file  = H5Fopen("bad.h5", H5F_ACC_RDWR, H5P_DEFAULT);
    const hsize_t chunk = 64;
    const hid_t   space = H5Screate_simple(1, &n, nullptr);
    const hid_t   how   = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(how, 1, &chunk);
    H5Ldelete(file, dataset, H5P_DEFAULT);
    const hid_t data = H5Dcreate2(
      file, dataset, H5T_IEEE_F64LE, space, H5P_DEFAULT, how, H5P_DEFAULT);
    check(data >= 0, std::string("the test writes ") + dataset);
    H5Dclose(data);
    H5Pclose(how);
    H5Sclose(space);
    H5Fclose(file);
  }

  void
  faults_of_files()
  {
    check_throws<InputError>([] { HistoryReader reader("nowhere.h5"); },
                             "does not exist",
                             "a missing file");
    check_throws<InputError>(
      [] { HistoryReader reader("."); }, "is no file", "a directory");
    refuses([] { write_text("bad.h5", ""); }, "no HDF5", "an empty file");
    refuses([] { write_text("bad.h5", std::string(5000, '\x81')); },
            "no HDF5",
            "garbage");
    refuses([] { fs::resize_file("bad.h5", fs::file_size("bad.h5") / 2); },
            "truncated",
            "a truncated file");
    refuses(
      [] {
        remove_link("format_version", true);
        const hid_t  file    = H5Fopen("bad.h5", H5F_ACC_RDWR, H5P_DEFAULT);
        const hid_t  space   = H5Screate(H5S_SCALAR);
        const hid_t  a       = H5Acreate2(file,
                                   "format_version",
                                   H5T_IEEE_F64LE,
                                   space,
                                   H5P_DEFAULT,
                                   H5P_DEFAULT);
        const double version = 7.;
        H5Awrite(a, H5T_NATIVE_DOUBLE, &version);
        H5Aclose(a);
        H5Sclose(space);
        H5Fclose(file);
      },
      "version 7; this program reads 1",
      "another version");
    refuses([] { remove_link("format", true); },
            "no contact history",
            "another format");
    refuses([] { remove_link("complete", true); },
            "incomplete",
            "a run that was killed");
    refuses(
      [] {
        const hid_t  file    = H5Fopen("bad.h5", H5F_ACC_RDWR, H5P_DEFAULT);
        const hid_t  a       = H5Aopen(file, "complete", H5P_DEFAULT);
        const double not_yet = 0.;
        check(H5Awrite(a, H5T_NATIVE_DOUBLE, &not_yet) >= 0,
              "the test says that the run has not ended");
        H5Aclose(a);
        H5Fclose(file);
      },
      "incomplete",
      "complete = 0");
    refuses([] { poke("samples/status", 400, 3.); },
            "the status 3 at 400 s",
            "an unknown status");
    refuses([] { remove_link("samples/pressure", false); },
            "no dataset 'samples/pressure'",
            "a missing dataset");
    refuses([] { poke("samples/pressure", 999, NAN); },
            "not a number in 'samples/pressure'",
            "NaN");
    refuses([] { poke("samples/time", 600, 3.); },
            "do not increase",
            "times out of order");
    refuses([] { poke("nodes/area", 1, -1.); }, "area", "a negative area");
    for (const double corner : {-1., 2., .5, double(NAN)})
      refuses([corner] { poke("nodes/quads", 0, corner); },
              "names a node in 'nodes/quads' that it does not have",
              "a piece of the face with the node " + std::to_string(corner));
    refuses([] { claim_rows("nodes/quads", 80); },
            "not four nodes each",
            "pieces of the face in one column");
    for (const hsize_t n : {hsize_t(1) << 38, hsize_t(1) << 60})
      refuses([n] { claim_rows("nodes/area", n); },
              "does not fit into the memory (dataset nodes/area",
              "more nodes than any memory holds");
    {
      // 32-bit field of another number of nodes
      HistoryLayout layout = two_nodes();
      copy_without_mark();
      const hid_t file = H5Fopen("bad.h5", H5F_ACC_RDWR, H5P_DEFAULT);
      H5Ldelete(file, "samples/gap", H5P_DEFAULT);
      const hsize_t extent[2] = {1000, 3};
      const hid_t   space     = H5Screate_simple(2, extent, nullptr);
      H5Dclose(H5Dcreate2(file,
                          "samples/gap",
                          H5T_IEEE_F32LE,
                          space,
                          H5P_DEFAULT,
                          H5P_DEFAULT,
                          H5P_DEFAULT));
      H5Sclose(space);
      H5Fclose(file);
      check_throws<InputError>([] { HistoryReader reader("bad.h5"); },
                               "'samples/gap' that does not fit",
                               "a dataset of another shape");
    }
  }

  /** @p file with the byte at @p place changed. */
  void
  change_byte(const std::string &file,
              const std::size_t  place,
              const char         value)
  {
    std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
    stream.seekp(static_cast<std::streamoff>(place));
    stream.put(value);
  }

  /** Any change of a history that squeal has written is found. */
  void
  damage_is_found()
  {
    const std::string good = read_file("good.h5");
    std::mt19937      random(4);
    // Behind the mark: without it the file is one from elsewhere.
    std::uniform_int_distribution<std::size_t> place(40, good.size() - 1);
    unsigned int                               n_refused = 0;
    constexpr unsigned int                     n         = 50;
    for (unsigned int i = 0; i < n; ++i)
      {
        fs::copy_file(
          "good.h5", "bad.h5", fs::copy_options::overwrite_existing);
        const std::size_t p = place(random);
        change_byte("bad.h5", p, static_cast<char>(good[p] ^ (1 << (i % 8))));
        try
          {
            const HistoryReader reader("bad.h5");
          }
        catch (const InputError &e)
          {
            n_refused +=
              std::string(e.what()).find("is damaged") != std::string::npos;
          }
      }
    check(n_refused == n,
          std::to_string(n_refused) + " of 50 damaged histories are refused");
  }

  /** What crashes in a library does so in a process of its own. */
  void
  crashes_stay_in_the_child()
  {
    check(ends_by_signal([] { std::raise(SIGFPE); }) &&
            ends_by_signal([] { std::abort(); }),
          "a crash is told");
    check(!ends_by_signal([] {}) &&
            !ends_by_signal([] { throw InputError("no"); }),
          "an orderly end is none");
  }

  const std::string node_table =
    "node,x_m,y_m,area_m2\n0,0,0,1e-6\n1,1e-3,0,1e-6\n";
  const std::string sample_table =
    "time_s,node,pressure_pa,traction_x_pa,traction_y_pa,status\n"
    "0,0,1e6,0,5e5,2\n0,1,0,0,0,0\n1e-4,0,2e6,0,1e6,1\n1e-4,1,0,0,0,0\n";

  void
  tables()
  {
    write_text("nodes.csv", node_table);
    write_text("samples.csv", sample_table);
    check(import_csv_history("nodes.csv", "samples.csv", "table.h5") == 2,
          "two samples of a table");
    const HistoryReader reader("table.h5");
    HistorySamples      s;
    reader.read(0, 2, s);
    check(s.pressure == std::vector<double>({1e6, 0., 2e6, 0.}) &&
            s.status == std::vector<double>({2., 0., 1., 0.}) &&
            !reader.layout().has_slip_rate && !reader.layout().has_gap,
          "they come back, and only they");
    const auto refuse = [](const std::string &old,
                           const std::string &by,
                           const std::string &part,
                           const std::string &claim) {
      std::string       text = sample_table;
      const std::size_t at   = text.find(old);
      check(at != std::string::npos, "the test changes " + old);
      write_text("samples.csv", text.replace(at, old.size(), by));
      fs::remove("refused.h5");
      check_throws<InputError>(
        [] { import_csv_history("nodes.csv", "samples.csv", "refused.h5"); },
        part,
        claim);
      bool left = false;
      for (const auto &entry : fs::directory_iterator("."))
        left |= entry.path().string().find("refused") != std::string::npos;
      check(!left, claim + ": nothing half written");
    };
    refuse("0,1,0,0,0,0\n1e-4",
           "0,1,nan,0,0,0\n1e-4",
           "samples.csv:3: column 'pressure_pa': 'nan'",
           "NaN");
    refuse("pressure_pa",
           "presure_pa",
           "'pressure_pa' is missing; did you mean 'presure_pa'",
           "a missing column");
    refuse("status",
           "Status",
           "samples.csv:1: column 'Status' is not read; did you mean 'status'",
           "a column that is misspelt");
    refuse("status",
           "pressure_pa",
           "column 'pressure_pa' is there twice",
           "a column that is there twice");
    refuse("status",
           "slip_rate_y_m_per_s",
           "column 'slip_rate_x_m_per_s' is missing",
           "half of a slip rate");
    refuse("0,1,0,0,0,0\n1e-4",
           "0,1,0,0,0\n1e-4",
           "samples.csv:3: has 5 cells",
           "a short line");
    refuse("0,1,0,0,0,0\n1e-4",
           "1e-4",
           "samples.csv:3: expected node 1",
           "a missing node");
    refuse("1e-4,1,0,0,0,0\n",
           "1e-4,1,0,0,0,0",
           "samples.csv:5: the line does not end",
           "a file that ends within a number");
    refuse("1e-4,0,",
           "0,0,",
           "samples.csv:4: the time does not increase",
           "equal times");
    refuse("2e6,0,1e6,1\n1e-4,1,0,0,0,0\n",
           "2e6,0,1e6,1\n",
           "lacks nodes from 1",
           "an unfinished sample");
    refuse("1e6,0,5e5,2",
           "-1e6,0,5e5,2",
           "samples.csv:2: the pressure is negative",
           "tension");
    refuse("5e5,2", "5e5,3", "samples.csv:2: the status", "an unknown status");
    refuse("1e6,0,5e5,2",
           "1,5e6,0,5e5,2",
           "has 7 cells, the header 6; if its numbers have decimal commas",
           "decimal commas between commas");
    // as a spreadsheet writes it that has commas for decimals
    const auto with_semicolons = [](std::string text) {
      std::replace(text.begin(), text.end(), ',', ';');
      std::replace(text.begin(), text.end(), '.', ',');
      return "\xEF\xBB\xBF" + text;
    };
    write_text("nodes.csv", with_semicolons(node_table));
    std::string other = with_semicolons(sample_table);
    other.replace(other.find("1e6"), 3, "1000000,0");
    write_text("samples.csv", other);
    fs::remove("table.h5");
    import_csv_history("nodes.csv", "samples.csv", "table.h5");
    HistoryReader("table.h5").read(0, 2, s);
    check(s.pressure == std::vector<double>({1e6, 0., 2e6, 0.}),
          "semicolons, decimal commas and a byte-order mark");
    write_text("samples.csv", other.replace(other.find("5e5"), 3, "5.0e5"));
    check_throws<InputError>(
      [] { import_csv_history("nodes.csv", "samples.csv", "refused.h5"); },
      "samples.csv:2: '5.0e5': decimal commas and decimal points",
      "both decimal marks");
    write_text("samples.csv", sample_table);
    write_text("nodes.csv", "node,x_m,y_m,area_m2\n0,0,0,0\n");
    check_throws<InputError>(
      [] { import_csv_history("nodes.csv", "samples.csv", "refused.h5"); },
      "nodes.csv:2: the area",
      "a node without area");
  }
} // namespace



int
main()
{
  round_trip();
  several_pairs();
  faults_of_files();
  damage_is_found();
  crashes_stay_in_the_child();
  tables();
}
