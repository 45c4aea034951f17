// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/pair_terms.h>
#include <pellicle/base/exceptions.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace pellicle
{
PairTerms::PairTerms(std::vector<std::shared_ptr<PairTerm>> terms, const Communicator &communicator)
    : list(std::move(terms))
    , communicator(communicator)
{
  for (const auto &term : list)
    term->distribute(communicator);
}

// Each process meets the errors of its own points only: that there is one is agreed upon before anybody throws.
std::vector<double> PairTerms::evaluate(const NodalVectors &positions, const Order order)
{
  own_elements.clear();
  std::vector<double> sums(list.size() + 2, 0.);
  std::string failure;
  for (std::size_t k = 0; k < list.size() && failure.empty(); ++k)
    try
    {
      ContactElements of_term = list[k]->evaluate(positions, order);
      std::move(of_term.elements.begin(), of_term.elements.end(), std::back_inserter(own_elements));
      sums[k] = of_term.energy;
      sums[list.size()] += static_cast<double>(of_term.n_active);
    }
    catch (const SolveError &error)
    {
      failure     = "\"" + list[k]->name() + "\": " + error.what();
      sums.back() = 1.;
    }
  communicator.sum(sums);
  if (sums.back() > 0.)
    throw SolveError(failure.empty() ? "A pair of surfaces in contact makes no sense; another process knows which."
                                     : failure);
  active = static_cast<std::size_t>(sums[list.size()]);
  sums.resize(list.size());
  return sums;
}

bool PairTerms::augment(const NodalVectors &positions, const double tolerance)
{
  evaluate(positions, Order::value);
  bool any = false;
  for (const auto &term : list)
  {
    MultiplierChange change = term->pending();
    change.largest_change   = communicator.largest(change.largest_change);
    change.largest_traction = communicator.largest(change.largest_traction);
    any                     = any || change.relative() > tolerance;
  }
  if (any)
    for (const auto &term : list)
      term->augment();
  return any;
}

void PairTerms::exchange(Archive &archive)
{
  for (const auto &term : list)
  {
    std::vector<double> memory = term->memory();
    const std::size_t n        = memory.size();
    if (!archive.is_reading())
      communicator.sum(memory);
    archive | memory;
    if (memory.size() != n)
      throw ArchiveMismatch("contact '" + term->name() + "' has other points");
    if (archive.is_reading())
      term->recall(memory);
  }
}
} // namespace pellicle
