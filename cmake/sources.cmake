# SPDX-License-Identifier: LGPL-2.1-or-later
#
# Every source file of the library, one sorted list a layer. A layer uses itself
# and the layers above it in this file; .ci/check_layers looks after that and
# after files that are missing here.

set(SQUEAL_SOURCES_BASE
    source/base/assignment.cc
    source/base/base64.cc
    source/base/files.cc
    source/base/interrupt.cc
    source/base/memory.cc
    source/base/mumps.cc
    source/base/row_space.cc
    source/base/run_log.cc
    source/base/sparse_matrix.cc
    source/base/timers.cc)

set(SQUEAL_SOURCES_PARAMETERS
    source/parameters/aliases.cc
    source/parameters/allowed.cc
    source/parameters/check_body.cc
    source/parameters/check_contacts.cc
    source/parameters/check_means.cc
    source/parameters/check_parameters.cc
    source/parameters/check_scene.cc
    source/parameters/choices.cc
    source/parameters/declare_analysis.cc
    source/parameters/declare_body.cc
    source/parameters/declare_contact.cc
    source/parameters/declare_scene.cc
    source/parameters/face_geometry.cc
    source/parameters/names.cc
    source/parameters/number_access.cc
    source/parameters/numbers.cc
    source/parameters/print_defaults.cc
    source/parameters/print_parameters.cc
    source/parameters/prm_tree.cc
    source/parameters/read_parameters.cc
    source/parameters/read_prm_file.cc
    source/parameters/schema.cc
    source/parameters/section_families.cc
    source/parameters/text.cc
    source/parameters/unknown_names.cc)

set(SQUEAL_SOURCES_SCENE
    source/scene/body_mesh.cc
    source/scene/coarse_mesh.cc
    source/scene/gmsh_file.cc
    source/scene/gmsh_mesh.cc
    source/scene/import_contact.cc
    source/scene/import_numbering.cc
    source/scene/import_tables.cc
    source/scene/import_text.cc
    source/scene/imported_model.cc
    source/scene/matrix_formats.cc
    source/scene/matrix_import.cc
    source/scene/matrix_import_abaqus.cc
    source/scene/matrix_import_market.cc
    source/scene/matrix_import_nastran.cc)

set(SQUEAL_SOURCES_DISCRETIZATION
    source/discretization/affine_system.cc
    source/discretization/assembly.cc
    source/discretization/discretization.cc
    source/discretization/eigenvalue_error.cc
    source/discretization/eigenvalue_error_cell.cc
    source/discretization/element_matrices.cc
    source/discretization/face_quadrature.cc
    source/discretization/free_unknowns.cc
    source/discretization/pencil.cc
    source/discretization/point_evaluator.cc)

set(SQUEAL_SOURCES_CONTACT
    source/contact/contact_geometry.cc
    source/contact/contact_terms.cc
    source/contact/elimination.cc
    source/contact/linearized_system.cc
    source/contact/mortar.cc)

set(SQUEAL_SOURCES_EIGEN
    source/eigen/arpack_modes.cc
    source/eigen/certified_solver.cc
    source/eigen/complex_pairs.cc
    source/eigen/dense_quadratic.cc
    source/eigen/direct_solver.cc
    source/eigen/mass_basis.cc
    source/eigen/mode_naming.cc
    source/eigen/mode_naming_disc.cc
    source/eigen/mode_naming_profile.cc
    source/eigen/mode_naming_solid.cc
    source/eigen/reduced_basis.cc
    source/eigen/sliding_inverse.cc
    source/eigen/undamped_modes.cc)

set(SQUEAL_SOURCES_TRANSIENT)

set(SQUEAL_SOURCES_RESULTS
    source/results/axis.cc
    source/results/chart.cc
    source/results/chart_layout.cc
    source/results/compare.cc
    source/results/cost_at_error.cc
    source/results/display_mesh.cc
    source/results/hdf5_file.cc
    source/results/history_reader.cc
    source/results/history_writer.cc
    source/results/html_report.cc
    source/results/label_layout.cc
    source/results/matrix_market.cc
    source/results/plots.cc
    source/results/plotter.cc
    source/results/read_csv.cc
    source/results/result_checks.cc
    source/results/run_record.cc
    source/results/shape_plot.cc
    source/results/shape_view.cc
    source/results/shape_writer.cc
    source/results/surface_quads.cc
    source/results/table.cc
    source/results/vtk_xml.cc)

set(SQUEAL_SOURCES_DRIVER
    source/driver/cea_quantities.cc
    source/driver/cea_solution.cc
    source/driver/command_line.cc
    source/driver/matrix_output.cc
    source/driver/mode_solution.cc
    source/driver/model.cc
    source/driver/run_cea.cc
    source/driver/run_context.cc
    source/driver/run_modes.cc
    source/driver/run_session.cc
    source/driver/run_work_precision.cc
    source/driver/shape_output.cc)

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
