// SPDX-License-Identifier: LGPL-2.1-or-later

#include <squeal/base/dense_decompositions.h>

#ifdef SQUEAL_DENSE_DECOMPOSITIONS
SQUEAL_DENSE_KERNELS(template)
SQUEAL_DENSE_REFLECTIONS(template)
SQUEAL_DENSE_DECOMPOSITIONS(template)
#endif
