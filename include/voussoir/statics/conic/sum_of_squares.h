// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_statics_conic_sum_of_squares_h
#define voussoir_statics_conic_sum_of_squares_h

#include <array>
#include <cstddef>

namespace Voussoir
{
/**
 * A positive sum of squares c (g . x)^2 of two rows, and its inverse, to all
 * digits however different the c are.
 */
class SumOfSquares
{
public:
  /** Add a square, by the first two coefficients of g. */
  void add(const double c, const std::array<double, 3> &of_rows)
  {
    const std::array<double, 2> g = {{of_rows[0], of_rows[1]}};
    for (std::size_t i = 0; i < n; ++i)
    {
      const Square &other = squares[i];
      const double volume = g[0] * other.g[1] - g[1] * other.g[0];
      det += c * other.c * (volume * volume);
    }
    squares[n++] = {c, g};
  }
  /** The three different entries of the inverse: 00, 01, 11. */
  std::array<double, 3> inverse() const
  {
    std::array<double, 3> sum = {};
    for (std::size_t i = 0; i < n; ++i)
    {
      const Square &square = squares[i];
      const double weight = square.c / det;
      sum[0] += weight * square.g[1] * square.g[1];
      sum[1] -= weight * square.g[0] * square.g[1];
      sum[2] += weight * square.g[0] * square.g[0];
    }
    return sum;
  }

private:
  struct Square
  {
    double c;
    std::array<double, 2> g;
  };
  /** Three of each of two cones, and two of a cost. */
  std::array<Square, 8> squares = {};
  std::size_t n = 0;
  double det = 0.;
};

/** The same of three rows. */
class SumOfSquaresOfThree
{
public:
  /** Add a square. */
  void add(const double c, const std::array<double, 3> &g)
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      const Vector3 normal = vector_product(g, squares[i].g);
      const double weight = c * squares[i].c;
      for (std::size_t j = 0; j < i; ++j)
      {
        const Vector3 &other = squares[j].g;
        const double volume =
            normal[0] * other[0] + normal[1] * other[1] + normal[2] * other[2];
        det += weight * squares[j].c * (volume * volume);
      }
      for (unsigned int k = 0; k < 3; ++k)
        for (unsigned int l = 0; l < 3; ++l)
          adjoint[3 * k + l] += weight * normal[k] * normal[l];
    }
    squares[n++] = {c, g};
  }
  /** Set the nine entries of the inverse. */
  void find_inverse(double *const inverse) const
  {
    for (unsigned int k = 0; k < 9; ++k)
      inverse[k] = adjoint[k] / det;
  }

private:
  using Vector3 = std::array<double, 3>;
  static Vector3 vector_product(const Vector3 &a, const Vector3 &b)
  {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
             a[0] * b[1] - a[1] * b[0]}};
  }
  struct Square
  {
    double c;
    Vector3 g;
  };
  /** Three of a cone, three of a cost and one of a bound. */
  std::array<Square, 7> squares = {};
  std::size_t n = 0;
  std::array<double, 9> adjoint = {};
  double det = 0.;
};

} // namespace Voussoir

#endif
