// SPDX-License-Identifier: LGPL-2.1-or-later

// Factors that do not fit into memory: on disk they give the same results, and
// what fits nowhere is refused with its size.

#include "scenes.h"
#include "worst.h"

#include <deal.II/base/mpi.h>

#include <malloc.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>

using namespace squeal;
using namespace squeal::testing;

namespace
{
  namespace fs = std::filesystem;

  constexpr double top = 8000.;

  std::size_t
  n_entries(const fs::path &folder)
  {
    return std::distance(fs::directory_iterator(folder),
                         fs::directory_iterator());
  }

  fs::path
  new_folder(const std::string &name)
  {
    const fs::path folder = fs::path("out_of_core") / name;
    fs::remove_all(folder);
    fs::create_directories(folder);
    return folder;
  }

  FactorStorage
  on_disk(const fs::path &folder)
  {
    return {FactorStorage::Place::disk, folder.string(), 0.};
  }

  /** No more memory than @p bytes beyond what the process uses. */
  class MemoryLimit
  {
  public:
    explicit MemoryLimit(const double bytes)
    {
      ::getrlimit(RLIMIT_AS, &former);
      std::ifstream in("/proc/self/statm");
      double        pages = 0.;
      in >> pages;
      struct rlimit limit = former;
      limit.rlim_cur = static_cast<rlim_t>(pages * ::getpagesize() + bytes -
                                           ::mallinfo2().fordblks);
      ::setrlimit(RLIMIT_AS, &limit);
    }
    ~MemoryLimit()
    {
      ::setrlimit(RLIMIT_AS, &former);
    }

  private:
    struct rlimit former;
  };

  /** @p dashpots per spring, N s/m: damping of a few rows is a matrix of its
   * own. */
  void
  test_same_results(const double dashpots)
  {
    SceneParameters scene = coarse_brake(.4);
    for (SpringParameters &spring : scene.springs)
      spring.dashpot = dashpots;
    Model                model(scene, 2, top);
    const fs::path       folder = new_folder("same");
    const double         shift  = std::pow(2. * M_PI * top, 2);
    const ShiftedInverse memory(model.pencil, shift);
    check(memory.place() == FactorPlace::memory, "factors stay in memory");
    {
      const ShiftedInverse disk(model.pencil, shift, on_disk(folder));
      check(disk.place() == FactorPlace::disk, "factors are on disk");
      check(n_entries(folder) == 1, "their files are in the folder given");
      check(disk.n_modes_below() == memory.n_modes_below(),
            "the inertia is the same");
      const UndampedModes a = undamped_modes(model.pencil, memory);
      const UndampedModes b = undamped_modes(model.pencil, disk);
      // omega^2 = shift + 1 / theta, and each theta is good to 1e-10.
      const auto below = a.omega_squared.head(a.n_certified).array();
      check_below(((b.omega_squared.head(a.n_certified).array() - below) /
                   (below - memory.shift()))
                    .abs()
                    .maxCoeff<Eigen::PropagateNaN>(),
                  2e-10,
                  "the same modes");
      const ComplexPairs kept =
        CertifiedSolver(model.pencil, memory, a).solve(band(500., top));
      const ComplexPairs anew =
        CertifiedSolver(
          model.pencil, disk, b, nullptr, BasisProducts::computed_anew)
          .solve(band(500., top));
      check(anew.size() == kept.size() && kept.size() > 8, "as many pairs");
      for (unsigned int i = 0; i < kept.size(); ++i)
        {
          check_below(distance(anew.lambda, kept.lambda[i]),
                      1e-9,
                      "the same pair at " + number(kept.frequency(i)) + " Hz");
          check_below(anew.residual[i], 1e-8, "its residual");
          check_below(anew.left_residual[i], 1e-4, "its left residual");
        }
    }
    check(n_entries(folder) == 0, "the files are gone with the factor");
  }

  void
  test_too_large()
  {
    Model          model(coarse_brake(.4), 4, top);
    const fs::path folder = new_folder("large");
    const double   shift  = std::pow(2. * M_PI * top, 2);
    const double   needed = ShiftedInverse(model.pencil, shift).needed_memory();
    check(needed > 1e7, "needs " + number(needed) + " bytes");

    FactorStorage storage{FactorStorage::Place::automatic, folder.string(), 0.};
    // What the entries take on the way to the factor is about as much again.
    storage.reserve = 2.3 * needed;
    {
      const MemoryLimit    limit(4.1 * needed);
      const ShiftedInverse inverse(model.pencil, shift, storage);
      check(inverse.place() == FactorPlace::disk,
            "automatic: on disk where memory is short");
    }
    check(n_entries(folder) == 0, "nothing is left");

    const auto refusal = [&](const FactorStorage &s,
                             const double         bytes) -> std::string {
      const MemoryLimit limit(bytes);
      try
        {
          ShiftedInverse(model.pencil, shift, s);
        }
      catch (const NotEnoughMemory &e)
        {
          return e.what();
        }
      return "";
    };
    const auto holds = [](const std::string &text, const std::string &part) {
      return text.find(part) != std::string::npos;
    };
    const std::string plain =
      refusal({FactorStorage::Place::memory, "", 0.}, 0.9 * needed);
    check(holds(plain, "the factors need ") && holds(plain, " GB a rank"),
          "refused with what is needed: " + plain);
    const std::string beside =
      refusal({FactorStorage::Place::memory, "", 2.3 * needed}, 4.1 * needed);
    check(holds(beside, "the factors and what stands beside them need "),
          "refused with what else is needed: " + beside);
    const std::string disk = refusal(on_disk(folder), 0.3 * needed);
    check(holds(disk, "even when they are kept on disk"),
          "refused where the disk does not help: " + disk);
    check(n_entries(folder) == 0, "a refusal leaves nothing");
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_same_results(0.);
  test_same_results(1.);
  test_too_large();
  return 0;
}
