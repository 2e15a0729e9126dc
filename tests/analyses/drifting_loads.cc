// SPDX-License-Identifier: LGPL-2.1-or-later

// A block on a floor: a force that drifts is no vibration, nor does it squeal
// by itself before a trigger; what the reduced model alone has decides nothing;
// triggers and loads that move nothing are refused; the sound is that of the
// motion which vibrates, and silence where none does. Arguments: the program,
// the part.

#include <squeal/results/table.h>

#include "program.h"
#include "worst.h"

#include <cmath>
#include <cstdint>
#include <regex>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program;

  const std::string block_scene = R"(set Analysis         = transient
set Output directory = out
set Overwrite        = true
subsection Scene
  set Bodies   = floor, block
  set Supports = floor_bottom, floor_top
  set Springs  = bed
  set Loads    = press
  set Contacts = c
  subsection Body floor
    set Size     = 0.04, 0.04, 0.01
    set Position = 0, 0, -0.01
    set Cells    = 1, 1, 1
  end
  subsection Body block
    set Size          = 0.02, 0.02, 0.01
    set Position      = 0, 0, 0
    set Cells         = 2, 2, 1
    set Young modulus = 210e9
    set Density       = 7800
  end
  subsection Support floor_bottom
    set Body = floor
    set Face = z_min
  end
  subsection Support floor_top
    set Body = floor
    set Face = z_max
  end
  # 20 kN/m along x, 30 kN/m along y
  subsection Spring bed
    set Kind        = area
    set Body        = block
    set Face        = z_max
    set Stiffnesses = 5e7, 7.5e7, 0
    set Dashpots    = 2e3, 2e3, 0
  end
  subsection Load press
    set Body  = block
    set Face  = z_max
    set Force = 0, 0, -100
  end
  subsection Contact c
    set Source body          = block
    set Source face          = z_min
    set Target body          = floor
    set Target face          = z_max
    set Formulation          = mortar
    set Contact state        = preload
    set Sliding speed        = 0.05
    set Friction coefficient = 0.3
    set Normal force         = 100
  end
  subsection Damping
    set Model             = whole model
    set Stiffness damping = 4e-6
  end
end
subsection Discretization
  set Degree         = 1
  set Estimate error = false
end
subsection Eigenvalues
  set Highest frequency = 2000
end
subsection Transient
  set Integrator      = implicit
  set Cut-off         = 20e3
  set Time step       = 1e-5
  set End time        = 0.05
  set Sample interval = 5e-5
  set Disturbance     = 0
end
subsection Output
  set Plots = false
