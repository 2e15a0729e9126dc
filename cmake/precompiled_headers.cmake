# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Headers of libraries that most compile units read: more than half of a unit's
# time went into them. They are compiled once, for the core and once more with
# OpenCV for tribology. Every file still includes what it uses: with
# SQUEAL_PRECOMPILED_HEADERS off the same sources build.

option(SQUEAL_PRECOMPILED_HEADERS "Compile headers of libraries once" ON)

set(SQUEAL_CORE_HEADERS
    <algorithm> <array> <cmath> <complex> <filesystem> <fstream> <functional>
    <map> <memory> <optional> <set> <sstream> <string> <vector>
    <Eigen/Dense>
    <deal.II/base/mpi.h>
    <deal.II/base/quadrature_lib.h>
    <deal.II/distributed/tria.h>
    <deal.II/dofs/dof_handler.h>
    <deal.II/fe/fe_values.h>
    <deal.II/lac/affine_constraints.h>
    <squeal/base/dense_decompositions.h>)
set(SQUEAL_TRIBOLOGY_HEADERS <opencv2/core.hpp> <opencv2/imgproc.hpp>)

# squeal_precompile(target header...): makes them once for this target.
function(squeal_precompile target)
  if(SQUEAL_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()

# squeal_share_precompiled(target owner): takes those of another target.
function(squeal_share_precompiled target owner)
  if(SQUEAL_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} REUSE_FROM ${owner})
  endif()
endfunction()
