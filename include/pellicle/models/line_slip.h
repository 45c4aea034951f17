// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/archive.h>
#include <pellicle/discretization/surface_discretization.h>
#include <pellicle/potentials/wetting/line_friction.h>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace pellicle
{
enum class SlipStatus
{
  stuck,
  advancing,
  receding
};

/**
 * Which nodes of a contact line stick and which slip, and the friction that follows: what active sets of pinned lines
 * have in common. A cell of the line has one direction of slip: where two meet the node between them sticks.
 */
class LineSlip
{
public:
  explicit LineSlip(const EdgeLoop &line);

  /**
   * Begins a load step with the statuses of the last equilibrium.
   *
   * @param areas  densities of the area on the left of the line at its quadrature points.
   * @param keeps_last_step  whether the state is the last equilibrium: a step that was taken back has cost nothing.
   */
  void begin_step(std::vector<double> areas, bool keeps_last_step);

  /** Lets the next load step begin with nodes that all stick. */
  void forget_statuses();

  bool has_node(const std::size_t node) const { return nodes.count(node) == 1; }
  SlipStatus of_node(std::size_t node) const { return nodes.at(node).status; }

  /** A node that wants to slip, and by how much its force is beyond the threshold. */
  struct Slip
  {
    double excess     = 0.;
    std::size_t node  = 0;
    SlipStatus status = SlipStatus::stuck;
  };
  /**
   * Statuses after an equilibrium: nodes that have turned back stick, and those that want to slip do, the one farthest
   * beyond its threshold first. Returns how many nodes changed theirs; if none did, the load step is done.
   *
   * @param areas  as in begin_step(), at the equilibrium.
   * Throws SolveError for statuses that were tried before in this load step, and where only nodes between two
   * directions of slip want to move.
   */
  std::size_t update(const std::vector<std::size_t> &turned_back, std::vector<Slip> wanted, std::vector<double> areas);

  /** Friction per swept area of cells that slip; zero where they stick. */
  void set_friction(double advancing, double receding);
  /** Shared with the friction's potential; see make_line_friction(). */
  const std::shared_ptr<LineFrictionState> &friction() const { return friction_state; }

  struct Counts
  {
    std::size_t stuck = 0, advancing = 0, receding = 0;
  };
  Counts counts() const;
  /** Of a pulled line for which no equilibrium was found: that the drop slides, if nodes slip; else empty. */
  std::string about_sliding() const;
  /** Statuses, and what slipping has cost. */
  void exchange(Archive &archive);

private:
  struct Node
  {
    SlipStatus status  = SlipStatus::stuck;
    SlipStatus settled = SlipStatus::stuck; ///< at the last equilibrium
    std::vector<std::size_t> cells;         ///< of the line, that have the node
  };
  SlipStatus of_cell(std::size_t cell) const;
  bool may_slip(const Slip &slip) const;
  void note_statuses();
  double dissipated_in_step() const;

  const EdgeLoop &line;
  std::map<std::size_t, Node> nodes;
  std::shared_ptr<LineFrictionState> friction_state = std::make_shared<LineFrictionState>();
  std::vector<double> areas_at_equilibrium;
  std::set<std::vector<SlipStatus>> tried;
};
} // namespace pellicle
