// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_run_log_h
#define squeal_base_run_log_h

#include <fstream>
#include <functional>
#include <iosfwd>
#include <string>
#include <utility>
#include <vector>

namespace squeal
{
  class Timers;

  /** Columns that @p text (UTF-8) takes on a terminal. */
  std::size_t display_width(const std::string &text);

  /** "0.42 s", "14 s", "1 min 43 s", "2 h 05 min". */
  std::string format_duration(double seconds);

  /** Prints @p rows as columns two blanks apart, the first row as heading with
   * a rule under it, each line led by @p indent. Column c is left aligned if
   * @p left[c]; columns beyond the end of @p left are right aligned. Columns that
   * do not fit into 80 follow below, behind the first column once more. */
  void print_aligned(std::ostream                                &out,
                     const std::vector<std::vector<std::string>> &rows,
                     const std::vector<bool>                     &left = {true},
                     const std::string &indent                         = "  ");

  /** @p text with its lines of more than @p width columns broken at blanks; what
   * a line goes on with stands two columns further in. A word that is too long
   * for a line is left whole, and so are lines without a single blank between
   * words, such as rules. */
  std::string wrapped(const std::string &text, std::size_t width = 80);

  /**
   * What a run tells: on the console, where long lines are broken, and, word
   * for word, in its log file. A quiet console shows results, warnings and
   * errors alone; the file has everything.
   *
   * On ranks other than the root every call is silent. Until open() names the
   * file the lines are kept, so that the log starts with the first line of the
   * run although the output directory is known only later.
   */
  class RunLog
  {
  public:
    /** Names and values of a block of aligned lines. */
    using Lines = std::vector<std::pair<std::string, std::string>>;

    /** Writes to standard output; a progress line is rewritten in place where
     * that is a terminal. */
    explicit RunLog(bool is_root, bool is_quiet = false);

    /** Writes to @p console, treated as a terminal if @p is_terminal. */
    RunLog(bool          is_root,
           std::ostream &console,
           bool          is_terminal = false,
           bool          is_quiet    = false);

    /** Continues in the file @p path, which gets all lines so far. Throws
     * InputError if it cannot be written. */
    void open(const std::string &path);

    /** One or more lines. */
    void info(const std::string &text);

    /** One or more lines that a quiet console shows, too. */
    void result(const std::string &text);

    /** A heading with a rule under it. */
    void heading(const std::string &text);

    /** Aligned lines "  name  value". */
    void key_values(const Lines &lines);

    /** A line "warning: ...", kept for summary() and for run.json. The same
     * text is said and kept once. */
    void warning(const std::string &text);

    /** Warnings so far. On ranks other than the root this is empty. */
    const std::vector<std::string> &warnings() const;

    /** The end of the run: key @p figures, the table of @p timers, peak memory
     * and all warnings once more. */
    void summary(const Lines &figures, const Timers &timers);

    bool on_root() const;

  private:
    friend class Progress;

    enum class Importance
    {
      usual,
      result /**< shown on a quiet console, too */
    };

    /** Adds complete lines to console and file. */
    void write(const std::string &lines,
               Importance         importance = Importance::usual);

    static std::string aligned(const Lines &lines);

    /** Adds complete lines to the file, or keeps them for it. */
    void write_to_file(const std::string &lines);

    /** Shows @p text as the line to be rewritten; "" removes it. */
    void show_transient(const std::string &text);

    bool                     is_root;
    std::ostream            &console;
    bool                     is_terminal;
    bool                     is_quiet;
    std::string              path;
    std::ofstream            file;
    std::string              kept;
    std::vector<std::string> warning_texts;
    std::size_t              transient_width = 0;
  };

  /**
   * Progress of a loop with an estimate of the time left, by the time since the
   * first report: what comes before it may be set-up. The estimate is there
   * from 1 s after that, as several reports may come at once. Nothing is shown
   * for loops shorter than 5 s. On a terminal one line is rewritten some times
   * a second; elsewhere, and in the log file, a line appears every 10 s.
   */
  class Progress
  {
  public:
    using Clock = std::function<double()>;

    /** @p n_steps = 0 stands for an unknown number; @p clock gives seconds and
     * is the wall clock unless given. */
    Progress(RunLog            &log,
             const std::string &what,
             std::size_t        n_steps,
             Clock              clock = {});

    /** Ends the progress, if any was shown, with a line that says how much is
     * done, 100 % of a loop that came to its end, and the time taken. */
    ~Progress();
    Progress(const Progress &)            = delete;
    Progress &operator=(const Progress &) = delete;

    /** @p n_more steps are done; @p note is shown behind the numbers. */
    void advance(std::size_t n_more = 1, const std::string &note = "");

  private:
    /** "Sweep: 10 of 100 (10 %)" */
    std::string done() const;

    std::string line(double elapsed, const std::string &note) const;

    RunLog     &log;
    std::string what;
    std::size_t n_steps;
    std::size_t n_done = 0;
    Clock       clock;
    double      start;
    double      first_report = 0.; /**< time of it, from the start, s */
    std::size_t n_at_first   = 0;  /**< steps done by then */
    double      last_line;
    double      last_transient;
    bool        shown = false;
  };
} // namespace squeal

#endif
