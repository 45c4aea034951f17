// SPDX-License-Identifier: LGPL-2.1-or-later
// Flat facets made round: normals, curves, and start shapes from files.
#include "expect_user_error.h"
#include "msh_writer.h"
#include "sample_meshes.h"

#include <pellicle/base/constants.h>
#include <pellicle/discretization/rounding.h>
#include <pellicle/discretization/smooth_shape.h>
#include <pellicle/discretization/start_shapes.h>
#include <pellicle/discretization/surface_quality.h>

namespace
{
using namespace pellicle;

/** Moves sphere points along the sphere, smoothly and without symmetry, and stretches the sphere to an ellipsoid. */
PolygonMesh distorted(PolygonMesh mesh, const double a, const double b, const double c)
{
  for (auto &x : mesh.vertices)
  {
    x = x + Vector3<double>(.15 * std::sin(2. * x[1]), .1 * std::cos(1.5 * x[2]), .12 * x[0] * x[1]);
    x = x / norm(x);
    x = {a * x[0], b * x[1], c * x[2]};
  }
  return mesh;
}

StartShape from(const PolygonMesh &mesh, const unsigned int degree, const unsigned int refinements)
{
  StartShape shape;
  shape.name        = "file";
  shape.file        = write_text(msh_text(mesh));
  shape.degree      = degree;
  shape.refinements = refinements;
  return shape;
}

/** Largest distance of the rounded facets from the unit sphere. */
double deviation_from_sphere(const PolygonMesh &mesh)
{
  const RoundedSurface rounded = round_polygons(mesh);
  double largest               = 0.;
  for (const QuadVertices &quad : rounded.quads)
    for (double xi = -1.; xi <= 1.; xi += .25)
      for (double eta = -1.; eta <= 1.; eta += .25)
        largest = std::max(largest, std::abs(norm(rounded_point(rounded, quad, xi, eta)) - 1.));
  return largest;
}

double reduced_volume(const SurfaceQuality &q)
{
  return 3. * q.volume / (4. * pi * std::pow(q.area / (4. * pi), 1.5));
}

TEST(Rounding, NormalsAreExactOnASphere)
{
  for (const PolygonMesh &mesh :
       {distorted(quad_sphere(3), 1., 1., 1.), distorted(cut_into_triangles(quad_sphere(3)), 1., 1., 1.)})
  {
    const auto normals = vertex_normals(mesh);
    for (std::size_t v = 0; v < normals.size(); ++v)
      EXPECT_NEAR(norm(normals[v] - mesh.vertices[v]), 0., 1e-13);
  }
}

TEST(Rounding, EdgesAreNearlyCirclesAndTheSameFromBothEnds)
{
  RoundedSurface quarter; // of the unit circle
  quarter.vertices = quarter.normals = {{1., 0., 0.}, {0., 1., 0.}};
  for (double t = 0.; t <= 1.; t += .125)
  {
    const Vector3<double> x = rounded_edge(quarter, 0, 1, t);
    EXPECT_NEAR(norm(x), 1., 3e-4);
    EXPECT_NEAR(norm(x - rounded_edge(quarter, 1, 0, 1. - t)), 0., 1e-15);
  }
  EXPECT_NEAR(norm(rounded_edge(quarter, 0, 1, .5)), 1., 1e-15);
}

TEST(Rounding, CoarseSpheresComeOutRound)
{
  // 24 facets of an eighth of a turn, and 96 of half of that. Flat ones miss the sphere by 0.13 and 0.05.
  EXPECT_LT(deviation_from_sphere(quad_sphere(2)), .013);
  EXPECT_LT(deviation_from_sphere(quad_sphere(4)), 2e-3);
  EXPECT_LT(deviation_from_sphere(distorted(quad_sphere(4), 1., 1., 1.)), 3e-3);
  EXPECT_LT(deviation_from_sphere(cut_into_triangles(quad_sphere(2))), .013);
}

TEST(Rounding, DeviationShrinksAtFourthOrder)
{
  for (const bool triangles : {false, true})
  {
    const auto sample = [&](const unsigned int n)
    {
      const PolygonMesh quads = distorted(quad_sphere(n), 1., 1., 1.);
      return deviation_from_sphere(triangles ? cut_into_triangles(quads) : quads);
    };
    EXPECT_GT(std::log2(sample(4) / sample(8)), 3.5) << (triangles ? "triangles" : "quadrilaterals");
  }
}

TEST(Rounding, AreaOfAFileConvergesAtLeastAtThirdOrder)
{
  // Sphere of 24, 96 and 384 facets (triangles: twice as many). The area is scaled to the wanted one: look at
  // V/A^(3/2).
  for (const bool triangles : {false, true})
  {
    std::vector<double> errors;
    for (const unsigned int n : {2u, 4u, 8u})
    {
      const PolygonMesh quads       = flipped_at_random(distorted(quad_sphere(n), 1., 1., 1.));
      const SurfaceDiscretization d = make_start_shape(from(triangles ? cut_into_triangles(quads) : quads, 4, 0));
      const SurfaceQuality q        = surface_quality(d, d.positions);
      EXPECT_NEAR(q.area, 4. * pi, 1e-12);
      EXPECT_EQ(d.n_cells, 6 * n * n * (triangles ? 6 : 1));
      errors.push_back(std::abs(reduced_volume(q) - 1.));
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]), 3.) << errors[0] << " " << errors[1];
    EXPECT_GT(std::log2(errors[1] / errors[2]), 3.) << errors[1] << " " << errors[2];
  }
}

