// SPDX-License-Identifier: LGPL-2.1-or-later

// What is saved of another run is said, kept and not used; files of others are
// left alone; one process owns an output directory. Arguments: the program, the
// folder of parameter files.

#include "../contact/turned_block.h"
#include "brief_runs.h"

using namespace squeal;
using namespace squeal::testing;

namespace
{
  namespace fs = std::filesystem;

  std::string program, folder;

  /** Stops run.prm with a checkpoint. */
  void
  stop_with_checkpoint(const std::string &directory)
  {
    fs::remove_all(directory);
    fs::create_directory(directory);
    const Outcome o =
      run_in(directory, program, "run.prm", [&](const pid_t id) {
        for (unsigned int i = 0; i < 3000; ++i)
          {
            if (fs::exists(directory + "/out/checkpoint_before.h5"))
              break;
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
          }
        ::kill(id, SIGTERM);
      });
    check(o.code == 128 + SIGTERM &&
            fs::exists(directory + "/out/checkpoint.h5") &&
            fs::exists(directory + "/out/checkpoint_before.h5"),
          "stopped with two checkpoints: " + o.errors);
  }

  /** The pin of the scene from a Gmsh file with @p n cells along its edges. */
  void
  write_pin(const unsigned int n)
  {
    BodyParameters pin;
    pin.name  = "pin";
    pin.size  = {{0.010, 0.010, 0.020}};
    pin.cells = {{n, n, 4}};
    make_turned_block(pin, 0.);
  }



  void
  another_mesh()
  {
    write_pin(2);
    write_text("run.prm",
               pin_on_beam(folder,
                           "subsection Scene\n subsection Body pin\n"
                           "  set Shape = gmsh\n"
                           "  set Mesh file = pin.msh\n end\nend\n",
                           "0.008"));
    stop_with_checkpoint("mesh");
    const std::string before = text_of("mesh/out/checkpoint.h5");
    write_pin(3);
    const Outcome o = run_in("mesh", program, "run.prm");
    check(o.code == 0, "runs with another mesh: " + o.errors);
    const std::string log = text_of("mesh/out/run.log");
    check(log.find("of another run: Scene/Body pin/Mesh file is ") !=
              std::string::npos &&
            log.find("continues from") == std::string::npos,
          "a checkpoint with another mesh is not used, and that is said");
    check(text_of("mesh/out/checkpoint.kept1.h5") == before,
          "the checkpoint is kept, byte by byte");
    fs::remove_all("fresh");
    fs::create_directory("fresh");
    check(run_in("fresh", program, "run.prm").code == 0, "a fresh run");
    for (const char *name : {"forces.csv", "energy.csv", "contact_history.h5"})
      check(text_of(std::string("mesh/out/") + name) ==
              text_of(std::string("fresh/out/") + name),
            std::string("the result is that of a fresh run: ") + name);
  }



  void
  damaged_checkpoint()
  {
    stop_with_checkpoint("damaged");
    const std::string path = "damaged/out/checkpoint.h5";
    std::string       text = text_of(path);
    text[text.size() / 2]  = static_cast<char>(text[text.size() / 2] ^ 4);
    write_text(path, text);
    const Outcome o = run_in("damaged", program, "run.prm");
    check(o.code == 0, "goes on: " + o.errors);
    const std::string log = text_of("damaged/out/run.log");
    check(log.find("checkpoint.h5' is damaged") != std::string::npos &&
            log.find("continues from out/checkpoint_before.h5") !=
              std::string::npos,
          "a damaged checkpoint gives way to the one before");
    check(text_of("damaged/out/checkpoint.kept1.h5") == text, "and is kept");
    auto killed = comparable_results("damaged/out"),
         whole  = comparable_results("fresh/out");
    killed.erase("checkpoint.kept1.h5");
    // It names the file that was put aside.
    killed.erase("run.json");
    whole.erase("run.json");
    check_same_results(whole, killed, "continued from the one before");
  }



