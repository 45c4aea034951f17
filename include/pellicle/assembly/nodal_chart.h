// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>
#include <pellicle/kinematics/gap.h>

#include <array>
#include <memory>
#include <optional>
#include <vector>

namespace pellicle
{
/**
 * Unknowns of one field: nodal vector of I = current vector + sum_j column_Ij u_Ij (contract 4: Z = the 3 x m matrix of
 * columns). Assembly works in R^3 and knows none of it; rows and columns of a cell's contribution are multiplied by Z
 * when they are scattered.
 *
 * A column's equation is the physical one (Z^T residual = 0) or, for the tangential columns of the ALE chart, the mesh
 * equation (tangential gradient of the mesh energy = 0).
 */
struct NodalChart
{
  struct Node
  {
    unsigned int count = 0;              ///< m, 0 to 3
    std::array<double, 9> columns{};     ///< column j: columns[3 j .. 3 j + 2], orthonormal
    std::array<bool, 3> mesh_equation{}; ///< by column
  };
  std::vector<Node> nodes;
  /** Nodes that have the unknowns of another one (a rigid ring, two sides of a line): leader[I], or I itself. Empty:
   * none. Both have as many columns; where these differ, for example in length, the follower moves along its own. */
  std::vector<std::size_t> leader;

  /** A node whose displacement others share, component by component. */
  struct Carrier
  {
    std::size_t node = 0;
    std::array<double, 3> share{};
  };
  /**
   * Nodes that are carried along by others, beside their own unknowns: displacement of I = sum_j column_Ij u_Ij + sum
   * over carriers J of share_JI * (displacement of J). Carriers are not carried themselves. Empty: none are.
   */
  std::vector<std::vector<Carrier>> carriers;

  /**
   * Of a field of unit vectors: its values at the nodes, at which the columns are tangential to the unit sphere. A step
   * is then followed by normalisation, and the matrix gains -(g . v) on the diagonal (g the gradient with respect to v
   * in R^3), the second derivative of that retraction. Empty: a field of plain vectors.
   */
  std::vector<std::array<double, 3>> unit_vectors;

  /** A rigid body on whose surface a node stays, with normal and second derivative of the gap there. */
  struct OnBody
  {
    std::shared_ptr<const RigidBody> body;
    GapSample here;
  };
  /**
   * Of nodes that stay on bodies, whose columns are tangential to them: a step is followed by going to the closest
   * point of the body, and the matrix gains -(g . n) (column . hessian column), g the gradient with respect to x in
   * R^3: the second derivative of that retraction. Empty: there are none.
   */
  std::vector<std::optional<OnBody>> on_body;

  /** Whether a node has unknowns of its own. */
  bool leads(const std::size_t node) const { return leader.empty() || leader[node] == node; }

  bool has_mesh_equations() const;
};

/** What the tangential unknowns of a node are for: there are none, they obey mesh equations, or they are physical. */
enum class TangentialMotion
{
  none,
  mesh,
  physical
};

/** No unknowns at all; conditions may give some nodes their own (places of material points). */
NodalChart held_chart(const SurfaceDiscretization &discretization);

/** Every admissible direction of a node is an unknown (the moment). */
NodalChart free_chart(const SurfaceDiscretization &discretization);

/**
 * Normal graph x = X + u d with d the nodal normal: one unknown a node, symmetric, variational. Tangential motion, a
 * gauge, is fixed. Nodes of edge loops also move along the conormal, for that is no gauge: it moves the line within the
 * surface.
 */
NodalChart graph_chart(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                       const NodalVectors &normals);

/** ALE: all admissible directions; the normal one (on edge loops the conormal, too) with the physical equation, the
 * others with mesh equations. Unsymmetric, no bias. */
NodalChart ale_chart(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                     const NodalVectors &normals);

/** Unit conormals on edge loops (zero elsewhere): the rotation about the tangent of the line and, on surfaces in space,
 * the one out of its normal plane. */
NodalChart conormal_chart(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                          const NodalVectors &conormals);

/** Numbers at the nodes of edge loops that keep conormals orthogonal to the line; none on a meridian, where they are.
 */
NodalChart edge_scalar_chart(const SurfaceDiscretization &discretization);

/** Gives nodes all admissible directions, all of them physical: material points, whatever the chart of the others. */
void free_nodes(const SurfaceDiscretization &discretization, const std::vector<bool> &material, NodalChart &chart);

/** Unit normals at the nodes: averages of the cells' normals there, weighted by x,1 x x,2, projected to the admissible
 * directions; zero inside bodies. Throws SolveError where a mesh has collapsed. */
NodalVectors nodal_normals(const SurfaceDiscretization &discretization, const NodalVectors &positions);
/** The same at the nodes of edge loops from the cells on the left of the loops alone: where a surface goes on beyond a
 * line, it may have a kink there. Elsewhere zero. */
NodalVectors nodal_normals_at_edges(const SurfaceDiscretization &discretization, const NodalVectors &positions);

/** Weights w_I > 0 of the nodes that add up to the area: the diagonal of the mass matrix, scaled. (Row sums may vanish
 * at the pole of a meridian.) */
std::vector<double> nodal_areas(const SurfaceDiscretization &discretization, const NodalVectors &positions);
} // namespace pellicle
