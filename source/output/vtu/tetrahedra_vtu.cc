// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/vtu/tetrahedra_vtu.h>
#include <voussoir/output/vtu/vtu_file.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace Voussoir
{
namespace
{
/** The cell that has tetrahedron @p t. */
unsigned int cell_of(const TetrahedralStress &stress, const std::size_t t)
{
  return std::upper_bound(stress.first.begin(), stress.first.end(), t) -
         stress.first.begin() - 1;
}
} // namespace

void write_tetrahedra_vtu(std::ostream &out, const SpaceResults &results)
{
  const TetrahedralStress &stress = *results.tetrahedra;
  const Packing<3> &packing = results.scene.packing();
  const std::size_t n = stress.list.size();
  // The last one is above the others, if these run around from there.
  static constexpr unsigned int order[] = {1, 2, 3, 0};
  const auto corner = [&stress](const std::size_t i) {
    return stress.list[i / 4].corners[order[i % 4]];
  };
  VtuFile grid = VtuFile::separate(
      VtuFile::Shape::tetrahedron,
      {4 * n,
       [corner](std::size_t i, const std::size_t end, double *place) {
         for (; i < end; ++i)
         {
           const dealii::Point<3> x = corner(i);
           place = std::copy(x.begin_raw(), x.end_raw(), place);
         }
       }},
      {n, [](std::size_t t, const std::size_t end, std::int64_t *place) {
         for (; t < end; ++t)
           *place++ = 4 * (t + 1);
       }});
  const auto add = [&grid](const std::string &name, const unsigned int size,
                           const auto &of) {
    using Number = std::decay_t<decltype(*of(0).begin())>;
    grid.add_cell_field<Number>(
        name, size, [of](std::size_t t, const std::size_t end, Number *place) {
          for (; t < end; ++t)
            for (const Number value : of(t))
              *place++ = value;
        });
  };
  add("stress", 9, [&stress](const std::size_t t) {
    std::array<double, 9> values;
    const dealii::Tensor<2, 3> &sigma = stress.list[t].stress;
    for (unsigned int i = 0; i < 9; ++i)
      values[i] = sigma[i / 3][i % 3];
    return values;
  });
  add("principal_stress_1", 1, [&stress](const std::size_t t) {
    return std::array<double, 1>{
        {principal_stresses(stress.list[t].stress).greatest}};
  });
  add("principal_stress_3", 1, [&stress](const std::size_t t) {
    return std::array<double, 1>{
        {principal_stresses(stress.list[t].stress).least}};
  });
  add("skew", 1, [&stress](const std::size_t t) {
    const dealii::Tensor<2, 3> &sigma = stress.list[t].stress;
    return std::array<double, 1>{
        {0.5 / std::sqrt(2.) * (sigma - transpose(sigma)).norm()}};
  });
  add("div", 3, [&stress](const std::size_t t) {
    const dealii::Tensor<1, 3> &div = stress.list[t].divergence;
    return std::array<double, 3>{{div[0], div[1], div[2]}};
  });
  add("cell", 1, [&stress](const std::size_t t) {
    return std::array<std::int32_t, 1>{{std::int32_t(cell_of(stress, t))}};
  });
  add("group", 1, [&stress, &packing](const std::size_t t) {
    return std::array<std::int32_t, 1>{
        {std::int32_t(packing.group(cell_of(stress, t)))}};
  });
  add("reconstructed", 1, [&stress](const std::size_t t) {
    return std::array<std::uint8_t, 1>{{std::uint8_t(
        !std::binary_search(stress.undetermined.begin(),
                            stress.undetermined.end(), cell_of(stress, t)))}};
  });
  grid.add_point_vector(
      "displacement",
      [&, corner](std::size_t i, const std::size_t end, double *place) {
        for (; i < end; ++i)
        {
          const unsigned int c = cell_of(stress, i / 4);
          const dealii::Tensor<1, 3> u =
              results.motion.displacement.empty()
                  ? dealii::Tensor<1, 3>()
                  : results.motion.at(c, corner(i) - packing.centre(c));
          place = std::copy(u.begin_raw(), u.end_raw(), place);
        }
      });
  grid.write(out);
}
} // namespace Voussoir
