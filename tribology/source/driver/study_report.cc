// SPDX-License-Identifier: LGPL-2.1-or-later
#include <squeal/parameters/text.h>
#include <squeal/results/table.h>
#include <squeal/run/settings.h>
#include <squeal/tribology/driver/image_report.h>
#include <squeal/tribology/driver/study_report.h>
#include <squeal/tribology/statistics/quantity_text.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

namespace squeal::tribology
{
  namespace
  {
    namespace fs = std::filesystem;

    const std::map<std::string, std::string> &
    meanings()
    {
      static const std::map<std::string, std::string> texts = {
        {"recorded history",
         "contact pressure, traction and slip of every node over time, from a "
         "documented generator or a measured table"},
        {"transient", "computed contact history of the turning disc"},
        {"damage",
         "load cycles of every node counted and added up; stresses below the "
         "face; friction power and impacts"},
        {"synthetic specimen",
         "made images with known cracks, not photographs of a pad"},
        {"segmentation", "cracks, exfoliations and plateaus found in images"},
        {"correlation", "maps of damage against maps of features"}};
      return texts;
    }



    std::string
    figures_text(const RunRecord &record)
    {
      std::string text;
      for (const auto &[name, value] : record.figures)
        text += (text.empty() ? "" : "; ") + name + ": " + value;
      return text;
    }



    std::string
    silence_text(const Silence silence)
    {
      switch (silence)
        {
        case Silence::few_cells:
          return "too few cells to take shared causes out";
        case Silence::index_constant:
        case Silence::feature_constant:
          return "one of the maps is the same everywhere";
        case Silence::index_explained:
          return "the index follows from what is taken out";
        case Silence::feature_explained:
          break;
        }
      return "the feature follows from what is taken out";
    }



    std::string
    interval_text(const LinkTest &test)
    {
      if (!std::isfinite(test.r))
        return "one of the maps is the same everywhere";
      const std::string plain = "r = " + rounded_text(test.r, 2);
      if (!test.conditional.is_known)
        return plain + "; " + silence_text(test.conditional.silence);
      return plain + ", with shared causes taken out " +
             rounded_text(test.conditional.r, 2) + ", between " +
             rounded_text(test.conditional_interval[0], 2) + " and " +
             rounded_text(test.conditional_interval[1], 2);
    }



    std::string
    command_of(const RunRecord &record)
    {
      return command_of_run(
        record.parameter_file, record.settings, record.n_ranks);
    }
  } // namespace



  StudyRuns::StudyRuns(const std::vector<std::string> &directories)
  {
    for (const std::string &directory : directories)
      runs.push_back({directory, read_run_record(directory + "/run.json")});
  }



  void
  StudyRuns::add_steps(HtmlReport &report) const
  {
    std::vector<std::string> steps;
    for (const Run &run : runs)
      {
        const auto        it      = meanings().find(run.record.analysis);
        const std::string figures = figures_text(run.record);
        steps.push_back("Step " + std::to_string(steps.size() + 1) + ", " +
                        run.record.scene + " (" + run.record.analysis + ")" +
                        (it == meanings().end() ? "" : ": " + it->second) +
                        "." +
                        (figures.empty() ? "" : " Result: " + figures + "."));
      }
    report.list(steps);
  }



  namespace
  {
    /** Names of the pairs of a run; one that is empty of a run with one. */
    std::vector<std::string>
    pairs_of(const Table &totals)
    {
      std::vector<std::string> names;
      for (std::size_t i = 0; i < totals.n_rows(); ++i)
        if (totals.has_column("pair"))
          if (const std::string name = totals.text(i, "pair");
              names.empty() || names.back() != name)
            names.push_back(name);
      return names.empty() ? std::vector<std::string>{""} : names;
    }
  } // namespace



  void
  StudyRuns::add_damage(HtmlReport &report) const
  {
    report.paragraph(
      "Where no constants of the material were given damage is an index: the "
      "sum of (amplitude over a reference stress) to the power m over all load "
      "cycles. It ranks places and runs and says nothing about life; several "
      "slopes m stand side by side because nobody has published one for brake "
      "pads.");
    for (const Run &run : runs)
      {
        if (run.record.analysis != "damage")
          continue;
        for (const std::string &warning : run.record.warnings)
          report.paragraph(run.record.scene + ": " + warning + ".");
        const std::string plots  = run.directory + "/plots/";
        const Table       totals = read_csv(run.directory + "/totals.csv");
        // One row alone compares nothing; the steps above have its figures.
        if (totals.n_rows() > 1)
          report.table(
            totals, "Over the whole face: " + run.record.scene, {}, {}, false);
        for (const std::string &pair : pairs_of(totals))
          {
            const std::string end = (pair.empty() ? "" : "_" + pair) + ".png",
                              of  = run.record.scene +
                                   (pair.empty() ? "" : ", " + pair);
            report.figure(
              plots + "damage_maps" + end,
              "Damage of " + of +
                ", seen through the back of the pad; the disc slides along "
                "the arrow.");
            report.figure(
              plots + "ratio_maps" + end,
              "Squealing over silent run, node by node; grey where the silent "
              "pad does not touch.");
            report.figure(plots + "depths" + end,
                          "Largest value of each criterion against depth.",
                          true);
          }
      }
  }



