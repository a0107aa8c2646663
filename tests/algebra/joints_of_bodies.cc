// SPDX-License-Identifier: LGPL-2.1-or-later

// What all cores do for joints and bodies is to the last bit what one does, one
// joint after the other: jumps, blocks of sets, and sums of forces on bodies,
// of more joints than a core takes at once. A trap stays as it is in all of
// them.

#include <voussoir/algebra/joints_of_bodies.h>
#include <voussoir/base/chunks.h>

#include "disc_joint.h"
#include <cmath>
#include <limits>
#include <random>

namespace test_joints_of_bodies
{
using namespace Voussoir;

std::mt19937 generator(11);

double random()
{
  return generator() / double(std::mt19937::max()) - 0.5;
}

std::vector<double> randoms(const std::size_t n)
{
  std::vector<double> v(n);
  for (double &component : v)
    component = random();
  return v;
}

/** Joints of one to four contacts, some with friction, between any bodies. */
Structure::Part heap(const Kinematics &kinematics)
{
  const unsigned int n_bodies = 1000, n_joints = 3000;
  Structure::Part part;
  part.kinematics = kinematics;
  for (unsigned int b = 0; b < n_bodies; ++b)
    part.centres.push_back(vector(random(), random(), random()));
  for (unsigned int e = 0; e < n_joints; ++e)
  {
    const unsigned int a = generator() % n_bodies,
                       b = (a + 1 + generator() % (n_bodies - 1)) % n_bodies;
    Vector3 normal = vector(random(), random(), random());
    normal /= normal.norm();
    std::vector<Vector3> points(1 + generator() % 4);
    for (Vector3 &x : points)
      x = vector(random(), random(), random());
    add_joint(part, {a, b, 1., 1., 1.}, normal, points, generator() % 2 == 0);
  }
  part.loads.assign(kinematics.n_unknowns() * n_bodies, 0.);
  return part;
}

bool are_equal(const std::vector<double> &a, const std::vector<double> &b)
{
  return a == b;
}

void sums(const Kinematics &kinematics)
{
  const Structure structure(ProcessGroup(), heap(kinematics));
  const JointsOfBodies joints(structure);
  check(kinematics.name() + ": more than one chunk",
        structure.joints().size() > 2 * items_of_a_chunk &&
            structure.n_bodies() > 2 * items_of_a_chunk);

  const std::vector<double> f = randoms(structure.n_all_rows());
  std::vector<double> one_by_one(structure.n_dofs(), 0.);
  for (unsigned int e = 0; e < structure.joints().size(); ++e)
    structure.add_jump_gradient(e, &f[structure.first_row(e)],
                                one_by_one.data());
  check("  forces on bodies",
        are_equal(joints.forces_on_bodies(1., f), one_by_one));
  std::vector<double> all(structure.n_dofs(), 0.);
  structure.add_jump_gradients(-0.7, f, all);
  check("  and times a factor",
        are_equal(joints.forces_on_bodies(-0.7, f), all));

  const std::vector<double> u = randoms(structure.n_dofs());
  std::vector<double> jumps(structure.n_all_rows()), to = f;
  for (unsigned int e = 0; e < structure.joints().size(); ++e)
    structure.find_jumps(e, u.data(), &jumps[structure.first_row(e)]);
  check("  jumps", are_equal(structure.jumps(u), jumps));
  structure.add_exact_jumps(u, to);
  std::vector<double> exact = f;
  for (std::size_t k = 0; k < exact.size(); ++k)
    exact[k] =
        static_cast<double>(exact[k] + structure.exact_jump(k, u.data()));
  check("  exact jumps", are_equal(to, exact));

  const std::vector<double> a = randoms(structure.n_all_coefficients());
  std::vector<double> by_sets = f;
  for (unsigned int e = 0; e < structure.joints().size(); ++e)
    structure.for_each_set(e, [&](const unsigned int size,
                                  const unsigned int row,
                                  const unsigned int coefficient) {
      for (unsigned int i = 0; i < size; ++i)
      {
        const std::size_t first = structure.first_row(e) + row;
        by_sets[first + i] = 0.;
        for (unsigned int j = 0; j < size; ++j)
          by_sets[first + i] +=
              a[structure.first_coefficient(e) + coefficient + size * i + j] *
              f[first + j];
      }
    });
  to = f;
  structure.multiply_by_blocks(a, to);
  check("  blocks of sets", are_equal(to, by_sets));
}

void ranges()
{
  std::vector<unsigned int> n_visits(1001, 0), of_range(11, 0);
  for_chunks(
      1001, 100,
      [&](const std::size_t k, const std::size_t begin, const std::size_t end) {
        of_range[k] = end - begin;
        for (std::size_t i = begin; i < end; ++i)
          ++n_visits[i];
      });
  check("each number once", n_visits == std::vector<unsigned int>(1001, 1));
  check("the last range is shorter",
        of_range.back() == 1 && of_range[9] == 100);
  bool is_called = false;
  for_chunks(0, 100,
             [&](std::size_t, std::size_t, std::size_t) { is_called = true; });
  check("none of nothing", !is_called);
  // In Debug a trap would end the test.
  const InvalidOperationsAllowed allowed;
  std::vector<double> numbers(1000, std::numeric_limits<double>::infinity());
  for_chunks(1000, 10,
             [&](std::size_t, const std::size_t begin, const std::size_t end) {
               for (std::size_t i = begin; i < end; ++i)
                 numbers[i] -= numbers[i];
             });
  check("what is allowed here is allowed in all of them",
        std::isnan(numbers.front()) && std::isnan(numbers.back()));
}

void run()
{
  ranges();
  for (const Kinematics *kinematics : {&in_space, &turning_in_space})
    sums(*kinematics);
}

const RoomTest test("joints_of_bodies", run);
} // namespace test_joints_of_bodies
