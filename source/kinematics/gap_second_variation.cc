// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/base/near_match.h>
#include <pellicle/kinematics/gap_second_variation.h>

namespace pellicle
{
namespace
{
using Row = std::vector<double>;

void add_across(const ClosestPoint &p, const double factor, DenseMatrix &m)
{
  for (const Row &b : p.B)
    m.add_outer(factor / p.gap, b, b);
}

/** -(Q_a right^aT + left^a Q_a^T + b_ab left^a right^bT) */
void add_reduced(const ClosestPoint &p, const std::array<Row, 2> &left, const std::array<Row, 2> &right,
                 const double factor, DenseMatrix &m)
{
  for (unsigned int a = 0; a < p.n_parameters; ++a)
  {
    m.add_outer(-factor, p.Q[a], right[a]);
    m.add_outer(-factor, left[a], p.Q[a]);
    for (unsigned int b = 0; b < p.n_parameters; ++b)
      m.add_outer(-factor * p.curvature(a, b), left[a], right[b]);
  }
}

void add_full(const ClosestPoint &p, const double factor, DenseMatrix &m)
{
  add_reduced(p, p.D, p.D, factor, m);
  std::array<Row, 2> turn; // -a_a . dn_p
  for (unsigned int a = 0; a < p.n_parameters; ++a)
  {
    turn[a] = p.Q[a];
    for (unsigned int b = 0; b < p.n_parameters; ++b)
      for (std::size_t i = 0; i < turn[a].size(); ++i)
        turn[a][i] += p.curvature(a, b) * p.D[b][i];
  }
  for (unsigned int a = 0; a < p.n_parameters; ++a)
    for (unsigned int b = 0; b < p.n_parameters; ++b)
      m.add_outer(factor * p.gap * p.inverse_metric(a, b), turn[a], turn[b]);
  add_across(p, factor, m);
}

void add_equal(const ClosestPoint &p, const double factor, DenseMatrix &m)
{
  add_reduced(p, p.D_hat, p.D, factor, m);
  add_across(p, factor, m);
}

void add_hat(const ClosestPoint &p, const double factor, DenseMatrix &m)
{
  add_reduced(p, p.D_hat, p.D_hat, factor, m);
  add_across(p, factor, m);
}

void add_none(const ClosestPoint & /*point*/, const double /*factor*/, DenseMatrix & /*matrix*/)
{
}

Vector3<double> axis(const unsigned int component)
{
  Vector3<double> e;
  e[component] = 1.;
  return e;
}
} // namespace

const std::vector<GapSecondVariation> &gap_second_variations()
{
  static const std::vector<GapSecondVariation> all = {
      {"full", add_full}, {"equal", add_equal}, {"hat", add_hat}, {"none", add_none}};
  return all;
}

const GapSecondVariation &gap_second_variation(const std::string &name)
{
  std::vector<std::string> names;
  for (const GapSecondVariation &variation : gap_second_variations())
  {
    if (variation.name == name)
      return variation;
    names.push_back(variation.name);
  }
  throw UserError("There is no second variation of the gap '" + name + "'." + suggestion(name, names));
}

// The variation of f_b = (x - x_p) . a_b = 0 in two directions, one after the other, with x - x_p = g n_p.
DenseMatrix parameter_second_variation(const ClosestPoint &p, const MasterPoint &master, const unsigned int a)
{
  DenseMatrix m(p.n_rows());
  for (unsigned int b = 0; b < p.n_parameters; ++b)
  {
    const double s = p.c(a, b);
    for (unsigned int g = 0; g < p.n_parameters; ++g)
    {
      m.add_both_outer(-s, master_row(p.base[b], master.first_values[g]), p.D[g]);
      m.add_both_outer(s * p.gap, master_row(p.normal, master.second_values[b + g]), p.D[g]);
      m.add_both_outer(-s, master_row(p.base[g], master.first_values[b]), p.D[g]);
      m.add_both_outer(s, relative_row(master.second(b, g), master), p.D[g]);
      for (unsigned int d = 0; d < p.n_parameters; ++d)
      {
        const double both =
            p.gap * dot(p.normal, master.third_derivative(b, g, d)) - dot(p.base[b], master.second(g, d));
        m.add_outer(s * both, p.D[g], p.D[d]);
        m.add_both_outer(-s * dot(p.base[g], master.second(b, d)), p.D[g], p.D[d]);
      }
    }
    for (unsigned int component = 0; component < 3; ++component)
      m.add_both_outer(s, relative_row(axis(component), master), master_row(axis(component), master.first_values[b]));
  }
  return m;
}

DenseMatrix simplified_parameter_second_variation(const ClosestPoint &p, const MasterPoint &master,
                                                  const unsigned int a)
{
  DenseMatrix m(p.n_rows());
  for (unsigned int b = 0; b < p.n_parameters; ++b)
  {
    const double s = p.inverse_metric(a, b);
    for (unsigned int g = 0; g < p.n_parameters; ++g)
    {
      const Row moved = master_row(p.base[b], master.first_values[g]);
      m.add_outer(-s, moved, p.D[g]);
      m.add_outer(-s, p.D_hat[g], moved);
      m.add_outer(-s, p.D_hat[g], master_row(p.base[g], master.first_values[b]));
      m.add_outer(s, relative_row(master.second(b, g), master), p.D[g]);
      for (unsigned int d = 0; d < p.n_parameters; ++d)
        m.add_outer(-s * (dot(p.base[b], master.second(g, d)) + dot(p.base[g], master.second(b, d))), p.D_hat[g],
                    p.D[d]);
    }
    for (unsigned int component = 0; component < 3; ++component)
      m.add_outer(s, relative_row(axis(component), master), master_row(axis(component), master.first_values[b]));
  }
  return m;
}
} // namespace pellicle
