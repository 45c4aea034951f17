// SPDX-License-Identifier: LGPL-2.1-or-later
#include "expression_symbols.h"

#include <pellicle/base/constants.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/base/expression_of_place.h>
#include <pellicle/base/text.h>

#include <muParser.h>

#include <cmath>
#include <sstream>
#include <vector>

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

constexpr std::size_t longest_list = 20000; // muParser takes no longer text

/** Numbers, names and operations in an expression, as far as they are no more than `most`. */
std::size_t n_parts(const GiNaC::ex &f, const std::size_t most)
{
  std::size_t n = 1;
  for (std::size_t i = 0; i < f.nops() && n <= most; ++i)
    n += n_parts(f.op(i), most - n);
  return n;
}

/** Functions of place one after the other, as a list with commas, the constants in full precision. */
class List
{
public:
  explicit List(const std::string &text)
      : of(text)
  {
    list << GiNaC::csrc_double;
  }

  /** Derivatives of nested functions and of long products grow fast: parts are counted before they are written. */
  void append(const GiNaC::ex &f)
  {
    if (n_parts(f, longest_list) <= longest_list)
      list << (list.tellp() > 0 ? "," : "") << f;
    if (n_parts(f, longest_list) > longest_list || static_cast<std::size_t>(list.tellp()) > longest_list)
      throw UserError("'" + excerpt(of) +
                      "' has derivatives up to the third order that are too long to be evaluated (more than " +
                      std::to_string(longest_list) + " characters): use fewer terms, factors or nested functions");
  }

  std::string text() const { return list.str(); }

private:
  std::string of;
  std::ostringstream list;
};

/** f and its derivatives in the order of PlaceSample. */
std::string list_of_derivatives(const std::string &text, const std::array<GiNaC::realsymbol, 2> &variables)
{
  List list(text);
  std::vector<GiNaC::ex> derivatives{read_expression(text, variables)};
  list.append(derivatives.front());
  for (unsigned int order = 1; order <= 3; ++order)
  {
    const std::vector<GiNaC::ex> lower = derivatives;
    derivatives                        = {lower.front().diff(variables[0])};
    for (const GiNaC::ex &f : lower)
      derivatives.push_back(f.diff(variables[1]));
    for (const GiNaC::ex &f : derivatives)
      list.append(f);
  }
  return list.text();
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
  const std::string beginning =
      "'" + excerpt(expression) + "' is not a function of " + variables[0] + " and " + variables[1];
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
  PELLICLE_ASSERT(n_values == 10, "value and derivatives");
  const double zeroth = 1. / unit_of_value, first = zeroth * unit_of_place, second = first * unit_of_place,
               third = second * unit_of_place;
  return {zeroth * f[0], first * f[1], first * f[2], second * f[3], second * f[4],
          second * f[5], third * f[6], third * f[7], third * f[8],  third * f[9]};
}
} // namespace pellicle
