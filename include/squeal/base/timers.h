// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_timers_h
#define squeal_base_timers_h

#include <iosfwd>
#include <string>
#include <vector>

namespace squeal
{
  /** Seconds of a clock that never jumps. */
  double wall_seconds();

  /** CPU seconds used so far by this process with all of its threads. */
  double cpu_seconds();

  /** Largest resident memory of this process so far, in MB (10^6 bytes); 0
   * where the system does not tell. */
  double peak_memory_mb();

  /**
   * Wall and CPU time of the named sections of a run: "Setup: ...",
   * "Assemble: ...", "Solve: ...", "Write: ...".
   *
   * Sections nest. What an inner section takes belongs to the inner one alone
   * ("own" times), so the own times of all sections and the untimed rest add
   * up to the run. Sections are opened and closed by the main thread; the CPU
   * time includes all threads of this rank.
   */
  class Timers
  {
  public:
    /** What is known of one section, in seconds. */
    struct Entry
    {
      std::string  name;
      unsigned int count    = 0;  /**< times entered */
      double       wall     = 0.; /**< with the sections inside */
      double       own_wall = 0.; /**< without them */
      double       own_cpu  = 0.;
      unsigned int depth    = 0; /**< sections around it at first entry */
    };

    /** Times its own life. */
    class Section
    {
    public:
      Section(Timers &timers, const std::string &name);
      ~Section();
      Section(const Section &)            = delete;
      Section &operator=(const Section &) = delete;

    private:
      Timers &timers;
    };

    Timers();

    /** Closed sections and the part of open ones before now, in order of first
     * entry. */
    std::vector<Entry> entries() const;

    /** Wall seconds since construction. */
    double total_wall() const;

    /** CPU seconds since construction. */
    double total_cpu() const;

    /** Aligned table: section, calls, wall, own wall, own CPU, share. */
    void print(std::ostream &out) const;

  private:
    struct Open
    {
      std::size_t entry;
      double      start_wall;
      double      start_cpu;
      double      inner_wall;
      double      inner_cpu;
    };

    /** Books the innermost open section of @p open into @p entries. */
    static void close(std::vector<Open> &open, std::vector<Entry> &entries);

    std::vector<Entry> closed;
    std::vector<Open>  open;
    double             start_wall;
    double             start_cpu;
  };
} // namespace squeal

#endif
