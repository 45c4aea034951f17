// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exact_text.h>
#include <pellicle/base/exceptions.h>
#include <pellicle/solvers/ida_integrator.h>

#include <idas/idas.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>

#include <algorithm>
#include <exception>
#include <functional>
#include <string>
#include <utility>

namespace pellicle
{
namespace
{
constexpr long largest_number_of_steps = 100000; // from one output to the next

using Context = std::unique_ptr<_SUNContext, void (*)(SUNContext)>;
using Memory  = std::unique_ptr<void, void (*)(void *)>;
using Vector  = std::unique_ptr<_generic_N_Vector, void (*)(N_Vector)>;
using Matrix  = std::unique_ptr<_generic_SUNMatrix, void (*)(SUNMatrix)>;
using Linear  = std::unique_ptr<_generic_SUNLinearSolver, void (*)(SUNLinearSolver)>;

Context make_context()
{
  SUNContext context = nullptr;
  SUNContext_Create(nullptr, &context);
  return {context, [](SUNContext c) { SUNContext_Free(&c); }};
}

/** A view of a vector of ours. */
Vector view(std::vector<double> &values, SUNContext context)
{
  return {N_VMake_Serial(static_cast<sunindextype>(values.size()), values.data(), context), N_VDestroy};
}

void take(N_Vector from, std::vector<double> &to)
{
  std::copy_n(N_VGetArrayPointer(from), to.size(), to.begin());
}
} // namespace

/** The matrix and the linear solver that IDAS sees are empty shells: what they stand for is in this object. */
class IdaIntegrator::Implementation
{
public:
  Implementation(ImplicitSystem &dae, LinearSolver &linear_solver, const IdaTolerances &tolerances, const double time,
                 std::vector<double> start, const double first_time)
      : system(dae)
      , solver(linear_solver)
      , now(time)
      , y(std::move(start))
      , rate(y.size(), 0.)
      , point(y.size())
      , point_rate(y.size())
      , right(y.size())
      , y_view(view(y, context.get()))
      , rate_view(view(rate, context.get()))
      , work_view(view(work, context.get()))
  {
    std::vector<double> differential;
    for (const bool is_differential : system.is_differential())
      differential.push_back(is_differential ? 1. : 0.);
    const Vector id = view(differential, context.get());
    make_shells();
    void *const ida = memory.get();
    IDASetErrHandlerFn(ida, on_error, this);
    IDAInit(ida, residual, now, y_view.get(), rate_view.get());
    IDASetUserData(ida, this);
    IDASStolerances(ida, tolerances.relative, tolerances.absolute);
    IDASetMaxNumSteps(ida, largest_number_of_steps);
    IDASetId(ida, id.get());
    IDASetLinearSolver(ida, linear_shell.get(), matrix_shell.get());
    IDASetJacFn(ida, jacobian);
    // Energies are quadratic in what is small, so their absolute tolerance is smaller.
    IDAQuadInit(ida, power, work_view.get());
    IDAQuadSStolerances(ida, tolerances.relative, tolerances.relative * tolerances.absolute);
    IDASetQuadErrCon(ida, SUNTRUE);
    if (IDACalcIC(ida, IDA_YA_YDP_INIT, first_time) < 0)
      fail("found no consistent start");
    IDAGetConsistentIC(ida, y_view.get(), rate_view.get());
    // Anew: the power at the start was taken with the rates as they were before.
    IDAReInit(ida, now, y_view.get(), rate_view.get());
    IDAQuadReInit(ida, work_view.get());
  }

  void advance(const double time)
  {
    double reached = now;
    const int flag = IDASolve(memory.get(), time, &reached, y_view.get(), rate_view.get(), IDA_NORMAL);
    now            = reached;
    if (flag < 0)
      fail("stopped at time " + exact_text(now));
    IDAGetQuad(memory.get(), &reached, work_view.get());
  }

  IdaStatistics statistics() const
  {
    long steps = 0, residuals = 0, setups = 0;
    IdaStatistics result;
    IDAGetNumSteps(memory.get(), &steps);
    IDAGetNumResEvals(memory.get(), &residuals);
    IDAGetNumLinSolvSetups(memory.get(), &setups);
    IDAGetLastOrder(memory.get(), &result.last_order);
    IDAGetLastStep(memory.get(), &result.last_step);
    result.steps          = static_cast<int>(steps);
    result.residuals      = static_cast<int>(residuals);
    result.factorisations = static_cast<int>(setups);
    return result;
  }

private:
  ImplicitSystem &system;
  LinearSolver &solver;
  const SparseMatrix *tangent = nullptr;
  std::string message;
  std::exception_ptr unexpected; ///< C code cannot let exceptions pass
  Context context = make_context();

public:
  double now;
  std::vector<double> y, rate, work{0.};

private:
  std::vector<double> point, point_rate, right;
  Vector y_view, rate_view, work_view;
  Matrix matrix_shell{nullptr, SUNMatFreeEmpty};
  Linear linear_shell{nullptr, SUNLinSolFreeEmpty};
  Memory memory{IDACreate(context.get()), [](void *m) { IDAFree(&m); }};

