// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_scene_modulus_table_h
#define squeal_scene_modulus_table_h

#include <squeal/parameters/parameters.h>

#include <array>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  /** The complex modulus of a material, E (1 + i eta). */
  struct ComplexModulus
  {
    double storage;     /**< E, Pa */
    double loss_factor; /**< eta */
  };

  /**
   * The complex modulus of a material over frequency, temperature and, where
   * its file says so, pressure: comma-separated values with the columns
   * frequency_Hz, temperature_C, storage_modulus_Pa, loss_factor and perhaps
   * pressure_Pa in any order. Each pressure has its own temperatures, and each
   * of these its own frequencies, two at least. Blank lines and lines that
   * start with # are passed over.
   *
   * Between frequencies log E and eta follow cubics over log f that are
   * monotone wherever the values are (Fritsch and Carlson, SIAM J. Numer. Anal.
   * 17, 1980): once differentiable, without overshoot. Between temperatures
   * and between pressures both are linear.
   */
  class ModulusTable
  {
  public:
    /** Throws InputError "file:line: ..." for whatever is not such a table: no
     * text, a column that is missing or unknown, a value that is no number, E
     * and f not above 0, eta or a pressure below 0, a row that is there twice,
     * and of a modulus that rises so steeply over frequency (like its
     * power 1.9) that a mode could have several frequencies. */
    explicit ModulusTable(const std::string &file);

    /** At @p frequency, Hz, @p temperature, degrees Celsius, and @p pressure,
     * Pa, of which a table without pressures knows nothing. Outside the table
     * throws InputError, or takes its nearest end. */
    ComplexModulus at(
      const double                               frequency,
      const double                               temperature,
      const double                               pressure,
      const BodyParameters::ModulusExtrapolation extrapolation) const;

    bool depends_on_pressure() const;
    /** Whether E or eta differ between frequencies of one temperature and
     * pressure. */
    bool depends_on_frequency() const;

  private:
    /** Values at one temperature, ascending in log f. */
    struct Curve
    {
      double              temperature;
      std::vector<double> log_f, log_e, eta;
      /** Derivatives of both at the frequencies, by log f. */
      std::vector<double> slope_e, slope_eta;

      /** log E and eta; outside those of the nearest end. */
      std::array<double, 2> at(const double log_frequency) const;
    };
    /** Curves at one pressure, ascending in temperature. */
    struct Sheet
    {
      double             pressure;
      std::vector<Curve> curves;

      /** log E and eta; outside those of the nearest end. */
      std::array<double, 2> at(const double log_frequency,
                               const double temperature) const;
    };
    void read(const std::string &file);
    void require_moderate_slopes();
    /** Throws InputError where @p sheet does not reach. */
    void require_inside(const Sheet &sheet,
                        const double frequency,
                        const double temperature) const;

    std::string        file_name;
    bool               has_pressures = false;
    std::vector<Sheet> sheets; /**< ascending in pressure; one without them */
  };



  /** The modulus tables of a scene. */
  class ModulusTables
  {
  public:
    /** Reads the table of every body that has one. */
    explicit ModulusTables(const SceneParameters &scene);

    bool empty() const;
    /** Whether some modulus is another one at another frequency. */
    bool depend_on_frequency() const;
    /** Whether the table of @p body, if it has one, has pressures. */
    bool depend_on_pressure(const BodyParameters &body) const;

    /** The scene with the moduli of @p frequency, Hz; outside the tables those
     * of their ends, whatever the bodies ask for. */
    SceneParameters at(const SceneParameters &scene,
                       const double           frequency) const;

    /** Throws InputError where a body has no modulus at a frequency of the
     * band, at its temperature or at its pressure. */
    void require_band(const SceneParameters &scene,
                      const double           lowest,
                      const double           highest) const;

  private:
    /** By the position of the body; those of one file are one. */
    std::vector<std::shared_ptr<const ModulusTable>>           of_body;
    std::map<std::string, std::shared_ptr<const ModulusTable>> of_file;
  };

  /** The frequency at which bodies with a table have the modulus of undamped
   * modes, steady sliding and mesh errors: in the middle of the band, over the
   * logarithm; of a band from 0 a tenth of its end. Hz */
  double reference_frequency(const EigenParameters &band);

  /** Gives bodies that have a modulus table its values at the reference
   * frequency. Throws InputError where a table cannot be read or does not cover
   * the band. */
  void take_modulus_tables(Parameters &parameters);
} // namespace squeal

#endif
