// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/models/surface_model.h>

#include <iosfwd>

namespace pellicle
{
/**
 * What --validate prints of a scene that has been built: effects with their descriptions, mesh, fields, the loops over
 * cells with all terms and the fields that they read, the reported quantities of the start shape (all digits), and the
 * seconds that it took.
 */
void write_validation_report(const SurfaceScene &scene, const SurfaceModel &model, const Timing &timing,
                             std::ostream &out);
} // namespace pellicle
