// SPDX-License-Identifier: LGPL-2.1-or-later

// Frequency responses of the program against closed forms and direct solutions,
// reciprocity with and without friction, the universal files column by column,
// MAC of measured shapes. Arguments: the program, the folder prm.

#include <squeal/results/measured_shapes.h>
#include <squeal/results/table.h>

#include "program.h"
#include "universal_reader.h"
#include "worst.h"

#include <Eigen/LU>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  using Complex = std::complex<double>;

  std::string program, prm;

  Outcome
  run(const std::string &text, const std::vector<std::string> &settings = {})
  {
    return run_text(program, text, settings);
  }

  void
  run_well(const std::string              &text,
           const std::vector<std::string> &settings = {})
  {
    const Outcome outcome = run(text, settings);
    check(outcome.code == 0, "the run ends well " + outcome.errors);
  }

  /** Rows of one pair of points as complex numbers. */
  std::vector<Complex>
  response(const Table       &table,
           const std::string &excitation,
           const std::string &observed,
           const std::string &state = "")
  {
    std::vector<Complex> values;
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      if (table.text(r, "excitation") == excitation &&
          table.text(r, "response") == observed &&
          (state.empty() || table.text(r, "contact_state") == state))
        values.emplace_back(table.real(r, "real"), table.real(r, "imag"));
    return values;
  }

  double
  largest(const std::vector<Complex> &values)
  {
    Worst result;
    for (const Complex value : values)
      result.add(std::abs(value));
    return result.largest();
  }

  /** Largest difference over the largest value. */
  double
  difference(const std::vector<Complex> &a, const std::vector<Complex> &b)
  {
    check(a.size() == b.size() && !a.empty(), "as many values");
    Worst result;
    for (std::size_t i = 0; i < a.size(); ++i)
      result.add(std::abs(a[i] - b[i]));
    return result.largest() / largest(b);
  }

  /** Hoffmann's mass with a dashpot along the belt, observed in y and z. */
  std::string
  hoffmann(const double mu, const std::string &quantity)
  {
    const std::string file  = text_of(prm + "/minimal/hoffmann.prm");
    std::string       scene = file.substr(0, file.find("subsection Result "));
    for (const auto &[old, by] :
         std::vector<std::pair<std::string, std::string>>{
           {"= cea", "= frequency response"},
           {"output/minimal/hoffmann", "out"},
           {"= 0.5\n", "= 0.5\n    set Dashpot = 0.1\n"},
           {"coefficient = 1\n", "coefficient = " + std::to_string(mu) + "\n"}})
      scene = replaced_in(scene, old, by);
    return scene + R"(
subsection Measurement
  set Points = along, out
  subsection Point along
    set Body      = mass
    set Direction = 0, 2, 0
  end
  subsection Point out
    set Body      = mass
    set Direction = 0, 0, 1
  end
end
subsection Frequency response
  set Quantity = )" +
           quantity + R"(
  set Number   = 51
end
subsection Output
  set Plots  = false
  set Report = false
