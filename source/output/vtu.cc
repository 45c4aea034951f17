// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/output/atomic_file.h>
#include <pellicle/output/run_files.h>
#include <pellicle/output/vtu.h>

#include <deal.II/base/data_out_base.h>

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

namespace pellicle
{
namespace
{
template <int dim>
using Patch       = dealii::DataOutBase::Patch<dim, 3>;
using RangeOfRows = std::tuple<unsigned int, unsigned int, std::string,
                               dealii::DataComponentInterpretation::DataComponentInterpretation>;

constexpr auto is_vector = dealii::DataComponentInterpretation::component_is_part_of_vector;
constexpr auto is_tensor = dealii::DataComponentInterpretation::component_is_part_of_tensor;

/**
 * One cell in deal.II's terms: a table with a row for each scalar component and a column for each point, points
 * lexicographic as in the sample. The last three rows are the coordinates; deal.II takes the points from there when
 * `points_are_available`.
 */
template <int dim>
Patch<dim> make_patch(const SurfaceSample &sample, const std::vector<SampledField> &fields,
                      const unsigned int n_components, const std::size_t cell)
{
  const std::size_t n_points = sample.points_per_cell(), first = cell * n_points;
  const unsigned int k = sample.degree;

  Patch<dim> patch;
  patch.patch_index          = cell;
  patch.reference_cell       = dealii::ReferenceCells::get_hypercube<dim>(); // the default is none, and writes no cells
  patch.n_subdivisions       = k;
  patch.points_are_available = true;
  patch.data.reinit(n_components + 3, n_points);

  unsigned int row = 0;
  for (const SampledField &field : fields)
    for (unsigned int c = 0; c < field.n_components; ++c, ++row)
      for (std::size_t p = 0; p < n_points; ++p)
        patch.data(row, p) = field.values[(first + p) * field.n_components + c];
  for (unsigned int c = 0; c < 3; ++c, ++row)
    for (std::size_t p = 0; p < n_points; ++p)
      patch.data(row, p) = sample.points[3 * (first + p) + c];

  for (unsigned int v = 0; v < (1u << dim); ++v)
  {
    std::size_t corner = first, stride = k;
    for (unsigned int d = 0; d < dim; ++d, stride *= k + 1)
      corner += ((v >> d) & 1u) * stride;
    for (unsigned int c = 0; c < 3; ++c)
      patch.vertices[v][c] = sample.points[3 * corner + c];
  }
  return patch;
}

template <int dim>
std::string vtu_text(const SurfaceSample &sample)
{
  std::vector<SampledField> fields = {{"position", 3, sample.points}};
  for (const SampledField &field : sample.fields)
    if (field.name != "position")
      fields.push_back(field);

  std::vector<std::string> component_names;
  std::vector<RangeOfRows> ranges;
  for (const SampledField &field : fields)
  {
    PELLICLE_ASSERT(field.n_components == 1 || field.n_components == 3 || field.n_components == 9,
                    "fields are scalars, vectors or tensors");
    PELLICLE_ASSERT(field.values.size() == sample.n_points() * field.n_components, "a value for every point");
    const unsigned int first = component_names.size();
    if (field.n_components > 1)
      ranges.emplace_back(first, first + field.n_components - 1, field.name,
                          field.n_components == 3 ? is_vector : is_tensor);
    component_names.insert(component_names.end(), field.n_components, field.name);
  }

  std::vector<Patch<dim>> patches;
  patches.reserve(sample.n_cells);
  for (std::size_t cell = 0; cell < sample.n_cells; ++cell)
    patches.push_back(make_patch<dim>(sample, fields, component_names.size(), cell));

  dealii::DataOutBase::VtkFlags flags;
  flags.write_higher_order_cells = true;
  flags.print_date_and_time      = false; // the same run gives the same file
  flags.compression_level        = dealii::DataOutBase::VtkFlags::best_speed;
  std::ostringstream out;
  dealii::DataOutBase::write_vtu(patches, component_names, ranges, flags, out);
  return out.str();
}
} // namespace

void write_vtu(const std::filesystem::path &path, const SurfaceSample &sample)
{
  PELLICLE_ASSERT(sample.degree >= 1, "cells of degree 1 or more");
  PELLICLE_ASSERT(sample.points.size() == 3 * sample.n_points(), "three coordinates for every point");
  write_whole_file(path, sample.dimension == 3 ? vtu_text<3>(sample) : vtu_text<2>(sample));
}

SolutionFiles::SolutionFiles(std::filesystem::path output_directory)
    : directory(std::move(output_directory))
{
}

std::filesystem::path SolutionFiles::write(const SurfaceSample &sample, const int step, const double time,
                                           const std::vector<NamedSample> &bodies)
{
  const auto write_part = [&](const std::string &part_name, const SurfaceSample &part, const std::size_t number)
  {
    std::ostringstream name;
    name << part_name << '_' << std::setw(4) << std::setfill('0') << step << ".vtu";
    write_vtu(directory / name.str(), part);
    parts.push_back({time, number, name.str()});
    return directory / name.str();
  };
  const std::filesystem::path path = write_part("solution", sample, 0);
  for (std::size_t b = 0; b < bodies.size(); ++b)
    write_part(bodies[b].name, bodies[b].sample, b + 1);
  write_index();
  return path;
}

void SolutionFiles::write_index() const
{
  std::ostringstream index;
  index << std::setprecision(16) << "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
        << "byte_order=\"LittleEndian\">\n  <Collection>\n";
  for (const Part &part : parts)
    index << "    <DataSet timestep=\"" << part.time << "\" group=\"\" part=\"" << part.number << "\" file=\""
          << part.file << "\"/>\n";
  index << "  </Collection>\n</VTKFile>\n";
  write_whole_file(directory / "solution.pvd", index.str());
}

void SolutionFiles::exchange(Archive &archive, const std::filesystem::path &of_earlier)
{
  namespace fs = std::filesystem;
  archive | parts;
  if (!archive.is_reading())
    return;
  for (const Part &part : parts)
    check_file_name(part.file);
  // Whoever has removed a file does not miss it in the index.
  parts.erase(
      std::remove_if(parts.begin(), parts.end(), [&](const Part &part) { return !fs::exists(of_earlier / part.file); }),
      parts.end());
  std::set<std::string> files;
  for (const Part &part : parts)
    files.insert(part.file);
  remove_solutions(directory, files);
  if (!fs::equivalent(of_earlier, directory))
    for (const std::string &file : files)
    {
      std::ostringstream content;
      content << std::ifstream(of_earlier / file, std::ios::binary).rdbuf();
      write_whole_file(directory / file, content.str());
    }
  if (!parts.empty())
    write_index();
}

std::filesystem::path SolutionFiles::last() const
{
  for (auto part = parts.rbegin(); part != parts.rend(); ++part)
    if (part->number == 0)
      return directory / part->file;
  return {};
}
} // namespace pellicle
