// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/scene/proofs/certificate_measures.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace Voussoir
{
namespace
{
/** A load, relative to the largest of the scene, that is rounding. */
constexpr double rounding_of_loads = 1e-12;
constexpr double infinitely_large = std::numeric_limits<double>::infinity();
/** The largest relative closing of a joint in a mechanism, for rounding. */
constexpr double largest_closing = 1e-12;
/** The largest MechanismCertificate::share_of_closing: normal forces may be
 * some times the largest load. */
constexpr double largest_share = 0.1;

/** Whether a motion is infinite or no number, which slips through comparisons.
 */
bool is_no_number(const WorkOfMotion &of)
{
  return !std::isfinite(of.largest) || std::isnan(of.dissipation);
}
} // namespace

std::vector<double> reference_forces(const std::vector<unsigned int> &group,
                                     const std::vector<double> &load,
                                     const double largest_force)
{
  std::vector<double> reference(group.size(), 0.);
  double largest_load = 0.;
  for (unsigned int c = 0; c < load.size(); ++c)
  {
    double &largest = reference[group[c]];
    largest = std::max(largest, load[c]);
    largest_load = std::max(largest_load, largest);
  }
  for (double &largest : reference)
    if (!(largest > rounding_of_loads * largest_load))
      largest = largest_load > 0. ? largest_load : largest_force;
  std::vector<double> of_cell;
  for (unsigned int c = 0; c < load.size(); ++c)
    of_cell.push_back(reference[group[c]]);
  return of_cell;
}

void RelativeErrors::add(double &largest,
                         const LargestError::Kind kind,
                         const double error,
                         const unsigned int cell)
{
  if (!(reference[cell] > 0.)) // there is nothing to be compared
    return;
  const double relative = error / reference[cell];
  largest = std::max(largest, relative);
  if (relative > certificate.largest.relative &&
      (kind != LargestError::Kind::moment || turns))
    certificate.largest = {kind, cell, error, relative};
}

/** They would slip through every comparison. */
Certificate infinitely_wrong()
{
  return {infinitely_large,
          infinitely_large,
          infinitely_large,
          infinitely_large,
          infinitely_large,
          0., // loads are not to blame
          {},
          {}};
}

bool proves_collapse(const MechanismCertificate &certificate)
{
  return certificate.closing_violation <= largest_closing &&
         certificate.work_over_dissipation > 1. &&
         certificate.share_of_closing < largest_share &&
         certificate.load_residual <= largest_load_residual;
}

MechanismCertificate certificate_of(const WorkOfMotion &of,
                                    const double work,
                                    const double largest_load)
{
  MechanismCertificate certificate;
  certificate.closing_violation = of.closing_violation();
  if (is_no_number(of) || std::isnan(work)) // it proves nothing
  {
    certificate.closing_violation = infinitely_large;
    return certificate;
  }
  if (work > 0.)
    certificate.work_over_dissipation =
        of.dissipation > 0. ? work / of.dissipation : infinitely_large;
  if (of.all_closings > 0.)
    certificate.share_of_closing =
        work > of.dissipation
            ? of.all_closings * largest_load / (work - of.dissipation)
            : infinitely_large;
  return certificate;
}

FactorBound
bound_by(const WorkOfMotion &of, const double dead_work, const double live_work)
{
  FactorBound bound;
  if (is_no_number(of) || std::isnan(dead_work) || std::isnan(live_work))
    return {infinitely_large, 0., infinitely_large};
  bound.live_work = live_work;
  bound.factor = live_work != 0. ? (of.dissipation - dead_work) / live_work
                                 : infinitely_large;
  bound.closing_violation = of.closing_violation();
  return bound;
}
} // namespace Voussoir
