// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/packing/polyhedra/models/model_text.h>
#include <voussoir/packing/polyhedra/models/readers.h>

#include <algorithm>
#include <array>

namespace Voussoir
{
namespace
{
/** The least bytes of a line of an OFF file: "0 0 0" and its end. */
constexpr long long least_bytes_of_off_line = 6;

/**
 * The numbers of vertices and faces of an object, which stand behind the word
 * OFF or on the next line.
 */
std::array<long long, 2> read_off_counts(ModelText &text)
{
  const std::string head(text.words()[0]);
  const std::size_t size = head.size();
  if (size < 3 || head.substr(size - 3) != "OFF" ||
      head.find_first_of("4n") != std::string::npos)
    text.refuse("'" + head +
                "' should be 'OFF', with which an object of three dimensions "
                "begins.");
  std::size_t word = 1;
  if (text.words().size() == 1)
  {
    text.expect_line("the numbers of vertices and faces");
    word = 0;
  }
  else if (text.words()[1] == "BINARY")
    text.refuse("it is binary; save it as text.");
  const long long most = text.n_bytes() / least_bytes_of_off_line;
  return {{text.integer(word, "the number of vertices", 0, most),
           text.integer(word + 1, "the number of faces", 0, most)}};
}

BlockMesh read_off_object(ModelText &text)
{
  const auto [n_vertices, n_faces] = read_off_counts(text);
  BlockMesh block;
  block.vertices.reserve(n_vertices);
  for (long long v = 0; v < n_vertices; ++v)
  {
    text.expect_line(Voussoir::text("vertex ", v, " of ", n_vertices));
    block.vertices.push_back(text.point(0));
  }
  std::vector<unsigned int> loop;
  for (long long f = 0; f < n_faces; ++f)
  {
    text.expect_line(Voussoir::text("face ", f, " of ", n_faces));
    const long long n = text.integer(
        0, "the number of vertices of the face, which are to follow", 0,
        text.words().size() - 1);
    loop.clear();
    for (long long i = 1; i <= n; ++i)
      loop.push_back(
          text.integer(i, "the number of a vertex", 0, n_vertices - 1));
    block.faces.add(loop);
  }
  return block;
}
} // namespace

BlockMeshes read_off_model(const std::filesystem::path &file)
{
  ModelText text(file, "OFF");
  BlockMeshes model;
  model.file = file;
  model.record_name = "object";
  while (text.next_line())
  {
    model.blocks.push_back(read_off_object(text));
    model.blocks.back().record = model.blocks.size();
  }
  if (std::all_of(model.blocks.begin(), model.blocks.end(),
                  [](const BlockMesh &b) { return b.faces.size() == 0; }))
    text.refuse_file("has no faces; a packing needs at least one block.");
  return model;
}
} // namespace Voussoir
