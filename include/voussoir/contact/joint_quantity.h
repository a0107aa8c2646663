// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_contact_joint_quantity_h
#define voussoir_contact_joint_quantity_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polyhedra/packing.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * A quantity that two parameters of a section give to the interfaces: an
 * expression in x, y, in space z, and the unit normal for all of them, and
 * others for pairs of groups. Their present values are the defaults.
 */
struct JointQuantity
{
  /** The word for it, behind "a". */
  std::string word;
  /** The section. */
  std::string section;
  /** @{ */
  /** The value for all interfaces, or a list for each, and its parameter. */
  std::string everywhere;
  std::string parameter;
  /** @} */
  /** @{ */
  /** The values for pairs, and their parameter. */
  std::string of_pairs;
  std::string parameter_of_pairs;
  /** @} */
  /** False if it may be zero. */
  bool is_positive = false;
  /** True if nothing stands for an infinite value; else it is refused. */
  bool may_be_empty = false;

  /** Declare the two parameters in @p prm, which is in the section. */
  void add_parameters(dealii::ParameterHandler &prm,
                      const std::string &documentation,
                      const std::string &documentation_of_pairs);
};

/**
 * The mean of a quantity over each of the interfaces of @p packing.
 *
 * @param warnings on means that are not exact are added.
 * @throws InputError naming the interface if a value is negative, or zero where
 *   that is refused, or not a finite number, or varies too fast for its mean;
 *   if a formula cannot be parsed; if a list has not one number for each; or
 * naming a pair of groups that does not exist, is given twice or meets nowhere.
 */
template <int dim>
std::vector<double> means(const Packing<dim> &packing,
                          const JointQuantity &quantity,
                          std::vector<std::string> &warnings);

/** The interfaces of a packing, in the plane or in space, as laws see them. */
class JointMeans
{
public:
  virtual ~JointMeans() = default;
  /** means() of the packing. */
  virtual std::vector<double>
  operator()(const JointQuantity &quantity,
             std::vector<std::string> &warnings) const = 0;
  /** The middle of interface @p e, for messages. */
  virtual std::string place(unsigned int e) const = 0;
};
} // namespace Voussoir

#endif
