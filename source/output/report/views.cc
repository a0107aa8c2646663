// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/analyses/ranges/ranges.h>
#include <voussoir/base/text.h>
#include <voussoir/output/fields/tables.h>
#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/layers.h>
#include <voussoir/output/report/motion_layer.h>
#include <voussoir/output/report/views.h>
#include <voussoir/scene/proofs/displacement_jumps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace Voussoir
{
namespace
{
/** Pale colours of groups, which those who see few colours can tell apart. */
constexpr std::array<const char *, 7> group_colours = {
    {"#e6d3b3", "#b8d4e8", "#c9e2c5", "#efc3a4", "#d9c7e6", "#f3e9a0",
     "#c8c8c8"}};

/** The largest displacement that is drawn, in cells. */
constexpr double motion_in_cells = 0.5;

/** A motion is drawn as it is if that is within this factor of readable. */
constexpr double readable = 5.;

/** The largest factor of a motion, over that which is readable or drawn. */
constexpr double most_over_readable = 4., most_over_drawn = 2.;

/** A value for each cell or interface, as a class of a scale. */
struct Layering
{
  ColourScale scale;
  std::vector<double> values;
};

/** Puts views, layers and colours together. */
class PictureMaker
{
public:
  PictureMaker(const Scene &scene, const UnitNames &names)
      : picture(box_of(scene)), overlays(box_of(scene)), scene(scene),
        packing(scene.packing), names(names)
  {}

  void add_view(const std::string &id,
                const std::string &name,
                const std::string &legend)
  {
    picture.views.push_back({id, name, legend});
    picture.style += of(id) + ".in-" + id + "{display:block}\n";
  }

  /** The beginning of a selector for what is in the view. */
  static std::string of(const std::string &id)
  {
    return "#view-" + id + ":checked~.sheet ";
  }

  /** Colour the cells or the joints in the view @p id by @p values. */
  void colour(std::vector<Layering> &layers,
              const std::string &id,
              const std::string &elements,
              Layering layer)
  {
    picture.style += layer.scale.rules(of(id) + elements);
    layers.push_back(std::move(layer));
  }

  /**
   * Draw the blocks and the joints, and over them what views have drawn.
   *
   * @param in_full each as an element of its own, which the reader can point
   *   at.
   */
  Picture finish(bool in_full);

  Picture picture;
  Drawing overlays;
  const Scene &scene;
  const Packing<2> &packing;
  const UnitNames &names;
  std::vector<Layering> of_cells, of_joints;
};

std::string classes_of(const std::vector<Layering> &layers,
                       const unsigned int k)
{
  std::string classes;
  for (const Layering &layer : layers)
    classes +=
        (classes.empty() ? "" : " ") + layer.scale.class_of(layer.values[k]);
  return classes;
}

Picture PictureMaker::finish(const bool in_full)
{
  Drawing &drawing = picture.drawing;
  drawing.open("id=\"blocks\"");
  std::vector<dealii::Point<2>> corners;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
  {
    corners.clear();
    for (unsigned int i = 0; i < packing.n_sides(c); ++i)
      corners.push_back(packing.vertex(c, i));
    const std::string of_views = classes_of(of_cells, c);
    const std::string classes =
        text('g', packing.group(c) % group_colours.size(),
             of_views.empty() ? "" : " ", of_views);
    if (in_full)
      drawing.polygon(corners, classes);
    else
      drawing.add_to_path(corners, true, classes);
  }
  drawing.finish_paths();
  drawing.close();
  drawing.open("id=\"joints\"");
  const auto &interfaces = packing.interfaces();
  for (unsigned int e = 0; e < interfaces.size(); ++e)
  {
    const Packing<2>::Interface &i = interfaces[e];
    if (in_full)
      drawing.line(i.start, i.end, classes_of(of_joints, e));
    else
      drawing.add_to_path({i.start, i.end}, false, classes_of(of_joints, e));
  }
  drawing.finish_paths();
  drawing.close();
  draw_supports(drawing, packing, "in-all");
  drawing.append(overlays);
  drawing.scale_bar(names.length);
  return std::move(picture);
}

/** The swatches of the groups, if there are several. */
std::string legend_of_groups(const Packing<2> &packing)
{
  std::set<unsigned int> groups;
  for (unsigned int c = 0; c < packing.n_cells(); ++c)
    groups.insert(packing.group(c));
  std::string html;
  std::size_t n_shown = 0;
  for (const unsigned int g : groups)
    if (groups.size() > 1 && n_shown < group_colours.size())
    {
      html += text("<p><span class=\"swatch\" style=\"background:",
                   group_colours[g % group_colours.size()], "\"></span> ",
                   html_text(packing.group_names()[g]), "</p>");
      ++n_shown;
    }
  if (groups.size() > group_colours.size())
    html += text("<p>and ", groups.size() - n_shown,
                 " more groups in the same colours</p>");
  return html;
}

std::string swatch(const std::string &kind, const std::string &words)
{
  return "<p><span class=\"swatch line " + kind + "\"></span> " + words +
         "</p>";
}

/** A number with its unit, in HTML. */
std::string amount(const double number, const std::string &unit)
{
  return html_text(text_with_digits(number, 4) + (unit.empty() ? "" : " ") +
                   unit);
}

/** What links without forces look like. */
std::string legend_of_links(const Scene &scene)
{
  bool has_bars = false, has_fill = false;
  for (const Link &link : scene.links)
    (link.is_of_fill ? has_fill : has_bars) = true;
  return has_bars && has_fill ? swatch("of-link", "tie, prop, or side of fill")
         : has_bars           ? swatch("of-link", "tie or prop")
         : has_fill           ? swatch("of-link", "side of fill")
                              : "";
}

/** The structure with its supports and loads. */
void add_structure(PictureMaker &maker)
{
  for (std::size_t g = 0; g < group_colours.size(); ++g)
    maker.picture.style += text(maker.of("structure"), "#blocks .g", g,
                                "{fill:", group_colours[g], "}\n");
  Drawing &drawing = maker.overlays;
  const double largest = draw_loads(drawing, maker.scene, "in-structure");
  draw_gaps(drawing, maker.packing, "in-structure");
  std::string legend = legend_of_groups(maker.packing);
  if (maker.packing.n_supports() > 0)
    legend += swatch("of-support", "support");
  legend += largest > 0.
                ? swatch("of-load", "loads; the longest arrow is " +
                                        amount(largest, maker.names.force))
                : "<p>no loads</p>";
  draw_fill(drawing, maker.scene, "in-structure");
  draw_links(drawing, maker.scene, nullptr, "in-structure");
  if (!maker.scene.fill_columns.empty())
    legend += swatch("of-fill", "fill");
  legend += legend_of_links(maker.scene);
  if (!maker.packing.gaps().empty())
    legend += swatch("of-gap", "narrow gap that was left open");
  maker.add_view("structure", "Structure", legend);
}

void add_forces(PictureMaker &maker, const InterfaceForces &forces)
{
  Drawing &drawing = maker.overlays;
  const double largest =
      draw_resultants(drawing, maker.scene, forces, "in-forces");
  draw_line_of_thrust(drawing, maker.scene, forces, "in-forces");
  draw_links(drawing, maker.scene, &forces, "in-forces");
  std::string legend;
  if (drawing.has("resultant"))
    legend += swatch("of-resultant",
                     "resultants of the joints, as long and as wide as they "
                     "are large; the largest is " +
                         amount(largest, maker.names.force));
  else
    legend += "<p>no forces</p>";
  if (drawing.has("resultant tension"))
    legend += swatch("of-pulls", "those that pull");
  if (drawing.has("thrust"))
    legend += swatch("of-thrust",
                     "line of thrust, where two joints of a block bear most");
  if (!maker.scene.turns())
    legend += "<p>Blocks do not turn in this run: forces are drawn at the "
              "middle of the joints.</p>";
  if (drawing.has("pulls"))
    legend += swatch("of-pulls", "tie in tension");
  if (drawing.has("pushes"))
    legend += swatch("of-pushes", maker.scene.fill_columns.empty()
                                      ? "prop in compression"
                                      : "prop or fill that presses");
  if (drawing.has("yields"))
    legend += "<p>Those that yield are thicker.</p>";
  maker.add_view("forces", "Forces", legend);
}

/** A view of one value of each joint. */
void add_joint_view(PictureMaker &maker,
                    const std::string &id,
                    const std::string &name,
                    const std::string &title,
                    Layering layer)
{
  maker.add_view(id, name, layer.scale.legend(title));
  maker.colour(maker.of_joints, id, "#joints", std::move(layer));
}

std::vector<double> of_joints(const std::string &name, const Results &results)
{
  return interface_fields().values(name, results,
                                   results.scene.packing.interfaces().size());
}

void add_joint_views(PictureMaker &maker, const Results &results)
{
  const std::vector<double> forces = of_joints("normal_force", results);
  add_joint_view(
      maker, "normal", "Normal force",
      UnitNames::labelled("normal force of the joints, negative in compression",
                          maker.names.force),
      {ColourScale("n", forces), forces});
  add_joint_view(maker, "utilisation", "Utilisation",
                 "share of the strength that is used, 1 at the limit",
                 {ColourScale("u", 1.), of_joints("utilisation", results)});
  const auto *const ranges = results.data<Ranges>();
  if (ranges == nullptr || !ranges->has_interfaces())
    return;
  std::vector<double> widths = of_joints("p_max", results);
  const std::vector<double> least = of_joints("p_min", results);
  for (unsigned int e = 0; e < widths.size(); ++e)
    widths[e] -= least[e];
  add_joint_view(
      maker, "ranges", "Ranges",
      UnitNames::labelled(
          "normal force of the joints: the greatest of all states less the "
          "least",
          maker.names.force),
      {ColourScale("r", widths), widths});
}

void add_stress(PictureMaker &maker, const Results &results)
{
  const auto of_blocks = [&](const std::string &name) {
    return cell_fields().values(name, results, maker.packing.n_cells());
  };
  std::vector<double> largest = of_blocks("principal_stress_1");
  const std::vector<double> smaller = of_blocks("principal_stress_2");
  for (unsigned int c = 0; c < largest.size(); ++c)
    if (!(std::abs(largest[c]) > std::abs(smaller[c])))
      largest[c] = smaller[c];
  draw_principal_stresses(maker.overlays, maker.packing, results.mean_stresses,
                          "in-stress");
  std::string marks;
  if (maker.overlays.has("cross", "tension"))
    marks += swatch("of-cross", "principal stresses, pressure");
  if (maker.overlays.has("cross tension"))
    marks += swatch("of-tension", "principal stresses, tension");
  Layering layer{ColourScale("s", largest), largest};
  maker.add_view("stress", "Stress",
                 layer.scale.legend(UnitNames::labelled(
                     "mean stress of the blocks: the principal stress of the "
                     "larger size, tension positive",
                     maker.names.stress)) +
                     marks);
  maker.colour(maker.of_cells, "stress", "#blocks", std::move(layer));
}

/** @param name of the motion, as in "Mechanism". */
void add_motion(PictureMaker &maker,
                const Motion &motion,
                const std::string &name,
                const bool has_size)
{
  const double largest = jumps_of(maker.packing, motion).largest_displacement;
  if (largest == 0.)
    return;
  double factor = motion_in_cells * typical_size(maker.packing) / largest;
  if (has_size && factor < readable && factor > 1. / readable)
    factor = 1.;
  Drawing &drawing = maker.overlays;
  draw_motion(drawing, maker.scene, motion, factor, "in-motion");
  std::string legend =
      has_size
          ? "<p>largest displacement " + amount(largest, maker.names.length) +
                (factor == 1.
                     ? ", drawn as large as it is"
                     : ", drawn " + amount(factor, "") + " times as large") +
                "</p>"
          : "<p>a mechanism has no size: it is drawn so that it can be "
            "seen</p>";
  if (drawing.has("opens"))
    legend += swatch("of-opens", "joint that opens");
  if (drawing.has("slides"))
    legend += swatch("of-slides", "joint that slides");
  if (drawing.has("hinge"))
    legend += swatch("of-hinge", "hinge: open at the other end");
  legend += legend_of_links(maker.scene);
  maker.add_view("motion", name, legend);
  maker.picture.motion =
      DrawnMotion{&motion, factor,
                  std::max(most_over_readable * motion_in_cells *
                               typical_size(maker.packing) / largest,
                           most_over_drawn * factor),
                  largest, has_size};
}
} // namespace

Picture
picture_of(const Results &results, const UnitNames &names, const bool in_full)
{
  PictureMaker maker(results.scene, names);
  add_structure(maker);
  if (in_full)
    add_forces(maker, results.forces);
  add_joint_views(maker, results);
  if (in_full && !results.mean_stresses.empty())
    add_stress(maker, results);
  if (const MotionBeside *const beside = results.motion_beside())
    add_motion(maker, beside->motion, beside->title, beside->has_size);
  else if (in_full)
    add_motion(maker, results.motion, "Displacement", true);
  return maker.finish(in_full);
}

Picture
picture_of(const Collapse &collapse, const UnitNames &names, const bool in_full)
{
  PictureMaker maker(collapse.scene, names);
  add_motion(maker, collapse.motion, "Mechanism", false);
  add_structure(maker);
  return maker.finish(in_full);
}
} // namespace Voussoir
