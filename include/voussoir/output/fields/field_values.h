// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_field_values_h
#define voussoir_output_fields_field_values_h

#include <deal.II/base/tensor.h>

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
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
  number, /**< one component */
  pair,   /**< the numbers of the start and of the end of an edge */
  vector, /**< two components, x and y */
  tensor  /**< four components: xx, xy, yx, yy */
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

/** Values by the types that they are computed in. */
namespace FieldComponents
{
/** @{ */
/** Whether a type is a std::optional. */
template <typename Value>
struct IsOptional : std::false_type
{
};
template <typename Value>
struct IsOptional<std::optional<Value>> : std::true_type
{
};
/** @} */

/** The type of a value, which may be missing. */
template <typename Value>
struct Given
{
  using Type = Value; /**< that without std::optional */
};
/** The type of a value that is missing for some elements. */
template <typename Value>
struct Given<std::optional<Value>>
{
  using Type = Value; /**< that without std::optional */
};

/** Double is real, int an integer, and bool a mark. */
template <typename Value>
constexpr FieldType type()
{
  using Type = typename Given<Value>::Type;
  return std::is_same_v<Type, bool> ? FieldType::mark
         : std::is_integral_v<Type> ? FieldType::integer
                                    : FieldType::real;
}

/** Arrays are pairs. */
template <typename Value>
constexpr FieldShape shape()
{
  using dealii::Tensor;
  return std::is_arithmetic_v<typename Given<Value>::Type> ? FieldShape::number
         : std::is_same_v<Value, std::array<double, 2>>    ? FieldShape::pair
         : std::is_base_of_v<Tensor<2, 2>, Value>          ? FieldShape::tensor
                                                           : FieldShape::vector;
}

/** Put the components of @p value at @p place. @return where they end. */
template <typename Value>
double *put(double *place, const Value &value)
{
  if constexpr (IsOptional<Value>::value)
    *place++ =
        value ? double(*value) : std::numeric_limits<double>::quiet_NaN();
  else if constexpr (shape<Value>() == FieldShape::number)
    *place++ = double(value);
  else if constexpr (shape<Value>() == FieldShape::tensor)
    for (unsigned int i = 0; i < 4; ++i)
      *place++ = value[i / 2][i % 2];
  else
    for (unsigned int i = 0; i < 2; ++i)
      *place++ = value[i];
  return place;
}
} // namespace FieldComponents

/** The values @p value(e) of the elements e, computed when they are wanted. */
template <typename Value>
FieldValues values_of_each(const Value &value)
{
  return [value](std::size_t e, const std::size_t end, double *place) {
    for (; e < end; ++e)
      place = FieldComponents::put(place, value(e));
  };
}

/** Values that lie in memory. */
template <typename Object>
struct Stored
{
  /** The type of a value. */
  using Value = Object;

  /** All of a vector, which must outlive what is made of this object. */
  explicit Stored(const std::vector<Value> &all)
      : all{reinterpret_cast<const double *>(all.data()), all.size(),
            sizeof(Value)}
  {}
  /** A member of each object in a vector, which must live as long. */
  template <typename Whole>
  Stored(const std::vector<Whole> &objects, Value Whole::*const member)
      : all{objects.empty()
                ? nullptr
                : reinterpret_cast<const double *>(&(objects.front().*member)),
            objects.size(), sizeof(Whole)}
  {}

  /** The place of the values, and a function that copies some. */
  BoundValues bound() const
  {
    static_assert(sizeof(Value) % sizeof(double) == 0 &&
                  FieldComponents::type<Value>() == FieldType::real);
    const auto value = [all = all](const std::size_t e) -> const Value & {
      return *reinterpret_cast<const Value *>(
          reinterpret_cast<const char *>(all.first) + e * all.stride);
    };
    return {values_of_each(value), all};
  }

private:
  FieldMemory all;
};
/** So that the type of the member need not be named. */
template <typename Whole, typename Value>
Stored(const std::vector<Whole> &, Value Whole::*) -> Stored<Value>;
} // namespace Voussoir

#endif
