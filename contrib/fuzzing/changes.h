// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_contrib_fuzzing_changes_h
#define voussoir_contrib_fuzzing_changes_h

#include <random>
#include <string>
#include <vector>

namespace Fuzzing
{
/**
 * Makes spoilt inputs of good ones where there is no libFuzzer: a few bytes, a
 * number, a line or the rest of an input are changed, left out, doubled or
 * exchanged for those of another. The same ones in every run.
 */
class Changes
{
public:
  /** @param seeds the good inputs, one at least. */
  Changes(const std::vector<std::string> &seeds, unsigned int number);

  /** The next one. */
  std::string next();

private:
  /** One of 0, ..., n - 1; 0 if n is 0. */
  std::size_t any_below(std::size_t n);
  const std::string &any_of(const std::vector<std::string> &texts);
  void change(std::string &input);

  const std::vector<std::string> &seeds;
  std::mt19937 random;
};
} // namespace Fuzzing

#endif
