// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_sliding_of_pad_h
#define squeal_tribology_statistics_sliding_of_pad_h

#include <squeal/results/table.h>
#include <squeal/tribology/setup/damage_parameters.h>

#include <array>
#include <string>

namespace squeal::tribology
{
  /** Where the disc slides under a pad. */
  struct PadSliding
  {
    /** Direction of length 1 in x and y; 0, 0 where it slides all round. */
    std::array<double, 2> direction{{0., 1.}};

    LeadingEdge leading_edge = LeadingEdge::lowest_y; /**< never automatic */
    bool        is_assumed   = false; /**< as neither table nor wish tells it */
    bool        is_told      = false; /**< the direction, by the table */
  };

  /**
   * The sliding direction of a damage table, from its columns sliding_x and
   * sliding_y, which are the same in all rows. Where @p wanted is automatic the
   * leading edge is the one from which that direction points away within 25
   * degrees, and the lowest y for a table without the columns. Where it names
   * an edge the direction must point away from it within 45 degrees; a table
   * without the columns, or one whose disc slides all round, takes any edge.
   *
   * Throws InputError naming @p file: for columns that are no direction, for an
   * edge that contradicts them, and for 'automatic' where no single edge leads.
   */
  PadSliding sliding_of_pad(const Table       &damage,
                            const std::string &file,
                            LeadingEdge        wanted);

  /**
   * Refuses features against another sliding direction than that of the pad:
   * the columns sliding_x and sliding_y of @p features, which lines have no
   * sign of, must lie within 5 degrees of a direction that the damage table
   * tells, and within 45 of one that a leading edge stands for. A table without
   * the columns, an edge that is assumed and a disc that slides all round
   * contradict nothing. Throws InputError naming both files.
   */
  void require_same_sliding(const PadSliding  &sliding,
                            const std::string &damage_file,
                            const Table       &features,
                            const std::string &feature_file);
} // namespace squeal::tribology

#endif
