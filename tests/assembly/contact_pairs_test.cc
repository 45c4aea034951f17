// SPDX-License-Identifier: LGPL-2.1-or-later
// Contact of two sheets: derivatives and symmetry of what is assembled, patch tests, Newton's iteration, ties.
#include "contact_problem.h"

#include <pellicle/assembly/contact_pairs.h>
#include <pellicle/base/exceptions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace
{
using namespace pellicle;
using namespace pellicle::test;

const std::vector<ContactMeasure> measures{ContactMeasure::reference, ContactMeasure::current,
                                           ContactMeasure::current_reduced};

/** Slave looking down (u and v exchanged) on a bumpy master; it is smaller, so that all its points have partners. */
TwoSheets bumpy_sheets(const unsigned int degree, const unsigned int n_slave, const unsigned int n_master,
                       const double height, const SheetStiffness &stiffness)
{
  return TwoSheets(sheet(degree, n_slave,
                         [&](const double u, const double v)
                         {
                           const double x = 0.1 + 0.8 * v, y = 0.1 + 0.8 * u;
                           return Vector3<double>(x, y, height + 0.3 * (x - 0.5) * (x - 0.5) + 0.1 * x * y);
                         }),
                   sheet(degree, n_master,
                         [](const double u, const double v) {
                           return Vector3<double>(u, v, -0.25 * (u - 0.4) * (u - 0.4) - 0.35 * (v - 0.5) * (v - 0.5));
                         }),
                   stiffness);
}

ContactLaw law(const double penalty, const ContactMeasure measure = ContactMeasure::reference,
               const std::string &second_variation = "full")
{
  return {penalty, {0.5, 0.5}, second_variation, measure};
}

Eigen::VectorXd random_vector(const Eigen::Index n, const unsigned int seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1., 1.);
  Eigen::VectorXd u(n);
  for (Eigen::Index i = 0; i < n; ++i)
    u[i] = uniform(generator);
  return u;
}

NodalVectors moved(const NodalVectors &x, const double eps, const Eigen::VectorXd &u)
{
  NodalVectors result = x;
  for (Eigen::Index i = 0; i < u.size(); ++i)
    result[i] += eps * u[i];
  return result;
}

ContactPairs contact_of(const TwoSheets &sheets, const ContactLaw &contact_law)
{
  return ContactPairs(sheets.slave_cells(), sheets.master_cells(), sheets.reference, contact_law);
}

TwoSheets::Contact as_contact(ContactPairs &pairs)
{
  return [&pairs](const NodalVectors &x, const Order order) { return pairs.evaluate(x, order); };
}

/** The slave moved down. */
NodalVectors pressed(const TwoSheets &sheets, const double depth)
{
  NodalVectors x = sheets.reference;
  for (std::size_t I = 0; I < sheets.slave.n_nodes; ++I)
    x[3 * I + 2] -= depth;
  return x;
}

/** Contact with multipliers that are neither zero nor the pressure. */
ContactPairs augmented_pairs(const TwoSheets &sheets, const ContactLaw &contact_law)
{
  ContactPairs pairs = contact_of(sheets, contact_law);
  pairs.evaluate(pressed(sheets, 0.02), Order::value);
  pairs.augment();
  return pairs;
}

// One master cell, so that no point changes its cell; the slave is in it everywhere.
TEST(ContactPairsTest, Derivatives)
{
  for (unsigned int degree = 2; degree <= 3; ++degree)
    for (const ContactMeasure measure : measures)
    {
      const TwoSheets sheets    = bumpy_sheets(degree, 2, 1, -0.25, {});
      ContactPairs pairs        = augmented_pairs(sheets, law(7., measure));
      const ContactElements now = pairs.evaluate(sheets.reference, Order::hessian);
      EXPECT_EQ(now.n_active, pairs.points().size());
      EXPECT_EQ(now.elements.size(), 4u);
      const Eigen::VectorXd gradient = sheets.gradient(now), u = random_vector(gradient.size(), degree);
      const Eigen::VectorXd product = sheets.matrix(now) * u;
      double force_error[2], matrix_error[2];
      for (int half = 0; half < 2; ++half)
      {
        const double eps   = half == 0 ? 2e-3 : 1e-3;
        const auto ahead   = pairs.evaluate(moved(sheets.reference, eps, u), Order::gradient);
        const auto behind  = pairs.evaluate(moved(sheets.reference, -eps, u), Order::gradient);
        force_error[half]  = std::abs((ahead.energy - behind.energy) / (2. * eps) - gradient.dot(u));
        matrix_error[half] = ((sheets.gradient(ahead) - sheets.gradient(behind)) / (2. * eps) - product).norm();
      }
      EXPECT_NEAR(std::log2(matrix_error[0] / matrix_error[1]), 2., 0.1);
      EXPECT_LT(matrix_error[1], 1e-2 * product.norm());
      if (measure == ContactMeasure::current_reduced)
      {
        EXPECT_GT(force_error[1], 0.01 * std::abs(gradient.dot(u))) << "derives from no energy";
      }
      else
      {
        EXPECT_NEAR(std::log2(force_error[0] / force_error[1]), 2., 0.1);
        EXPECT_LT(force_error[1], 1e-3 * std::abs(gradient.dot(u)));
      }
    }
}