  [[noreturn]] void fail(const std::string &what)
  {
    if (unexpected)
      std::rethrow_exception(unexpected);
    throw SolveError("The integrator ida " + what + (message.empty() ? "." : ": " + message));
  }

  void make_shells()
  {
    matrix_shell.reset(SUNMatNewEmpty(context.get()));
    matrix_shell->ops->getid = [](SUNMatrix) { return SUNMATRIX_CUSTOM; };
    matrix_shell->ops->zero  = [](SUNMatrix) { return 0; };
    linear_shell.reset(SUNLinSolNewEmpty(context.get()));
    linear_shell->content      = this;
    linear_shell->ops->gettype = [](SUNLinearSolver) { return SUNLINEARSOLVER_DIRECT; };
    linear_shell->ops->setup   = factorize;
    linear_shell->ops->solve   = solve;
  }

  /** Calls f for C code: 0, 1 for a failure that a shorter step may cure, -1 for any other. */
  int guarded(const std::function<void()> &f)
  {
    try
    {
      f();
      return 0;
    }
    catch (const SolveError &error)
    {
      message = error.what();
      return 1;
    }
    catch (...)
    {
      unexpected = std::current_exception();
      return -1;
    }
  }

  static Implementation &self(void *data) { return *static_cast<Implementation *>(data); }

  static int residual(const double t, N_Vector yy, N_Vector yp, N_Vector result, void *data)
  {
    Implementation &me = self(data);
    return me.guarded(
        [&]
        {
          take(yy, me.point);
          take(yp, me.point_rate);
          me.system.residual(t, me.point, me.point_rate, me.right);
          std::copy(me.right.begin(), me.right.end(), N_VGetArrayPointer(result));
        });
  }

  static int jacobian(const double t, const double alpha, N_Vector yy, N_Vector yp, N_Vector, SUNMatrix, void *data,
                      N_Vector, N_Vector, N_Vector)
  {
    Implementation &me = self(data);
    return me.guarded(
        [&]
        {
          take(yy, me.point);
          take(yp, me.point_rate);
          me.tangent = &me.system.tangent(t, me.point, me.point_rate, alpha);
        });
  }

  static int power(const double, N_Vector yy, N_Vector yp, N_Vector result, void *data)
  {
    Implementation &me = self(data);
    return me.guarded(
        [&]
        {
          take(yy, me.point);
          take(yp, me.point_rate);
          N_VGetArrayPointer(result)[0] = me.system.dissipated_power(me.point, me.point_rate);
        });
  }

  static int factorize(SUNLinearSolver shell, SUNMatrix)
  {
    Implementation &me = self(shell->content);
    return me.guarded([&] { me.solver.factorize(*me.tangent); });
  }

  static int solve(SUNLinearSolver shell, SUNMatrix, N_Vector x, N_Vector b, double)
  {
    Implementation &me = self(shell->content);
    return me.guarded(
        [&]
        {
          take(b, me.right);
          me.solver.solve(me.right);
          std::copy(me.right.begin(), me.right.end(), N_VGetArrayPointer(x));
        });
  }

  static void on_error(const int code, const char *, const char *, char *text, void *data)
  {
    if (code < 0)
      self(data).message = text;
  }
};

IdaIntegrator::IdaIntegrator(ImplicitSystem &system, LinearSolver &solver, const IdaTolerances &tolerances,
                             const double time, std::vector<double> y, const double first_time)
    : implementation(std::make_unique<Implementation>(system, solver, tolerances, time, std::move(y), first_time))
{
}

IdaIntegrator::~IdaIntegrator() = default;

void IdaIntegrator::advance(const double time)
{
  implementation->advance(time);
}

double IdaIntegrator::time() const
{
  return implementation->now;
}

const std::vector<double> &IdaIntegrator::y() const
{
  return implementation->y;
}

const std::vector<double> &IdaIntegrator::rate() const
{
  return implementation->rate;
}

double IdaIntegrator::dissipated() const
{
  return implementation->work[0];
}

IdaStatistics IdaIntegrator::statistics() const
{
  return implementation->statistics();
}
} // namespace pellicle
