// SPDX-License-Identifier: LGPL-2.1-or-later
/*
 * CHOLMOD: null, no result; status=N, no result for this reason; and for
 * solutions nan, inf, zero and wrong.
 */
#include "plant.h"
#include <cholmod.h>

namespace
{
/** Whether there is to be no result, and why. */
bool has_none(const char *const failure, cholmod_common *const common)
{
  if (Plant::is(failure, "null"))
    common->status = CHOLMOD_OUT_OF_MEMORY;
  else if (Plant::is(failure, "status"))
    common->status = Plant::number_of(failure);
  else
    return false;
  return true;
}
} // namespace

extern "C" {
cholmod_sparse *cholmod_allocate_sparse(size_t n_rows,
                                        size_t n_columns,
                                        size_t n_entries,
                                        int sorted,
                                        int packed,
                                        int stype,
                                        int xtype,
                                        cholmod_common *common)
{
  static Plant::Function function("cholmod_allocate_sparse");
  static auto *const real = Plant::hidden<decltype(cholmod_allocate_sparse)>(
      "cholmod_allocate_sparse");
  return has_none(function.call(), common)
             ? nullptr
             : real(n_rows, n_columns, n_entries, sorted, packed, stype, xtype,
                    common);
}

cholmod_factor *cholmod_analyze(cholmod_sparse *matrix, cholmod_common *common)
{
  static Plant::Function function("cholmod_analyze");
  static auto *const real =
      Plant::hidden<decltype(cholmod_analyze)>("cholmod_analyze");
  return has_none(function.call(), common) ? nullptr : real(matrix, common);
}

cholmod_factor *cholmod_analyze_p(cholmod_sparse *matrix,
                                  int *order,
                                  int *set,
                                  size_t size,
                                  cholmod_common *common)
{
  static Plant::Function function("cholmod_analyze_p");
  static auto *const real =
      Plant::hidden<decltype(cholmod_analyze_p)>("cholmod_analyze_p");
  return has_none(function.call(), common)
             ? nullptr
             : real(matrix, order, set, size, common);
}

int cholmod_factorize(cholmod_sparse *matrix,
                      cholmod_factor *factor,
                      cholmod_common *common)
{
  static Plant::Function function("cholmod_factorize");
  static auto *const real =
      Plant::hidden<decltype(cholmod_factorize)>("cholmod_factorize");
  const char *const failure = function.call();
  if (has_none(failure, common))
    return 0;
  const int done = real(matrix, factor, common);
  if (failure != nullptr && factor->x != nullptr)
    Plant::spoil(failure, static_cast<double *>(factor->x),
                 factor->is_super ? factor->xsize : factor->nzmax);
  return done;
}

cholmod_dense *cholmod_solve(int system,
                             cholmod_factor *factor,
                             cholmod_dense *right,
                             cholmod_common *common)
{
  static Plant::Function function("cholmod_solve");
  static auto *const real =
      Plant::hidden<decltype(cholmod_solve)>("cholmod_solve");
  const char *const failure = function.call();
  if (has_none(failure, common))
    return nullptr;
  cholmod_dense *const solution = real(system, factor, right, common);
  if (failure != nullptr && solution != nullptr)
    Plant::spoil(failure, static_cast<double *>(solution->x), solution->nzmax);
  return solution;
}
}
