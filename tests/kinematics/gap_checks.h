// SPDX-License-Identifier: LGPL-2.1-or-later
// A gap's derivatives against differences of the gap itself.
#pragma once

#include "checks.h"

#include <pellicle/base/exceptions.h>
#include <pellicle/kinematics/gap.h>

#include <string>
#include <vector>

/** normal = grad g, hessian = grad normal, foot = x - g n on the surface, and what follows for any distance. */
inline void check_gap(const pellicle::RigidBody &body, const pellicle::Vector3<double> &x,
                      const double tolerance = 2e-9)
{
  using namespace pellicle;
  SCOPED_TRACE(body.name());
  const double h         = 1e-5;
  const GapSample sample = body.gap(x);
  expect_close(dot(sample.normal, sample.normal), 1.);
  expect_close(sample.foot, x - sample.gap * sample.normal);
  EXPECT_NEAR(body.gap(sample.foot).gap, 0., 1e-12);
  const Vector3<double> no_change = sample.hessian * sample.normal;
  for (unsigned int j = 0; j < 3; ++j)
  {
    Vector3<double> step;
    step[j]              = h;
    const GapSample plus = body.gap(x + step), minus = body.gap(x - step);
    EXPECT_NEAR(sample.normal[j], (plus.gap - minus.gap) / (2. * h), tolerance);
    for (unsigned int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(sample.hessian(i, j), (plus.normal[i] - minus.normal[i]) / (2. * h), tolerance) << i << "," << j;
      EXPECT_EQ(sample.hessian(i, j), sample.hessian(j, i));
    }
    EXPECT_NEAR(no_change[j], 0., 1e-12);
  }
}

/** Expects a SolveError whose message holds all the parts. */
inline void expect_no_gap(const pellicle::RigidBody &body, const pellicle::Vector3<double> &x,
                          const std::vector<std::string> &parts)
{
  try
  {
    body.gap(x);
    ADD_FAILURE() << body.name() << ": a gap was given where none is unique";
  }
  catch (const pellicle::SolveError &error)
  {
    for (const std::string &part : parts)
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << "'" << part << "' in: " << error.what();
  }
}
