// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/output/shape_output.h>

#include <squeal/results/shape_plot.h>
#include <squeal/results/shape_writer.h>
#include <squeal/results/surface_quads.h>

#include <cmath>

namespace squeal
{
  namespace
  {
    ShapeOptions
    shape_options(const Parameters &p)
    {
      ShapeOptions options;
      options.display_scale = p.output.slip_display_scale;
      return options;
    }

    unsigned int
    disc_body(const SceneParameters &scene)
    {
      if (const unsigned int disc = main_disc(scene); disc != -1u)
        return disc;
      for (const auto &contact : scene.contacts)
        if (contact.target_body != "ground")
          return body_index(scene, contact.target_body);
      return 0;
    }

    /** The drawn picture of one unstable pair; returns its path or "". */
    std::string
    draw_pair(RunContext                     &context,
              const std::vector<SurfaceQuad> &quads,
              const double                    size,
              const std::string              &file,
              const std::string              &title,
              const std::string              &subtitle)
    {
      if (!context.is_root)
        return "";
      const SceneParameters   &scene = context.parameters.scene;
      const unsigned int       disc  = disc_body(scene);
      std::vector<std::string> names;
      for (const auto &body : scene.bodies)
        names.push_back(body.name);
      ShapePicture picture =
        make_shape_picture(quads,
                           disc,
                           context.parameters.output.slip_display_scale * size,
                           contact_face_looks_down(scene, disc),
                           names);
      picture.title    = title;
      picture.subtitle = subtitle;
      context.output.file("plots/" + file + ".png");
      const std::string path = context.output.path() + "/plots/" + file;
      return plot_shape(context.plotter, picture, path) ? path + ".png" : "";
    }
  } // namespace



  std::string
  write_mode_shapes(RunContext         &context,
                    const Model        &model,
                    const ModeSolution &solution)
  {
    const auto &p = context.parameters;
    ShapeWriter writer(
      *model.discretization(), context.output, shape_options(p));
    const Block        full  = model.linearized().expand(solution.modes.shapes);
    const unsigned int end   = solution.n_up_to(p.eigen.highest_frequency);
    unsigned int       begin = 0;
    while (begin < end &&
           solution.modes.frequency(begin) < p.eigen.lowest_frequency)
      ++begin;
    Progress     progress(context.log, "shapes", end - begin);
    std::string  first;
    unsigned int number = 0;
    for (unsigned int i = begin; i < end; ++i)
      {
        const double      f    = solution.modes.frequency(i);
        const std::string name = shape_name(++number, f, false);
        writer.write_shape(name,
                           full.col(i),
                           Block(full.rows(), 0),
                           f,
                           p.output.animation_frames);
        if (first.empty())
          first = name + ".pvd";
        progress.advance();
      }
    return first;
  }



  std::string
  write_pair_shapes(RunContext           &context,
                    const Model          &model,
                    const ComplexPairs   &pairs,
                    const PairQuantities &quantities,
                    HtmlReport           &report)
  {
    const auto &p = context.parameters;
    ShapeWriter writer(
      *model.discretization(), context.output, shape_options(p));
    const SurfaceQuads surface(*model.discretization(), 3);
    Progress           progress(context.log, "shapes", pairs.size());
    std::string        worst_name, first;
    double             worst = 0.;
    for (unsigned int i = 0; i < pairs.size(); ++i)
      {
        const bool unstable = is_unstable(pairs, i);
        progress.advance();
        if (!unstable && p.output.shapes == OutputParameters::Shapes::unstable)
          continue;
        const double      f    = pairs.frequency(i);
        const std::string name = shape_name(i + 1, f, unstable);
        const Block       re =
          model.linearized().expand(Block(pairs.right.col(i).real()));
        const Block im =
          model.linearized().expand(Block(pairs.right.col(i).imag()));
        writer.write_shape(name,
                           re,
                           im,
                           f,
                           p.output.animation_frames,
                           {{"sigma_per_s", pairs.sigma(i)}});
        if (first.empty())
          first = name + ".pvd";
        if (!unstable)
          continue;
        if (pairs.sigma(i) > worst)
          {
            worst      = pairs.sigma(i);
            worst_name = name + ".pvd";
          }
        if (!p.output.plots)
          continue;
        auto   quads   = surface.evaluate(re, im, 0.);
        double largest = largest_displacement(quads), phase = 0.;
        for (unsigned int k = 1; k < 12; ++k)
          {
            auto turned = surface.evaluate(re, im, M_PI * k / 12.);
            if (const double size = largest_displacement(turned);
                size > largest)
              {
                largest = size;
                phase   = M_PI * k / 12.;
                quads   = std::move(turned);
              }
          }
        (void)phase;
        const std::string path = draw_pair(
          context,
          quads,
          surface.size(),
          name,
          quantities.names[i].text + " at " + rounded_text(f, 5) + " Hz",
          "growth rate " + rounded_text(pairs.sigma(i), 4) +
            " 1/s, damping ratio " +
            rounded_text(100. * pairs.damping_ratio(i), 3) + " %");
        if (!path.empty())
          report.figure(path,
                        "Unstable shape " + quantities.names[i].text + " at " +
                          rounded_text(f, 5) + " Hz");
      }
    return worst_name.empty() ? first : worst_name;
  }
} // namespace squeal
