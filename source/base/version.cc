// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/version.h>

namespace pellicle
{
const char *version()
{
  return PELLICLE_VERSION;
}
} // namespace pellicle
