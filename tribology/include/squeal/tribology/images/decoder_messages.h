// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_tribology_images_decoder_messages_h
#define squeal_tribology_images_decoder_messages_h

#include <functional>
#include <string>

namespace squeal::tribology
{
  /** What is written to the standard error stream while @p action runs, which
   * does not reach the terminal. The libraries behind OpenCV report damage
   * there and nowhere else. One action at a time, whatever the threads, but
   * they may be nested; what others write meanwhile is caught as well. Empty
   * where the system gives no file in memory: then the messages go where they
   * always do. */
  std::string messages_of(const std::function<void()> &action);

  /** The first line of @p messages in which a decoder says that the pixels are
   * not those that were stored; empty where there is none. Unknown tags of
   * microscopes and the like are no damage. */
  std::string damage_in(const std::string &messages);
} // namespace squeal::tribology

#endif
