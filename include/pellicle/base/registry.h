// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/exceptions.h>
#include <pellicle/base/near_match.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace pellicle
{
/**
 * Readable list of named things that can be made, in the order in which they were added. A registry is an ordinary
 * object that one function fills; nothing registers itself before main.
 *
 *     Registry<Shape, double> shapes("shape");
 *     shapes.add("sphere", [](const double radius) { return std::make_unique<Sphere>(radius); });
 *     std::unique_ptr<Shape> shape = shapes.create("sphere", 2.);
 */
template <typename Product, typename... Args>
class Registry
{
public:
  using Factory = std::function<std::unique_ptr<Product>(Args...)>;

  /** `kind` says in messages what is listed: "effect". */
  explicit Registry(std::string kind)
      : product_kind(std::move(kind))
  {
  }

  /** Every name is added once. */
  void add(const std::string &name, Factory factory)
  {
    PELLICLE_ASSERT(!contains(name), "a name is registered once");
    factories.emplace_back(name, std::move(factory));
  }

  bool contains(const std::string &name) const { return find(name) != factories.end(); }

  /** What the factory of that name makes. Throws UserError with near matches when there is none. */
  std::unique_ptr<Product> create(const std::string &name, Args... args) const
  {
    const auto found = find(name);
    if (found == factories.end())
      throw UserError("There is no " + product_kind + " '" + name + "'." + suggestion(name, names()));
    return found->second(std::forward<Args>(args)...);
  }

  std::vector<std::string> names() const
  {
    std::vector<std::string> all;
    for (const auto &named : factories)
      all.push_back(named.first);
    return all;
  }

private:
  auto find(const std::string &name) const
  {
    return std::find_if(factories.begin(), factories.end(), [&](const auto &named) { return named.first == name; });
  }

  std::string product_kind;
  std::vector<std::pair<std::string, Factory>> factories;
};
} // namespace pellicle
