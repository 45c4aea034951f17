// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/kinematics/automatic_differentiation.h>
#include <pellicle/potentials/potential.h>

#include <string>
#include <type_traits>
#include <utility>

namespace pellicle
{
/**
 * Makes a Potential of a pointwise density. A density is a class with
 *
 *     static constexpr std::array<FieldUse, n> fields;
 *     static constexpr bool reparametrisation_invariant;
 *     template <typename Number>
 *     Number density(const PointInputs<Number, n> &inputs, const PointData &data) const;
 *
 * Its derivatives come from automatic differentiation over the inputs of a point. A hot density may also have
 *
 *     void add_derivatives(const PointInputs<double, n> &inputs, const PointData &data, const PointDerivativeView
 * &view) const;
 *
 * which is then used instead, and which the library-wide test compares with the automatic one.
 */
template <typename Density>
class DensityPotential : public Potential
{
public:
  static constexpr unsigned int n_fields = std::tuple_size<std::decay_t<decltype(Density::fields)>>::value;

  DensityPotential(std::string name, Density density, Where where = {})
      : potential_name(std::move(name))
      , pointwise(std::move(density))
      , part(std::move(where))
  {
  }

  const std::string &name() const override { return potential_name; }

  const Where &where() const override { return part; }

  std::vector<FieldUse> fields() const override { return {Density::fields.begin(), Density::fields.end()}; }

  bool reparametrisation_invariant() const override { return Density::reparametrisation_invariant; }

  void add(const CellPoints &points, const unsigned int *field_offsets, const double factor, const Order order,
           PointSums &sums) const override
  {
    for (unsigned int q = 0; q < points.n_points; ++q)
    {
      const double *inputs = points.inputs + std::size_t(q) * points.n_inputs;
      const PointData data{points.first_point + q, points.region};
      double *gradient = order >= Order::gradient ? sums.gradient.data() + std::size_t(q) * sums.n_inputs : nullptr;
      double *hessian =
          order == Order::hessian ? sums.hessian.data() + std::size_t(q) * sums.n_inputs * sums.n_inputs : nullptr;
      if (order == Order::value)
        sums.value[q] += factor * pointwise.density(gather<double>(inputs, field_offsets), data);
      else if constexpr (has_hand_written_derivatives)
      {
        const auto in = gather<double>(inputs, field_offsets);
        sums.value[q] += factor * pointwise.density(in, data);
        pointwise.add_derivatives(in, data,
                                  PointDerivativeView(gradient, hessian, sums.n_inputs, field_offsets, factor));
      }
      else
        sums.value[q] += add_automatic(inputs, field_offsets, data, factor, order, sums.n_inputs, gradient, hessian);
    }
  }

  /** The same as add() at one point, always by automatic differentiation: the oracle of the tests. Returns factor *
   * density. */
  double add_automatic(const double *inputs, const unsigned int *field_offsets, const PointData &data,
                       const double factor, const Order order, const unsigned int n_inputs, double *gradient,
                       double *hessian) const
  {
    std::array<unsigned int, n_local> where{};
    local_positions(field_offsets, where);
    if (order == Order::hessian)
    {
      using Number     = SecondOrder<n_local>;
      const Number psi = pointwise.density(seeded<Number>(inputs, where), data);
      for (unsigned int i = 0; i < n_local; ++i)
      {
        gradient[where[i]] += factor * psi.dx(i).val();
        for (unsigned int j = 0; j < n_local; ++j)
          hessian[where[i] * n_inputs + where[j]] += factor * psi.dx(i).dx(j);
      }
      return factor * psi.val().val();
    }
    using Number     = FirstOrder<n_local>;
    const Number psi = pointwise.density(seeded<Number>(inputs, where), data);
    for (unsigned int i = 0; i < n_local; ++i)
      gradient[where[i]] += factor * psi.dx(i);
    return factor * psi.val();
  }

  const Density &density() const { return pointwise; }

private:
  static constexpr unsigned int count_inputs()
  {
    unsigned int n = 0;
    for (unsigned int f = 0; f < n_fields; ++f)
      n += 3 * n_slots(Density::fields[f].derivatives);
    return n;
  }
  static constexpr unsigned int n_local = count_inputs();

  template <typename D, typename = void>
  struct HandWritten : std::false_type
  {
  };
  template <typename D>
  struct HandWritten<D, std::void_t<decltype(std::declval<const D &>().add_derivatives(
                            std::declval<const PointInputs<double, n_fields> &>(), std::declval<const PointData &>(),
                            std::declval<const PointDerivativeView &>()))>> : std::true_type
  {
  };
  static constexpr bool has_hand_written_derivatives = HandWritten<Density>::value;

  static void local_positions(const unsigned int *field_offsets, std::array<unsigned int, n_local> &where)
  {
    unsigned int k = 0;
    for (unsigned int f = 0; f < n_fields; ++f)
      for (unsigned int i = 0; i < 3 * n_slots(Density::fields[f].derivatives); ++i)
        where[k++] = field_offsets[f] + i;
  }

  template <typename Number>
  static PointInputs<Number, n_fields> gather(const double *inputs, const unsigned int *field_offsets)
  {
    PointInputs<Number, n_fields> in;
    for (unsigned int f = 0; f < n_fields; ++f)
      for (unsigned int s = 0; s < n_slots(Density::fields[f].derivatives); ++s)
        for (unsigned int c = 0; c < 3; ++c)
          in[f].slots[s][c] = inputs[field_offsets[f] + 3 * s + c];
    return in;
  }

  template <typename Number>
  static PointInputs<Number, n_fields> seeded(const double *inputs, const std::array<unsigned int, n_local> &where)
  {
    PointInputs<Number, n_fields> in;
    unsigned int k = 0;
    for (unsigned int f = 0; f < n_fields; ++f)
      for (unsigned int s = 0; s < n_slots(Density::fields[f].derivatives); ++s)
        for (unsigned int c = 0; c < 3; ++c, ++k)
          in[f].slots[s][c] = seed<Number>(k, inputs[where[k]]);
    return in;
  }

  std::string potential_name;
  Density pointwise;
  Where part;
};
} // namespace pellicle
