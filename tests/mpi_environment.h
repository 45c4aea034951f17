// SPDX-License-Identifier: LGPL-2.1-or-later
// Starts MPI for the tests of an executable that solve something (MUMPS needs it); include it in one or more of its
// sources.
#pragma once

#include <gtest/gtest.h>
#include <mpi.h>

namespace pellicle::test
{
class MpiEnvironment : public testing::Environment
{
public:
  void SetUp() override { MPI_Init(nullptr, nullptr); }
  void TearDown() override { MPI_Finalize(); }
};

inline testing::Environment *const mpi_environment = testing::AddGlobalTestEnvironment(new MpiEnvironment);
} // namespace pellicle::test
