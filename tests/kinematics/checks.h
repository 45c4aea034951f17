// SPDX-License-Identifier: LGPL-2.1-or-later
// Comparisons relative to the size of what is compared.
#pragma once

#include <pellicle/kinematics/surface_tensors.h>
#include <pellicle/kinematics/vector3.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

inline void expect_close(const double a, const double b, const double scale = 1., const double tolerance = 1e-12)
{
  EXPECT_NEAR(a, b, tolerance * std::max({std::abs(a), std::abs(b), scale}));
}

inline void expect_close(const pellicle::Vector3<double> &a, const pellicle::Vector3<double> &b,
                         const double scale = 1.)
{
  for (unsigned int i = 0; i < 3; ++i)
    expect_close(a[i], b[i], std::max({norm(a), norm(b), scale}));
}

inline void expect_close(const pellicle::SymmetricSurfaceTensor<double> &a,
                         const pellicle::SymmetricSurfaceTensor<double> &b, double scale = 1.)
{
  for (unsigned int i = 0; i < 3; ++i)
    scale = std::max({scale, std::abs(a.components[i]), std::abs(b.components[i])});
  for (unsigned int i = 0; i < 3; ++i)
    expect_close(a.components[i], b.components[i], scale);
}
