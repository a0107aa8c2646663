// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/invalid_index.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/voronoi/cell_lists.h>
#include <voussoir/packing/polyhedra/voronoi/face_cutter.h>
#include <voussoir/packing/polyhedra/voronoi/small_features.h>
#include <voussoir/packing/polyhedra/voronoi/voronoi_cells.h>
#include <voussoir/packing/polyhedra/voronoi/voronoi_sites.h>

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
using dealii::Point;

/** The narrowest face, relative to the mean size of a cell. */
constexpr double relative_resolution_in_space = 1e-12;

/** The same at least, in rounding errors of the coordinates. */
constexpr double unresolved_epsilons = 256.;

/**
 * The least distance of two generators over the resolution, so that no cell is
 * so flat that it goes with its narrow faces.
 */
constexpr double least_generator_distance = 100.;

using SpaceKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Tetrahedra = CGAL::Delaunay_triangulation_3<
    SpaceKernel,
    CGAL::Triangulation_data_structure_3<
        CGAL::Triangulation_vertex_base_with_info_3<unsigned int, SpaceKernel>,
        CGAL::Triangulation_cell_base_with_info_3<unsigned int, SpaceKernel>>>;

SpaceKernel::Point_3 kernel_point(const Point<3> &p)
{
  return {p[0], p[1], p[2]};
}

