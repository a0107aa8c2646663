// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/exceptions.h>
#include <voussoir/base/floating_point.h>
#include <voussoir/base/text.h>
#include <voussoir/base/text_file.h>
#include <voussoir/packing/polygons/readers.h>

#ifdef VOUSSOIR_GDAL_LIBRARY
#include <voussoir/packing/polygons/ogr_dataset.h>
#endif

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <utility>

namespace Voussoir
{
#ifdef VOUSSOIR_GDAL_LIBRARY
namespace
{
/** The number of a field; below zero if there is none. */
int field_of(const OGRLayerH layer, const char *name)
{
  return gdal().OGR_FD_GetFieldIndex(gdal().OGR_L_GetLayerDefn(layer), name);
}

/** What a feature has in a field; empty if nothing. */
std::string value_of(const OGRFeatureH feature, const int field)
{
  return field < 0 || !gdal().OGR_F_IsFieldSetAndNotNull(feature, field)
             ? ""
             : gdal().OGR_F_GetFieldAsString(feature, field);
}

/** A geometry as GDAL has it, and with few and many chords for its arcs. */
struct Drawn
{
  OGRGeometryH usual;
  /** Null if the format tells of its arcs. */
  OGRGeometryH coarse, fine;

  Drawn part(const int i) const
  {
    const auto part_of = [i](const OGRGeometryH of) {
      return of == nullptr ? nullptr : gdal().OGR_G_GetGeometryRef(of, i);
    };
    return {part_of(usual), part_of(coarse), part_of(fine)};
  }
};

/** Reads one file; one object, used once. */
class OgrReader
{
public:
  OgrReader(const std::filesystem::path &file, LayerChoice layers)
      : layers(std::move(layers))
  {
    list.file = file;
    list.record_name = "feature";
  }

  PolygonList read()
  {
    gdal().GDALAllRegister();
    OgrDataset dataset(list.file);
    if (!dataset.is_open())
      refuse_file("is of none of the formats that are read" + messages.error() +
                  "; save it as .wkt, .off, GeoPackage, GeoJSON or DXF.");
    is_dxf = dataset.is_dxf();
    if (is_dxf)
    {
      constexpr const char *whole_turn = "360";
      coarse.emplace(list.file, whole_turn);
      fine.emplace(list.file, text(fine_step));
    }
    for (int i = 0; i < dataset.n_layers(); ++i)
      read_layer(dataset, i);
    layers.check(list.file.string());
    if (list.polygons.empty())
      refuse_file("has no polygons and no closed lines" + messages.error() +
                  "; a packing needs at least one.");
    give_notices();
    return std::move(list);
  }

private:
  using Kind = DrawingFault::Kind;

  [[noreturn]] void refuse(const std::string &fault,
                           const Kind kind = Kind::no_polygon) const
  {
    throw list.fault(kind, list.polygons.size(), feature, fault, detail);
  }
  /** Read a part of a feature; what has a fault counts as a cell, too. */
  template <typename Read>
  void try_to(const Read &read)
  {
    if (!list.passes(read))
    {
      list.polygons.push_back({{}, "", feature, true});
      list.polygons.back().detail = detail;
    }
  }
  [[noreturn]] void refuse_file(const std::string &fault) const
  {
    throw InputError("The file of polygons '" + list.file.string() + "' " +
                     fault);
  }

  void read_layer(OgrDataset &dataset, const int number)
  {
    const OGRLayerH layer = dataset.begin_layer(number);
    for (auto *with_step : {&coarse, &fine})
      if (*with_step)
        (*with_step)->begin_layer(number);
    const std::string layer_name =
        gdal().OGR_FD_GetName(gdal().OGR_L_GetLayerDefn(layer));
    const int layer_field = is_dxf ? field_of(layer, "Layer") : -1,
              handle_field = is_dxf ? field_of(layer, "EntityHandle") : -1;
    int group_field = -1;
    for (const char *name : {"group", "name", "Layer"})
      if (group_field < 0)
        group_field = field_of(layer, name);

    for (auto next = dataset.next(); next != nullptr; next = dataset.next())
    {
      const auto with_few = next_of(coarse), with_many = next_of(fine);
      ++feature;
      const std::string name =
          is_dxf ? value_of(next.get(), layer_field) : layer_name;
      if (!layers.takes(name))
        continue;
      group = layers.group_of(name, value_of(next.get(), group_field));
      const std::string handle = value_of(next.get(), handle_field);
      detail = "layer '" + name + "'";
      if (!handle.empty())
        detail += ", handle " + handle;
      else if (!is_dxf)
        detail += text(", id ", gdal().OGR_F_GetFID(next.get()));
      read_feature(
          {geometry_of(next), geometry_of(with_few), geometry_of(with_many)});
    }
    if (!messages.first_error.empty())
      refuse_file(text("cannot be read beyond feature ", feature,
                       messages.error(),
                       "; open and save it again with the "
                       "program that wrote it."));
  }

  static Owned<OGRFeatureH> next_of(std::optional<OgrDataset> &dataset)
  {
    return dataset ? dataset->next()
                   : Owned<OGRFeatureH>(nullptr, gdal().OGR_F_Destroy);
  }

  static OGRGeometryH geometry_of(const Owned<OGRFeatureH> &which)
  {
    return which == nullptr ? nullptr
                            : gdal().OGR_F_GetGeometryRef(which.get());
  }

  void read_feature(const Drawn &drawn)
  {
    if (drawn.usual == nullptr)
      return try_to([&] {
        refuse("has no geometry" + messages.error() + "; delete it.");
      });
    has_z |= gdal().OGR_G_Is3D(drawn.usual) != 0;
    read_geometry(drawn);
  }

