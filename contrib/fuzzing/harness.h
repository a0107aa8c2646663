// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_contrib_fuzzing_harness_h
#define voussoir_contrib_fuzzing_harness_h

#include <voussoir/packing/packing.h>
#include <voussoir/packing/polygons/corner_contacts.h>
#include <voussoir/packing/polygons/polygons.h>
#include <voussoir/packing/polyhedra/cell_overlaps.h>
#include <voussoir/packing/polyhedra/models/model.h>
#include <voussoir/packing/polyhedra/packing.h>
#include <voussoir/run/make_run.h>
#include <voussoir/terminal/terminal.h>

#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// What the targets share. All are one program, linked once with deal.II's two
// hundred libraries; VOUSSOIR_FUZZ_TARGET names the one to run. A target is a
// file that reads an input as a user's text. Whatever it ends with but an
// InputError, and a message that is not fit to be shown, is a find.

namespace Fuzzing
{
/** A target, under the name of its file. */
struct Target
{
  using Read = void (*)(const std::string &input);

  Target(const std::string &name, const Read read)
  {
    all().emplace(name, read);
  }

  /** The targets of this program. */
  static std::map<std::string, Read> &all()
  {
    static std::map<std::string, Read> targets;
    return targets;
  }
};

/** Write a file of the working directory. */
void write_file(const std::string &name, const std::string &content);

/** End the program unless a message can be shown; see harness.cc. */
void check_message(const std::string &message);

/** The lines of a text. */
std::vector<std::string> lines_of(const std::string &text);

/**
 * Read parameters, and do something with the run unless that is large, which
 * takes the time that it takes.
 */
void with_run(const Voussoir::ParameterSources &sources,
              const std::function<void(Voussoir::Run &)> &action);

/** Understand all that a run is made from, and solve nothing. */
inline void validate(const Voussoir::ParameterSources &sources)
{
  with_run(sources, [](const Voussoir::Run &run) { run.validate(""); });
}

/** Makes packings of files, by one generator. */
template <int dim, typename Generator>
class FileReader
{
public:
  /** @param settings of the generator, as in a .prm file, with the @p file. */
  FileReader(const std::string &settings, const std::string &file) : file(file)
  {
    generator.add_parameters(prm);
    prm.parse_input_from_string(settings);
  }

  /** Make a packing of a file with this content. */
  void read(const std::string &content)
  {
    write_file(file, content);
    std::ostringstream out;
    Voussoir::Terminal terminal(out);
    Voussoir::Cells<dim> cells = generator.generate("", terminal);
    if constexpr (dim == 3)
      cells.joins_edges = true;
    else if constexpr (std::is_same_v<Generator, Voussoir::PolygonGenerator>)
      join_corners(cells);
    const Voussoir::Packing<dim> packing(std::move(cells));
    for (const std::string &notice : packing.notices())
      check_message(notice);
    if constexpr (dim == 3)
      overlaps(packing.polyhedra(), packing.polyhedra().tolerance);
  }

private:
  const std::string file;
  Generator generator;
  dealii::ParameterHandler prm;
};

/** Drawings, of the format that the ending of the name tells. */
inline FileReader<2, Voussoir::PolygonGenerator>
drawing(const std::string &file)
{
  return {"set File = " + file, file};
}

/** Blocks in space, of the format that the ending of the name tells. */
inline FileReader<3, Voussoir::ModelGenerator> model(const std::string &file)
{
  return {"set File = " + file, file};
}
} // namespace Fuzzing

#endif
