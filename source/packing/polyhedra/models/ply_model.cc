// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/model_text.h>
#include <voussoir/packing/polyhedra/models/ply_numbers.h>
#include <voussoir/packing/polyhedra/models/readers.h>

#include <boost/lexical_cast/try_lexical_convert.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

namespace Voussoir
{
namespace
{
/** A property of the elements of a PLY file: a number, or a list of them. */
struct PlyProperty
{
  std::string name, type;
  std::string type_of_count; // empty if it is no list
};

/** A list of elements of a PLY file. */
struct PlyElement
{
  std::string name;
  std::size_t count;
  std::vector<PlyProperty> properties;
};

/** Reads one file; one object, used once. */
class PlyReader
{
public:
  explicit PlyReader(const std::filesystem::path &file)
      : file(file), bytes(read_model_bytes(file))
  {}

  BlockMeshes read()
  {
    read_head();
    for (const PlyElement &element : elements)
      read_elements(element);
    if (block.faces.size() == 0)
      refuse("has no faces; a packing needs at least one block.");
    check_vertex_numbers();
    block.record = 1;
    BlockMeshes model;
    model.file = file;
    model.record_name = "object";
    model.blocks.push_back(std::move(block));
    return model;
  }

private:
  [[noreturn]] void refuse(const std::string &fault) const
  {
    throw InputError("The PLY file '" + file.string() + "' " + fault);
  }

  std::vector<std::string> next_line_of_head()
  {
    const std::size_t end = bytes.find('\n', at);
    if (end == bytes.npos)
      refuse("does not begin with the head of this format, from 'ply' to "
             "'end_header'.");
    std::istringstream line(bytes.substr(at, end - at));
    at = end + 1;
    return {std::istream_iterator<std::string>(line), {}};
  }

  void read_head()
  {
    if (bytes.compare(0, 3, "ply") != 0)
      refuse("does not begin with 'ply', as this format does.");
    next_line_of_head();
    for (unsigned int line = 2;; ++line)
    {
      const std::vector<std::string> words = next_line_of_head();
      if (words.size() == 1 && words[0] == "end_header")
        return;
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info")
        continue;
      if (!read_line_of_head(words))
        refuse(
            text("cannot be read in line ", line, ": '",
                 bytes.substr(0, at - 1).substr(bytes.rfind('\n', at - 2) + 1),
                 "' is no line of the head of this format that is "
                 "understood."));
    }
  }

  /** False if the line is none that is understood. */
  bool read_line_of_head(const std::vector<std::string> &words)
  {
    const std::size_t n = words.size();
    if (words[0] == "format" && n > 1)
    {
      form = words[1] == "ascii"                  ? PlyForm::text
             : words[1] == "binary_little_endian" ? PlyForm::little_endian
                                                  : PlyForm::big_endian;
      return form != PlyForm::big_endian || words[1] == "binary_big_endian";
    }
    if (words[0] == "element" && n == 3)
    {
      elements.push_back({words[1], 0, {}});
      return boost::conversion::try_lexical_convert(words[2],
                                                    elements.back().count) &&
             elements.back().count <= bytes.size();
    }
    if (words[0] != "property" || elements.empty())
      return false;
    const bool is_list = n == 5 && words[1] == "list";
    if (!is_list && n != 3)
      return false;
    elements.back().properties.push_back(
        {words[n - 1], words[n - 2], is_list ? words[2] : ""});
    return bytes_of_ply_type(words[n - 2]) > 0 &&
           (!is_list || bytes_of_ply_type(words[2]) > 0);
  }

