// SPDX-License-Identifier: LGPL-2.1-or-later
#include "plant.h"

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <new>
#include <stdexcept>
#include <unistd.h>

namespace Plant
{
namespace
{
/** Of another process than that of PLANT_RANK. */
bool is_elsewhere()
{
  const char *const wanted = std::getenv("PLANT_RANK");
  const char *const own = std::getenv("OMPI_COMM_WORLD_RANK");
  return wanted != nullptr && (own == nullptr || std::strcmp(wanted, own) != 0);
}

/** What any function may do instead of its work. */
void fail(const char *failure)
{
  if (is(failure, "abort"))
    std::abort();
  if (is(failure, "fault"))
    std::raise(SIGSEGV);
  if (is(failure, "exit"))
    std::exit(1);
  if (is(failure, "throw"))
    throw std::runtime_error("a planted exception");
  if (is(failure, "throw_int"))
    throw -1;
  if (is(failure, "bad_alloc"))
    throw std::bad_alloc();
}
} // namespace

const char *Function::call()
{
  // Without memory: malloc() is one of the functions.
  const char *entry = std::getenv("PLANT");
  const std::size_t length = std::strlen(name);
  while (entry != nullptr &&
         (std::strncmp(entry, name, length) != 0 || entry[length] != ':'))
  {
    entry = std::strchr(entry, ';');
    entry += entry != nullptr ? 1 : 0;
  }
  if (entry == nullptr || is_elsewhere())
    return nullptr;
  char *end;
  const long first = std::strtol(entry + length + 1, &end, 10);
  const bool follow = *end == '+';
  const long call = __atomic_add_fetch(&n_calls, 1, __ATOMIC_RELAXED);
  if (call < first || (call > first && !follow))
    return nullptr;
  const char *const failure = end + (follow ? 2 : 1);
  if (const char *const mark = std::getenv("PLANT_MARK"))
    close(open(mark, O_CREAT | O_WRONLY, 0600));
  fail(failure);
  return failure;
}

bool is(const char *const failure, const char *const name)
{
  if (failure == nullptr)
    return false;
  const std::size_t length = std::strlen(name);
  return std::strncmp(failure, name, length) == 0 &&
         std::strchr(";=", failure[length]) != nullptr; // or its end
}

int number_of(const char *const failure)
{
  return std::atoi(std::strchr(failure, '=') + 1);
}

void spoil(const char *const failure, double *const values, const long n)
{
  for (long k = 0; k < n; ++k)
    if (is(failure, "nan"))
      values[k] = NAN;
    else if (is(failure, "inf"))
      values[k] = INFINITY;
    else if (is(failure, "zero"))
      values[k] = 0.;
    else if (is(failure, "wrong"))
      values[k] *= 1. + 0.5 * std::sin(1. + k);
}
} // namespace Plant
