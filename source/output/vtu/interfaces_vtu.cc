// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/vtu/interfaces_vtu.h>
#include <voussoir/output/vtu/vtu_file.h>
#include <voussoir/output/vtu/vtu_values.h>
#include <voussoir/scene/proofs/displacement_jumps.h>
#include <voussoir/scene/proofs/utilisation.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace Voussoir
{
using VtuValues::scalar;
using VtuValues::vector;

namespace
{
/** A grid of one line for each interface. */
VtuFile lines_of(const std::vector<Packing::Interface> &interfaces)
{
  const auto points = [&](std::size_t p, std::size_t end, double *place) {
    for (; p < end; ++p)
    {
      const Packing::Interface &i = interfaces[p / 2];
      const auto x = vector(p % 2 == 0 ? i.start : i.end);
      place = std::copy(x.begin(), x.end(), place);
    }
  };
  const auto ends = [](std::size_t e, std::size_t end, std::int64_t *place) {
    for (; e < end; ++e)
      *place++ = 2 * (e + 1);
  };
  return VtuFile::separate(VtuFile::Shape::line,
                           {2 * interfaces.size(), points},
                           {interfaces.size(), ends});
}
/** A mark of interfaces whose ranges are not asked for. */
constexpr std::int32_t not_wanted = -1;

/**
 * Add the ranges by @p add. ParaView draws no infinite numbers: where there is
 * no bound, or none is asked for, the force itself takes its place.
 */
template <typename Add>
void add_ranges(const std::vector<Packing::Interface> &interfaces,
                const Ranges &ranges,
                const InterfaceForces &forces,
                const Add &add)
{
  const auto value = [&ranges](const std::size_t e, const double bound,
                               const double force) {
    return scalar(ranges.wanted[e] && std::isfinite(bound) ? bound : force);
  };
  add("p_min", [&ranges, &forces, value](std::size_t e) {
    return value(e, 0. - ranges.normal[e].greatest, 0. - forces.normal[e]);
  });
  add("p_max", [&ranges, &forces, value](std::size_t e) {
    return value(e, 0. - ranges.normal[e].least, 0. - forces.normal[e]);
  });
  add("q_min", [&ranges, &forces, value](std::size_t e) {
    return value(e, ranges.tangential[e].least, forces.tangential[e]);
  });
  add("q_max", [&ranges, &forces, value](std::size_t e) {
    return value(e, ranges.tangential[e].greatest, forces.tangential[e]);
  });
  if (!ranges.eccentricity.empty())
  {
    const auto place = [&ranges, &forces, &interfaces](const std::size_t e,
                                                       const double end) {
      return scalar(ranges.wanted[e] && !std::isnan(end)
                        ? end
                        : forces.eccentricity(interfaces[e], e));
    };
    add("e_min", [&ranges, place](std::size_t e) {
      return place(e, ranges.eccentricity[e].least);
    });
    add("e_max", [&ranges, place](std::size_t e) {
      return place(e, ranges.eccentricity[e].greatest);
    });
  }
  if (ranges.are_inner)
  {
    add("p_beyond",
        [&ranges](std::size_t e) { return scalar(ranges.normal[e].beyond); });
    add("q_beyond", [&ranges](std::size_t e) {
      return scalar(ranges.tangential[e].beyond);
    });
  }
  add("determined", [&ranges](std::size_t e) {
    return scalar(ranges.wanted[e] ? std::int32_t(ranges.is_determined(e))
                                   : not_wanted);
  });
  add("unbounded", [&ranges](std::size_t e) {
    return scalar(ranges.wanted[e] ? std::int32_t(ranges.is_unbounded(e))
                                   : not_wanted);
  });
}

template <typename Add>
void add_samples(const StateSamples &samples, const Add &add)
{
  add("p_mean", [&samples](std::size_t e) {
    return scalar(0. - samples.normal[e].mean);
  });
  add("p_mean_error",
      [&samples](std::size_t e) { return scalar(samples.normal[e].error); });
  add("p_deviation", [&samples](std::size_t e) {
    return scalar(samples.normal[e].deviation);
  });
  add("q_mean",
      [&samples](std::size_t e) { return scalar(samples.tangential[e].mean); });
  add("q_mean_error", [&samples](std::size_t e) {
    return scalar(samples.tangential[e].error);
  });
  add("q_deviation", [&samples](std::size_t e) {
    return scalar(samples.tangential[e].deviation);
  });
}
} // namespace

void write_interfaces_vtu(std::ostream &out, const Results &results)
{
  const Scene &scene = results.scene;
  const InterfaceForces &forces = results.forces;
  const auto &interfaces = scene.packing.interfaces();
  VtuFile file = lines_of(interfaces);
  const auto add = [&](const std::string &name, const auto &value) {
    VtuValues::add_cell_field(file, name, value);
  };
  add("force", [&](std::size_t e) {
    return vector(forces.on_cell_minus(interfaces[e], e));
  });
  add("normal_force", [&](std::size_t e) { return scalar(forces.normal[e]); });
  add("tangential_force",
      [&](std::size_t e) { return scalar(forces.tangential[e]); });
  add("normal_stress", [&](std::size_t e) {
    return scalar(forces.normal[e] / interfaces[e].length);
  });
  add("tangential_stress", [&](std::size_t e) {
    return scalar(forces.tangential[e] / interfaces[e].length);
  });
  if (scene.turns())
  {
    add("normal_force_0",
        [&](std::size_t e) { return scalar(forces.at_ends[e][0]); });
    add("normal_force_1",
        [&](std::size_t e) { return scalar(forces.at_ends[e][1]); });
    add("eccentricity", [&](std::size_t e) {
      return scalar(forces.eccentricity(interfaces[e], e));
    });
  }
  add("strength", [&](std::size_t e) { return scalar(scene.strength[e]); });
  const Utilisation utilisation(scene, forces);
  add("utilisation",
      [utilisation](std::size_t e) { return scalar(utilisation(e)); });
  add("cell_minus", [&](std::size_t e) {
    return scalar(std::int32_t(interfaces[e].cell_minus));
  });
  add("cell_plus", [&](std::size_t e) {
    const unsigned int plus = interfaces[e].cell_plus;
    return scalar(plus == scene.packing.ground() ? -1 : std::int32_t(plus));
  });
  const auto add_mark = [&](const std::string &name,
                            const std::vector<bool> &marks) {
    if (!marks.empty())
      add(name,
          [&marks](std::size_t e) { return scalar(std::uint8_t(marks[e])); });
  };
  if (results.ranges)
    add_ranges(interfaces, *results.ranges, forces, add);
  if (results.samples && results.samples->have_settled())
    add_samples(*results.samples, add);
  add_mark("never_pressed", results.never_pressed);
  add_mark("always_sliding", results.always_sliding);
  file.write(out);
}

void write_mechanism_joints_vtu(std::ostream &out,
                                const Scene &scene,
                                const Motion &motion)
{
  VtuFile file = lines_of(scene.packing.interfaces());
  const InterfaceJumps jumps = jumps_of(scene.packing, motion);
  const auto add = [&](const std::string &name, const auto &value) {
    VtuValues::add_cell_field(file, name, value);
  };
  add("opening", [&](std::size_t e) {
    return scalar(0.5 * (jumps.openings[e][0] + jumps.openings[e][1]));
  });
  add("sliding", [&](std::size_t e) { return scalar(jumps.sliding[e]); });
  add("dissipation", [&](std::size_t e) {
    return scalar(scene.limits(e)
                      .resistance(jumps.openings[e], jumps.sliding[e])
                      .dissipation);
  });
  if (scene.turns())
    for (const unsigned int end : {0, 1})
      add("opening_" + std::to_string(end),
          [&, end](std::size_t e) { return scalar(jumps.openings[e][end]); });
  file.write(out);
}
} // namespace Voussoir
