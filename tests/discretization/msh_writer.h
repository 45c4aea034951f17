// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/discretization/polygon_mesh.h>

#include <cstdio>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

namespace pellicle
{
/** Writes the text to a file of its own in the test directory and returns its name. */
inline std::string write_text(const std::string &text)
{
  static int number      = 0;
  const auto *test       = testing::UnitTest::GetInstance()->current_test_info();
  const std::string file = testing::TempDir() + "pellicle_" + test->name() + "_" + std::to_string(number++) + ".msh";
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

/** MSH 4.1 ASCII text of a mesh: one block of nodes (with tags that neither begin at 1 nor are consecutive), one of
 * triangles and one of quadrilaterals, and what a reader must pass over: another section, a line element, a node that
 * nobody uses. */
inline std::string msh_text(const PolygonMesh &mesh)
{
  const auto tag      = [](const std::size_t v) { return std::to_string(10 + 3 * v); };
  std::size_t n_of[5] = {};
  for (const Polygon &polygon : mesh.polygons)
    ++n_of[polygon.n_vertices];
  const std::size_t n_nodes = mesh.vertices.size() + 1, n_elements = mesh.polygons.size() + 1;

  std::string text = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"membrane\"\n$EndPhysicalNames\n";
  text += "$Nodes\n1 " + std::to_string(n_nodes) + " 1 100000\n2 1 0 " + std::to_string(n_nodes) + "\n";
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
    text += tag(v) + "\n";
  text += "100000\n";
  char line[100];
  for (const auto &x : mesh.vertices)
  {
    std::snprintf(line, sizeof(line), "%.17g %.17g %.17g\n", x[0], x[1], x[2]);
    text += line;
  }
  text += "5 5 5\n$EndNodes\n";

  const int n_blocks = 1 + (n_of[3] > 0) + (n_of[4] > 0);
  text += "$Elements\n" + std::to_string(n_blocks) + " " + std::to_string(n_elements) + " 1 " +
          std::to_string(n_elements) + "\n";
  text += "1 1 1 1\n1 " + tag(0) + " " + tag(1) + "\n";
  std::size_t number = 2;
  for (const unsigned int n : {3u, 4u})
  {
    if (n_of[n] == 0)
      continue;
    text += "2 1 " + std::to_string(n - 1) + " " + std::to_string(n_of[n]) + "\n";
    for (const Polygon &polygon : mesh.polygons)
      if (polygon.n_vertices == n)
      {
        text += std::to_string(number++);
        for (unsigned int i = 0; i < n; ++i)
          text += " " + tag(polygon.vertices[i]);
        text += "\n";
      }
  }
  return text + "$EndElements\n";
}
} // namespace pellicle
