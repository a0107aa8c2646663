// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/running_bond.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
std::string RunningBondGenerator::name() const
{
  return "running bond";
}

std::string RunningBondGenerator::meaning() const
{
  return "a rectangular wall of equal bricks, every second course shifted by "
         "half a brick.";
}

void RunningBondGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  prm.add_parameter("Courses", n_courses, "Number of courses, bottom to top.",
                    Integer(1, 1000000));
  prm.add_parameter("Bricks per course", n_bricks,
                    "Number of whole bricks in the bottom course and every "
                    "second one above; the courses between have one whole "
                    "brick less and a half brick at either end.",
                    Integer(1, 1000000));
  prm.add_parameter("Width", width, "Width of the wall; a length, positive.",
                    Double(0.));
  prm.add_parameter("Height", height, "Height of the wall; a length, positive.",
                    Double(0.));
}

CellLoops RunningBondGenerator::generate(const std::filesystem::path &) const
{
  if (!(width > 0.) || !(height > 0.) || !std::isfinite(width * height))
    throw InputError(text("The wall 'Packing/running bond' has the width ",
                          width, " and the height ", height,
                          "; both must be positive and finite."));

  // Coordinates are counted in half bricks and courses, so that shared
  // vertices are recognised exactly. Level k has the vertices of the head
  // joints below and above it.
  const unsigned int n_halves = 2 * n_bricks;
  const auto joints = [n_halves](const unsigned int course) {
    std::vector<unsigned int> x = {0};
    for (unsigned int h = (course % 2 == 0 ? 2 : 1); h < n_halves; h += 2)
      x.push_back(h);
    x.push_back(n_halves);
    return x;
  };

  CellLoops cells;
  const unsigned int none = dealii::numbers::invalid_unsigned_int;
  std::vector<unsigned int> below(n_halves + 1, none), above;
  const auto make_level = [&](const unsigned int level) {
    std::vector<unsigned int> vertex_at(n_halves + 1, none);
    for (const bool upper : {false, true})
    {
      if ((upper && level == n_courses) || (!upper && level == 0))
        continue;
      for (const unsigned int h : joints(upper ? level : level - 1))
        vertex_at[h] = 0; // marked; numbered below, from left to right
    }
    for (unsigned int h = 0; h <= n_halves; ++h)
      if (vertex_at[h] != none)
      {
        vertex_at[h] = cells.vertices.size();
        cells.vertices.emplace_back(width * h / n_halves,
                                    height * level / n_courses);
      }
    return vertex_at;
  };

  above = make_level(0);
  for (unsigned int course = 0; course < n_courses; ++course)
  {
    below = std::move(above);
    above = make_level(course + 1);
    const std::vector<unsigned int> x = joints(course);
    for (unsigned int b = 0; b + 1 < x.size(); ++b)
    {
      for (unsigned int h = x[b]; h <= x[b + 1]; ++h)
        if (below[h] != none)
          cells.loops.push_back(below[h]);
      for (unsigned int h = x[b + 1] + 1; h-- > x[b];)
        if (above[h] != none)
          cells.loops.push_back(above[h]);
      cells.first.push_back(cells.loops.size());
    }
  }
  return cells;
}
} // namespace Voussoir
