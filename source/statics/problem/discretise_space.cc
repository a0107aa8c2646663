// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/statics/problem/discretise_space.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace Voussoir
{
using dealii::Point;
using dealii::Tensor;

namespace
{
/** n_e and two tangents, of an interface. */
struct FaceFrame
{
  explicit FaceFrame(const Packing<3>::Interface &i)
      : normal(i.normal), first(tangent_of(i.normal)),
        second(cross_product_3d(normal, first))
  {}
  Tensor<1, 3> normal, first, second;
};

/** Makes a problem of a scene in space. */
class SpaceDiscretisation
{
public:
  explicit SpaceDiscretisation(const SpaceScene &scene);
  DiscreteProblem::Data data;

private:
  void choose_scales();
  void add_joint(unsigned int e);
  ContactRow row(const Packing<3>::Interface &i,
                 const Point<3> &place,
                 const Tensor<1, 3> &direction) const;

  const SpaceScene &scene;
  const SpaceBlocks &blocks;
  Point<3> centroid;
};

void find_load_in_space(const SpaceScene &scene,
                        const unsigned int cell,
                        const double length_unit,
                        const double force_unit,
                        double *load)
{
  const Tensor<1, 3> force = scene.loads.force[cell] / force_unit;
  std::copy_n(force.begin_raw(), 3, load);
  if (scene.blocks->turns())
  {
    const Tensor<1, 3> torque =
        scene.loads.torque[cell] / (force_unit * length_unit);
    std::copy_n(torque.begin_raw(), 3, load + 3);
  }
}

SpaceDiscretisation::SpaceDiscretisation(const SpaceScene &scene)
    : scene(scene), blocks(*scene.blocks)
{
  choose_scales();
  const Packing<3> &packing = blocks.packing;
  const double volume = packing.volume();
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    centroid += packing.volume(c) / volume * packing.centre(c);
  Structure::Part &part = data.part;
  part.kinematics = *blocks.kinematics;
  const unsigned int n = part.kinematics.n_unknowns();
  data.n_cells = packing.n_cells();
  const bool has_ground = packing.n_supports() > 0;
  part.loads.resize(n * (packing.n_cells() + has_ground));
  const double force_unit =
      data.stress_unit * data.length_unit * data.length_unit;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    part.centres.push_back((packing.centre(c) - centroid) / data.length_unit);
    find_load_in_space(scene, c, data.length_unit, force_unit,
                       &part.loads[n * c]);
  }
  if (has_ground)
    part.centres.emplace_back();
  for (unsigned int e = 0; e < packing.interfaces().size(); ++e)
    add_joint(e);
}

void SpaceDiscretisation::choose_scales()
{
  const Packing<3> &packing = blocks.packing;
  data.length_unit = std::cbrt(packing.volume() / packing.n_cells());
  double largest = 0., total = 0.;
  for (const Point<3> &x : packing.polygons().vertices)
    for (unsigned int i = 0; i < 3; ++i)
      largest = std::max(largest, std::abs(x[i]));
  data.coordinate_rounding =
      std::numeric_limits<double>::epsilon() * largest / data.length_unit;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    total += scene.loads.force[c].norm() +
             scene.loads.torque[c].norm() / data.length_unit;
  data.is_loaded = total > 0.;
  // As in the plane: the pressure at the foot of a wall under its own weight.
  if (data.is_loaded)
    data.stress_unit = total / (std::sqrt(double(packing.n_cells())) *
                                data.length_unit * data.length_unit);
}

ContactRow SpaceDiscretisation::row(const Packing<3>::Interface &i,
                                    const Point<3> &place,
                                    const Tensor<1, 3> &direction) const
{
  const auto turn = [&](const unsigned int cell) {
    const Point<3> &from = cell == blocks.packing.ground()
                               ? centroid
                               : blocks.packing.centre(cell);
    return cross_product_3d((place - from) / data.length_unit, direction);
  };
  ContactRow result;
  std::copy_n(direction.begin_raw(), 3, result.direction.begin());
  const Tensor<1, 3> minus = turn(i.cell_minus), plus = turn(i.cell_plus);
  std::copy_n(minus.begin_raw(), 3, result.turn_minus.begin());
  std::copy_n(plus.begin_raw(), 3, result.turn_plus.begin());
  return result;
}

void SpaceDiscretisation::add_joint(const unsigned int e)
{
  const Packing<3>::Interface &i = blocks.packing.interfaces()[e];
  const FaceFrame frame(i);
  const double area = i.area / (data.length_unit * data.length_unit);
  const Joint joint = {i.cell_minus,
                       i.cell_plus,
                       area,
                       blocks.packing.distance(i) / data.length_unit,
                       blocks.strength_under_tension(e) / data.stress_unit *
                           area,
                       blocks.coefficient(e)};
  std::vector<ContactRow> rows;
  std::vector<unsigned int> sets;
  std::vector<double> shares;
  for (const FacePoint &point : blocks.points[e].pressure)
  {
    rows.push_back(row(i, point.place, frame.normal));
    shares.push_back(point.share);
    sets.push_back(joint.coefficient > 0. ? 3 : 1);
    if (joint.coefficient > 0.)
      for (const Tensor<1, 3> &t : {frame.first, frame.second})
        rows.push_back(row(i, point.place, t));
  }
  if (joint.strength > 0.)
    for (const FacePoint &point : blocks.points[e].friction)
    {
      for (const Tensor<1, 3> &t : {frame.first, frame.second})
        rows.push_back(row(i, point.place, t));
      sets.push_back(2);
      shares.push_back(point.share);
    }
  data.part.joints.add(joint, rows, data.part.kinematics, sets, shares);
  const Strengths &of = blocks.strengths;
  if (of.tensile.empty() && of.compressive.empty())
    return;
  const double unit = area / data.stress_unit;
  data.limits.push_back(
      {blocks.tensile(e) * unit, of.compressive.empty()
                                     ? std::numeric_limits<double>::infinity()
                                     : of.compressive[e] * unit});
}

double force_unit_in_space(const DiscreteProblem &problem)
{
  return problem.stress_scale() * problem.length_scale() *
         problem.length_scale();
}
} // namespace

