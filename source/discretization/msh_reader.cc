// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/discretization/polygon_mesh.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <unordered_map>

namespace pellicle
{
namespace
{
/** The file line by line, cut into words. */
class MshText
{
public:
  explicit MshText(const std::string &file)
      : file(file)
      , stream(file)
  {
    if (!stream)
      throw UserError("Mesh file '" + file + "' cannot be opened: check the name and permissions.");
    if (std::filesystem::is_directory(file))
      throw UserError("Mesh file '" + file + "' is a directory: a Gmsh file is needed.");
  }

  [[noreturn]] void fail(const std::string &what, const std::size_t at_line = 0) const
  {
    throw UserError(file + ":" + std::to_string(at_line > 0 ? at_line : line_number) + ": " + what);
  }

  /** Next line that is not blank; false at the end of the file. */
  bool next()
  {
    while (stream.getline(buffer.data(), static_cast<std::streamsize>(buffer.size())))
    {
      ++line_number;
      const std::string line = buffer.data();
      words.clear();
      std::size_t begin = 0;
      while ((begin = line.find_first_not_of(blanks, begin)) != std::string::npos)
      {
        const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
        words.push_back(line.substr(begin, end - begin));
        begin = end;
      }
      if (!words.empty())
        return true;
    }
    if (!stream.eof())
      fail("the file cannot be read further, or has a line of more than " + std::to_string(buffer.size() - 1) +
               " characters: it is no ASCII file of Gmsh.",
           line_number + 1);
    words.clear();
    return false;
  }

  /** Next line of a section, with at least `n_words` words. */
  void next_in(const std::string &section, const std::size_t n_words)
  {
    if (!next())
      fail("the file ends inside " + section + ": it is incomplete, write it again.");
    if (words.front()[0] == '$')
      fail(section + " ends too early, with '" + words.front() + "': it has fewer entries than its counts say.");
    if (words.size() < n_words)
      fail("expected " + std::to_string(n_words) + " numbers in " + section + ", found " +
           std::to_string(words.size()) + ".");
  }

  /** Consumes the rest of a section. */
  void skip_to(const std::string &end)
  {
    while (next())
      if (words.front() == end)
        return;
    fail("the file ends before '" + end + "': it is incomplete, write it again.");
  }

  std::size_t count(const std::size_t i) const { return number<std::size_t>(i, "a whole number >= 0"); }

  double real(const std::size_t i) const
  {
    const double value = number<double>(i, "a number");
    if (!std::isfinite(value))
      fail("'" + words[i] + "' is not a finite number.");
    return value;
  }

  const std::string &word(const std::size_t i) const { return words[i]; }
  std::size_t line() const { return line_number; }

private:
  template <typename Number>
  Number number(const std::size_t i, const char *what) const
  {
    Number value{};
    const std::string &text = words[i];
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
      fail("'" + text + "' is not " + what + ".");
    return value;
  }

  static constexpr const char *blanks = " \t\r";

