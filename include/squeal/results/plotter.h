// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_plotter_h
#define squeal_results_plotter_h

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  class RunLog;

  /** Colours that readers with any kind of colour vision tell apart (Okabe and
   * Ito, 2008), and grey for what stays in the background. */
  enum class Ink
  {
    blue,
    vermillion,
    green,
    orange,
    purple,
    sky,
    black,
    yellow,
    grey
  };

  /** That of series @p k of a chart; from the seventh on they repeat. */
  Ink series_ink(const std::size_t k);

  /** "#0072b2". */
  std::string colour_code(Ink ink);

  /** The same, darkened where it would be too light to read as text. */
  std::string text_colour(Ink ink);

  /** A picture as commands for gnuplot: a script that sets no terminal, and
   * the data files it names. Marker sizes are to be multiplied by the variable
   * marker_scale, which makes them alike on all terminals. */
  struct Drawing
  {
    int                                              width  = 1400; /**< px */
    int                                              height = 900;
    double                                           font_size = 18.; /**< pt */
    std::string                                      script;
    std::vector<std::pair<std::string, std::string>> data;

    /** Adds a data file and returns the name by which the script reads it. */
    std::string add_data(const std::string &content);

    /** Appends a line to the script. */
    void add(const std::string &line);
  };

  /** @p text in the quotes of gnuplot. */
  std::string in_quotes(const std::string &text);

  /** @p value for a script or data file: seven digits, never "nan". */
  std::string plot_number(double value);

  /**
   * Turns drawings into picture files with gnuplot. Where gnuplot is missing or
   * fails the run goes on with one warning: a picture is never worth a result.
   */
  class Plotter
  {
  public:
    /** Is told the path of a file that is about to be written. */
    using Announce = std::function<void(const std::string &path)>;

    /** With @p announce_svg each picture is written as .svg, too, and
     * announced; not one of more data than a quarter of a megabyte, as surfaces
     * of many facets have. */
    explicit Plotter(RunLog &log, Announce announce_svg = {});

    /** Writes @p path + ".png" (and ".svg"). Returns whether the picture is
     * there. Throws InputError if the file cannot be put in its place. */
    bool draw(const Drawing &drawing, const std::string &path) const;

    bool is_available() const;

  private:
    bool draw_as(const Drawing     &drawing,
                 const std::string &terminal,
                 const std::string &path) const;

    RunLog     &log;
    Announce    announce_svg;
    bool        available = false;
    std::string png_terminal; /**< pngcairo, or png where that is missing */
  };
} // namespace squeal

#endif
