// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/model_text.h>
#include <voussoir/packing/polyhedra/models/readers.h>

#include <algorithm>
#include <unordered_map>

namespace Voussoir
{
namespace
{
/** Reads one file; one object, used once. */
class TessReader
{
public:
  explicit TessReader(const std::filesystem::path &file)
      : text(file, "Neper tessellation")
  {
    model.file = file;
    model.record_name = "polyhedron";
    model.is_computed = true;
  }

  BlockMeshes read()
  {
    if (!text.next_line() || text.words()[0] != "***tess")
      text.refuse_file(
          "does not begin with three stars and 'tess', as this format does.");
    while (text.next_line())
      if (text.words()[0] == "**general")
        read_general();
      else if (text.words()[0] == "**periodicity")
        refuse_periodic();
      else if (text.words()[0] == "**vertex")
        read_vertices();
      else if (text.words()[0] == "**face")
        read_faces();
      else if (text.words()[0] == "**polyhedron")
        read_polyhedra();
    if (model.blocks.empty())
      text.refuse_file("has no section '**polyhedron' with polyhedra; a "
                       "packing needs at least one.");
    return std::move(model);
  }

private:
  /** The numbers that lines begin with, and their places in a list. */
  using Numbers = std::unordered_map<long long, unsigned int>;

  [[noreturn]] void refuse_periodic() const
  {
    text.refuse("the tessellation is periodic, and a packing is not; make one "
                "without the option -periodicity.");
  }

  void read_general()
  {
    text.expect_line("the dimension");
    if (text.integer(0, "the dimension", 1, 3) != 3)
      text.refuse("the tessellation is not one of space; a packing of "
                  "polyhedra is made of one with the dimension 3.");
    if (text.words().size() > 1 && text.words()[1] == "periodic")
      refuse_periodic();
  }

  long long number(const std::size_t word, const std::string &what) const
  {
    return text.integer(word, "the number of " + what, -most, most);
  }

  unsigned int find(const Numbers &numbers,
                    const std::size_t word,
                    const std::string &what) const
  {
    const long long signed_number = number(word, what);
    const auto found = numbers.find(std::abs(signed_number));
    if (found == numbers.end())
      text.refuse(Voussoir::text("there is no ", what, ' ',
                                 std::abs(signed_number), " before this."));
    return found->second;
  }

  unsigned int read_count(const std::string &things)
  {
    text.expect_line("the number of " + things);
    return text.integer(0, "the number of " + things, 0, text.n_bytes());
  }

  void read_vertices()
  {
    const unsigned int n = read_count("vertices");
    for (unsigned int v = 0; v < n; ++v)
    {
      text.expect_line(Voussoir::text("vertex ", v + 1, " of ", n));
      vertex_numbers[number(0, "a vertex")] = whole.vertices.size();
      whole.vertices.push_back(text.point(1));
    }
  }

  /** Each face has four lines: vertices, edges, plane, and its state. */
  void read_faces()
  {
    const unsigned int n = read_count("faces");
    std::vector<unsigned int> loop;
    for (unsigned int f = 0; f < n; ++f)
    {
      text.expect_line(Voussoir::text("face ", f + 1, " of ", n));
      face_numbers[number(0, "a face")] = faces.size();
      const long long n_corners =
          text.integer(1, "the number of its vertices, which are to follow", 0,
                       std::max<long long>(text.words().size(), 2) - 2);
      loop.clear();
      for (long long i = 0; i < n_corners; ++i)
        loop.push_back(find(vertex_numbers, 2 + i, "vertex"));
      faces.add(loop);
      for (const char *const line : {"its edges", "its plane", "its state"})
        text.expect_line(line);
    }
  }

  void read_polyhedra()
  {
    const unsigned int n = read_count("polyhedra");
    std::vector<unsigned int> loop, all;
    n_polyhedra_of_face.resize(faces.size());
    for (unsigned int p = 0; p < n; ++p)
    {
      text.expect_line(Voussoir::text("polyhedron ", p + 1, " of ", n));
      const long long record = number(0, "a polyhedron");
      const long long n_faces =
          text.integer(1, "the number of its faces, which are to follow", 0,
                       std::max<long long>(text.words().size(), 2) - 2);
      whole.faces = FaceLoops();
      all.clear();
      for (long long i = 0; i < n_faces; ++i)
      {
        const unsigned int number_of_face = find(face_numbers, 2 + i, "face");
        // A small file could else ask for any memory.
        if (n_polyhedra_of_face[number_of_face]++ == 2)
          text.refuse(
              Voussoir::text("face ", std::abs(number(2 + i, "a face")),
                             " is in a third place; remove it there, as a face "
                             "is between two polyhedra at most."));
        const auto face = faces[number_of_face];
        loop.assign(face.begin(), face.end());
        // Behind a minus the face runs the other way round.
        if (number(2 + i, "a face") < 0)
          std::reverse(loop.begin(), loop.end());
        all.push_back(whole.faces.size());
        whole.faces.add(loop);
      }
      model.blocks.push_back(part_of_block(whole, all));
      model.blocks.back().record = record;
    }
  }

  static constexpr long long most = 1000000000; // of a number in the file
  ModelText text;
  BlockMeshes model;
  BlockMesh whole;
  FaceLoops faces;
  Numbers vertex_numbers, face_numbers;
  std::vector<unsigned int> n_polyhedra_of_face;
};
} // namespace

BlockMeshes read_tess_model(const std::filesystem::path &file)
{
  return TessReader(file).read();
}
} // namespace Voussoir
