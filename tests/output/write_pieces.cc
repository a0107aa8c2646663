// SPDX-License-Identifier: LGPL-2.1-or-later

// Writes the stress of a packing whole and in three pieces, one of which is a
// single cell, for read_with_paraview.py. Every value is made up of the numbers
// of its cell and sub-cell, so that it shows whether it is in its place.

#include <voussoir/output/vtu/stress_vtu.h>
#include <voussoir/packing/cell_range.h>
#include <voussoir/packing/voronoi/random_points.h>
#include <voussoir/packing/voronoi/voronoi_cells.h>

#include <filesystem>
#include <fstream>
#include <type_traits>

using namespace Voussoir;

int main(int argc, char **argv)
{
  AssertThrow(argc == 2, dealii::ExcMessage("write_pieces DIRECTORY"));
  const std::filesystem::path directory = argv[1];
  std::filesystem::create_directories(directory);

  // Enough sub-cells for several blocks of compression.
  const unsigned int n_cells = 30000;
  const ConvexPolygon square(Rectangle{{0., 0.}, {1., 1.}});
  const Packing<2> packing(voronoi_cells(random_points(n_cells, 1), square));
  Motion motion;
  StressField stress;
  for (unsigned int c = 0; c < n_cells; ++c)
  {
    motion.displacement.push_back(
        dealii::Tensor<1, 2>({1. / 3. + c, 1. / 7. - c}));
    motion.rotation.push_back(0.5 * (c % 3));
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
    {
      SubCellStress s;
      s.stress =
          dealii::Tensor<2, 2>({{1. / 3. + c, 1. * i}, {-1. * c, 0.1 * i}});
      s.divergence = dealii::Tensor<1, 2>({1. * i, -0.1 * c});
      s.skew = 0.7 * c;
      stress.sub_cells.push_back(s);
    }
  }
  stress.undetermined = {1, n_cells - 1};

  const auto file = [&](const std::string &name) {
    return std::ofstream(directory / name);
  };
  auto whole = file("stress.vtu");
  write_stress_vtu(whole, {packing, stress, motion});
  std::vector<std::string> names;
  unsigned int begin = 0;
  for (const unsigned int end : {10000U, 10001U, n_cells})
  {
    names.push_back("stress_" + std::to_string(names.size()) + ".vtu");
    auto piece = file(names.back());
    const Packing<2> cells(cut_free(packing, {begin, end}));
    StressField inside;
    inside.sub_cells.assign(
        stress.sub_cells.begin() + stress.first(packing, begin, 0),
        stress.sub_cells.begin() + stress.first(packing, end, 0));
    inside.undetermined = stress.undetermined;
    const auto of_piece = [&](const auto &all) {
      return std::decay_t<decltype(all)>(all.begin() + begin,
                                         all.begin() + end);
    };
    Motion part;
    part.displacement = of_piece(motion.displacement);
    part.rotation = of_piece(motion.rotation);
    write_stress_vtu(piece, {cells, inside, part, begin});
    begin = end;
  }
  auto record = file("stress.pvtu");
  write_stress_pvtu(record, {packing, stress, motion}, names);
}
