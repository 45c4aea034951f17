// SPDX-License-Identifier: LGPL-2.1-or-later
#include <pellicle/base/exceptions.h>
#include <pellicle/solvers/eigenvalues.h>

#include "lanczos.h"
#include "shifted_pencil.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <utility>

namespace pellicle
{
namespace
{
constexpr int n_lowerings      = 13;  // tenfold each: from scale to 10^12 scale
constexpr int n_approaches     = 8;   // of the shift to the spectrum
constexpr int hasty_restarts   = 3;   // of Lanczos' method before the shift is moved nearer
constexpr int patient_restarts = 300; // when it is not moved any more
// Eigenvalues whose distances from the shift differ by more have inverses that differ by digits ARPACK should not lose.
constexpr double largest_spread = 1e4;

std::string as_text(const double value)
{
  std::ostringstream text;
  text << value;
  return text.str();
}

class LowestEigenpairs
{
public:
  LowestEigenpairs(const SparseMatrix &K, const SparseMatrix &M, LinearSolver &linear_solver, const int n_expected,
                   const int n)
      : pencil(K, M)
      , solver(linear_solver)
      , n_expected_negative(n_expected)
      , n_wanted(n)
  {
  }

  Eigenpairs compute(const double scale)
  {
    go_below_spectrum(scale);
    find();
    find_missing();
    for (std::size_t i = 0; i < found.values.size(); ++i)
      if (const double residual = pencil.relative_residual(found.values[i], found.vectors[i]);
          !(residual <= eigenpair_tolerance))
        throw SolveError("Eigenvalue " + std::to_string(i + 1) + " (" + as_text(found.values[i]) +
                         ") has the relative residual " + as_text(residual) + ", more than " +
                         as_text(eigenpair_tolerance) + ": the matrix is too badly conditioned.");
    return std::move(found);
  }

private:
  /** Factorises at s and counts the eigenvalues below; none where s is an eigenvalue to working precision. */
  std::optional<int> count_below(const double s)
  {
    factorised_at = s;
    ++found.n_factorizations;
    try
    {
      solver.factorize(pencil.at(s));
    }
    catch (const SolveError &error)
    {
      const std::optional<Inertia> inertia = solver.inertia();
      if (!inertia || inertia->zero == 0)
        throw;
      singular = error.what();
      return std::nullopt;
    }
    const std::optional<Inertia> inertia = solver.inertia();
    if (!inertia)
      throw SolveError("The linear solver '" + solver.name() +
                       "' does not count negative pivots: without them nobody knows whether the eigenvalues found are "
                       "the lowest. Use 'mumps' (Newton/Linear solver).");
    const int count = inertia->negative - n_expected_negative;
    if (count < 0)
      throw SolveError("The matrix has " + std::to_string(inertia->negative) +
                       " negative eigenvalues, fewer than the " + std::to_string(n_expected_negative) +
                       " of internal fields, constraints and gauge rows.");
    return count;
  }

  void go_below_spectrum(const double scale)
  {
    std::optional<int> count;
    shift = -scale;
    for (int k = 0; k < n_lowerings; ++k, shift *= 10.)
      if (count = count_below(shift); count == 0)
        return;
    if (!count)
      throw SolveError(singular);
    throw SolveError("No shift lies below all eigenvalues: " + std::to_string(*count) + " are below " +
                     as_text(0.1 * shift) +
                     ". Either internal fields, constraints and gauge rows contribute more negative eigenvalues than " +
                     std::to_string(n_expected_negative) + ", or unknowns without mass are unstable.");
  }

  /** Lanczos' method about the present shift, in the M-orthogonal complement of the vectors found already. */
  internal::LanczosResult lanczos(const int n, const int max_restarts)
  {
    if (factorised_at != shift && count_below(shift) != 0)
      throw SolveError("The inertia at the shift " + as_text(shift) +
                       " is lost in round-off: the matrix is too badly conditioned.");
    internal::LanczosOperator map;
    map.size           = pencil.size();
    map.n_eigenvectors = pencil.n_massive() - int(found.vectors.size());
    map.mass           = [&](const double *x, double *result) { pencil.apply_mass(x, result); };
    std::vector<std::vector<double>> dual(found.vectors.size(), std::vector<double>(pencil.size()));
    for (std::size_t i = 0; i < dual.size(); ++i)
      pencil.apply_mass(found.vectors[i].data(), dual[i].data());
    map.solve = [&](std::vector<double> &b)
    {
      ++found.n_solves;
      solver.solve(b);
      for (std::size_t i = 0; i < dual.size(); ++i)
      {
        const double component = std::inner_product(b.begin(), b.end(), dual[i].begin(), 0.);
        for (std::size_t k = 0; k < b.size(); ++k)
          b[k] -= component * found.vectors[i][k];
      }
    };
    return internal::lanczos(map, n, max_restarts);
  }

