// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>
#include <pellicle/potentials/effect.h>

#include <string>
#include <vector>

namespace pellicle
{
/** One field of a scene: a vector per node, and where its inputs stand among the inputs of a point. */
struct Field
{
  std::string name;
  FieldRole role       = FieldRole::independent;
  unsigned int n_slots = 1; ///< as many as the most demanding potential reads
  unsigned int offset  = 0; ///< of its first input within the inputs of a point
  FieldSpace space     = FieldSpace::vectors;
};

/**
 * The fields that the listed potentials and constraints declare, and no others: an effect that is not listed adds no
 * unknowns. `position` comes first; the others follow in the order in which they are declared.
 */
class FieldLayout
{
public:
  explicit FieldLayout(const PotentialSet &set);

  const std::vector<Field> &fields() const { return list; }
  unsigned int n_inputs() const { return inputs; }
  /** Index of a field; asserts that it exists. */
  unsigned int index(std::string_view name) const;
  bool has(std::string_view name) const;
  /** Offsets of a potential's fields, in the order of Potential::fields(). */
  std::vector<unsigned int> offsets(const Potential &potential) const;

private:
  void declare(const Potential &potential);

  std::vector<Field> list;
  unsigned int inputs = 0;
};

/** Nodal values of all fields of a layout, in its order. */
using FieldValues = std::vector<NodalVectors>;
} // namespace pellicle
