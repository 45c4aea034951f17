// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/assembly/edge_frames.h>
#include <pellicle/assembly/nodal_chart.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/base/near_match.h>
#include <pellicle/models/director_start.h>
#include <pellicle/models/random_vectors.h>

#include <cmath>
#include <functional>

namespace pellicle
{
namespace
{
using Direction = Vector3<double>;

struct StartField
{
  std::string name;
  bool in_meridian_plane;
  std::function<Direction(const Direction &n, double angle)> director;
};

const Direction e_z(0., 0., 1.);

const std::vector<StartField> &start_fields_of_directors()
{
  static const std::vector<StartField> fields{
      {"normal", true, [](const Direction &n, double) { return n; }},
      {"turned", false,
       [](const Direction &n, const double angle)
       {
         const double c = std::cos(angle), s = std::sin(angle);
         return Direction(c * n[0] - s * n[1], s * n[0] + c * n[1], n[2]);
       }},
      {"towards z", true,
       [](const Direction &n, const double angle)
       {
         const Direction along = e_z - n[2] * n;
         const double s        = angle * norm(along);
         return std::cos(s) * n + std::sin(s) * unit_or(along, Direction());
       }},
      {"meridional", true, [](const Direction &n, double) { return unit_or(e_z - n[2] * n, e_z); }},
      {"azimuthal", false, [](const Direction &n, double) { return unit_or(cross(e_z, n), n); }},
  };
  return fields;
}
} // namespace

const std::vector<std::string> &director_start_names()
{
  static const std::vector<std::string> names = []
  {
    std::vector<std::string> list;
    for (const StartField &field : start_fields_of_directors())
      list.push_back(field.name);
    return list;
  }();
  return names;
}

NodalVectors start_directors(const SurfaceDiscretization &surface, const std::string &name, const double angle)
{
  for (const StartField &field : start_fields_of_directors())
  {
    if (field.name != name)
      continue;
    if (surface.kind == SurfaceDiscretization::Kind::meridian && !field.in_meridian_plane)
      throw UserError("Director field/Start = " + name +
                      " leaves the plane of the meridian: take Mesh/Symmetry = none, or another start.");
    NodalVectors directors = nodal_normals(surface, surface.positions);
    for (std::size_t I = 0; I < surface.n_nodes; ++I)
      set_vector_at(directors, I, field.director(vector_at(directors, I), angle));
    return directors;
  }
  throw UserError("Director field/Start = " + name + " is not known." + suggestion(name, director_start_names()));
}

void add_director_noise(const SurfaceDiscretization &surface, const double amplitude, const int seed,
                        NodalVectors &directors)
{
  if (amplitude == 0.)
    return;
  const NodalVectors noise = random_vectors(surface, amplitude, seed);
  for (std::size_t I = 0; I < surface.n_nodes; ++I)
  {
    const Direction O = vector_at(directors, I) + vector_at(noise, I);
    set_vector_at(directors, I, (1. / norm(O)) * O);
  }
}
} // namespace pellicle
