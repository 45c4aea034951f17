// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/surface_discretization.h>

#include <array>
#include <cstddef>
#include <vector>

namespace pellicle
{
/** Which of the planes x = 0, y = 0, z = 0 are planes of symmetry. */
struct MirrorPlanes
{
  std::array<bool, 3> normal_to{}; ///< by coordinate

  bool any() const { return normal_to[0] || normal_to[1] || normal_to[2]; }
  /** Images of a part between the planes, itself included: 1, 2, 4 or 8. */
  unsigned int n_images() const;
};

/**
 * The cells of a symmetric surface on the positive side of each plane: a half, a quarter or an eighth of it.
 *
 * Nodes on a plane stay there, and so do all vectors of theirs (AdmissibleDirections): the natural condition that is
 * left in the equations is that of the whole. Weights of the tables, of lines too, count the images, so that integrals
 * are those of the whole surface; lines that the planes cut begin and end there. Rigid motions that leave a plane are
 * gone.
 *
 * Throws UserError where a plane cuts through cells, or where the cells on its two sides are not equally many.
 */
SurfaceDiscretization symmetric_part(const SurfaceDiscretization &whole, const MirrorPlanes &planes);

/** Whether a motion maps each plane into itself. */
bool keeps_in_place(const RigidMotion &motion, const MirrorPlanes &planes);

/** A part with all its images, as one surface again (without its lines): what output shows. */
class UnfoldedSurface
{
public:
  UnfoldedSurface(const SurfaceDiscretization &part, const MirrorPlanes &planes);

  const SurfaceDiscretization &surface() const { return whole; }
  /** Values at its nodes of a field of the part: scalars are even, vectors (three components) are reflected. */
  std::vector<double> values(const std::vector<double> &of_part, unsigned int n_components) const;

private:
  /** The node of the part that a node is an image of, and which coordinates change sign. */
  struct Image
  {
    std::size_t node = 0;
    std::array<double, 3> sign{{1., 1., 1.}};
  };

  SurfaceDiscretization whole;
  std::vector<Image> images;
};
} // namespace pellicle
