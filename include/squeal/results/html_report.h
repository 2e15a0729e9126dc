// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_html_report_h
#define squeal_results_html_report_h

#include <squeal/results/run_record.h>
#include <squeal/results/table.h>

#include <map>
#include <string>
#include <vector>

namespace squeal
{
  /**
   * One HTML file that can be mailed, printed and read without a network:
   * styles, pictures and what sorts the tables are inside. Links lead to the
   * files beside it from which tables and charts can be taken. Parts appear in
   * the order in which they are added, under the last section(); a list of
   * sections stands at the top.
   */
  class HtmlReport
  {
  public:
    enum class Verdict
    {
      good,
      bad,
      neutral
    };

    HtmlReport(const std::string &title, const std::string &subtitle);

    /** The box under the title: one line that says what came out ("2 unstable
     * pairs") and the figures behind it. */
    void set_verdict(Verdict                 verdict,
                     const std::string      &headline,
                     const RunRecord::Pairs &figures);

    void section(const std::string &title);

    void paragraph(const std::string &text);

    /** The columns @p names of @p table (all if none is named), rounded, one
     * line a row; rows for which @p highlighted is true are tinted. A click on a
     * heading sorts by it. The first columns that fit beside each other are
     * shown, the others fold out. The sentence of a column is shown when the
     * mouse rests on its heading, and all of them below the table where
     * @p with_legend is true. */
    void table(const Table                    &table,
               const std::string              &caption,
               const std::vector<std::string> &names       = {},
               const std::vector<bool>        &highlighted = {},
               bool                            with_legend = true);

    /** A picture (PNG) from the file @p path; if it is not there nothing is
     * added. @p narrow pictures stand two in a row. */
    void figure(const std::string &path,
                const std::string &caption,
                bool               narrow = false);

    /** Markup that moves, and the scripts behind it, which the page gets once
     * however often they are asked for. */
    void interactive(const std::string &markup, const std::string &scripts);

    /** Says which files, by name beside the report, hold which tables: each
     * table() of the report gets a link to the one with its columns and as many
     * rows, else to one with its columns and more rows. */
    void link_tables(const std::map<std::string, const Table *> &tables);

    /** Names and values in two columns. */
    void pairs(const RunRecord::Pairs &pairs, const std::string &caption);

    void list(const std::vector<std::string> &items);

    /** Text as typed in a terminal. */
    void code(const std::string &text);

    /** The parts that every report ends with: result checks and warnings (if
     * any), times and memory, parameters, versions, and how to repeat the run
     * with @p command. */
    void run_record(const RunRecord &record, const std::string &command);

    /** Writes the file. */
    void write(const std::string &path) const;

  private:
    /** What is known of a table in the report when its file is looked for. */
    struct ShownTable
    {
      std::vector<std::string> columns;
      std::size_t              n_rows;
      std::string              link = {};
    };

    void checks(const RunRecord &record);
    void timings(const RunRecord &record);

    std::string              title;
    std::string              subtitle;
    std::string              verdict_box;
    std::string              body;
    std::vector<std::string> scripts;
    std::vector<ShownTable>  shown_tables;
    std::vector<std::string> figure_files; /**< paths of their PNG */
    std::vector<std::string> section_titles;
  };
} // namespace squeal

#endif
