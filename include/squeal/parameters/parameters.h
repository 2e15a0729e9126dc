// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_parameters_h
#define squeal_parameters_parameters_h

#include <squeal/parameters/analysis_parameters.h>
#include <squeal/parameters/limit_cycle_parameters.h>
#include <squeal/parameters/response_parameters.h>
#include <squeal/parameters/scene_parameters.h>
#include <squeal/parameters/sweep_parameters.h>
#include <squeal/parameters/transient_parameters.h>
#include <squeal/parameters/triggers_parameters.h>

#include <iosfwd>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  /**
   * Everything a run needs to know, read once from a parameter file, checked,
   * printed, then constant. Nothing below this layer sees a ParameterHandler.
   */
  struct Parameters
  {
    enum class Analysis
    {
      modes,
      cea,
      sweep,
      preload,
      transient,
      work_precision,
      frequency_response,
      updating,
      angles,
      limit_cycle,
      operating_matrix,
      triggers
    };
    Analysis                           analysis = Analysis::cea;
    SceneParameters                    scene;
    DiscretizationParameters           discretization;
    EigenParameters                    eigen;
    SweepParameters                    sweep;
    PreloadParameters                  preload;
    TransientParameters                transient;
    LimitCycleParameters               limit_cycle;
    TriggersParameters                 triggers;
    WorkPrecisionParameters            work_precision;
    AnglesParameters                   angles;
    OperatingMatrixParameters          operating_matrix;
    MeasurementParameters              measurement;
    FrequencyResponseParameters        frequency_response;
    UpdatingParameters                 updating;
    OutputParameters                   output;
    std::vector<ResultCheckParameters> result_checks;

    /** Name of the file it was read from. */
    std::string file;
    /** Every entry as used, "Section/Sub/Entry" and value, in declared order:
     * for the printed table, run.json and the parameters_used.prm. */
    std::vector<std::pair<std::string, std::string>> used;

    /** One line for each entry that was given by its former name, and one that
     * names entries without effect. */
    std::vector<std::string> notes;

    /** Checks that span several entries (names that must exist, faces of a
     * shape, radii in order, ...). Throws InputError naming the entry. */
    void check() const;
  };

  /**
   * Reads @p file (with its includes), applies @p overrides of the form
   * "Section/Sub/Entry = value", checks every entry against its declaration
   * and returns the structs. Throws InputError with file, line, entry, what is
   * allowed and the nearest valid name before anything else is done.
   *
   * Entries that only make sense together are left to Parameters::check().
   * Relative names of mesh, matrix and table files start from the folder of
   * the parameter file that sets them, in overrides from the working
   * directory; the structs hold absolute ones.
   */
  Parameters read_parameters(const std::string              &file,
                             const std::vector<std::string> &overrides = {});

  /**
   * The number in the entry @p path ("Scene/Body pad/Young modulus"), or in one
   * component of a list ("Scene/Body pad/Young moduli[2]", from 1). Throws
   * InputError for an unknown entry (with the nearest name) and for one that
   * is not a number.
   */
  double get_number(const Parameters &parameters, const std::string &path);

  /**
   * The same parameters with another @p value of the number that
   * get_number() reads, consistent as if it had been written in the file, and
   * checked by Parameters::check(). The file is not read again. Throws
   * InputError if the value is not allowed.
   */
  Parameters with_value(const Parameters  &parameters,
                        const std::string &path,
                        double             value);

  namespace prm
  {
    class Schema;
  }

  /**
   * Scenes that differ in a few numbers, in microseconds: what with_value()
   * does to the text of a file is done once, here, and only the values are set
   * anew. They are not checked: see check_sweep() and with_value().
   */
  class NumberSetter
  {
  public:
    /** @p paths as of get_number(). Throws InputError like it. */
    NumberSetter(const Parameters               &parameters,
                 const std::vector<std::string> &paths);
    ~NumberSetter();

    /** The scene with one value for every path. Valid until the next call. */
    const SceneParameters &scene(const std::vector<double> &values);

  private:
    struct Target;
    Parameters                   changed;
    std::unique_ptr<prm::Schema> schema;
    std::vector<Target>          targets;
  };

  /** Prints the entries that differ from the defaults as an aligned table. */
  void print_parameters(const Parameters &parameters, std::ostream &out);

  /** Writes the used parameters as a .prm file that reproduces the run; names
   * of input files are relative to it. Throws InputError if it cannot be
   * written. */
  void write_used_parameters(const Parameters  &parameters,
                             const std::string &file);

  /** Prints every entry with its default, unit and a sentence: a parameter
   * file that can be read back. The sections of families like "Body <name>"
   * are in comments, ready for a name. */
  void print_defaults(std::ostream &out);

  /** Prints doc/parameters.md: one table a section, one for all members of a
   * family like "Body <name>". */
  void print_parameter_documentation(std::ostream &out);
} // namespace squeal

#endif
