/* Times and counts what the program asks of CHOLMOD, Epetra and ML.

   A shared library to be loaded before these, by LD_PRELOAD. Each function here
   hides the one of its name, and calls it. At the end, if any was called, a
   line for each kernel goes to the file $KERNEL_PROBE: its name, calls,
   seconds, bytes and operations. The bytes are those that must at least be
   moved once the operands do not fit into the cache:

   - factorisation: each entry of the factor is allocated in the cache, written,
     and read once for the columns to its right;
   - solution: each entry of the factor is read forwards and backwards;
   - product: each entry of the matrix is read with its column, each row with
     its beginning, the vector and the result once, and the result is also
     allocated;
   - cycle: its products with the finest matrix.

   Calls that are inside of a counted call of the same kernel do not count. */
#define _GNU_SOURCE
#include <cholmod.h>
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum Kernel
{
  analysis,
  factorisation,
  solution,
  product,
  cycle,
  n_kernels
};

static const char *const names[n_kernels] = {"analysis", "factorisation",
                                             "solution", "product", "cycle"};
static struct
{
  long calls, depth;
  double start, seconds, bytes, operations;
} kernels[n_kernels];

static double now(void)
{
  struct timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return t.tv_sec + 1e-9 * t.tv_nsec;
}

static void enter(enum Kernel k)
{
  if (kernels[k].depth++ == 0)
    kernels[k].start = now();
}

static void leave(enum Kernel k, double bytes, double operations)
{
  if (--kernels[k].depth > 0)
    return;
  kernels[k].seconds += now() - kernels[k].start;
  kernels[k].calls += 1;
  kernels[k].bytes += bytes;
  kernels[k].operations += operations;
}

static void *hidden(const char *name)
{
  void *found = dlsym(RTLD_NEXT, name);
  if (!found)
    abort();
  return found;
}

static double size_of(const cholmod_factor *factor)
{
  return 8. * (factor->is_super ? factor->xsize : factor->nzmax);
}

cholmod_factor *cholmod_analyze(cholmod_sparse *matrix, cholmod_common *common)
{
  cholmod_factor *(*original)(cholmod_sparse *, cholmod_common *) =
      hidden("cholmod_analyze");
  enter(analysis);
  cholmod_factor *factor = original(matrix, common);
  leave(analysis, 0., 0.);
  return factor;
}

int cholmod_factorize(cholmod_sparse *matrix,
                      cholmod_factor *factor,
                      cholmod_common *common)
{
  int (*original)(cholmod_sparse *, cholmod_factor *, cholmod_common *) =
      hidden("cholmod_factorize");
  enter(factorisation);
  const int fine = original(matrix, factor, common);
  leave(factorisation, 3. * size_of(factor), common->fl);
  return fine;
}

cholmod_dense *cholmod_solve(int what,
                             cholmod_factor *factor,
                             cholmod_dense *right,
                             cholmod_common *common)
{
  cholmod_dense *(*original)(int, cholmod_factor *, cholmod_dense *,
                             cholmod_common *) = hidden("cholmod_solve");
  enter(solution);
  cholmod_dense *u = original(what, factor, right, common);
  leave(solution, 2. * size_of(factor), size_of(factor) / 2. * right->ncol);
  return u;
}

void epetra_dcrsmv_(int *transposed,
                    int *n_rows,
                    int *n_columns,
                    double *values,
                    int *columns,
                    int *starts,
                    double *x,
                    double *y)
{
  static void (*original)(int *, int *, int *, double *, int *, int *, double *,
                          double *);
  if (!original)
    original = hidden("epetra_dcrsmv_");
  enter(product);
  original(transposed, n_rows, n_columns, values, columns, starts, x, y);
  const double n_entries = starts[*n_rows] - starts[0];
  const double bytes = 12. * n_entries + 28. * *n_rows;
  leave(product, bytes, 2. * n_entries);
  if (kernels[cycle].depth > 0)
    kernels[cycle].bytes += bytes;
}

double ML_Cycle_MG(void *level,
                   double *u,
                   double *right,
                   int from_zero,
                   void *comm,
                   int with_norm,
                   void *ml)
{
  static double (*original)(void *, double *, double *, int, void *, int,
                            void *);
  if (!original)
    original = hidden("ML_Cycle_MG");
  enter(cycle);
  const double norm = original(level, u, right, from_zero, comm, with_norm, ml);
  leave(cycle, 0., 0.);
  return norm;
}

__attribute__((destructor)) static void report(void)
{
  long n_calls = 0;
  for (int k = 0; k < n_kernels; ++k)
    n_calls += kernels[k].calls;
  const char *path = getenv("KERNEL_PROBE");
  FILE *file = path && n_calls ? fopen(path, "w") : NULL;
  if (!file)
    return;
  for (int k = 0; k < n_kernels; ++k)
    fprintf(file, "%s,%ld,%.9g,%.9g,%.9g\n", names[k], kernels[k].calls,
            kernels[k].seconds, kernels[k].bytes, kernels[k].operations);
  fclose(file);
}
