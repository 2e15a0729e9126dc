// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_run_campaign_runs_h
#define squeal_run_campaign_runs_h

#include <squeal/parameters/parameters.h>
#include <squeal/run/fingerprint.h>

#include <string>
#include <vector>

namespace squeal
{
  /** One run of a campaign. */
  struct CampaignRun
  {
    Parameters          parameters;
    std::vector<double> shown; /**< values of the axes, as tables show them */
    std::string         top;   /**< kind of the support; empty as it stands */
    Fingerprint         fingerprint; /**< all that its motion depends on */
  };

  /**
   * The runs of a campaign: every top, every point of the axes of `Sweep`,
   * every integrator asked for. Those of one group share their bodies, and
   * differ in friction and integrator only. Throws InputError where the scene's
   * friction coefficient is negative.
   */
  std::vector<std::vector<CampaignRun>> campaign_groups(
    const Parameters &parameters);

  /** Those of all groups, one after the other. */
  std::vector<CampaignRun> all_runs(
    const std::vector<std::vector<CampaignRun>> &groups);

  /** The unit of an axis' values as tables show them: that of its entries, MPa
   * where its name ends in "_mpa", none of a logarithm. */
  std::string shown_unit(const SweepAxisParameters &axis,
                         const SceneParameters     &scene);

  /** What charts call it, with that unit: "E_pad in GPa". */
  std::string shown_title(const SweepAxisParameters &axis,
                          const SceneParameters     &scene);
} // namespace squeal

#endif
