// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/models/meridian_curve.h>

#include <array>

namespace pellicle
{
MeridianCurve::MeridianCurve(const SurfaceDiscretization &meridian, const NodalVectors &positions)
    : meridian(meridian)
    , positions(positions)
    , ends(make_tables_at(meridian.kind, meridian.degree, {{{0., 0.}}, {{1., 0.}}}))
{
}

MeridianPoint MeridianCurve::at(const std::size_t cell, const double xi) const
{
  return evaluate(make_tables_at(meridian.kind, meridian.degree, {{{xi, 0.}}}), cell, 0);
}

MeridianPoint MeridianCurve::evaluate(const ShapeTables &tables, const std::size_t cell, const unsigned int point) const
{
  std::array<double, 36> inputs{}; // at most two points
  evaluate_field(tables, &meridian.cell_nodes[cell * meridian.n_local()], positions, 2, inputs.data());
  const double *const x = inputs.data() + std::size_t(18) * point;
  return {x[0], x[2], x[3]};
}
} // namespace pellicle
