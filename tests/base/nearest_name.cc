// SPDX-License-Identifier: LGPL-2.1-or-later

// The distance of two texts is a metric with known values, and names that are
// far from all others are near to none.

#include <voussoir/base/nearest_name.h>

#include "tests.h"

namespace test_nearest_name
{
using namespace Voussoir;

void run()
{
  check("equal texts", edit_distance("Strength", "strength") == 0);
  check("exchanged letters", edit_distance("Strenght", "Strength") == 2);
  check("known ones", edit_distance("kitten", "sitting") == 3 &&
                          edit_distance("", "abc") == 3 &&
                          edit_distance("abc", "") == 3);
  const std::vector<std::string> words = {
      "Strength", "Stress", "Where", "", "Body force", "Cell forces"};
  bool is_metric = true;
  for (const auto &a : words)
    for (const auto &b : words)
      for (const auto &c : words)
        is_metric =
            is_metric && edit_distance(a, b) == edit_distance(b, a) &&
            edit_distance(a, c) <= edit_distance(a, b) + edit_distance(b, c);
  check("a metric", is_metric);

  const std::vector<std::string> paths = {
      "Friction/Strength", "Loads/Stress", "Loads/Body force",
      "Live loads/Body force", "Supports/Where"};
  using Names = std::vector<std::string>;
  check("the nearest",
        nearest_names("Strenght", paths) == Names{"Friction/Strength"});
  check("both of one name",
        nearest_names("Body forces", paths) ==
            Names({"Loads/Body force", "Live loads/Body force"}));
  check("not more than are wanted",
        nearest_names("Body forces", paths, 1).size() == 1);
  check("of whole texts",
        nearest_texts("Load/Stress", paths) == Names{"Loads/Stress"} &&
            nearest_texts("Stress", paths).empty());
  // Letter by letter this would take many minutes.
  check("none of a name as long as a file",
        nearest_names(std::string(100000000, 'x'),
                      std::vector<std::string>(300, paths[0]))
            .empty());
  check("none", nearest_names("Elasticity", paths).empty() &&
                    nearest_names("x", paths).empty());
}

const RoomTest test("nearest_name", run);
} // namespace test_nearest_name
