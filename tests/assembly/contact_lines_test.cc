// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact of a line with a surface that deforms: the multipliers q and q_alpha on the contact line of Sauer 2014, (15).
#include "contact_problem.h"

#include <pellicle/assembly/contact_pairs.h>
#include <pellicle/assembly/contact_ties.h>
#include <pellicle/discretization/edge_loops.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

constexpr double depth = -0.04;

/** The rim of the slave, a square of side 0.8, hovers above one bumpy master cell, here and there in it. */
TwoSheets rim_on_bump(const unsigned int degree)
{
  return TwoSheets(sheet(degree, 2,
                         [](const double u, const double v)
                         {
                           const double x = 0.1 + 0.8 * v, y = 0.1 + 0.8 * u;
                           return Vector3<double>(x, y, -0.15 - depth + 0.1 * x * y);
                         }),
                   sheet(degree, 1,
                         [](const double u, const double v) {
                           return Vector3<double>(u, v, -0.25 * (u - 0.4) * (u - 0.4) - 0.35 * (v - 0.5) * (v - 0.5));
                         }),
                   {1., 1.});
}

SlavePoints rim_points(const TwoSheets &sheets)
{
  return {find_rims(sheets.slave, [](const Vector3<double> &) { return std::string("rim"); }).front(),
          sheets.reference};
}

/** Checks force and matrix of a term by differences; the second ones are zero for quadratic energies. */
void check_derivatives(const TwoSheets &sheets, PairTerm &term)
{
  const ContactElements now = term.evaluate(sheets.reference, Order::hessian);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  Eigen::VectorXd u(sheets.load.size());
  for (Eigen::Index i = 0; i < u.size(); ++i)
    u[i] = uniform(generator);
  const auto at = [&](const double eps)
  {
    NodalVectors x = sheets.reference;
    for (Eigen::Index i = 0; i < u.size(); ++i)
      x[i] += eps * u[i];
    return term.evaluate(x, Order::gradient);
  };
  const Eigen::VectorXd product = sheets.matrix(now) * u;
  const double force            = sheets.gradient(now).dot(u);
  double force_error[2], matrix_error[2];
  for (int half = 0; half < 2; ++half)
  {
    const double eps = half == 0 ? 2e-3 : 1e-3;
    const auto ahead = at(eps), behind = at(-eps);
    force_error[half]  = std::abs((ahead.energy - behind.energy) / (2. * eps) - force);
    matrix_error[half] = ((sheets.gradient(ahead) - sheets.gradient(behind)) / (2. * eps) - product).norm();
  }
  EXPECT_LT(force_error[1], 1e-3 * std::abs(force) + 1e-12);
  EXPECT_LT(matrix_error[1], 1e-3 * product.norm());
  for (const auto &error : {force_error, matrix_error})
    EXPECT_TRUE(error[0] < 1e-9 || std::abs(std::log2(error[0] / error[1]) - 2.) < 0.2) << error[0] << " " << error[1];
  const TwoSheets::Matrix K = sheets.matrix(now), K_swap = K.transpose();
  EXPECT_LT(TwoSheets::Matrix(K - K_swap).norm(), 1e-13 * K.norm());
}

ContactLaw both_sides(const double penalty)
{
  ContactLaw law{penalty, {0.5, 0.5}};
  law.sides = ContactSides::two;
  return law;
}

TEST(ContactLines, NormalForcePushesAndPulls)
{
  for (const unsigned int degree : {2u, 3u})
  {
    const TwoSheets sheets = rim_on_bump(degree);
    ContactPairs pairs(rim_points(sheets), sheets.master_cells(), both_sides(7.), "line");
    pairs.evaluate(sheets.reference, Order::value);
    pairs.augment();
    const ContactElements now = pairs.evaluate(sheets.reference, Order::gradient);
    EXPECT_EQ(now.n_active, 8 * (degree + 1));
    double largest = -1e9, smallest = 1e9;
    for (const ContactPoint &point : pairs.points())
    {
      largest  = std::max(largest, point.pressure);
      smallest = std::min(smallest, point.pressure);
    }
    EXPECT_GT(largest, 0.1);
    EXPECT_LT(smallest, -0.1);
    check_derivatives(sheets, pairs);
  }
}

TEST(ContactLines, TiesHoldInAllDirections)
{
  const TwoSheets sheets = rim_on_bump(2);
  ContactTies ties(rim_points(sheets), sheets.master_cells(), sheets.reference, 5., {0.5, 0.5}, "tied line");
  EXPECT_EQ(ties.points().size(), 24u);
  ties.evaluate(sheets.reference, Order::value);
  ties.augment();
  check_derivatives(sheets, ties);
  EXPECT_EQ(ties.material_nodes().size(), 16u + 9u); // of the rim, and all of the master
  // A unit displacement along x of a line of length L stretches ties by (eps/2) L.
  ContactTies fresh(rim_points(sheets), sheets.master_cells(), sheets.reference, 5., {0.5, 0.5});
  const double before            = fresh.evaluate(sheets.reference, Order::value).energy;
  NodalVectors x                 = sheets.reference;
  double first                   = 0.;
  const ContactElements at_start = fresh.evaluate(sheets.reference, Order::gradient);
  for (std::size_t I = 0; I < sheets.slave.n_nodes; ++I)
  {
    x[3 * I] += 1.;
    first += sheets.gradient(at_start)[3 * Eigen::Index(I)];
  }
  const double length = loop_length(
      find_rims(sheets.slave, [](const Vector3<double> &) { return std::string("rim"); }).front(), sheets.reference);
  EXPECT_NEAR(fresh.evaluate(x, Order::value).energy - before, first + 0.5 * 5. * length, 1e-12);
}

// A term that recalls the memory of another one has its energy, with multipliers and all.
template <typename Term>
void check_memory(const TwoSheets &sheets, Term &term, Term fresh)
{
  NodalVectors moved = sheets.reference;
  for (std::size_t i = 2; i < moved.size(); i += 3)
    moved[i] += 0.01 * std::sin(static_cast<double>(i));
  const double without = fresh.evaluate(moved, Order::value).energy;
  term.evaluate(sheets.reference, Order::value);
  term.augment();
  term.evaluate(sheets.reference, Order::value);
  fresh.recall(term.memory());
  EXPECT_EQ(fresh.memory(), term.memory());
  const double energy = term.evaluate(moved, Order::value).energy;
  EXPECT_EQ(fresh.evaluate(moved, Order::value).energy, energy);
  EXPECT_NE(energy, without);
}

TEST(ContactLines, MemoryLivesOn)
{
  const TwoSheets sheets = rim_on_bump(2);
  ContactPairs pairs(rim_points(sheets), sheets.master_cells(), both_sides(7.), "line");
  check_memory(sheets, pairs, ContactPairs(rim_points(sheets), sheets.master_cells(), both_sides(7.), "line"));
  ContactTies ties(rim_points(sheets), sheets.master_cells(), sheets.reference, 5., {0.5, 0.5}, "tied line");
  check_memory(sheets, ties,
               ContactTies(rim_points(sheets), sheets.master_cells(), sheets.reference, 5., {0.5, 0.5}, "tied line"));
}
} // namespace
