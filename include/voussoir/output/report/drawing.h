// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_drawing_h
#define voussoir_output_report_drawing_h

#include <voussoir/output/summary/text_lines.h>
#include <voussoir/packing/packing.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace Voussoir
{
/**
 * Elements of SVG, for what is drawn in the coordinates of a packing. The
 * picture is 1000 of its own units wide or high, whichever is more, with y
 * downward, and places are written to a hundredth of one. How an element looks
 * is left to the style sheet, which goes by its classes.
 */
class Drawing
{
public:
  /** @param packing lies in it with a margin. */
  explicit Drawing(const Packing<2> &packing);
  /** @param box of what is drawn. */
  explicit Drawing(const dealii::BoundingBox<2> &box);

  /** The attribute viewBox of the picture: "x y width height". */
  std::string view_box() const;
  /** The length in the packing that is as long as the picture is wide or high.
   */
  double extent() const { return size; }
  /** The length in the packing of one unit of the picture. */
  double length_of_unit() const;
  /** The place in the packing that is at (0, 0) in the picture. */
  dealii::Point<2> origin() const
  {
    return {box.lower_bound(0), box.upper_bound(1)};
  }

  /** Begin a group of elements; @p attributes as in `id="blocks"`. */
  void open(const std::string &attributes);
  /** End it. */
  void close();
  /** @{ */
  /**
   * An element with the classes @p classes, "a b"; lengths of the packing.
   * Lines and dots may have further attributes, as in `data-joint="3"`.
   */
  void polygon(const std::vector<dealii::Point<2>> &corners,
               const std::string &classes);
  void polyline(const std::vector<dealii::Point<2>> &points,
                const std::string &classes);
  void line(const dealii::Point<2> &from,
            const dealii::Point<2> &to,
            const std::string &classes,
            const std::string &attributes = "");
  void dot(const dealii::Point<2> &place,
           const std::string &classes,
           const std::string &attributes = "");
  /** @} */

  /**
   * A bar of a round length below the packing, in a group with the id
   * `scale`. @param unit of lengths, or none.
   */
  void scale_bar(const std::string &unit);

  /**
   * True if an element was drawn that has the classes @p words, "a b" in the
   * order in which it has them.
   *
   * @param without a class that it has not.
   */
  bool has(const std::string &words, const std::string &without = "") const;

  /**
   * Add a polygon, or a line, to those with the same classes that
   * finish_paths() writes as one element, which is less for a browser.
   */
  void add_to_path(const std::vector<dealii::Point<2>> &points,
                   bool is_closed,
                   const std::string &classes);
  /** Write what was added, one element for each set of classes. */
  void finish_paths();
  /** Add all elements of a drawing of the same packing. */
  void append(const Drawing &other);

  /** All elements. */
  const std::string &elements() const { return content.text(); }

private:
  /** Write a length in units of the picture. */
  static void number(double x, TextLines &text);
  void place(const dealii::Point<2> &p, char between, TextLines &text) const;
  void many(const char *element,
            const std::vector<dealii::Point<2>> &points,
            const std::string &classes);
  void end_with(const std::string &classes, const std::string &attributes = "");

  dealii::BoundingBox<2> box;
  double size;
  TextLines content;
  /** The directions of the paths that are begun, by their classes. */
  std::map<std::string, TextLines> paths;
  /** The sets of classes of all elements. */
  std::set<std::string> drawn;
};
} // namespace Voussoir

#endif
