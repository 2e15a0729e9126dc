// SPDX-License-Identifier: LGPL-2.1-or-later

// OpenBLAS works with the widest kernels that the processor has, also where it
// does not know the processor; what the user sets stays.

#include "../analyses/program.h"
#include "check.h"

#include <squeal/base/blas_kernels.h>

#include <cstdlib>

using namespace squeal;
using squeal::testing::check;

namespace
{
  const std::set<std::string> sse = {"sse", "sse2", "ssse3", "sse4_1"};

  std::set<std::string>
  with(std::set<std::string> flags, const std::set<std::string> &more)
  {
    flags.insert(more.begin(), more.end());
    return flags;
  }

  void
  widest_follow_the_flags()
  {
    using blas_kernels::widest;
    const auto avx2 = with(sse, {"avx", "avx2", "fma"});
    const auto avx512 =
      with(avx2, {"avx512f", "avx512dq", "avx512cd", "avx512bw", "avx512vl"});
    check(widest({}).empty() && widest(sse).empty(), "SSE: the library's own");
    check(widest(with(sse, {"avx"})) == "Sandybridge", "AVX");
    check(widest(with(sse, {"avx", "avx2"})) == "Sandybridge",
          "AVX2 without fused products");
    check(widest(avx2) == "Haswell", "AVX2");
    check(widest(with(avx2, {"avx512f", "avx512cd"})) == "Haswell",
          "part of AVX-512");
    check(widest(avx512) == "SkylakeX", "AVX-512");
  }

  void
  narrower_by_vector_length()
  {
    using blas_kernels::are_narrower;
    check(are_narrower("Prescott", "Haswell"), "SSE3 under AVX2");
    check(are_narrower("haswell", "SkylakeX"), "any case");
    check(!are_narrower("Zen", "Haswell") && !are_narrower("Haswell", "Zen"),
          "as wide");
    check(!are_narrower("SkylakeX", "Haswell"), "wider");
    check(!are_narrower("Unheard", "SkylakeX") && !are_narrower("Prescott", ""),
          "unknown ones are left alone");
  }

  /** What the program says it works with; @p core is set by the user unless it
   * is empty. */
  std::string
  kernels_of(const std::string &program, const std::string &core)
  {
    const auto outcome = testing::run_program({program, "--version"}, [&]() {
      if (core.empty())
        unsetenv("OPENBLAS_CORETYPE");
      else
        setenv("OPENBLAS_CORETYPE", core.c_str(), 1);
    });
    check(outcome.code == 0, program + " --version ends well");
    const std::string title = "OpenBLAS kernels ";
    const auto        start = outcome.output.find(title);
    check(start != std::string::npos, "the kernels are named");
    const auto end = outcome.output.find('\n', start);
    return outcome.output.substr(start + title.size(),
                                 end - start - title.size());
  }

  void
  programs_take_the_widest(const std::vector<std::string> &programs)
  {
    const std::string best =
      blas_kernels::widest(blas_kernels::processor_flags());
    for (const std::string &program : programs)
      {
        check(!blas_kernels::are_narrower(kernels_of(program, ""), best),
              program + " has kernels as wide as " + best);
        check(kernels_of(program, "Prescott") == "Prescott",
              program + " leaves the user's choice");
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  widest_follow_the_flags();
  narrower_by_vector_length();
  programs_take_the_widest({argv + 1, argv + argc});
  return 0;
}
