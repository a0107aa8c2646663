// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_loads_resultant_h
#define voussoir_scene_loads_resultant_h

#include <voussoir/base/geometry.h>
#include <voussoir/packing/packing.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <cmath>

namespace Voussoir
{
/** The sum of forces, and of their moments about a point. */
class Resultant
{
public:
  /** Of no forces. @param about a point among them, a length. */
  explicit Resultant(const dealii::Point<2> &about) : about(about) {}

  /**
   * Add the force @p f that acts at a place, and a @p couple, positive
   * counterclockwise; S L and S L^2.
   */
  void add(const dealii::Point<2> &place,
           const dealii::Tensor<1, 2> &f,
           const double couple = 0.)
  {
    sum += f;
    sum_of_moments += cross(place - about, f) + couple;
    sum_of_sizes += f.norm();
  }

  /**
   * Add the traction on an edge.
   *
   * @param mean of it, a stress.
   * @param first_moment EdgeTractions::first_moment, S L^2.
   */
  void add(const Packing<2>::BoundaryEdge &edge,
           const dealii::Tensor<1, 2> &mean,
           const dealii::Tensor<1, 2> &first_moment)
  {
    add(edge.midpoint(), edge.length * mean,
        cross((edge.end - edge.start) / edge.length, first_moment));
  }

  /** Add @p factor times another one about the same point. */
  void add(const double factor, const Resultant &other)
  {
    sum += factor * other.sum;
    sum_of_moments += factor * other.sum_of_moments;
    sum_of_sizes += std::abs(factor) * other.sum_of_sizes;
  }

  /** The sum of the forces; S L. */
  const dealii::Tensor<1, 2> &force() const { return sum; }
  /** The sum of their moments, positive counterclockwise; S L^2. */
  double moment() const { return sum_of_moments; }
  /** The sum of their sizes; S L. */
  double size() const { return sum_of_sizes; }

private:
  dealii::Point<2> about;
  dealii::Tensor<1, 2> sum;
  double sum_of_moments = 0., sum_of_sizes = 0.;
};
} // namespace Voussoir

#endif
