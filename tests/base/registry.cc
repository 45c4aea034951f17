// SPDX-License-Identifier: LGPL-2.1-or-later
#include "expect_user_error.h"

#include <pellicle/base/registry.h>

using namespace pellicle;
using pellicle::test::expect_user_error;

namespace
{
struct Shape
{
  virtual ~Shape()            = default;
  virtual double area() const = 0;
};

struct Square : Shape
{
  explicit Square(const double a)
      : side(a)
  {
  }
  double area() const override { return side * side; }
  double side;
};

struct Diamond : Shape
{
  explicit Diamond(const double a)
      : diagonal(a)
  {
  }
  double area() const override { return diagonal * diagonal / 2.; }
  double diagonal;
};

Registry<Shape, double> shapes()
{
  Registry<Shape, double> registry("shape");
  registry.add("square", [](const double a) { return std::make_unique<Square>(a); });
  registry.add("diamond", [](const double a) { return std::make_unique<Diamond>(a); });
  return registry;
}
} // namespace

TEST(Registry, CreatesByName)
{
  EXPECT_EQ(shapes().create("square", 3.)->area(), 9.);
  EXPECT_EQ(shapes().create("diamond", 3.)->area(), 4.5);
}

TEST(Registry, KeepsTheOrder)
{
  EXPECT_EQ(shapes().names(), (std::vector<std::string>{"square", "diamond"}));
  EXPECT_TRUE(shapes().contains("diamond"));
  EXPECT_FALSE(shapes().contains("Diamond"));
}

TEST(Registry, UnknownNameListsNearMatches)
{
  expect_user_error([] { shapes().create("dimond", 1.); }, {"no shape 'dimond'", "Did you mean 'diamond'?"});
  expect_user_error([] { shapes().create("xyzuvw", 1.); }, {"no shape 'xyzuvw'", "Possible: 'square', 'diamond'."});
}

TEST(Registry, ArgumentsMayBeReferences)
{
  Registry<int, int &> registry("counter");
  registry.add("next", [](int &count) { return std::make_unique<int>(++count); });
  int count = 4;
  EXPECT_EQ(*registry.create("next", count), 5);
  EXPECT_EQ(count, 5);
}
