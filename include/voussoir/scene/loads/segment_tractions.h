// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_segment_tractions_h
#define voussoir_scene_loads_segment_tractions_h

#include <voussoir/packing/packing.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace Voussoir
{
/** The traction on the edges of the boundary. */
struct EdgeTractions
{
  /** No traction on @p n_edges edges. */
  explicit EdgeTractions(unsigned int n_edges)
      : mean(n_edges), first_moment(n_edges)
  {}

  /** g_e, the mean over each edge; S. */
  std::vector<dealii::Tensor<1, 2>> mean;
  /**
   * The integral over each edge of the traction times the distance along it
   * from its middle, positive towards its end; S L^2.
   */
  std::vector<dealii::Tensor<1, 2>> first_moment;
};

/** A traction that varies linearly along a straight line. */
struct SegmentTraction
{
  /** @{ */
  /** The ends; lengths. */
  dealii::Point<2> start;
  dealii::Point<2> end;
  /** @} */
  /** @{ */
  /** The traction there; S. */
  dealii::Tensor<1, 2> at_start;
  dealii::Tensor<1, 2> at_end;
  /** @} */

  /** A force of the traction, and where it acts; a length and S L. */
  using Part = std::pair<dealii::Point<2>, dealii::Tensor<1, 2>>;
  /**
   * Two forces of the same sum and moment as the traction: those of its two
   * triangles, each at a third of the line from the end where it is largest.
   */
  std::array<Part, 2> resultants() const;
};

/** Two finite numbers "a, b"; nothing if the text is anything else. */
std::optional<dealii::Point<2>> pair_of_text(const std::string &text);

/**
 * Read a list "x, y to x, y: g_x, g_y; ...", or "...: g_x, g_y to g_x, g_y" for
 * a traction that varies.
 *
 * @throws InputError naming @p parameter if it is not of that form.
 */
std::vector<SegmentTraction>
segment_tractions_of_text(const std::string &list,
                          const std::string &parameter);

/**
 * Add the traction on a line to that on the boundary edges it runs along, cut
 * at its ends. Edges may be off the line by a millionth of its length, for
 * coordinates written with few digits.
 *
 * @throws InputError naming @p parameter if a part of the line is on no edge of
 *   the boundary, or on two.
 */
void add_segment_traction(const Packing<2> &packing,
                          const SegmentTraction &segment,
                          const std::string &parameter,
                          EdgeTractions &tractions);
} // namespace Voussoir

#endif
