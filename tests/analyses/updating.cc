// SPDX-License-Identifier: LGPL-2.1-or-later

// Updating: derivatives against differences, twin experiments that recover
// known numbers, settings that make the fitted scene, what data do not
// identify, refusals. Arguments: the program.

#include <squeal/analyses/updating/updating_model.h>
#include <squeal/results/table.h>

#include "program.h"
#include "updating_scenes.h"

#include <deal.II/base/mpi.h>

#include <random>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  std::string program;

  const double true_disc = 2.3e11, true_pad = 3.1e10, true_contact = 4e8;

  /** The small brake with a stiffness of disc, pad and contact; a heavy pad,
   * so that all three move frequencies. */
  std::string
  brake(const double disc, const double pad, const double contact)
  {
    std::string text = small_brake;
    for (const auto &[old, by] :
         std::vector<std::pair<std::string, std::string>>{
           {"set Density       = 2500", "set Density       = 3e5"},
           {"set Young modulus = 2e10",
            "set Young modulus = " + shortest_text(pad)},
           {"set Shape         = annulus",
            "set Shape         = annulus\n    set Young modulus = " +
              shortest_text(disc)},
           {"set Grid                 = 2, 2",
            "set Grid                 = 2, 2\n    set Normal stiffness = " +
              shortest_text(contact)},
           {"set Highest frequency = 6000", "set Highest frequency = 20000"}})
      text = replaced_in(text, old, by);
    return text;
  }

  /** Fit of the three, from other values. */
  std::string
  fit(const std::string &more = "", const std::string &names = "")
  {
    return replaced_in(brake(2.2e11, 2.7e10, 5e8), "= cea", "= updating") + R"(
subsection Measurement
  set Frequencies file = measured.csv
end
subsection Updating
  set Tolerance = 1e-8
  set Numbers   = disc, pad, contact)" +
           names + R"(
  subsection Number disc
    set Entries = Scene/Body disc/Young modulus
    set Lower   = 1e11
    set Upper   = 4e11
  end
  subsection Number pad
    set Entries = Scene/Body pad/Young modulus
    set Lower   = 5e9
    set Upper   = 2e11
  end
  subsection Number contact
    set Entries = Scene/Contact pad_disc/Normal stiffness
    set Lower   = 5e7
    set Upper   = 1e10
  end
)" + more + "end\n";
  }

  Outcome
  run(const std::string &text, const std::vector<std::string> &settings = {})
  {
    return run_text(program, text, settings);
  }

  /** How often each name stands in a table. */
  std::map<std::string, unsigned int>
  count_names(const Table &table)
  {
    std::map<std::string, unsigned int> count;
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      ++count[table.text(r, "name")];
    return count;
  }

  /** Eigenvalues of a brake that many tests begin with, solved once. */
  const Table &
  solved(const std::string &text, const std::string &name)
  {
    static std::map<std::string, Table> tables;
    const auto                          known = tables.find(text);
    if (known != tables.end())
      return known->second;
    check(run(text).code == 0, name + " is solved");
    return tables.emplace(text, read_csv("out/eigenvalues.csv")).first->second;
  }

  /** Writes measured.csv from the twin: frequencies of modes whose names stand
   * once in its table and once in that of the scene where the fit starts, with
   * independent normal errors of the standard deviation @p noise. */
  void
  measure_twin(const double noise, const unsigned int seed = 0)
  {
    auto at_start =
      count_names(solved(brake(2.2e11, 2.7e10, 5e8), "the start"));
    const Table &table =
      solved(brake(true_disc, true_pad, true_contact), "the twin");
    auto                             count = count_names(table);
    std::string                      text  = "name,frequency_hz,weight\n";
    unsigned int                     n     = 0;
    std::mt19937                     random(seed);
    std::normal_distribution<double> normal;
    for (std::size_t r = 0; r < table.n_rows() && n < 14; ++r)
      if (const std::string name = table.text(r, "name");
          count[name] == 1 && at_start[name] == 1)
        {
          const double error = noise * normal(random);
          text += '"' + name + "\"," +
                  shortest_text((1. + error) * table.real(r, "frequency_hz")) +
                  ",1\n";
          ++n;
        }
    check(n >= 6, "the twin has " + std::to_string(n) + " named modes");
    write_text("measured.csv", text);
  }

  const std::vector<std::pair<std::string, double>> truth = {
    {"disc", true_disc},
    {"pad", true_pad},
    {"contact", true_contact}};

  /** The last one: programs that begin as copies of this process start MPI
   * themselves. */
  void
  test_derivatives(int argc, char **argv)
  {
    measure_twin(0.);
    dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
    write_text("run.prm", fit());
    const Parameters parameters =
      read_parameters("run.prm", {"Overwrite = true"});
    parameters.check();
    RunContext            context(parameters, true);
    UpdatingModel         model(context);
    const Eigen::VectorXd point = Eigen::Vector3d(.05, .2, -.3);
    model.evaluate(Eigen::VectorXd::Zero(3));
    const UpdatingEvaluation here = model.evaluate(point);
    const double             h    = 1e-4;
    for (int n = 0; n < 3; ++n)
      {
        const Eigen::VectorXd d     = h * Eigen::VectorXd::Unit(3, n);
        const Eigen::VectorXd slope = (model.evaluate(point + d).residuals -
                                       model.evaluate(point - d).residuals) /
                                      (2. * h);
        const double error =
          (slope - here.jacobian.col(n)).norm() / here.jacobian.col(n).norm();
        std::cout << "        " << truth[n].first << ": " << error << std::endl;
        check(error <= 1e-5, "derivatives are those of the frequencies");
      }
  }

  void
  test_twin()
  {
    measure_twin(0.);
    const Outcome outcome = run(fit());
    check(outcome.code == 0, "the fit ends well " + outcome.errors);
    const Table table = read_csv("out/updated_numbers.csv");
    for (const auto &[number, exact] : truth)
      {
        const double error = value(table, number, "value") / exact - 1.;
        std::cout << "        " << number << ": " << error << std::endl;
        check(std::abs(error) <= 1e-5, "the fit recovers " + number);
        check(value(table, number, "identified") == 1., "and identifies it");
      }
    std::cout << "        evaluations: "
              << read_csv("out/updating_history.csv").n_rows() << std::endl;
  }

  /** Confidence intervals of 95 % hold the truth about so often, over fits to
   * data with random errors; a single fit would say nothing. */
  void
  test_confidence_intervals()
  {
    const unsigned int n_fits = 10;
    unsigned int       held   = 0;
    for (unsigned int seed = 1; seed <= n_fits; ++seed)
      {
        measure_twin(7e-4, seed);
        check(run(fit()).code == 0, "the fit to data with errors ends well");
        const Table noisy = read_csv("out/updated_numbers.csv");
        for (const auto &[number, exact] : truth)
          {
            const double lower = value(noisy, number, "interval_lower");
            const double upper = value(noisy, number, "interval_upper");
            held += lower < exact && exact < upper;
            const double widest = number == "contact" ? 1.1 : 1.01;
            check(upper < widest * lower,
                  "the interval is narrow for " + number + ": " +
                    shortest_text(upper / lower));
          }
      }
    // Of 30, 28.5 are expected. The three of a fit hang together: were all
    // three the same, fewer than 8 of 10 fits would hold with a probability of
    // 1 %. Intervals of half the width would hold 20.
    std::cout << "        held " << held << " of " << 3 * n_fits << std::endl;
    check(held >= 24, "confidence intervals hold the truth");
  }

  void
  test_identification()
  {
    measure_twin(1e-4);
    // Light damping does not move frequencies; a tenth number is no help.
    const Outcome outcome = run(fit("  subsection Number damping\n"
                                    "    set Entries = Scene/Damping/Stiffness "
                                    "damping\n"
                                    "    set Lower = 1e-9\n"
                                    "    set Upper = 1e-7\n"
                                    "  end\n",
                                    ", damping") +
                                "subsection Scene\n  subsection Damping\n"
                                "    set Model = whole model\n"
                                "    set Stiffness damping = 1e-8\n"
                                "  end\nend\n");
    check(outcome.code == 0, "the fit ends well " + outcome.errors);
    const Table table = read_csv("out/updated_numbers.csv");
    check(value(table, "damping", "identified") == 0. &&
            std::isnan(value(table, "damping", "interval_lower")),
          "a number without influence is not identified");
    check(value(table, "disc", "identified") == 1., "the others are");
    check(unbroken(outcome.output).find("the data do not identify damping") !=
            std::string::npos,
          "and the run says so");
  }

  /** Alone, such a number has an interval that ends nowhere. */
  void
  test_lone_number_without_influence()
  {
    measure_twin(0.);
    const Outcome outcome =
      run(replaced_in(brake(2.2e11, 2.7e10, 5e8), "= cea", "= updating") + R"(
subsection Scene
  subsection Damping
    set Model             = whole model
    set Stiffness damping = 1e-8
  end
end
subsection Measurement
  set Frequencies file = measured.csv
end
subsection Updating
  set Numbers = damping
  subsection Number damping
    set Entries = Scene/Damping/Stiffness damping
    set Lower   = 1e-9
    set Upper   = 1e-7
  end
end
)");
    check(outcome.code == 0, "the fit ends well " + outcome.errors);
    const Table table = read_csv("out/updated_numbers.csv");
    check(value(table, "damping", "identified") == 0. &&
            std::isnan(value(table, "damping", "interval_lower")) &&
            std::isnan(value(table, "damping", "interval_upper")),
          "a lone number without influence is not identified");
  }

  /** Components of one list move together, and the settings that are left say
   * the whole list. */
  void
  test_settings_of_lists()
  {
    std::string         data = "name,frequency_hz,weight\n";
    std::vector<double> exact;
    for (const double stiffness : {1.5e6, 3e6, 4e6})
      {
        exact.push_back(std::sqrt(stiffness) / (2. * M_PI));
        data += "," + shortest_text(exact.back()) + ",1\n";
      }
    write_text("measured.csv", data);
    const Outcome fitted = run(mass_on_spring, {"Analysis = updating"});
    check(fitted.code == 0, "components of a list are fitted " + fitted.errors);
    std::vector<std::string> settings = {"Analysis = cea"};
    std::istringstream       lines(text_of("out/updated_settings.txt"));
    for (std::string line; std::getline(lines, line);)
      if (line[0] != '#')
        settings.push_back(line);
    check(settings.size() == 2, "one line for the list: " + settings.back());
    check(run(mass_on_spring, settings).code == 0, "which is taken again");
    const Table table = read_csv("out/eigenvalues.csv");
    check(table.n_rows() == 3, "three frequencies");
    for (std::size_t r = 0; r < 3; ++r)
      check_close(table.real(r, "frequency_hz"),
                  exact[r],
                  1e-6,
                  "the settings make the fitted scene");
  }

  void
  refused(const Outcome &outcome, const std::string &part)
  {
    check(outcome.code == 2 && outcome.errors.find(part) != std::string::npos &&
            std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1,
          "refused in one line: " + outcome.errors);
  }

  /** Of pairing by shape: which of two shapes is meant must be clear. */
  void
  refuse_equal_names()
  {
    const std::string text =
      replaced_in(
        fit(), "set Tolerance", "set Pairing = shape\n  set Tolerance") +
      "subsection Measurement\n  set Shapes file = shapes.csv\n"
      "  set Points = p, q\n"
      "  subsection Point p\n    set Body = disc\n"
      "    set Position = 0.1, 0, -0.01\n    set Direction = 0, 0, 1\n  end\n"
      "  subsection Point q\n    set Body = disc\n"
      "    set Position = 0, 0.1, 0\n    set Direction = 0, 0, 1\n  end\nend\n";
    const std::string shape =
      "    -1\n    55\nMode shape\nb\nc\nd\ne\n"
      "         1         2         2         8         "
      "2         3\n         2         1         1      "
      "   1\n        900.0\n         1\n          1.0"
      "          0.0          1.0\n         2\n        "
      "  1.0          0.0          1.0\n    -1\n";
    write_text("shapes.csv", shape + shape);
    write_text("measured.csv",
               "name,frequency_hz,weight\na,900,1\nb,950,1\na,990,1\n");
    refused(run(text), "measured.csv:4: name 'a' is there twice");
    write_text("measured.csv",
               "name,frequency_hz,weight\nMode shape,900,1\nb,950,1\n"
               "c,990,1\n");
    refused(run(text), "shapes.csv: has 2 shapes called 'Mode shape'");
    write_text("measured.csv",
               "name,frequency_hz,weight\nMode shapes,900,1\nb,950,1\n"
               "c,990,1\n");
    refused(run(text), "did you mean 'Mode shape'?");
  }

  void
  test_refusals()
  {
    measure_twin(0.);
    const std::string good = text_of("measured.csv");
    for (const auto &[text, part] :
         {std::make_pair("name,frequency_hz\na,1\n", "weight"),
          {"name,frequency_hz,weight\n", "measured.csv"},
          {"name,frequency_hz,weight\na,-5,1\n", "measured.csv:2"},
          {"name,frequency_hz,weight\na,nan,1\n", "measured.csv:2"},
          {"name,frequency_hz,weight\na,5,1\n", "cannot determine"},
          {"name,frequency_hz,weight\na,900,1\nb,95000,1\nc,950,1\n",
           "measured.csv:3: frequency_hz = 95000"},
          {"name,frequency_hz,weight\nnobody,900,1\nb,5,1\nc,5,1\n",
           "no mode of the band is called 'nobody'"}})
      {
        write_text("measured.csv", text);
        refused(run(fit()), part);
      }
    refuse_equal_names();
    write_text("measured.csv", good);
    refused(run(fit(),
                {"Updating/Number disc/Entries = Scene/Body disc/Poisson "
                 "ratio",
                 "Updating/Number disc/Lower = 0.1",
                 "Updating/Number disc/Upper = 0.4"}),
            "Poisson ratio");
    refused(run(fit(), {"Updating/Number disc/Upper = 2e11"}), "Lower");
    refused(run(fit(),
                {"Updating/Number disc/Entries = Scene/Body disc/Young "
                 "modulus, Scene/Contact pad_disc/Normal stiffness per area"}),
            "neither mass nor damping nor stiffness");
    refused(run(fit(), {"Measurement/Frequencies file = nowhere.csv"}),
            "nowhere.csv");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 2, "argument: the program");
  program = argv[1];
  test_twin();
  test_confidence_intervals();
  test_identification();
  test_settings_of_lists();
  test_lone_number_without_influence();
  test_refusals();
  test_derivatives(argc, argv);
}
