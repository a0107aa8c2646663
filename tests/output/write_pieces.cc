// SPDX-License-Identifier: LGPL-2.1-or-later

// Writes the stress of a packing whole and in three pieces, one of which is a
// single cell, for read_with_paraview.py. Every value is made up of the numbers
// of its cell and sub-cell, so that it shows whether it is in its place.

#include <voussoir/output/vtu.h>
#include <voussoir/packing/random_points.h>
#include <voussoir/packing/voronoi_cells.h>

#include <filesystem>
#include <fstream>

using namespace Voussoir;

int main(int argc, char **argv)
{
  AssertThrow(argc == 2, dealii::ExcMessage("write_pieces DIRECTORY"));
  const std::filesystem::path directory = argv[1];
  std::filesystem::create_directories(directory);

  // Enough sub-cells for several blocks of compression.
  const unsigned int n_cells = 30000;
  const Rectangle rectangle = {{0., 0.}, {1., 1.}};
  Packing packing(voronoi_cells(random_points(n_cells, 1), rectangle));
  const std::vector<double> strength(packing.interfaces().size(), 1.);
  Loads loads;
  loads.traction.resize(packing.boundary_edges().size());
  const Scene scene(std::move(packing), strength, loads);

  Results results{RunRecord(scene)};
  for (unsigned int c = 0; c < n_cells; ++c)
  {
    results.displacement.push_back(
        dealii::Tensor<1, 2>({1. / 3. + c, 1. / 7. - c}));
    for (unsigned int i = 0; i < scene.packing.n_sides(c); ++i)
    {
      SubCellStress s;
      s.stress =
          dealii::Tensor<2, 2>({{1. / 3. + c, 1. * i}, {-1. * c, 0.1 * i}});
      s.divergence = dealii::Tensor<1, 2>({1. * i, -0.1 * c});
      s.skew = 0.7 * c;
      results.stress.sub_cells.push_back(s);
    }
  }
  results.stress.undetermined = {1, n_cells - 1};

  const auto file = [&](const std::string &name) {
    return std::ofstream(directory / name);
  };
  auto whole = file("stress.vtu");
  write_stress_vtu(whole, results);
  std::vector<std::string> names;
  unsigned int begin = 0;
  for (const unsigned int end : {10000U, 10001U, n_cells})
  {
    names.push_back("stress_" + std::to_string(names.size()) + ".vtu");
    auto piece = file(names.back());
    write_stress_piece(piece, results, {begin, end});
    begin = end;
  }
  auto record = file("stress.pvtu");
  write_stress_pvtu(record, results, names);
}
