// SPDX-License-Identifier: LGPL-2.1-or-later

// The page of a packing in space: what its script reads adds up again, its
// picture has each face that is seen once and in an order in which no face
// covers a nearer one, and what cannot be shown is refused.

#include <voussoir/base/random.h>
#include <voussoir/output/report/space/isometric_view.h>
#include <voussoir/output/report/space/space_picture.h>
#include <voussoir/output/report/space_report.h>
#include <voussoir/packing/polyhedra/cell_moments.h>

#include <deal.II/base/utilities.h>

#include <nlohmann/json.hpp>

#include "boxes.h"
#include "tests.h"
#include <cstring>
#include <limits>
#include <regex>
#include <set>

namespace test_space_report
{
using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

const double infinity = std::numeric_limits<double>::infinity();

std::string page_of(const SpaceReport &report)
{
  std::ostringstream out;
  write_space_report(out, report);
  return out.str();
}

/** What stands between two texts. */
std::string between(const std::string &text,
                    const std::string &begin,
                    const std::string &end)
{
  const std::size_t from = text.find(begin);
  if (from == text.npos)
    return "";
  const std::size_t start = from + begin.size();
  return text.substr(start, text.find(end, start) - start);
}

nlohmann::json data_of(const std::string &page)
{
  return nlohmann::json::parse(between(
      page, "<script type=\"application/json\" id=\"data\">", "</script>"));
}

template <typename Number>
std::vector<Number> list(const nlohmann::json &text)
{
  const auto bytes = dealii::Utilities::decode_base64(text.get<std::string>());
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  if (!numbers.empty())
    std::memcpy(numbers.data(), bytes.data(), sizeof(Number) * numbers.size());
  return numbers;
}

/** The volume and the area of each cell, from the lists that the page has. */
struct Measures
{
  std::vector<double> volumes, areas;
};

Measures measures_of(const nlohmann::json &data)
{
  const double scale = data.at("scale");
  const auto places = list<float>(data.at("vertices"));
  const auto corners = list<std::uint32_t>(data.at("corners"));
  const auto sizes = list<std::uint32_t>(data.at("face_sizes"));
  const auto cut_faces = list<std::uint32_t>(data.at("cut_faces"));
  const auto cut = list<std::uint32_t>(data.at("cut_triangles"));
  Measures measures;
  const auto add = [&](const unsigned int a, const unsigned int b,
                       const unsigned int c) {
    std::array<Tensor<1, 3>, 3> x;
    for (unsigned int d = 0; d < 3; ++d)
    {
      x[0][d] = scale * places[3 * a + d];
      x[1][d] = scale * places[3 * b + d];
      x[2][d] = scale * places[3 * c + d];
    }
    measures.volumes.back() += x[0] * cross_product_3d(x[1], x[2]) / 6.;
    measures.areas.back() +=
        0.5 * cross_product_3d(x[1] - x[0], x[2] - x[0]).norm();
  };
  unsigned int face = 0, at = 0, n_cut = 0, cut_at = 0;
  for (const unsigned int n_faces : list<std::uint32_t>(data.at("cell_faces")))
  {
    measures.volumes.push_back(0.);
    measures.areas.push_back(0.);
    for (const unsigned int end = face + n_faces; face < end; ++face)
    {
      if (n_cut < cut_faces.size() && cut_faces[n_cut] == face)
      {
        ++n_cut;
        for (unsigned int k = 0; k + 2 < sizes[face]; ++k, cut_at += 3)
          add(cut.at(cut_at), cut.at(cut_at + 1), cut.at(cut_at + 2));
      }
      else
        for (unsigned int k = 1; k + 1 < sizes[face]; ++k)
          add(corners.at(at), corners.at(at + k), corners.at(at + k + 1));
      at += sizes[face];
    }
  }
  return measures;
}

/** A polygon of the picture. */
struct Drawn
{
  unsigned int cell;
  std::vector<Point<2>> corners;
};

std::vector<Drawn> polygons_of(const std::string &page)
{
  const std::string svg = between(page, "<svg id=\"drawing\"", "</svg>");
  std::vector<Drawn> drawn;
  const std::regex parts("data-cell=\"(\\d+)\"|points=\"([^\"]*)\"");
  unsigned int cell = 0;
  for (std::sregex_iterator part(svg.begin(), svg.end(), parts), end;
       part != end; ++part)
    if ((*part)[1].matched)
      cell = std::stoi((*part)[1]);
    else
    {
      Drawn polygon = {cell, {}};
      std::string points = (*part)[2];
      std::replace(points.begin(), points.end(), ',', ' ');
      std::istringstream in(points);
      for (Point<2> p; in >> p[0] >> p[1];)
        polygon.corners.push_back(p);
      drawn.push_back(polygon);
    }
  return drawn;
}

bool contains(const std::vector<Point<2>> &polygon, const Point<2> &p)
{
  bool is_inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point<2> &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if ((a[1] > p[1]) != (b[1] > p[1]) &&
        p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]))
      is_inside = !is_inside;
  }
  return is_inside;
}