  void read_geometry(const Drawn &drawn)
  {
    const OGRGeometryH geometry = drawn.usual;
    const OGRwkbGeometryType type =
        gdal().OGR_GT_Flatten(gdal().OGR_G_GetGeometryType(geometry));
    const auto is_a = [type](const OGRwkbGeometryType other) {
      return gdal().OGR_GT_IsSubClassOf(type, other) != 0;
    };
    if (gdal().OGR_G_IsEmpty(geometry))
      try_to([&] { refuse("is empty; delete it."); });
    else if (is_a(wkbGeometryCollection) || is_a(wkbMultiSurface) ||
             is_a(wkbPolyhedralSurface))
      for (int i = 0; i < gdal().OGR_G_GetGeometryCount(geometry); ++i)
        read_geometry(drawn.part(i));
    else if (is_a(wkbCurvePolygon))
      try_to([&] { read_polygon(geometry); });
    else if (is_a(wkbCurve))
      try_to([&] { add(chain(drawn), true); });
    else if (n_left_out++ == 0)
      first_left_out =
          text("feature ", feature, ", a ", gdal().OGRGeometryTypeToName(type));
  }

  /** With the chords that GDAL makes of arcs in the hatches of a DXF file. */
  void read_polygon(const OGRGeometryH polygon)
  {
    if (gdal().OGR_G_GetGeometryCount(polygon) > 1)
      refuse("has a hole; a cell is one loop, so cut it into cells without "
             "holes.",
             Kind::hole);
    add(chain_of(gdal().OGR_G_GetGeometryRef(polygon, 0)), false);
  }

  /** The vertices and arcs of a line. */
  DrawnChain chain(const Drawn &line)
  {
    const DrawnChain usual = chain_of(line.usual);
    if (usual.has_arcs() || line.coarse == nullptr || line.fine == nullptr)
      return usual;
    const DrawnChain drawn = chain_between(
        chain_of(line.coarse).points, chain_of(line.fine).points, usual.points);
    has_other_curves |= drawn.has_other_curves;
    return drawn;
  }

  void add(const DrawnChain &drawn, const bool is_line)
  {
    if (drawn.points.empty())
      refuse("has no points" + messages.error() + "; delete it.");
    PolygonList::Polygon polygon;
    polygon.ring = drawn.points;
    if (drawn.has_arcs())
      polygon.bulges = drawn.bulges;
    const bool returns =
        polygon.ring.size() > 1 && polygon.ring.front() == polygon.ring.back();
    polygon.is_line = is_line;
    polygon.is_open = is_line && !returns;
    if (returns)
      polygon.ring.pop_back();
    if (!polygon.bulges.empty())
      polygon.bulges.resize(polygon.ring.size(), 0.);
    polygon.group = group;
    polygon.record = feature;
    polygon.detail = detail;
    list.polygons.push_back(polygon);
  }

  void give_notices()
  {
    const std::string of_file = " of '" + list.file.string() + "' ";
    if (has_z)
      list.notices.push_back("The Z coordinates" + of_file + "are ignored.");
    if (has_other_curves)
      list.notices.push_back("The curves" + of_file +
                             "are replaced by chains of straight sides.");
    if (n_left_out > 0)
      list.notices.push_back(
          text(n_left_out, " geometries", of_file,
               "are left out because they bound no area; the "
               "first is ",
               first_left_out, "."));
    if (!messages.first_warning.empty())
      list.notices.push_back("On reading '" + list.file.string() +
                             "' GDAL says: " + messages.first_warning);
  }

  PolygonList list;
  LayerChoice layers;
  GdalMessages messages;
  bool is_dxf = false;
  /** The same file with few and many chords for its arcs. */
  std::optional<OgrDataset> coarse, fine;
  unsigned int feature = 0;
  /** Of the feature: the group of its cells, and what names it. */
  std::string group, detail;
  unsigned int n_left_out = 0;
  std::string first_left_out;
  bool has_z = false;
  bool has_other_curves = false;
};

/**
 * GDAL waits forever for the end of a line of a DXF with a byte 0, which the
 * binary form and damaged files have.
 */
void refuse_zero_bytes_of_dxf(const std::filesystem::path &file)
{
  std::array<char, 1000> beginning = {};
  std::ifstream(file, std::ios::binary)
      .read(beginning.data(), beginning.size());
  if (!boost::iequals(file.extension().string(), ".dxf") &&
      !boost::contains(beginning, "SECTION"))
    return;
  const std::string bytes = bytes_of_file(file).value_or("");
  if (const std::size_t place = bytes.find('\0'); place != bytes.npos)
    throw InputError(text(
        "The file of polygons '", file.string(), "' has a byte 0 in line ",
        1 + std::count(bytes.begin(), bytes.begin() + place, '\n'),
        ", as no text has; save the drawing as DXF in text (ASCII), not in "
        "the binary form."));
}
} // namespace

PolygonList read_ogr_file(const std::filesystem::path &file,
                          const LayerChoice &layers)
{
  if (!std::filesystem::exists(file))
    throw InputError("The file of polygons '" + file.string() +
                     "' does not exist. Paths in a .prm file start at the "
                     "directory of that file.");
  refuse_zero_bytes_of_dxf(file);
  // libxml2, which GDAL starts, computes 0/0 for its own NaN.
  const InvalidOperationsAllowed allowed;
  return OgrReader(file, layers).read();
}

#else

PolygonList read_ogr_file(const std::filesystem::path &file,
                          const LayerChoice &)
{
  throw InputError("The file of polygons '" + file.string() +
                   "' is read through GDAL, without which Voussoir was built. "
                   "Save the polygons as .wkt or .off, or install GDAL "
                   "(Debian: libgdal-dev) and build with VOUSSOIR_GDAL=ON.");
}

#endif
} // namespace Voussoir