// Above the ridge of a roof every slave point is closest to the edge between two cells; multipliers keep it active
// there.
TEST(ContactPairsTest, DerivativesAboveAnEdge)
{
  const TwoSheets sheets(sheet(2, 1,
                               [](const double u, const double v)
                               { return Vector3<double>(0.4 + 0.2 * v, 0.2 + 0.6 * u, 0.3 + 0.1 * u * v); }),
                         sheet(2, 2,
                               [](const double u, const double v)
                               { return Vector3<double>(u, v, -std::abs(u - 0.5) - 0.2 * v * v); }),
                         {});
  ContactPairs pairs = contact_of(sheets, law(7.));
  for (unsigned int i = 0; i < 20; ++i)
  {
    pairs.evaluate(pressed(sheets, 0.7), Order::value);
    pairs.augment();
  }
  const ContactElements now = pairs.evaluate(sheets.reference, Order::hessian);
  EXPECT_EQ(now.n_active, 9u);
  for (const ContactPoint &point : pairs.points())
    EXPECT_EQ(point.partner->at.n_free(), 1u);
  const Eigen::VectorXd u = random_vector(sheets.load.size(), 5), product = sheets.matrix(now) * u;
  double error[2];
  for (int half = 0; half < 2; ++half)
  {
    const double eps  = half == 0 ? 2e-3 : 1e-3;
    const auto ahead  = pairs.evaluate(moved(sheets.reference, eps, u), Order::gradient);
    const auto behind = pairs.evaluate(moved(sheets.reference, -eps, u), Order::gradient);
    error[half]       = ((sheets.gradient(ahead) - sheets.gradient(behind)) / (2. * eps) - product).norm();
  }
  EXPECT_NEAR(std::log2(error[0] / error[1]), 2., 0.1);
  EXPECT_LT(error[1], 1e-3 * product.norm());
}

// Symmetric with the reference measure and with (135); the skew part of (145) is that of -t N dJ^T alone.
TEST(ContactPairsTest, SymmetryOfTheTangent)
{
  const TwoSheets sheets = bumpy_sheets(2, 2, 3, -0.15, {});
  for (const std::string variation : {"full", "equal"})
    for (const ContactMeasure measure : measures)
    {
      ContactPairs pairs             = augmented_pairs(sheets, law(7., measure, variation));
      const TwoSheets::Matrix K      = sheets.matrix(pairs.evaluate(sheets.reference, Order::hessian));
      const TwoSheets::Matrix K_swap = K.transpose();
      const double skew              = TwoSheets::Matrix(K - K_swap).norm() / K.norm();
      if (measure != ContactMeasure::current_reduced)
      {
        EXPECT_LT(skew, 1e-14) << variation;
        continue;
      }
      EXPECT_GT(skew, 0.02);
      RecordProperty("skew_of_reduced", std::to_string(skew));

      // v . K u - u . K v = -sum t (dg[v] da[u] - da[v] dg[u]), variations by differences
      const Eigen::VectorXd u = random_vector(K.rows(), 1), v = random_vector(K.rows(), 2);
      const std::vector<ContactPoint> points = pairs.points();
      const auto gaps_and_areas              = [&](const NodalVectors &x)
      {
        pairs.evaluate(x, Order::value);
        std::vector<std::array<double, 2>> list;
        for_all_points(pairs.slave().tables, pairs.slave().cell_nodes, x, 3,
                       [&](const WalkPoint &p) {
                         list.push_back({{pairs.points()[list.size()].partner->gap, p.area()}});
                       });
        return list;
      };
      const auto variations = [&](const Eigen::VectorXd &w)
      {
        const double eps = 1e-4;
        auto difference  = gaps_and_areas(moved(sheets.reference, eps, w)),
             behind      = gaps_and_areas(moved(sheets.reference, -eps, w));
        for (std::size_t i = 0; i < difference.size(); ++i)
          for (unsigned int k = 0; k < 2; ++k)
            difference[i][k] = (difference[i][k] - behind[i][k]) / (2. * eps);
        return difference;
      };
      const auto along_u = variations(u), along_v = variations(v);
      double predicted = 0.;
      for (std::size_t i = 0; i < points.size(); ++i)
        predicted -= points[i].pressure * (along_v[i][0] * along_u[i][1] - along_v[i][1] * along_u[i][0]);
      const double found = v.dot(K * u) - u.dot(K * v);
      EXPECT_NEAR(found, predicted, 1e-5 * std::abs(predicted));
    }
}

