// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_space_space_picture_h
#define voussoir_output_report_space_space_picture_h

#include <voussoir/output/report/colour_scale.h>
#include <voussoir/output/report/drawing.h>
#include <voussoir/output/report/space/report_content.h>

#include <deal.II/base/bounding_box.h>

#include <string>
#include <vector>

namespace Voussoir
{
/**
 * The largest number of faces of a picture, more than which a browser shows
 * slowly: those of some 5,000 blocks that lie apart.
 */
constexpr unsigned int most_faces_in_picture = 15000;

/**
 * The numbers of the faces that look towards the viewer of an isometric view
 * and are not covered by joints as a whole, ascending.
 */
std::vector<unsigned int> faces_in_picture(const CellFaces &cells,
                                           const FaceContacts *contacts);

/**
 * An isometric picture of blocks as SVG: a group of the class "cell" for each
 * block with its number as `data-cell`, and in it a polygon for each of its
 * faces, with a class "l0" to "l8" for how light it is. A block has the class
 * "fixed", or those of its values in the colour scales.
 *
 * @param faces of faces_in_picture(), at least one.
 * @param scales one for each of SpaceReport::cell_fields.
 */
Drawing space_picture(const SpaceReport &report,
                      const std::vector<unsigned int> &faces,
                      const std::vector<ColourScale> &scales);

/** Rules of CSS for the classes "l0" to "l8" of a picture. */
std::string light_rules();
} // namespace Voussoir

#endif
