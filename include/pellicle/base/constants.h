// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace pellicle
{
constexpr double pi = 3.14159265358979323846;
} // namespace pellicle
