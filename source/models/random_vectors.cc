// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/discretization/admissible.h>
#include <pellicle/models/random_vectors.h>

#include <cstdint>
#include <random>

namespace pellicle
{
NodalVectors random_vectors(const SurfaceDiscretization &surface, const double amplitude, const int seed)
{
  NodalVectors vectors(3 * surface.n_nodes);
  // The raw generator is the same everywhere, the standard distributions are not.
  std::mt19937 random(static_cast<std::uint32_t>(seed));
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
  {
    Vector3<double> any;
    for (unsigned int c = 0; c < 3; ++c)
      any[c] = amplitude * (2. * (random() / 4294967296.) - 1.);
    set_vector_at(vectors, I, admissible_part(admissible_at(surface, I), any));
  }
  return vectors;
}
} // namespace pellicle
