// SPDX-License-Identifier: LGPL-2.1-or-later
/*
 * The C library: malloc and its kin, which count calls of PLANT_SIZE bytes or
 * more, if that is given; pthread_create; and what writes files.
 */
#include "plant.h"
#include <cerrno>
#include <cstdlib>
#include <pthread.h>
#include <sys/types.h>
#include <sys/uio.h>

extern "C" {
void *__libc_malloc(size_t);
void *__libc_calloc(size_t, size_t);
void *__libc_realloc(void *, size_t);
void *__libc_memalign(size_t, size_t);
}

namespace
{
Plant::Function of_malloc("malloc");

/** Whether there is no memory for so many bytes. */
bool is_out_of_memory(const size_t size)
{
  // What a failing call needs itself.
  static thread_local bool is_inside = false;
  // The loader asks for memory before there is an environment.
  const char *const least = getenv("PLANT_SIZE");
  if (is_inside || least == nullptr)
    return false;
  is_inside = true;
  const bool is_out =
      size >= strtoul(least, nullptr, 10) && of_malloc.call() != nullptr;
  is_inside = false;
  if (is_out)
    errno = ENOMEM;
  return is_out;
}
} // namespace

extern "C" {
void *malloc(size_t size)
{
  return is_out_of_memory(size) ? nullptr : __libc_malloc(size);
}

void *calloc(size_t n, size_t size)
{
  return is_out_of_memory(n * size) ? nullptr : __libc_calloc(n, size);
}

void *realloc(void *old, size_t size)
{
  return is_out_of_memory(size) ? nullptr : __libc_realloc(old, size);
}

int posix_memalign(void **result, size_t alignment, size_t size)
{
  if (is_out_of_memory(size))
    return ENOMEM;
  *result = __libc_memalign(alignment, size);
  return *result == nullptr ? ENOMEM : 0;
}

int pthread_create(pthread_t *thread,
                   const pthread_attr_t *attributes,
                   void *(*function)(void *),
                   void *argument)
{
  static Plant::Function planted("pthread_create");
  static auto *const real =
      Plant::hidden<decltype(pthread_create)>("pthread_create");
  return planted.call() != nullptr
             ? EAGAIN
             : real(thread, attributes, function, argument);
}

ssize_t write(int file, const void *bytes, size_t n)
{
  static Plant::Function planted("write");
  static auto *const real = Plant::hidden<decltype(write)>("write");
  if (file > 2 && n > 1 && planted.call() != nullptr)
  {
    errno = ENOSPC;
    return -1;
  }
  return real(file, bytes, n);
}

ssize_t writev(int file, const iovec *parts, int n)
{
  static Plant::Function planted("writev");
  static auto *const real = Plant::hidden<decltype(writev)>("writev");
  if (file > 2 && planted.call() != nullptr)
  {
    errno = ENOSPC;
    return -1;
  }
  return real(file, parts, n);
}

int rename(const char *from, const char *to)
{
  static Plant::Function planted("rename");
  static auto *const real = Plant::hidden<decltype(rename)>("rename");
  if (planted.call() != nullptr)
  {
    errno = EIO;
    return -1;
  }
  return real(from, to);
}

char *mkdtemp(char *path)
{
  static Plant::Function planted("mkdtemp");
  static auto *const real = Plant::hidden<decltype(mkdtemp)>("mkdtemp");
  if (planted.call() != nullptr)
  {
    errno = EROFS;
    return nullptr;
  }
  return real(path);
}
}
