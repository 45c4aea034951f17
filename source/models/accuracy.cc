// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/models/accuracy.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pellicle
{
namespace
{
/** Solving costs about this power of the number of unknowns: nested dissection in the plane, a band along a line. */
double log_of_work(const LevelRecord &from, const LevelMesh &to, const LevelRange &range)
{
  const double unknowns = expected_unknowns(from, to, range) / static_cast<double>(from.n_unknowns);
  return (range.dimension == 1 ? 1. : 1.5) * std::log(unknowns);
}

/** What the last step between two levels has brought, if it changed what `is_such` says. */
template <typename F>
std::optional<double> measured(const std::vector<LevelRecord> &levels, const LevelRange &range, const F &is_such)
{
  for (std::size_t i = levels.size(); i-- > 1;)
  {
    const LevelRecord &before = levels[i - 1], &after = levels[i];
    if (is_such(before.mesh, after.mesh) && before.error && after.error && *before.error > 0. && *after.error > 0.)
      return std::log(*before.error / *after.error) / log_of_work(before, after.mesh, range);
    if (i + 1 == levels.size() && !is_such(before.mesh, after.mesh))
      return std::nullopt; // the mesh is another one now
  }
  return std::nullopt;
}

/** One degree more: on cells that resolve the solution the error falls by a factor that hardly depends on the degree.
 */
class RaiseDegree : public NextMesh
{
public:
  std::optional<LevelMesh> after(const LevelRecord &level, const LevelRange &range) const override
  {
    if (level.mesh.degree >= range.highest_degree)
      return std::nullopt;
    return LevelMesh{level.mesh.degree + 1, level.mesh.refinements, level.mesh.cut};
  }
  double promise(const std::vector<LevelRecord> &levels, const LevelRange &range) const override
  {
    // Not yet tried on this mesh: worth trying.
    return measured(levels, range, [](const LevelMesh &a, const LevelMesh &b) { return b.degree > a.degree; })
        .value_or(std::numeric_limits<double>::max());
  }
};

/** All cells cut, as long as they are of one size: energies of smooth solutions converge like h^(2k). */
class RefineAll : public NextMesh
{
public:
  std::optional<LevelMesh> after(const LevelRecord &level, const LevelRange &range) const override
  {
    const LevelMesh &mesh = level.mesh;
    if (mesh.refinements >= range.most_refinements || !mesh.cut.empty())
      return std::nullopt;
    return LevelMesh{mesh.degree, mesh.refinements + 1};
  }
  double promise(const std::vector<LevelRecord> &levels, const LevelRange &range) const override
  {
    const LevelMesh &mesh = levels.back().mesh;
    const double smooth =
        2. * mesh.degree * std::log(2.) / log_of_work(levels.back(), {mesh.degree, mesh.refinements + 1}, range);
    const auto is_refined = [](const LevelMesh &a, const LevelMesh &b) { return b.refinements > a.refinements; };
    return std::min(smooth, measured(levels, range, is_refined).value_or(smooth));
  }
};

/** The cells cut that have most of the errors: what remains are those of the others, and 2^(-2k) of theirs. */
class CutWorst : public NextMesh
{
public:
  std::optional<LevelMesh> after(const LevelRecord &level, const LevelRange & /*range*/) const override
  {
    const double smallest = std::ldexp(1., -finest);
    LevelMesh mesh        = level.mesh;
    for (const CellPlace &place : level.worst.places)
      if (place.size > smallest)
        mesh.cut.push_back(place);
    if (mesh.cut.size() == level.mesh.cut.size())
      return std::nullopt;
    return mesh;
  }
  double promise(const std::vector<LevelRecord> &levels, const LevelRange &range) const override
  {
    const LevelRecord &level = levels.back();
    const double share = level.worst.share, left = 1. - share + share * std::ldexp(1., -2 * int(level.mesh.degree));
    return -std::log(left) / log_of_work(level, *after(level, range), range);
  }

private:
  static constexpr int finest = 20; ///< halvings of the coarsest mesh's cells: beyond, coordinates are round-off
};
} // namespace

void AccuracyParameters::bind(ParameterSection &section)
{
  section.number("Target", target, Range::between(0., 1.), dimensions::none,
                 "Relative error of the headline quantity (vesicle: bending energy; droplet_contact and "
                 "director_membrane: total energy; wetting_ridge: ridge radius) that the run is to reach: degree and "
                 "refinement are raised from coarse ones until the estimated error is below it. 0: the scene's own "
                 "mesh, without an estimate.");
  section.integer("Maximum levels", max_levels, 2, 50, "Meshes that are tried for Target at most.");
  section.integer("Maximum unknowns", max_unknowns, 100, 100000000,
                  "Size of the linear system beyond which no finer mesh is tried for Target: a limit for memory (about "
                  "5 kB an unknown in space) and time.");
  section.choice("Refinement", refinement, {"uniform", "adaptive"},
                 "How meshes are refined for Target. uniform: all cells. adaptive: where it promises more, only the "
                 "cells with the largest errors, for solutions that are local (necks, tethers, contact lines). Meshes "
                 "of soft substrates, of drops with a base in space and of parts that are joined stay uniform.");
}

std::vector<std::unique_ptr<NextMesh>> ways_to_refine()
{
  std::vector<std::unique_ptr<NextMesh>> ways;
  ways.push_back(std::make_unique<RaiseDegree>());
  ways.push_back(std::make_unique<RefineAll>());
  ways.push_back(std::make_unique<CutWorst>());
  return ways;
}

std::optional<LevelMesh> next_level(const std::vector<LevelRecord> &levels, const LevelRange &range)
{
  std::optional<LevelMesh> best;
  double most = 0.;
  for (const auto &way : ways_to_refine())
  {
    const std::optional<LevelMesh> mesh = way->after(levels.back(), range);
    const double promise                = mesh ? way->promise(levels, range) : 0.;
    if (mesh && (!best || promise > most))
    {
      best = mesh;
      most = promise;
    }
  }
  return best;
}

double expected_unknowns(const LevelRecord &level, const LevelMesh &next, const LevelRange &range)
{
  const double along = std::ldexp(1., static_cast<int>(next.refinements) - static_cast<int>(level.mesh.refinements)) *
                       next.degree / level.mesh.degree;
  // A cell that is cut makes two or four of one.
  const double more = (std::ldexp(1., static_cast<int>(range.dimension)) - 1.) *
                      static_cast<double>(next.cut.size() - level.mesh.cut.size()) / static_cast<double>(level.n_cells);
  return static_cast<double>(level.n_unknowns) * std::pow(along, range.dimension) * (1. + more);
}
} // namespace pellicle
