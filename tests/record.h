// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/observer.h>

#include <string>
#include <vector>

namespace pellicle::test
{
/** Collects the reports. */
class Record : public Observer
{
public:
  void on_iteration(const IterationReport &report) override { iterations.push_back(report); }
  void on_message(const std::string &text) override { messages.push_back(text); }
  std::vector<IterationReport> iterations;
  std::vector<std::string> messages;
};
} // namespace pellicle::test