end
)";

  Outcome
  run(const std::vector<std::string> &settings, const std::string &more = "")
  {
    write_text("block.prm", block_scene + more);
    std::vector<std::string> words = {program};
    for (const std::string &setting : settings)
      words.insert(words.end(), {"--set", setting});
    words.push_back("block.prm");
    return run_program(words);
  }

  std::string
  runs(const std::vector<std::string> &settings)
  {
    const Outcome o = run(settings);
    check(o.code == 0, settings.front() + " runs: " + o.errors);
    return unbroken(o.output);
  }

  bool
  has(const std::string &text, const std::string &part)
  {
    return text.find(part) != std::string::npos;
  }

  /** Samples of pad.wav. */
  std::vector<double>
  sound()
  {
    const std::string   file = text_of("out/pad.wav");
    std::vector<double> values;
    for (std::size_t i = 44; i + 1 < file.size(); i += 2)
      values.push_back(static_cast<std::int16_t>(
        static_cast<unsigned char>(file[i]) |
        static_cast<unsigned char>(file[i + 1]) << 8));
    return values;
  }

  void
  check_silence(const std::string &claim)
  {
    const Table t = read_csv("out/transient.csv");
    check(t.text(0, "limit_cycle") == "no", claim + " is no limit cycle");
    for (const char *column :
         {"limit_cycle_frequency_hz", "largest_line_hz", "repetition"})
      check(t.is_missing(0, column), claim + " has no " + column);
    check(has(text_of("out/run.json"), "nothing vibrates"),
          claim + ": said in words");
    Worst loudest;
    for (const double value : sound())
      loudest.add(std::abs(value));
    check_within(loudest, 0., claim + " is not heard");
  }

  void
  drifts()
  {
    runs({"Transient/Final speed ratio = 3",
          "Scene/Contact c/Friction law = table",
          "Scene/Contact c/Friction speeds = 0, 0.2",
          "Scene/Contact c/Friction coefficients = 0.2, 0.4"});
    const Table t = read_csv("out/transient.csv");
    check(t.real(0, "rms_tangential_n") > .5,
          "the tangential force drifts: " +
            std::to_string(t.real(0, "rms_tangential_n")) + " N");
    check_silence("friction that rises with the speed");

    runs({"Transient/Start = ramp", "Scene/Load press/Ramp time = 0.075"});
    check(read_csv("out/transient.csv").real(0, "rms_normal_n") > 5.,
          "the normal force drifts");
    const Table ramped = read_csv("out/transient.csv");
    check(ramped.text(0, "limit_cycle") == "no",
          "a load that comes on is no limit cycle");
  }

  void
  triggers()
  {
    const std::string said = runs({"Transient/Start = ramp",
                                   "Scene/Load press/Ramp time = 0.02",
                                   "Scene/Contact c/Friction coefficient = 0.1",
                                   "Transient/Hammer/Body = block",
                                   "Transient/Hammer/Face = x_max",
                                   "Transient/Hammer/Force = 1, 0, 0",
                                   "Transient/Hammer/Time = 0.015",
                                   "Transient/Hammer/Duration = 1e-3"});
    check(has(said, "before the end of the longest 'Ramp time'"),
          "a trigger while the load comes on is warned of");
    const std::string outcome = text_of("out/run.json");
    check(!has(outcome, "squeal by itself") && has(outcome, "none: rms"),
          "the load that comes on is no squeal by itself: " + outcome);

    const std::string reduced = runs({"Transient/End time = 2e-3"});
    check(has(reduced, "which this run does not use") &&
            !has(text_of("out/run.json"), "outside the band, grows"),
          "motions that the reduced model alone has decide nothing");

    const std::string steady =
      runs({"Scene/Load press/Ramp time = 0.02", "Transient/End time = 2e-3"});
    check(has(steady, "/Ramp time' ("), "a ramp without effect is warned of");
  }

  /** What run.json says of the trigger: a word, and N before it, after it and
   * at the end. */
  struct Blow
  {
    std::string         word;
    std::vector<double> sizes;
  };

  Blow
  blow(const std::string &force, const std::string &sample_interval)
  {
    runs({"Transient/Hammer/Body = block",
          "Transient/Hammer/Face = z_max",
          "Transient/Hammer/Force = 0, 0, " + force,
          "Transient/Hammer/Time = 0.02",
          "Transient/Hammer/Duration = 2e-4",
          "Eigenvalues/Highest frequency = 100",
          "Transient/Sample interval = " + sample_interval});
    const std::string text = text_of("out/run.json");
    std::smatch       parts;
    check(
      std::regex_search(text,
                        parts,
                        std::regex("\"outcome\": \"([^:]*):.* (\\S+) N before "
                                   "the trigger, (\\S+) N after it, (\\S+) N "
                                   "at the end\"")),
      "there is an outcome of the trigger");
    return {parts[1],
            {std::stod(parts[2]), std::stod(parts[3]), std::stod(parts[4])}};
  }

  /** Every step counts, however few samples are kept of the motion. */
  void
  outcomes_by_steps()
  {
    for (const char *force : {"-20", "2000"})
      {
        const Blow many = blow(force, "5e-5"), few = blow(force, "4e-3");
        check(many.word == few.word,
              std::string(force) + " N: " + many.word + " with many samples, " +
                few.word + " with few");
        for (unsigned int k = 0; k < 3; ++k)
          check(std::abs(many.sizes[k] - few.sizes[k]) <
                  1e-3 * many.sizes[k] + 1e-5, // of 100 N, rounding
                "and as large: " + std::to_string(many.sizes[k]) + ", " +
                  std::to_string(few.sizes[k]) + " N");
      }
  }

  void
  refused(const std::vector<std::string> &settings,
          const std::vector<std::string> &parts,
          const std::string              &more = "")
  {
    std::vector<std::string> all = {"Transient/End time = 1e-3"};
    all.insert(all.end(), settings.begin(), settings.end());
    const Outcome     o    = run(all, more);
    const std::string said = unbroken(o.errors);
    check(o.code != 0, settings.back() + " is refused");
    for (const std::string &part : parts)
      check(has(said, part), "'" + part + "' in: " + said);
  }

  void
  refusals()
  {
    const std::string hammer = "Transient/Hammer/";
    const auto        struck = [&](const std::string &body,
                            const std::string &face,
                            const std::string &force,
                            const std::string &duration) {
      return std::vector<std::string>{hammer + "Body = " + body,
                                      hammer + "Face = " + face,
                                      hammer + "Force = " + force,
                                      hammer + "Duration = " + duration};
    };
    refused(struck("block", "x_max", "500, 0, 0", "9e-5"),
            {"'Transient/Hammer/Duration'", "ten time steps"});
    refused({"Transient/Friction impulse = 0.5",
             "Transient/Friction impulse duration = 4e-6"},
            {"'Transient/Friction impulse duration'", "ten time steps"});
    // The size of the coefficient of a target that turns backwards, too.
    const std::string mu = "Scene/Contact c/Friction coefficient = ";
    for (const char *size : {"0.3", "-0.3"})
      refused({mu + size,
               "Transient/Friction impulse = -0.301",
               "Transient/Friction impulse duration = 1e-4"},
              {"'Transient/Friction impulse' = -0.301",
               "contact 'c' below 0",
               "at least -0.3"});
    refused({mu + "0",
             "Scene/Contact c/Friction law = table",
             "Scene/Contact c/Friction speeds = 0, 0.1, 0.2",
             "Scene/Contact c/Friction coefficients = 0.5, 0.2, 0.3",
             "Transient/Friction impulse = -0.25",
             "Transient/Friction impulse duration = 1e-4"},
            {"'Transient/Friction impulse' = -0.25", "at least -0.2"});
    runs({"Transient/End time = 1e-3",
          mu + "-0.3",
          "Transient/Friction impulse = -0.3",
          "Transient/Friction impulse duration = 1e-4"});
    refused(struck("block", "x_max", "0, 0, 0", "1e-4"),
            {"'Transient/Hammer/Force'", "nothing is struck"});
    for (const char *face : {"x_min", "z_max"})
      refused(struck("floor", face, "0, 0, 500", "1e-4"),
              {"Transient/Hammer", "moves nothing", face});
    refused({"Scene/Loads = press, idle"},
            {"Scene/Load idle", "moves nothing", "x_min"},
            "subsection Scene\n  subsection Load idle\n    set Body = floor\n  "
            "  set Face = x_min\n    set Force = 0, 0, 500\n  end\nend\n");
    const Outcome o = run({"Transient/End time = 1e-3",
                           hammer + "Body = block",
                           hammer + "Face = x_max",
                           hammer + "Force = 1, 0, 0",
                           hammer + "Duration = 1e-4"});
    check(o.code == 0, "ten steps on a free face are a blow: " + o.errors);
  }

  /** Stick-slip along y, which the normal force knows nothing of. */
  void
  sounds()
  {
    const auto stick_slip = [](const std::string &interval,
                               const std::string &highest,
                               const std::string &along_y) {
      return std::vector<std::string>{
        "Transient/Disturbance = 1e-6",
        "Transient/End time = 0.1",
        "Transient/Time step = 2e-5",
        "Transient/Sample interval = " + interval,
        "Eigenvalues/Highest frequency = " + highest,
        "Scene/Spring bed/Stiffnesses = 5e7, " + along_y + ", 0",
        "Scene/Contact c/Friction law = exponential",
        "Scene/Contact c/Friction coefficient = 0.1",
        "Scene/Contact c/Static friction coefficient = 0.3",
        "Scene/Contact c/Decay speed = 0.05",
        "Output/Plots = true"};
    };
    runs(stick_slip("2e-4", "2000", "7.5e7"));
    const Table t      = read_csv("out/transient.csv"),
                probes = read_csv("out/probes.csv");
    check(t.real(0, "rms_tangential_n") > 1. && t.real(0, "rms_normal_n") < .01,
          "it sticks and slips under a steady load: " +
            std::to_string(t.real(0, "rms_tangential_n")) + " N, " +
            std::to_string(t.real(0, "rms_normal_n")) + " N");
    const std::vector<double> heard = sound();
    check(heard.size() >= probes.n_rows(), "a value for each sample");
    // Along the sliding, y, but for rounding to 16 bits and for the end, where
    // one repetition gives way to the next.
    Worst  largest;
    double x = 0., y = 0., z = 0.;
    for (std::size_t i = 0; i < probes.n_rows() / 2; ++i)
      {
        const double along = probes.real(i, "pad_ay_m_per_s2");
        largest.add(std::abs(heard[i]));
        x += heard[i] * heard[i];
        y += along * along;
        z += heard[i] * along;
      }
    check(std::abs(std::abs(z) / std::sqrt(x * y) - 1.) < 1e-3,
          "the sound is that of the sliding: " +
            std::to_string(z / std::sqrt(x * y)));
    check(largest.largest() > 1e4, "and loud");
    check(std::filesystem::exists("out/plots/spectrum.png"),
          "there is a spectrum");

    runs(stick_slip("4e-3", "100", "7.5e8"));
    check(!std::filesystem::exists("out/pad.wav") &&
            !std::filesystem::exists("out/plots/spectrum.png"),
          "samples too far apart for the motion have no sound, no spectrum");
    const std::string report = text_of("out/report.html");
    check(has(report, "forces.png") && !has(report, "spectrum.png") &&
            !has(report, "pad.wav"),
          "nor does the report show them");
    check(has(text_of("out/run.log"), "neither sound nor spectrum"),
          "which is said");
  }
} // namespace

int
main(int argc, char **argv)
{
  check(argc == 3, "two arguments: program and part");
  program                 = argv[1];
  const std::string which = argv[2];
  if (which == "drifts")
    drifts();
  else if (which == "triggers")
    triggers();
  else if (which == "refusals")
    refusals();
  else if (which == "outcomes")
    outcomes_by_steps();
  else if (which == "sound")
    sounds();
  else
    check(false, "a part: drifts, triggers, outcomes, refusals or sound");
}
