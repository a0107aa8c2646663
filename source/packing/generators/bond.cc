// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/packing/generators/bond.h>

namespace Voussoir
{
namespace
{
// All in quarters of a stretcher.
constexpr unsigned int stretcher = quarters_in_stretcher;
constexpr unsigned int header = stretcher / 2;
/** A stretcher and a header of the Flemish bond. */
constexpr unsigned int period = stretcher + header;

bool is_joint_of_headers(const unsigned int x, const unsigned int length)
{
  if (x == header || x == length - header)
    return true;
  return x > header && x < length - header && x % 2 == 1;
}

bool is_joint_of_odd_flemish_course(const unsigned int x,
                                    const unsigned int length)
{
  // In such a wall the course below ends with a whole stretcher, as it begins.
  const bool symmetric = length % period == stretcher;
  if (x == header || (symmetric && x == length - header))
    return true;
  if (x < header || (symmetric && x > length - header))
    return false;
  return x % period == 1 || x % period == 3;
}

bool is_joint(const Bond bond,
              const unsigned int course,
              const unsigned int x,
              const unsigned int length)
{
  const bool odd = course % 2 == 1;
  switch (bond)
  {
  case Bond::running: return x % stretcher == (odd ? header : 0);
  case Bond::stack: return x % stretcher == 0;
  case Bond::English:
    return odd ? is_joint_of_headers(x, length) : x % stretcher == 0;
  case Bond::Flemish:
    return odd ? is_joint_of_odd_flemish_course(x, length)
               : x % period == stretcher || x % period == 0;
  }
  return false;
}
} // namespace

std::vector<unsigned int> head_joints(const Bond bond,
                                      const unsigned int course,
                                      const unsigned int n_stretchers)
{
  const unsigned int length = stretcher * n_stretchers;
  std::vector<unsigned int> joints = {0};
  for (unsigned int x = 1; x < length; ++x)
    if (is_joint(bond, course, x, length))
      joints.push_back(x);
  joints.push_back(length);
  return joints;
}
} // namespace Voussoir
