// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/declarations.h>
#include <squeal/tribology/setup/tribology_parameters.h>

namespace squeal::tribology
{
  void
  declare_tribology(prm::Schema &schema, TribologyParameters &parameters)
  {
    using prm::Allowed;
    TribologyParameters::Output &output = parameters.output;
    schema.add("Analysis",
               parameters.analysis,
               "What is computed: damage maps of a contact history, maps of "
               "cracks and exfoliations in images, the correlation of the two, "
               "an image with known cracks, or a history file from a generator "
               "or a table.");
    schema.add("Name",
               parameters.name,
               Allowed::text(),
               "Name of the study, for headings.");
    schema.add("Output directory",
               output.directory,
               Allowed::text(),
               "Folder of all results, relative to the working directory.");
    schema.add("Overwrite",
               output.overwrite,
               "Replace the results of an earlier run in that folder.");
    declare_recorded_history(schema, parameters.recorded_history);
    declare_history(schema, parameters.history);
    declare_fatigue(schema, parameters.fatigue);
    declare_surface(schema, parameters.surface);
    declare_subsurface(schema, parameters.subsurface);
    declare_images(
      schema, parameters.images, parameters.segmentation, parameters.specimen);
    declare_correlation(schema, parameters.correlation);
    schema.enter_section("Output", "What is written.");
    schema.add("Plots", output.plots, "Write pictures as PNG files.");
    schema.add("Report", output.report, "Write report.html.");
    schema.leave_section();
    prm::declare_result_checks(schema, parameters.result_checks);
  }
} // namespace squeal::tribology
