// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <string>

namespace pellicle
{
/**
 * A short decimal text that reads back as exactly the same number: 15 significant digits where
 * they suffice, else 16 or 17. Infinities are "inf" and "-inf". Does not depend on the locale.
 */
std::string exact_text(double value);
} // namespace pellicle
