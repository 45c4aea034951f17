// SPDX-License-Identifier: LGPL-2.1-or-later
// One text as a number, as a list of numbers and as a function of place.
#include "targets.h"

#include <pellicle/base/expression.h>
#include <pellicle/base/expression_of_place.h>
#include <pellicle/base/parameter_text.h>

#include <cmath>

namespace pellicle::fuzz
{
namespace
{
template <typename Action>
void unless_refused(const Action &action)
{
  try
  {
    action();
  }
  catch (const UserError &)
  {
  }
}
} // namespace

void read_expression(const std::string &input)
{
  unless_refused(
      [&]
      {
        if (std::isnan(evaluate_number(input)))
          throw std::logic_error("nan is no number");
      });
  unless_refused(
      [&]
      {
        std::vector<double> values;
        ParameterSection section("Section");
        section.numbers("Values", values, Range::any().or_infinite(), dimensions::none, "");
        assign_text(section.entries().front(), input);
        const std::vector<double> first = values;
        assign_text(section.entries().front(), value_text(section.entries().front()));
        if (values != first)
          throw std::logic_error("the written list is read as another one");
      });
  ExpressionOfPlace(input).at(0.3, -0.4);
}
} // namespace pellicle::fuzz
