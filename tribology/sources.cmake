# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Every source file of squeal_tribology, sorted.

set(SQUEAL_TRIBOLOGY_SOURCES
    source/criteria/critical_plane.cc
    source/criteria/enclosing_ball.cc
    source/criteria/multiaxial.cc
    source/damage/damage_files.cc
    source/damage/damage_table.cc
    source/damage/history_damage.cc
    source/damage/map_picture.cc
    source/damage/subsurface.cc
    source/damage/surface.cc
    source/driver/context.cc
    source/driver/run_correlation.cc
    source/driver/run_damage.cc
    source/driver/run_recorded_history.cc
    source/fatigue/accumulation.cc
    source/fatigue/damage_counter.cc
    source/fatigue/mean_stress.cc
    source/fatigue/sn_curve.cc
    source/fatigue/spectral.cc
    source/history/clipped_sine.cc
    source/history/contact_grid.cc
    source/history/csv_import.cc
    source/images/image_parameters.cc
    source/images/run_segmentation.cc
    source/images/run_synthetic_specimen.cc
    source/setup/choices.cc
    source/setup/declare.cc
    source/setup/declare_correlation.cc
    source/setup/declare_damage.cc
    source/setup/declare_history.cc
    source/setup/tribology_parameters.cc
    source/subsurface/half_space.cc)
