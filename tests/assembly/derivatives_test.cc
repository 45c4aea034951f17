// SPDX-License-Identifier: LGPL-2.1-or-later
// Assembled gradients and matrices against differences of the assembled energy.
#include "sample_problem.h"

#include <pellicle/potentials/energies/incompressible_rubber_skin.h>
#include <pellicle/potentials/energies/mesh_distortion.h>

#include <gtest/gtest.h>

#include <cmath>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** Reads second derivatives, and nothing else does; mixes slots, products of all kinds. */
struct SecondDerivativeDensity
{
  static constexpr std::array<FieldUse, 2> fields{{{"director", Derivatives::none, FieldRole::independent},
                                                   {"position", Derivatives::second, FieldRole::independent}}};
  static constexpr bool reparametrisation_invariant = false;

  template <typename Number>
  Number density(const PointInputs<Number, 2> &inputs, const PointData & /*data*/) const
  {
    const auto &x = inputs[1];
    return dot(x.d11(), x.d22()) + 0.3 * dot(x.d12(), x.d12()) * dot(x.d1(), x.d1()) +
           dot(inputs[0].value(), cross(x.d11(), x.d2())) +
           0.1 * dot(x.value(), x.d22()) * dot(inputs[0].value(), x.value());
  }
};

/** Errors of central differences fall by four when their step is halved. */
void expect_second_order(const double error, const double error_of_half_step, const std::string &what)
{
  EXPECT_NEAR(std::log2(error / error_of_half_step), 2., 0.1) << what << ": " << error << ", " << error_of_half_step;
}

void check_derivatives(Lagrangian &lagrangian, const std::string &what)
{
  const FieldValues fields = lagrangian.rough_fields(), gradient = lagrangian.gradient(fields);
  for (unsigned int seed = 5; seed < 8; ++seed)
  {
    const FieldValues direction = lagrangian.directions(1., seed), product = lagrangian.matrix_times(fields, direction);
    double gradient_error[2], matrix_error[2];
    for (int half = 0; half < 2; ++half)
    {
      const double eps        = half == 0 ? 4e-4 : 2e-4;
      const FieldValues ahead = sum(fields, eps, direction), behind = sum(fields, -eps, direction);
      gradient_error[half] =
          std::abs((lagrangian.value(ahead) - lagrangian.value(behind)) / (2. * eps) - test::dot(gradient, direction));
      const FieldValues difference = sum(lagrangian.gradient(ahead), -1., lagrangian.gradient(behind));
      FieldValues error            = product;
      for (FieldValues::value_type &values : error)
        for (double &value : values)
          value *= -1.;
      matrix_error[half] = test::norm(sum(error, 0.5 / eps, difference));
    }
    EXPECT_LT(gradient_error[1], 1e-4 * std::abs(test::dot(gradient, direction)) + 1e-4 * test::norm(gradient)) << what;
    EXPECT_LT(matrix_error[1], 1e-4 * test::norm(product)) << what;
    expect_second_order(gradient_error[0], gradient_error[1], what + ", gradient");
    expect_second_order(matrix_error[0], matrix_error[1], what + ", matrix");

    // <a, K b> = <b, K a>
    const FieldValues other = lagrangian.directions(1., seed + 40);
    EXPECT_NEAR(test::dot(other, product), test::dot(direction, lagrangian.matrix_times(fields, other)),
                1e-12 * test::norm(other) * test::norm(product))
        << what;
  }
}

TEST(Derivatives, SumOfAllTerms)
{
  for (const auto &[name, surface] : small_surfaces())
  {
    Lagrangian lagrangian(surface, all_terms());
    check_derivatives(lagrangian, name);
  }
}

TEST(Derivatives, DensityWithSecondDerivatives)
{
  for (const auto &[name, surface] : small_surfaces())
  {
    PotentialSet set = all_terms();
    set.energies.push_back(
        std::make_shared<DensityPotential<SecondDerivativeDensity>>("second derivatives", SecondDerivativeDensity{}));
    Lagrangian lagrangian(surface, set);
    EXPECT_EQ(lagrangian.layout.fields()[0].n_slots, 6u);
    EXPECT_EQ(lagrangian.layout.fields()[lagrangian.layout.index("director")].n_slots, 1u);
    check_derivatives(lagrangian, name);
  }
}

/** Metric of the start shape at every quadrature point. */
std::vector<ReferenceMetric> start_metric(const SurfaceDiscretization &surface)
{
  std::vector<ReferenceMetric> metric;
  std::vector<double> x(18 * surface.tables.n_points);
  for (std::size_t cell = 0; cell < surface.n_cells; ++cell)
  {
    evaluate_field(surface.tables, &surface.cell_nodes[cell * surface.n_local()], surface.positions, 3, x.data());
    for (unsigned int q = 0; q < surface.tables.n_points; ++q)
    {
      const Vector3<double> x1(x[18 * q + 3], x[18 * q + 4], x[18 * q + 5]),
          x2(x[18 * q + 6], x[18 * q + 7], x[18 * q + 8]);
      metric.push_back({pellicle::dot(x1, x1), pellicle::dot(x1, x2), pellicle::dot(x2, x2)});
    }
  }
  return metric;
}

