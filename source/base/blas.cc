// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/blas.h>

#include <deal.II/base/multithread_info.h>

#include <cstdlib>
#include <dlfcn.h>

namespace Voussoir
{
namespace
{
/** The BLAS is known only at run time: its functions are looked up by name. */
void *find(const char *name)
{
  return dlsym(RTLD_DEFAULT, name);
}
} // namespace

std::string blas_kernel()
{
  using GetName = char *(*)();
  const auto name = reinterpret_cast<GetName>(find("openblas_get_corename"));
  return name == nullptr ? "" : name();
}

std::string faster_blas_kernel()
{
  if (blas_kernel() != "Prescott" ||
      std::getenv("OPENBLAS_CORETYPE") != nullptr)
    return "";
#ifdef __x86_64__
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    return "SkylakeX";
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    return "Haswell";
#endif
  return "";
}

void prepare_blas()
{
  using SetThreads = void (*)(int);
  // CHOLMOD starts four threads of OpenMP in each small loop, whatever the
  // number of cores; without them its factors take two thirds of the time
  // (programs do better, by serial_regions.cc).
  if (const auto set_levels =
          reinterpret_cast<SetThreads>(find("omp_set_max_active_levels")))
    set_levels(0);
  using GetParallel = int (*)();
  if (const auto set_threads =
          reinterpret_cast<SetThreads>(find("openblas_set_num_threads")))
    set_threads(1);
  const auto get_parallel =
      reinterpret_cast<GetParallel>(find("openblas_get_parallel"));
  constexpr int without_threads = 0;
  if (get_parallel != nullptr && get_parallel() == without_threads)
    dealii::MultithreadInfo::set_thread_limit(1);
}
} // namespace Voussoir