/** Largest difference of the pressure from `expected`, relative to it. */
double pressure_error(const ContactPairs &pairs, const double expected)
{
  double largest = 0.;
  for (const ContactPoint &point : pairs.points())
    largest = std::max(largest, std::abs(point.pressure - expected) / expected);
  return largest;
}

TwoSheets flat_sheets(const unsigned int degree, const unsigned int n_slave, const unsigned int n_master)
{
  return TwoSheets(sheet(degree, n_slave, [](const double u, const double v) { return Vector3<double>(v, u, 0.); }),
                   sheet(degree, n_master, [](const double u, const double v) { return Vector3<double>(u, v, 0.); }),
                   {1., 2.});
}

// Uniform load p on the slave, foundations k: p = k w_s + t, t = k w_m = eps (w_s - w_m).
TEST(ContactPairsTest, PatchTestOfMatchingMeshes)
{
  for (unsigned int degree = 1; degree <= 3; ++degree)
  {
    TwoSheets sheets = flat_sheets(degree, 3, 3);
    sheets.add_load(true, {0., 0., -0.3});
    ContactPairs pairs = contact_of(sheets, law(50.));
    NodalVectors x     = pressed(sheets, 0.01);
    EXPECT_LE(sheets.solve(x, as_contact(pairs), 1e-13), 3u);
    EXPECT_LT(pressure_error(pairs, 0.3 / (2. + 2. / 50.)), 1e-12);

    unsigned int n_augmentations = 0;
    while (pairs.augment().relative() > 1e-13 && ++n_augmentations < 20)
      EXPECT_LE(sheets.solve(x, as_contact(pairs), 1e-13), 3u);
    EXPECT_LT(n_augmentations, 12u);
    EXPECT_LT(pressure_error(pairs, 0.15), 1e-12);
    for (const ContactPoint &point : pairs.points())
      EXPECT_NEAR(point.partner->gap, 0., 1e-13);
  }
}

// Forces on the master are integrated over the slave's cells, across which the master's shape functions have kinks: the
// force on a smooth displacement is wrong by h, the pressure by about h^2 whatever the degree.
TEST(ContactPairsTest, PatchTestOfOtherMeshesConverges)
{
  for (unsigned int degree = 1; degree <= 2; ++degree)
  {
    std::vector<double> errors;
    for (const unsigned int n : {4u, 8u})
    {
      TwoSheets sheets = flat_sheets(degree, n, n + n / 2);
      sheets.add_load(true, {0., 0., -0.3});
      ContactPairs pairs = contact_of(sheets, law(50.));
      NodalVectors x     = pressed(sheets, 0.1);
      EXPECT_LT(sheets.solve(x, as_contact(pairs), 1e-12), 10u);
      errors.push_back(pressure_error(pairs, 0.3 / (2. + 2. / 50.)));
    }
    EXPECT_LT(errors[0], 0.01);
    EXPECT_GT(std::log2(errors[0] / errors[1]), 1.5);
    RecordProperty("errors_of_degree_" + std::to_string(degree),
                   std::to_string(errors[0]) + ", " + std::to_string(errors[1]));
  }
}

// Of degree 3 the weights of the master's functions within a slave cell need more points than the slave's own.
TEST(ContactPairsTest, ExtraGaussPoints)
{
  std::vector<double> errors;
  for (const unsigned int extra : {0u, 2u})
  {
    TwoSheets sheets = flat_sheets(3, 2, 3);
    sheets.add_load(true, {0., 0., -0.3});
    ContactLaw more         = law(50.);
    more.extra_gauss_points = extra;
    ContactPairs pairs      = contact_of(sheets, more);
    NodalVectors x          = pressed(sheets, 0.1);
    EXPECT_LT(sheets.solve(x, as_contact(pairs), 1e-12), 10u);
    EXPECT_EQ(pairs.points().size(), 4 * (4 + extra) * (4 + extra));
    errors.push_back(pressure_error(pairs, 0.3 / (2. + 2. / 50.)));
  }
  EXPECT_LT(errors[1], 0.1 * errors[0]);
}

