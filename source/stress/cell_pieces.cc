// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/geometry.h>
#include <voussoir/base/invalid_index.h>
#include <voussoir/packing/area_moments.h>
#include <voussoir/packing/convex_pieces.h>
#include <voussoir/stress/cell_pieces.h>

#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;
using dealii::Tensor;

/** A force and its torque about a point. */
struct Wrench
{
  Tensor<1, 2> force;
  double torque = 0.;

  void operator+=(const Wrench &other)
  {
    force += other.force;
    torque += other.torque;
  }
};

/** A field b_0 + B (x - x_c) of the resultant and the moments of another. */
struct LinearField
{
  LinearField(const AreaMoments &cell,
              const Tensor<1, 2> &force,
              const Tensor<2, 2> &moment)
      : slope((moment - outer_product(force, cell.centroid())) *
              invert(cell.second_about_centroid())),
        constant((force - slope * cell.first) / cell.area)
  {}

  Tensor<1, 2> at(const Tensor<1, 2> &arm) const
  {
    return constant + slope * arm;
  }

  Tensor<2, 2> slope;
  Tensor<1, 2> constant;
};

/** The linear body force of a cell. */
LinearField body_force_of(const Scene &scene, const unsigned int c)
{
  return {area_moments(scene.packing, c), scene.body.force(scene.packing, c),
          scene.body.moment(c)};
}

/** The shift of the force on a side that has the given couple. */
Tensor<1, 2> shift_of_couple(const double couple, const Tensor<1, 2> &along)
{
  return 2. * couple / along.norm_square() *
         Tensor<1, 2>({-along[1], along[0]});
}

/** Finds the forces on the pieces of one cell; one object, used once. */
class Cutting
{
public:
  Cutting(const Packing<2> &packing,
          const unsigned int cell,
          const std::vector<std::vector<unsigned int>> &pieces)
      : packing(packing), cell(cell), pieces(pieces), on_piece(pieces.size())
  {
    for (unsigned int p = 0; p < pieces.size(); ++p)
      for (unsigned int k = 0; k < pieces[p].size(); ++k)
        side_of[{vertex(p, k), vertex(p, k + 1)}] = {p, k};
  }

  /** Add the forces on the sides of the cell and, if not null, inside. */
  void add_known(const CellForces &of_cells, const LinearField *const body)
  {
    const unsigned int first = packing.first_side(cell);
    for (unsigned int p = 0; p < pieces.size(); ++p)
    {
      sides.emplace_back(pieces[p].size());
      for (unsigned int k = 0; k < pieces[p].size(); ++k)
      {
        if (is_cut(p, k))
          continue;
        SideForce &of_side = sides[p][k];
        of_side.force = of_cells.on_side[first + vertex(p, k)];
        if (!of_cells.shift_on_side.empty())
          of_side.shift = of_cells.shift_on_side[first + vertex(p, k)];
        add(p, k);
      }
      if (body != nullptr)
        add_body(p, *body);
    }
    share_out_torque();
  }

  /** Find the forces through the cuts, from the leaves of the tree. */
  void find_cuts() { find_cuts_behind(0, invalid_index); }

  std::vector<std::vector<SideForce>> sides;
  /** By piece and side, the integral of the body force over the triangle. */
  std::vector<std::vector<Tensor<1, 2>>> body_forces;

private:
  /** Vertex @p k of a piece, by its number in the cell. */
  unsigned int vertex(const unsigned int p, const unsigned int k) const
  {
    return pieces[p][k % pieces[p].size()];
  }
  bool is_cut(const unsigned int p, const unsigned int k) const
  {
    return (vertex(p, k) + 1) % packing.n_sides(cell) != vertex(p, k + 1);
  }
  /** From the centre of the cell. */
  Tensor<1, 2> place(const unsigned int v) const
  {
    return packing.vertex(cell, v) - packing.centre(cell);
  }

  /** Add what acts on a side to what acts on its piece. */
  void add(const unsigned int p, const unsigned int k)
  {
    const Tensor<1, 2> a = place(vertex(p, k)), b = place(vertex(p, k + 1));
    const SideForce &of = sides[p][k];
    on_piece[p] += {of.force, cross(0.5 * (a + b), of.force) +
                                  cross(0.5 * (b - a), of.shift)};
  }

