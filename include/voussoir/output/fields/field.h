// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_fields_field_h
#define voussoir_output_fields_field_h

#include <voussoir/output/fields/field_values.h>
#include <voussoir/output/fields/moving_scene.h>

#include <cstddef>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace Voussoir
{
/**
 * What is said of a quantity that each interface, cell or boundary edge has,
 * without its values: all that a column, an array, an attribute of Python's and
 * a line of the manual need.
 */
struct FieldDescription
{
  /** Where a grid has it. */
  enum class Place
  {
    nowhere, /**< it has no array */
    cells,   /**< one value a cell of the grid */
    points   /**< the writer of the grid has the values at the points */
  };

  /** Of the array in a grid; of pairs nothing is named so there. */
  std::string name;
  /** In powers of L, a length, and S, a stress, as in "S L"; empty: none. */
  std::string unit;
  /** What it is, as doc/results.md says it, in Markdown. */
  std::string words;
  /** When it is there, as in "with `Ranges`"; empty: always. */
  std::string condition = {};
  /** What grids have otherwise, or need to say; empty: nothing. */
  std::string words_in_grid = {};
  /** Of its components in a table; empty: it is in none. */
  std::vector<std::string> columns = {};
  /** Its place in a grid. */
  Place in_grid = Place::cells;
  /** The attribute of Python; empty: there is none. */
  std::string attribute = {};
  /** What its values are of. */
  FieldShape shape = FieldShape::number;
  /** How its values are written. */
  FieldType type = FieldType::real;

  /** The number of its components. */
  unsigned int n_components() const
  {
    return shape == FieldShape::number         ? 1
           : shape == FieldShape::space_vector ? 3
           : shape == FieldShape::space_tensor ? 9
           : shape == FieldShape::tensor       ? 4
                                               : 2;
  }
  /** The names of its components: those of vectors end in _x, _y, _z. */
  std::vector<std::string> component_names(const std::string &of) const;
};

/** A quantity with its values, for the writers. */
struct BoundField : BoundValues
{
  /** What is said of it. */
  const FieldDescription *about;
  /** False if results that should have it have not: no value is to be asked. */
  bool has_values;
};

/** Quantities of some results, in the order in which they are written. */
using BoundFields = std::vector<BoundField>;

/** When there is a quantity in some data. */
template <typename Data>
struct FieldCondition
{
  /** As FieldDescription::condition. */
  std::string words;
  /** Whether files have it. */
  std::function<bool(const Data &)> holds;
  /**
   * Why there are no values, which leaves columns empty; an empty text if there
   * are. Null: there are if files have them.
   */
  std::function<std::string(const Data &)> lacks = nullptr;
};

/**
 * A quantity of interfaces, cells or boundary edges, stated once for the
 * tables, the grids, Python and the manual.
 *
 * @tparam Data what it follows from: Results, or as much of them as it needs,
 *   see part_of().
 */
template <typename Data>
struct Field : FieldDescription
{
  /**
   * A quantity that is there always, in tables and grids.
   *
   * @param value a function of the data and the number e of an element; or one
   *   of the data, which makes ready what all elements need, and returns a
   *   function of e, or Stored values. The type of a value says shape and type:
   *   double, int (an integer), bool (a mark), std::array<double, 2> (a pair),
   *   Tensor<1, 2> or Tensor<2, 2>. Where an element has no value it is not a
   *   number, a double.
   */
  template <typename Value>
  Field(const std::string &name,
        const std::string &unit,
        const std::string &words,
        Value value)
      : FieldDescription{name, unit, words}
  {
    if constexpr (std::is_invocable_v<Value, const Data &, unsigned int>)
      declare([value](const Data &data) {
        return [&data, value](const unsigned int e) { return value(data, e); };
      });
    else
      declare(value);
    columns = component_names(name);
    attribute = name;
  }
  /** @p other, in data that have its data as a part. */
  template <typename Part>
  explicit Field(const Field<Part> &other)
      : FieldDescription(other), bind([bind = other.bind](const Data &data) {
          return bind(part_of<Part>(data));
        }),
        holds([holds = other.holds](const Data &data) {
          return holds(part_of<Part>(data));
        }),
        lacks([lacks = other.lacks](const Data &data) {
          return lacks(part_of<Part>(data));
        })
  {}

  /** @{ */
  /** Give its columns, or the attribute of Python, other names. */
  Field &with_columns(const std::vector<std::string> &names)
  {
    columns = names;
    return *this;
  }
  Field &with_attribute(const std::string &other)
  {
    attribute = other;
    return *this;
  }
  /** @} */
  /** Leave it to grids. */
  Field &only_in_grid() { return with_columns({}); }
  /** Leave it to tables. */
  Field &only_in_table() { return at(Place::nowhere); }
  /** Put it elsewhere in grids. */
  Field &at(const Place place)
  {
    in_grid = place;
    return *this;
  }
  /** Say more of it where it is in a grid. */
  Field &saying_in_grid(const std::string &sentence)
  {
    words_in_grid = sentence;
    return *this;
  }
  /** Write its values, which are double, as integers. */
  Field &as_integer()
  {
    type = FieldType::integer;
    return *this;
  }

  /** In grids take @p other(data, e) where it is not finite. */
  template <typename Value>
  Field &instead_in_grid(const Value &other, const std::string &sentence)
  {
    bind = [bind = bind, other](const Data &data) {
      BoundValues values = bind(data);
      values.stand_in = values_of_each(
          [&data, other](const unsigned int e) { return other(data, e); });
      return values;
    };
    return saying_in_grid(sentence);
  }

  /** Write its values, which are int, as the texts @p names(data). */
  template <typename Names>
  Field &numbering(const Names &names)
  {
    type = FieldType::name;
    bind = [bind = bind, names](const Data &data) {
      BoundValues values = bind(data);
      values.names = &names(data);
      return values;
    };
    return *this;
  }

  /** Its values, which refer to @p data. */
  BoundField bound(const Data &data) const
  {
    const bool has_values = lacks(data).empty();
    return {has_values ? bind(data) : BoundValues(), this, has_values};
  }

  /** Its values; only to be asked if lacks() says nothing. */
  std::function<BoundValues(const Data &)> bind;
  /** FieldCondition::holds. */
  std::function<bool(const Data &)> holds = [](const Data &) { return true; };
  /** FieldCondition::lacks. */
  std::function<std::string(const Data &)> lacks = [](const Data &) {
    return std::string();
  };

private:
  /** Take shape, type and values from what @p ready(data) returns. */
  template <typename Ready>
  void declare(const Ready &ready)
  {
    using Values = std::decay_t<std::invoke_result_t<Ready, const Data &>>;
    using Value = std::decay_t<std::invoke_result_t<Values, unsigned int>>;
    shape = shape_of_values<Value>;
    type = type_of_values<Value>;
    bind = [ready](const Data &data) {
      const Values values = ready(data);
      if constexpr (std::is_base_of_v<FieldMemory, Values>)
        return BoundValues{values_of_each(values), values};
      else
        return BoundValues{values_of_each(values)};
    };
  }
};

/** Related quantities, in the order of the columns. */
template <typename Data>
using Fields = std::vector<Field<Data>>;

/** @p fields, which are there on a condition. */
template <typename Data>
Fields<Data> when(const FieldCondition<Data> &condition, Fields<Data> fields)
{
  for (Field<Data> &field : fields)
  {
    field.condition = condition.words;
    field.holds = condition.holds;
    field.lacks = condition.lacks;
    if (!condition.lacks)
      field.lacks = [condition](const Data &data) {
        return condition.holds(data)
                   ? std::string()
                   : "it is there " + condition.words + " only";
      };
  }
  return fields;
}

/** @p fields in tables alone. */
template <typename Data>
Fields<Data> only_in_table(Fields<Data> fields)
{
  for (Field<Data> &field : fields)
    field.only_in_table();
  return fields;
}

/** One list of several. */
template <typename Data>
Fields<Data> together(const std::vector<Fields<Data>> &groups)
{
  Fields<Data> all;
  for (const Fields<Data> &group : groups)
    all.insert(all.end(), group.begin(), group.end());
  return all;
}

/**
 * The condition that blocks turn. Who asks for the values where they do not
 * gets what there is, which may be nothing.
 */
template <typename Data>
FieldCondition<Data>
where_blocks_turn(const std::function<bool(const Data &)> &turn)
{
  return {"with `Rotations = true`", turn,
          [](const Data &) { return std::string(); }};
}
} // namespace Voussoir

#endif
