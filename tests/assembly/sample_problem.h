// SPDX-License-Identifier: LGPL-2.1-or-later
// Small surfaces, rough fields on them, and the assembled Lagrangian as a function of all nodal values.
#pragma once

#include <pellicle/assembly/assembler.h>
#include <pellicle/discretization/builders.h>
#include <pellicle/models/vesicle_scene.h>
#include <pellicle/potentials/constraints/enclosed_volume.h>
#include <pellicle/potentials/constraints/total_area.h>
#include <pellicle/potentials/density_potential.h>
#include <pellicle/potentials/energies/helfrich_bending.h>
#include <pellicle/potentials/energies/pressure.h>
#include <pellicle/potentials/energies/surface_tension.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

namespace pellicle::test
{
/** A closed surface in space, a meridian and half a meridian; few cells. */
inline std::vector<std::pair<std::string, SurfaceDiscretization>> small_surfaces()
{
  return {{"surface", on_cube_sphere(ellipsoid({{1.1, 0.9, 1.3}}), 2, 0)},
          {"meridian", on_meridian(ellipsoid({{0.8, 0.8, 1.3}}), 3, 0, false)},
          {"half meridian", on_meridian(ellipsoid({{0.8, 0.8, 1.3}}), 3, 0, true)}};
}

/** Everything that this room must be able to add up, with unequal coefficients. */
inline PotentialSet all_terms()
{
  PotentialSet set;
  set.energies.push_back(
      std::make_shared<DensityPotential<HelfrichBending>>("helfrich bending", HelfrichBending{1.3, 0.4}));
  set.energies.push_back(std::make_shared<DensityPotential<SurfaceTension>>("surface tension", SurfaceTension{0.7}));
  set.energies.push_back(std::make_shared<DensityPotential<Pressure>>("pressure", Pressure{-0.6}));
  set.constraints.resize(2);
  set.constraints[0].measure = std::make_shared<DensityPotential<TotalArea>>("area constraint", TotalArea{});
  set.constraints[1].measure =
      std::make_shared<DensityPotential<EnclosedVolume>>("volume constraint", EnclosedVolume{});
  return set;
}

/** Random numbers in [-size, size], in the nodes' admissible directions. */
inline NodalVectors random_vectors(const SurfaceDiscretization &surface, const double size, const unsigned int seed)
{
  std::mt19937 random(seed);
  NodalVectors result(3 * surface.n_nodes, 0.);
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
  {
    const AdmissibleDirections directions = surface.admissible.empty() ? AdmissibleDirections{} : surface.admissible[I];
    for (unsigned int j = 0; j < directions.count; ++j)
    {
      const double value = size * (random() / 2147483648. - 1.);
      for (unsigned int c = 0; c < 3; ++c)
        result[3 * I + c] += value * directions.columns[j][c];
    }
  }
  return result;
}

inline FieldValues sum(FieldValues a, const double factor, const FieldValues &b)
{
  for (std::size_t f = 0; f < a.size(); ++f)
    for (std::size_t i = 0; i < a[f].size(); ++i)
      a[f][i] += factor * b[f][i];
  return a;
}

inline double dot(const FieldValues &a, const FieldValues &b)
{
  double result = 0.;
  for (std::size_t f = 0; f < a.size(); ++f)
    for (std::size_t i = 0; i < a[f].size(); ++i)
      result += a[f][i] * b[f][i];
  return result;
}

inline double norm(const FieldValues &a)
{
  return std::sqrt(dot(a, a));
}

/** Sum of energies + lambda . g with its derivatives in plain R^3. */
class Lagrangian
{
public:
  Lagrangian(const SurfaceDiscretization &discretization, PotentialSet potentials)
      : surface(discretization)
      , set(std::move(potentials))
      , layout(set)
      , assembler(surface, layout, set, communicator, Assembler::everything(set, layout))
      , multipliers(set.constraints.size())
  {
    for (std::size_t k = 0; k < multipliers.size(); ++k)
      multipliers[k] = 0.9 - 1.7 * static_cast<double>(k);
  }

  /** The start shape with rough nodes and rough other fields. */
  FieldValues rough_fields() const
  {
    FieldValues fields = directions(0.05, 1);
    for (std::size_t f = 1; f < fields.size(); ++f)
      fields[f] = random_vectors(surface, 1., 17 + static_cast<unsigned int>(f));
    for (std::size_t i = 0; i < fields[0].size(); ++i)
      fields[0][i] += surface.positions[i];
    return fields;
  }
  FieldValues directions(const double size, const unsigned int seed) const
  {
    FieldValues fields;
    for (std::size_t f = 0; f < layout.fields().size(); ++f)
      fields.push_back(random_vectors(surface, size, seed + 100 * static_cast<unsigned int>(f)));
    return fields;
  }

  double value(const FieldValues &fields)
  {
    const TermValues terms = assembler.loop(set, fields, multipliers, Order::value);
    double result          = 0.;
    for (const double e : terms.energies)
      result += e;
    for (std::size_t k = 0; k < multipliers.size(); ++k)
      result += multipliers[k] * terms.constraints[k];
    return result;
  }
  FieldValues gradient(const FieldValues &fields)
  {
    FieldValues result(fields.size(), NodalVectors(3 * surface.n_nodes, 0.));
    assembler.loop(set, fields, multipliers, Order::gradient,
                   [&](const Cell &cell, const Element &element, const auto &)
                   {
                     for_rows(cell, [&](const std::size_t f, const std::size_t i, const std::size_t row)
                              { result[f][i] += element.gradient[row]; });
                   });
    return result;
  }
  /** Matrix times a direction. */
  FieldValues matrix_times(const FieldValues &fields, const FieldValues &direction)
  {
    FieldValues result(fields.size(), NodalVectors(3 * surface.n_nodes, 0.));
    assembler.loop(
        set, fields, multipliers, Order::hessian,
        [&](const Cell &cell, const Element &element, const auto &)
        {
          for_rows(cell,
                   [&](const std::size_t f, const std::size_t i, const std::size_t row)
                   {
                     for_rows(cell, [&](const std::size_t g, const std::size_t j, const std::size_t column)
                              { result[f][i] += element.matrix[row * element.n_rows + column] * direction[g][j]; });
                   });
        });
    return result;
  }

  /** Calls with field, index within its nodal vectors, row of the cell's contribution. */
  template <typename Action>
  void for_rows(const Cell &cell, const Action &action) const
  {
    for (std::size_t f = 0; f < layout.fields().size(); ++f)
      for (unsigned int c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < cell.n_nodes; ++i)
          action(f, 3 * cell.nodes[i] + c, (3 * f + c) * cell.n_nodes + i);
  }

  const SurfaceDiscretization &surface;
  PotentialSet set;
  FieldLayout layout;
  Communicator communicator;
  Assembler assembler;
  std::vector<double> multipliers;
};
} // namespace pellicle::test
