// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <pellicle/base/exceptions.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace pellicle
{
/** The call throws UserError, and its message holds every one of the given parts. */
inline void expect_user_error(const std::function<void()> &call, const std::vector<std::string> &parts)
{
  try
  {
    call();
    ADD_FAILURE() << "nothing was thrown";
  }
  catch (const UserError &error)
  {
    const std::string message = error.what();
    for (const std::string &part : parts)
      EXPECT_NE(message.find(part), std::string::npos) << "message: " << message << "\nlacks:   " << part;
  }
}
} // namespace pellicle

#define EXPECT_USER_ERROR(call, ...)                                                                                   \
  {                                                                                                                    \
    SCOPED_TRACE(#call);                                                                                               \
    pellicle::expect_user_error([&]() { call; }, {__VA_ARGS__});                                                       \
  }
