// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/model_text.h>
#include <voussoir/packing/polyhedra/models/readers.h>

#include <charconv>
#include <map>
#include <numeric>
#include <optional>

namespace Voussoir
{
using DefectKind = ModelDefect::Kind;

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
        read_vertex();
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

  void read_vertex()
  {
    try
    {
      vertices.push_back(text.point(1));
    }
    catch (const InputError &error)
    {
      const DefectKind kind = text.words().size() < 4
                                  ? DefectKind::missing_coordinate
                                  : DefectKind::bad_coordinate;
      vertex_faults[vertices.size()] = fault_of_line(kind, error.what());
      vertices.emplace_back();
    }
  }

  void read_face()
  {
    loop.clear();
    for (std::size_t word = 1; word < text.words().size(); ++word)
      if (const auto vertex = vertex_number(word))
        loop.push_back(*vertex);
      else
        break; // one fault of a face is told
    all_faces.add(loop);
    line_of_face.push_back(text.line());
  }

  static ModelDefect fault_of_line(const DefectKind kind,
                                   const std::string &sentence)
  {
    ModelDefect fault = {kind, dealii::numbers::invalid_unsigned_int};
    fault.detail = sentence;
    return fault;
  }

  /** Keep a fault of the face in this line. */
  void add_fault(const DefectKind kind, const std::string &sentence)
  {
    face_faults[all_faces.size()] =
        fault_of_line(kind, text.fault_in_line(sentence));
  }

  /** The first of the numbers of "vertex/texture/normal", from zero; nothing
   * but a fault if there is no such vertex. */
  std::optional<unsigned int> vertex_number(const std::size_t word)
  {
    const std::string_view whole = text.words()[word];
    const std::string_view digits = whole.substr(0, whole.find('/'));
    const long long n = vertices.size();
    long long v = 0;
    const char *const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, v);
    if (stop != end || error != std::errc())
      add_fault(DefectKind::bad_index,
                "'" + std::string(whole) +
                    "' should be the number of a vertex, as in \"f 1 2 3\" or "
                    "\"f 1/1/1 2/2/1 3/3/1\".");
    else if (v == 0 || v > n || v < -n)
      add_fault(DefectKind::unknown_vertex,
                Voussoir::text("the face has the vertex ", v,
                               "; before it there are those from 1 to ", n,
                               ", or backwards from -1 to ", -n, "."));
    else
      return v > 0 ? v - 1 : n + v;
    return {};
  }

  /** Add the faults of lines with the faces or vertices of a block. */
  void add_faults(BlockMesh &block, const std::vector<unsigned int> &faces)
  {
    for (const unsigned int face : faces)
    {
      if (const auto found = face_faults.find(face); found != face_faults.end())
        block.faults.push_back(found->second);
      for (const unsigned int vertex : whole.faces[face])
        if (const auto found = vertex_faults.find(vertex);
            found != vertex_faults.end())
        {
          block.faults.push_back(found->second);
          vertex_faults.erase(found);
        }
    }
  }

  void cut_into_blocks(std::vector<Name> names)
  {
    if (names.empty() || names[0].first_face > 0)
      names.insert(names.begin(), {"", line_of_face[0], 0});
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
      add_faults(model.blocks.back(), faces);
    }
    for (const auto &[vertex, fault] : vertex_faults) // of no face
      model.faults.push_back(fault);
  }

  ModelText text;
  BlockMeshes model;
  BlockMesh whole;
  std::map<unsigned int, ModelDefect> vertex_faults, face_faults;
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
