// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_scene_proofs_face_function_h
#define voussoir_scene_proofs_face_function_h

#include <voussoir/scene/space/face_forces.h>

#include <deal.II/base/point.h>
#include <deal.II/base/tensor.h>

#include <vector>

namespace Voussoir
{
/**
 * A linear function of the forces of the interfaces in space: the work of those
 * on c- along a rigid motion of each interface. A displacement alone gives a
 * component of the resultant, an angle alone one of its moment.
 */
struct FaceFunction
{
  /** The motion of one interface, to first order in the angle. */
  struct Term
  {
    /** Its number. */
    unsigned int interface;
    /** At the place `about`. */
    dealii::Tensor<1, 3> displacement;
    /** The vector of the angle; one over a length for a force without unit. */
    dealii::Tensor<1, 3> rotation = {};
    /** A length. */
    dealii::Point<3> about = {};

    /** What a force at @p place is multiplied by. */
    dealii::Tensor<1, 3> at(const dealii::Point<3> &place) const
    {
      return displacement + cross_product_3d(rotation, place - about);
    }
  };
  /** Each interface has at most one. */
  std::vector<Term> terms;

  /** This function times @p factor. */
  FaceFunction times(double factor) const;
  /** Its value; S L^2 times the unit of its displacements. */
  double operator()(const FaceForces &forces) const;
  /** Of each of so many interfaces its term, or null. */
  std::vector<const Term *> by_interface(std::size_t n_interfaces) const;
};

/** The force on c- along n_e of interface @p e, negative in compression. */
FaceFunction normal_force(const Packing<3> &packing, unsigned int e);
/** Component @p i of the force on c- across n_e. */
FaceFunction
shear_force(const Packing<3> &packing, unsigned int e, unsigned int i);
} // namespace Voussoir

#endif
