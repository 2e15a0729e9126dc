// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_driver_study_report_h
#define squeal_tribology_driver_study_report_h

#include <squeal/results/html_report.h>
#include <squeal/tribology/driver/context.h>
#include <squeal/tribology/statistics/pad_tables.h>

#include <string>
#include <vector>

namespace squeal::tribology
{
  /** The runs of a study that its last report tells about. */
  class StudyRuns
  {
  public:
    /** Reads run.json of each directory. Throws InputError where there is
     * none. */
    explicit StudyRuns(const std::vector<std::string> &directories);

    bool
    empty() const
    {
      return runs.empty();
    }

    /** What was done, in the order of the runs. */
    void add_steps(HtmlReport &report) const;

    /** Damage maps and totals of the runs of that kind. */
    void add_damage(HtmlReport &report) const;

    /** Overlays and figures of the segmented images. Writes reduced pictures
     * to the folder plots of @p context. */
    void add_images(HtmlReport &report, Context &context) const;

    /** Commands that repeat the study, the run @p last after the others. */
    void add_commands(HtmlReport &report, const RunRecord &last) const;

  private:
    struct Run
    {
      std::string directory;
      RunRecord   record;
    };

    static void add_overlays(HtmlReport  &report,
                             Context     &context,
                             const Run   &run,
                             const Table &table);

    std::vector<Run> runs;
  };

  /** What was found and how sure it is, one sentence for each pad and group. */
  std::vector<std::string> in_plain_words(
    const std::vector<PadLink>     &links,
    const std::vector<GroupResult> &groups,
    const CorrelationParameters    &parameters);

  /** What any map that concentrates at the leading edge or at the rim would
   * reach with each feature, beside what the indices reach. */
  std::vector<std::string> shared_cause_sentences(
    const std::vector<PadLink>  &links,
    const CorrelationParameters &parameters);
} // namespace squeal::tribology

#endif
