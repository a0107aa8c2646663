// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/stress/shared_tetrahedra.h>

#include <numeric>

namespace Voussoir
{
using dealii::Point;

namespace
{
/** The cells of one process, as lists of plain data. */
struct CellMessage
{
  std::vector<StressedCell> cells;
  std::vector<FaceLoad> faces;
  /** The number of faces of each cell, of polygons of each face, and of
   * vertices of each polygon. */
  std::vector<unsigned int> n_faces, n_polygons, n_vertices;
  std::vector<Point<3>> vertices;

  void add(const StressedCell &cell, const std::vector<LoadedFace> &of);
  std::vector<std::vector<LoadedFace>> loaded_faces() const;
};

void CellMessage::add(const StressedCell &cell,
                      const std::vector<LoadedFace> &of)
{
  cells.push_back(cell);
  n_faces.push_back(of.size());
  for (const LoadedFace &face : of)
  {
    faces.push_back(face);
    n_polygons.push_back(face.polygons.size());
    for (const auto &polygon : face.polygons)
    {
      n_vertices.push_back(polygon.size());
      vertices.insert(vertices.end(), polygon.begin(), polygon.end());
    }
  }
}

/** Of each cell; with views of the vertices here. */
std::vector<std::vector<LoadedFace>> CellMessage::loaded_faces() const
{
  std::vector<std::vector<LoadedFace>> of_cells;
  auto face = faces.begin();
  auto polygons = n_polygons.begin();
  auto size = n_vertices.begin();
  const Point<3> *next = vertices.data();
  for (const unsigned int n : n_faces)
  {
    of_cells.emplace_back();
    for (unsigned int f = 0; f < n; ++f, ++face, ++polygons)
    {
      of_cells.back().push_back({*face});
      for (unsigned int p = 0; p < *polygons; ++p, ++size)
      {
        of_cells.back().back().polygons.emplace_back(next, *size);
        next += *size;
      }
    }
  }
  return of_cells;
}

/** Visit all lists of a message. */
template <typename MessageType, typename Visitor>
void for_each_list_of(MessageType &message, const Visitor &visit)
{
  visit(message.cells);
  visit(message.faces);
  visit(message.n_faces);
  visit(message.n_polygons);
  visit(message.n_vertices);
  visit(message.vertices);
}

TetrahedralStress stress_of(const CellMessage &message)
{
  return tetrahedral_stress(message.cells, message.loaded_faces());
}

/** The number of tetrahedra of each cell. */
std::vector<std::size_t> numbers_of_tetrahedra(const TetrahedralStress &of)
{
  std::vector<std::size_t> numbers(of.first.size());
  std::adjacent_difference(of.first.begin(), of.first.end(), numbers.begin());
  return {numbers.begin() + 1, numbers.end()};
}
} // namespace

TetrahedralStress
tetrahedral_stress(const SpaceScene &scene,
                   const FaceForces &forces,
                   const std::vector<dealii::Tensor<2, 3>> &means,
                   const ProcessGroup &processes)
{
  if (processes.size() == 1)
    return tetrahedral_stress(scene, forces, means);
  processes.call(tetrahedra_task);
  return processes.together([&]() {
    const auto cells = stressed_cells(scene, means);
    const auto faces = loaded_faces(scene, forces);
    CellMessage message;
    // Its own last, so that no more than two are held at a time.
    std::vector<std::size_t> begin;
    for (unsigned int r = 0; r <= processes.size(); ++r)
      begin.push_back(cells.size() * r / processes.size());
    for (unsigned int r = processes.size(); r-- > 0;)
    {
      message = {};
      for (std::size_t c = begin[r]; c < begin[r + 1]; ++c)
        message.add(cells[c], faces[c]);
      if (r > 0)
        for_each_list_of(message,
                         [&](const auto &list) { processes.send(list, r); });
    }
    const TetrahedralStress own = stress_of(message);
    const auto lists = processes.gather(own.list);
    const auto numbers = processes.gather(numbers_of_tetrahedra(own));
    const auto undetermined = processes.gather(own.undetermined);
    TetrahedralStress all;
    std::size_t n = 0;
    for (const auto &list : lists)
      n += list.size();
    all.list.reserve(n);
    for (unsigned int r = 0; r < processes.size(); ++r)
    {
      all.list.insert(all.list.end(), lists[r].begin(), lists[r].end());
      for (const std::size_t n : numbers[r])
        all.first.push_back(all.first.back() + n);
      for (const unsigned int c : undetermined[r])
        all.undetermined.push_back(begin[r] + c);
    }
    return all;
  });
}

void work_on_tetrahedra(const ProcessGroup &processes)
{
  processes.together([&]() {
    CellMessage message;
    for_each_list_of(message, [&](auto &list) {
      list =
          processes.receive<typename std::decay_t<decltype(list)>::value_type>(
              0);
    });
    const TetrahedralStress own = stress_of(message);
    processes.gather(own.list);
    processes.gather(numbers_of_tetrahedra(own));
    processes.gather(own.undetermined);
  });
}
} // namespace Voussoir
