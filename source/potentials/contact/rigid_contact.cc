// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/potentials/contact/contact_law.h>
#include <pellicle/potentials/contact/rigid_contact.h>
#include <pellicle/potentials/surface_measures.h>

#include <utility>

namespace pellicle
{
namespace
{
Vector3<double> vector_at(const double *components)
{
  return {components[0], components[1], components[2]};
}

/** Adds the derivatives of energy(x) per area times a constant area. */
void add_per_area(const GapSample &sample, const ContactResponse &response, const double area,
                  const PointDerivativeView &view)
{
  view.add_gradient(0, 0, (-area * response.pressure) * sample.normal);
  if (view.wants_hessian())
    view.add_hessian(0, 0, 0, 0,
                     (area * response.stiffness) * outer(sample.normal, sample.normal) -
                         (area * response.pressure) * sample.hessian);
}

/** Adds what comes from the change of the area J, where it is the current one. */
void add_change_of_area(const GapSample &sample, const ContactResponse &response, const AreaDerivatives &area,
                        const PointDerivativeView &view)
{
  for (unsigned int a = 0; a < 2; ++a)
    view.add_gradient(0, 1 + a, response.energy * area.dJ[a]);
  if (!view.wants_hessian())
    return;
  for (unsigned int a = 0; a < 2; ++a)
  {
    view.add_hessian(0, 0, 0, 1 + a, -response.pressure * outer(sample.normal, area.dJ[a]));
    for (unsigned int b = a; b < 2; ++b)
      view.add_hessian(0, 1 + a, 0, 1 + b, response.energy * area.d2J(a, b));
  }
}
} // namespace

RigidContact::RigidContact(std::shared_ptr<const RigidBody> body, const double penalty, ContactPoints points,
                           const ContactMeasure measure, Where where)
    : body(std::move(body))
    , penalty(penalty)
    , data(std::move(points))
    , measure(measure)
    , part(std::move(where))
{
  PELLICLE_ASSERT(penalty > 0., "the penalty of contact is positive");
  PELLICLE_ASSERT(data.multipliers && (measure == ContactMeasure::current || data.reference_areas),
                  "contact needs multipliers, and areas of the reference unless it counts current areas");
}

const std::string &RigidContact::name() const
{
  static const std::string text = "contact";
  return text;
}

std::vector<FieldUse> RigidContact::fields() const
{
  const Derivatives derivatives = measure == ContactMeasure::reference ? Derivatives::none : Derivatives::first;
  return {{"position", derivatives, FieldRole::independent}};
}

void RigidContact::add(const CellPoints &points, const unsigned int *field_offsets, const double factor,
                       const Order order, PointSums &sums) const
{
  for (unsigned int q = 0; q < points.n_points; ++q)
  {
    const std::size_t index = points.first_point + q;
    const double *const x   = points.inputs + std::size_t(q) * points.n_inputs + field_offsets[0];
    const GapSample sample  = body->gap(vector_at(x));
    const ContactResponse response(sample.gap, (*data.multipliers)[index], penalty);

    const bool current = measure == ContactMeasure::current;
    const double area  = current ? norm(cross(vector_at(x + 3), vector_at(x + 6))) : (*data.reference_areas)[index];
    sums.value[q] += factor * area * response.energy;
    if (order == Order::value)
      continue;
    const PointDerivativeView view(
        sums.gradient.data() + std::size_t(q) * sums.n_inputs,
        order == Order::hessian ? sums.hessian.data() + std::size_t(q) * sums.n_inputs * sums.n_inputs : nullptr,
        sums.n_inputs, field_offsets, factor);
    add_per_area(sample, response, area, view);
    if (current)
      add_change_of_area(sample, response, AreaDerivatives(vector_at(x + 3), vector_at(x + 6)), view);
  }
}
} // namespace pellicle
