// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/base/run_log.h>
#include <squeal/eigen/dense_quadratic.h>
#include <squeal/output/moving_pictures.h>
#include <squeal/results/motion_view.h>

#include <algorithm>
#include <numeric>

namespace squeal
{
  namespace
  {
    constexpr std::size_t most_motions = 8;
    /** Quads of a page at most, if they are no fewer anyway: 16 bits for each
     * of nine numbers of a point and a motion are some 24 bytes in a page. */
    constexpr std::size_t most_quads = 12000;

    bool
    can_be_shown(const RunContext &context, const Model &model)
    {
      return context.parameters.output.report && model.discretization() &&
             model.discretization()->has_mesh() &&
             !MotionView::script().empty();
    }

    /** Collective; the same on every rank. */
    std::size_t
    n_quads(const Discretization &d, const SurfaceQuads &surface)
    {
      Eigen::MatrixXd number(1, 1);
      number(0, 0) = static_cast<double>(
        surface.evaluate(Block::Zero(d.space()->n_owned(), 1)).size());
      d.space()->sum(number);
      return static_cast<std::size_t>(number(0, 0));
    }

    /** The surfaces in as many pieces as a page can hold. */
    SurfaceQuads
    surfaces_of(const Discretization &d)
    {
      const std::size_t coarse = n_quads(d, SurfaceQuads(d, 1));
      return {d,
              coarse > most_quads / 4   ? 1u
              : coarse > most_quads / 9 ? 2u
                                        : 3u};
    }

    MotionView
    view_of(const RunContext               &context,
            const std::vector<SurfaceQuad> &quads,
            const double                    size)
    {
      std::vector<std::string> bodies;
      for (const auto &body : context.parameters.scene.bodies)
        bodies.push_back(body.name);
      return {
        quads, bodies, context.parameters.output.slip_display_scale * size};
    }

    void
    add(const RunContext  &context,
        const MotionView  &view,
        const std::string &caption,
        HtmlReport        &report)
    {
      if (context.is_root && view.n_motions() > 0)
        report.interactive(view.markup(caption, ""), MotionView::script());
    }

    const char how[] =
      " Drag to turn, wheel to come nearer, double click to go back.";
  } // namespace



  void
  show_pairs(RunContext           &context,
             const Model          &model,
             const ComplexPairs   &pairs,
             const PairQuantities &quantities,
             HtmlReport           &report)
  {
    if (!can_be_shown(context, model) || pairs.size() == 0)
      return;
    std::vector<unsigned int> shown;
    for (unsigned int i = 0; i < pairs.size(); ++i)
      if (is_unstable(pairs, i))
        shown.push_back(i);
    const bool any = !shown.empty();
    if (any)
      std::stable_sort(
        shown.begin(), shown.end(), [&](const auto a, const auto b) {
          return pairs.sigma(a) > pairs.sigma(b);
        });
    else
      {
        shown.resize(pairs.size());
        std::iota(shown.begin(), shown.end(), 0u);
      }
    shown.resize(std::min(shown.size(), most_motions));

    const SurfaceQuads          surface = surfaces_of(*model.discretization());
    std::unique_ptr<MotionView> view;
    for (const unsigned int i : shown)
      {
        const auto quads = [&](const Eigen::VectorXd &part) {
          return surface.evaluate(model.linearized().expand(Block(part)));
        };
        const auto real      = quads(pairs.right.col(i).real()),
                   imaginary = quads(pairs.right.col(i).imag());
        if (!view)
          view = std::make_unique<MotionView>(
            view_of(context, real, surface.size()));
        if (context.is_root)
          view->add_harmonic(quantities.names[i].text + ", " +
                               rounded_text(pairs.frequency(i), 5) +
                               " Hz, sigma " + rounded_text(pairs.sigma(i), 4) +
                               " 1/s",
                             real,
                             imaginary);
      }
    add(
      context,
      *view,
      std::string(any ? "Growing pairs, loudest first" : "Pairs of the band") +
        ", over one period; growth is not drawn." + how,
      report);
  }



  void
  show_modes(RunContext         &context,
             const Model        &model,
             const ModeSolution &solution,
             HtmlReport         &report)
  {
    if (!can_be_shown(context, model))
      return;
    const auto                 &p       = context.parameters.eigen;
    const SurfaceQuads          surface = surfaces_of(*model.discretization());
    std::unique_ptr<MotionView> view;
    for (unsigned int i = 0; i < solution.n_up_to(p.highest_frequency); ++i)
      {
        const double f = solution.modes.frequency(i);
        if (!is_between(f, p.lowest_frequency, p.highest_frequency) ||
            (view && view->n_motions() == most_motions))
          continue;
        const auto real = surface.evaluate(
          model.linearized().expand(Block(solution.modes.shapes.col(i))));
        auto imaginary = real;
        for (SurfaceQuad &quad : imaginary)
          quad.displacements = {};
        if (!view)
          view = std::make_unique<MotionView>(
            view_of(context, real, surface.size()));
        view->add_harmonic(rounded_text(f, 5) + " Hz", real, imaginary);
      }
    if (view)
      add(context, *view, std::string("Modes of the band.") + how, report);
  }



  void
  show_frames(RunContext        &context,
              const Model       &model,
              const Block       &motion,
              const std::string &name,
              HtmlReport        &report)
  {
    if (!can_be_shown(context, model) || motion.cols() < 2)
      return;
    const SurfaceQuads surface = surfaces_of(*model.discretization());
    std::vector<std::vector<SurfaceQuad>> frames;
    const Eigen::VectorXd                 mean = motion.rowwise().mean();
    for (Eigen::Index k = 0; k < motion.cols(); ++k)
      frames.push_back(surface.evaluate(Block(motion.col(k) - mean)));
    MotionView view = view_of(context, frames[0], surface.size());
    view.add_frames(name, frames);
    add(context,
        view,
        name + ", deviation from the mean, over and over again." + how,
        report);
  }
} // namespace squeal
