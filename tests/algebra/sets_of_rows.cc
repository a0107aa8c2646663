// SPDX-License-Identifier: LGPL-2.1-or-later

// Joints with different numbers of rows, in sets of one or several: where rows,
// sets and coefficients are; closed forms of one block on a floor in space,
// with friction that is a disc of two rows, and beside a wall without any; and
// in the plane a third contact, or a disc, that change nothing.

#include <voussoir/statics/energy/elastic_problem.h>

#include "disc_joint.h"

namespace test_sets_of_rows
{
using namespace Voussoir;

/**
 * A block on a floor and beside a wall that has a contact but no friction: what
 * pushes it along the floor, beyond the strength there, the wall bears if it is
 * in the way.
 */
void block_on_floor()
{
  const double k = 2., strength = 0.3;
  const auto solution = [&](const Vector3 &load, const LinearSolver method) {
    Structure::Part part;
    part.kinematics = in_space;
    part.centres = {vector(0., 0., 0.5), Vector3()};
    for (const double sign : {1., -1.})
      for (unsigned int i = 0; i < 3; ++i)
        part.loads.push_back(sign * load[i]);
    add_joint(part, {0, 1, k, 1., strength}, vector(0., 0., -1.), {Vector3()},
              true);
    add_joint(part, {0, 1, 1., 1., 0.}, vector(1., 0., 0.), {Vector3()}, false);
    const Structure structure(ProcessGroup(), std::move(part));
    const DiscJoint law(structure);
    JointSystem system(structure, method);
    return solved(structure, law, system).forces();
  };
  for (const LinearSolver method :
       {LinearSolver::direct, LinearSolver::multigrid})
  {
    // Pulled from the wall, in any direction: the floor bears it all.
    std::vector<double> f = solution(vector(-0.2, 0.1, -1.), method);
    check("four rows in two joints", f.size() == 4);
    check_error("pressure on the floor", std::abs(f[0] + 1.), 1e-12);
    check_error("friction in a disc",
                std::abs(std::hypot(f[1], f[2]) - std::hypot(0.2, 0.1)), 1e-12);
    check_error("nothing at the wall", std::abs(f[3]), 1e-12);

    // Pushed against the wall: both are springs until the floor slides. With
    // displacement u along x, floor and wall have k u and u.
    f = solution(vector(0.3, 0., -1.), method);
    check_error("shared by the wall", std::abs(f[3] + 0.1), 1e-12);
    f = solution(vector(1., 0., -1.), method);
    check_error("the floor slides", std::abs(std::hypot(f[1], f[2]) - strength),
                1e-12);
    check_error("and the wall bears the rest", std::abs(f[3] + 1. - strength),
                1e-12);
  }
}

/**
 * In the plane: what acts at the end of a block, beside its two contacts, a
 * third one between them or a disc of two rows instead of one for sliding does
 * not change. The disc has a row along a third direction of which the plane
 * knows nothing, here the tangent once more.
 */
void rows_in_the_plane()
{
  enum Kind
  {
    two_contacts,
    middle,
    disc
  };
  std::vector<double> known;
  for (const Kind kind : {two_contacts, middle, disc})
  {
    Structure::Part part;
    part.kinematics = rotations();
    part.centres = {vector(0., 0.5, 0.), Vector3()};
    // On the block, and on the ground with the moment about the origin.
    part.loads = {0.1, -1., 0.05, -0.1, 1., -0.05 + 0.5 * 0.1};
    std::vector<ContactRow> rows;
    for (const double x : {-0.5, 0.5})
      rows.push_back({{{0., -1., 0.}}, {{-x}}, {{-x}}});
    if (kind == middle)
      rows.push_back(combination(0.5, rows[0], 0.5, rows[1]));
    const ContactRow sliding = {{{1., 0., 0.}}, {{0.5}}, {{0.}}};
    rows.push_back(sliding);
    std::vector<unsigned int> sets;
    if (kind == disc)
    {
      rows.push_back({});
      sets = {1, 1, 2};
    }
    part.joints.add({0, 1, 1., 1., 0.2}, rows, part.kinematics, sets);
    const Structure structure(ProcessGroup(), std::move(part));
    const DiscJoint with_disc(structure);
    const ElasticJoint elastic(structure);
    const JointLaw &law =
        kind == disc ? static_cast<const JointLaw &>(with_disc) : elastic;
    JointSystem system(structure, LinearSolver::direct, 1e-8);
    const Newton newton = solved(structure, law, system);
    check_error("a block in the plane: balance", newton.imbalance(), 1e-12);
    // The sums of forces and of their moments about the middle.
    const std::vector<double> &f = newton.forces();
    const std::vector<double> sums = {kind == middle ? f[0] + f[1] + f[2]
                                                     : f[0] + f[1],
                                      f[1] - f[0], f[kind == middle ? 3 : 2]};
    if (known.empty())
      known = sums;
    for (unsigned int k = 0; k < 3; ++k)
      check_error("  forces of any rows", std::abs(sums[k] - known[k]), 1e-12);
  }
  check_error("  the pressure is the load", std::abs(known[0] + 1.), 1e-12);
  check_error("  friction, too", std::abs(std::abs(known[2]) - 0.1), 1e-12);
}

/** Joints with discs and without, in any order: all have their places. */
void places_of_rows()
{
  JointRows joints;
  const std::vector<ContactRow> two(2), three(3);
  joints.add({0, 1, 1., 1., 1.}, two, in_space);
  joints.add({0, 1, 1., 1., 1.}, two, in_space, {1, 1});
  check("no blocks without a set of several rows", joints.set_sizes.empty());
  joints.add({0, 1, 1., 1., 1.}, three, in_space, {1, 2});
  joints.add({0, 1, 1., 1., 1.}, two, in_space);
  joints.add({0, 1, 1., 1., 1.}, three, in_space, {3});
  Structure::Part part;
  part.kinematics = in_space;
  part.centres.resize(2);
  part.loads.resize(6, 0.);
  part.joints = joints;
  const Structure structure(ProcessGroup(), std::move(part));
  check("rows", structure.n_all_rows() == 12 && structure.first_row(3) == 7 &&
                    structure.n_rows(4) == 3);
  check("coefficients", structure.n_all_coefficients() == 20 &&
                            structure.first_coefficient(2) == 4 &&
                            structure.first_coefficient(3) == 9 &&
                            structure.first_coefficient(4) == 11);
  check("sets", structure.sets(0) == std::vector<unsigned int>({1, 1}) &&
                    structure.sets(2) == std::vector<unsigned int>({1, 2}) &&
                    structure.sets(4) == std::vector<unsigned int>({3}));
  bool all = true;
  for (unsigned int e = 0; e < 5; ++e)
    for (std::size_t k = structure.first_row(e); k < structure.first_row(e + 1);
         ++k)
      all &= structure.joint_of_row(k) == e;
  check("joints of rows", all);
}

void run()
{
  places_of_rows();
  block_on_floor();
  rows_in_the_plane();
}

const RoomTest test("sets_of_rows", run);
} // namespace test_sets_of_rows
