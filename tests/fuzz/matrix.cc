// SPDX-License-Identifier: LGPL-2.1-or-later

// Matrices of other codes; FORMAT is market, abaqus or nastran.
#include <squeal/scene/matrix_import.h>

#include "fuzz.h"

using namespace squeal;

namespace
{
  using Format                   = MatrixPartParameters::Format;
  constexpr Format matrix_market = Format::matrix_market;
  constexpr Format abaqus        = Format::abaqus;
  constexpr Format nastran       = Format::nastran;
} // namespace

extern "C" int
LLVMFuzzerTestOneInput(const std::uint8_t *data, const std::size_t size)
{
  return fuzz::read_as("in.mtx", data, size, [&](const std::string &path) {
    MatrixPartParameters part;
    part.name   = "part";
    part.file   = path;
    part.format = size % 2 == 0 ? FORMAT : Format::automatic;
    part.role   = size % 4 < 2 ? MatrixPartParameters::Role::stiffness
                               : MatrixPartParameters::Role::friction;
    const ImportedMatrix matrix = read_matrix(part);
    fuzz::require_finite(matrix.values, "an entry");
    fuzz::require(matrix.rows.size() == matrix.values.size() &&
                    matrix.columns.size() == matrix.values.size(),
                  "arrays of different sizes");
    for (std::size_t i = 0; i < matrix.rows.size(); ++i)
      fuzz::require(matrix.rows[i] < matrix.n && matrix.columns[i] < matrix.n,
                    "an entry outside the matrix");
    fuzz::require(matrix.labels.empty() || matrix.labels.size() == matrix.n,
                  "another number of labels than of rows");
  });
}
