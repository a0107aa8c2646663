// SPDX-License-Identifier: LGPL-2.1-or-later

// Newton's method and its linear systems know neither plane nor space, and
// joints have as many rows as each needs. Here are bodies with three
// translations, and with three rotations besides, on joints of one to several
// contacts, with friction that is a disc of two rows or without any: closed
// forms of one block on a floor, matrices against products of dense ones, and a
// heap of blocks in which every force is checked against its law.

#include <voussoir/algebra/newton.h>
#include <voussoir/statics/energy/elastic_problem.h>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/vector.h>

#include "tests.h"
#include <random>

namespace test_sets_of_rows
{
using namespace Voussoir;
using dealii::Tensor;
using Vector3 = Tensor<1, 3>;

const Kinematics in_space("translations in space", 3, 0);
const Kinematics turning_in_space("rotations in space", 3, 3);

Vector3 vector(const double x, const double y, const double z)
{
  Vector3 v;
  v[0] = x;
  v[1] = y;
  v[2] = z;
  return v;
}

std::array<double, 3> numbers(const Vector3 &v)
{
  return {{v[0], v[1], v[2]}};
}

/** The row of a point, from the centres of c- and c+. */
ContactRow row(const Vector3 &direction,
               const Vector3 &from_minus = Vector3(),
               const Vector3 &from_plus = Vector3())
{
  return {numbers(direction), numbers(cross_product_3d(from_minus, direction)),
          numbers(cross_product_3d(from_plus, direction))};
}

/** Any two tangents of a normal. */
std::array<Vector3, 2> tangents(const Vector3 &normal)
{
  const Vector3 other =
      std::abs(normal[0]) < 0.7 ? vector(1., 0., 0.) : vector(0., 1., 0.);
  Vector3 first = cross_product_3d(normal, other);
  first /= first.norm();
  return {{first, cross_product_3d(normal, first)}};
}

/**
 * Elastic joints: contacts in sets of one row, which share the stiffness, and
 * sliding in a disc of two rows, up to the strength.
 */
class DiscJoint : public JointLaw
{
public:
  explicit DiscJoint(const Structure &structure) : structure(structure) {}

  void find_forces(const unsigned int e,
                   const double *jumps,
                   double *forces) const override
  {
    const double k = structure.joints()[e].stiffness();
    structure.for_each_set(
        e, [&](const unsigned int size, const unsigned int r, unsigned int) {
          if (size == 1)
          {
            forces[r] = k / n_contacts(e) * std::min(jumps[r], 0.);
            return;
          }
          const double force = k * std::hypot(jumps[r], jumps[r + 1]);
          const double share = std::min(1., structure.limit(e) / force);
          for (unsigned int i = 0; i < 2; ++i)
            forces[r + i] = (force > 0. ? share : 1.) * k * jumps[r + i];
        });
  }

  bool find_second_derivatives(const unsigned int e,
                               const double *jumps,
                               double *second) const override
  {
    const double k = structure.joints()[e].stiffness();
    bool all = true, has_disc = false;
    structure.for_each_set(e, [&](const unsigned int size, const unsigned int r,
                                  const unsigned int first) {
      double *block = second + first;
      if (size == 1)
      {
        block[0] = jumps[r] <= 0. ? k / n_contacts(e) : 0.;
        all &= jumps[r] <= 0.;
        return;
      }
      has_disc = true;
      const double length = std::hypot(jumps[r], jumps[r + 1]);
      const bool slides = k * length > structure.limit(e);
      all &= !slides;
      for (unsigned int i = 0; i < 2; ++i)
        for (unsigned int j = 0; j < 2; ++j)
        {
          const double one = i == j ? 1. : 0.;
          block[2 * i + j] =
              slides ? structure.limit(e) / length *
                           (one - jumps[r + i] / length * jumps[r + j] / length)
                     : k * one;
        }
    });
    return all && has_disc;
  }

private:
  unsigned int n_contacts(const unsigned int e) const
  {
    unsigned int n = 0;
    structure.for_each_set(e, [&](const unsigned int size, unsigned int,
                                  unsigned int) { n += size == 1 ? 1 : 0; });
    return n;
  }

  const Structure &structure;
};

/** A part with a joint of as many contacts, and with or without friction. */
void add_joint(Structure::Part &part,
               const Structure::Joint &joint,
               const Vector3 &normal,
               const std::vector<Vector3> &points,
               const bool has_friction)
{
  const Vector3 &minus = part.centres[joint.cell_minus],
                &plus = part.centres[joint.cell_plus];
  std::vector<ContactRow> rows;
  std::vector<unsigned int> sets(points.size(), 1);
  Vector3 mean;
  for (const Vector3 &x : points)
  {
    rows.push_back(row(normal, x - minus, x - plus));
    mean += 1. / points.size() * x;
  }
  if (has_friction)
  {
    for (const Vector3 &t : tangents(normal))
      rows.push_back(row(t, mean - minus, mean - plus));
    sets.push_back(2);
  }
  part.joints.add(joint, rows, part.kinematics, sets);
}

/** Newton's method from rest. */
Newton
solved(const Structure &structure, const JointLaw &law, JointSystem &system)
{
  Newton newton(structure, law, system,
                std::vector<double>(structure.n_dofs(), 0.));
  while (newton.imbalance() > 1e-13 && newton.n_iterations() < 200)
    newton.step(least_shift, newton.u());
  return newton;
}

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
  Structure::Joints joints;
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
  rigid_motions();
  linear_systems();
  block_on_floor();
  heap_of_blocks();
  rows_in_the_plane();
  places_of_rows();
}

const RoomTest test("sets_of_rows", run);
} // namespace test_sets_of_rows
