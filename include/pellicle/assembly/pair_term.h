// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/assembly/communicator.h>
#include <pellicle/assembly/contact_elements.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pellicle
{
/** What an augmentation changes, or would change. */
struct MultiplierChange
{
  double largest_change   = 0.;
  double largest_traction = 0.;

  /** The change over the traction; 0 without any. */
  double relative() const { return largest_traction > 0. ? largest_change / largest_traction : 0.; }
};

/**
 * An energy of pairs of cells that are no neighbours: which nodes meet depends on where they are, so that no cell of
 * the assembler can hold it. Reads positions only. A multiplier at every point makes exact what a penalty enforces
 * (Uzawa): equilibria with multipliers fixed in turn with augmentations.
 */
class PairTerm
{
public:
  virtual ~PairTerm() = default;

  /** Under which its energy is reported and errors are. */
  virtual const std::string &name() const = 0;
  /** From now on evaluate() gives the share of this process. */
  virtual void distribute(const Communicator &communicator) = 0;
  /** Energy and elements at these positions; throws SolveError where they make no sense. */
  virtual ContactElements evaluate(const NodalVectors &positions, Order order) = 0;
  /** How far tractions at the last evaluation are from the multipliers, and the largest of both. */
  virtual MultiplierChange pending() const = 0;
  /** Takes the tractions of the last evaluation as multipliers; returns what was pending. */
  virtual MultiplierChange augment() = 0;
  /** What lives on from one load step to the next, point by point; zero for points of other processes. */
  virtual std::vector<double> memory() const = 0;
  /** Takes over the memory of all points. */
  virtual void recall(const std::vector<double> &memory) = 0;
  /** Nodes on which it acts tangentially, so that a chart must leave them all directions. */
  virtual std::vector<std::size_t> material_nodes() const { return {}; }
};
} // namespace pellicle
