// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>

#include <array>
#include <charconv>

namespace pellicle
{
std::string exact_text(const double value)
{
  std::array<char, 40> buffer;
  std::string text;
  for (const int digits : {15, 16, 17}) // 17 digits identify every double
  {
    const auto written =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, digits);
    text        = std::string(buffer.data(), written.ptr);
    double back = 0.;
    std::from_chars(buffer.data(), written.ptr, back);
    if (back == value)
      break;
  }
  return text;
}
} // namespace pellicle
