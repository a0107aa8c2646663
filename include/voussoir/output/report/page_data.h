// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_page_data_h
#define voussoir_output_report_page_data_h

#include <voussoir/output/report/details.h>
#include <voussoir/output/report/page_parts.h>
#include <voussoir/output/report/views.h>
#include <voussoir/output/results.h>

namespace Voussoir
{
/** The largest number of cells of which a page shows all. */
constexpr unsigned int most_cells_in_full = 20000;

/** True if a page shows all of a run. */
bool is_in_full(const RunRecord &run);

/** @{ */
/**
 * What the script of a page knows beside the picture: scale and units as JSON
 * (`data`), the tables of the .csv files (`blocks`, `joints`, `links`) and, if
 * @p picture shows a motion that they have not, its tables (`motion`, `jumps`).
 * Tables are empty where is_in_full() is false. And the `hint` for the reader.
 */
PageParts page_data_of(const Results &results,
                       const Picture &picture,
                       const UnitNames &names);
PageParts page_data_of(const Collapse &collapse,
                       const Picture &picture,
                       const UnitNames &names);
/** @} */
/** Without results. */
PageParts page_data_of(const Picture &picture);
} // namespace Voussoir

#endif
