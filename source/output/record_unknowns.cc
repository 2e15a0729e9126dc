// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/output/record_unknowns.h>

namespace squeal
{
  void
  record_unknowns(const Model &model, RunRecord &record)
  {
    record.n_dofs = model.n_unknowns();
    record.dofs_of_bodies.clear();
    if (!model.discretization())
      return;
    const std::vector<unsigned int> &of_body =
      model.discretization()->n_free_of_body();
    for (std::size_t b = 0; b < of_body.size(); ++b)
      record.dofs_of_bodies.emplace_back(model.body_names()[b], of_body[b]);
  }
} // namespace squeal
