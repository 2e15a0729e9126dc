// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_limit_cycle_parameters_h
#define squeal_parameters_limit_cycle_parameters_h

namespace squeal
{
  /** Periodic motions of "Analysis = limit cycle", section "Limit cycle". */
  struct LimitCycleParameters
  {
    double frequency = 0.;          /**< Hz, of the pair it starts from; 0:
                                       that of the largest sigma in the band */
    bool   every_pair = false;      /**< one cycle for each growing pair */
    bool   campaign   = false;      /**< at every point of the axes */
    double start      = 2.;         /**< amplitude over that at which
                                       half of the nodes open or stick */
    double       run_time  = 0.02;  /**< s, of the motion before Newton */
    unsigned int run_steps = 64;    /**< of a period of the pair, then */
    unsigned int starts    = 0;     /**< of transients beside a campaign's
                                       cycles */
    unsigned int searches   = 0;    /**< along the axis of a branch */
    unsigned int steps      = 128;  /**< of a period */
    unsigned int harmonics  = 30;   /**< that are written */
    unsigned int iterations = 30;   /**< of Newton's method at most */
    double       tolerance  = 1e-6; /**< of the return after a period */
  };
} // namespace squeal

#endif
