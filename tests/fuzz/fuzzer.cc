// SPDX-License-Identifier: LGPL-2.1-or-later
// The entry of libFuzzer; PELLICLE_FUZZ_READER is the reader that it feeds.
#include "targets.h"

#include <cstddef>
#include <cstdint>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
  pellicle::fuzz::run(pellicle::fuzz::PELLICLE_FUZZ_READER, std::string(reinterpret_cast<const char *>(data), size));
  return 0;
}
