// SPDX-License-Identifier: LGPL-2.1-or-later
// Assertions on the messages that users read.
#pragma once

#include <pellicle/base/exceptions.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pellicle::test_messages
{
/** Expects a UserError whose message holds all the parts. */
template <typename Action>
void expect_refusal(const Action &action, const std::vector<std::string> &parts)
{
  try
  {
    action();
    ADD_FAILURE() << "nothing was refused; expected a message with '" << parts.front() << "'";
  }
  catch (const UserError &error)
  {
    const std::string message = error.what();
    for (const std::string &part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << "'" << part << "' is missing in: " << message;
  }
}

/** The message of the UserError that the action throws; empty when it throws none. */
template <typename Action>
std::string message_of(const Action &action)
{
  try
  {
    action();
  }
  catch (const UserError &error)
  {
    return error.what();
  }
  return "";
}
} // namespace pellicle::test_messages
