// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/assembler.h>
#include <pellicle/discretization/lagrange_line.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/models/sample_body.h>

#include <boost/math/special_functions/legendre.hpp>

#include <cmath>
#include <utility>

namespace pellicle
{
namespace
{
/** A matrix with a row for each point at which something is wanted. */
struct Interpolation
{
  std::size_t n_from = 0;
  std::vector<double> entries; ///< [to * n_from + from]

  /** Adds sum_from entry * values[from], n components a point, to what is in `result`. */
  void add(const double *values, const unsigned int n, std::vector<double> &result) const
  {
    for (std::size_t row = 0; row * n_from < entries.size(); ++row)
    {
      std::vector<double> sum(n, 0.);
      for (std::size_t from = 0; from < n_from; ++from)
        for (unsigned int c = 0; c < n; ++c)
          sum[c] += entries[row * n_from + from] * values[from * n + c];
      result.insert(result.end(), sum.begin(), sum.end());
    }
  }
};

/** Tensor product of the same interpolation in all directions, first one fastest. */
Interpolation tensor_power(const Interpolation &line, const unsigned int dimension)
{
  Interpolation result = line;
  for (unsigned int d = 1; d < dimension; ++d)
  {
    Interpolation next;
    next.n_from = result.n_from * line.n_from;
    for (std::size_t to = 0; to * line.n_from < line.entries.size(); ++to)
      for (std::size_t row = 0; row * result.n_from < result.entries.size(); ++row)
        for (std::size_t from = 0; from < line.n_from; ++from)
          for (std::size_t column = 0; column < result.n_from; ++column)
            next.entries.push_back(line.entries[to * line.n_from + from] *
                                   result.entries[row * result.n_from + column]);
    result = std::move(next);
  }
  return result;
}

/** From the nodes of a line to i/k. */
Interpolation from_nodes(const unsigned int degree)
{
  const LagrangeLine line(degree);
  Interpolation result;
  result.n_from = degree + 1;
  for (unsigned int i = 0; i <= degree; ++i)
  {
    const LagrangeLine::Values N = line.at(static_cast<double>(i) / degree);
    result.entries.insert(result.entries.end(), N[0].begin(), N[0].begin() + degree + 1);
  }
  return result;
}

/** From Gauss points of a line to i/k, by the projection onto polynomials of degree k - 1. */
Interpolation from_gauss_points(const unsigned int degree, const unsigned int n_gauss_points)
{
  const ShapeTables gauss = make_edge_tables(1, n_gauss_points); // N_1 = xi
  Interpolation result;
  result.n_from = n_gauss_points;
  for (unsigned int i = 0; i <= degree; ++i)
    for (unsigned int q = 0; q < n_gauss_points; ++q)
    {
      double entry = 0.;
      for (int m = 0; m < static_cast<int>(degree); ++m)
        entry += (2 * m + 1) * gauss.weights[q] * boost::math::legendre_p(m, 2. * i / degree - 1.) *
                 boost::math::legendre_p(m, 2. * gauss.tables[0][2 * q + 1] - 1.);
      result.entries.push_back(entry);
    }
  return result;
}

/** Potentials that act on a body, summed at the quadrature points of a cell. */
class BodyPotentials
{
public:
  BodyPotentials(const SurfaceProblem &problem, const BulkPart &body)
      : problem(problem)
      , body(body)
  {
    for (const auto &energy : problem.potentials().energies)
      if (energy->where().part == Where::Part::bulk && energy->where().name == body.name)
        terms.emplace_back(energy.get(), problem.layout().offsets(*energy));
  }

  bool is_empty() const { return terms.empty(); }

  /** Density w per parametric volume, and its gradient with respect to all inputs, into `sums`. */
  void evaluate(const std::size_t cell)
  {
    const std::size_t *const nodes = &body.cell_nodes[cell * body.tables.n_nodes];
    gather_inputs(body.tables, nodes, problem.layout(), problem.state().fields, inputs);
    const unsigned int n = body.tables.n_points;
    sums.reset(n, problem.layout().n_inputs(), Order::gradient);
    const CellPoints points{cell * n, n, problem.layout().n_inputs(), inputs.data(), 0};
    for (const auto &[potential, offsets] : terms)
      potential->add(points, offsets.data(), 1., Order::gradient, sums);
  }

  /** The position's input in a slot (0 value, 1 ",1", ...) at point q, and dw by it. */
  Vector3<double> position(const unsigned int q, const unsigned int slot) const { return at(inputs, q, slot); }
  Vector3<double> gradient(const unsigned int q, const unsigned int slot) const { return at(sums.gradient, q, slot); }
  double value(const unsigned int q) const { return sums.value[q]; }

private:
  Vector3<double> at(const std::vector<double> &list, const unsigned int q, const unsigned int slot) const
  {
    const double *const v = &list[std::size_t(q) * sums.n_inputs + 3 * slot]; // the position comes first
    return {v[0], v[1], v[2]};
  }