  void read_elements(const PlyElement &element)
  {
    if (element.properties.empty())
      return; // however many there are said to be
    const bool is_vertex = element.name == "vertex";
    const bool is_face = element.name == "face";
    std::vector<double> values;
    std::vector<unsigned int> loop;
    for (std::size_t k = 0; k < element.count; ++k)
    {
      dealii::Point<3> place;
      for (const PlyProperty &property : element.properties)
      {
        read_values(property, element, k, values);
        const char axis = property.name.size() == 1 ? property.name[0] : ' ';
        if (is_vertex && axis >= 'x' && axis <= 'z' && values.size() == 1)
          place[axis - 'x'] = values[0];
        if (is_face && (property.name == "vertex_indices" ||
                        property.name == "vertex_index"))
        {
          loop.clear();
          for (const double value : values)
            loop.push_back(vertex_of(value));
          block.faces.add(loop);
        }
      }
      if (is_vertex)
        block.vertices.push_back(place);
    }
  }

  /** The number of a vertex; that of none for what cannot be one. */
  static unsigned int vertex_of(const double value)
  {
    constexpr double most = std::numeric_limits<int>::max();
    return std::isfinite(value) && value >= 0. && value < most
               ? static_cast<unsigned int>(value)
               : std::numeric_limits<unsigned int>::max();
  }

  void read_values(const PlyProperty &property,
                   const PlyElement &element,
                   const std::size_t number,
                   std::vector<double> &values)
  {
    std::size_t n = 1;
    const auto next = [&](const std::string &type) {
      return form == PlyForm::text ? next_word(element, number)
                                   : next_bytes(type, element, number);
    };
    if (!property.type_of_count.empty())
    {
      const double count = next(property.type_of_count);
      if (!std::isfinite(count) || count < 0. || count > bytes.size())
        refuse(text("has no number of values for '", property.name, "' of ",
                    element.name, ' ', number, "; it is damaged."));
      n = count;
    }
    values.clear();
    for (std::size_t i = 0; i < n; ++i)
      values.push_back(next(property.type));
  }

  double next_bytes(const std::string &type,
                    const PlyElement &element,
                    const std::size_t number)
  {
    const InvalidOperationsAllowed allowed; // a number may be none
    const unsigned int size = bytes_of_ply_type(type);
    if (at + size > bytes.size())
      refuse_end(element, number);
    const auto *const data =
        reinterpret_cast<const unsigned char *>(bytes.data()) + at;
    at += size;
    const double value = load_ply_number(data, type, form);
    // Each use of a signalling one would be an invalid operation.
    return std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value;
  }

  double next_word(const PlyElement &element, const std::size_t number)
  {
    const char *const blanks = " \t\r\n";
    at = bytes.find_first_not_of(blanks, at);
    if (at == bytes.npos)
      refuse_end(element, number);
    const std::size_t end =
        std::min(bytes.find_first_of(blanks, at), bytes.size());
    double value = 0.;
    if (!boost::conversion::try_lexical_convert(bytes.data() + at, end - at,
                                                value))
      refuse(text("cannot be read in line ",
                  1 + std::count(bytes.begin(), bytes.begin() + at, '\n'),
                  ": '", bytes.substr(at, end - at), "' of ", element.name, ' ',
                  number, " should be a number."));
    at = end;
    return value;
  }

  [[noreturn]] void refuse_end(const PlyElement &element,
                               const std::size_t number) const
  {
    refuse(text("ends in ", element.name, ' ', number, " of ", element.count,
                "; it was cut short."));
  }

  void check_vertex_numbers() const
  {
    for (unsigned int f = 0; f < block.faces.size(); ++f)
      for (const unsigned int vertex : block.faces[f])
        if (vertex >= block.vertices.size())
          refuse(text("has face ", f,
                      " with a vertex that is not there; vertices are numbered "
                      "from 0 to ",
                      static_cast<long>(block.vertices.size()) - 1, "."));
  }

  const std::filesystem::path file;
  const std::string bytes;
  std::size_t at = 0; // the next byte
  PlyForm form = PlyForm::text;
  std::vector<PlyElement> elements;
  BlockMesh block;
};
} // namespace

BlockMeshes read_ply_model(const std::filesystem::path &file)
{
  return PlyReader(file).read();
}
} // namespace Voussoir
