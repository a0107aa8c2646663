// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_layers_h
#define voussoir_output_report_layers_h

#include <voussoir/output/report/drawing.h>
#include <voussoir/output/results.h>

#include <string>

namespace Voussoir
{
/** The box around the cells of a scene and the ends of its links; lengths. */
dealii::BoundingBox<2> box_of(const Scene &scene);

/** The root of the mean area of a cell, a length to draw things by. */
double typical_size(const Packing<2> &packing);

/**
 * @{
 * A layer of the picture, which the views named by @p views show ("in-forces
 * in-stress").
 */
/** The sides that rest on the ground, hatched. */
void draw_supports(Drawing &drawing,
                   const Packing<2> &packing,
                   const std::string &views);
/**
 * Links as lines between the places where they act.
 *
 * @param forces of which the colours and widths are; null for plain lines.
 */
void draw_links(Drawing &drawing,
                const Scene &scene,
                const InterfaceForces *forces,
                const std::string &views);
/** The soil that stands on blocks. */
void draw_fill(Drawing &drawing, const Scene &scene, const std::string &views);
/** Narrow gaps that were left open. */
void draw_gaps(Drawing &drawing,
               const Packing<2> &packing,
               const std::string &views);
/** Loads as arrows. @return the force of the longest, zero without loads. */
double
draw_loads(Drawing &drawing, const Scene &scene, const std::string &views);
/**
 * The resultant of each joint that bears more than a small part of the largest,
 * along its line of action, as long and as wide as it is large. @return the
 * largest.
 */
double draw_resultants(Drawing &drawing,
                       const Scene &scene,
                       const InterfaceForces &forces,
                       const std::string &views);
/**
 * The line of thrust: a line through each block of which two joints bear most,
 * and others a small part of that, from the point of application on one to that
 * on the other, the wider the more. Only blocks that turn have one.
 */
void draw_line_of_thrust(Drawing &drawing,
                         const Scene &scene,
                         const InterfaceForces &forces,
                         const std::string &views);
/** The principal stresses of each cell as crosses. */
void draw_principal_stresses(Drawing &drawing,
                             const Packing<2> &packing,
                             const std::vector<dealii::Tensor<2, 2>> &stresses,
                             const std::string &views);
/** @} */
} // namespace Voussoir

#endif