  /** Add a body force, by a rule that is exact for its torque. */
  void add_body(const unsigned int p, const LinearField &body)
  {
    std::vector<Point<2>> ring;
    for (const unsigned int v : pieces[p])
      ring.push_back(packing.vertex(cell, v));
    const Tensor<1, 2> c = centroid(ring) - packing.centre(cell);
    body_forces.resize(p + 1);
    for (unsigned int k = 0; k < pieces[p].size(); ++k)
    {
      const Tensor<1, 2> a = place(vertex(p, k)), b = place(vertex(p, k + 1));
      const double area = 0.5 * cross(a - c, b - c);
      const Tensor<1, 2> force = area * body.at((a + b + c) / 3.);
      Wrench of_triangle = {force, 0.};
      for (const Tensor<1, 2> &x :
           {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)})
        of_triangle.torque += area / 3. * cross(x, body.at(x));
      on_piece[p] += of_triangle;
      body_forces[p].push_back(force);
    }
  }

  /** Take the torque of the whole cell from its pieces, by their areas. */
  void share_out_torque()
  {
    Wrench all;
    for (const Wrench &of : on_piece)
      all += of;
    for (unsigned int p = 0; p < pieces.size(); ++p)
    {
      double area = 0.;
      for (unsigned int k = 0; k < pieces[p].size(); ++k)
        area += 0.5 * cross(place(vertex(p, k)), place(vertex(p, k + 1)));
      on_piece[p].torque -= area / packing.area(cell) * all.torque;
    }
  }

  /** What acts on a piece and all behind it, seen from the piece before. */
  Wrench find_cuts_behind(const unsigned int p, const unsigned int before)
  {
    Wrench behind = on_piece[p];
    for (unsigned int k = 0; k < pieces[p].size(); ++k)
    {
      if (!is_cut(p, k))
        continue;
      const auto [other, side] = side_of.at({vertex(p, k + 1), vertex(p, k)});
      if (other == before)
        continue;
      const Wrench beyond = find_cuts_behind(other, p);
      behind += beyond;
      const Tensor<1, 2> a = place(vertex(p, k)), b = place(vertex(p, k + 1));
      const double couple = beyond.torque - cross(0.5 * (a + b), beyond.force);
      sides[p][k] = {beyond.force, shift_of_couple(couple, b - a)};
      sides[other][side] = {-1. * beyond.force,
                            shift_of_couple(-couple, a - b)};
    }
    return behind;
  }

  const Packing<2> &packing;
  const unsigned int cell;
  const std::vector<std::vector<unsigned int>> pieces;
  std::vector<Wrench> on_piece;
  /** The piece and its side from one vertex to another. */
  std::map<std::pair<unsigned int, unsigned int>,
           std::pair<unsigned int, unsigned int>>
      side_of;
};
} // namespace

CellPieces::CellPieces(const Packing<2> &packing)
    : packing(packing), pieces(loops())
{}

CellLoops CellPieces::loops()
{
  CellLoops loops;
  loops.group_names = packing.group_names();
  loops.group_names.pop_back(); // the ground, which a packing adds
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    if (packing.is_seen_whole(c))
    {
      std::vector<unsigned int> all(packing.n_sides(c));
      std::iota(all.begin(), all.end(), 0);
      add_piece(c, all, loops);
      loops.centres.push_back(packing.centre(c));
    }
    else
      for (const auto &piece : convex_pieces(ring_of(packing, c)))
      {
        add_piece(c, piece, loops);
        std::vector<Point<2>> ring;
        for (const unsigned int v : piece)
          ring.push_back(packing.vertex(c, v));
        loops.centres.push_back(centroid(ring));
      }
  return loops;
}

void CellPieces::add_piece(const unsigned int cell,
                           const std::vector<unsigned int> &corners,
                           CellLoops &loops)
{
  std::vector<unsigned int> loop;
  for (const unsigned int v : corners)
  {
    loop.push_back(loops.vertices.size());
    loops.vertices.push_back(packing.vertex(cell, v));
  }
  loops.add(loop);
  loops.group.push_back(packing.group(cell));
  cells.push_back(cell);
  corners_of.push_back(corners);
}

std::vector<unsigned int>
CellPieces::cells_of(const std::vector<unsigned int> &of_pieces) const
{
  std::vector<unsigned int> found;
  for (const unsigned int p : of_pieces)
    if (found.empty() || found.back() != cells[p])
      found.push_back(cells[p]);
  return found;
}

CellForces CellPieces::forces(const Scene &scene,
                              const InterfaceForces &forces) const
{
  const CellForces of_cells = cell_forces(scene, forces, all_cells(packing));
  const bool has_body = !of_cells.body.empty();
  CellForces result;
  const auto add = [&](const SideForce &of_side) {
    result.on_side.push_back(of_side.force);
    result.shift_on_side.push_back(of_side.shift);
  };
  for (unsigned int p = 0; p < cells.size();)
  {
    const unsigned int c = cells[p];
    if (packing.is_seen_whole(c))
    {
      for (std::size_t s = packing.first_side(c); s < packing.first_side(c + 1);
           ++s)
      {
        add({of_cells.on_side[s], of_cells.shift_on_side.empty()
                                      ? Tensor<1, 2>()
                                      : of_cells.shift_on_side[s]});
        if (has_body)
          result.body.push_back(of_cells.body[s]);
      }
      ++p;
      continue;
    }
    std::vector<std::vector<unsigned int>> of_cell;
    for (; p < cells.size() && cells[p] == c; ++p)
      of_cell.push_back(corners_of[p]);
    Cutting cutting(packing, c, of_cell);
    std::optional<LinearField> body;
    if (has_body)
      body.emplace(body_force_of(scene, c));
    cutting.add_known(of_cells, body ? &*body : nullptr);
    cutting.find_cuts();
    for (const auto &sides : cutting.sides)
      for (const SideForce &of_side : sides)
        add(of_side);
    for (const auto &of_piece : cutting.body_forces)
      result.body.insert(result.body.end(), of_piece.begin(), of_piece.end());
  }
  return result;
}

Motion CellPieces::motion(const Motion &of_cells) const
{
  Motion motion;
  for (unsigned int p = 0; p < cells.size(); ++p)
  {
    const unsigned int c = cells[p];
    motion.displacement.push_back(
        of_cells.at(c, pieces.centre(p) - packing.centre(c)));
    if (!of_cells.rotation.empty())
      motion.rotation.push_back(of_cells.rotation[c]);
  }
  return motion;
}
} // namespace Voussoir
