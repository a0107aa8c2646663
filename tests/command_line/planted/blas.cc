// SPDX-License-Identifier: LGPL-2.1-or-later
/*
 * BLAS and LAPACK, as CHOLMOD, deal.II and MUMPS call them: nan, inf, zero or
 * wrong of the result; info=N of LAPACK.
 */
#include "plant.h"

namespace
{
void spoil_matrix(const char *const failure,
                  double *const a,
                  const int n_rows,
                  const int n_columns,
                  const int leading)
{
  for (long j = 0; failure != nullptr && j < n_columns; ++j)
    Plant::spoil(failure, a + j * leading, n_rows);
}
} // namespace

extern "C" {
void dgemm_(const char *transa,
            const char *transb,
            const int *m,
            const int *n,
            const int *k,
            const double *alpha,
            const double *a,
            const int *lda,
            const double *b,
            const int *ldb,
            const double *beta,
            double *c,
            const int *ldc)
{
  static Plant::Function function("dgemm");
  static auto *const real = Plant::hidden<decltype(dgemm_)>("dgemm_");
  const char *const failure = function.call();
  real(transa, transb, m, n, k, alpha, a, lda, b, ldb, beta, c, ldc);
  spoil_matrix(failure, c, *m, *n, *ldc);
}

void dsyrk_(const char *uplo,
            const char *trans,
            const int *n,
            const int *k,
            const double *alpha,
            const double *a,
            const int *lda,
            const double *beta,
            double *c,
            const int *ldc)
{
  static Plant::Function function("dsyrk");
  static auto *const real = Plant::hidden<decltype(dsyrk_)>("dsyrk_");
  const char *const failure = function.call();
  real(uplo, trans, n, k, alpha, a, lda, beta, c, ldc);
  spoil_matrix(failure, c, *n, *n, *ldc);
}

void dtrsm_(const char *side,
            const char *uplo,
            const char *transa,
            const char *diag,
            const int *m,
            const int *n,
            const double *alpha,
            const double *a,
            const int *lda,
            double *b,
            const int *ldb)
{
  static Plant::Function function("dtrsm");
  static auto *const real = Plant::hidden<decltype(dtrsm_)>("dtrsm_");
  const char *const failure = function.call();
  real(side, uplo, transa, diag, m, n, alpha, a, lda, b, ldb);
  spoil_matrix(failure, b, *m, *n, *ldb);
}

void dpotrf_(
    const char *uplo, const int *n, double *a, const int *lda, int *info)
{
  static Plant::Function function("dpotrf");
  static auto *const real = Plant::hidden<decltype(dpotrf_)>("dpotrf_");
  const char *const failure = function.call();
  real(uplo, n, a, lda, info);
  if (Plant::is(failure, "info"))
    *info = Plant::number_of(failure);
  else
    spoil_matrix(failure, a, *n, *n, *lda);
}

void dgesdd_(const char *job,
             const int *m,
             const int *n,
             double *a,
             const int *lda,
             double *s,
             double *u,
             const int *ldu,
             double *vt,
             const int *ldvt,
             double *work,
             const int *lwork,
             int *iwork,
             int *info)
{
  static Plant::Function function("dgesdd");
  static auto *const real = Plant::hidden<decltype(dgesdd_)>("dgesdd_");
  const char *const failure = *lwork == -1 ? nullptr : function.call();
  real(job, m, n, a, lda, s, u, ldu, vt, ldvt, work, lwork, iwork, info);
  if (Plant::is(failure, "info"))
    *info = Plant::number_of(failure);
  else if (failure != nullptr && *lwork != -1)
    Plant::spoil(failure, s, *m < *n ? *m : *n);
}

void dgetrf_(const int *m,
             const int *n,
             double *a,
             const int *lda,
             int *pivots,
             int *info)
{
  static Plant::Function function("dgetrf");
  static auto *const real = Plant::hidden<decltype(dgetrf_)>("dgetrf_");
  const char *const failure = function.call();
  real(m, n, a, lda, pivots, info);
  if (Plant::is(failure, "info"))
    *info = Plant::number_of(failure);
  else
    spoil_matrix(failure, a, *m, *n, *lda);
}
}
