# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Every source file of the library, one sorted list a layer. A layer uses itself
# and the layers above it in this file; .ci/check_layers looks after that and
# after files that are missing here.

set(SQUEAL_SOURCES_BASE)

set(SQUEAL_SOURCES_PARAMETERS)

set(SQUEAL_SOURCES_SCENE)

set(SQUEAL_SOURCES_DISCRETIZATION)

set(SQUEAL_SOURCES_CONTACT)

set(SQUEAL_SOURCES_EIGEN)

set(SQUEAL_SOURCES_TRANSIENT)

set(SQUEAL_SOURCES_RESULTS)

set(SQUEAL_SOURCES_DRIVER)

set(SQUEAL_SOURCES
    ${SQUEAL_SOURCES_BASE}
    ${SQUEAL_SOURCES_PARAMETERS}
    ${SQUEAL_SOURCES_SCENE}
    ${SQUEAL_SOURCES_DISCRETIZATION}
    ${SQUEAL_SOURCES_CONTACT}
    ${SQUEAL_SOURCES_EIGEN}
    ${SQUEAL_SOURCES_TRANSIENT}
    ${SQUEAL_SOURCES_RESULTS}
    ${SQUEAL_SOURCES_DRIVER})
