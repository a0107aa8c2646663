// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/model_text.h>
#include <voussoir/packing/polyhedra/models/readers.h>

#include <charconv>
#include <limits>
#include <numeric>

namespace Voussoir
{
namespace
{
/** Reads one file; one object, used once. */
class ObjReader
{
public:
  explicit ObjReader(const std::filesystem::path &file) : text(file, "OBJ")
  {
    model.file = file;
  }

  BlockMeshes read()
  {
    while (text.next_line())
      if (text.words()[0] == "v")
        vertices.push_back(text.point(1));
      else if (text.words()[0] == "f")
        read_face();
      else if (text.words()[0] == "o")
        objects.push_back({text.rest(1), text.line(), all_faces.size()});
      else if (text.words()[0] == "g")
        groups.push_back({text.rest(1), text.line(), all_faces.size()});
    if (all_faces.size() == 0)
      text.refuse_file("has no faces; a packing needs at least one block.");
    cut_into_blocks(objects.empty() ? groups : objects);
    return std::move(model);
  }

private:
  /** A line with the name of a block. */
  struct Name
  {
    std::string name;
    unsigned int line;
    unsigned int first_face;
  };

  void read_face()
  {
    const long long n = vertices.size();
    loop.clear();
    for (std::size_t word = 1; word < text.words().size(); ++word)
    {
      const long long v = vertex_number(word);
      if (v == 0 || v > n || v < -n)
        text.refuse(Voussoir::text("the face has the vertex ", v,
                                   "; before it there are those from 1 to ", n,
                                   ", or backwards from -1 to ", -n, "."));
      loop.push_back(v > 0 ? v - 1 : n + v);
    }
    all_faces.add(loop);
    line_of_face.push_back(text.line());
  }

  /** The first of the numbers of "vertex/texture/normal". */
  long long vertex_number(const std::size_t word) const
  {
    constexpr long long most = std::numeric_limits<int>::max();
    const std::string_view whole = text.words()[word];
    const std::string_view digits = whole.substr(0, whole.find('/'));
    long long value = 0;
    const char *const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, value);
    if (stop != end || error != std::errc() || value > most || value < -most)
      text.refuse("'" + std::string(whole) +
                  "' should be the number of a vertex, as in \"f 1 2 3\" or "
                  "\"f 1/1/1 2/2/1 3/3/1\".");
    return value;
  }

  void cut_into_blocks(std::vector<Name> names)
  {
    if (names.empty() || names[0].first_face > 0)
      names.insert(names.begin(), {"", line_of_face[0], 0});
    BlockMesh whole;
    whole.vertices = std::move(vertices);
    whole.faces = std::move(all_faces);
    std::vector<unsigned int> faces;
    for (std::size_t k = 0; k < names.size(); ++k)
    {
      const unsigned int end =
          k + 1 < names.size() ? names[k + 1].first_face : whole.faces.size();
      if (end == names[k].first_face)
        continue; // the name of points, lines or nothing
      faces.resize(end - names[k].first_face);
      std::iota(faces.begin(), faces.end(), names[k].first_face);
      model.blocks.push_back(part_of_block(whole, faces));
      model.blocks.back().name = names[k].name;
      model.blocks.back().record = names[k].line;
    }
  }

  ModelText text;
  BlockMeshes model;
  std::vector<dealii::Point<3>> vertices;
  FaceLoops all_faces;
  std::vector<unsigned int> line_of_face;
  std::vector<Name> objects, groups;
  std::vector<unsigned int> loop;
};
} // namespace

BlockMeshes read_obj_model(const std::filesystem::path &file)
{
  return ObjReader(file).read();
}
} // namespace Voussoir