TEST(Derivatives, MeshEnergyVanishesAtItsReferenceOnly)
{
  for (const auto &[name, surface] : small_surfaces())
  {
    PotentialSet set;
    set.energies.push_back(make_mesh_distortion(start_metric(surface)));
    Lagrangian lagrangian(surface, set);
    EXPECT_NEAR(lagrangian.value({surface.positions}), 0., 1e-12) << name;
    EXPECT_NEAR(test::norm(lagrangian.gradient({surface.positions})), 0., 1e-11) << name;
    EXPECT_GT(lagrangian.value(lagrangian.rough_fields()), 1e-2) << name;
    check_derivatives(lagrangian, name);
  }
}

// A shape stretched by l in all directions has the energy (mu/2) (2 l^2 + l^-4 - 3) times its area before.
TEST(Derivatives, SkinOfAStretchedShape)
{
  const double mu = 1.7, l = 1.2;
  for (const auto &[name, surface] : small_surfaces())
  {
    PotentialSet skin, area;
    skin.energies.push_back(std::make_shared<DensityPotential<ElasticSkin<IncompressibleRubberSkin>>>(
        "skin", ElasticSkin<IncompressibleRubberSkin>{
                    {mu}, std::make_shared<const std::vector<ReferenceMetric>>(start_metric(surface))}));
    area.energies.push_back(std::make_shared<DensityPotential<TotalArea>>("area", TotalArea{}));
    Lagrangian lagrangian(surface, skin);
    const FieldValues start{surface.positions}, stretched = sum(start, l - 1., start);
    EXPECT_NEAR(lagrangian.value(start), 0., 1e-12) << name;
    EXPECT_NEAR(test::norm(lagrangian.gradient(start)), 0., 1e-12) << name;
    EXPECT_NEAR(lagrangian.value(stretched),
                mu / 2. * (2. * l * l + std::pow(l, -4) - 3.) * Lagrangian(surface, area).value(start), 1e-11)
        << name;
    check_derivatives(lagrangian, name);
  }
}

/** w = t + r x (position), r x (other vectors): the derivative of a rigid motion of everything. */
FieldValues rigid_motion(const FieldValues &fields, const RigidMotion &motion)
{
  const Vector3<double> t(motion.translation[0], motion.translation[1], motion.translation[2]);
  const Vector3<double> r(motion.rotation[0], motion.rotation[1], motion.rotation[2]);
  FieldValues result = fields;
  for (std::size_t f = 0; f < fields.size(); ++f)
    for (std::size_t i = 0; i < fields[f].size(); i += 3)
    {
      Vector3<double> w = cross(r, Vector3<double>(fields[f][i], fields[f][i + 1], fields[f][i + 2]));
      if (f == 0)
        w += t;
      for (unsigned int c = 0; c < 3; ++c)
        result[f][i + c] = w[c];
    }
  return result;
}

// Volume and area of a closed surface do not change either, however rough it is.
TEST(Derivatives, RigidMotionsDoNoWork)
{
  for (const auto &[name, surface] : small_surfaces())
  {
    Lagrangian lagrangian(surface, all_terms());
    const FieldValues fields = lagrangian.rough_fields(), gradient = lagrangian.gradient(fields);
    EXPECT_EQ(surface.rigid_motions.size(), name == "surface" ? 6u : name == "meridian" ? 1u : 0u);
    for (const RigidMotion &motion : surface.rigid_motions)
    {
      const FieldValues w = rigid_motion(fields, motion);
      EXPECT_NEAR(test::dot(gradient, w), 0., 1e-13 * test::norm(gradient) * test::norm(w)) << name;
    }
  }
}

TEST(Derivatives, EnergyOfATurnedAndShiftedSurface)
{
  const auto surface = on_cube_sphere(ellipsoid({{1.1, 0.9, 1.3}}), 2, 0);
  Lagrangian lagrangian(surface, all_terms());
  const FieldValues fields = lagrangian.rough_fields();
  FieldValues moved        = fields;
  const double c = std::cos(0.7), s = std::sin(0.7);
  for (std::size_t f = 0; f < fields.size(); ++f)
    for (std::size_t i = 0; i < fields[f].size(); i += 3)
    {
      const double *v       = &fields[f][i];
      const double turned[] = {v[1], c * v[2] - s * v[0], s * v[2] + c * v[0]}; // determinant 1
      for (unsigned int d = 0; d < 3; ++d)
        moved[f][i + d] = turned[d] + (f == 0 ? 2. - d : 0.);
    }
  EXPECT_NEAR(lagrangian.value(moved), lagrangian.value(fields), 1e-12 * std::abs(lagrangian.value(fields)) + 1e-12);
}
} // namespace
