// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
/**
 * Watches the poles of closed surfaces, which come together first where a vesicle gets flat or a cup deep. Membranes do
 * not feel each other: what is found with poles in contact, or beyond, is a solution of the equations, but no vesicle.
 */
class SelfContactWatch
{
public:
  /**
   * What is wrong with a shape, in words, when it is worse than before: poles nearer to each other than 0.05
   * sqrt(A/4 pi), or membranes that have gone through each other (negative axis_thickness).
   *
   * @param quantities  reported ones: area, axis_thickness.
   * @param place       where on a load path, for example "Vesicle/Reduced volume = 0.51"; empty: nowhere in particular.
   */
  std::optional<std::string> look(const std::vector<std::pair<std::string, double>> &quantities,
                                  const std::string &place);

private:
  enum class Contact
  {
    none,
    near,
    through
  };
  Contact worst = Contact::none;
};
} // namespace pellicle