/** Cells numbered as a field. */
SpaceField numbers(const CellFaces &cells)
{
  SpaceField field = {"Number", "", {}};
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
    field.values.push_back(c);
  return field;
}

void check_wall()
{
  std::cout << "a wall on a slab" << std::endl;
  const std::vector<Box> list_of_boxes = wall_on_slab(6, 4);
  CellFaces cells = boxes(list_of_boxes);
  cells.n_fixed = 1;
  const FaceContacts contacts = contacts_of(list_of_boxes);
  SpaceField field = numbers(cells);
  field.values[5] = infinity;
  SpaceField forces = {"Force", "kN", {}};
  for (unsigned int j = 0; j < contacts.faces.size(); ++j)
    forces.values.push_back(j % 2 ? 1. * j : -1. * j);
  const std::string page =
      page_of({"</script><b>&", &cells, &contacts, {field}, {forces}, {}, {}});

  const nlohmann::json data = data_of(page);
  const Measures measures = measures_of(data);
  const auto volumes = list<double>(data.at("volumes"));
  double error = 0.;
  for (unsigned int c = 0; c < cells.n_cells(); ++c)
  {
    const double volume = list_of_boxes[c].volume();
    error = std::max({error, std::abs(measures.volumes.at(c) / volume - 1.),
                      std::abs(volumes.at(c) / volume - 1.)});
  }
  check_error("  volumes", error, 1e-6); // of floats
  double covered = 0.;
  for (const double area : list<double>(data.at("joint_areas")))
    covered += area;
  // Beds, the lowest on the slab, and head joints.
  check_error("  area of the joints",
              std::abs(covered - (6 * 4 * 0.5 + 3 * (3 + 4) * 0.25)), 1e-12);
  check("  fields are there as they are",
        list<double>(data.at("fields")[0].at("values")) == field.values &&
            list<double>(data.at("fields")[1].at("values")) == forces.values);
  const auto steps = list<std::uint8_t>(data.at("fields")[0].at("steps"));
  check("  their colours", steps[0] == 0 && steps[26] == 16 && steps[5] == 255);
  check("  pairs of cells",
        list<std::uint32_t>(data.at("joint_cells")).size() ==
            2 * contacts.faces.size());

  // All fronts, the right faces at the end of each course, and the top.
  const std::vector<Drawn> drawn = polygons_of(page);
  check("  faces in the picture", drawn.size() == 28 + 7 + 6);
  std::set<std::vector<double>> different;
  for (const Drawn &polygon : drawn)
  {
    std::vector<double> all = {1. * polygon.cell};
    for (const Point<2> &p : polygon.corners)
      all.insert(all.end(), {p[0], p[1]});
    different.insert(all);
  }
  check("  each once", different.size() == drawn.size());
  check("  classes of values",
        page.find("data-cell=\"26\" class=\"cell c0s16\"") != page.npos &&
            page.find("data-cell=\"5\" class=\"cell c0snone\"") != page.npos &&
            page.find("data-cell=\"27\" class=\"cell fixed\"") != page.npos);
  check("  no text ends an element", page.find("</script><b>") == page.npos);
  const std::string svg = between(page, "<svg", "</svg>");
  check("  numbers alone",
        svg.find("nan") == svg.npos && svg.find("inf") == svg.npos);
}