  void
  StudyRuns::add_images(HtmlReport &report, Context &context) const
  {
    report.paragraph(
      "Each image lies on the pad by its stage position or by points known in "
      "both, and is cut into the nodal cells of the damage map. Pictures show "
      "it in the axes of the maps, however it was taken.");
    for (const bool pictures : {false, true})
      for (const Run &run : runs)
        {
          if (run.record.analysis != "segmentation")
            continue;
          const Table table = read_csv(run.directory + "/segmentation.csv");
          if (pictures)
            add_overlays(report, context, run, table);
          else
            report.table(table, "Images of " + run.record.scene);
        }
  }



  void
  StudyRuns::add_overlays(HtmlReport  &report,
                          Context     &context,
                          const Run   &run,
                          const Table &table)
  {
    constexpr std::size_t n_shown = 2;
    const std::string     name    = fs::path(run.directory).filename();
    for (std::size_t i = 0; i < std::min(n_shown, table.n_rows()); ++i)
      {
        const std::string stem = table.text(i, "image");
        // Images without a place on the pad are as they were taken.
        const std::string on_pad = run.directory + "/" + stem + "_on_pad.png";
        report.figure(
          reduced_picture(
            fs::exists(on_pad) ? on_pad
                               : run.directory + "/" + stem + "_overlay.png",
            context.output.file("plots/" + name + "_" + stem + ".png")),
          run.record.scene + ", " + stem +
            ": cracks in red, outlines of exfoliations in purple, of contact "
            "plateaus in blue.",
          true);
      }
  }



  void
  StudyRuns::add_commands(HtmlReport &report, const RunRecord &last) const
  {
    std::string text;
    for (const Run &run : runs)
      text += command_of(run.record) + "\n";
    report.code(text + command_of(last) + "\n");
  }



  std::vector<std::string>
  in_plain_words(const std::vector<PadLink>     &links,
                 const std::vector<GroupResult> &groups,
                 const CorrelationParameters    &p)
  {
    std::vector<std::string> sentences;
    if (p.is_synthetic)
      sentences.push_back(
        "The images are made, not photographed: what follows tests the "
        "method and says nothing about a brake.");
    std::size_t n_pads = 0;
    for (const PadLink &l : links)
      n_pads = std::max(n_pads, l.pad + 1);
    for (std::size_t pad = 0; pad < n_pads; ++pad)
      {
        std::vector<std::string> found[3];
        for (const PadLink &l : links)
          if (l.pad == pad)
            found[static_cast<int>(l.test.verdict)].push_back(
              QuantityText(l.index).name + " with " +
              QuantityText(l.feature).name + " (" + interval_text(l.test) +
              ")");
        std::string text = "Pad " + std::to_string(pad + 1);
        if (pad < p.groups.size())
          text += " (" + p.groups[pad] + ")";
        const std::string words[3] = {
          "damage and features lie at the same places: ",
          "they lie at different places, or go together by less than a "
          "correlation of " +
            rounded_text(p.relevant_link, 2) + ": ",
          "these images cannot tell: "};
        const Verdict kinds[3] = {
          Verdict::supported, Verdict::contradicted, Verdict::undecided};
        for (int k = 0; k < 3; ++k)
          if (const auto &list = found[static_cast<int>(kinds[k])];
              !list.empty())
            sentences.push_back(text + ", " +
                                verdict_text(kinds[k], p.is_synthetic) + ": " +
                                words[k] + prm::join(list, "; ") + ".");
      }
    for (const GroupResult &g : groups)
      sentences.push_back(
        "Squealing against silent pads, " + QuantityText(g.feature).name +
        ": " + verdict_text(g.verdict, p.is_synthetic) + ". " + g.reason);
    return sentences;
  }



  std::vector<std::string>
  shared_cause_sentences(const std::vector<PadLink>  &links,
                         const CorrelationParameters &p)
  {
    // the index with the largest correlation stands for all of a feature
    std::map<std::pair<std::size_t, std::string>, const PadLink *> best;
    for (const PadLink &l : links)
      if (std::isfinite(l.test.r))
        {
          const PadLink *&other = best[{l.pad, l.feature}];
          if (other == nullptr || std::abs(l.test.r) > std::abs(other->test.r))
            other = &l;
        }
    std::vector<std::string> sentences;
    for (const auto &[key, link] : best)
      {
        const LinkTest &t = link->test;
        sentences.push_back(
          "Pad " + std::to_string(link->pad + 1) + ", " +
          QuantityText(link->feature).name +
          ": any map that concentrates at the leading edge, " +
          choice_name(t.reference.edge) +
          ", would reach r = " + rounded_text(t.reference.leading_edge, 2) +
          ", any that concentrates at the rim r = " +
          rounded_text(t.reference.rim, 2) + "; the best index, " +
          QuantityText(link->index).name + ", reaches " + rounded_text(t.r, 2) +
          (t.conditional.is_known
             ? ", and " + rounded_text(t.conditional.r, 2) +
                 " once shared causes are taken out"
             : "") +
          ": " + verdict_text(t.verdict, p.is_synthetic) + " (without: " +
          verdict_text(t.verdict_without, p.is_synthetic) + ").");
      }
    return sentences;
  }
} // namespace squeal::tribology
