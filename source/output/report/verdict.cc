// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/text.h>
#include <voussoir/output/report/verdict.h>
#include <voussoir/output/summary/messages.h>

#include <boost/algorithm/string/replace.hpp>

#include <cmath>

namespace Voussoir
{
namespace
{
/** What a ratio has above one where four digits would not tell it from one. */
constexpr double hardly_above_one = 5e-4;

/** A number with four digits. */
std::string four_digits(const double x)
{
  return text_with_digits(x, 4);
}

/** A number with two digits, such as an error. */
std::string two_digits(const double x)
{
  return text_with_digits(x, 2);
}

/** An AnalysisResult::sentence with the units of the user. */
std::string with_units(std::string sentence, const UnitNames &names)
{
  for (const auto &[mark, unit] :
       {std::pair("{L}", names.length), std::pair("{F}", names.force)})
    boost::algorithm::replace_all(sentence, mark,
                                  unit.empty() ? "" : ' ' + unit);
  return sentence;
}

/** What an analysis has found, with few digits. */
std::string answer_of(const AnalysisResult &analysis, const UnitNames &names)
{
  return analysis.sentence.empty()
             ? analysis.title + ": " + analysis.description + "."
             : with_units(analysis.sentence, names);
}

std::string certificate_of(const Results &results)
{
  const Certificate &of = results.certificate;
  std::string words =
      text("Computed from the forces alone: the forces on each block add up to "
           "zero within ",
           two_digits(of.equilibrium_residual),
           " of the largest load on a block, and no joint bears more than its "
           "limits by more than ",
           two_digits(of.admissibility_violation), " of it.");
  if (results.scene.turns())
    words += text(" Their moments add up to zero within ",
                  two_digits(of.moment_residual),
                  " of that load times the size of the block.");
  else
    words += text(" Blocks do not turn, and moments up to ",
                  two_digits(of.max_torque),
                  " of that load times the size of the block remain.");
  return words;
}

std::string certificate_of(const Collapse &collapse)
{
  const MechanismCertificate &of = collapse.proof;
  return text("Computed from the motion alone: no joint closes by more than ",
              two_digits(of.closing_violation),
              " of the largest displacement, and the loads do ",
              std::isfinite(of.work_over_dissipation)
                  ? text(text_to_copy(of.work_over_dissipation),
                         " times the work that the joints can dissipate.")
                  : "work that the joints do not resist.");
}

/** What the loads do along the mechanism, in words. */
std::string work_of(const MechanismCertificate &proof)
{
  const double ratio = proof.work_over_dissipation;
  if (!std::isfinite(ratio))
    return "work that nothing resists.";
  if (ratio - 1. < hardly_above_one)
    return "more work than joints can dissipate, by " + two_digits(ratio - 1.) +
           " of it.";
  return four_digits(ratio) + " times the work that joints can dissipate.";
}
} // namespace

ReportVerdict verdict_of(const Results &results, const UnitNames &names)
{
  const bool is_solved = results.status.kind == Status::Kind::solved;
  ReportVerdict verdict = {
      is_solved ? "carried" : "within",
      sentence_of(results.status, results.scene.packing.n_supports() > 0),
      {},
      {}};
  for (const AnalysisResult &analysis : results.analyses)
  {
    const std::string answer = answer_of(analysis, names);
    if (analysis.is_verdict)
    {
      if (!is_solved)
        verdict.beside.push_back(verdict.sentence);
      verdict.sentence = answer;
      verdict.proof.push_back(analysis.title + ": " + analysis.description +
                              ".");
    }
    else
      verdict.beside.push_back(answer);
  }
  verdict.proof.push_back(certificate_of(results));
  return verdict;
}

ReportVerdict verdict_of(const Collapse &collapse)
{
  const std::string loads =
      collapse.loads == NotCarried::Loads::all ? "The loads are"
      : collapse.loads == NotCarried::Loads::dead
          ? "The dead loads alone are"
          : "The dead loads, with any factor of the live ones, are";
  return {"collapse",
          loads + " not carried: along the mechanism they do " +
              work_of(collapse.proof),
          {},
          {message_of(collapse, ""), certificate_of(collapse)}};
}
} // namespace Voussoir
