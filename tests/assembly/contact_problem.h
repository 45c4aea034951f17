// SPDX-License-Identifier: LGPL-2.1-or-later
// Two sheets on elastic foundations that touch, and a plain Newton iteration for them.
#pragma once

#include "sample_sheets.h"

#include <pellicle/assembly/contact_elements.h>
#include <pellicle/discretization/point_walk.h>
#include <pellicle/kinematics/surface_point.h>

#include <Eigen/Sparse>
#include <Eigen/SparseLU>

#include <cmath>
#include <functional>
#include <vector>

namespace pellicle::test
{
/** (stretching/2) int |grad u|^2 + (foundation/2) int |u|^2 per reference area, u = x - X, for each of two sheets. */
struct SheetStiffness
{
  double stretching = 1.;
  double foundation = 1.;
};

/** Nodes of the slave first, then those of the master; unknowns 3 I + c. */
class TwoSheets
{
public:
  using Matrix = Eigen::SparseMatrix<double>;

  TwoSheets(const SurfaceDiscretization &slave, const SurfaceDiscretization &master, const SheetStiffness &stiffness)
      : slave(slave)
      , master(master)
      , reference(slave.positions)
      , load(Eigen::VectorXd::Zero(3 * (slave.n_nodes + master.n_nodes)))
      , elastic(load.size(), load.size())
  {
    reference.insert(reference.end(), master.positions.begin(), master.positions.end());
    std::vector<Eigen::Triplet<double>> entries;
    add_stiffness(slave, 0, stiffness, entries);
    add_stiffness(master, slave.n_nodes, stiffness, entries);
    elastic.setFromTriplets(entries.begin(), entries.end());
  }

  SurfaceCells slave_cells() const { return surface_cells(slave); }
  SurfaceCells master_cells() const { return surface_cells(master, {}, slave.n_nodes); }

  /** Force per reference area of the slave (false: the master). */
  void add_load(const bool on_slave, const Vector3<double> &force)
  {
    const SurfaceDiscretization &sheet = on_slave ? slave : master;
    const std::size_t first            = on_slave ? 0 : slave.n_nodes;
    for_all_points(sheet.tables, sheet.cell_nodes, sheet.positions, 3,
                   [&](const WalkPoint &p)
                   {
                     for (std::size_t I = 0; I < sheet.n_local(); ++I)
                       for (unsigned int c = 0; c < 3; ++c)
                         load[3 * (first + p.nodes[I]) + c] +=
                             p.area() * sheet.tables.tables[0][p.q * sheet.n_local() + I] * force[c];
                   });
  }

  /** Gradient of the whole energy. */
  Eigen::VectorXd residual(const NodalVectors &x, const ContactElements &contact) const
  {
    Eigen::VectorXd u(load.size());
    for (Eigen::Index i = 0; i < u.size(); ++i)
      u[i] = x[i] - reference[i];
    return elastic * u - load + gradient(contact);
  }

  Eigen::VectorXd gradient(const ContactElements &contact) const
  {
    Eigen::VectorXd g = Eigen::VectorXd::Zero(load.size());
    for (const ContactElement &element : contact.elements)
      for (std::size_t i = 0; i < element.derivatives.n_rows; ++i)
        g[unknown(element, i)] += element.derivatives.gradient[i];
    return g;
  }

  Matrix matrix(const ContactElements &contact) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    for (const ContactElement &element : contact.elements)
    {
      const std::size_t n = element.derivatives.n_rows;
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
          entries.emplace_back(unknown(element, i), unknown(element, j), element.derivatives.matrix[i * n + j]);
    }
    Matrix m(load.size(), load.size());
    m.setFromTriplets(entries.begin(), entries.end());
    return m;
  }

  using Contact = std::function<ContactElements(const NodalVectors &, Order)>;

  /** Full Newton steps from x until the residual is below `tolerance` times the load; the number of steps, at most
   * `most`. */
  unsigned int solve(NodalVectors &x, const Contact &contact, const double tolerance,
                     const unsigned int most = 60) const
  {
    for (unsigned int step = 0; step < most; ++step)
    {
      const ContactElements elements = contact(x, Order::hessian);
      const Eigen::VectorXd r        = residual(x, elements);
      if (r.norm() <= tolerance * load.norm())
        return step;
      Eigen::SparseLU<Matrix> lu(elastic + matrix(elements));
      const Eigen::VectorXd change = lu.solve(r);
      for (Eigen::Index i = 0; i < change.size(); ++i)
        x[i] -= change[i];
    }
    return most;
  }

  SurfaceDiscretization slave, master;
  NodalVectors reference;
  Eigen::VectorXd load;
  Matrix elastic;

private:
  static Eigen::Index unknown(const ContactElement &element, const std::size_t row)
  {
    const std::size_t n = element.nodes.size();
    return 3 * element.nodes[row % n] + row / n;
  }

  static void add_stiffness(const SurfaceDiscretization &sheet, const std::size_t first,
                            const SheetStiffness &stiffness, std::vector<Eigen::Triplet<double>> &entries)
  {
    const std::size_t n = sheet.n_local();
    for_all_points(sheet.tables, sheet.cell_nodes, sheet.positions, 3,
                   [&](const WalkPoint &p)
                   {
                     const TangentPlane<double> plane(p[1], p[2]);
                     const auto table = [&](const unsigned int s, const std::size_t I)
                     { return sheet.tables.tables[s][p.q * n + I]; };
                     for (std::size_t I = 0; I < n; ++I)
                       for (std::size_t J = 0; J < n; ++J)
                       {
                         double k = stiffness.foundation * table(0, I) * table(0, J);
                         for (unsigned int a = 0; a < 2; ++a)
                           for (unsigned int b = 0; b < 2; ++b)
                             k += stiffness.stretching * plane.inverse_metric(a, b) * table(1 + a, I) * table(1 + b, J);
                         for (unsigned int c = 0; c < 3; ++c)
                           entries.emplace_back(3 * (first + p.nodes[I]) + c, 3 * (first + p.nodes[J]) + c,
                                                p.area() * k);
                       }
                   });
  }
};
} // namespace pellicle::test
