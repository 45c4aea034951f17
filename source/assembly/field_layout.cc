// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/field_layout.h>

#include <algorithm>

namespace pellicle
{
FieldLayout::FieldLayout(const PotentialSet &set)
{
  list.push_back({"position", FieldRole::independent, n_slots(Derivatives::first), 0, FieldSpace::vectors});
  for (const auto &energy : set.energies)
    declare(*energy);
  for (const Constraint &constraint : set.constraints)
  {
    for (std::size_t p = 0; p < constraint.n_parts(); ++p)
      declare(constraint.part(p));
    if (constraint.self_term)
      declare(*constraint.self_term);
  }
  for (const Dissipation &dissipation : set.dissipations)
    declare(*dissipation.over_step);
  for (Field &field : list)
  {
    field.offset = inputs;
    inputs += 3 * field.n_slots;
  }
}

void FieldLayout::declare(const Potential &potential)
{
  for (const FieldUse &use : potential.fields())
  {
    const auto found = std::find_if(list.begin(), list.end(), [&](const Field &f) { return f.name == use.name; });
    if (found == list.end())
      list.push_back({std::string(use.name), use.role, n_slots(use.derivatives), 0, use.space});
    else
    {
      PELLICLE_ASSERT(found->role == use.role, "two potentials declare different roles for one field");
      found->n_slots = std::max(found->n_slots, n_slots(use.derivatives));
    }
  }
}

bool FieldLayout::has(const std::string_view name) const
{
  return std::any_of(list.begin(), list.end(), [&](const Field &f) { return f.name == name; });
}

unsigned int FieldLayout::index(const std::string_view name) const
{
  const auto found = std::find_if(list.begin(), list.end(), [&](const Field &f) { return f.name == name; });
  PELLICLE_ASSERT(found != list.end(), "no such field in this scene");
  return static_cast<unsigned int>(found - list.begin());
}

std::vector<unsigned int> FieldLayout::offsets(const Potential &potential) const
{
  std::vector<unsigned int> result;
  for (const FieldUse &use : potential.fields())
    result.push_back(list[index(use.name)].offset);
  return result;
}
} // namespace pellicle
