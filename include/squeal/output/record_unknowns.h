// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_output_record_unknowns_h
#define squeal_output_record_unknowns_h

#include <squeal/model/model.h>
#include <squeal/results/run_record.h>

namespace squeal
{
  /** Enters the free unknowns of @p model and of each of its bodies, as
   * Model::print_summary() shows them, in @p record. Imported matrices have
   * none by body. */
  void record_unknowns(const Model &model, RunRecord &record);
} // namespace squeal

#endif
