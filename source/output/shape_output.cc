// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/eigen/dense_quadratic.h>
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

    /** The disc of a picture: which body, and whether its contact face looks
     * down. */
    struct PicturedDisc
    {
      unsigned int body       = 0;
      bool         looks_down = false;
    };

    PicturedDisc
    pictured_disc(const Model &model)
    {
      if (const DiscRing *ring = model.namer().ring())
        return {model.namer().disc(), ring->other_side > ring->face};
      const SceneParameters &scene = model.discretization()->scene();
      for (const auto &contact : scene.contacts)
        if (contact.target_body != "ground")
          {
            const unsigned int body = body_index(scene, contact.target_body);
            return {body, contact_face_looks_down(scene, body)};
          }
      return {};
    }

    /** Places and motions in the directions of the disc, so that it lies flat
     * in the picture. */
    void
    lay_flat(const DiscRing &ring, std::vector<SurfaceQuad> &quads)
    {
      const auto turn = [&](std::array<double, 3> &v) {
        const dealii::Tensor<1, 3> old({v[0], v[1], v[2]});
        for (unsigned int c = 0; c < 3; ++c)
          v[c] = old * ring.directions[c];
      };
      for (SurfaceQuad &quad : quads)
        for (unsigned int i = 0; i < 4; ++i)
          {
            turn(quad.corners[i]);
            turn(quad.displacements[i]);
          }
    }

    /** The name of a direction of the disc: that of the scene along it, "-y"
     * against y, "across" or "axis" where there is none. */
    std::string
    direction_name(const DiscRing &ring, const unsigned int c)
    {
      const std::array<std::string, 3> names{{"x", "y", "z"}};
      for (unsigned int d = 0; d < 3; ++d)
        if (const double part = ring.directions[c][d];
            std::abs(part) > 1. - 1e-6)
          return part > 0. ? names[d] : "-" + names[d];
      return c == 2 ? "axis" : "across " + std::to_string(c + 1);
    }

    /** The drawn picture of one unstable pair; returns its path or "". */
    std::string
    draw_pair(RunContext              &context,
              const Model             &model,
              std::vector<SurfaceQuad> quads,
              const double             size,
              const std::string       &file,
              const std::string       &title,
              const std::string       &subtitle)
    {
      if (!context.is_root)
        return "";
      const SceneParameters   &scene = context.parameters.scene;
      const PicturedDisc       disc  = pictured_disc(model);
      std::vector<std::string> names;
      for (const auto &body : scene.bodies)
        names.push_back(body.name);
      if (const DiscRing *ring = model.namer().ring())
        lay_flat(*ring, quads);
      ShapePicture picture =
        make_shape_picture(quads,
                           disc.body,
                           context.parameters.output.slip_display_scale * size,
                           disc.looks_down,
                           names);
      if (const DiscRing *ring = model.namer().ring())
        for (unsigned int c = 0; c < 3; ++c)
          picture.directions[c] = direction_name(*ring, c);
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
    while (begin < end && !is_between(solution.modes.frequency(begin),
                                      p.eigen.lowest_frequency,
                                      p.eigen.highest_frequency))
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
        double largest = largest_displacement(quads);
        for (unsigned int k = 1; k < 12; ++k)
          {
            auto turned = surface.evaluate(re, im, M_PI * k / 12.);
            if (const double size = largest_displacement(turned);
                size > largest)
              {
                largest = size;
                quads   = std::move(turned);
              }
          }
        const std::string path = draw_pair(
          context,
          model,
          std::move(quads),
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
