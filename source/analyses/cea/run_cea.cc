// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/output/matrix_output.h>
#include <squeal/output/moving_pictures.h>
#include <squeal/output/shape_output.h>

#include <squeal/analyses/analyses.h>
#include <squeal/base/exceptions.h>
#include <squeal/base/worst_of.h>
#include <squeal/eigen/direct_solver.h>
#include <squeal/model/adaptive_cea.h>
#include <squeal/model/frequency_pencil.h>
#include <squeal/model/linear_solver.h>
#include <squeal/model/rotor_symmetry.h>
#include <squeal/model/turning_modes.h>
#include <squeal/output/cea_quantities.h>
#include <squeal/output/headline_error.h>
#include <squeal/output/open_signs.h>
#include <squeal/output/record_unknowns.h>
#include <squeal/results/compare.h>
#include <squeal/results/plots.h>

#include <sstream>

namespace squeal
{
  namespace
  {
    std::vector<PlottedPair>
    plotted_pairs(const ComplexPairs   &pairs,
                  const PairQuantities &q,
                  const OpenSigns      &open)
    {
      std::vector<PlottedPair> result;
      for (unsigned int i = 0; i < pairs.size(); ++i)
        {
          PlottedPair pair;
          pair.sigma                = pairs.sigma(i);
          pair.frequency            = pairs.frequency(i);
          pair.name                 = q.names[i].text;
          pair.is_unstable          = is_unstable(pairs, i);
          pair.is_open              = open.is_open[i];
          pair.residual             = pairs.residual[i];
          pair.error_estimate       = pairs.error_estimate[i];
          pair.discretisation_error = q.discretisation_error[i];
          for (Eigen::Index b = 0; b < q.energy_shares.rows(); ++b)
            pair.energy_shares.push_back(q.energy_shares(b, i));
          result.push_back(pair);
        }
      return result;
    }

    void
    draw_charts(RunContext                         &context,
                const Model                        &model,
                const std::vector<PlottedPair>     &pairs,
                const std::vector<BasisEnrichment> &history,
                HtmlReport                         &report)
    {
      if (!context.is_root)
        return;
      const auto &p    = context.parameters.eigen;
      const auto  path = [&](const std::string &name) {
        context.output.file("plots/" + name + ".png");
        return context.output.path() + "/plots/" + name;
      };
      const auto &plotter = context.plotter;
      report.section("Charts");
      plot_spectrum(plotter, pairs, path("spectrum"));
      report.figure(path("spectrum") + ".png", "Complex eigenvalues", true);
      plot_damping_chart(
        plotter, pairs, p.damping_threshold_percent, path("damping"));
      report.figure(path("damping") + ".png", "Damping ratio", true);
      plot_energy_shares(
        plotter, model.body_names(), pairs, path("energy_shares"));
      report.figure(path("energy_shares") + ".png",
                    "Energy by body; growing pairs in orange",
                    true);
      plot_error_estimates(plotter,
                           pairs,
                           p.residual_tolerance,
                           p.error_tolerance,
                           path("errors"));
      report.figure(path("errors") + ".png", "Error of every pair", true);
      std::vector<EnrichmentStep> steps;
      for (const auto &step : history)
        steps.push_back(
          {step.basis_size, step.worst_residual, step.worst_estimate});
      plot_enrichment_decay(
        plotter, steps, p.residual_tolerance, p.error_tolerance, path("basis"));
      report.figure(path("basis") + ".png", "Certified basis", true);
    }

    void
    write_signature(RunContext         &context,
                    const Model        &model,
                    const ComplexPairs &pairs)
    {
      const auto signature = model.namer().signature();
      if (!signature)
        return;
      ComplexBlock full = model.linearized()
                            .expand(Block(pairs.right.real()))
                            .cast<std::complex<double>>();
      full.imag() = model.linearized().expand(Block(pairs.right.imag()));
      const Eigen::MatrixXcd samples = signature->apply(full);
      std::vector<long long> indices;
      std::vector<Signature> rows;
      for (Eigen::Index j = 0; j < samples.cols(); ++j)
        {
          indices.push_back(j + 1);
          rows.emplace_back(samples.col(j).data(),
                            samples.col(j).data() + samples.rows());
        }
      context.write_table(
        "signature.csv",
        make_signature_table(indices, model.namer().signature_entries(), rows));
    }



    /** The pairs with sigma > 0, in words too. */
    struct UnstablePairs
    {
      std::vector<bool> is_unstable; /**< one a pair */
      unsigned int      number = 0;
      std::string       text; /**< names, frequencies, growth rates */
      /** Whether these are all pairs of the band. */
      bool is_complete = true;

      std::string
      verdict() const
      {
        if (!is_complete)
          return (number == 0 ? "none" : std::to_string(number)) + " of the " +
                 std::to_string(is_unstable.size()) + " pairs found " +
                 (number > 1 ? "are" : "is") + " unstable" +
                 (number == 0 ? "" : ": " + text) +
                 "; others of the band may be";
        if (number == 0)
          return "no unstable pair in the band";
        return number == 1
                 ? "1 unstable pair: " + text
                 : std::to_string(number) + " unstable pairs: " + text;
      }
    };



