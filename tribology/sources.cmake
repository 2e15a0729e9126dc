# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Every source file of squeal_tribology, sorted.

set(SQUEAL_TRIBOLOGY_SOURCES
    source/driver/context.cc
    source/driver/run_correlation.cc
    source/driver/run_damage.cc
    source/driver/run_recorded_history.cc
    source/fatigue/accumulation.cc
    source/fatigue/damage_counter.cc
    source/fatigue/mean_stress.cc
    source/fatigue/sn_curve.cc
    source/fatigue/spectral.cc
    source/images/areas.cc
    source/images/centre_line.cc
    source/images/crack_finder.cc
    source/images/crack_growth.cc
    source/images/crack_width.cc
    source/images/image_parameters.cc
    source/images/metadata.cc
    source/images/micrograph.cc
    source/images/ridge_filter.cc
    source/images/run_segmentation.cc
    source/images/run_synthetic_specimen.cc
    source/images/specimen.cc
    source/images/specimen_shapes.cc
    source/setup/choices.cc
    source/setup/declare.cc
    source/setup/declare_correlation.cc
    source/setup/declare_damage.cc
    source/setup/declare_history.cc
    source/setup/tribology_parameters.cc)