  std::string file;
  std::ifstream stream;
  std::vector<char> buffer = std::vector<char>(1000000); // for a line: files that are not text may have endless ones
  std::vector<std::string> words;
  std::size_t line_number = 0;
};

/** A facet whose nodes are still tags of the file. */
struct RawFacet
{
  std::size_t name = 0, line = 0;
  unsigned int n_vertices = 3;
  std::array<std::size_t, 4> tags{};
};

using NodeTable = std::unordered_map<std::size_t, Vector3<double>>;

void read_header(MshText &text)
{
  if (!text.next() || text.word(0) != "$MeshFormat")
    text.fail("this is not a Gmsh mesh: an MSH file begins with '$MeshFormat'.");
  text.next_in("$MeshFormat", 3);
  if (text.word(0) != "4.1")
    text.fail("MSH version " + text.word(0) +
              " is not read; write the mesh with 'gmsh -2 -format msh41' (version 4.1, ASCII).");
  if (text.word(1) != "0")
    text.fail("binary MSH files are not read; write the mesh as ASCII ('gmsh -2 -format msh41 -save_all', option "
              "Mesh.Binary = 0).");
  text.skip_to("$EndMeshFormat");
}

void read_nodes(MshText &text, NodeTable &nodes)
{
  const std::string section = "$Nodes";
  text.next_in(section, 4);
  const std::size_t n_blocks = text.count(0);
  for (std::size_t block = 0; block < n_blocks; ++block)
  {
    text.next_in(section, 4);
    const std::size_t n_nodes = text.count(3);
    std::vector<std::size_t> tags; // grows with the file, whatever the count claims
    for (std::size_t i = 0; i < n_nodes; ++i)
    {
      text.next_in(section, 1);
      tags.push_back(text.count(0));
    }
    for (const std::size_t tag : tags)
    {
      text.next_in(section, 3);
      if (!nodes.emplace(tag, Vector3<double>(text.real(0), text.real(1), text.real(2))).second)
        text.fail("node " + std::to_string(tag) + " is given twice.");
    }
  }
  text.skip_to("$EndNodes");
}

/** What a surface element that cannot be used is called, by its type in the file; empty for lines, volumes and points.
 */
std::string unusable_facet(const std::size_t type, const std::size_t dimension)
{
  static const std::map<std::size_t, std::string> names = {
      {9, "6-node triangles"},   {10, "9-node quadrilaterals"}, {16, "8-node quadrilaterals"},
      {20, "9-node triangles"},  {21, "10-node triangles"},     {22, "12-node triangles"},
      {23, "15-node triangles"}, {36, "16-node quadrilaterals"}};
  const auto found = names.find(type);
  if (found != names.end())
    return found->second;
  return dimension == 2 ? "surface elements" : "";
}

void read_elements(MshText &text, std::vector<RawFacet> &facets)
{
  const std::string section = "$Elements";
  text.next_in(section, 4);
  const std::size_t n_blocks = text.count(0);
  for (std::size_t block = 0; block < n_blocks; ++block)
  {
    text.next_in(section, 4);
    const std::size_t dimension = text.count(0), type = text.count(2), n_elements = text.count(3);
    const bool wanted = (type == 2 || type == 3);
    if (!wanted && n_elements > 0 && !unusable_facet(type, dimension).empty())
      text.fail(unusable_facet(type, dimension) + " (type " + std::to_string(type) +
                ") are not read: only 3-node triangles and 4-node quadrilaterals are. Write the mesh with 'gmsh -2 "
                "-order 1 -format msh41'.");

    const unsigned int n_vertices = (type == 2) ? 3 : 4;
    for (std::size_t i = 0; i < n_elements; ++i)
    {
      text.next_in(section, wanted ? n_vertices + 1 : 1);
      if (!wanted)
        continue;
      RawFacet facet;
      facet.name       = text.count(0);
      facet.line       = text.line();
      facet.n_vertices = n_vertices;
      for (unsigned int v = 0; v < n_vertices; ++v)
        facet.tags[v] = text.count(v + 1);
      facets.push_back(facet);
    }
  }
  text.skip_to("$EndElements");
}

/** Replaces tags by running numbers; only nodes in use get one. */
PolygonMesh resolve(const MshText &text, const std::string &file, const NodeTable &nodes,
                    const std::vector<RawFacet> &facets)
{
  PolygonMesh mesh;
  mesh.source = file;
  std::unordered_map<std::size_t, unsigned int> number_of;
  for (const RawFacet &facet : facets)
  {
    Polygon polygon;
    polygon.n_vertices = facet.n_vertices;
    polygon.name       = facet.name;
    for (unsigned int v = 0; v < facet.n_vertices; ++v)
    {
      const std::size_t tag = facet.tags[v];
      const auto node       = nodes.find(tag);
      if (node == nodes.end())
        text.fail("element " + std::to_string(facet.name) + " uses node " + std::to_string(tag) +
                      ", which the file does not define.",
                  facet.line);
      for (unsigned int w = 0; w < v; ++w)
        if (facet.tags[w] == tag)
          text.fail("element " + std::to_string(facet.name) + " uses node " + std::to_string(tag) + " twice.",
                    facet.line);
      const auto [entry, is_new] = number_of.emplace(tag, static_cast<unsigned int>(mesh.vertices.size()));
      if (is_new)
      {
        mesh.vertices.push_back(node->second);
        mesh.vertex_names.push_back(tag);
      }
      polygon.vertices[v] = entry->second;
    }
    mesh.polygons.push_back(polygon);
  }
  return mesh;
}
} // namespace

PolygonMesh read_msh(const std::string &file)
{
  MshText text(file);
  read_header(text);

  NodeTable nodes;
  std::vector<RawFacet> facets;
  while (text.next())
  {
    const std::string section = text.word(0);
    if (section[0] != '$')
      text.fail("expected the beginning of a section ('$...'), found '" + section + "'.");
    if (section == "$Nodes")
      read_nodes(text, nodes);
    else if (section == "$Elements")
      read_elements(text, facets);
    else
      text.skip_to("$End" + section.substr(1));
  }
  if (facets.empty())
    text.fail("no surface elements (3-node triangles or 4-node quadrilaterals) up to the end of the file: mesh the "
              "surface ('gmsh -2') and, "
              "if physical groups are defined, put the surface in one of them or save all elements.");
  return resolve(text, file, nodes, facets);
}
} // namespace pellicle
