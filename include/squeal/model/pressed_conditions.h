// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_model_pressed_conditions_h
#define squeal_model_pressed_conditions_h

#include <squeal/contact/contact_terms.h>
#include <squeal/parameters/parameters.h>

#include <memory>
#include <vector>

namespace squeal
{
  class Timers;

  /**
   * The contact of steady sliding under one condition after another: of scenes
   * on one mesh that differ by moduli, loads and sliding. The open scene is
   * made ready once, and its statics are solved part by part where those of
   * other moduli follow from them, see StaticsByPart.
   */
  class PressedConditions
  {
  public:
    PressedConditions();
    ~PressedConditions();

    /** Of every pair of @p here; none where no contact state is that of the
     * preload. @p bodies: the same number under conditions whose bodies and
     * loads are the same. Throws InputError. Collective. */
    std::vector<ContactStates> states(const Parameters &here,
                                      const std::size_t bodies,
                                      Timers           &timers);

  private:
    struct Condition;

    std::unique_ptr<const Condition> first;
    std::size_t                      bodies_of_first = 0;
  };
} // namespace squeal

#endif
