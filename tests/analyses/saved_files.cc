// SPDX-License-Identifier: LGPL-2.1-or-later

// Files that squeal reads back: a damaged checkpoint or basis is never used.

#include <squeal/base/exceptions.h>
#include <squeal/base/files.h>
#include <squeal/base/output_directory.h>
#include <squeal/base/sealed_file.h>
#include <squeal/base/state_files.h>
#include <squeal/run/checkpoints.h>
#include <squeal/run/finished_runs.h>
#include <squeal/sweep/reduced_model.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include <sys/stat.h>
#include <unistd.h>

#include "check.h"

using namespace squeal;
using namespace squeal::testing;
namespace fs = std::filesystem;

namespace
{
  constexpr unsigned int n_damages = 50;

  std::string
  bytes_of(const std::string &path)
  {
    std::ifstream      in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }

  void
  put(const std::string &path, const std::string &bytes)
  {
    std::ofstream(path, std::ios::binary) << bytes;
  }

  std::size_t
  below(const std::size_t n, std::mt19937 &random)
  {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
  }

  /** @p bytes with one thing wrong, of five kinds in turn. */
  std::string
  damaged(const std::string &bytes,
          const unsigned int kind,
          std::mt19937      &random)
  {
    std::string       result = bytes;
    const std::size_t at = below(bytes.size(), random), block = 64,
                      first  = below(bytes.size() - 2 * block, random),
                      second = first + block;
    switch (kind % 5)
      {
      case 0: // a bit
        result[at] = static_cast<char>(result[at] ^ (1 << below(8, random)));
        break;
      case 1: // cut
        result.resize(at);
        break;
      case 2: // a piece of zeros, or of ones where there are zeros
        for (std::size_t i = first; i < second; ++i)
          result[i] = 0;
        if (result == bytes)
          for (std::size_t i = first; i < second; ++i)
            result[i] = 1;
        break;
      case 3: // two blocks exchanged
        std::swap_ranges(result.begin() + first,
                         result.begin() + second,
                         result.begin() + second);
        if (result == bytes)
          result[first] = static_cast<char>(result[first] + 1);
        break;
      default: // longer
        result += bytes.substr(0, 1 + below(block, random));
      }
    return result;
  }



  NamedNumbers
  some_state(const double number)
  {
    NamedNumbers state;
    for (unsigned int k = 0; k < 40; ++k)
      {
        std::vector<double> values(10 * k);
        for (std::size_t i = 0; i < values.size(); ++i)
          values[i] = number + std::sin(double(i * k));
        state.set("group/" + std::to_string(k), values);
      }
    state.set("number", number);
    return state;
  }

  Fingerprint
  some_run(const std::string &density)
  {
    Fingerprint fingerprint;
    fingerprint.add("Scene/Body pad/Density", density);
    return fingerprint;
  }



  void
  damaged_checkpoints()
  {
    const Checkpoints run("checkpoint.h5", some_run("2500"));
    const auto        clear = []() {
      for (const auto &entry : fs::directory_iterator("."))
        fs::remove_all(entry.path());
    };
    clear();
    run.write(some_state(1.));
    run.write(some_state(2.));
    const std::string last   = bytes_of("checkpoint.h5"),
                      before = bytes_of("checkpoint_before.h5");
    check(run.find().state->number("number") == 2.,
          "the last checkpoint is the one that is used");
    check(*run.find().state == some_state(2.), "with all its numbers");

    std::mt19937 random(7);
    unsigned int n_refused = 0, n_fallen_back = 0;
    for (unsigned int k = 0; k < n_damages; ++k)
      {
        clear();
        const std::string wrong = damaged(last, k, random);
        put("checkpoint.h5", wrong);
        const bool has_other = k % 2 == 0;
        if (has_other)
          put("checkpoint_before.h5", before);
        try
          {
            const auto found = run.find();
            check(has_other && found.state && *found.state == some_state(1.) &&
                    found.notes.size() == 1,
                  "a damaged checkpoint gives way to the one before it");
            check(bytes_of("checkpoint.kept1.h5") == wrong,
                  "and is kept under another name");
            ++n_fallen_back;
          }
        catch (const InputError &e)
          {
            check(std::string(e.what()).find("checkpoint.h5") !=
                      std::string::npos &&
                    std::string(e.what()).find('\n') == std::string::npos,
                  "a damaged checkpoint is refused in one line");
            check(bytes_of("checkpoint.h5") == wrong, "and is left as it is");
            ++n_refused;
          }
      }
    check(n_refused + n_fallen_back == n_damages && n_fallen_back > 20,
          std::to_string(n_refused) + " refused, " +
            std::to_string(n_fallen_back) + " gave way, none used");
    clear();
  }



