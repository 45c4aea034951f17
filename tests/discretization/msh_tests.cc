// SPDX-License-Identifier: LGPL-2.1-or-later
// Reading and orienting meshes from files: what is read, what is repaired, what is refused and with which words.
#include "expect_user_error.h"
#include "msh_writer.h"
#include "sample_meshes.h"

#include <algorithm>

namespace
{
using namespace pellicle;

double volume(const PolygonMesh &mesh)
{
  double sum = 0.;
  for (const Polygon &p : mesh.polygons)
    for (unsigned int i = 1; i + 1 < p.n_vertices; ++i)
      sum += dot(mesh.vertices[p.vertex(0)], cross(mesh.vertices[p.vertex(i)], mesh.vertices[p.vertex(i + 1)])) / 6.;
  return sum;
}

/** Text with the first occurrence of a part replaced. */
std::string replaced(std::string text, const std::string &part, const std::string &by)
{
  const std::size_t at = text.find(part);
  EXPECT_NE(at, std::string::npos) << part;
  return text.replace(at, part.size(), by);
}

TEST(MshReader, ReadsQuadrilateralsAndTrianglesAndNothingElse)
{
  for (const bool triangles : {false, true})
  {
    const PolygonMesh written = triangles ? cut_into_triangles(quad_sphere(2)) : quad_sphere(2);
    PolygonMesh read          = read_msh(write_text(msh_text(written)));
    ASSERT_EQ(read.polygons.size(), written.polygons.size());
    ASSERT_EQ(read.vertices.size(), written.vertices.size()); // the unused node is gone
    for (std::size_t p = 0; p < read.polygons.size(); ++p)
    {
      ASSERT_EQ(read.polygons[p].n_vertices, written.polygons[p].n_vertices);
      EXPECT_EQ(read.polygons[p].name, p + 2);
      for (unsigned int i = 0; i < read.polygons[p].n_vertices; ++i)
      {
        const unsigned int v = read.polygons[p].vertex(i), w = written.polygons[p].vertex(i);
        EXPECT_EQ(norm(read.vertices[v] - written.vertices[w]), 0.);
        EXPECT_EQ(read.vertex_names[v], 10 + 3 * w);
      }
    }
  }
}

TEST(MshReader, AcceptsWindowsLineEndsAndBlankLines)
{
  std::string text = msh_text(quad_sphere(1)), windows = "\r\n";
  for (const char c : text)
    windows += (c == '\n') ? std::string("\r\n\r\n") : std::string(1, c);
  EXPECT_EQ(read_msh(write_text(windows)).polygons.size(), 6u);
}

TEST(MshReader, NamesFileAndLineOfMistakes)
{
  const std::string good = msh_text(quad_sphere(1));
  const auto read        = [&](const std::string &text) { return read_msh(write_text(text)); };

  EXPECT_USER_ERROR(read_msh("/no/such/file.msh"), "'/no/such/file.msh' cannot be opened");
  EXPECT_USER_ERROR(read(""), "not a Gmsh mesh");
  EXPECT_USER_ERROR(read("solid sphere\nfacet normal 0 0 1\n"), ".msh:1:", "not a Gmsh mesh");
  EXPECT_USER_ERROR(read(replaced(good, "4.1 0 8", "2.2 0 8")), ".msh:2:", "version 2.2", "-format msh41");
  EXPECT_USER_ERROR(read(replaced(good, "4.1 0 8", "4.1 1 8")), ".msh:2:", "binary", "ASCII");
  EXPECT_USER_ERROR(read(good.substr(0, 20)), "the file ends");
  EXPECT_USER_ERROR(read(good.substr(0, good.find("$EndNodes") - 20)), "$Nodes", "incomplete");
  EXPECT_USER_ERROR(read(good.substr(0, good.find("$EndElements"))), "$EndElements", "incomplete");
  EXPECT_USER_ERROR(read(good.substr(0, good.find("$Elements"))), "no surface elements");
  EXPECT_USER_ERROR(read(replaced(good, "2 1 3 6\n", "2 1 3 7\n")), "$Elements ends too early", "fewer entries");
  EXPECT_USER_ERROR(read(replaced(good, "2 1 0 9\n", "2 1 0 99999999999999\n")), "is not a whole number");
  EXPECT_USER_ERROR(read(replaced(good, "2 1 0 9\n", "2 1 0 99999999999999999999999\n")),
                    "'99999999999999999999999' is not a whole number");
  EXPECT_USER_ERROR(read(replaced(good, "5 5 5\n", "5 five 5\n")), "'five' is not a number");
  EXPECT_USER_ERROR(read(replaced(good, "5 5 5\n", "5 nan 5\n")), "'nan' is not a finite number");
  EXPECT_USER_ERROR(read(replaced(good, "5 5 5\n", "5 5\n")), "expected 3 numbers", "found 2");
  EXPECT_USER_ERROR(read(replaced(good, "\n13\n", "\n-13\n")), "'-13' is not a whole number");
  EXPECT_USER_ERROR(read(replaced(good, "\n13\n", "\n16\n")), "node 16 is given twice");
  EXPECT_USER_ERROR(read(replaced(good, "\n100000\n", "\n100001\n$")), "$Nodes ends too early");
  EXPECT_USER_ERROR(read(replaced(good, "\n2 10 13 16 19\n", "\n2 10 13 16 777\n")),
                    ".msh:35:", "element 2 uses node 777", "does not define");
  EXPECT_USER_ERROR(read(replaced(good, "\n2 10 13 16 19\n", "\n2 10 13 13 19\n")), "element 2 uses node 13 twice");
  EXPECT_USER_ERROR(read(replaced(good, "\n2 10 13 16 19\n", "\n2 10 13 16\n")), "expected 5 numbers");
  EXPECT_USER_ERROR(read(replaced(good, "2 1 3 6\n", "2 1 10 6\n")), "9-node quadrilaterals (type 10)", "-order 1");
  EXPECT_USER_ERROR(read(replaced(good, "2 1 3 6\n", "2 1 9 6\n")), "6-node triangles (type 9)", "-order 1");
  EXPECT_USER_ERROR(read(replaced(good, "2 1 3 6\n", "3 1 4 6\n")), "no surface elements"); // tetrahedra only
  EXPECT_USER_ERROR(read(replaced(good, "$Elements", "stray\n$Elements")), "'stray'", "beginning of a section");
}

TEST(Orientation, FlippedFacetsAreTurnedOutwards)
{
  for (const bool triangles : {false, true})
  {
    const PolygonMesh outward = triangles ? cut_into_triangles(quad_sphere(3)) : quad_sphere(3);
    PolygonMesh mesh          = flipped_at_random(outward);
    EXPECT_LT(volume(mesh), .5 * volume(outward));
    orient_closed_surface(mesh);
    EXPECT_NEAR(volume(mesh), volume(outward), 1e-14);

    PolygonMesh inward = outward; // all the same way, but the wrong one
    for (Polygon &p : inward.polygons)
      std::reverse(p.vertices.begin(), p.vertices.begin() + p.n_vertices);
    orient_closed_surface(inward);
    EXPECT_NEAR(volume(inward), volume(outward), 1e-14);
  }
}

TEST(Orientation, SurfacesThatAreNotClosedManifoldsAreRefused)
{
  PolygonMesh open = quad_sphere(2);
  open.polygons.pop_back();
  EXPECT_USER_ERROR(orient_closed_surface(open), "sample: edge (", "belongs to one cell only",
                    "closed surface is needed");

  PolygonMesh fin = quad_sphere(2);
  fin.vertices.emplace_back(2., 2., 2.);
  fin.vertex_names.push_back(4711);
  add_polygon(fin, {fin.polygons[0].vertices[0], fin.polygons[0].vertices[1],
                    static_cast<unsigned int>(fin.vertices.size() - 1)});
  EXPECT_USER_ERROR(orient_closed_surface(fin), "edge (");
  PolygonMesh repeated = quad_sphere(2);
  repeated.polygons.push_back(repeated.polygons[3]);
  EXPECT_USER_ERROR(orient_closed_surface(repeated), "belongs to 3 cells", "non-manifold");

  PolygonMesh two       = quad_sphere(1);
  const PolygonMesh one = quad_sphere(1);
  for (const auto &x : one.vertices)
  {
    two.vertex_names.push_back(two.vertices.size());
    two.vertices.push_back(x + Vector3<double>(5., 0., 0.));
  }
  for (const Polygon &p : one.polygons)
    add_polygon(two, {p.vertices[0] + 8, p.vertices[1] + 8, p.vertices[2] + 8, p.vertices[3] + 8});
  EXPECT_USER_ERROR(orient_closed_surface(two), "more than one piece", "6 of 12");

  PolygonMesh flat = quad_sphere(1);
  for (auto &x : flat.vertices)
    x[2] = 1.;
  EXPECT_USER_ERROR(orient_closed_surface(flat), "encloses no volume");
}

TEST(Orientation, PinchedVertexIsRefused)
{
  // Two opposite vertices of a sphere made one: all edges are still shared by two cells.
  PolygonMesh mesh = quad_sphere(4);
  unsigned int top = 0, bottom = 0;
  for (unsigned int v = 0; v < mesh.vertices.size(); ++v)
  {
    if (mesh.vertices[v][2] > 1. - 1e-9)
      top = v;
    if (mesh.vertices[v][2] < -1. + 1e-9)
      bottom = v;
  }
  for (Polygon &p : mesh.polygons)
    std::replace(p.vertices.begin(), p.vertices.end(), bottom, top);
  EXPECT_USER_ERROR(orient_closed_surface(mesh), "touches itself at node " + std::to_string(top));
}

TEST(Orientation, ProjectivePlaneIsRefused)
{
  PolygonMesh mesh = projective_plane();
  EXPECT_USER_ERROR(orient_closed_surface(mesh), "not orientable");
}

TEST(MshReader, WhatIsNoTextIsRefused)
{
  EXPECT_USER_ERROR(read_msh("/dev/zero"), "/dev/zero:1", "line of more than 999999 characters");
  EXPECT_USER_ERROR(read_msh(testing::TempDir()), "is a directory");
}
} // namespace