/** The number of the box that a ray along the view meets first, or none. */
unsigned int first_met(const std::vector<Box> &list,
                       const IsometricView &view,
                       const Point<2> &place)
{
  const Point<3> on_ray =
      view.centre + place[0] * view.right + place[1] * view.up;
  unsigned int first = list.size();
  double nearest = -infinity;
  for (unsigned int k = 0; k < list.size(); ++k)
  {
    double enter = -infinity, leave = infinity;
    for (unsigned int d = 0; d < 3; ++d)
    {
      const double a = (list[k].lower_bound(d) - on_ray[d]) / view.towards[d];
      const double b = (list[k].upper_bound(d) - on_ray[d]) / view.towards[d];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (enter < leave && leave > nearest)
    {
      nearest = leave;
      first = k;
    }
  }
  return first;
}

/**
 * Layers of beams, crosswise on one another, and as different in length as to
 * lie farther by their middles than those that they hide.
 */
std::vector<Box> beams()
{
  std::vector<Box> list;
  for (unsigned int layer = 0; layer < 6; ++layer)
    for (unsigned int k = 0; k < 5; ++k)
    {
      const double z = 0.3 * layer, at = 0.8 * k, from = -2. * (k % 3);
      list.push_back(
          layer % 2 == 0
              ? box_between({from, at, z}, {5. + k % 2, at + 0.4, z + 0.3})
              : box_between({at, -from - 3., z}, {at + 0.4, 9. - k, z + 0.3}));
    }
  return list;
}

void check_order(const std::string &name, const std::vector<Box> &list)
{
  const CellFaces cells = boxes(list);
  const std::vector<Drawn> drawn =
      polygons_of(page_of({"", &cells, nullptr, {}, {}, {}, {}}));
  IsometricView view;
  view.centre = box_of(cells).center();
  // The picture is 1000 wide or high, whichever is more.
  std::vector<Point<2>> places;
  for (const Point<3> &p : cells.vertices)
    places.push_back(view.place(p));
  const dealii::BoundingBox<2> box(places);
  const double size = std::max(box.side_length(0), box.side_length(1));
  Random random(1);
  unsigned int n_wrong = 0, n_met = 0;
  for (unsigned int k = 0; k < 4000; ++k)
  {
    const Point<2> place(box.lower_bound(0) + random() * box.side_length(0),
                         box.lower_bound(1) + random() * box.side_length(1));
    const Point<2> in_picture(1000. * (place[0] - box.lower_bound(0)) / size,
                              1000. * (box.upper_bound(1) - place[1]) / size);
    unsigned int last = list.size();
    for (const Drawn &polygon : drawn)
      if (contains(polygon.corners, in_picture))
        last = polygon.cell;
    const unsigned int met = first_met(list, view, place);
    n_met += met < list.size();
    n_wrong += met != last;
  }
  // Places are written to a hundredth: points near a side may be wrong.
  std::cout << name << std::endl;
  check("  rays that meet boxes", n_met > 1000);
  check_error("  share of rays that meet another than is drawn",
              1. * n_wrong / n_met, 1e-3);
}

void check_prism()
{
  std::cout << "a prism that is not convex" << std::endl;
  CellFaces cells;
  add_prism(cells,
            {{0., 0.}, {0., 3.}, {1., 3.}, {1., 1.}, {3., 1.}, {3., 0.}});
  for (const double shift : {0., 1048576.})
    for (const double size : {1. / 1024., 1024.})
    {
      CellFaces moved = cells;
      for (Point<3> &p : moved.vertices)
        for (unsigned int d = 0; d < 3; ++d)
          p[d] = size * (p[d] + shift);
      const nlohmann::json data =
          data_of(page_of({"", &moved, nullptr, {}, {}, {}, {}}));
      const Measures measures = measures_of(data);
      check_error(
          "  volume",
          std::abs(measures.volumes[0] / (5. * size * size * size) - 1.), 1e-6);
      check_error("  area",
                  std::abs(measures.areas[0] / (22. * size * size) - 1.), 1e-6);
    }
}

void check_scale()
{
  const std::vector<Box> list = wall_on_slab(3, 3);
  const CellFaces cells = boxes(list);
  const auto svg = [](const CellFaces &cells) {
    return between(page_of({"", &cells, nullptr, {}, {}, {}, {}}), "<svg",
                   "</svg>");
  };
  bool is_same = true;
  for (const double size : {0x1p-40, 0x1p40})
    for (const double shift : {0., 4096.})
    {
      CellFaces other = cells;
      for (Point<3> &p : other.vertices)
        for (unsigned int d = 0; d < 3; ++d)
          p[d] = size * (p[d] - shift);
      is_same = is_same && svg(other) == svg(cells);
    }
  check("the picture is the same at all scales, far from the origin", is_same);
}

void check_little()
{
  const CellFaces none;
  const std::string empty = page_of(
      {"", &none, nullptr, {{"F", "", {}}}, {}, {{"a<", "b&"}}, {"c>"}});
  check("a page without blocks",
        empty.find("There are no blocks.") != empty.npos &&
            data_of(empty).at("cells") == 0);
  check("its texts",
        empty.find("<td>a&lt;</td><td>b&amp;</td>") != empty.npos &&
            empty.find("<td>c&gt;</td>") != empty.npos);
  // A cell without volume, seen from its side and from its edge.
  CellFaces flat;
  flat.vertices = {{0., 0., 0.}, {1., 0., 0.}, {1., 1., 0.}};
  flat.add_face(std::vector<unsigned int>{0, 1, 2});
  flat.add_face(std::vector<unsigned int>{2, 1, 0});
  flat.add_face(std::vector<unsigned int>{0, 1, 0});
  flat.end_cell();
  const std::string page = page_of({"", &flat, nullptr, {}, {}, {}, {}});
  check("a cell without volume has one face that is seen",
        polygons_of(page).size() == 1);
  // As many faces as are drawn, and one more.
  std::vector<Box> list;
  for (unsigned int k = 0; k < most_faces_in_picture / 3; ++k)
    list.push_back(box_between({2. * k, 0., 0.}, {2. * k + 1., 1., 1.}));
  const auto all_drawn = [](const std::vector<Box> &list) {
    const CellFaces cells = boxes(list);
    return faces_in_picture(cells, nullptr).size() <= most_faces_in_picture;
  };
  const bool as_many = all_drawn(list);
  list.push_back(box_between({-2., 0., 0.}, {-1., 1., 1.}));
  check("the largest picture", as_many && !all_drawn(list));
}

void check_refusals()
{
  const std::vector<Box> list = wall_on_slab(1, 2);
  CellFaces cells = boxes(list);
  FaceContacts contacts = contacts_of(list);
  const auto refuse = [&] {
    show_refusal([&] { page_of({"", &cells, &contacts, {}, {}, {}, {}}); });
  };
  show_refusal([&] {
    page_of({"", &cells, &contacts, {{"Weight", "kN", {1.}}}, {}, {}, {}});
  });
  show_refusal([&] {
    page_of({"", &cells, nullptr, {}, {{"Force", "kN", {1., 2.}}}, {}, {}});
  });
  contacts.faces[2] = {{3, 99}};
  refuse();
  contacts = contacts_of(list);
  contacts.patches.vertices[0][1] = infinity;
  refuse();
  contacts = contacts_of(list);
  contacts.faces.pop_back();
  refuse();
  contacts = contacts_of(list);
  cells.vertices[9][2] = 1e200;
  refuse();
  cells.file = "blocks.obj";
  cells.records = {3, 17, 25};
  cells.vertices[9][2] = std::numeric_limits<double>::quiet_NaN();
  refuse();
  cells.vertices[9][2] = 0.;
  cells.loops[30] = 77;
  refuse();
}

void run()
{
  check_wall();
  check_order("a wall on a slab", wall_on_slab(5, 3));
  check_order("beams crosswise on one another", beams());
  check_prism();
  check_scale();
  check_little();
  check_refusals();
}

const RoomTest test("space_report", run);
} // namespace test_space_report
