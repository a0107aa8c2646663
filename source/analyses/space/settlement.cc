// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/ranges/settlement.h>
#include <voussoir/analyses/space/settlement.h>
#include <voussoir/base/text.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace
{
/** A jump, over the largest displacement of a support, that is one. */
constexpr double least_jump_of_face = 1e-6;

/** How many interfaces a settlement opens or lets slide. */
struct CountOfFaceJumps
{
  CountOfFaceJumps(const SpaceScene &scene,
                   const SettlementOf<SpaceScene> &settlement)
  {
    const double least = least_jump_of_face * settlement.largest_displacement;
    for (const FaceJump &jump :
         jumps_of_faces(*scene.blocks, settlement.motion))
    {
      open += jump.least_opening > least;
      hinges += jump.least_opening <= least && jump.greatest_opening > least;
      sliding += jump.largest_slip > least;
    }
  }

  unsigned int open = 0;    /**< at all vertices */
  unsigned int hinges = 0;  /**< at some of them only */
  unsigned int sliding = 0; /**< along themselves */
};
} // namespace

void settle(SpaceAnswer &answer,
            const std::vector<SpaceSupportMotion> &of_supports,
            Terminal &terminal)
{
  terminal.begin("Settlement");
  SettlementOf<SpaceScene> found = find_settlement(answer.scene, of_supports);
  const CountOfFaceJumps count(answer.scene, found);
  const std::string words =
      text("supports move by at most ", found.largest_displacement,
           "; interfaces with a hinge: ", count.hinges, ", open: ", count.open,
           ", sliding: ", count.sliding);
  terminal.stage("Settlement", words);
  answer.lines.emplace_back("Settlement", words);
  answer.summary["formulation"] = "settlement";
  answer.summary["selection"] =
      "forces that go with the displacement of the supports";
  answer.summary["settlement"] = {
      {"largest_displacement", found.largest_displacement},
      {"work", found.work},
      {"width", found.width},
      {"closing_violation", found.closing_violation},
      {"hinges", count.hinges},
      {"open", count.open},
      {"sliding", count.sliding}};
  answer.forces = std::move(found.forces);
  answer.motion = std::move(found.motion);
  judge_forces(answer);
}
} // namespace Voussoir
