// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace pellicle
{
/** Version of the library, "major.minor.patch". */
const char *version();
} // namespace pellicle