  double eigenvalue(const double inverse_distance) const { return shift + 1. / inverse_distance; }

  /** The wanted number of eigenpairs, after moving the shift to where Lanczos' method gets them fast and exactly. */
  void find()
  {
    for (int k = 0; k < n_approaches; ++k)
    {
      const internal::LanczosResult result = lanczos(n_wanted, hasty_restarts);
      const double nearest                 = eigenvalue(result.values.front());
      if (!result.converged)
      {
        if (!move_towards(nearest))
          break;
        continue;
      }
      const double farthest = eigenvalue(result.values[n_wanted - 1]);
      if (farthest - shift <= largest_spread * (nearest - shift))
      {
        keep(result);
        return;
      }
      shift = nearest - (farthest - nearest);
    }
    const internal::LanczosResult result = lanczos(n_wanted, patient_restarts);
    if (!result.converged)
      throw SolveError("The " + std::to_string(n_wanted) +
                       " lowest eigenvalues are not found: Lanczos' method does not converge about the shift " +
                       as_text(shift) + ". Ask for fewer or for more: the last one may be one of a crowd.");
    keep(result);
  }

  /** Moves the shift up, nearly to a Ritz value (never below the lowest eigenvalue). */
  bool move_towards(const double ritz_value)
  {
    for (const double way : {0.99, 0.9, 0.5})
      if (const double s = shift + way * (ritz_value - shift); count_below(s) == 0)
      {
        shift = s;
        return true;
      }
    return false;
  }

  /** Adds eigenpairs to those found, ascending, and drops what is not wanted. */
  void keep(const internal::LanczosResult &result)
  {
    std::vector<std::pair<double, std::vector<double>>> all;
    for (std::size_t i = 0; i < found.values.size(); ++i)
      all.emplace_back(found.values[i], std::move(found.vectors[i]));
    for (std::size_t i = 0; i < result.vectors.size(); ++i)
      all.emplace_back(eigenvalue(result.values[i]), result.vectors[i]);
    std::stable_sort(all.begin(), all.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
    all.resize(n_wanted);
    found.values.clear();
    found.vectors.clear();
    for (auto &[value, vector] : all)
    {
      found.values.push_back(value);
      found.vectors.push_back(std::move(vector));
    }
  }

  /** Lanczos' method knows multiple eigenvalues by round-off only; the inertia knows them all. */
  void find_missing()
  {
    for (int k = 0; k < n_wanted; ++k)
    {
      const int n_missing = count_missing();
      if (n_missing == 0)
        return;
      if (n_missing < 0)
        throw SolveError("Lanczos' method finds more eigenvalues below " + as_text(found.values.back()) +
                         " than the inertia says there are: the matrix is too badly conditioned.");
      const auto result = lanczos(n_missing, patient_restarts);
      if (!result.converged)
        break;
      keep(result);
    }
    throw SolveError("There are eigenvalues below " + as_text(found.values.back()) +
                     " that Lanczos' method does not find.");
  }

  /** Eigenvalues just below the largest one found, less those found. */
  int count_missing()
  {
    for (double distance = 1e-6 * (found.values.back() - shift); distance < found.values.back() - shift;
         distance *= 10.)
    {
      const double s   = found.values.back() - distance;
      const bool clear = std::none_of(found.values.begin(), found.values.end(),
                                      [&](const double mu) { return std::abs(mu - s) < 0.1 * distance; });
      if (!clear)
        continue;
      if (const std::optional<int> count = count_below(s))
      {
        const auto n_found =
            std::count_if(found.values.begin(), found.values.end(), [&](const double mu) { return mu < s; });
        return *count - int(n_found);
      }
    }
    throw SolveError("Whether eigenvalues below " + as_text(found.values.back()) + " were missed cannot be told. " +
                     singular);
  }

  internal::ShiftedPencil pencil;
  LinearSolver &solver;
  int n_expected_negative, n_wanted;
  double shift = 0., factorised_at = 0.;
  std::string singular; ///< message of the last singular factorisation
  Eigenpairs found;
};
} // namespace

Eigenpairs lowest_eigenpairs(const SparseMatrix &K, const SparseMatrix &M, LinearSolver &solver,
                             const int n_expected_negative, const unsigned int n, const double scale)
{
  PELLICLE_ASSERT(n > 0, "no eigenvalues wanted");
  PELLICLE_ASSERT(std::isfinite(scale) && scale > 0., "the scale is not positive");
  return LowestEigenpairs(K, M, solver, n_expected_negative, int(n)).compute(scale);
}
} // namespace pellicle
