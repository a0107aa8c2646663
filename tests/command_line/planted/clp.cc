// SPDX-License-Identifier: LGPL-2.1-or-later
/*
 * Clp: error, a CoinError; status=N, what it says behind a solution that is
 * found; nan, wrong and zero of the forces, duals=... of the multipliers; of a
 * ray null, nan and wrong.
 */
#include "plant.h"
#include <ClpSimplex.hpp>
#include <CoinError.hpp>

namespace
{
using Method = int(ClpSimplex *, int, int);

int run(Plant::Function &function,
        Method *const real,
        ClpSimplex *const clp,
        const int first,
        const int second)
{
  const char *const failure = function.call();
  if (Plant::is(failure, "error"))
    throw CoinError("a planted error", "run", "Plant");
  const int status = real(clp, first, second);
  if (failure == nullptr)
    return status;
  if (Plant::is(failure, "status"))
    clp->setProblemStatus(Plant::number_of(failure));
  else if (Plant::is(failure, "multipliers"))
    Plant::spoil("wrong", clp->dualRowSolution(), clp->numberRows());
  else if (Plant::is(failure, "no_multipliers"))
    Plant::spoil("nan", clp->dualRowSolution(), clp->numberRows());
  else
    Plant::spoil(failure, clp->primalColumnSolution(), clp->numberColumns());
  return status;
}
} // namespace

int ClpSimplex::primal(int first, int second)
{
  static Plant::Function function("primal");
  static Method *const real =
      Plant::hidden<Method>("_ZN10ClpSimplex6primalEii");
  return run(function, real, this, first, second);
}

int ClpSimplex::dual(int first, int second)
{
  static Plant::Function function("dual");
  static Method *const real = Plant::hidden<Method>("_ZN10ClpSimplex4dualEii");
  return run(function, real, this, first, second);
}

double *ClpModel::unboundedRay() const
{
  static Plant::Function function("unboundedRay");
  static auto *const real = Plant::hidden<double *(const ClpModel *)>(
      "_ZNK8ClpModel12unboundedRayEv");
  const char *const failure = function.call();
  double *const ray = Plant::is(failure, "null") ? nullptr : real(this);
  if (failure != nullptr && ray != nullptr)
    Plant::spoil(failure, ray, numberColumns_);
  return ray;
}
