// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
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
    Vector3<double> any, admitted;
    for (unsigned int c = 0; c < 3; ++c)
      any[c] = amplitude * (2. * (random() / 4294967296.) - 1.);
    const AdmissibleDirections directions = surface.admissible.empty() ? AdmissibleDirections{} : surface.admissible[I];
    for (unsigned int j = 0; j < directions.count; ++j)
    {
      const Vector3<double> e(directions.columns[j][0], directions.columns[j][1], directions.columns[j][2]);
      admitted += dot(any, e) * e;
    }
    set_vector_at(vectors, I, admitted);
  }
  return vectors;
}
} // namespace pellicle
