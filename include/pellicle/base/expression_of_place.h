// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/function_of_place.h>

#include <array>
#include <memory>
#include <string>

namespace pellicle
{
/**
 * A function of place that a scene gives as text, such as `0.1*sin(2*pi*x)*cos(y)`, with symbolic derivatives.
 *
 * The text holds numbers, + - * / ^ (from the right: a^b^c is a^(b^c)), parentheses, pi, the two variables and the
 * functions sqrt exp ln log (both natural) log10 log2 sin cos tan asin acos atan atan2 sinh cosh tanh asinh acosh atanh
 * abs: those of evaluate_number() that can be differentiated. The derivatives of abs are nan where its argument is 0.
 *
 * The user's function F takes and gives quantities in the user's units; inside, places are divided by `unit_of_place`
 * and values by `unit_of_value`:
 *
 *     f(x, y) = F(x unit_of_place, y unit_of_place) / unit_of_value,
 *
 * and the derivatives are those of f. A height has the scene's length for both, a dimensionless function 1 for the
 * second.
 */
class ExpressionOfPlace : public FunctionOfPlace
{
public:
  /** Throws UserError, naming the text, what is not understood in it and what is allowed. */
  explicit ExpressionOfPlace(const std::string &text, double unit_of_place = 1., double unit_of_value = 1.,
                             const std::array<std::string, 2> &variables = {"x", "y"});
  ~ExpressionOfPlace() override;

  /** Not to be called for one object by several threads at once. */
  PlaceSample at(double x, double y) const override;
  const std::string &text() const override { return expression; }

private:
  struct Evaluator;
  std::string expression;
  double unit_of_place, unit_of_value;
  std::unique_ptr<Evaluator> evaluator;
};
} // namespace pellicle
