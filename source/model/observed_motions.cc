// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/contact/contact_resultant.h>
#include <squeal/discretization/load_vector.h>
#include <squeal/model/observed_motions.h>
#include <squeal/model/pressed_model.h>
#include <squeal/scene/layer_mesh.h>

#include <numeric>
#include <set>

namespace squeal
{
  namespace
  {
    /** @p body and all that ties and springs join it to. */
    std::set<std::string>
    joined_bodies(const SceneParameters &scene, const std::string &body)
    {
      std::set<std::string> joined = {body};
      const auto join = [&](const std::string &a, const std::string &b) {
        if (joined.count(a) == joined.count(b))
          return false;
        joined.insert(a);
        joined.insert(b);
        return true;
      };
      for (bool grows = true; grows;)
        {
          grows = false;
          for (const auto &[a, b] : glued_bodies(scene))
            grows = join(a, b) || grows;
          for (const auto &spring : scene.springs)
            if (spring.other_body != "ground")
              grows = join(spring.body, spring.other_body) || grows;
        }
      return joined;
    }

    /** The load that presses a pair on: of those on the source and on what it
     * is joined to, else of all, the one whose force against the normal is
     * largest. Null without loads. */
    const LoadParameters *
    pressing_load(const SceneParameters &scene, const ContactPair &pair)
    {
      const auto n      = mean_frame(pair.geometry).normal;
      const auto joined = joined_bodies(scene, pair.parameters.source_body);
      const LoadParameters *best = nullptr;
      double                most = 0.;
      for (const bool only_joined : {true, false})
        for (const auto &load : scene.loads)
          {
            if (best && !only_joined && joined.count(best->body) > 0)
              continue;
            if (only_joined && joined.count(load.body) == 0)
              continue;
            const double force = -(n[0] * load.force[0] + n[1] * load.force[1] +
                                   n[2] * load.force[2]);
            if (!best || force > most)
              {
                best = &load;
                most = force;
              }
          }
      return best;
    }

    /** Mean motion of the face of @p load against its force. */
    Block
    motion_against(const Discretization &d,
                   const PointEvaluator &evaluator,
                   LoadParameters        load)
    {
      const double size = std::sqrt(load.force[0] * load.force[0] +
                                    load.force[1] * load.force[1] +
                                    load.force[2] * load.force[2]);
      if (!(size > 0.))
        return Block::Zero(d.space()->n_owned(), 1);
      for (double &component : load.force)
        component /= -size;
      return load_vector(d, evaluator, load);
    }



    /** Those of one pair. */
    void
    add_observers(const Discretization &d,
                  const PointEvaluator &evaluator,
                  const ContactPair    &pair,
                  const BodyMatrices   &body,
                  Eigen::Ref<Block>     l)
    {
      const auto        &scene = d.scene();
      const auto        &g     = pair.geometry;
      const RowSpace    &space = *d.space();
      const unsigned int source =
        body_index(scene, pair.parameters.source_body);
      const double area = std::accumulate(g.areas.begin(), g.areas.end(), 0.);
      const auto centre = evaluator.displacements(source, {body.centre}, 1e-4);
      for (unsigned int c = 0; c < 3; ++c)
        add_functional(
          space, centre.rows[0][c], 1., l.col(PressedModel::centre_x + c));
      // The far face may be inside, tied to another body: the contact nodes
      // mirrored at the centre of the source.
      std::vector<dealii::Point<3>> mirrored;
      for (std::size_t j = 0; j < g.points.size(); ++j)
        {
          const auto &n = g.frames[j].normal;
          mirrored.push_back(g.points[j] +
                             2. * ((body.centre - g.points[j]) * n) * n);
        }
      const auto far = evaluator.displacements(source, mirrored, 1e-4);
      for (std::size_t j = 0; j < g.points.size(); ++j)
        for (unsigned int c = 0; c < 3; ++c)
          if (const double n = g.frames[j].normal[c]; n != 0.)
            {
              const double share = n * g.areas[j] / area;
              add_functional(space,
                             g.target_rows[j][c],
                             share,
                             l.col(PressedModel::target_at_contact));
              add_functional(space,
                             far.found[j] ? far.rows[j][c] : centre.rows[0][c],
                             share,
                             l.col(PressedModel::far_face));
            }
      if (const LoadParameters *load = pressing_load(scene, pair))
        l.col(PressedModel::loaded_face) = motion_against(d, evaluator, *load);
    }
  } // namespace



  void
  add_functional(const RowSpace             &space,
                 const Functionals::Row     &row,
                 const double                factor,
                 Eigen::Ref<Eigen::VectorXd> column)
  {
    const auto first = space.first_owned(), n = space.n_owned();
    for (const auto &[r, weight] : row)
      if (r >= first && r < first + n)
        column[r - first] += factor * weight;
  }



  Block
  observed_motions(const Discretization            &d,
                   const ContactNodes              &nodes,
                   const std::vector<BodyMatrices> &bodies)
  {
    const PointEvaluator evaluator(d);
    const unsigned int   n = PressedModel::n_observers;
    Block l = Block::Zero(d.space()->n_owned(), n * nodes.pairs().size());
    for (std::size_t i = 0; i < nodes.pairs().size(); ++i)
      {
        const ContactPair &pair = nodes.pairs()[i];
        Block              part = Block::Zero(l.rows(), n);
        add_observers(
          d,
          evaluator,
          pair,
          bodies[body_index(d.scene(), pair.parameters.source_body)],
          part);
        l.middleCols(n * i, n) = part;
      }
    return l;
  }
} // namespace squeal
