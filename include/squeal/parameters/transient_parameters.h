// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_transient_parameters_h
#define squeal_parameters_transient_parameters_h

#include <squeal/parameters/scene_parameters.h>

#include <string>
#include <vector>

namespace squeal
{
  /** Steady sliding under the loads, section "Preload". */
  struct PreloadParameters
  {
    enum class RunIn
    {
      none,   /**< flat faces, as meshed */
      archard /**< worn until the wear no longer changes the pressure */
    };
    RunIn        run_in     = RunIn::none;
    unsigned int load_steps = 10;    /**< equal shares of the load */
    double       tolerance  = 1e-10; /**< of the contact law, relative to the
                                          mean nodal force */
    /** A number of the scene ("Scene/Body pad/Young modulus") and the values
     * at which the contact stiffness is computed as well. */
    std::string         stiffness_entry;
    std::vector<double> stiffness_values;
  };

  /** A short force on a face, section "Transient/Hammer". */
  struct HammerParameters
  {
    std::string body, face;
    Vector3     force{{0., 0., 0.}}; /**< N, at the top of the half sine */
    double      time     = 0.;       /**< s, of its start */
    double      duration = 2e-4;     /**< s */
  };

  /** Motion in time, section "Transient". */
  struct TransientParameters
  {
    enum class Start
    {
      steady_sliding, /**< under the full load, slightly disturbed */
      ramp            /**< at rest, loads from zero by their ramps */
    };
    enum class Integrator
    {
      reduced,  /**< modes up to the cut-off, contact nodes without mass */
      implicit, /**< finite elements, trapezoidal rule, contact velocities */
      explicit_ /**< finite elements, beta-2 scheme with forward multipliers */
    };
    enum class DiscFrame
    {
      eulerian,  /**< contact matrices of the start: axisymmetric target */
      corotating /**< the target's mesh turns, matrices of every step */
    };
    enum class ContactMethod
    {
      newton,      /**< semi-smooth, Gauss-Seidel where it cycles */
      gauss_seidel /**< projected sweeps alone, as in the thesis */
    };
    Start         start             = Start::steady_sliding;
    Integrator    integrator        = Integrator::reduced;
    ContactMethod contact_method    = ContactMethod::newton;
    DiscFrame     disc_frame        = DiscFrame::eulerian;
    double        beta_2            = 0.5; /**< of the explicit scheme */
    double        explicit_step     = 0.;  /**< s; 0: `time_step` */
    double        interface_cut_off = 0.;  /**< Hz, of the contact's own Ritz
                                              motions; 0: none moves */
    double cut_off_damping = 0.; /**< ratio there, falling as (f/cut-off)^8;
                                    of the reduced integrator */
    double disturbance = 1e-18;  /**< J, of an impulse at points of all
                                    bodies */
    double       cut_off         = 40e3; /**< Hz, modes of the bodies */
    double       time_step       = 2e-6; /**< s */
    double       end_time        = 0.05; /**< s */
    double       tolerance       = 1e-8; /**< as PreloadParameters::tolerance */
    double       sample_interval = 2e-5; /**< s, of all results */
    double       history_start   = 0.;   /**< s, of contact_history.h5 */
    unsigned int animation_frames  = 0;  /**< the last samples, as motion.pvd */
    double       final_speed_ratio = 1.; /**< |V| at the end over that at the
                                            start, linear in between */
    HammerParameters hammer;
    double           friction_impulse      = 0.; /**< added to mu for a while */
    double           friction_impulse_time = 0.; /**< s */
    double           friction_impulse_duration = 1e-3; /**< s */

    std::string checkpoint_file;            /**< empty: checkpoint.h5 */
    double      checkpoint_interval = 600.; /**< s of wall time; 0: only when
                                                 the run is stopped */
    bool resume = true;

    /** The time step of the integrator, s. */
    double
    step() const
    {
      return integrator == Integrator::explicit_ && explicit_step > 0.
               ? explicit_step
               : time_step;
    }

    /** Kinds of the support `top_support` that a campaign goes through; empty:
     * that of the scene. */
    std::vector<std::string> tops;
    std::string              top_support = "top";
    /** Integrators that a campaign goes through; empty: `integrator`. */
    std::vector<std::string> integrators;
    bool compare_with_cea = false; /**< sigma and f about the same state by the
                                      eigenvalue analysis of the whole model */
    std::string  campaign_table = "campaign.csv";
    unsigned int threads        = 2; /**< runs of a campaign side by side */
  };
} // namespace squeal

#endif
