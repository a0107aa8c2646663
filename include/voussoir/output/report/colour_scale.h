// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_colour_scale_h
#define voussoir_output_report_colour_scale_h

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * The colours of values: steps from light to dark if all have one sign, so that
 * the darkest is the largest size, or from blue over grey to orange. Both can
 * be told apart by those who see few colours, the first also in grey.
 */
class ColourScale
{
public:
  /**
   * @param name a letter or a word, with which the classes begin.
   * @param values of which it shows the range; others than finite ones have a
   *   class of their own.
   */
  ColourScale(std::string name, const std::vector<double> &values);
  /** Values from zero to @p most, one sign. */
  ColourScale(std::string name, double most);

  /** The number of colours: an odd one, so that zero has its own. */
  static constexpr unsigned int n_steps = 17;

  /** The number of the colour of a finite @p value, below n_steps. */
  unsigned int step(double value) const;
  /** The colours in order, n_steps of them as "#rrggbb". */
  std::vector<std::string> colours() const;
  /** The class of @p value, such as "s12". */
  std::string class_of(double value) const;
  /** The share of the largest size that @p value has, between 0 and 1. */
  double share(double value) const;
  /** True if values of both signs are there. */
  bool has_both_signs() const { return low < 0. && high > 0.; }
  /**
   * Rules of CSS that give each class its colour as `--colour` and the share of
   * the largest size as `--share`, for the children of @p selector.
   */
  std::string rules(const std::string &selector) const;
  /** The legend as HTML, under the title @p title. */
  std::string legend(const std::string &title) const;

private:
  /** The value in the middle of a step. */
  double middle(double step) const;

  std::string name;
  /** The range of values, with zero in it. */
  double low = 0., high = 0.;
  bool has_missing = false;
};

/** A text with the signs of HTML written as what they stand for. */
std::string html_text(const std::string &text);
} // namespace Voussoir

#endif
