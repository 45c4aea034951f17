// SPDX-License-Identifier: LGPL-2.1-or-later
// Sticking: tied sheets against sheets that share their nodes.
#include "contact_problem.h"

#include <pellicle/assembly/contact_ties.h>
#include <pellicle/base/exceptions.h>

#include <gtest/gtest.h>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

/** Two copies of a curved sheet, of n x n and m x m cells; the first looks down (u and v exchanged). */
TwoSheets double_sheet(const unsigned int degree, const unsigned int n, const unsigned int m)
{
  const auto shape = [](const double x, const double y)
  { return Vector3<double>(x, y + 0.1 * x * y, 0.2 * x * x - 0.3 * x * y); };
  TwoSheets sheets(sheet(degree, n, [&](const double u, const double v) { return shape(v, u); }),
                   sheet(degree, m, shape), {1., 0.5});
  sheets.add_load(true, {0.3, -0.1, 0.2});
  sheets.add_load(false, {-0.1, 0.1, 0.4});
  return sheets;
}

TwoSheets::Contact as_contact(ContactTies &ties)
{
  return [&ties](const NodalVectors &x, const Order order) { return ties.evaluate(x, order); };
}

/** Equilibrium if each node of the slave is one of the master's: of node (i, j) it is (j, i). */
Eigen::VectorXd conforming_solution(const TwoSheets &sheets, const std::size_t n_across)
{
  std::vector<Eigen::Triplet<double>> entries;
  const std::size_t n = sheets.slave.n_nodes;
  for (std::size_t I = 0; I < n; ++I)
    for (std::size_t c = 0; c < 3; ++c)
    {
      entries.emplace_back(3 * I + c, 3 * I + c, 1.);
      const std::size_t exchanged = (I % n_across) * n_across + I / n_across;
      entries.emplace_back(3 * (n + exchanged) + c, 3 * I + c, 1.);
    }
  TwoSheets::Matrix share(6 * n, 3 * n);
  share.setFromTriplets(entries.begin(), entries.end());
  const TwoSheets::Matrix shared = share.transpose() * sheets.elastic * share;
  Eigen::SparseLU<TwoSheets::Matrix> lu(shared);
  const Eigen::VectorXd right = share.transpose() * sheets.load;
  return share * Eigen::VectorXd(lu.solve(right));
}

TEST(ContactTiesTest, EqualsSharedNodes)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    const TwoSheets sheets = double_sheet(degree, 2, 2);
    ContactTies ties(sheets.slave_cells(), sheets.master_cells(), sheets.reference, 1e4, {1e-6, 1e-6});
    EXPECT_EQ(ties.points().size(), 4 * (degree + 1) * (degree + 1));
    NodalVectors x = sheets.reference;
    EXPECT_EQ(sheets.solve(x, as_contact(ties), 1e-10), 1u) << "quadratic";
    unsigned int n_augmentations = 0;
    while (ties.augment().relative() > 1e-8 && ++n_augmentations < 30)
      sheets.solve(x, as_contact(ties), 1e-10);
    EXPECT_LT(n_augmentations, 15u);

    const Eigen::VectorXd u = conforming_solution(sheets, 2 * degree + 1);
    EXPECT_GT(u.norm(), 0.1);
    for (Eigen::Index i = 0; i < u.size(); ++i)
      EXPECT_NEAR(x[i] - sheets.reference[i], u[i], 1e-9);
    for (const TiedPoint &tie : ties.points())
      EXPECT_LT(norm(ties.gap(tie, x)), 1e-11);
  }
}

// A common linear displacement leaves tied points together, also of other meshes (of a flat sheet): no force, no
// energy.
TEST(ContactTiesTest, CommonAffineMotionsAreFree)
{
  const auto flat = [](const double x, const double y) { return Vector3<double>(x, y, 0.); };
  const TwoSheets sheets(sheet(2, 2, [&](const double u, const double v) { return flat(v, u); }), sheet(2, 3, flat),
                         {1., 1.});
  ContactTies ties(sheets.slave_cells(), sheets.master_cells(), sheets.reference, 10., {1e-6, 1e-6});
  NodalVectors x = sheets.reference;
  for (std::size_t I = 0; I < x.size() / 3; ++I)
  {
    const double u = sheets.reference[3 * I], v = sheets.reference[3 * I + 1];
    x[3 * I] += 0.3 + 0.2 * v;
    x[3 * I + 1] -= 0.4 * u;
    x[3 * I + 2] += 0.5 * u - v;
  }
  const ContactElements none = ties.evaluate(x, Order::gradient);
  EXPECT_EQ(none.n_active, 36u);
  EXPECT_NEAR(none.energy, 0., 1e-25);
  EXPECT_LT(sheets.gradient(none).norm(), 1e-12);
  // Apart by d everywhere: eps d^2/2 an area.
  for (std::size_t I = 0; I < sheets.slave.n_nodes; ++I)
    x[3 * I + 1] += 0.1;
  EXPECT_NEAR(ties.evaluate(x, Order::value).energy, 0.5 * 10. * 0.01, 1e-13);
}

TEST(ContactTiesTest, OnlyWhatTouchesIsTied)
{
  const auto ramp = [](const double u, const double v) { return Vector3<double>(v, u, 0.1 * v); };
  const TwoSheets sheets(sheet(1, 2, ramp),
                         sheet(1, 2, [](const double u, const double v) { return Vector3<double>(u, v, 0.); }),
                         {1., 1.});
  const ContactTies ties(sheets.slave_cells(), sheets.master_cells(), sheets.reference, 1., {0.05, 0.05});
  EXPECT_EQ(ties.points().size(), 8u);
  for (const TiedPoint &tie : ties.points())
    EXPECT_EQ(tie.slave_cell / 2, 0u);
  EXPECT_THROW(ContactTies(sheets.slave_cells(), sheets.master_cells(), sheets.reference, 0., {1., 1.}), UserError);
}
} // namespace
