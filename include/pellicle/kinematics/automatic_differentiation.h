// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

// Of Sacado only the forward types are needed. Its configuration would pull in Kokkos, Teuchos and MPI headers (three
// times the compile time, and a library to link), so these three definitions replace it. A file that has included
// Sacado before, as deal.II's headers do, keeps the full configuration: the types are the same.
#ifndef SACADO_CONFIGDEFS_H
#define TRILINOS_NO_CONFIG_H
#define HAVE_SACADO_CXX11
#define SACADO_NEW_FAD_DESIGN_IS_DEFAULT
#include <Sacado_Fad_SFad.hpp>
#undef TRILINOS_NO_CONFIG_H
#else
#include <Sacado_Fad_SFad.hpp>
#endif

#include <array>
#include <cstddef>

namespace pellicle
{
/**
 * Numbers that carry their derivatives with respect to n inputs (forward mode): FirstOrder the gradient, SecondOrder
 * gradient and Hessian, by nesting.
 *
 * Products and sums of such numbers are expression templates: store them in variables of the number type, never of type
 * `auto`. A default-constructed number is not initialised; write Number(0.) to start a sum.
 */
template <unsigned int n>
using FirstOrder = Sacado::Fad::SFad<double, n>;

template <unsigned int n>
using SecondOrder = Sacado::Fad::SFad<Sacado::Fad::SFad<double, n>, n>;

namespace internal
{
template <typename Number>
struct Seed;

template <int n>
struct Seed<Sacado::Fad::SFad<double, n>>
{
  static constexpr std::size_t n_inputs = n;

  static Sacado::Fad::SFad<double, n> input(const int i, const double x) { return {n, i, x}; }
};

template <int n>
struct Seed<Sacado::Fad::SFad<Sacado::Fad::SFad<double, n>, n>>
{
  static constexpr std::size_t n_inputs = n;

  static Sacado::Fad::SFad<Sacado::Fad::SFad<double, n>, n> input(const int i, const double x)
  {
    return {n, i, Seed<Sacado::Fad::SFad<double, n>>::input(i, x)};
  }
};
} // namespace internal

/** The i-th independent input (i < n) with value x, as a FirstOrder<n> or SecondOrder<n>: its derivative with respect
 * to itself is 1. */
template <typename Number>
Number seed(const unsigned int i, const double x)
{
  return internal::Seed<Number>::input(static_cast<int>(i), x);
}

/** All n inputs at once, input i at position i. */
template <typename Number>
auto seed(const std::array<double, internal::Seed<Number>::n_inputs> &x)
{
  std::array<Number, internal::Seed<Number>::n_inputs> inputs;
  for (unsigned int i = 0; i < inputs.size(); ++i)
    inputs[i] = seed<Number>(i, x[i]);
  return inputs;
}

/** The value without its derivatives; a plain number is its own value. */
inline double value_of(const double f)
{
  return f;
}

template <int n>
double value_of(const Sacado::Fad::SFad<double, n> &f)
{
  return f.val();
}

template <int n>
double value_of(const Sacado::Fad::SFad<Sacado::Fad::SFad<double, n>, n> &f)
{
  return f.val().val();
}

/** df/dx_i, i = 0 .. n-1. */
template <int n>
std::array<double, n> gradient_of(const Sacado::Fad::SFad<double, n> &f)
{
  std::array<double, n> gradient;
  for (int i = 0; i < n; ++i)
    gradient[i] = f.dx(i);
  return gradient;
}

template <int n>
std::array<double, n> gradient_of(const Sacado::Fad::SFad<Sacado::Fad::SFad<double, n>, n> &f)
{
  std::array<double, n> gradient;
  for (int i = 0; i < n; ++i)
    gradient[i] = f.val().dx(i);
  return gradient;
}

/** d2f/dx_i dx_j at position i n + j; symmetric to the last bit (both triangles are filled from the lower one). */
template <int n>
std::array<double, n * n> hessian_of(const Sacado::Fad::SFad<Sacado::Fad::SFad<double, n>, n> &f)
{
  std::array<double, n * n> hessian;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j <= i; ++j)
      hessian[i * n + j] = hessian[j * n + i] = f.dx(i).dx(j);
  return hessian;
}
} // namespace pellicle
