// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tests_parameters_describe_h
#define squeal_tests_parameters_describe_h

#include <squeal/parameters/parameters.h>

#include <iomanip>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace squeal
{
  namespace testing
  {
    /** Collects "struct.member = value" of every member of the structs, by
     * hand: independent of how they are declared and printed. */
    class Description
    {
    public:
      std::vector<std::string> lines;

      template <typename T>
      void
      add(const std::string &name, const T &value)
      {
        std::ostringstream text;
        text << name << " = " << std::setprecision(17);
        print(text, value);
        lines.push_back(text.str());
      }

    private:
      template <typename T>
      static void
      print(std::ostream &out, const T &value)
      {
        if constexpr (std::is_enum_v<T>)
          out << static_cast<int>(value);
        else if constexpr (std::is_arithmetic_v<T> ||
                           std::is_same_v<T, std::string>)
          out << value;
        else
          for (const auto &element : value)
            {
              print(out, element);
              out << ';';
            }
      }
    };

#define SQUEAL_DESCRIBE(object, member) \
  description.add(#object "." #member, object.member)

    inline void
    describe(Description &description, const BodyParameters &body)
    {
      SQUEAL_DESCRIBE(body, shape);
      SQUEAL_DESCRIBE(body, position);
      SQUEAL_DESCRIBE(body, size);
      SQUEAL_DESCRIBE(body, inner_radius);
      SQUEAL_DESCRIBE(body, outer_radius);
      SQUEAL_DESCRIBE(body, height);
      SQUEAL_DESCRIBE(body, cells);
      SQUEAL_DESCRIBE(body, mesh_file);
      SQUEAL_DESCRIBE(body, physical_volume);
      SQUEAL_DESCRIBE(body, mesh_faces);
      SQUEAL_DESCRIBE(body, mesh_length_unit);
      SQUEAL_DESCRIBE(body, mesh_mass_unit);
      SQUEAL_DESCRIBE(body, layer_body);
      SQUEAL_DESCRIBE(body, layer_face);
      SQUEAL_DESCRIBE(body, thickness);
      SQUEAL_DESCRIBE(body, element_layers);
      SQUEAL_DESCRIBE(body, modulus_table_file);
      SQUEAL_DESCRIBE(body, temperature);
      SQUEAL_DESCRIBE(body, pressure);
      SQUEAL_DESCRIBE(body, modulus_extrapolation);
      SQUEAL_DESCRIBE(body, material_from_mesh_file);
      SQUEAL_DESCRIBE(body, material_model);
      SQUEAL_DESCRIBE(body, young_modulus);
      SQUEAL_DESCRIBE(body, poisson_ratio);
      SQUEAL_DESCRIBE(body, density);
      SQUEAL_DESCRIBE(body, young_moduli);
      SQUEAL_DESCRIBE(body, shear_moduli);
      SQUEAL_DESCRIBE(body, poisson_ratios);
      SQUEAL_DESCRIBE(body, material_axis_1);
      SQUEAL_DESCRIBE(body, material_axis_2);
      SQUEAL_DESCRIBE(body, mass);
      SQUEAL_DESCRIBE(body, inertia);
      SQUEAL_DESCRIBE(body, mass_damping);
      SQUEAL_DESCRIBE(body, stiffness_damping);
      SQUEAL_DESCRIBE(body, structural_damping);
      SQUEAL_DESCRIBE(body, rotation_speed);
      SQUEAL_DESCRIBE(body, rotation_axis);
      // none: where the position is
      description.add("body.rotation_centre",
                      body.rotation_centre.value_or(Vector3{{-1e99, 0., 0.}}));
      SQUEAL_DESCRIBE(body, angle);
    }

    inline void
    describe(Description &description, const TieParameters &tie)
    {
      SQUEAL_DESCRIBE(tie, source_body);
      SQUEAL_DESCRIBE(tie, source_face);
      SQUEAL_DESCRIBE(tie, target_body);
      SQUEAL_DESCRIBE(tie, target_face);
      SQUEAL_DESCRIBE(tie, kind);
    }

    inline void
    describe(Description &description, const SpringParameters &spring)
    {
      SQUEAL_DESCRIBE(spring, kind);
      SQUEAL_DESCRIBE(spring, body);
      SQUEAL_DESCRIBE(spring, other_body);
      SQUEAL_DESCRIBE(spring, face);
      SQUEAL_DESCRIBE(spring, first_point);
      SQUEAL_DESCRIBE(spring, last_point);
      SQUEAL_DESCRIBE(spring, number);
      SQUEAL_DESCRIBE(spring, direction);
      SQUEAL_DESCRIBE(spring, stiffness);
      SQUEAL_DESCRIBE(spring, dashpot);
      SQUEAL_DESCRIBE(spring, stiffnesses);
      SQUEAL_DESCRIBE(spring, dashpots);
      SQUEAL_DESCRIBE(spring, stiffness_damping);
      SQUEAL_DESCRIBE(spring, structural_damping);
    }

    inline void
    describe(Description &description, const SupportParameters &support)
    {
      SQUEAL_DESCRIBE(support, body);
      SQUEAL_DESCRIBE(support, face);
      SQUEAL_DESCRIBE(support, kind);
      SQUEAL_DESCRIBE(support, components);
    }

    inline void
    describe(Description &description, const LumpedMassParameters &lumped)
    {
      SQUEAL_DESCRIBE(lumped, body);
      SQUEAL_DESCRIBE(lumped, point);
      SQUEAL_DESCRIBE(lumped, mass);
    }

    inline void
    describe(Description &description, const LoadParameters &load)
    {
      SQUEAL_DESCRIBE(load, body);
      SQUEAL_DESCRIBE(load, face);
      SQUEAL_DESCRIBE(load, force);
      SQUEAL_DESCRIBE(load, pressure);
      SQUEAL_DESCRIBE(load, moment);
      SQUEAL_DESCRIBE(load, ramp_time);
    }

    inline void
    describe(Description &description, const ContactParameters &contact)
    {
      SQUEAL_DESCRIBE(contact, source_body);
      SQUEAL_DESCRIBE(contact, source_face);
      SQUEAL_DESCRIBE(contact, contact_point);
      SQUEAL_DESCRIBE(contact, target_body);
      SQUEAL_DESCRIBE(contact, target_face);
      SQUEAL_DESCRIBE(contact, formulation);
      SQUEAL_DESCRIBE(contact, layout);
      SQUEAL_DESCRIBE(contact, grid);
      SQUEAL_DESCRIBE(contact, normal_stiffness);
      SQUEAL_DESCRIBE(contact, tangential_stiffness);
      SQUEAL_DESCRIBE(contact, normal_stiffness_per_area);
      SQUEAL_DESCRIBE(contact, state);
      SQUEAL_DESCRIBE(contact, friction_coefficient);
      SQUEAL_DESCRIBE(contact, friction_law);
      SQUEAL_DESCRIBE(contact, static_friction_coefficient);
      SQUEAL_DESCRIBE(contact, decay_speed);
      SQUEAL_DESCRIBE(contact, friction_speeds);
      SQUEAL_DESCRIBE(contact, friction_coefficients);
      SQUEAL_DESCRIBE(contact, friction_direction);
      SQUEAL_DESCRIBE(contact, sliding_direction);
      SQUEAL_DESCRIBE(contact, transverse_slip_term);
      SQUEAL_DESCRIBE(contact, sliding_speed);
      SQUEAL_DESCRIBE(contact, normal_force);
      SQUEAL_DESCRIBE(contact, friction_slope);
      SQUEAL_DESCRIBE(contact, stiffness_damping);
      SQUEAL_DESCRIBE(contact, structural_damping);
    }

    inline void
    describe(Description &description, const MatrixPartParameters &part)
    {
      SQUEAL_DESCRIBE(part, file);
      SQUEAL_DESCRIBE(part, role);
      SQUEAL_DESCRIBE(part, format);
      SQUEAL_DESCRIBE(part, matrix_name);
      SQUEAL_DESCRIBE(part, factor);
    }

    inline void
    describe(Description &description, const MeasuredPointParameters &point)
    {
      SQUEAL_DESCRIBE(point, body);
      SQUEAL_DESCRIBE(point, position);
      SQUEAL_DESCRIBE(point, direction);
      SQUEAL_DESCRIBE(point, node);
    }

    inline void
    describe(Description &description, const UpdatedNumberParameters &number)
    {
      SQUEAL_DESCRIBE(number, entries);
      SQUEAL_DESCRIBE(number, lower);
      SQUEAL_DESCRIBE(number, upper);
    }

    inline void
    describe(Description &description, const SweepAxisParameters &axis)
    {
      SQUEAL_DESCRIBE(axis, entries);
      SQUEAL_DESCRIBE(axis, scale);
      SQUEAL_DESCRIBE(axis, from);
      SQUEAL_DESCRIBE(axis, to);
      SQUEAL_DESCRIBE(axis, number);
      SQUEAL_DESCRIBE(axis, values);
      SQUEAL_DESCRIBE(axis, entry_values);
      SQUEAL_DESCRIBE(axis, distribution);
      SQUEAL_DESCRIBE(axis, mean);
      SQUEAL_DESCRIBE(axis, deviation);
      SQUEAL_DESCRIBE(axis, shown_as);
    }

    inline void
    describe(Description &description, const ResultCheckParameters &check)
    {
      SQUEAL_DESCRIBE(check, table);
      SQUEAL_DESCRIBE(check, where);
      SQUEAL_DESCRIBE(check, nearest);
      SQUEAL_DESCRIBE(check, column);
      SQUEAL_DESCRIBE(check, expected);
      SQUEAL_DESCRIBE(check, relative_tolerance);
      SQUEAL_DESCRIBE(check, absolute_tolerance);
    }

    template <typename T>
    void
    describe_all(Description &description, const std::vector<T> &members)
    {
      for (const T &member : members)
        describe(description, member);
    }

    inline void
    describe(Description &description, const SceneParameters &scene)
    {
      SQUEAL_DESCRIBE(scene, name);
      SQUEAL_DESCRIBE(scene, kind);
      SQUEAL_DESCRIBE(scene, damping.model);
      SQUEAL_DESCRIBE(scene, damping.mass_damping);
      SQUEAL_DESCRIBE(scene, damping.stiffness_damping);
      SQUEAL_DESCRIBE(scene, damping.structural_damping);
      SQUEAL_DESCRIBE(scene, contact_pattern_file);
      SQUEAL_DESCRIBE(scene, contact_normal_stiffness);
      SQUEAL_DESCRIBE(scene, friction_coefficient);
      SQUEAL_DESCRIBE(scene, node_table_file);
      describe_all(description, scene.bodies);
      describe_all(description, scene.ties);
      describe_all(description, scene.springs);
      describe_all(description, scene.supports);
      describe_all(description, scene.lumped_masses);
      describe_all(description, scene.loads);
      describe_all(description, scene.contacts);
      describe_all(description, scene.matrix_parts);
    }

    inline void
    describe_numerics(Description &description, const Parameters &p)
    {
      SQUEAL_DESCRIBE(p, discretization.degree);
      SQUEAL_DESCRIBE(p, discretization.mass);
      SQUEAL_DESCRIBE(p, discretization.refinements);
      SQUEAL_DESCRIBE(p, discretization.refinement);
      SQUEAL_DESCRIBE(p, discretization.tolerance);
      SQUEAL_DESCRIBE(p, discretization.growth_rate_tolerance);
      SQUEAL_DESCRIBE(p, discretization.maximum_cycles);
      SQUEAL_DESCRIBE(p, discretization.maximum_dofs);
      SQUEAL_DESCRIBE(p, discretization.estimate_error);
      SQUEAL_DESCRIBE(p, eigen.lowest_frequency);
      SQUEAL_DESCRIBE(p, eigen.highest_frequency);
      SQUEAL_DESCRIBE(p, eigen.mode_tolerance);
      SQUEAL_DESCRIBE(p, eigen.linear_solver);
      SQUEAL_DESCRIBE(p, eigen.solver);
      SQUEAL_DESCRIBE(p, eigen.residual_tolerance);
      SQUEAL_DESCRIBE(p, eigen.error_tolerance);
      SQUEAL_DESCRIBE(p, eigen.maximum_enrichments);
      SQUEAL_DESCRIBE(p, eigen.direct_shift_frequency);
      SQUEAL_DESCRIBE(p, eigen.number_of_pairs);
      SQUEAL_DESCRIBE(p, eigen.damping_threshold_percent);
      SQUEAL_DESCRIBE(p, eigen.compare_direct);
      SQUEAL_DESCRIBE(p, sweep.frequency_tolerance);
      SQUEAL_DESCRIBE(p, sweep.sigma_tolerance);
      SQUEAL_DESCRIBE(p, sweep.maximum_basis);
      SQUEAL_DESCRIBE(p, sweep.basis_file);
      SQUEAL_DESCRIBE(p, sweep.reuse_basis);
      SQUEAL_DESCRIBE(p, sweep.edge_tolerance);
      SQUEAL_DESCRIBE(p, sweep.exceptional_points);
      SQUEAL_DESCRIBE(p, sweep.boundary_tolerance);
      SQUEAL_DESCRIBE(p, sweep.direct_checks);
      SQUEAL_DESCRIBE(p, sweep.compare);
      SQUEAL_DESCRIBE(p, sweep.sensitivities);
      SQUEAL_DESCRIBE(p, sweep.suggestions);
      SQUEAL_DESCRIBE(p, sweep.largest_change);
      SQUEAL_DESCRIBE(p, sweep.scatter_samples);
      SQUEAL_DESCRIBE(p, sweep.scatter_seed);
      SQUEAL_DESCRIBE(p, preload.run_in);
      SQUEAL_DESCRIBE(p, preload.load_steps);
      SQUEAL_DESCRIBE(p, preload.tolerance);
      SQUEAL_DESCRIBE(p, preload.stiffness_entry);
      SQUEAL_DESCRIBE(p, preload.stiffness_values);
      SQUEAL_DESCRIBE(p, transient.start);
      SQUEAL_DESCRIBE(p, transient.integrator);
      SQUEAL_DESCRIBE(p, transient.integrators);
      SQUEAL_DESCRIBE(p, transient.contact_method);
      SQUEAL_DESCRIBE(p, transient.beta_2);
      SQUEAL_DESCRIBE(p, transient.disc_frame);
      SQUEAL_DESCRIBE(p, transient.animation_frames);
      SQUEAL_DESCRIBE(p, transient.explicit_step);
      SQUEAL_DESCRIBE(p, transient.interface_cut_off);
      SQUEAL_DESCRIBE(p, transient.disturbance);
      SQUEAL_DESCRIBE(p, transient.cut_off_damping);
      SQUEAL_DESCRIBE(p, transient.cut_off);
      SQUEAL_DESCRIBE(p, transient.time_step);
      SQUEAL_DESCRIBE(p, transient.end_time);
      SQUEAL_DESCRIBE(p, transient.tolerance);
      SQUEAL_DESCRIBE(p, transient.sample_interval);
      SQUEAL_DESCRIBE(p, transient.history_start);
      SQUEAL_DESCRIBE(p, transient.final_speed_ratio);
      SQUEAL_DESCRIBE(p, transient.friction_impulse);
      SQUEAL_DESCRIBE(p, transient.friction_impulse_time);
      SQUEAL_DESCRIBE(p, transient.friction_impulse_duration);
      SQUEAL_DESCRIBE(p, transient.checkpoint_file);
      SQUEAL_DESCRIBE(p, transient.checkpoint_interval);
      SQUEAL_DESCRIBE(p, transient.resume);
      SQUEAL_DESCRIBE(p, transient.tops);
      SQUEAL_DESCRIBE(p, transient.top_support);
      SQUEAL_DESCRIBE(p, transient.compare_with_cea);
      SQUEAL_DESCRIBE(p, limit_cycle.frequency);
      SQUEAL_DESCRIBE(p, limit_cycle.every_pair);
      SQUEAL_DESCRIBE(p, limit_cycle.campaign);
      SQUEAL_DESCRIBE(p, limit_cycle.start);
      SQUEAL_DESCRIBE(p, limit_cycle.run_time);
      SQUEAL_DESCRIBE(p, limit_cycle.run_steps);
      SQUEAL_DESCRIBE(p, limit_cycle.starts);
      SQUEAL_DESCRIBE(p, limit_cycle.searches);
      SQUEAL_DESCRIBE(p, limit_cycle.steps);
      SQUEAL_DESCRIBE(p, limit_cycle.harmonics);
      SQUEAL_DESCRIBE(p, limit_cycle.iterations);
      SQUEAL_DESCRIBE(p, limit_cycle.tolerance);
      SQUEAL_DESCRIBE(p, triggers.points);
      SQUEAL_DESCRIBE(p, triggers.impulses);
      SQUEAL_DESCRIBE(p, triggers.duration);
      SQUEAL_DESCRIBE(p, triggers.tolerance);
      SQUEAL_DESCRIBE(p, triggers.window);
      SQUEAL_DESCRIBE(p, triggers.hold);
      SQUEAL_DESCRIBE(p, triggers.longest);
      SQUEAL_DESCRIBE(p, triggers.edge_time);
      SQUEAL_DESCRIBE(p, triggers.halvings);
      SQUEAL_DESCRIBE(p, transient.campaign_table);
      SQUEAL_DESCRIBE(p, transient.threads);
      SQUEAL_DESCRIBE(p, transient.hammer.body);
      SQUEAL_DESCRIBE(p, transient.hammer.face);
      SQUEAL_DESCRIBE(p, transient.hammer.force);
      SQUEAL_DESCRIBE(p, transient.hammer.time);
      SQUEAL_DESCRIBE(p, transient.hammer.duration);
      SQUEAL_DESCRIBE(p, frequency_response.quantity);
      SQUEAL_DESCRIBE(p, frequency_response.excitations);
      SQUEAL_DESCRIBE(p, frequency_response.responses);
      SQUEAL_DESCRIBE(p, frequency_response.states);
      SQUEAL_DESCRIBE(p, frequency_response.number);
      SQUEAL_DESCRIBE(p, frequency_response.scale);
      SQUEAL_DESCRIBE(p, frequency_response.margin);
      SQUEAL_DESCRIBE(p, frequency_response.residual);
      SQUEAL_DESCRIBE(p, frequency_response.checks);
      SQUEAL_DESCRIBE(p, frequency_response.check_tolerance);
      SQUEAL_DESCRIBE(p, updating.pairing);
      SQUEAL_DESCRIBE(p, updating.minimum_mac);
      SQUEAL_DESCRIBE(p, updating.tolerance);
      SQUEAL_DESCRIBE(p, updating.maximum_evaluations);
      SQUEAL_DESCRIBE(p, updating.confidence_percent);
      SQUEAL_DESCRIBE(p, measurement.shapes_file);
      SQUEAL_DESCRIBE(p, measurement.frequencies_file);
      SQUEAL_DESCRIBE(p, angles.bodies);
      SQUEAL_DESCRIBE(p, angles.from);
      SQUEAL_DESCRIBE(p, angles.to);
      SQUEAL_DESCRIBE(p, angles.number);
      SQUEAL_DESCRIBE(p, operating_matrix.pressures);
      SQUEAL_DESCRIBE(p, operating_matrix.temperatures);
      SQUEAL_DESCRIBE(p, operating_matrix.speeds);
      SQUEAL_DESCRIBE(p, operating_matrix.both_directions);
      SQUEAL_DESCRIBE(p, work_precision.problem);
      SQUEAL_DESCRIBE(p, work_precision.ladders);
      SQUEAL_DESCRIBE(p, work_precision.values);
      SQUEAL_DESCRIBE(p, work_precision.adaptive_values);
      SQUEAL_DESCRIBE(p, work_precision.cut_offs);
      SQUEAL_DESCRIBE(p, work_precision.time_steps);
      SQUEAL_DESCRIBE(p, work_precision.refinement_degree);
      SQUEAL_DESCRIBE(p, work_precision.quantity);
      SQUEAL_DESCRIBE(p, work_precision.reference);
    }

    /** Every member of every struct, one line each. */
    inline std::vector<std::string>
    describe(const Parameters &p)
    {
      Description description;
      SQUEAL_DESCRIBE(p, analysis);
      SQUEAL_DESCRIBE(p, output.directory);
      SQUEAL_DESCRIBE(p, output.overwrite);
      SQUEAL_DESCRIBE(p, output.shapes);
      SQUEAL_DESCRIBE(p, output.animation_frames);
      SQUEAL_DESCRIBE(p, output.plots);
      SQUEAL_DESCRIBE(p, output.report);
      SQUEAL_DESCRIBE(p, output.export_matrices);
      SQUEAL_DESCRIBE(p, output.slip_display_scale);
      describe(description, p.scene);
      describe_numerics(description, p);
      describe_all(description, p.sweep.axes);
      describe_all(description, p.measurement.points);
      describe_all(description, p.updating.numbers);
      describe_all(description, p.result_checks);
      return description.lines;
    }

#undef SQUEAL_DESCRIBE
  } // namespace testing
} // namespace squeal

#endif
