// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_driver_analyses_h
#define squeal_tribology_driver_analyses_h

#include <squeal/tribology/driver/context.h>

namespace squeal::tribology
{
  /** `Analysis = damage`: maps of damage and of the surface indices. */
  void run_damage(Context &context);

  /** `Analysis = recorded history`: a history file from a generator or CSV. */
  void run_recorded_history(Context &context);

  /** `Analysis = correlation`: damage maps against maps of features. */
  void run_correlation(Context &context);

  /** `Analysis = segmentation`: cracks and exfoliations of images. */
  void run_segmentation(Context &context);

  /** `Analysis = synthetic specimen`: images with known features. */
  void run_synthetic_specimen(Context &context);
} // namespace squeal::tribology

#endif