    /** The eigenvalues of direct_check.csv that have no certified one. */
    Eigen::VectorXcd
    pairs_without_certified(const Table &checks)
    {
      std::vector<std::complex<double>> lambda;
      for (std::size_t r = 0; r < checks.n_rows(); ++r)
        if (checks.is_missing(r, "frequency_hz"))
          lambda.emplace_back(checks.real(r, "direct_sigma_per_s"),
                              2. * M_PI *
                                checks.real(r, "direct_frequency_hz"));
      return Eigen::Map<const Eigen::VectorXcd>(lambda.data(), lambda.size());
    }



    /** Whether no pair of the band is missing. Moduli over frequency take the
     * basis whatever solver is asked for. */
    bool
    is_complete(const CeaSolution &solution)
    {
      return solution.basis_size > 0;
    }



    UnstablePairs
    unstable_pairs(const CeaSolution    &solution,
                   const PairQuantities &quantities)
    {
      const ComplexPairs &pairs = solution.pairs;
      UnstablePairs       result;
      result.is_complete = is_complete(solution);
      for (unsigned int i = 0; i < pairs.size(); ++i)
        {
          result.is_unstable.push_back(is_unstable(pairs, i));
          if (!result.is_unstable.back())
            continue;
          ++result.number;
          result.text += (result.text.empty() ? "" : "; ") +
                         quantities.names[i].text + " at " +
                         rounded_text(pairs.frequency(i), 5) + " Hz, sigma " +
                         rounded_text(pairs.sigma(i), 4) + " 1/s";
        }
      return result;
    }



    void
    log_eigenvalues(RunLog &log, const Table &table, const bool with_names)
    {
      log.heading("Eigenvalues: lambda = sigma + i omega, sigma > 0 "
                  "unstable, f = omega / 2 pi, zeta = -sigma / |lambda|");
      if (with_names)
        log.info(explanation_of_names());
      std::ostringstream text;
      table.print(text,
                  {"index",
                   "frequency_hz",
                   "sigma_per_s",
                   "unstable",
                   "name",
                   "damping_ratio",
                   "residual_rel",
                   "error_estimate_rel",
                   "discretisation_error_rel"});
      log.info(text.str());
    }



    /** What of the basis of the band is proven. */
    std::string
    completeness_text(const EigenParameters &p,
                      const CeaSolution     &solution,
                      const ModeSolution    &modes)
    {
      if (!is_complete(solution))
        return "none: the direct solver has the pairs nearest to its shift";
      return "inertia, all " + std::to_string(modes.modes.n_certified) +
             " undamped modes below " +
             rounded_text(std::sqrt(modes.inverse->shift()) / (2. * M_PI), 6) +
             " Hz are in the basis" +
             (solution.lowest_frequency > p.lowest_frequency
                ? ", pairs from " + rounded_text(solution.lowest_frequency, 4) +
                    " Hz on"
                : "");
    }



    /** Of a band in which @p unstable grow: open where every one of them, or one
     * that decays, may be of the other kind on a finer mesh, and where pairs
     * may be missing. */
    HtmlReport::Verdict
    verdict_on(const UnstablePairs &unstable,
               const bool           grows_elsewhere,
               const OpenSigns     &open)
    {
      if (grows_elsewhere || unstable.number > open.n_growing)
        return HtmlReport::Verdict::bad;
      return open.any() || !unstable.is_complete ? HtmlReport::Verdict::neutral
                                                 : HtmlReport::Verdict::good;
    }



    std::string
    largest_error(const Model        &model,
                  const ComplexPairs &pairs,
                  const Table        &table)
    {
      std::vector<ErrorSource> sources = {
        {"reduction", worst_of(pairs.error_estimate)}};
      if (has_mesh_error(model))
        sources.push_back(
          error_of_column("mesh", table, "discretisation_error_rel"));
      return headline_error(sources);
    }

    /** Writes the direct pairs beside the certified ones and says what these
     * miss. The certified pairs stand without them: where the direct solver
     * does not converge, the run goes on and warns. */
    std::string
    compare_directly(RunContext         &context,
                     const Model        &model,
                     const ModeSolution &modes,
                     const ComplexPairs &pairs)
    {
      try
        {
          const Table checks = compare_with_direct(
            model, modes, pairs, context.log, context.timers);
          context.write_table("direct_check.csv", checks);
          return text_of_missing(pairs_without_certified(checks));
        }
      catch (const ComputationError &e)
        {
          context.log.warning(
            std::string("the certified pairs are not compared: ") + e.what());
          return "";
        }
    }
  } // namespace



