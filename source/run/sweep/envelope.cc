// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/run/sweep/envelope.h>
#include <voussoir/run/sweep/sweep_factors.h>

#include <algorithm>
#include <cmath>

namespace Voussoir
{
namespace
{
constexpr std::size_t no_run = SweepLayout::no_run;

/** Put run @p k in the place of one that says less. */
void keep_more_critical(std::size_t &kept,
                        const std::size_t k,
                        const std::vector<SweepRun> &runs)
{
  if (kept == no_run || is_more_critical(runs[k], runs[kept]))
    kept = k;
}
} // namespace

bool Envelope::exists() const
{
  return of_curve.size() > 1 &&
         std::any_of(of_curve.begin(), of_curve.end(),
                     [](const std::size_t k) { return k != no_run; });
}

Envelope envelope_of(const SweepLayout &layout,
                     const std::vector<SweepRun> &runs)
{
  const std::size_t n = layout.along.values.size();
  Envelope envelope = {std::vector<std::size_t>(n, no_run),
                       std::vector<std::size_t>(n, no_run),
                       std::vector<std::size_t>(layout.runs.size(), no_run)};
  for (std::size_t place = 0; place < n; ++place)
  {
    bool is_open = false;
    for (std::size_t curve = 0; curve < layout.runs.size(); ++curve)
    {
      const std::size_t k = layout.runs[curve][place];
      if (k == no_run)
        continue;
      is_open = is_open || runs[k].verdict == Status::Kind::collapse ||
                (!runs[k].has_answer && !runs[k].is_unloaded);
      const std::optional<double> factor = factor_of(runs[k]);
      if (!factor || !std::isfinite(*factor))
        continue;
      keep_more_critical(envelope.of_curve[curve], k, runs);
      keep_more_critical(runs[k].seeks_least ? envelope.lower[place]
                                             : envelope.upper[place],
                         k, runs);
    }
    if (is_open)
      envelope.upper[place] = envelope.lower[place] = no_run;
  }
  return envelope;
}
} // namespace Voussoir
