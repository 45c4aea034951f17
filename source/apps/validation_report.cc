// SPDX-License-Identifier: LGPL-2.1-or-later
#include "validation_report.h"

#include <pellicle/assembly/cell_loops.h>
#include <pellicle/output/tables.h>

#include <ostream>

namespace pellicle
{
namespace
{
void write_loop(const CellLoop &loop, std::ostream &out)
{
  out << "\n  " << loop.over << " (" << loop.n_cells << " cells, " << loop.n_points << " points):";
  for (const LoopTerm &term : loop.terms)
  {
    out << "\n    " << kind_name(term.kind) << " '" << term.name << "'";
    if (!term.region.empty())
      out << " on region '" << term.region << "'";
    out << " of";
    for (const std::string &field : term.fields)
      out << ' ' << field;
  }
}
} // namespace

void write_validation_report(const SurfaceScene &scene, const SurfaceModel &model, const Timing &timing,
                             std::ostream &out)
{
  out << "The scene is valid.\nEffects:";
  for (const auto &effect : scene.effects)
    out << "\n  " << effect->name() << ": " << effect->description();
  out << "\nMesh: " << model.n_cells() << " cells of degree " << model.mesh().degree << ", " << model.mesh().n_nodes
      << " nodes\nFields:";
  const SurfaceProblem &problem = model.equilibrium();
  for (const Field &field : problem.layout().fields())
    out << ' ' << field.name;
  out << "\nLoops:";
  for (const CellLoop &loop : cell_loops(problem.discretization(), problem.potentials()))
    write_loop(loop, out);
  out << "\nStart shape:";
  for (const auto &[name, value] : model.quantities())
    out << "\n  " << name << " = " << number_text(value);
  out << "\nSeconds: " << number_text(timing.total()) << std::endl;
}
} // namespace pellicle
