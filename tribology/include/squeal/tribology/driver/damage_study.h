// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_driver_damage_study_h
#define squeal_tribology_driver_damage_study_h

#include <squeal/results/table.h>
#include <squeal/tribology/damage/damage_files.h>
#include <squeal/tribology/damage/damage_table.h>
#include <squeal/tribology/driver/context.h>
#include <squeal/tribology/history/face_areas.h>

namespace squeal::tribology
{
  /** One pair of a history with all that is computed from it. */
  struct DamageStudy
  {
    /** @p pair: empty where the history has but one. Throws InputError where
     * the areas of the nodes contradict their places. */
    DamageStudy(const std::string       &file,
                const std::string       &pair,
                const HistoryParameters &history)
      : reader(file, pair)
      , window(history_window(reader, history))
      , grid(reader.layout())
    {
      require_areas_of_face(reader.layout(), file);
    }

    /** What stands behind the names of files: "_<pair>". */
    std::string
    suffix() const
    {
      const std::string &pair = reader.layout().pair;
      return pair.empty() ? pair : "_" + pair;
    }

    HistoryReader                reader;
    HistoryWindow                window;
    ContactGrid                  grid;
    HistoryDamage                damage;
    std::vector<SubsurfacePoint> subsurface;
  };

  /** Pictures of a damage @p table into the folder `plots`: maps of damage and
   * of the surface indices, over the silent run if the table has one, largest
   * values over depth, and the worst node's counts. */
  void draw_damage_pictures(Context           &context,
                            const DamageStudy &study,
                            const Table       &table,
                            bool               has_silent);

  /** Sections of a @p report: what was done and what the histories do not tell
   * (pauses, tension, order), damage with its pictures, the face, below it, and
   * limits. @p silent: the run it is compared with, or null. */
  void report_damage(HtmlReport        &report,
                     const Context     &context,
                     const Table       &table,
                     const Table       &sums,
                     const DamageStudy &study,
                     const DamageStudy *silent);
} // namespace squeal::tribology

#endif