bool is_finite(const Point<3> &p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

/** Builds the cells; one object, used once. */
class SpaceVoronoiBuilder
{
public:
  SpaceVoronoiBuilder(const PointList<3> &generators,
                      const ConvexPolyhedron &domain)
      : generators(generators), domain(domain),
        sites(generators.points, domain), vertices{sites, {}, {}}
  {
    const double cell_size =
        std::cbrt(domain.volume() / std::max(1U, sites.n_generators()));
    resolution =
        std::max(relative_resolution_in_space * cell_size,
                 unresolved_epsilons * std::numeric_limits<double>::epsilon() *
                     domain.largest_length());
  }

  CellFaces build()
  {
    check_generators();
    triangulate();
    make_vertices();
    make_faces();
    triangulation.clear();
    cut_faces();
    faces = without_small_features(faces, vertices, resolution);
    put_into_planes();
    CellFaces cells = cells_of(faces, vertices.places, sites.n_generators());
    cells.centres = generators.points;
    return cells;
  }

private:
  void check_generators() const
  {
    if (generators.points.empty())
      throw InputError("There are no points to make Voronoi cells of; give at "
                       "least one.");
    for (unsigned int c = 0; c < sites.n_generators(); ++c)
      if (!is_finite(generators.points[c]) ||
          !domain.contains(generators.points[c], resolution))
        throw InputError("The " + generators.describe(c) +
                         " is not inside the " + domain.description() +
                         "; remove it or enlarge the " + domain.shape() + ".");
  }

  void triangulate()
  {
    std::vector<std::pair<SpaceKernel::Point_3, unsigned int>> places;
    places.reserve(sites.n_points());
    for (unsigned int i = 0; i < sites.n_points(); ++i)
      places.emplace_back(kernel_point(sites.point(i)), i);
    triangulation.insert(places.begin(), places.end());
    if (triangulation.number_of_vertices() == sites.n_points())
      return;
    std::vector<bool> is_there(sites.n_points(), false);
    for (const auto vertex : triangulation.finite_vertex_handles())
      is_there[vertex->info()] = true;
    for (unsigned int c = 0; c < sites.n_generators(); ++c)
      if (!is_there[c])
        refuse(c, triangulation.nearest_vertex(places[c].first)->info());
  }

  [[noreturn]] void refuse(const unsigned int a, const unsigned int b) const
  {
    const unsigned int later = std::max(a, b), earlier = std::min(a, b);
    const double distance = sites.point(a).distance(sites.point(b));
    if (distance == 0.)
      throw InputError("The " + generators.describe(later) +
                       " coincides with " + generators.describe(earlier) +
                       "; each cell needs a point of its own.");
    throw InputError(text(
        "The ", generators.describe(later), " is only ", distance,
        " away from ", generators.describe(earlier), "; at this size of the ",
        domain.shape(), " points must be ",
        least_generator_distance * resolution, " apart; move or remove one."));
  }

  /** One in each tetrahedron that has a generator. */
  void make_vertices()
  {
    auto &places = vertices.places;
    places.reserve(triangulation.number_of_cells());
    for (const auto cell : triangulation.finite_cell_handles())
    {
      const VertexName name = name_of(cell);
      if (name[0] >= sites.n_generators())
        continue;
      cell->info() = places.size();
      places.push_back(sites.place(name));
      is_inside.push_back(sites.is_surely_inside(places.back()));
    }
  }

  static VertexName name_of(const Tetrahedra::Cell_handle cell)
  {
    VertexName name;
    for (unsigned int i = 0; i < 4; ++i)
      name[i] = cell->vertex(i)->info();
    std::sort(name.begin(), name.end());
    return name;
  }

  /** The dual of each edge that has a generator. */
  void make_faces()
  {
    const double least = least_generator_distance * resolution;
    for (const auto &edge : triangulation.finite_edges())
    {
      const auto a = edge.first->vertex(edge.second);
      const auto b = edge.first->vertex(edge.third);
      if (std::min(a->info(), b->info()) >= sites.n_generators())
        continue;
      // The nearest neighbour of a point is one of its Delaunay neighbours.
      if (CGAL::squared_distance(a->point(), b->point()) < least * least)
        refuse(a->info(), b->info());
      if (a->info() < b->info())
        make_face(edge.first, a, b);
      else
        make_face(edge.first, b, a);
    }
  }

  /**
   * The face between two sites, counterclockwise as seen from the second.
   *
   * @param begin a tetrahedron that has both.
   */
  void make_face(const Tetrahedra::Cell_handle begin,
                 const Tetrahedra::Vertex_handle from,
                 const Tetrahedra::Vertex_handle to)
  {
    loop.clear();
    bool is_inside_as_a_whole = true;
    Tetrahedra::Cell_handle cell = begin;
    do
    {
      const int i = cell->index(from), j = cell->index(to);
      const int left = Tetrahedra::next_around_edge(i, j);
      loop.push_back({cell->info(), cell->vertex(6 - i - j - left)->info()});
      is_inside_as_a_whole &= is_inside[cell->info()];
      cell = cell->neighbor(left);
    } while (cell != begin);

    const std::array<unsigned int, 2> sides = {{from->info(), to->info()}};
    if (is_inside_as_a_whole)
      add_face(sides, {loop.data(), loop.size()});
    else
    {
      reaching_out.corners.insert(reaching_out.corners.end(), loop.begin(),
                                  loop.end());
      reaching_out.end_face(sides);
    }
  }

  void add_face(const std::array<unsigned int, 2> &sides,
                const dealii::ArrayView<const CutCorner> corners)
  {
    for (const CutCorner &corner : corners)
      faces.corners.push_back(corner.vertex);
    faces.end_face(sides);
  }

  void cut_faces()
  {
    FaceCutter cutter(sites, vertices.places);
    for (unsigned int k = 0; k < domain.n_planes(); ++k)
      reaching_out = cutter.cut(reaching_out, k);
    for (unsigned int f = 0; f < reaching_out.size(); ++f)
      add_face(reaching_out.sides[f], reaching_out[f]);
    reaching_out = {};
    vertices.n_planes.resize(vertices.places.size());
    for (unsigned int v = 0; v < vertices.places.size(); ++v)
      vertices.n_planes[v] = cutter.n_planes(v);
  }

  /** For vertices that were joined near an edge of the domain. */
  void put_into_planes()
  {
    for (unsigned int f = 0; f < faces.size(); ++f)
    {
      if (!sites.is_plane(faces.sides[f][1]))
        continue;
      const unsigned int k = faces.sides[f][1] - sites.n_points();
      const unsigned int axis = domain.plane(k).axis;
      if (axis != invalid_index)
        for (const unsigned int v : faces[f])
          vertices.places[v][axis] = domain.origin(k)[axis];
    }
  }

  const PointList<3> &generators;
  const ConvexPolyhedron &domain;
  const VoronoiSites sites;
  /** The least width of a face; a length. */
  double resolution = 0.;

  Tetrahedra triangulation;
  /** First those of the tetrahedra, in their order. */
  FaceVertices vertices;
  /** Of these, those that no plane can cut off. */
  std::vector<bool> is_inside;
  /** The faces that are ready. */
  VertexFaces faces;
  /** Those that reach beyond a plane. */
  SiteFaces<CutCorner> reaching_out;
  /** The face that is being made. */
  std::vector<CutCorner> loop;
};
} // namespace

CellFaces voronoi_cells(const PointList<3> &generators,
                        const ConvexPolyhedron &domain)
{
  return SpaceVoronoiBuilder(generators, domain).build();
}
} // namespace Voussoir
