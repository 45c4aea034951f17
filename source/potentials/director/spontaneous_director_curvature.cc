// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/potentials/director/spontaneous_director_curvature.h>
#include <pellicle/potentials/director/tangential_form.h>
#include <pellicle/potentials/director/unit_director_derivatives.h>
#include <pellicle/potentials/energies/helfrich_bending.h>

#include <limits>

namespace pellicle
{
namespace
{
/** A field and a slot of the density. */
struct Input
{
  unsigned int field, slot;
};

/** Adds the derivatives of the triple product a . (b x c). */
void add_triple_product(const PointInputs<double, 2> &inputs, const Input &a, const Input &b, const Input &c,
                        const PointDerivativeView &view)
{
  const Vector3<double> &a_value = inputs[a.field].slots[a.slot], &b_value = inputs[b.field].slots[b.slot],
                        &c_value = inputs[c.field].slots[c.slot];
  view.add_gradient(a.field, a.slot, cross(b_value, c_value));
  view.add_gradient(b.field, b.slot, cross(c_value, a_value));
  view.add_gradient(c.field, c.slot, cross(a_value, b_value));
  if (!view.wants_hessian())
    return;
  view.add_hessian(a.field, a.slot, b.field, b.slot, -1. * cross_matrix(c_value));
  view.add_hessian(a.field, a.slot, c.field, c.slot, cross_matrix(b_value));
  view.add_hessian(b.field, b.slot, c.field, c.slot, -1. * cross_matrix(a_value));
}
} // namespace

// In d the density is a sum of forms of which the derivatives are at hand: a^ab x,a . d,b, the surface term of
// HelfrichBending; |d|^2 + (d . n)^2; and triple products.
void SpontaneousDirectorCurvature::add_derivatives(const PointInputs<double, 2> &inputs, const PointData &data,
                                                   const PointDerivativeView &view) const
{
  UnitDirectorDerivatives derivatives(inputs[1], view.wants_hessian());
  const PointInputs<double, 2> unit{inputs[0], derivatives.unit_field()};
  HelfrichBending{std::numeric_limits<double>::infinity(), 0.}.add_derivatives(unit, data,
                                                                               derivatives.collect(divergence));
  TangentialForm<1> form;
  form.alpha[0][0] = 2. * projection;
  form.beta[0][0]  = -2. * projection;
  form.add_derivatives(unit[0], {unit[1].value()}, derivatives.collect(1.));

  constexpr Input x1{0, 1}, x2{0, 2}, d{1, 0}, d1{1, 1}, d2{1, 2};
  add_triple_product(unit, d, x1, x2, derivatives.collect(normal_part));
  add_triple_product(unit, d, d1, x2, derivatives.collect(permutation));
  add_triple_product(unit, d, d2, x1, derivatives.collect(-permutation));
  derivatives.add_to(view);
}
} // namespace pellicle