  const SurfaceProblem &problem;
  const BulkPart &body;
  std::vector<std::pair<const Potential *, std::vector<unsigned int>>> terms;
  std::vector<double> inputs;
  PointSums sums;
};

/** x,1 . (x,2 x x,3) at all quadrature points of all cells. */
std::vector<double> parametric_volumes(const BulkPart &body, const NodalVectors &positions)
{
  std::vector<double> list;
  for_all_points(body.tables, body.cell_nodes, positions, 4,
                 [&](const WalkPoint &x) { list.push_back(dot(x[1], cross(x[2], x[3]))); });
  return list;
}

double von_mises(const double *s)
{
  const double normal = std::pow(s[0] - s[4], 2) + std::pow(s[4] - s[8], 2) + std::pow(s[8] - s[0], 2),
               shear  = s[1] * s[1] + s[5] * s[5] + s[2] * s[2];
  return std::sqrt(0.5 * normal + 3. * shear);
}

class BodySampler
{
public:
  BodySampler(const SurfaceProblem &problem, const SurfaceDiscretization &discretization, const BulkPart &body,
              const NodalVectors &material_position, const Scales &unit)
      : body(body)
      , x(problem.state().fields[0])
      , X(material_position)
      , unit(unit)
      , potentials(problem, body)
      , volumes(parametric_volumes(body, x))
      , reference_volumes(parametric_volumes(body, X))
  {
    sample.dimension     = discretization.kind == SurfaceDiscretization::Kind::surface ? 3 : 2;
    sample.degree        = discretization.degree;
    sample.n_cells       = body.n_cells;
    unsigned int n_gauss = 1;
    while (std::pow(n_gauss, sample.dimension) < body.tables.n_points - 0.5)
      ++n_gauss;
    nodes_to_points = tensor_power(from_nodes(sample.degree), sample.dimension);
    gauss_to_points = tensor_power(from_gauss_points(sample.degree, n_gauss), sample.dimension);
  }

  SurfaceSample run()
  {
    for (std::size_t cell = 0; cell < body.n_cells; ++cell)
    {
      add_places(cell);
      add_ratios(cell);
    }
    std::vector<double> displacement = sample.points;
    for (std::size_t i = 0; i < displacement.size(); ++i)
      displacement[i] -= material[i];
    sample.fields.push_back({"displacement", 3, std::move(displacement)});
    sample.fields.push_back({"material_position", 3, std::move(material)});
    sample.fields.push_back({"volume_ratio", 1, std::move(volume_ratio)});
    if (!potentials.is_empty())
      add_stress_fields();
    return std::move(sample);
  }

private:
  void add_places(const std::size_t cell)
  {
    const std::size_t *const nodes = &body.cell_nodes[cell * body.tables.n_nodes];
    for (const auto &[values, list] : {std::make_pair(&x, &sample.points), std::make_pair(&X, &material)})
    {
      std::vector<double> of_cell;
      for (std::size_t i = 0; i < nodes_to_points.n_from; ++i)
        for (unsigned int c = 0; c < 3; ++c)
          of_cell.push_back(unit.length * (*values)[3 * nodes[i] + c]);
      nodes_to_points.add(of_cell.data(), 3, *list);
    }
  }

  void add_ratios(const std::size_t cell)
  {
    const unsigned int n = body.tables.n_points;
    std::vector<double> J, w, sigma;
    if (!potentials.is_empty())
      potentials.evaluate(cell);
    for (unsigned int q = 0; q < n; ++q)
    {
      const double j = volumes[cell * n + q], j_reference = reference_volumes[cell * n + q];
      J.push_back(j / j_reference);
      if (potentials.is_empty())
        continue;
      w.push_back(potentials.value(q) / j_reference * unit.of(dimensions::pressure));
      Matrix3 stress;
      for (unsigned int a = 1; a <= 3; ++a)
        stress = stress + outer(potentials.gradient(q, a), potentials.position(q, a));
      for (const double entry : stress.entries)
        sigma.push_back(entry / j * unit.of(dimensions::pressure));
    }
    gauss_to_points.add(J.data(), 1, volume_ratio);
    if (potentials.is_empty())
      return;
    gauss_to_points.add(w.data(), 1, energy_density);
    gauss_to_points.add(sigma.data(), 9, stresses);
  }

  void add_stress_fields()
  {
    std::vector<double> equivalent, pressure;
    for (std::size_t p = 0; p < sample.n_points(); ++p)
    {
      const double *const s = &stresses[9 * p];
      equivalent.push_back(von_mises(s));
      pressure.push_back(-(s[0] + s[4] + s[8]) / 3.);
    }
    sample.fields.push_back({"cauchy_stress", 9, std::move(stresses)});
    sample.fields.push_back({"von_mises_stress", 1, std::move(equivalent)});
    sample.fields.push_back({"mean_pressure", 1, std::move(pressure)});
    sample.fields.push_back({"elastic_energy_density", 1, std::move(energy_density)});
  }

  const BulkPart &body;
  const NodalVectors &x, &X;
  const Scales &unit;
  BodyPotentials potentials;
  std::vector<double> volumes, reference_volumes;
  Interpolation nodes_to_points, gauss_to_points;
  SurfaceSample sample;
  std::vector<double> material, volume_ratio, energy_density, stresses;
};
} // namespace

SurfaceSample sample_body(const SurfaceProblem &problem, const SurfaceDiscretization &discretization,
                          const BulkPart &body, const NodalVectors &material_position, const Scales &unit)
{
  return BodySampler(problem, discretization, body, material_position, unit).run();
}
} // namespace pellicle