end
)";
  }

  void
  test_closed_form()
  {
    for (const auto &[quantity, power, mu] :
         {std::make_tuple("receptance", 0, .5),
          {"mobility", 1, .5},
          {"accelerance", 2, 0.}})
      {
        run_well(hoffmann(mu, quantity));
        const Table      table = read_csv("out/frequency_response.csv");
        Eigen::Matrix2cd K, C = Eigen::Matrix2cd::Zero();
        K << 2., -1. + mu * 4. / 3., -1., 2.;
        C(0, 0)                              = 0.1;
        const std::vector<std::string> names = {"along", "out"};
        for (int j = 0; j < 2; ++j)
          for (int i = 0; i < 2; ++i)
            {
              std::vector<Complex> exact;
              for (int k = 0; k <= 50; ++k)
                {
                  const Complex          s(0., 2. * M_PI * .01 * k);
                  const Eigen::Matrix2cd Q =
                    s * s * Eigen::Matrix2cd::Identity() + s * C + K;
                  exact.push_back(std::pow(s, power) * Q.inverse()(i, j));
                }
              const double error =
                difference(response(table, names[j], names[i]), exact);
              check(error <= 1e-9,
                    std::string(quantity) + " of " + names[i] +
                      " over a force at " + names[j] + " is the closed form: " +
                      std::to_string(error * 1e9) + "e-9");
            }
      }
  }

  void
  test_universal_file()
  {
    run_well(hoffmann(.5, "mobility"));
    const Table       table     = read_csv("out/frequency_response.csv");
    const std::string file      = "out/frequency_response_scene.uff";
    const auto        functions = read_universal_functions(text_of(file));
    check(functions.size() == 4, "four functions in the universal file");
    for (const auto &f : functions)
      {
        check(f.quantity == 11, "the ordinate is a velocity");
        check(f.response_direction == (f.response == "along" ? 2 : 3) &&
                f.response_node == (f.response == "along" ? 1 : 2),
              "node and direction of " + f.response);
        const auto expected = response(table, f.reference, f.response);
        check(difference(f.values, expected) <= 1e-12,
              "the universal file holds the values of the CSV, " + f.response +
                " over " + f.reference);
        check_close(f.first, 0., 1e-12, "first frequency", 1.);
        check_close(f.step, .01, 1e-9, "step of the frequency");
      }
    run_well(hoffmann(.5, "mobility"),
             {"Eigenvalues/Lowest frequency = 0.01",
              "Frequency response/Scale = logarithmic"});
    const auto uneven = read_universal_functions(text_of(file));
    check(uneven.size() == 4 && uneven[0].frequencies.size() == 51,
          "unevenly spaced frequencies are written with the values");
    check_close(uneven[0].frequencies[50], .5, 1e-5, "the last of them");

    // The reader would notice.
    const std::string good = text_of(file);
    for (const auto &[old, by, claim] :
         {std::make_tuple("    58\n", "   58\n", "a shifted number"),
          {"    -1\n    58\n", "    58\n", "a missing mark"},
          {"Frequency           ", "Frequency ", "a label that is too short"}})
      {
        bool refused = false;
        try
          {
            refused =
              read_universal_functions(replaced_in(good, old, by)).size() != 4;
          }
        catch (const std::runtime_error &)
          {
            refused = true;
          }
        check(refused, std::string("the strict reader refuses ") + claim);
      }
  }

  /** The small brake with three points. */
  std::string
  brake(const std::string &more = "")
  {
    return replaced_in(small_brake, "= cea", "= frequency response") + R"(
subsection Scene
  subsection Contact pad_disc
    set Tangential stiffness = 1e8
  end
  subsection Damping
    set Model             = whole model
    set Stiffness damping = 1e-7
    set Mass damping      = 5
  end
end
subsection Measurement
  set Points = below, far, side
  subsection Point below
    set Body      = disc
    set Position  = 0.1, 0, -0.01
    set Direction = 0, 0, 1
  end
  subsection Point far
    set Body      = disc
    set Position  = 0, 0.1, 0
    set Direction = 0, 0, -1
  end
  subsection Point side
    set Body      = pad
    set Position  = 0.1, -0.005, 0.005
    set Direction = 0, 1, 0
  end
end
subsection Frequency response
  set Number = 101
)" + more + "end\n";
  }

  void
  test_reciprocity()
  {
    for (const double mu : {0., .3})
      {
        run_well(brake(),
                 {"Scene/Contact pad_disc/Friction coefficient = " +
                  std::to_string(mu)});
        const Table  table = read_csv("out/frequency_response.csv");
        const double d     = difference(response(table, "below", "side"),
                                    response(table, "side", "below"));
        std::cout << "        mu " << mu << ": " << d << std::endl;
        if (mu == 0.)
          check(d <= 1e-9, "responses are reciprocal without friction");
        else
          check(d >= 1e-2, "friction ends reciprocity");
      }
    run_well(brake("set Contact states = stick\n"));
    const Table table = read_csv("out/frequency_response.csv");
    check(difference(response(table, "below", "side", "stick"),
                     response(table, "side", "below", "stick")) <= 1e-9,
          "responses are reciprocal with sticking contact");
  }

  /** Differences of every response over its own size at the checked
   * frequencies; the largest of them. */
  double
  worst_of_own_size()
  {
    const Table table = read_csv("out/direct_check.csv");
    std::map<std::string, std::vector<std::size_t>> rows;
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      rows[table.text(r, "contact_state") + "/" + table.text(r, "excitation") +
           "/" + table.text(r, "response")]
        .push_back(r);
    Worst worst;
    for (const auto &[name, of_one] : rows)
      {
        double squares = 0.;
        for (const std::size_t r : of_one)
          squares += std::norm(Complex(table.real(r, "direct_real"),
                                       table.real(r, "direct_imag")));
        const double size = std::sqrt(squares / of_one.size());
        for (const std::size_t r : of_one)
          {
            const double difference =
              std::hypot(table.real(r, "real") - table.real(r, "direct_real"),
                         table.real(r, "imag") - table.real(r, "direct_imag"));
            check_close(table.real(r, "difference_of_own_rel"),
                        difference / size,
                        1e-6,
                        name + ": difference over its root mean square");
            check_close(table.real(r, "difference_of_value_rel"),
                        difference / std::hypot(table.real(r, "direct_real"),
                                                table.real(r, "direct_imag")),
                        1e-4,
                        name + ": difference over the value itself");
            worst.add(difference / size);
          }
      }
    return worst.largest();
  }

  double
  worst_check()
  {
    const Table table = read_csv("out/direct_check.csv");
    Worst       worst;
    check(table.n_rows() > 0, "there are direct solutions");
    for (const double d : table.reals("difference_rel"))
      {
        // Of two solutions in two ways; also not a missing one.
        check(d > 0., "a difference to a direct solution");
        worst.add(d);
      }
    return worst.largest();
  }

  void
  test_superposition()
  {
    const std::string             states = "set Contact states = stick, full\n"
                                           "set Checks = 8\n";
    std::map<std::string, double> error;
    for (const std::string residual :
         {"none", "flexibility", "flexibility and inertia"})
      for (const std::string margin : {"1.5", "3"})
        {
          run_well(brake(states),
                   {"Frequency response/Residual = " + residual,
                    "Frequency response/Margin = " + margin});
          error[residual[0] + residual.substr(residual.size() - 1) + margin] =
            worst_check();
          std::cout << "        " << residual << ", margin " << margin << ": "
                    << worst_check() << std::endl;
        }
    check(worst_of_own_size() > 0., "differences of every response");
    check(error["fa3"] <= 1e-3,
          "superposition with both residual terms within 1e-3 of direct "
          "solutions");
    check(error["fa3"] <= .2 * error["fa1.5"],
          "with both terms twice the margin gains a factor of five");
    check(error["fy3"] <= .1 * error["ne3"] &&
            error["fa3"] <= .1 * error["fy3"],
          "each residual term gains a factor of ten");
    check(unbroken(
            run(brake(states), {"Frequency response/Residual = none"}).output)
              .find("raise 'Frequency response/Margin'") != std::string::npos,
          "a difference beyond the tolerance is warned of");
  }

  /** MAC of every measured shape with the mode most like it. */
  std::vector<double>
  best_mac(const Table &table)
  {
    std::vector<double> result;
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      if (table.integer(r, "best") == 1)
        result.push_back(table.real(r, "mac"));
    return result;
  }

  void
  test_mac()
  {
    run_well(brake());
    std::filesystem::copy_file(
      "out/frequency_response_scene.uff",
      "own.uff",
      std::filesystem::copy_options::overwrite_existing);
    const auto shapes = read_measured_shapes("own.uff");
    run_well(brake(), {"Measurement/Shapes file = own.uff"});
    const Table table = read_csv("out/mac.csv");
    const auto  own   = best_mac(table);
    check(own.size() == shapes.size() && own.size() > 5,
          "every shape of the universal file is compared");
    for (const double mac : own)
      check(mac > 1. - 1e-9, "a shape is like itself");
    for (std::size_t r = 0; r < table.n_rows(); ++r)
      if (table.integer(r, "best") == 1)
        check_close(table.real(r, "frequency_hz"),
                    table.real(r, "measured_frequency_hz"),
                    1e-4,
                    "the frequency in the file is that of the mode");

    const Table by_point = read_csv("out/comac.csv");
    check(by_point.n_rows() > 2, "every point has a COMAC");
    for (std::size_t r = 0; r < by_point.n_rows(); ++r)
      check(by_point.real(r, "comac") > 1. - 1e-9,
            "at every point the shapes are like themselves");

    write_text("shapes.csv",
               "shape,frequency_hz,point,real,imag\n"
               "a,1000,below,1,0\na,1000,far,-1,0\na,1000,side,0.5,0\n");
    run_well(brake(), {"Measurement/Shapes file = shapes.csv"});
    check(best_mac(read_csv("out/mac.csv")).size() == 1,
          "shapes are read from CSV");
    // Two shapes that no mode has: the point that is wrong in both is told.
    write_text("shapes.csv",
               "shape,frequency_hz,point,real,imag\n"
               "a,1000,below,1,0\na,1000,far,-1,0\na,1000,side,9,0\n"
               "b,1000,below,1,0\nb,1000,far,1,0\nb,1000,side,0,0\n");
    run_well(brake(), {"Measurement/Shapes file = shapes.csv"});
    const Table wrong = read_csv("out/comac.csv");
    Worst       smallest;
    for (std::size_t r = 0; r < wrong.n_rows(); ++r)
      {
        const double value = wrong.real(r, "comac");
        check(value >= 0. && value <= 1. + 1e-12, "a COMAC is a share");
        smallest.add(value);
      }
    check(smallest.smallest() < 0.99, "shapes that differ are told apart");

    const std::string good = text_of("own.uff");
    for (const auto &[text, part] :
         std::vector<std::pair<std::string, std::string>>{
           {"", "bad.uff"},
           {good.substr(0, good.size() - 200), "bad.uff:"},
           {"    -1\n    58\n", "bad.uff:"},
           {std::string("\0\1\2garbage\n", 11), "bad.uff"},
           {"shape,frequency_hz,point,real\na,1,below,1\n", "imag"},
           {"shape,frequency_hz,point,real,imag\na,1,below,nan,0\n",
            "bad.uff:2"},
           {"shape,frequency_hz,point,real,imag\na,1,elsewhere,1,0\n",
            "has point 'elsewhere', which is not in Measurement/Points"},
           {"shape,frequency_hz,point,real,imag\na,1,below,1,0\na,1,far,1,0\n"
            "a,1,Side,1,0\n",
            "did you mean 'side'?"},
           {"shape,frequency_hz,point,real,imag\na,1,below,1,0\na,2,far,1,0\n",
            "bad.uff:3: shape 'a' has another frequency above"},
           {"    -1\n    55\na\nb\nc\nd\ne\n         1         2         2  "
            "       8         x         3\n",
            "bad.uff:8"}})
      {
        write_text("bad.uff", text);
        const Outcome outcome =
          run(brake(), {"Measurement/Shapes file = bad.uff"});
        check(
          outcome.code == 2 && outcome.errors.find(part) != std::string::npos &&
            std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1,
          "a bad file is refused by one line: " + outcome.errors);
      }
  }

  /** Directions at one node that are not at right angles to each other: the
   * motion of the node is one whose signals are those of the modes. */
  void
  test_oblique_directions()
  {
    const std::string far =
      "    set Body = disc\n    set Position = 0, 0.1, 0\n"
      "    set Node = 7\n    set Direction = ";
    const std::string text =
      replaced_in(
        brake(), "Points = below, far", "Points = below, p, q, r, far") +
      "subsection Measurement\n  subsection Point far\n    set Node = 7\n"
      "  end\n  subsection Point p\n" +
      far + "1, 0, 1\n  end\n  subsection Point q\n" + far +
      "1, 2, 0\n  end\n  subsection Point r\n" + far + "0, 1, 1\n  end\nend\n";
    run_well(text);
    std::filesystem::copy_file(
      "out/frequency_response_scene.uff",
      "own.uff",
      std::filesystem::copy_options::overwrite_existing);
    run_well(text, {"Measurement/Shapes file = own.uff"});
    for (const double mac : best_mac(read_csv("out/mac.csv")))
      check(mac > 1. - 1e-9,
            "a shape seen along oblique directions is like itself");
  }

  void
  test_refusals()
  {
    const auto refused = [](const std::string              &text,
                            const std::vector<std::string> &settings,
                            const std::string              &part) {
      const Outcome outcome = run(text, settings);
      check(
        outcome.code == 2 && outcome.errors.find(part) != std::string::npos &&
          std::count(outcome.errors.begin(), outcome.errors.end(), '\n') == 1,
        "refused in one line: " + outcome.errors);
    };
    refused(brake(),
            {"Measurement/Point far/Position = 0, 0.3, 0"},
            "Measurement/Point far/Position lies outside body 'disc'");
    refused(brake(), {"Measurement/Point far/Body = wheel"}, "wheel");
    refused(brake(), {"Frequency response/Responses = nobody"}, "nobody");
    refused(brake(),
            {"Measurement/Point far/Node = 1",
             "Measurement/Point far/Direction = 0, 0, 1"},
            "Node");
    refused(brake(),
            {"Measurement/Point below/Node = 2"},
            "'Measurement/Point far/Node' = 2 is also the number of point "
            "'below'");
    refused(
      brake(), {"Frequency response/Scale = logarithmic"}, "Lowest frequency");
  }
} // namespace



int
main(int argc, char **argv)
{
  check(argc == 3, "arguments: the program, the folder prm");
  program = argv[1];
  prm     = argv[2];
  test_closed_form();
  test_universal_file();
  test_reciprocity();
  test_superposition();
  test_mac();
  test_oblique_directions();
  test_refusals();
}
