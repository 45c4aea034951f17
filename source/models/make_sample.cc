// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/models/make_sample.h>

#include <boost/math/special_functions/cos_pi.hpp>
#include <boost/math/special_functions/sin_pi.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace pellicle
{
namespace
{
/** Cell after cell, point after point: sum_I table(0, p, I) v_I. */
std::vector<double> interpolate(const SurfaceDiscretization &discretization, const ShapeTables &at_points,
                                const std::vector<double> &values, const unsigned int n_components)
{
  PELLICLE_ASSERT(values.size() == n_components * discretization.n_nodes, "a value for every node");
  std::vector<double> result(discretization.n_cells * at_points.n_points * n_components, 0.);
  double *out = result.data();
  for (std::size_t cell = 0; cell < discretization.n_cells; ++cell)
  {
    const std::size_t *const nodes = &discretization.cell_nodes[cell * at_points.n_nodes];
    for (unsigned int p = 0; p < at_points.n_points; ++p, out += n_components)
      for (unsigned int i = 0; i < at_points.n_nodes; ++i)
        for (unsigned int c = 0; c < n_components; ++c)
          out[c] += at_points.tables[0][std::size_t(p) * at_points.n_nodes + i] * values[n_components * nodes[i] + c];
  }
  return result;
}

/** (i/k, j/k), i fastest; on a meridian i/k only. */
std::vector<std::array<double, 2>> equidistant_points(const SurfaceDiscretization &discretization)
{
  const unsigned int k = discretization.degree;
  std::vector<std::array<double, 2>> points;
  for (unsigned int j = 0; j <= (discretization.kind == SurfaceDiscretization::Kind::surface ? k : 0); ++j)
    for (unsigned int i = 0; i <= k; ++i)
      points.push_back({{double(i) / k, double(j) / k}});
  return points;
}

/** Turns what was sampled along a meridian into what belongs to the points of revolved cells. */
class Revolution
{
public:
  Revolution(const SurfaceDiscretization &discretization, const unsigned int n_azimuth)
      : k(discretization.degree)
      , n_line_cells(discretization.n_cells)
      , n_halves(discretization.mirror ? 2 : 1)
  {
    for (unsigned int j = 0; j <= n_azimuth * k; ++j)
    {
      const double angle =
          2. * (j % (n_azimuth * k)) / (n_azimuth * k); // in units of pi; the last is exactly the first
      cosines.push_back(boost::math::cos_pi(angle));
      sines.push_back(boost::math::sin_pi(angle));
    }
  }

  std::size_t n_cells() const { return n_halves * n_line_cells * n_around(); }

  std::vector<double> operator()(const std::vector<double> &line, const unsigned int n_components) const
  {
    std::vector<double> result;
    result.reserve(n_cells() * (k + 1) * (k + 1) * n_components);
    for (unsigned int half = 0; half < n_halves; ++half)
      for (std::size_t cell = 0; cell < n_line_cells; ++cell)
        for (std::size_t around = 0; around < n_around(); ++around)
          for (unsigned int j = 0; j <= k; ++j)
            for (unsigned int i = 0; i <= k; ++i)
            {
              // Reflection turns a cell inside out; walked the other way along the meridian it faces outwards again.
              const std::size_t along = cell * (k + 1) + (half == 0 ? i : k - i);
              append(result, &line[along * n_components], n_components, around * k + j, half == 0 ? 1. : -1.);
            }
    return result;
  }

private:
  std::size_t n_around() const { return (cosines.size() - 1) / k; }

  void append(std::vector<double> &result, const double *const v, const unsigned int n_components,
              const std::size_t azimuth, const double z_sign) const
  {
    if (n_components == 1)
    {
      result.push_back(*v);
      return;
    }
    const double c = cosines[azimuth], s = sines[azimuth];
    result.insert(result.end(), {c * v[0] - s * v[1], s * v[0] + c * v[1], z_sign * v[2]});
  }

  const unsigned int k;
  const std::size_t n_line_cells;
  const unsigned int n_halves;
  std::vector<double> cosines, sines; ///< at n_azimuth k + 1 angles
};
} // namespace

SurfaceSample make_sample(const SurfaceDiscretization &discretization, const NodalVectors &positions,
                          const std::vector<SampledNodalField> &fields, const unsigned int n_azimuth)
{
  PELLICLE_ASSERT(n_azimuth >= 3, "three cells are the fewest round an axis");
  const bool meridian = discretization.kind == SurfaceDiscretization::Kind::meridian;
  const ShapeTables at_points =
      make_tables_at(discretization.kind, discretization.degree, equidistant_points(discretization));
  const Revolution revolve(discretization, n_azimuth);

  const auto sampled = [&](const std::vector<double> &values, const unsigned int n_components)
  {
    PELLICLE_ASSERT(n_components == 1 || n_components == 3, "a field is a scalar or a vector");
    const std::vector<double> own = interpolate(discretization, at_points, values, n_components);
    return meridian ? revolve(own, n_components) : own;
  };
  SurfaceSample sample;
  sample.degree  = discretization.degree;
  sample.n_cells = meridian ? revolve.n_cells() : discretization.n_cells;
  sample.points  = sampled(positions, 3);
  if (!discretization.cell_region.empty())
  {
    std::vector<double> regions;
    for (const unsigned int region : discretization.cell_region)
      regions.insert(regions.end(), at_points.n_points, region);
    sample.fields.push_back({"region", 1, meridian ? revolve(regions, 1) : std::move(regions)});
  }
  for (const SampledNodalField &field : fields)
    sample.fields.push_back({field.name, field.n_components, sampled(field.values, field.n_components)});
  return sample;
}
} // namespace pellicle
