// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_results_signature_h
#define squeal_results_signature_h

#include <squeal/results/table.h>

#include <complex>
#include <map>
#include <string>
#include <vector>

namespace squeal
{
  /** Displacements of a shape at sampled points. */
  using Signature = std::vector<std::complex<double>>;

  /**
   * signature.csv: for every pair of a run its displacement at sampled points,
   * by which two runs on different meshes recognise each other's shapes. Each
   * row is `index,re_<entry>,im_<entry>,...` with real and imaginary part of
   * one sample after the other; an entry names the body and the number of the
   * sample in it, so that the order of the bodies does not matter. The phase
   * and size of a shape do not matter either.
   */
  Table make_signature_table(const std::vector<long long>   &indices,
                             const std::vector<std::string> &entries,
                             const std::vector<Signature>   &samples);

  /** |a^H b|^2 / (a^H a b^H b) of two signatures; 0 if one vanishes. */
  double modal_assurance(const Signature &a, const Signature &b);

  /** The signatures of a run. */
  struct SignatureFile
  {
    /** Of every sample; none where the file is not there, or of an earlier
     * version, which numbers the samples through all bodies in their order. */
    std::vector<std::string>       entries;
    std::map<long long, Signature> of_pair; /**< by the index of the pair */

    std::size_t n_samples() const;
  };

  /** Nothing where there is no such file. Throws InputError for columns that
   * are none of signatures. */
  SignatureFile read_signatures(const std::string &path);

  /**
   * Brings the samples of @p b into the order of those of @p a. Where that
   * cannot be done both lose their signatures, and the reason is returned, in
   * one line: samples of other bodies or points, or a file of an earlier
   * version. Such a one is taken by the order of its samples where both runs
   * list their bodies alike (@p same_bodies).
   */
  std::string align_signatures(SignatureFile &a,
                               SignatureFile &b,
                               const bool     same_bodies);
} // namespace squeal

#endif