// Steps for the last tenth of a load that presses a dome on a dome, gap times curvature about 0.1.
TEST(ContactPairsTest, NewtonNeedsTheSecondVariation)
{
  std::vector<unsigned int> steps;
  for (const GapSecondVariation &variation : gap_second_variations())
  {
    TwoSheets sheets(sheet(2, 2,
                           [](const double u, const double v)
                           {
                             const double x = 0.8 * v - 0.4, y = 0.8 * u - 0.4;
                             return Vector3<double>(x, y, -0.8 * x * x - 1.1 * y * y);
                           }),
                     sheet(2, 2,
                           [](const double u, const double v)
                           {
                             const double x = u - 0.5, y = v - 0.5;
                             return Vector3<double>(x, y, -x * x - y * y);
                           }),
                     {0.02, 1.});
    ContactPairs exact = contact_of(sheets, law(2.));
    ContactPairs pairs = contact_of(sheets, law(2., ContactMeasure::reference, variation.name));
    NodalVectors x     = sheets.reference;
    for (const double part : {0.3, 0.6, 0.9, 1.})
    {
      sheets.load.setZero();
      sheets.add_load(true, {0.02 * part, 0., -0.2 * part});
      ContactPairs &used       = part < 1. ? exact : pairs;
      const unsigned int taken = sheets.solve(x, as_contact(used), 1e-12);
      EXPECT_LT(taken, 60u);
      if (part == 1.)
        steps.push_back(taken);
    }
    RecordProperty("steps_" + variation.name, std::to_string(steps.back()));
  }
  EXPECT_EQ(steps[0], steps[1]);
  EXPECT_LE(steps[1], 5u);
  EXPECT_LT(steps[1] + 4, steps[2]);
  EXPECT_LT(steps[2] + 8, steps[3]);
}

// Beyond the master's rim and too far above nothing happens; a lifted slave gives its multipliers up.
TEST(ContactPairsTest, PointsWithoutPartnerAreFree)
{
  const TwoSheets sheets = flat_sheets(1, 2, 2);
  ContactPairs pairs     = contact_of(sheets, law(50.));
  NodalVectors x         = pressed(sheets, 0.01);
  for (std::size_t I = 0; I < sheets.slave.n_nodes; ++I)
    x[3 * I] += 0.5;
  const ContactElements half = pairs.evaluate(x, Order::gradient);
  EXPECT_EQ(half.n_active, 8u);
  EXPECT_NEAR(half.energy, 0.5 * 25. * 1e-4, 1e-15);
  // Of the slave's cells those on the left, of the master's those on the right.
  EXPECT_EQ(half.elements.size(), 2u);
  double sum = 0.;
  for (Eigen::Index i = 2; i < 3 * Eigen::Index(sheets.slave.n_nodes); i += 3)
    sum += sheets.gradient(half)[i];
  EXPECT_NEAR(sum, -0.5 * 50. * 0.01, 1e-14) << "the energy falls when the slave rises";
  EXPECT_NEAR(sheets.gradient(half).sum(), 0., 1e-14);

  EXPECT_EQ(pairs.augment().relative(), 1.);
  const ContactElements away = pairs.evaluate(pressed(sheets, -0.6), Order::hessian);
  EXPECT_EQ(away.n_active, 0u);
  EXPECT_TRUE(away.elements.empty());
  EXPECT_EQ(pairs.augment().relative(), 0.);
  EXPECT_EQ(pairs.evaluate(pressed(sheets, -0.6), Order::value).energy, 0.);
}

TEST(ContactPairsTest, WrongLawsAreNamed)
{
  const TwoSheets sheets = flat_sheets(1, 1, 1);
  for (const auto &[wrong, text] : {std::pair(law(0.), std::string("must be > 0")),
                                    std::pair(law(1., ContactMeasure::reference, "hut"), std::string("'hat'"))})
    try
    {
      contact_of(sheets, wrong);
      FAIL() << text;
    }
    catch (const UserError &error)
    {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
}
} // namespace
