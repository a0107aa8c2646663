// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/input/earlier_run.h>
#include <voussoir/output/csv.h>
#include <voussoir/output/summary/summary.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <utility>

namespace Voussoir
{
namespace fs = std::filesystem;
using dealii::Point;

namespace
{
/**
 * The difference of two coordinates that may be rounding, over the largest one.
 * The files have all digits; but another compiler may make others of the
 * packing.
 */
constexpr double rounding_of_coordinates = 1e-10;
/** The difference of two strengths, over one, that may be rounding. */
constexpr double rounding_of_strengths = 1e-10;

constexpr const char *same_scene =
    ". The packing, supports and strengths must be those of the run that the "
    "forces are from; leave 'Forces from' empty to solve.";

/** A point with digits enough to see the difference. */
std::string all_of(const Point<2> &p)
{
  return "(" + text_to_copy(p[0]) + ", " + text_to_copy(p[1]) + ")";
}

/** The difference of two coordinates that may be rounding. */
double rounding_in(const Packing<2> &packing)
{
  double largest = 0.;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      largest = std::max({largest, std::abs(packing.vertex(c, i)[0]),
                          std::abs(packing.vertex(c, i)[1])});
  return rounding_of_coordinates * largest;
}

bool are_same(const Point<2> &a, const Point<2> &b, const double tolerance)
{
  return std::abs(a[0] - b[0]) <= tolerance &&
         std::abs(a[1] - b[1]) <= tolerance;
}

[[noreturn]] void
differ(const CsvReader &line, const std::string &there, const std::string &here)
{
  line.refuse("has " + there + "; in this run it is " + here + same_scene);
}

std::string between(const double cell_minus, const double cell_plus)
{
  return text("between cell ", cell_minus, " and ",
              cell_plus < 0. ? "the ground" : text("cell ", cell_plus));
}

std::string from_to(const Point<2> &start, const Point<2> &end)
{
  return "from " + all_of(start) + " to " + all_of(end);
}
} // namespace

EarlierRun::EarlierRun(fs::path directory_in)
    : directory(std::move(directory_in)), origin(read_summary()),
      interfaces(open(interfaces_csv)), cells(open(cells_csv)),
      marked(interfaces.has_column("never_pressed")),
      turned(interfaces.has_column("normal_force_0"))
{
  interfaces.choose({"cell_minus", "cell_plus", "x0", "y0", "x1", "y1",
                     "normal_force", "tangential_force", "strength"});
  if (marked)
    interfaces.choose({"never_pressed", "always_sliding"});
  if (turned)
    interfaces.choose({"normal_force_0", "normal_force_1"});
  cells.choose({"id", "x", "y", "ux", "uy"});
  if (turned)
    cells.choose({"rotation"});
}

void EarlierRun::refuse(const std::string &fault) const
{
  throw InputError(
      "'Forces from' = '" + directory.string() + "': " + fault +
      " Name the directory of results with forces, where a relative path "
      "starts at the directory that the program is run in, or leave it empty "
      "to solve.");
}

EarlierRun::Origin EarlierRun::read_summary() const
{
  if (!fs::is_directory(directory))
    refuse("there is no such directory.");
  const fs::path file = directory / summary_json;
  std::ifstream in(file);
  if (!in || fs::is_directory(file))
    refuse("there is no " + summary_json + ".");
  Origin found;
  const auto count_in = [&](const nlohmann::json &tree, const char *key) {
    const nlohmann::json &value = tree.at(key);
    // Of any other number the conversion may be undefined.
    if (!value.is_number_unsigned() ||
        value > std::numeric_limits<unsigned int>::max())
      refuse(text("its ", summary_json, " has no number of things for '", key,
                  "'."));
    return value.get<unsigned int>();
  };
  try
  {
    const nlohmann::json summary = nlohmann::json::parse(in);
    if (summary.at("status") == Status{Status::Kind::collapse, 0.}.word())
      refuse("that run found that the load is not carried, so that there are "
             "no forces.");
    const nlohmann::json &packing = summary.at("packing");
    found.n_cells = count_in(packing, "cells");
    found.n_interfaces = count_in(packing, "interfaces");
    summary.at("formulation").get_to(found.record.formulation);
    summary.at("selection").get_to(found.record.selection);
    const nlohmann::json &solver = summary.at("solver");
    // If that run has read its forces, too, what counts is the solver that
    // found them.
    const bool read = solver.contains("earlier_outcome");
    found.record.outcome = "read from '" + directory.string() + "'";
    solver.at(read ? "earlier_outcome" : "outcome")
        .get_to(found.record.earlier_outcome);
    found.record.n_iterations = count_in(solver, "iterations");
    found.record.n_evaluations = count_in(solver, "evaluations");
    if (solver.contains("correction"))
      found.correction = solver.at("correction").get<double>();
  }
  catch (const nlohmann::json::exception &error)
  {
    refuse("its " + summary_json + " is not the summary of a run (" +
           error.what() + ").");
  }
  return found;
}

CsvReader EarlierRun::open(const std::string &name) const
{
  if (!fs::exists(directory / name))
    refuse("there is no " + name +
           ", which a run writes with 'Output/Files' = all or csv.");
  return CsvReader(directory / name);
}

void EarlierRun::check_size(const Packing<2> &packing) const
{
  const auto check = [&](const std::string &things, const std::size_t there,
                         const std::size_t here) {
    if (there != here)
      throw InputError(text("The run in '", directory.string(), "' had ",
                            counted(there, things), ", this one has ", here,
                            same_scene));
  };
  check("cell", origin.n_cells, packing.n_cells());
  check("interface", origin.n_interfaces, packing.interfaces().size());
}

Carried EarlierRun::forces(const Scene &scene, SolverRecord &record)
{
  check_size(scene.packing);
  if (turned != scene.turns())
    throw InputError(text("The run in '", directory.string(),
                          "' had 'Rotations = ", turned ? "true" : "false",
                          "', this one has ", turned ? "false" : "true",
                          same_scene));
  record = origin.record;
  Carried found;
  found.correction = origin.correction;
  read_interfaces(scene, found);
  read_cells(scene.packing, found);
  read_links(scene, found);
  return found;
}

void EarlierRun::read_interfaces(const Scene &scene, Carried &found)
{
  const double rounding = rounding_in(scene.packing);
  const CsvReader &line = interfaces;
  for (unsigned int e = 0; e < origin.n_interfaces; ++e)
  {
    if (!interfaces.next())
      refuse(text("its ", interfaces_csv, " ends after ",
                  counted(e, "interface"), " of ", origin.n_interfaces, "."));
    const Packing<2>::Interface &i = scene.packing.interfaces()[e];
    const double plus =
        i.cell_plus == scene.packing.ground() ? -1. : i.cell_plus;
    if (line[0] != i.cell_minus || line[1] != plus)
      differ(line, text("interface ", e, " ", between(line[0], line[1])),
             between(i.cell_minus, plus));
    const Point<2> start(line[2], line[3]), end(line[4], line[5]);
    if (!are_same(start, i.start, rounding) || !are_same(end, i.end, rounding))
      differ(line, text("interface ", e, " ", from_to(start, end)),
             from_to(i.start, i.end));
    const double strength = scene.strength[e];
    if (std::abs(line[8] - strength) > rounding_of_strengths * strength)
      differ(line,
             text("the strength ", text_to_copy(line[8]), " of interface ", e),
             text_to_copy(strength));
    found.forces.normal.push_back(line[6]);
    found.forces.tangential.push_back(line[7]);
    if (marked)
    {
      found.never_pressed.push_back(line[9] != 0.);
      found.always_sliding.push_back(line[10] != 0.);
    }
    const unsigned int next = marked ? 11 : 9;
    if (turned)
      found.forces.at_ends.push_back({{line[next], line[next + 1]}});
  }
  if (interfaces.next())
    line.refuse(text("is more than the ", origin.n_interfaces,
                     " interfaces of that run."));
}

void EarlierRun::read_cells(const Packing<2> &packing, Carried &found)
{
  const double rounding = rounding_in(packing);
  for (unsigned int c = 0; c < origin.n_cells; ++c)
  {
    if (!cells.next())
      refuse(text("its ", cells_csv, " ends after ", counted(c, "cell"), " of ",
                  origin.n_cells, "."));
    const Point<2> centre(cells[1], cells[2]);
    if (cells[0] != c || !are_same(centre, packing.centre(c), rounding))
      differ(cells,
             text("cell ", cells[0], " with the centre ", all_of(centre)),
             text("cell ", c, " with ", all_of(packing.centre(c))));
    dealii::Tensor<1, 2> u;
    u[0] = cells[3];
    u[1] = cells[4];
    found.motion.displacement.push_back(u);
    if (turned)
      found.motion.rotation.push_back(cells[5]);
  }
  if (cells.next())
    cells.refuse(
        text("is more than the ", origin.n_cells, " cells of that run."));
}

void EarlierRun::read_links(const Scene &scene, Carried &found)
{
  if (!fs::exists(directory / links_csv) && scene.links.empty())
    return;
  CsvReader line = open(links_csv);
  line.choose({"x0", "y0", "x1", "y1", "least", "most", "force"});
  const double rounding = rounding_in(scene.packing);
  for (const Link &link : scene.links)
  {
    if (!line.next())
      refuse(
          text("its ", links_csv, " ends before the link '", link.name, "'."));
    const Point<2> start(line[0], line[1]), end(line[2], line[3]);
    if (!are_same(start, link.on_minus, rounding) ||
        !are_same(end, link.on_plus, rounding))
      differ(line, "the link '" + link.name + "' " + from_to(start, end),
             from_to(link.on_minus, link.on_plus));
    for (const auto &[there, here] :
         {std::pair(line[4], link.least), std::pair(line[5], link.most)})
      if (std::abs(there - here) > rounding_of_strengths * std::abs(here))
        differ(line,
               text("the bound ", text_to_copy(there), " of the link '",
                    link.name, "'"),
               text_to_copy(here));
    found.forces.in_links.push_back(line[6]);
  }
  if (line.next())
    line.refuse("is a link more than this run has.");
}
} // namespace Voussoir
