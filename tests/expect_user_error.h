// SPDX-License-Identifier: LGPL-2.1-or-later
// Assertions on the messages that users read.
#pragma once

#include <pellicle/base/exceptions.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pellicle::test
{
/** Expects a UserError whose message holds all the parts. */
template <typename Action>
void expect_user_error(const Action &action, const std::vector<std::string> &parts)
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
} // namespace pellicle::test

/** The same for a single call, which is named in a failure. */
#define EXPECT_USER_ERROR(call, ...)                                                                                   \
  {                                                                                                                    \
    SCOPED_TRACE(#call);                                                                                               \
    pellicle::test::expect_user_error([&]() { call; }, {__VA_ARGS__});                                                 \
  }
