// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/parameters/parameters.h>
#include <voussoir/packing/polyhedra/generators/block_resolution.h>
#include <voussoir/packing/polyhedra/generators/cross_vault.h>
#include <voussoir/packing/polyhedra/generators/groined_bay.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
/**
 * The shortest extension that is not 0, over the thickness of the arch: blocks
 * that are shorter beyond the corner carry nothing, and have slender faces.
 */
constexpr double shortest_extension = 0.01;

/** The shortest side of the intrados, with that of a keystone. */
double shortest_chord(const HalfArch &arch)
{
  const double crown = -2. * arch.joints.back().intrados[0];
  double shortest = crown > 0. ? crown : std::numeric_limits<double>::max();
  for (unsigned int k = 1; k < arch.joints.size(); ++k)
    shortest =
        std::min(shortest,
                 arch.joints[k - 1].intrados.distance(arch.joints[k].intrados));
  return shortest;
}
} // namespace

void CrossVaultGenerator::add_parameters(dealii::ParameterHandler &prm)
{
  using namespace dealii::Patterns;
  profile.add_parameters(prm);
  prm.add_parameter("Extension", extension,
                    "How far the webs go on beyond the square over the "
                    "springings; a length, 0 or at least a hundredth of "
                    "'Thickness'.",
                    Double(0.));
  prm.add_parameter("Depth over width", depth_over_width,
                    "Extent of the bay along y over that along x, which the "
                    "arch has; positive. If it is not 1, all is stretched "
                    "along y.",
                    Double(0.));
  prm.add_parameter("Blocks", n_blocks,
                    "Number of blocks along a web, from the middle of the "
                    "bay to its end.",
                    Integer(1, 1000000));
  add_choice<Bond>(prm, "Bond", bond,
                   {{Bond::running, "running",
                     "every second course is shifted by half a block."},
                    {Bond::stack, "stack",
                     "the head joints of all courses are in one "
                     "plane."}},
                   "How the blocks of a course overlap those of the next.");
  add_choice<bool>(
      prm, "Groins", mitred,
      {{false, "blocks",
        "a block of each course goes over the groin, with a leg in either "
        "web."},
       {true, "mitre joints", "the blocks of both webs end at the groin."}},
      "How the webs meet.");
}

CellFaces CrossVaultGenerator::generate(const std::filesystem::path &,
                                        Terminal &) const
{
  const HalfArch arch = profile.joints();
  check_measures("Packing/cross vault",
                 {{"Depth over width", depth_over_width}});
  if (!std::isfinite(extension) || extension < 0. ||
      (extension > 0. && extension < shortest_extension * profile.thickness()))
    throw InputError(text("'Packing/cross vault/Extension' is ", extension,
                          "; it must be 0, or finite and at least ",
                          shortest_extension * profile.thickness(),
                          ", a hundredth of the thickness."));
  check_number_of_cells(4. * profile.n_voussoirs() * (n_blocks + 1.),
                        "'Packing/cross vault/Voussoirs' and 'Blocks'");

  GroinedBay bay;
  bay.half_width = extension - arch.joints.front().extrados[0];
  bay.depth_over_width = depth_over_width;
  bay.n_blocks = n_blocks;
  bay.bond = bond;
  bay.mitred = mitred;
  const double shrunk = std::min(1., depth_over_width);
  check_resolution(
      "Packing/cross vault",
      {{"'Thickness' and 'Depth over width'", shrunk * profile.thickness()},
       {"'Voussoirs' and 'Thickness'", shrunk * shortest_chord(arch)},
       {"'Blocks'", shrunk * bay.half_width / (2. * n_blocks)}},
      std::max(std::max(1., depth_over_width) * bay.half_width,
               arch.joints.back().extrados[1]));
  return cells_of_bay(arch, bay);
}
} // namespace Voussoir