  void
  checkpoints_of_others()
  {
    const Checkpoints mine("checkpoint.h5", some_run("2500")),
      other("checkpoint.h5", some_run("2600"));
    other.write(some_state(1.));
    other.write(some_state(2.));
    const std::string last  = bytes_of("checkpoint.h5");
    const auto        found = mine.find();
    check(
      !found.state && found.notes.size() == 2 &&
        found.notes[0].find("Scene/Body pad/Density is 2500, it was 2600") !=
          std::string::npos,
      "a checkpoint of another run is not used, and the entry is named");
    mine.write(some_state(3.));
    mine.remove();
    check(bytes_of("checkpoint.kept1.h5") == last &&
            fs::exists("checkpoint_before.kept1.h5") &&
            !fs::exists("checkpoint.h5"),
          "and neither overwritten nor deleted");
    mine.write(some_state(4.));
    check(!mine.find(false).state && fs::exists("checkpoint.kept2.h5"),
          "without Resume an earlier one is put aside");
  }



  ReducedModel
  some_model()
  {
    ReducedModel model;
    model.parts               = {Eigen::MatrixXd::Identity(6, 6),
                                 Eigen::MatrixXd::Constant(6, 6, 0.5)};
    model.forms["energy pad"] = Eigen::MatrixXd::Identity(6, 6);
    model.numbers["factors"]  = Eigen::MatrixXd::Constant(1, 1, 3.);
    ModelCell cell;
    cell.lower         = Eigen::VectorXd::Zero(2);
    cell.upper         = Eigen::VectorXd::Ones(2);
    cell.turn          = Eigen::MatrixXd::Identity(6, 6);
    cell.local.n_basis = 4;
    model.project(cell);
    model.cells.push_back(cell);
    return model;
  }

  void
  damaged_bases()
  {
    write_reduced_model(some_model(), some_run("2500").text(), "basis.h5");
    std::string key;
    check(read_reduced_model("basis.h5", key).parts[1] == some_model().parts[1],
          "a whole basis comes back");
    check(key == some_run("2500").text() &&
            key_of_reduced_model("basis.h5") == key,
          "with its key");
    const std::string whole = bytes_of("basis.h5");
    std::mt19937      random(11);
    for (unsigned int k = 0; k < n_damages; ++k)
      {
        put("damaged.h5", damaged(whole, k, random));
        check_throws<InputError>(
          [&]() { read_reduced_model("damaged.h5", key); },
          "damaged.h5",
          "a damaged basis is refused");
        check(!is_whole_file("damaged.h5", state_kind::basis),
              "and known as such before it is read");
      }
  }



  void
  damaged_rows()
  {
    const auto read = []() {
      return FinishedRuns("runs.json", bytes_of("runs.json"));
    };
    const std::vector<Cell> row = {Cell("held"), Cell(0.1), Cell(12), Cell()};
    FinishedRuns            runs("runs.json", "");
    for (const char *density : {"2500", "2600", "2700"})
      runs.add(some_run(density), "row", row);
    const std::string whole = bytes_of("runs.json");
    std::mt19937      random(13);
    unsigned int      n_refused = 0;
    for (unsigned int k = 0; k < 4 * n_damages; ++k)
      {
        const std::string wrong = damaged(whole, k, random);
        put("runs.json", wrong);
        try
          {
            const FinishedRuns again = read();
            for (const char *density : {"2500", "2600", "2700"})
              {
                std::vector<Cell> found;
                check(!again.find(some_run(density), "row", 4, found) ||
                        (std::get<std::string>(found[0].value) == "held" &&
                         std::get<double>(found[1].value) == 0.1 &&
                         std::get<long long>(found[2].value) == 12 &&
                         found[3].is_missing()),
                      "a row that is found is the one that was kept");
              }
          }
        catch (const InputError &e)
          {
            ++n_refused;
            check(bytes_of("runs.json") == wrong,
                  "a damaged file is refused and kept");
          }
      }
    check(n_refused > 3 * n_damages,
          std::to_string(n_refused) + " damaged files refused");
    put("runs.json", whole);
    runs.add(some_run("2800"), "row", {Cell(HUGE_VAL)});
    std::vector<Cell> found;
    check(!read().find(some_run("2800"), "row", 1, found),
          "a row with an infinite number is not kept");
  }



  /** A pipe under the name of a saved file has no first bytes to wait for. */
  void
  pipes()
  {
    check(::mkfifo("pipe.h5", 0600) == 0, "a pipe is made");
    ::alarm(20); // the default action ends the program
    check(!is_state_file("pipe.h5"), "a pipe is no file of squeal");
    fs::create_directory("results");
    fs::rename("pipe.h5", "results/checkpoint.h5");
    check_throws<InputError>([]() { OutputDirectory("results", false); },
                             "not empty",
                             "nor may it be overwritten");
    OutputDirectory output("results", true);
    check_throws<InputError>(
      [&]() {
        output.state_file(
          "checkpoint.h5", state_kind::checkpoint, "Transient/Checkpoint file");
      },
      "no checkpoint that squeal has written",
      "and it is refused in place of a checkpoint");
    ::alarm(0);
  }
} // namespace



int
main()
{
  fs::remove_all("sealed_files_test");
  fs::create_directory("sealed_files_test");
  fs::current_path("sealed_files_test");
  damaged_checkpoints();
  checkpoints_of_others();
  damaged_bases();
  damaged_rows();
  pipes();
}
