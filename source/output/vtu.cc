// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/output/atomic_file.h>
#include <pellicle/output/vtu.h>

#include <deal.II/base/data_out_base.h>

#include <iomanip>
#include <sstream>
#include <tuple>

namespace pellicle
{
namespace
{
using Patch       = dealii::DataOutBase::Patch<2, 3>;
using VectorRange = std::tuple<unsigned int, unsigned int, std::string,
                               dealii::DataComponentInterpretation::DataComponentInterpretation>;

constexpr auto is_vector = dealii::DataComponentInterpretation::component_is_part_of_vector;

/**
 * One cell in deal.II's terms: a table with a row for each scalar component and a column for each point, points
 * lexicographic as in the sample. The last three rows are the coordinates; deal.II takes the points from there when
 * `points_are_available`.
 */
Patch make_patch(const SurfaceSample &sample, const std::vector<SampledField> &fields, const unsigned int n_components,
                 const std::size_t cell)
{
  const std::size_t n_points = sample.points_per_cell(), first = cell * n_points;
  const unsigned int k = sample.degree;

  Patch patch;
  patch.patch_index          = cell;
  patch.reference_cell       = dealii::ReferenceCells::Quadrilateral; // the default is none, and writes no cells
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

  const std::size_t corners[4] = {0, k, std::size_t(k) * (k + 1), n_points - 1};
  for (unsigned int v = 0; v < 4; ++v)
    for (unsigned int c = 0; c < 3; ++c)
      patch.vertices[v][c] = sample.points[3 * (first + corners[v]) + c];
  return patch;
}

std::string vtu_text(const SurfaceSample &sample)
{
  std::vector<SampledField> fields = {{"position", 3, sample.points}};
  for (const SampledField &field : sample.fields)
    if (field.name != "position")
      fields.push_back(field);

  std::vector<std::string> component_names;
  std::vector<VectorRange> vectors;
  for (const SampledField &field : fields)
  {
    PELLICLE_ASSERT(field.n_components == 1 || field.n_components == 3, "fields are scalars or vectors");
    PELLICLE_ASSERT(field.values.size() == sample.n_points() * field.n_components, "a value for every point");
    const unsigned int first = component_names.size();
    if (field.n_components == 3)
      vectors.emplace_back(first, first + 2, field.name, is_vector);
    component_names.insert(component_names.end(), field.n_components, field.name);
  }

  std::vector<Patch> patches;
  patches.reserve(sample.n_cells);
  for (std::size_t cell = 0; cell < sample.n_cells; ++cell)
    patches.push_back(make_patch(sample, fields, component_names.size(), cell));

  dealii::DataOutBase::VtkFlags flags;
  flags.write_higher_order_cells = true;
  flags.print_date_and_time      = false; // the same run gives the same file
  flags.compression_level        = dealii::DataOutBase::VtkFlags::best_speed;
  std::ostringstream out;
  dealii::DataOutBase::write_vtu(patches, component_names, vectors, flags, out);
  return out.str();
}
} // namespace

void write_vtu(const std::filesystem::path &path, const SurfaceSample &sample)
{
  PELLICLE_ASSERT(sample.degree >= 1, "cells of degree 1 or more");
  PELLICLE_ASSERT(sample.points.size() == 3 * sample.n_points(), "three coordinates for every point");
  write_whole_file(path, vtu_text(sample));
}

SolutionFiles::SolutionFiles(std::filesystem::path output_directory)
    : directory(std::move(output_directory))
{
}

std::filesystem::path SolutionFiles::write(const SurfaceSample &sample, const int step, const double time)
{
  std::ostringstream name;
  name << "solution_" << std::setw(4) << std::setfill('0') << step << ".vtu";
  const std::filesystem::path path = directory / name.str();
  write_vtu(path, sample);

  times_and_names.emplace_back(time, name.str());
  std::ostringstream index;
  index << std::setprecision(16);
  dealii::DataOutBase::write_pvd_record(index, times_and_names);
  write_whole_file(directory / "solution.pvd", index.str());
  return path;
}
} // namespace pellicle
