// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_setup_tribology_parameters_h
#define squeal_tribology_setup_tribology_parameters_h

#include <squeal/parameters/analysis_parameters.h>
#include <squeal/parameters/choices.h>
#include <squeal/parameters/schema.h>
#include <squeal/parameters/schema_text.h>
#include <squeal/tribology/setup/damage_parameters.h>
#include <squeal/tribology/setup/image_parameters.h>

#include <iosfwd>
#include <string>
#include <vector>

namespace squeal::tribology
{
  /** Everything a run of squeal-tribology needs to know, read once, checked,
   * printed, then constant. */
  struct TribologyParameters
  {
    enum class Analysis
    {
      damage,
      segmentation,
      correlation,
      synthetic_specimen,
      recorded_history
    };

    /** What is written, section "Output" and top level. */
    struct Output
    {
      std::string directory = "output";
      bool        overwrite = false;
      bool        plots     = true;
      bool        report    = true;
    };

    Analysis                  analysis = Analysis::damage;
    std::string               name; /**< of the study, for headings */
    HistoryParameters         history;
    RecordedHistoryParameters recorded_history;
    FatigueParameters         fatigue;
    SurfaceParameters         surface;
    SubsurfaceParameters      subsurface;
    CorrelationParameters     correlation;
    ImageParameters           images;
    SegmentationParameters    segmentation;
    SpecimenParameters        specimen;
    Output                    output;

    std::vector<ResultCheckParameters> result_checks;

    std::string              file;
    prm::UsedEntries         used;
    std::vector<std::string> notes;

    /** Checks that span several entries. Throws InputError. */
    void check() const;
  };

  Choices<TribologyParameters::Analysis> choices(TribologyParameters::Analysis);

  /** Reads a parameter file as read_parameters() does. Throws InputError. */
  TribologyParameters read_tribology_parameters(
    const std::string              &file,
    const std::vector<std::string> &overrides = {});

  /** Declares every entry, bound to @p parameters, whose result checks have
   * been named before. */
  void declare_tribology(prm::Schema &schema, TribologyParameters &parameters);

  /** Every entry with one member "<name>" of each family. */
  class GenericTribologySchema
  {
  public:
    GenericTribologySchema();

    const prm::Schema &
    operator*() const
    {
      return schema;
    }

  private:
    TribologyParameters parameters;
    prm::Schema         schema;
  };

  /** @name See print_defaults() and print_parameter_documentation(). */
  //@{
  void print_tribology_defaults(std::ostream &out);
  void print_tribology_documentation(std::ostream &out);
  //@}
} // namespace squeal::tribology

#endif
