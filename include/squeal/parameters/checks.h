// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_checks_h
#define squeal_parameters_checks_h

#include <squeal/parameters/parameters.h>

#include <string>

namespace squeal
{
  namespace prm
  {
    /** @name Parts of Parameters::check(). Each throws InputError with the
     * entry and what to change. */
    //@{
    /** Shape, material and mass of one body. */
    void check_body(const BodyParameters &body);

    /** Layers: that the bodies below them stand before them, and that nothing
     * else takes the faces that they cover. */
    void check_layers(const SceneParameters &scene);

    /** Modulus tables of bodies: analyses that know nothing of them. */
    void check_modulus_tables(const Parameters &parameters);

    /** Ties, springs, supports, masses, loads and damping. */
    void check_scene(const SceneParameters &scene);
    /** Bodies, faces and turning of one tie. */
    void check_tie(const SceneParameters &scene, const TieParameters &tie);
    /** Damping that the model of damping or a part would not use. */
    void check_damping(const SceneParameters &scene);

    /** Scenes of kind matrices: parts, tables and contacts, and that nothing is
     * set that has nothing to act on. */
    void check_matrices(const SceneParameters &scene);

    /** Contact pairs: bodies, faces, and that they meet. */
    void check_contacts(const SceneParameters &scene);
    /** The friction law and the springs of one of them. */
    void check_contact_law(const ContactParameters &contact);

    /** One expected value. */
    void check_result_check(const ResultCheckParameters &check);

    /** Axes of a sweep: entries, ranges and that every value is allowed. */
    void check_sweep(const Parameters &parameters);

    /** How one of its axes scatters: said in full, and by what has an effect.
     */
    void check_scatter(const SweepParameters     &sweep,
                       const SweepAxisParameters &axis);

    /** What needs the mesh of a model is refused for matrices. */
    void check_imported(const Parameters &parameters);

    /** Preload and transient: one contact, a load, times in order. */
    void check_transient(const Parameters &parameters);

    /** Periodic motions are those of the reduced model in the fixed frame with
     * one coefficient of friction at all slip rates. */
    void check_periodic_motions(const Parameters &parameters);

    /** The same and what limit cycles have nothing of, their branches and
     * campaigns. */
    void check_limit_cycle(const Parameters &parameters);

    /** The axis that branches of limit cycles are followed along, if there is
     * one. */
    void check_branch(const std::vector<SweepAxisParameters> &axes);

    /** Damping that has no motion in time: loss factors, and that of contact.
     */
    void check_damping_in_time(const SceneParameters &scene);

    /** Bodies that turn through the frame: steady sliding and motions in time
     * do not know their forces. */
    void check_turning_in_time(const SceneParameters &scene);

    /** Ladders, their rungs, and what is solved on them. */
    void check_work_precision(const Parameters &parameters);

    /** Blows of 'Analysis = triggers' and how motions are judged; hammer and
     * friction impulse of 'Analysis = transient', that they strike at all. */
    void check_triggers(const Parameters &parameters);

    /** Measured points, frequency responses and updating. */
    void check_response(const Parameters &parameters);

    /** Matrices are asked for where no analysis writes them. */
    void check_export(const Parameters &parameters);

    /** Everything outside the scene. */
    void check_analysis(const Parameters &parameters);
    //@}

    /** @name Means of these */
    //@{
    /** Throws InputError "'<section>/<entry>' <reason>". */
    [[noreturn]] void refuse_entry(const std::string &section,
                                   const std::string &entry,
                                   const std::string &reason);

    /** The body called @p name, which @p section/@p entry refers to. */
    const BodyParameters &require_body(const SceneParameters &scene,
                                       const std::string     &name,
                                       const std::string     &section,
                                       const std::string     &entry);

    /** The body whose 'Rotation speed' and axis hold for @p body: itself, or
     * of a layer what it lies on. */
    const BodyParameters &turning_body(const SceneParameters &scene,
                                       const BodyParameters  &body);

    /** Whether the centre of rotation of @p b lies on the axis of @p a, to
     * rounding. */
    bool have_centres_on_one_axis(const BodyParameters &a,
                                  const BodyParameters &b);

    /** Refuses a @p face that @p body does not have; a rigid body has none
     * and the name must be empty. */
    void require_face(const BodyParameters &body,
                      const std::string    &face,
                      const std::string    &section,
                      const std::string    &entry);

    /** Refuses the name of a file in the output directory that would leave
     * it. */
    void require_inside(const std::string &name,
                        const std::string &section,
                        const std::string &entry);

    /** Refuses the name of a file that outlives a run if it leaves the output
     * directory or is that of a result: it must end in ".h5". The empty name
     * stands for a default. */
    void require_saved_name(const std::string &name,
                            const std::string &section,
                            const std::string &entry);

    /** Refuses a file that is named but is not there; the empty name is
     * refused too if @p is_needed. */
    void require_file(const std::string &file,
                      const std::string &section,
                      const std::string &entry,
                      bool               is_needed);
    //@}
  } // namespace prm
} // namespace squeal

#endif
