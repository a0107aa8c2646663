// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_output_report_layer_h
#define voussoir_output_report_layer_h

#include <voussoir/output/report/drawing.h>

#include <string>

namespace Voussoir
{
/** A group of elements that some views show, open while this object lives. */
class Layer
{
public:
  /** @param views of which it is a part, as in "in-forces in-stress". */
  Layer(Drawing &drawing, const std::string &id, const std::string &views)
      : drawing(drawing)
  {
    drawing.open("id=\"" + id + "\" class=\"layer " + views + '"');
  }
  Layer(const Layer &) = delete;
  ~Layer() { drawing.close(); }

private:
  Drawing &drawing;
};
} // namespace Voussoir

#endif
