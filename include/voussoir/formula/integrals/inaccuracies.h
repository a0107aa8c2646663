// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_formula_integrals_inaccuracies_h
#define voussoir_formula_integrals_inaccuracies_h

#include <deal.II/base/point.h>

#include <functional>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * The relative error of an integral, and the part of its domain on which it is
 * not known on which side of a jump it is, up to which a user need not know.
 */
constexpr double negligible_error = 1e-10;

/** The same over faces and cells in space, along whose jumps nothing is cut. */
constexpr double largest_error_in_space = 1e-2;

/** The integrals of one parameter that are not accurate, for the user. */
class Inaccuracies
{
public:
  /**
   * @param parameter its full name, such as "Loads/Traction".
   * @param largest_error the relative error with which an integral is worth
   *   nothing.
   */
  explicit Inaccuracies(const std::string &parameter,
                        double largest_error = 1e-6);

  /**
   * Look at an integral.
   *
   * @param error of it by estimate.
   * @param size the integral of the size of the function, in the same unit.
   * @param uncertain the part of the domain along which a jump runs.
   * @param where says what the domain is, as "in cell 3"; only asked if need
   * be.
   * @throws InputError if it is so inaccurate that it is worth nothing.
   */
  void look_at(double error,
               double size,
               double uncertain,
               const std::function<std::string()> &where);

  /** A sentence on each kind of them, or none. */
  std::vector<std::string> warnings() const;

private:
  /** The inaccuracies of one kind. */
  struct Kind
  {
    unsigned int number = 0;
    double largest = 0.;
    std::string where;

    void add(double size, const std::function<std::string()> &where);
  };

  std::string parameter;
  double largest_error;
  Kind inexact, undecided;
};
/** "along the edge from (0, 1) to (2, 1)", for look_at(). */
std::string along_edge(const dealii::Point<2> &a, const dealii::Point<2> &b);
} // namespace Voussoir

#endif
