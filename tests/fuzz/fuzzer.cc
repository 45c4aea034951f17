// SPDX-License-Identifier: LGPL-2.1-or-later
// The entry of libFuzzer; PELLICLE_FUZZ_TARGET is the name of the target.
#include "targets.h"

#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace
{
const pellicle::fuzz::Target &own_target()
{
  for (const pellicle::fuzz::Target &target : pellicle::fuzz::targets())
    if (target.name == PELLICLE_FUZZ_TARGET)
      return target;
  throw std::logic_error("no target " PELLICLE_FUZZ_TARGET);
}
} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  static const pellicle::fuzz::Target &target = own_target();
  run(target, std::string(reinterpret_cast<const char *>(data), size));
  return 0;
}
