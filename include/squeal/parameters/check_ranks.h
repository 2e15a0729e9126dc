// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef squeal_parameters_check_ranks_h
#define squeal_parameters_check_ranks_h

namespace squeal
{
  struct Parameters;

  /** Before any work: throws InputError where @p parameters ask for what runs on
   * one rank and there are @p n_ranks. */
  void check_ranks(const Parameters &parameters, const unsigned int n_ranks);
} // namespace squeal

#endif