DiscreteProblem discretise(const SpaceScene &scene)
{
  return DiscreteProblem(SpaceDiscretisation(scene).data);
}

std::vector<double> discretise_loads(const DiscreteProblem &problem,
                                     const SpaceScene &scene)
{
  std::vector<double> loads(problem.n_dofs());
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    find_load_in_space(scene, c, problem.length_scale(),
                       force_unit_in_space(problem), &loads[problem.dof(c, 0)]);
  return loads;
}

std::vector<double> discretise_function(const DiscreteProblem &problem,
                                        const SpaceScene &scene,
                                        const FaceFunction &function)
{
  const SpaceBlocks &blocks = *scene.blocks;
  std::vector<double> c(problem.n_all_rows(), 0.);
  for (const FaceFunction::Term &term : function.terms)
  {
    const unsigned int e = term.interface;
    const FaceFrame frame(blocks.packing.interfaces()[e]);
    double *of = &c[problem.first_row(e)];
    const auto add_tangents = [&](const Tensor<1, 3> &jump) {
      *of++ = jump * frame.first;
      *of++ = jump * frame.second;
    };
    for (const FacePoint &point : blocks.points[e].pressure)
    {
      const Tensor<1, 3> jump = term.at(point.place);
      *of++ = jump * frame.normal;
      if (problem.joints()[e].coefficient > 0.)
        add_tangents(jump);
    }
    if (problem.joints()[e].strength > 0.)
      for (const FacePoint &point : blocks.points[e].friction)
        add_tangents(term.at(point.place));
  }
  return c;
}

SpaceMotion dimensional_motion(const DiscreteProblem &problem,
                               const SpaceScene &scene,
                               const std::vector<double> &u,
                               const double unit)
{
  SpaceMotion motion(problem.n_cells(), *scene.blocks->kinematics);
  if (u.empty())
    return motion;
  for (unsigned int c = 0; c < problem.n_cells(); ++c)
    for (unsigned int i = 0; i < 3; ++i)
    {
      motion.displacement[c][i] = unit * u[problem.dof(c, i)];
      if (!motion.rotation.empty())
        motion.rotation[c][i] =
            unit * u[problem.dof(c, 3 + i)] / problem.length_scale();
    }
  return motion;
}

FaceForces dimensional_forces(const DiscreteProblem &problem,
                              const SpaceScene &scene,
                              const Solution &solution)
{
  FaceForces forces;
  if (solution.forces.empty())
    return forces;
  const SpaceBlocks &blocks = *scene.blocks;
  const double unit = force_unit_in_space(problem);
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const FaceFrame frame(blocks.packing.interfaces()[e]);
    const double *f = &solution.forces[problem.first_row(e)];
    const bool has_cones = problem.joints()[e].coefficient > 0.;
    for (const FacePoint &point : blocks.points[e].pressure)
    {
      Tensor<1, 3> force = unit * *f++ * frame.normal;
      if (has_cones)
      {
        force += unit * f[0] * frame.first + unit * f[1] * frame.second;
        f += 2;
      }
      forces.list.push_back({point.place, force});
    }
    if (problem.joints()[e].strength > 0.)
      for (const FacePoint &point : blocks.points[e].friction)
      {
        forces.list.push_back({point.place, unit * f[0] * frame.first +
                                                unit * f[1] * frame.second});
        f += 2;
      }
    forces.first.push_back(forces.list.size());
  }
  return forces;
}

std::vector<double> nondimensional_forces(const DiscreteProblem &problem,
                                          const SpaceScene &scene,
                                          const FaceForces &forces)
{
  const SpaceBlocks &blocks = *scene.blocks;
  const double unit = force_unit_in_space(problem);
  std::vector<double> of_rows;
  of_rows.reserve(problem.n_all_rows());
  for (unsigned int e = 0; e < problem.joints().size(); ++e)
  {
    const FaceFrame frame(blocks.packing.interfaces()[e]);
    const unsigned int n_pressures = blocks.points[e].pressure.size();
    const bool has_cones = problem.joints()[e].coefficient > 0.;
    for (unsigned int k = forces.first[e]; k < forces.first[e + 1]; ++k)
    {
      const Tensor<1, 3> force = forces.list[k].force / unit;
      const bool is_pressure = k < forces.first[e] + n_pressures;
      if (is_pressure)
        of_rows.push_back(force * frame.normal);
      if (is_pressure && !has_cones)
        continue;
      of_rows.push_back(force * frame.first);
      of_rows.push_back(force * frame.second);
    }
  }
  return of_rows;
}
} // namespace Voussoir
