// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/observer.h>

#include <utility>
#include <vector>

namespace pellicle
{
/** Passes every report on to several observers, in order. They must outlive the list. */
class ObserverList : public Observer
{
public:
  explicit ObserverList(std::vector<Observer *> list)
      : observers(std::move(list))
  {
  }

  void on_iteration(const IterationReport &report) override
  {
    for (Observer *observer : observers)
      observer->on_iteration(report);
  }
  void on_step(const StepReport &report) override
  {
    for (Observer *observer : observers)
      observer->on_step(report);
  }
  void on_row(const TableRow &row) override
  {
    for (Observer *observer : observers)
      observer->on_row(row);
  }
  void on_message(const std::string &text) override
  {
    for (Observer *observer : observers)
      observer->on_message(text);
  }

private:
  std::vector<Observer *> observers;
};
} // namespace pellicle
