// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/text.h>
#include <voussoir/formula/integrals/inaccuracies.h>

namespace Voussoir
{
namespace
{
std::string and_more(const unsigned int number)
{
  return number > 1 ? text(", and on ", number - 1, " more") : std::string();
}
} // namespace

Inaccuracies::Inaccuracies(const std::string &parameter,
                           const double largest_error)
    : parameter(parameter), largest_error(largest_error)
{}

void Inaccuracies::look_at(const double absolute_error,
                           const double size,
                           const double uncertain,
                           const std::function<std::string()> &where)
{
  const double error = size > 0. ? absolute_error / size : 0.;
  if (!(error <= largest_error))
    throw InputError("The expression of '" + parameter + "' varies too fast " +
                     where() + " to find its mean; make it smoother.");
  if (error > negligible_error)
    inexact.add(error, where);
  if (uncertain > negligible_error)
    undecided.add(uncertain, where);
}

void Inaccuracies::Kind::add(const double size,
                             const std::function<std::string()> &of_what)
{
  ++number;
  if (size > largest)
  {
    largest = size;
    where = of_what();
  }
}

std::string along_edge(const dealii::Point<2> &a, const dealii::Point<2> &b)
{
  return "along the edge from " + text_of_point(a) + " to " + text_of_point(b);
}

std::vector<std::string> Inaccuracies::warnings() const
{
  std::vector<std::string> warnings;
  if (inexact.number > 0)
    warnings.push_back(
        text("The mean of '", parameter, "' may be off by ", inexact.largest,
             " of its size ", inexact.where, and_more(inexact.number),
             ": the expression varies too fast there. Make it smoother."));
  if (undecided.number > 0)
    warnings.push_back(text(
        "The expression of '", parameter, "' jumps ", undecided.where,
        and_more(undecided.number), ", all along ",
        undecided.largest == 1. ? std::string("it")
                                : text(undecided.largest, " of it"),
        " to within rounding, so that it is not known which value is meant. "
        "Move the jump, as in y < 1 + 1e-9 for y < 1."));
  return warnings;
}
} // namespace Voussoir
