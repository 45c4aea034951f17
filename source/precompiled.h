// SPDX-License-Identifier: LGPL-2.1-or-later
// The fat headers that several files of the rooms right of `potentials` share.
#pragma once

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/dofs/dof_handler.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/tria.h>

#include <Eigen/Sparse>
#include <nlohmann/json.hpp>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>
