// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_base_blas_kernels_h
#define squeal_base_blas_kernels_h

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
  } // namespace blas_kernels
} // namespace squeal

#endif