TEST(Rounding, ReducedVolumeOfAnEllipsoidFromAFileConverges)
{
  const double exact = ellipsoid({{1.1, .8, .6}}).reduced_volume();
  for (const bool triangles : {false, true})
  {
    std::vector<double> errors;
    for (const unsigned int n : {4u, 8u})
    {
      const PolygonMesh quads       = distorted(quad_sphere(n), 1.1, .8, .6);
      const SurfaceDiscretization d = make_start_shape(from(triangles ? cut_into_triangles(quads) : quads, 3, 0));
      errors.push_back(std::abs(reduced_volume(surface_quality(d, d.positions)) - exact));
    }
    EXPECT_GT(std::log2(errors[0] / errors[1]), 3.) << errors[0] << " " << errors[1];
    EXPECT_LT(errors[1], 1e-4);
  }
}

TEST(Rounding, RefinementsCutTheRoundedFacets)
{
  const PolygonMesh mesh             = distorted(quad_sphere(2), 1., 1., 1.);
  const SurfaceDiscretization coarse = make_start_shape(from(mesh, 5, 0)), fine = make_start_shape(from(mesh, 5, 2));
  EXPECT_EQ(coarse.n_cells, 24u);
  EXPECT_EQ(fine.n_cells, 24u * 16u);
  const SurfaceQuality a = surface_quality(coarse, coarse.positions), b = surface_quality(fine, fine.positions);
  EXPECT_NEAR(reduced_volume(a), reduced_volume(b), 1e-5); // the same smooth facets, not rounder ones
  EXPECT_GT(std::abs(reduced_volume(b) - 1.), 1e-5);
}

TEST(Rounding, MixedMeshesAreCutAlike)
{
  PolygonMesh mesh    = quad_sphere(2);
  const Polygon first = mesh.polygons.front();
  mesh.polygons.erase(mesh.polygons.begin());
  add_polygon(mesh, {first.vertices[0], first.vertices[1], first.vertices[2]});
  add_polygon(mesh, {first.vertices[0], first.vertices[2], first.vertices[3]});
  const SurfaceDiscretization d = make_start_shape(from(mesh, 3, 0));
  EXPECT_EQ(d.n_cells, 23u * 4u + 2u * 3u);
  EXPECT_EQ(d.n_nodes, d.n_cells * 9 + 2);
}

TEST(Rounding, TorusFromAFileKeepsItsHole)
{
  PolygonMesh mesh;
  const unsigned int n = 12, m = 8;
  for (unsigned int j = 0; j < m; ++j)
    for (unsigned int i = 0; i < n; ++i)
    {
      const double a = 2. * pi * i / n, b = 2. * pi * j / m, rho = 2. + std::cos(b);
      mesh.vertices.emplace_back(rho * std::cos(a), rho * std::sin(a), std::sin(b));
      add_polygon(mesh, {j * n + i, j * n + (i + 1) % n, (j + 1) % m * n + (i + 1) % n, (j + 1) % m * n + i});
    }
  StartShape shape              = from(flipped_at_random(mesh), 3, 0);
  shape.area                    = 8. * pi * pi;
  const SurfaceDiscretization d = make_start_shape(shape);
  EXPECT_EQ(d.n_nodes, d.n_cells * 9);
  EXPECT_NEAR(surface_quality(d, d.positions).volume, 4. * pi * pi, .02 * 4. * pi * pi);
}

TEST(Rounding, UnusableFilesAreRefusedByTheStartShape)
{
  StartShape shape = from(projective_plane(), 3, 0);
  EXPECT_USER_ERROR(make_start_shape(shape), shape.file, "not orientable");
  PolygonMesh open = quad_sphere(2);
  open.polygons.pop_back();
  shape = from(open, 3, 0);
  EXPECT_USER_ERROR(make_start_shape(shape), shape.file, "closed surface is needed");
  shape = from(quad_sphere(6), 2, 8);
  EXPECT_USER_ERROR(make_start_shape(shape), "Refinements = 8", "at most 1000000");
  shape.file = "";
  EXPECT_USER_ERROR(make_start_shape(shape), "cannot be opened");
}

TEST(Rounding, SpikesAndRepeatedPointsAreRefused)
{
  PolygonMesh same                            = quad_sphere(2);
  same.vertices[same.polygons[0].vertices[0]] = same.vertices[same.polygons[0].vertices[1]];
  EXPECT_USER_ERROR(vertex_normals(same), "edge of length zero");
  PolygonMesh folded = quad_sphere(3); // one vertex pushed through to the other side
  folded.vertices[0] = -1.5 * folded.vertices[0];
  EXPECT_USER_ERROR(make_start_shape(from(folded, 3, 0)), "epair the mesh");
}
} // namespace
