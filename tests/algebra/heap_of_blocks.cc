// SPDX-License-Identifier: LGPL-2.1-or-later

// Newton's method and its linear systems know neither plane nor space: a heap
// of blocks with three translations, and with three rotations besides, on
// joints of different numbers of contacts with discs of friction or without.
// Rigid motions move no joint, systems are solved as those of dense matrices,
// and under a load every force is checked against its law.

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include "disc_joint.h"
#include <random>

namespace test_heap_of_blocks
{
using namespace Voussoir;

/** A grid of blocks, each touching those beside and below, at random planes. */
Structure::Part heap(const Kinematics &kinematics, const bool all_alike)
{
  std::mt19937 generator(3);
  const auto random = [&]() {
    return generator() / double(std::mt19937::max()) - 0.5;
  };
  const unsigned int n = 4;
  Structure::Part part;
  part.kinematics = kinematics;
  for (unsigned int b = 0; b < n * n * n; ++b)
    part.centres.push_back(vector(b % n + 0.2 * random(),
                                  b / n % n + 0.2 * random(),
                                  b / n / n + 0.2 * random()));
  const unsigned int ground = n * n * n;
  part.centres.push_back(Vector3());
  const auto add = [&](const unsigned int a, const unsigned int b,
                       Vector3 normal) {
    if (!all_alike)
      normal += 0.2 * vector(random(), random(), random());
    normal /= normal.norm();
    const Vector3 middle = b == ground
                               ? part.centres[a] + 0.5 * normal
                               : 0.5 * (part.centres[a] + part.centres[b]);
    // Blocks that turn are held at all corners of each joint.
    const std::array<Vector3, 2> t = tangents(normal);
    const double s[] = {-0.5, 0.5, 0.5, -0.5, 0., 0.2},
                 r[] = {-0.5, -0.5, 0.5, 0.5, 0., 0.1};
    std::vector<Vector3> points;
    const unsigned int least = kinematics.turns() ? 4 : 1;
    const unsigned int n_points = all_alike ? 1 : least + generator() % 3;
    for (unsigned int k = 0; k < n_points; ++k)
      points.push_back(middle + s[k] * t[0] + r[k] * t[1]);
    // Above one another they cannot do without friction.
    const bool is_bed = normal[2] > 0.5;
    const bool has_friction =
        all_alike || kinematics.turns() || is_bed || generator() % 4 > 0;
    const double strength = (is_bed ? 0.06 : 0.02) * (1. + random());
    add_joint(part, {a, b, 1. + random(), 1. + random(), strength}, normal,
              points, has_friction);
  };
  for (unsigned int b = 0; b < ground; ++b)
  {
    const unsigned int x = b % n, y = b / n % n, z = b / n / n;
    if (x + 1 < n)
      add(b, b + 1, vector(1., 0., 0.));
    if (y + 1 < n)
      add(b, b + n, vector(0., 1., 0.));
    if (z + 1 < n)
      add(b, b + n * n, vector(0., 0., 1.));
    else
      add(b, ground, vector(0., 0., 1.));
  }
  part.loads.assign(kinematics.n_unknowns() * part.centres.size(), 0.);
  for (unsigned int b = 0; b < ground; ++b)
  {
    // The ground has all others with the opposite sign, and their moment.
    const Vector3 load = vector(0.02 * random(), 0.02 * random(), 0.05);
    const Vector3 moment = cross_product_3d(part.centres[b], load);
    double *of_ground = &part.loads[kinematics.n_unknowns() * ground];
    for (unsigned int i = 0; i < 3; ++i)
    {
      part.loads[kinematics.n_unknowns() * b + i] = load[i];
      of_ground[i] -= load[i];
      if (kinematics.turns())
        of_ground[3 + i] -= moment[i];
    }
  }
  return part;
}

/** sum_e B_e^T A_e B_e + shift, as a product of dense matrices. */
dealii::FullMatrix<double> dense(const Structure &structure,
                                 const std::vector<double> &coefficients,
                                 const double shift)
{
  const unsigned int n = structure.n_dofs();
  dealii::FullMatrix<double> matrix(n, n);
  for (unsigned int j = 0; j < n; ++j)
  {
    std::vector<double> u(n, 0.), column(n, 0.);
    u[j] = 1.;
    std::vector<double> f = structure.jumps(u);
    structure.multiply_by_blocks(coefficients, f);
    structure.add_jump_gradients(1., f, column);
    for (unsigned int i = 0; i < n; ++i)
      matrix(i, j) = column[i] + (i == j ? shift : 0.);
  }
  return matrix;
}

/** What is left of a random right-hand side, with a shift, relative to it. */
double residual_of(const Structure &structure,
                   JointSystem &system,
                   const JointStiffnesses &a)
{
  const double shift = 1e-6;
  std::mt19937 generator(7);
  dealii::Vector<double> r(structure.n_dofs()), left(r), u(r);
  for (double &component : r)
    component = generator() / double(std::mt19937::max()) - 0.5;
  system.prepare(a, shift);
  const std::vector<double> found = system.solve({r.begin(), r.end()});
  std::copy(found.begin(), found.end(), u.begin());
  dense(structure, a.of_rows, shift).vmult(left, u);
  left -= r;
  return left.l2_norm() / r.l2_norm();
}

/** Systems with blocks of one row and of two, whatever method solves them. */
void linear_systems()
{
  for (const Kinematics *kinematics : {&in_space, &turning_in_space})
    for (const bool all_alike : {false, true})
    {
      const Structure structure(ProcessGroup(), heap(*kinematics, all_alike));
      const DiscJoint law(structure);
      JointStiffnesses a;
      a.of_rows.resize(structure.n_all_coefficients());
      a.are_isotropic = true;
      // Alike: closed and at rest. Else some open, and some slide.
      std::mt19937 generator(5);
      for (unsigned int e = 0; e < structure.joints().size(); ++e)
      {
        std::vector<double> jumps(structure.n_rows(e), 0.);
        for (double &jump : jumps)
          jump = all_alike ? 0. : generator() / double(generator.max()) - 0.7;
        a.are_isotropic &= law.find_second_derivatives(
            e, jumps.data(), &a.of_rows[structure.first_coefficient(e)]);
      }
      const std::string name =
          kinematics->name() + (all_alike ? ", all alike" : ", any rows");
      check(name + ": isotropic", a.are_isotropic == all_alike);
      JointSystem direct(structure, LinearSolver::direct);
      check_error(name + ", direct", residual_of(structure, direct, a), 1e-9);
      JointSystem multigrid(structure, LinearSolver::multigrid);
      check_error(name + ", multigrid", residual_of(structure, multigrid, a),
                  1e-9);
    }
}

/** Rigid motions of all bodies as one move no joint. */
void rigid_motions()
{
  for (const Kinematics *kinematics : {&in_space, &turning_in_space})
  {
    const Structure structure(ProcessGroup(), heap(*kinematics, false));
    double largest = 0.;
    for (unsigned int k = 0; k < structure.n_unknowns(); ++k)
    {
      std::vector<double> u(structure.n_dofs());
      for (unsigned int b = 0; b < structure.n_bodies(); ++b)
        kinematics->find_rigid_motion(k, structure.centre(b),
                                      &u[structure.dof(b, 0)]);
      for (const double jump : structure.jumps(u))
        largest = std::max(largest, std::abs(jump));
    }
    check_error(kinematics->name() + ": jumps of rigid motions", largest,
                1e-14);
  }
}

/** The heap under its load: forces by their law, and in balance. */
void heap_of_blocks()
{
  for (const Kinematics *kinematics : {&in_space, &turning_in_space})
  {
    const Structure structure(ProcessGroup(), heap(*kinematics, false));
    const DiscJoint law(structure);
    JointSystem system(structure, LinearSolver::direct);
    const Newton newton = solved(structure, law, system);
    std::vector<double> left = structure.loads();
    structure.add_jump_gradients(-1., newton.forces(), left);
    double largest = 0.;
    for (const double component : left)
      largest = std::max(largest, std::abs(component));
    check_error(kinematics->name() + ": balance", largest, 1e-12);

    unsigned int n_sliding = 0, n_open = 0;
    double excess = 0., along = 0.;
    for (unsigned int e = 0; e < structure.joints().size(); ++e)
      structure.for_each_set(
          e, [&](const unsigned int size, const unsigned int r, unsigned int) {
            const double *f = &newton.forces()[structure.first_row(e) + r];
            const double *x = &newton.jumps()[structure.first_row(e) + r];
            if (size == 1)
            {
              n_open += *x > 0.;
              excess = std::max(excess, *f);
              return;
            }
            const double force = std::hypot(f[0], f[1]);
            n_sliding += force > (1. - 1e-9) * structure.limit(e);
            excess = std::max(excess, force - structure.limit(e));
            along = std::max(along, std::abs(f[0] * x[1] - f[1] * x[0]));
          });
    check("  some joints slide, and some open", n_sliding > 0 && n_open > 0);
    check_error("  forces beyond their sets", excess, 1e-15);
    check_error("  friction across its sliding", along, 1e-12);
  }
}

void run()
{
  rigid_motions();
  linear_systems();
  heap_of_blocks();
}

const RoomTest test("heap_of_blocks", run);
} // namespace test_heap_of_blocks
