// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_blas_kernels_h
#define squeal_base_blas_kernels_h

#include <new>
#include <set>
#include <string>

namespace squeal
{
  /**
   * Kernels that OpenBLAS works with, by its own names ("Haswell").
   *
   * OpenBLAS chooses them by the processor's family when it is loaded. A
   * release older than the processor does not know the family and falls back
   * without a word: Debian's 0.3.21 to SSE3 on Intel's family 6, model 207,
   * half the speed in a complex eigenvalue analysis. What the processor can do
   * says its flags, whatever its family.
   */
  namespace blas_kernels
  {
    /** The name of those that the library has chosen. */
    std::string in_use();

    /** Flags of this machine's first processor; empty where /proc/cpuinfo does
     * not tell. */
    std::set<std::string> processor_flags();

    /** The widest kernels that a processor with these @p flags can run among
     * those of OpenBLAS; empty where no flag tells of any that are wider than
     * every processor's. */
    std::string widest(const std::set<std::string> &flags);

    /** Whether kernels of that name use shorter vectors than those of @p other;
     * false where either name is unknown. */
    bool are_narrower(const std::string &name, const std::string &other);

    /**
     * Starts this program once more, with OPENBLAS_CORETYPE set, where the
     * library has chosen kernels narrower than the processor's: they are fixed
     * once it is loaded. To be called first in main(). Does nothing where the
     * user has set OPENBLAS_CORETYPE, or where the program cannot be started
     * again.
     */
    void start_again_with_widest(char **argv);

    /** The most threads that Debian's OpenBLAS works with. */
    constexpr int most_threads = 64;

    /** There is no memory for OpenBLAS to work in. */
    class NoWorkMemory : public std::bad_alloc
    {
    public:
      /** One line. */
      const char *what() const noexcept override;
    };

    /**
     * Sets the number of threads and lets OpenBLAS take the memory that it
     * works in, which it keeps: 128 MB of address space a thread, untouched
     * and so without cost until it is used. OpenBLAS itself takes it at its
     * first product and tries without end where there is none, as under a limit
     * of the shell (ulimit -v). To be called before anything is computed.
     *
     * Throws NoWorkMemory. Threads of the library may then hang at the end of
     * the process: it has to end by std::_Exit().
     *
     * @param n_threads  from 1 to most_threads
     */
    void start_threads(int n_threads);
  } // namespace blas_kernels
} // namespace squeal

#endif