  void
  run_cea(RunContext &context)
  {
    const auto &p = context.parameters;
    Model       model(p, context.timers);
    model.print_summary(context.log);
    warn_of_frozen_rotors(model, context.log);
    Table     steps = mesh_steps_table();
    MeshedCea cea =
      solve_cea_adaptively(model, context.log, context.timers, &steps);
    ModeSolution &modes = cea.modes;
    if (const std::string text = beyond_critical_speed(model, modes);
        !text.empty())
      context.log.warning(text);
    if (p.output.export_matrices)
      {
        write_matrices(context, *modes.pencil, "matrices");
        write_matrix_parts(context, model.linearized().system, "matrices");
      }
    const CeaSolution  &solution = cea.solution;
    const ComplexPairs &pairs    = solution.pairs;
    if (steps.n_rows() > 0)
      context.write_table("meshes.csv", steps);
    context.write_table("modes.csv", mode_table(model, modes));

    PairQuantities quantities;
    {
      Timers::Section section(context.timers, "Solve: names and indices");
      quantities            = pair_quantities(model, modes, pairs);
      quantities.mesh_error = cea.errors.lambda;
    }
    const Table table = eigenvalue_table(model, modes, pairs, quantities);
    context.write_table("eigenvalues.csv", table);
    const std::string moduli = moduli_text(p.scene, pairs);
    if (!moduli.empty())
      context.write_table("moduli.csv", moduli_table(p.scene, pairs));
    const std::string missing =
      p.eigen.compare_direct ? compare_directly(context, model, modes, pairs)
                             : "";
    write_signature(context, model, pairs);
    if (p.output.export_matrices)
      write_eigenpairs(context, *modes.pencil->space(), pairs, "matrices");

    log_eigenvalues(context.log, table, model.namer().n_coordinates() > 0);
    const UnstablePairs unstable = unstable_pairs(solution, quantities);
    const std::string   below    = text_below_band(solution, p.eigen),
                      left_out   = text_of_growth_left_out(solution),
                      elsewhere  = text_of_growth_outside(solution, p.eigen),
                      outside =
                        elsewhere +
                        (elsewhere.empty() || missing.empty() ? "" : "; ") +
                        missing;
    warn_of_growth_outside(solution, p.eigen, "", context.log);
    const OpenSigns open = open_signs(table);
    if (open.any())
      context.log.warning(open.text +
                          ": refine the mesh, raise 'Discretization/Degree' or "
                          "let 'Discretization/Refinement' do it");
    record_unknowns(model, context.record);
    context.record.figures = {
      {"unstable pairs", std::to_string(unstable.number)},
      {"which", unstable.number ? unstable.text : "none"},
      {unstable.is_complete ? "pairs in the band" : "pairs found",
       std::to_string(pairs.size())},
      {"worst residual", rounded_text(worst_of(pairs.residual), 2)},
      {"largest error of a pair, relative", largest_error(model, pairs, table)},
      {"worst error estimate of the reduction",
       unstable.is_complete ? rounded_text(worst_of(pairs.error_estimate), 2)
                            : "not estimated"},
      {"unknowns", std::to_string(model.n_unknowns())},
      {"basis", std::to_string(solution.basis_size)},
      {"completeness", completeness_text(p.eigen, solution, modes)},
      {"linear solver", linear_solver_text(*modes.inverse)}};
    if (open.any())
      context.record.figures.push_back(
        {"growth left open by the mesh",
         std::to_string(open.n_growing + open.n_decaying) + " pairs"});
    if (!below.empty())
      context.record.figures.push_back({"below the band", below});
    if (!left_out.empty())
      context.record.figures.push_back({"left out", left_out});
    if (!missing.empty())
      context.record.figures.insert(context.record.figures.begin() + 1,
                                    {"missing", missing});
    if (!moduli.empty())
      context.record.figures.push_back(
        {"moduli at the frequencies of the pairs", moduli});

    HtmlReport report("Complex eigenvalue analysis of " + p.scene.name,
                      "lambda = sigma + i omega, sigma > 0 unstable");
    report.set_verdict(
      verdict_on(unstable, !outside.empty(), open),
      unstable.verdict() + (outside.empty() ? "" : "; " + outside) +
        (open.any() ? "; " + open.text : "") +
        "; largest error of a pair: " + largest_error(model, pairs, table),
      context.record.figures);
    if (p.output.plots)
      {
        Timers::Section section(context.timers, "Write: charts");
        draw_charts(context,
                    model,
                    plotted_pairs(pairs, quantities, open),
                    solution.history,
                    report);
      }
    std::string open_this;
    if (p.output.shapes != OutputParameters::Shapes::none &&
        model.discretization() && model.discretization()->has_mesh())
      {
        Timers::Section section(context.timers, "Write: shapes");
        report.section(unstable.number ? "Unstable shapes" : "Shapes");
        show_pairs(context, model, pairs, quantities, report);
        open_this =
          write_pair_shapes(context, model, pairs, quantities, report);
      }
    if (steps.n_rows() > 0)
      {
        report.section("Meshes");
        report.table(steps, "Meshes, refined where the growth rates need it");
      }
    report.section("Eigenvalues");
    report.table(table,
                 unstable.is_complete ? "Pairs in the band" : "Pairs found",
                 {},
                 unstable.is_unstable);
    if (model.namer().n_coordinates() > 0)
      report.paragraph(explanation_of_names());
    context.finish(p.output.report ? &report : nullptr, open_this);
  }
} // namespace squeal
