// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/packing/area_moments.h>
#include <voussoir/packing/cells_at.h>
#include <voussoir/packing/group_names.h>
#include <voussoir/scene/links/ties.h>
#include <voussoir/scene/loads/loaded_cells.h>
#include <voussoir/scene/loads/segment_tractions.h>

#include <deal.II/base/patterns.h>

#include <boost/algorithm/string/trim.hpp>

#include <optional>
#include <utility>

namespace Voussoir
{
using dealii::Point;

namespace
{
/** The length of a tie, over its coordinates, that is none. */
constexpr double rounding_of_places = 1e-12;

/** An end of a tie. */
struct End
{
  unsigned int cell;
  Point<2> place;
};

const char *const forms =
    "write a place \"x, y\" in a block; a block or a group of one, as in cell "
    "12, with or without \"at x, y\" behind it; or \"ground at x, y\".";

/** "x, y". */
End end_at(const Packing<2> &packing,
           const Point<2> &x,
           const std::string &parameter)
{
  const CellsAt cells(packing, x);
  if (cells.there.empty())
    throw InputError(text("The parameter '", parameter, "' is at ",
                          text_of_point(x), ", which is in no block; ",
                          cells.describe_nearest(packing),
                          ". Correct the place, name the block, as in cell ",
                          cells.nearest, " at ", x[0], ", ", x[1],
                          ", or take ground at ", x[0], ", ", x[1], "."));
  if (cells.there.size() > 1)
    throw InputError(text("The parameter '", parameter, "' is at ",
                          text_of_point(x), ", where ", cells.there.size(),
                          " blocks meet; name one, as in cell ",
                          cells.there.front(), " at ", x[0], ", ", x[1], "."));
  return {cells.there.front(), x};
}

/** "x, y", "at x, y", "name", "name at x, y". */
End end_of_text(const Packing<2> &packing,
                const std::string &end,
                const std::string &parameter)
{
  const bool has_at = end.compare(0, 3, "at ") == 0;
  if (const auto x = pair_of_text(has_at ? end.substr(3) : end))
    return end_at(packing, *x, parameter);
  const std::size_t at = end.rfind(" at ");
  const std::string name = boost::algorithm::trim_copy(end.substr(0, at));
  std::optional<Point<2>> x;
  if (at != std::string::npos)
    x = pair_of_text(end.substr(at + 4));
  const bool is_ground = name == ground_name;
  if (name.empty() || (at != std::string::npos && !x) || (is_ground && !x))
    throw InputError("The parameter '" + parameter + "' is '" + end + "'; " +
                     forms);
  if (is_ground)
    return {packing.ground(), *x};
  const std::vector<unsigned int> cells =
      cells_that_take("a tie", packing, name, parameter);
  if (cells.size() != 1)
    throw InputError(text("The parameter '", parameter, "' is '", end,
                          "', and there are ", cells.size(),
                          " cells of that name; name one cell, as in cell ",
                          cells.front(), "."));
  const unsigned int c = cells.front();
  return {c, x ? *x : packing.centre(c) + area_moments(packing, c).centroid()};
}
} // namespace

void Ties::add_parameters(dealii::ParameterHandler &prm,
                          const std::set<std::string> &names)
{
  using namespace dealii::Patterns;
  if (names.empty())
    return;
  prm.enter_subsection(ties_section);
  for (const std::string &name : names)
  {
    check_link_name(ties_section, name);
    Entries &tie = of_name[name];
    prm.enter_subsection(name);
    const std::string end =
        "of the tie: a place \"x, y\" in a block; a block or a group of one, "
        "as in cell 12, by its centroid, or \"cell 12 at x, y\"; or \"ground "
        "at x, y\".";
    prm.add_parameter("From", tie.from, "One end " + end, Anything());
    prm.add_parameter("To", tie.to, "The other end " + end, Anything());
    prm.add_parameter("Yield force", tie.yield_force,
                      "The most tension that it bears, over the thickness of "
                      "the blocks; a stress times a length, not negative.",
                      Double(0.));
    prm.add_parameter("Compressive strength", tie.compressive_strength,
                      "The most compression that it bears, likewise; 0 for a "
                      "rod that goes slack. With 'Yield force = 0' it is a "
                      "prop.",
                      Double(0.));
    prm.add_parameter("Prestress", tie.prestress,
                      "The tension that it has at least, as of a rod that was "
                      "tightened against its anchors: then it is between this "
                      "and 'Yield force'. Not negative.",
                      Double(0.));
    prm.leave_subsection();
  }
  prm.leave_subsection();
}

std::vector<Link> Ties::links(const Packing<2> &packing) const
{
  std::vector<Link> links;
  for (const auto &[name, tie] : of_name)
  {
    const std::string path = ties_section + "/" + name;
    End from = end_of_text(packing, tie.from, path + "/From");
    End to = end_of_text(packing, tie.to, path + "/To");
    const auto refuse = [&](const std::string &fault) {
      throw InputError("The tie '" + path + "' " + fault);
    };
    if (from.cell == to.cell)
      refuse(from.cell == packing.ground()
                 ? "has both ends on the ground; let one be on a block."
                 : text("has both ends on ", packing.describe(from.cell),
                        "; let one be on another, or on the ground."));
    const double length = from.place.distance(to.place);
    if (!(length > rounding_of_places * (from.place.norm() + to.place.norm())))
      refuse(text("has both ends at ", text_of_point(from.place),
                  ", and so no direction; set 'From' and 'To' apart."));
    if (!(tie.yield_force > 0. || tie.compressive_strength > 0.))
      refuse("bears nothing; set its 'Yield force', its 'Compressive "
             "strength', or both.");
    if (tie.prestress > tie.yield_force)
      refuse(text("has the prestress ", tie.prestress,
                  ", which is more than its yield force ", tie.yield_force,
                  "; set 'Prestress' to at most that."));
    if (tie.prestress > 0. && tie.compressive_strength > 0.)
      refuse("has a prestress, below which its tension does not fall, and a "
             "compressive strength; set one of the two to 0.");
    if (from.cell > to.cell)
      std::swap(from, to);
    links.push_back(
        {name, from.cell, to.cell, from.place, to.place,
         (to.place - from.place) / length,
         tie.prestress > 0. ? tie.prestress : 0. - tie.compressive_strength,
         tie.yield_force, false});
  }
  return links;
}
} // namespace Voussoir
