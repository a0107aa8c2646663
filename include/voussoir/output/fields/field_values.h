// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_field_values_h
#define voussoir_output_fields_field_values_h

#include <deal.II/base/tensor.h>

#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

namespace Voussoir
{
/**
 * Puts the values of the elements from @p begin to @p end - 1, all components
 * of one and then of the next, where the pointer says. Called by several
 * threads at a time.
 */
using FieldValues =
    std::function<void(std::size_t begin, std::size_t end, double *values)>;

/** Where the values of a quantity lie in memory, if they do. */
struct FieldMemory
{
  const double *first = nullptr; /**< of the first element; null: nowhere */
  std::size_t n = 0;             /**< the number of elements */
  std::size_t stride = 0;        /**< from one element to the next; bytes */
};

/** What the values of a quantity are of. */
enum class FieldShape
{
  number,       /**< one component */
  pair,         /**< the numbers of the start and of the end of an edge */
  vector,       /**< two components, x and y */
  space_vector, /**< three components, x, y and z */
  tensor,       /**< four components: xx, xy, yx, yy */
  space_tensor  /**< nine components: xx, xy, xz, yx, ... zz */
};

/** How the values of a quantity are written. */
enum class FieldType
{
  real,    /**< as a double */
  integer, /**< as an integer of 32 bits with a sign */
  mark,    /**< as an integer of 8 bits, 0 or 1 */
  name     /**< in a table and in Python as a text, in a grid by its number */
};

/** All values of one quantity, of certain results. */
struct BoundValues
{
  /** The values; not a number where there is none. */
  FieldValues values;
  /** Of real numbers, and without copies of them; else empty. */
  FieldMemory memory = {};
  /**
   * What grids, which are drawn, have where the value is not finite; null: that
   * value.
   */
  FieldValues stand_in = {};
  /** Of FieldType::name: the texts, of which the values are numbers. */
  const std::vector<std::string> *names = nullptr;

  /** The values of a number as grids have them, see stand_in. */
  FieldValues drawn() const;
};

/** How values of a type are written: int as an integer, bool as a mark. */
template <typename Value>
constexpr FieldType type_of_values =
    std::is_same_v<Value, bool> ? FieldType::mark
    : std::is_integral_v<Value> ? FieldType::integer
                                : FieldType::real;

/** What values of a type are of; arrays are pairs. */
template <typename Value>
constexpr FieldShape shape_of_values =
    std::is_arithmetic_v<Value>                      ? FieldShape::number
    : std::is_same_v<Value, std::array<double, 2>>   ? FieldShape::pair
    : std::is_base_of_v<dealii::Tensor<2, 2>, Value> ? FieldShape::tensor
    : std::is_base_of_v<dealii::Tensor<2, 3>, Value> ? FieldShape::space_tensor
    : std::is_base_of_v<dealii::Tensor<1, 3>, Value> ? FieldShape::space_vector
                                                     : FieldShape::vector;

/** The values @p value(e) of the elements e, computed when they are wanted. */
template <typename Function>
FieldValues values_of_each(const Function &value)
{
  return [value](std::size_t e, const std::size_t end, double *place) {
    for (; e < end; ++e)
    {
      const auto &v = value(e);
      constexpr FieldShape shape = shape_of_values<std::decay_t<decltype(v)>>;
      if constexpr (shape == FieldShape::number)
        *place++ = v;
      else if constexpr (shape == FieldShape::tensor)
        for (const unsigned int i : {0, 1, 2, 3})
          *place++ = v[i / 2][i % 2];
      else if constexpr (shape == FieldShape::space_vector)
        for (const unsigned int i : {0, 1, 2})
          *place++ = v[i];
      else if constexpr (shape == FieldShape::space_tensor)
        for (unsigned int i = 0; i < 9; ++i)
          *place++ = v[i / 3][i % 3];
      else
        for (const unsigned int i : {0, 1})
          *place++ = v[i];
    }
  };
}

/** Values that lie in memory, which must outlive this object; real numbers. */
template <typename Value>
struct Stored : FieldMemory
{
  /** All of a vector. */
  explicit Stored(const std::vector<Value> &all)
      : FieldMemory{reinterpret_cast<const double *>(all.data()), all.size(),
                    sizeof(Value)}
  {}
  /** A member of each object in a vector. */
  template <typename Object>
  Stored(const std::vector<Object> &all, Value Object::*const member)
      : FieldMemory{all.empty() ? nullptr
                                : reinterpret_cast<const double *>(
                                      &(all.front().*member)),
                    all.size(), sizeof(Object)}
  {}

  /** The value of element @p e. */
  const Value &operator()(const std::size_t e) const
  {
    return *reinterpret_cast<const Value *>(
        reinterpret_cast<const char *>(first) + e * stride);
  }
};
/** So that the type of the member need not be named. */
template <typename Object, typename Value>
Stored(const std::vector<Object> &, Value Object::*) -> Stored<Value>;
} // namespace Voussoir

#endif
