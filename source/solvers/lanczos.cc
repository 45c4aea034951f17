// SPDX-License-Identifier: LGPL-2.1-or-later
// ARPACK's dsaupd and dseupd, mode 3 (Lehoucq, Sorensen, Yang: ARPACK Users' Guide, SIAM 1998, section 3.2).
#include "lanczos.h"

#include <pellicle/assembly/communicator.h>
#include <pellicle/base/exceptions.h>

#include <arpack.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace pellicle::internal
{
namespace
{
constexpr double ritz_tolerance = 1e-12; // relative accuracy of a Ritz value at which ARPACK takes it for converged
constexpr double round_off      = 1e-13; // a Ritz value this small relative to the first is zero

// ARPACK's status
constexpr int finished         = 0;
constexpr int restarts_used_up = 1;
constexpr int exhausted        = -9999; // the Krylov space has no more than iparam[4] dimensions

/**
 * One run of ARPACK; its arrays have its names. Its BLAS may round differently in different processes, which then
 * would not agree on when to stop: ARPACK runs in the first process, the others take part in solves and get the result.
 */
class Arpack
{
public:
  Arpack(const LanczosOperator &operator_, const int n_wanted, const int n_vectors, const int max_restarts)
      : map(operator_)
      , n(operator_.size)
      , nev(n_wanted)
      , ncv(n_vectors)
      , resid(n)
      , v(std::size_t(n) * ncv)
      , workd(3 * std::size_t(n))
      , workl(std::size_t(ncv) * (ncv + 8))
  {
    iparam[2] = max_restarts;
    std::mt19937 generator(1);
    for (double &entry : resid)
      entry = double(generator()) / double(std::mt19937::max()) - 0.5;
  }

  /** Returns the status and, in `dimension`, that of the Krylov space when it is exhausted. */
  int iterate(int &dimension)
  {
    std::vector<double> b(n);
    for (;;)
    {
      std::vector<double> message(n + 1, 0.); // right-hand side, then: is there one?
      if (is_first() && advance(b))
      {
        std::copy(b.begin(), b.end(), message.begin());
        message.back() = 1.;
      }
      communicator.sum(message);
      if (message.back() == 0.)
        break;
      std::copy_n(message.begin(), n, b.begin());
      map.solve(b);
      std::copy(b.begin(), b.end(), workd.begin() + target);
    }
    const std::vector<double> outcome = from_first({double(info), double(iparam[4])});
    dimension                         = int(outcome[1]);
    return int(outcome[0]);
  }

  /** Ritz values at the end, converged or not. */
  std::vector<double> ritz_values() const
  {
    const auto first = workl.begin() + (is_first() ? ipntr[5] - 1 : 0);
    return from_first({first, first + ncv});
  }

  /** Inverse eigenvalues and, one after the other, their vectors. */
  std::pair<std::vector<double>, std::vector<double>> eigenvectors()
  {
    std::vector<double> d(nev), z(std::size_t(n) * nev);
    if (is_first())
    {
      std::vector<a_int> select(ncv);
      dseupd_c(1, "A", select.data(), d.data(), z.data(), n, 0., "G", n, "LA", nev, ritz_tolerance, resid.data(), ncv,
               v.data(), n, iparam, ipntr, workd.data(), workl.data(), a_int(workl.size()), &info);
    }
    if (const int status = int(from_first({double(info)})[0]); status != finished)
      throw SolveError("ARPACK cannot extract eigenvectors (dseupd: info = " + std::to_string(status) + ").");
    return {from_first(d), from_first(z)};
  }

private:
  bool is_first() const { return communicator.rank() == 0; }

  std::vector<double> from_first(std::vector<double> values) const
  {
    if (!is_first())
      std::fill(values.begin(), values.end(), 0.);
    communicator.sum(values);
    return values;
  }

  /** Runs ARPACK up to its next right-hand side b, whose solution goes to workd[target]; false at the end. */
  bool advance(std::vector<double> &b)
  {
    for (;;)
    {
      dsaupd_c(&ido, "G", n, "LA", nev, ritz_tolerance, resid.data(), ncv, v.data(), n, iparam, ipntr, workd.data(),
               workl.data(), a_int(workl.size()), &info);
      const double *const x = &workd[ipntr[0] - 1];
      target                = ipntr[1] - 1;
      switch (ido)
      {
      case -1: // y = A^-1 M x
        map.mass(x, b.data());
        return true;
      case 1: // the same, M x is known already
        std::copy_n(&workd[ipntr[2] - 1], n, b.data());
        return true;
      case 2: // y = M x
        map.mass(x, &workd[target]);
        break;
      default:
        return false;
      }
    }
  }

  const LanczosOperator &map;
  const Communicator communicator;
  a_int n, nev, ncv;
  a_int ido = 0, info = 1; // 1: start vector given
  std::vector<double> resid, v, workd, workl;
  a_int iparam[11] = {1, 0, 0, 1, 0, 0, 3, 0, 0, 0, 0}; // exact shifts, block size 1, mode 3
  a_int ipntr[11]  = {1, 1, 1};
  int target       = 0;
};

/**
 * Vector i of those stored one after the other, M-normalised. Unknowns without mass are invisible in Lanczos' inner
 * product and carry more round-off than the others: one inverse iteration gives them the values that go with the mass
 * (Nour-Omid, Parlett, Ericsson, Jensen: How to implement the spectral transformation, Math. Comp. 48 (1987) 663).
 */
std::vector<double> purified(const LanczosOperator &map, const std::vector<double> &vectors, const int i)
{
  std::vector<double> u(map.size), Mu(map.size);
  map.mass(&vectors[std::size_t(i) * map.size], u.data());
  map.solve(u);
  map.mass(u.data(), Mu.data());
  const double norm = std::sqrt(std::inner_product(u.begin(), u.end(), Mu.begin(), 0.));
  for (double &entry : u)
    entry /= norm;
  return u;
}

[[noreturn]] void fail_for_want_of_eigenvalues(const int n_existing, const int n_wanted)
{
  throw SolveError("There are only " + std::to_string(n_existing) + " finite eigenvalues, " + std::to_string(n_wanted) +
                   " are wanted: that must be fewer than there are.");
}
} // namespace

LanczosResult lanczos(const LanczosOperator &map, const int n, const int max_restarts)
{
  // ARPACK's advice is twice as many vectors as are wanted; with twenty more a few eigenvalues need no restart.
  int n_vectors = std::min(2 * n + 20, map.n_eigenvectors);
  for (;;)
  {
    if (n >= n_vectors)
      fail_for_want_of_eigenvalues(std::max(n_vectors, 0), n);
    Arpack arpack(map, n, n_vectors, max_restarts);
    int dimension    = 0;
    const int status = arpack.iterate(dimension);
    LanczosResult result;
    switch (status)
    {
    case exhausted:
      if (dimension >= n_vectors)
        throw SolveError("ARPACK loses orthogonality: the matrix is too badly conditioned.");
      n_vectors = dimension;
      continue;
    case restarts_used_up:
      result.values = arpack.ritz_values();
      std::sort(result.values.rbegin(), result.values.rend());
      return result;
    case finished:
    {
      const auto [inverse, vectors] = arpack.eigenvectors();
      result.converged              = true;
      for (int i = 0; i < n; ++i)
      {
        if (std::abs(inverse[0]) < round_off * std::abs(inverse[i]))
          fail_for_want_of_eigenvalues(i, n);
        result.values.push_back(1. / inverse[i]);
        result.vectors.push_back(purified(map, vectors, i));
      }
      return result;
    }
    default:
      throw SolveError("ARPACK fails (dsaupd: info = " + std::to_string(status) + ").");
    }
  }
}
} // namespace pellicle::internal
