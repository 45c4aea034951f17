// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace pellicle
{
/** The user's input cannot be used: exit status 2. The message holds the value, the allowed range and what to do. */
class UserError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/** A solve did not reach its goal: exit status 1. The message names what failed and what to try. */
class SolveError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
} // namespace pellicle

/**
 * Our own mistakes (preconditions, index ranges), checked in Debug builds only. Users' mistakes are exceptions, in
 * every build.
 */
#ifdef NDEBUG
#define PELLICLE_ASSERT(condition, message) ((void)0)
#else
#define PELLICLE_ASSERT(condition, message)                                                                            \
  ((condition) ? (void)0                                                                                               \
               : (std::fprintf(stderr, "%s:%d: assertion failed: %s: %s\n", __FILE__, __LINE__, #condition, message),  \
                  std::abort()))
#endif
