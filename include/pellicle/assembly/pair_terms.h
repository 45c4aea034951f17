// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/pair_term.h>
#include <pellicle/base/archive.h>

#include <memory>
#include <vector>

namespace pellicle
{
/** All pair terms of a problem, on all processes. */
class PairTerms
{
public:
  explicit PairTerms(std::vector<std::shared_ptr<PairTerm>> terms, const Communicator &communicator);

  const std::vector<std::shared_ptr<PairTerm>> &terms() const { return list; }

  /** Energies of the terms, summed over all processes. Throws SolveError, on all processes, with the term's name. */
  std::vector<double> evaluate(const NodalVectors &positions, Order order);
  /** Of the last evaluation, this process's share. */
  const std::vector<ContactElement> &elements() const { return own_elements; }
  /** Points that touch, of all terms and processes, at the last evaluation. */
  std::size_t n_active() const { return active; }

  /** Augments all terms at these positions if one of them would change by more than the tolerance; returns whether it
   * did. */
  bool augment(const NodalVectors &positions, double tolerance);

  /** The memories of all terms. All processes write and read together. */
  void exchange(Archive &archive);

private:
  std::vector<std::shared_ptr<PairTerm>> list;
  const Communicator &communicator;
  std::vector<ContactElement> own_elements;
  std::size_t active = 0;
};
} // namespace pellicle
