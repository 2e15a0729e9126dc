// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_statistics_pad_tables_h
#define squeal_tribology_statistics_pad_tables_h

#include <squeal/tribology/history/contact_grid.h>
#include <squeal/tribology/statistics/link_test.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace squeal::tribology
{
  /** Indices and features of one pad on its nodal cells. */
  struct PadMaps
  {
    std::unique_ptr<ContactGrid>   grid;
    std::map<std::string, GridMap> indices;
    std::map<std::string, GridMap> features; /**< NaN where not looked at */
    GridMap                        seen;     /**< area of features, m^2 */
    GridMap                        coverage; /**< part of each cell seen */
    /** Of the cracks in each cell, m, NaN where not looked at; empty where the
     * table tells no density of cracks or no feature is a mean along them. */
    GridMap      crack_length;
    SharedCauses causes; /**< taken out of both */
    /** Spacing of the features' cells over that of the nodes; NaN where the
     * features lie at nodes or on no even lattice. */
    double coarseness = NAN;
    bool   is_silent  = false;
    /** Whether neither the table nor the parameters tell the leading edge. */
    bool is_edge_assumed = false;
    /** Whether the features lie on the face both as they stand and counted from
     * its centre, and are taken as they stand. */
    bool is_place_assumed = false;
    /** Whether a row of the features that counts is of made images, by a column
     * "synthetic" that is positive there. */
    bool is_synthetic = false;
    /** Columns of the features that hold no numbers and are left out. */
    std::vector<std::string> texts;
    /** Covariates that have one value in all known cells: they take nothing
     * out. */
    std::vector<std::string> constant_covariates;
    /** Rows of features at one place with other values, in words; empty where
     * there are none. */
    std::string doubled_rows;
  };

  /**
   * Reads a damage table and a table of features for each pad, see
   * read_whole_csv(). Rows of features
   * are shared among the nodal cells by area, see share_rows(); several rows in
   * a cell count with the area of it that each of them has seen, widths and
   * directions of cracks with the length of the cracks there. Of a table
   * with a column "image" only the rows "pad" count, and there must be some.
   * The damage table must cover a rectangular grid. Columns that are covariates
   * are shared causes, and neither indices nor features; of a name that both
   * tables have both columns are. The leading edge is
   * that of each table, see sliding_of_pad(). Throws InputError for a missing
   * column, for a table without rows, for a density of cracks below 0, for a
   * feature or covariate that is no finite number, see
   * columns_of_texts(), for a place that lies in no cell, for a coverage that
   * is no part of a cell and for 'crack_along_sliding' against another
   * direction than that of the damage table, see require_same_sliding().
   */
  std::vector<PadMaps> read_pads(const CorrelationParameters &parameters);

  /** One index against one feature on one pad. */
  struct PadLink
  {
    std::size_t pad = 0;
    std::string index, feature;
    LinkTest    test;
  };

  /** All links with their verdicts: Holm's adjustment and the number of
   * surrogates take all of them together. Cells below the least coverage do not
   * count. */
  std::vector<PadLink> link_pads(const std::vector<PadMaps>  &pads,
                                 const CorrelationParameters &parameters);

  /** Links that few cells bear and those of which nothing can be said: one line
   * for each feature or index of a pad, with the reason. */
  std::vector<std::string> warnings_of_weak_links(
    const std::vector<PadLink> &links);

  /** Pads with cells that are seen too little to count in links. */
  std::vector<std::string> warnings_of_thin_cells(
    const std::vector<PadMaps>  &pads,
    const CorrelationParameters &parameters);

  /** Pads whose features lie on cells that are more than half as large again
   * as those of the nodes: each counts at the nodes next to its centre. */
  std::vector<std::string> warnings_of_coarse_features(
    const std::vector<PadMaps>  &pads,
    const CorrelationParameters &parameters);

  /** Pads whose features may as well be counted from the centre of the face. */
  std::vector<std::string> warnings_of_assumed_places(
    const std::vector<PadMaps>  &pads,
    const CorrelationParameters &parameters);

  /** Pads whose table of features has columns without numbers. */
  std::vector<std::string> warnings_of_texts(
    const std::vector<PadMaps>  &pads,
    const CorrelationParameters &parameters);

  /** Pads with covariates that have one value in all cells. */
  std::vector<std::string> warnings_of_constant_covariates(
    const std::vector<PadMaps> &pads);

  /** Links of a small conditional p-value that rest on one row or column of
   * cells, as those of maps do that step at one place: the test finds too many
   * of them. */
  std::vector<std::string> warnings_of_links_by_steps(
    const std::vector<PadLink>  &links,
    const CorrelationParameters &parameters);

  /** Pads whose table of features has rows at one place with other values. */
  std::vector<std::string> warnings_of_doubled_rows(
    const std::vector<PadMaps>  &pads,
    const CorrelationParameters &parameters);

  /** Pads that are longer than the faces of brakes, as one with all lengths in
   * mm is. */
  std::vector<std::string> warnings_of_long_pads(
    const std::vector<PadMaps>  &pads,
    const CorrelationParameters &parameters);

  /** Pads with cells in which features but not all covariates are known: the
   * verdicts are without them. */
  std::vector<std::string> warnings_of_lacking_covariates(
    const std::vector<PadMaps> &pads);

  /** Pads whose leading edge is taken for the one at the lowest y because
   * nothing tells it. */
  std::vector<std::string> warnings_of_assumed_edges(
    const std::vector<PadMaps>  &pads,
    const CorrelationParameters &parameters);

  /** A feature's mean on squealing against silent pads. */
  struct GroupResult
  {
    std::string feature;
    std::size_t n_silent = 0, n_squealing = 0;
    double      mean_silent = 0., mean_squealing = 0.;
    double      p_value = 1., p_adjusted = 1.; /**< alone; Holm over features */
    Verdict     verdict = Verdict::undecided;
    std::string reason;
  };

  /**
   * Two-sided permutation test of the means of pads, by the area that was seen
   * or, of widths and directions of cracks, by their length, exact up to a
   * million choices of pads and from 200 000 random ones beyond (a p-value of
   * 0.05 is then good to 0.0005), adjusted by Holm for the number of features.
   * A pad is one sample: where the smallest adjusted p-value that the numbers
   * of pads allow is above the level, the verdict is undecided and says so.
   * Features are those of all pads, each compared on the pads that have it.
   * Empty if a group has no pad.
   */
  std::vector<GroupResult> compare_groups(
    const std::vector<PadMaps>  &pads,
    const CorrelationParameters &parameters);

  /** Features of groups that some pads do not have: a line for each, with the
   * pads. */
  std::vector<std::string> warnings_of_lacking_features(
    const std::vector<PadMaps>  &pads,
    const CorrelationParameters &parameters);
} // namespace squeal::tribology

#endif
