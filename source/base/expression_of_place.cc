// SPDX-License-Identifier: LGPL-2.1-or-later
#include "expression_symbols.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/base/expression_of_place.h>
#include <pellicle/base/text.h>

#include <muParser.h>

#include <cmath>
#include <sstream>

namespace pellicle
{
namespace
{
double direction(const double u)
{
  return u / std::abs(u); // nan at 0
}

double magnitude(const double u)
{
  return std::abs(u);
}

double power(const double base, const double exponent)
{
  return std::pow(base, exponent);
}

/** f, f_x, f_y, f_xx, f_xy, f_yy as a list with commas, the constants in full precision. */
std::string list_of_derivatives(const std::string &text, const std::array<GiNaC::realsymbol, 2> &variables)
{
  const GiNaC::ex f = read_expression(text, variables), f_x = f.diff(variables[0]), f_y = f.diff(variables[1]);
  std::ostringstream list;
  list << GiNaC::csrc_double << f << "," << f_x << "," << f_y << "," << f_x.diff(variables[0]) << ","
       << f_x.diff(variables[1]) << "," << f_y.diff(variables[1]);
  return list.str();
}
} // namespace

// GiNaC differentiates, muParser evaluates: its byte code is faster by far than substitution into a GiNaC expression.
struct ExpressionOfPlace::Evaluator
{
  double x = 0., y = 0.;
  mu::Parser parser;

  Evaluator(const std::string &list, const std::array<std::string, 2> &variables)
  {
    parser.DefineVar(variables[0], &x);
    parser.DefineVar(variables[1], &y);
    parser.DefineConst("Pi", pi);
    parser.DefineFun("pow", power);
    parser.DefineFun("magnitude", magnitude);
    parser.DefineFun("direction", direction);
    parser.SetExpr(list);
    parser.Eval();
  }
};

ExpressionOfPlace::ExpressionOfPlace(const std::string &text, const double unit_of_place, const double unit_of_value,
                                     const std::array<std::string, 2> &variables)
    : expression(trimmed(text))
    , unit_of_place(unit_of_place)
    , unit_of_value(unit_of_value)
{
  const std::string beginning = "'" + expression + "' is not a function of " + variables[0] + " and " + variables[1];
  try
  {
    evaluator = std::make_unique<Evaluator>(
        list_of_derivatives(expression, {GiNaC::realsymbol(variables[0]), GiNaC::realsymbol(variables[1])}), variables);
  }
  catch (const UserError &)
  {
    throw;
  }
  catch (const mu::Parser::exception_type &) // complex constants and those beyond double precision have no syntax there
  {
    throw UserError(beginning + ": a constant in it is not real or too large");
  }
  catch (const std::exception &) // poles, e.g. of 1/0 and ln(0)
  {
    throw UserError(beginning + ": it has no finite value or derivative anywhere, as with a division by 0");
  }
}

ExpressionOfPlace::~ExpressionOfPlace() = default;

PlaceSample ExpressionOfPlace::at(const double x, const double y) const
{
  evaluator->x          = unit_of_place * x;
  evaluator->y          = unit_of_place * y;
  int n_values          = 0;
  const double *const f = evaluator->parser.Eval(n_values);
  PELLICLE_ASSERT(n_values == 6, "value and derivatives");
  const double zeroth = 1. / unit_of_value, first = zeroth * unit_of_place, second = first * unit_of_place;
  return {zeroth * f[0], first * f[1], first * f[2], second * f[3], second * f[4], second * f[5]};
}
} // namespace pellicle