  void
  damaged_history()
  {
    stop_with_checkpoint("history");
    const std::string path = "history/out/checkpoint_samples.bin";
    std::string       text = text_of(path);
    check(text.size() > 2000, "the history is written as it comes");
    text[1000] = static_cast<char>(text[1000] ^ 4);
    write_text(path, text);
    const Outcome o = run_in("history", program, "run.prm");
    check(o.code == 2 && o.errors.find("checkpoint_samples.bin': has other "
                                       "rows than its checkpoint; move") !=
                           std::string::npos,
          "a damaged history is refused: " + o.errors);
    check(text_of(path) == text, "and left as it is");
  }



  void
  files_of_others()
  {
    fs::remove_all("others");
    fs::create_directories("others/out");
    write_text("others/out/checkpoint.h5", "mine");
    write_text("others/precious.h5", "mine");
    const auto refused = [&](const std::vector<std::string> &settings,
                             const std::string              &part) {
      const Outcome o = run_in("others", program, "run.prm", {}, settings);
      check(o.code == 2 && o.errors.find(part) != std::string::npos,
            "refused: " + o.errors);
      check(text_of("others/out/checkpoint.h5") == "mine" &&
              text_of("others/precious.h5") == "mine",
            "files of others are as they were");
    };
    refused({"Transient/Resume = false"}, "no checkpoint that squeal has");
    refused({"Transient/Checkpoint file = ../precious.h5"},
            "leaves the output directory");
    refused({"Transient/Checkpoint file = " +
             fs::absolute("others/precious.h5").string()},
            "leaves the output directory");
    for (const char *name : {"forces.csv", "run.json", "contact_history.h5"})
      refused({std::string("Transient/Checkpoint file = ") + name},
              "a name of its own that ends in '.h5'");
    refused({"Transient/Campaign table = ../precious.csv"},
            "leaves the output directory");
    write_text("sweep.prm", brake_sweep(folder));
    const Outcome o = run_in("others",
                             program,
                             "sweep.prm",
                             {},
                             {"Sweep/Basis file = deep/../../precious.h5"});
    check(o.code == 2 &&
            o.errors.find("leaves the output directory") != std::string::npos,
          "nor for the basis: " + o.errors);
  }



  void
  one_owner()
  {
    fs::remove_all("owned");
    fs::create_directory("owned");
    std::string   second;
    int           code = 0;
    pid_t         owner;
    const Outcome first =
      run_in("owned", program, "run.prm", [&](const pid_t id) {
        owner = id;
        wait_for_log("owned/out/run.log", "pairs in the band");
        const auto    before = fs::file_size("owned/out/run.log");
        const Outcome o      = run_in("owned", program, "run.prm");
        code                 = o.code;
        second               = o.errors;
        check(fs::file_size("owned/out/run.log") >= before,
              "the second run has removed nothing");
      });
    check(code == 2 &&
            second.find("in use by process " + std::to_string(owner) + " on") !=
              std::string::npos &&
            std::count(second.begin(), second.end(), '\n') == 1,
          "a second run in the same directory is refused in one line: " +
            second);
    check(first.code == 0, "the first one ends: " + first.errors);
    check_same_results(comparable_results("fresh/out"),
                       comparable_results("owned/out"),
                       "with the results of one that was alone");

    const Outcome killed =
      run_in("owned", program, "run.prm", [&](const pid_t id) {
        wait_for_log("owned/out/run.log", "pairs in the band");
        ::kill(id, SIGKILL);
      });
    check(killed.code == 128 + SIGKILL, "killed");
    check(run_in("owned", program, "run.prm").code == 0,
          "a dead owner stands in nobody's way");
  }
} // namespace



int
main(int argc, char *argv[])
{
  check(argc == 3, "two arguments: program and folder");
  program = fs::absolute(argv[1]).string();
  folder  = argv[2];
  another_mesh();
  damaged_checkpoint();
  damaged_history();
  files_of_others();
  one_owner();
}
