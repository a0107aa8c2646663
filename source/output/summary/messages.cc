// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/summary/messages.h>
#include <voussoir/statics/problem/stop.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace Voussoir
{
namespace
{
/** "the forces on cell 3 at (1, 2) miss balance by 1e-9". */
std::string fault(const Packing<2> &packing, const LargestError &error)
{
  const std::string cell = packing.describe(error.cell) + " at " +
                           text_of_point(packing.centre(error.cell));
  switch (error.kind)
  {
  case LargestError::Kind::balance:
    return text("the forces on ", cell, " miss balance by ", error.size);
  case LargestError::Kind::moment:
    return text("the moments on ", cell, " miss balance by ", error.size,
                " times the root of its area");
  default:
    return text("a force on ", cell, " is beyond its limit by ", error.size);
  }
}

/** On the cell that is balanced worst by its own measure. */
std::string worst_of_light(const Packing<2> &packing,
                           const std::vector<UnbalancedCell> &cells)
{
  const UnbalancedCell &worst = *std::max_element(
      cells.begin(), cells.end(),
      [](const UnbalancedCell &a, const UnbalancedCell &b) {
        return a.imbalance * b.own_force < b.imbalance * a.own_force;
      });
  return text(" Measured by their own loads, ", counted(cells.size(), "cell"),
              cells.size() == 1 ? " is" : " are",
              " not balanced: ", packing.describe(worst.cell), " at ",
              text_of_point(packing.centre(worst.cell)), " lacks ",
              worst.imbalance, " of ", worst.own_force,
              ", the load on it or beside it, and may slide.");
}

/** The message on a load that is carried to a small error only. */
std::string inexact(const Results &results)
{
  const Packing<2> &packing = results.scene.packing;
  const Certificate &certificate = results.certificate;
  const std::string found = text(
      "The load is carried to within ", results.status.within,
      " of the largest load on a cell: ", fault(packing, certificate.largest));
  if (results.status.within > largest_accepted_error)
    return found + ", which 'Solver/Tolerance' admits. Lower it for forces "
                   "that balance the load exactly.";
  return found +
         ", and neither a correction within all limits nor a mechanism of "
         "collapse was found. The load may be that far below or above what "
         "the packing can carry: set 'Analysis = load factor' to see how far "
         "the limit is, or lower 'Solver/Tolerance'." +
         (certificate.unbalanced.empty()
              ? ""
              : worst_of_light(packing, certificate.unbalanced));
}

/** A resistance to turning, over the moment, that is rounding. */
constexpr double no_resistance = 1e-9;

/** The message on forces that would turn blocks. */
std::string turning(const Packing<2> &packing, const Overturning &found)
{
  const unsigned int n = found.cells.size();
  const unsigned int first = found.cells.front();
  const double share = std::abs(found.moment) / found.resistance;
  std::string why;
  if (found.resistance <= no_resistance * std::abs(found.moment))
    why = ": nothing presses on the interfaces around";
  else if (found.interfaces.size() > 1)
    why = text(": the moment is ", share, " times what the ",
               found.interfaces.size(),
               " interfaces around can balance, each pressed at one end");
  else
  {
    const Packing<2>::Interface &i = packing.interfaces()[found.interfaces[0]];
    why = text(": the resultant on the interface from ", text_of_point(i.start),
               " to ", text_of_point(i.end), " lies ", 0.5 * (share - 1.),
               " of its length outside it");
  }
  return text(
      "Blocks do not turn in this run, and these forces would overturn ",
      n > 1 ? text(n, " blocks, among them ") : "", packing.describe(first),
      " at ", text_of_point(packing.centre(first)), why,
      ". Other forces may prevent that, or none: set 'Rotations = "
      "true'.");
}

bool is_loaded(const Scene &scene)
{
  return scene.has_body_force || !scene.on_cells.empty() ||
         std::any_of(scene.traction.begin(), scene.traction.end(),
                     [](const auto &g) { return g.norm() > 0.; });
}
} // namespace

std::string sentence_of(const Status &status, const bool has_supports)
{
  if (status.kind == Status::Kind::carried_within)
    return "The loads are carried to within " +
           text_with_digits(status.within, 2) +
           " of the largest: whether they are carried exactly is open.";
  return std::string("The loads are carried: forces within the limits of all "
                     "joints ") +
         (has_supports ? "and supports " : "") + "balance them.";
}

std::vector<std::string> cells_not_convex(const Packing<2> &packing)
{
  if (packing.not_convex().empty())
    return {};
  const unsigned int c = packing.not_convex().front();
  const std::size_t n_hiding = packing.not_seen_whole().size();
  return {text("Not convex: ", counted(packing.not_convex().size(), "cell"),
               ", the first of which is ", packing.describe(c), " at ",
               text_of_point(packing.centre(c)),
               ". The forces on their sides are those of the model; whether "
               "they would interlock with their neighbours is not looked at.",
               n_hiding > 0 ? text(" Of these ", n_hiding,
                                   " cannot be seen whole from the centre, and "
                                   "the stress is found in convex pieces.")
                            : "")};
}

std::vector<std::string> doubts_about(const Results &results)
{
  if (!is_loaded(results.scene))
    return {"No load acts on the packing, so that all forces are zero. The "
            "section 'Loads' gives loads."};
  std::vector<std::string> doubts;
  if (results.status.kind == Status::Kind::carried_within)
    doubts.push_back(inexact(results));
  const std::string &outcome = results.earlier_outcome.empty()
                                   ? results.outcome
                                   : results.earlier_outcome;
  if (!has_settled(outcome))
    doubts.push_back(
        "The solver " + outcome +
        ". The forces are balanced and admissible to what is said below, but "
        "may differ from those of the named selection.");
  for (const AnalysisResult &analysis : results.analyses)
    doubts.insert(doubts.end(), analysis.doubts.begin(), analysis.doubts.end());
  if (results.overturning)
    doubts.push_back(turning(results.scene.packing, *results.overturning));
  return doubts;
}

namespace
{
/** A ratio of work to dissipation that makes units doubtful. */
constexpr double ratio_of_units = 10.;
} // namespace

std::string message_of(const Collapse &collapse, const std::string &files)
{
  std::ostringstream message;
  message.precision(10); // close to the limit the ratio is hardly above one
  const bool crushes = !collapse.scene.compressive_strength.empty();
  const bool has_links = !collapse.scene.links.empty();
  const bool of_dead = collapse.loads != NotCarried::Loads::all;
  if (collapse.loads == NotCarried::Loads::dead_beside_any)
    message << "The dead loads are not carried with any factor of 'Live "
               "loads', which do no work along a mechanism of the blocks "
            << (crushes ? "in which joints may crush: along it they do "
                        : "that closes no joint: along it they do ");
  else if (of_dead)
    message << "The dead loads alone, without 'Live loads', are not carried: "
               "along a mechanism of the blocks "
            << (crushes ? "in which joints may crush they do "
                        : "that closes no joint they do ");
  else if (crushes)
    message << "The load is not carried: along a mechanism of the blocks in "
               "which joints may crush it does ";
  else
    message << "The load is not carried: along a mechanism of the blocks that "
               "closes no joint it does ";
  if (std::isfinite(collapse.proof.work_over_dissipation))
    message << collapse.proof.work_over_dissipation << " times the work that "
            << (crushes ? "joints" : "friction")
            << (has_links ? " and links" : "") << " can dissipate";
  else
    message << "work that friction does not resist";
  message << ", so that no forces within the strengths of the interfaces "
          << (has_links ? "and links " : "") << "balance "
          << (of_dead ? "them" : "it");
  if (std::isfinite(collapse.proof.work_over_dissipation))
    message
        << "; these would have to be at least that many times as large, and "
           "perhaps more";
  message << '.';
  if (std::isfinite(collapse.proof.work_over_dissipation) &&
      collapse.proof.work_over_dissipation > ratio_of_units)
    message << " So large a ratio may come of units"
            << (collapse.scene.turns()
                    ? ", or of blocks that turn about hinges, where hardly "
                      "anything slides"
                    : "")
            << ": see that lengths, loads and strengths have the same.";
  if (!collapse.parts.empty())
    message << " Most is done by " << collapse.parts.front().name << ", "
            << std::lround(100. * share_of_first(collapse.parts))
            << "% of the work that is put in. "
            << (files.empty() ? "Change" : "See " + files + "; change")
            << " 'Loads' or raise 'Friction/"
            << (collapse.scene.coefficient.empty() ? "Strength" : "Coefficient")
            << '\'' << (has_links ? ", or change 'Ties' or 'Fill'." : ".");
  if (collapse.loads == NotCarried::Loads::dead)
    message << " Whether they are carried beside some factor of 'Live loads' "
               "is not known.";
  return message.str();
}
} // namespace Voussoir
