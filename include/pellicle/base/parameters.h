// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/exceptions.h>
#include <pellicle/base/scales.h>

#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pellicle
{
/** Closed or open interval of allowed numbers. */
struct Range
{
  double lower    = -std::numeric_limits<double>::infinity();
  double upper    = std::numeric_limits<double>::infinity();
  bool lower_open = false; ///< value > lower instead of >=
  bool upper_open = false;
  bool allow_inf  = false; ///< "inf" is a meaningful value

  static Range any() { return {}; }
  static Range positive() { return {0., std::numeric_limits<double>::infinity(), true, false, false}; }
  static Range non_negative() { return {0., std::numeric_limits<double>::infinity(), false, false, false}; }
  static Range between(const double a, const double b) { return {a, b, false, false, false}; }
  /** The same range, where "inf" may stand as well. */
  Range or_infinite() const
  {
    Range r     = *this;
    r.allow_inf = true;
    return r;
  }

  /** True for every number inside; never for nan; for an infinite number only with allow_inf. */
  bool contains(double value) const;
  /** Text for messages and the manual: "a number > 0", "a number in [0, 1]", "a number >= 0 or inf". */
  std::string text() const;
};

/**
 * One section of a scene, seen from a plain struct of parameters: every member is bound once to its name, range,
 * dimension and text. Declaring, reading, scaling, writing and the manual's parameter chapter all follow from the same
 * binding:
 *
 *     struct SurfaceTensionParameters
 *     {
 *       double tension = 1.;
 *       void bind(ParameterSection &section)
 *       {
 *         section.number("Surface tension", tension, Range::any(), dimensions::tension,
 *                        "Prescribed surface tension sigma in E = sigma A. Positive: the surface wants to shrink.");
 *       }
 *     };
 *
 * The section keeps references to the members: it must not outlive them. The value a member has while it is bound is
 * its default.
 */
class ParameterSection
{
public:
  /** One bound member. */
  struct Entry
  {
    std::string name;
    std::string text;
    std::variant<double *, int *, bool *, std::string *, std::vector<double> *> target;
    Range range;                      // numbers and integers
    Dimension dimension;              // numbers
    std::vector<std::string> choices; // texts; empty: free text
  };

  explicit ParameterSection(std::string name)
      : section_name(std::move(name))
  {
  }

  /** A real number; in scenes an expression such as `4*pi` may stand for it. */
  void number(const std::string &name, double &target, const Range &range, Dimension dimension,
              const std::string &text);
  /** A whole number in [lower, upper]. */
  void integer(const std::string &name, int &target, int lower, int upper, const std::string &text);
  /** true or false. */
  void flag(const std::string &name, bool &target, const std::string &text);
  /** Free text, for example a file name. */
  void word(const std::string &name, std::string &target, const std::string &text);
  /** One of the given words. */
  void choice(const std::string &name, std::string &target, std::vector<std::string> choices, const std::string &text);
  /** Comma-separated real numbers. */
  void numbers(const std::string &name, std::vector<double> &target, const Range &range, Dimension dimension,
               const std::string &text);

  const std::string &name() const { return section_name; }
  const std::vector<Entry> &entries() const { return bound; }

private:
  std::string section_name;
  std::vector<Entry> bound;
};

/** Divides every number of a parameter struct by its scale: the values that the model computes with. */
void scale_entries(const ParameterSection &section, const Scales &scales);

/** Copy of a parameter struct in internal units. `Parameters` has `void bind(ParameterSection &)`. */
template <typename Parameters>
Parameters scaled(Parameters parameters, const Scales &scales)
{
  ParameterSection section("");
  parameters.bind(section);
  scale_entries(section, scales);
  return parameters;
}
} // namespace pellicle
