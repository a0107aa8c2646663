// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/model_text.h>
#include <voussoir/packing/polyhedra/models/readers.h>

#include <boost/endian/conversion.hpp>
#include <boost/functional/hash.hpp>

#include <array>
#include <unordered_map>

namespace Voussoir
{
namespace
{
/** The bytes of binary STL before the triangles, and of a triangle. */
constexpr std::size_t bytes_of_stl_head = 84, bytes_of_stl_triangle = 50;

/** A block made of triangles, in which vertices at one place are one. */
class WeldedTriangles
{
public:
  void add(const std::array<dealii::Point<3>, 3> &triangle)
  {
    std::array<unsigned int, 3> loop;
    for (unsigned int i = 0; i < 3; ++i)
      loop[i] = number_of(triangle[i]);
    block.faces.add(loop);
  }

  BlockMesh block;

private:
  unsigned int number_of(const dealii::Point<3> &p)
  {
    // A zero with a sign is one without.
    const std::array<double, 3> key = {{p[0] + 0., p[1] + 0., p[2] + 0.}};
    const auto [entry, is_new] = numbers.emplace(key, block.vertices.size());
    if (is_new)
      block.vertices.push_back(p);
    return entry->second;
  }

  std::unordered_map<std::array<double, 3>,
                     unsigned int,
                     boost::hash<std::array<double, 3>>>
      numbers;
};

void read_stl_solid(ModelText &text, WeldedTriangles &solid)
{
  std::array<dealii::Point<3>, 3> triangle;
  unsigned int n_corners = 0;
  for (text.expect_line("'endsolid'"); !text.begins_with("endsolid");
       text.expect_line("'endsolid'"))
    if (text.begins_with("vertex"))
    {
      if (n_corners == 3)
        text.refuse("a facet has a fourth vertex; it may have three.");
      triangle[n_corners++] = text.point(1);
    }
    else if (text.begins_with("endfacet"))
    {
      if (n_corners != 3)
        text.refuse("the facet has less than three vertices.");
      solid.add(triangle);
      n_corners = 0;
    }
    else if (!text.begins_with("facet") && !text.begins_with("outer") &&
             !text.begins_with("endloop"))
      text.refuse("'" + text.rest(0) +
                  "' is no line of this format, such as 'facet normal 0 0 1' "
                  "or 'vertex 1 0 0'.");
}

BlockMeshes read_stl_text(const std::filesystem::path &file)
{
  ModelText text(file, "STL");
  BlockMeshes model;
  while (text.next_line())
  {
    if (!text.begins_with("solid"))
      text.refuse("'" + text.rest(0) +
                  "' should be 'solid', with which a block begins.");
    WeldedTriangles solid;
    solid.block.name = text.rest(1);
    solid.block.record = model.blocks.size() + 1;
    read_stl_solid(text, solid);
    if (solid.block.faces.size() > 0)
      model.blocks.push_back(std::move(solid.block));
  }
  if (model.blocks.empty())
    text.refuse_file("has no triangles; a packing needs at least one block.");
  return model;
}

BlockMeshes read_stl_bytes(const std::filesystem::path &file,
                           const std::string &bytes)
{
  const auto *const data =
      reinterpret_cast<const unsigned char *>(bytes.data());
  const std::size_t n = boost::endian::load_little_u32(data + 80);
  if (n == 0)
    throw InputError("The STL file '" + file.string() +
                     "' has no triangles; a packing needs at least one block.");
  const InvalidOperationsAllowed allowed; // a number may be none
  WeldedTriangles solid;
  solid.block.record = 1;
  std::array<dealii::Point<3>, 3> triangle;
  for (std::size_t t = 0; t < n; ++t)
  {
    // Behind the normal, which is three numbers.
    const unsigned char *at =
        data + bytes_of_stl_head + t * bytes_of_stl_triangle + 12;
    for (dealii::Point<3> &corner : triangle)
      for (unsigned int d = 0; d < 3; ++d, at += 4)
        corner[d] =
            boost::endian::endian_load<float, 4, boost::endian::order::little>(
                at);
    solid.add(triangle);
  }
  BlockMeshes model;
  model.blocks.push_back(std::move(solid.block));
  return model;
}
} // namespace

BlockMeshes read_stl_model(const std::filesystem::path &file)
{
  const std::string bytes = read_model_bytes(file);
  BlockMeshes model;
  // Binary files may begin with "solid", too; their length tells.
  const bool has_head = bytes.size() >= bytes_of_stl_head;
  const std::size_t n_announced =
      has_head ? boost::endian::load_little_u32(
                     reinterpret_cast<const unsigned char *>(bytes.data()) + 80)
               : 0;
  const std::size_t n_bytes =
      bytes_of_stl_head + n_announced * bytes_of_stl_triangle;
  if (has_head && bytes.size() == n_bytes)
    model = read_stl_bytes(file, bytes);
  else if (has_head && bytes.find('\0') != bytes.npos)
    throw InputError(text("The STL file '", file.string(), "' has ",
                          bytes.size(),
                          " bytes; with as many triangles as it "
                          "announces, ",
                          n_announced, ", it would have ", n_bytes,
                          "; it was cut short, or is no such file."));
  else
    model = read_stl_text(file);
  model.file = file;
  model.record_name = "solid";
  return model;
}
} // namespace Voussoir
