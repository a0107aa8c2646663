// SPDX-License-Identifier: LGPL-2.1-or-later

// Ten thousand random loads on packings of all generators: the forces and the
// moments in cells.csv and boundary.csv add up to those that were asked for.
// What was asked for is added up here from the numbers of the .prm file, with
// the vertices of packing.off: forces at their places or at centroids, and
// polynomials over edges and cells by Gauss's rules.

#include <voussoir/command_line.h>

#include "own_directory.h"
#include "table.h"
#include "tests.h"
#include <array>
#include <fstream>
#include <random>

using namespace Voussoir;
using dealii::Point;
using dealii::Tensor;

constexpr unsigned int n_loads = 10000;

std::mt19937_64 engine(1);

double uniform(const double low, const double high)
{
  return low + (high - low) * std::ldexp(double(engine() >> 11), -53);
}

unsigned int whole(const unsigned int low, const unsigned int high)
{
  return low + engine() % (high - low + 1);
}

Tensor<1, 2> random_force()
{
  return Tensor<1, 2>({uniform(-1., 1.), uniform(-1., 1.)});
}

/** A number that is read back to the last digit. */
std::string digits(const double x)
{
  std::ostringstream out;
  out.precision(17);
  out << x;
  return out.str();
}

std::string pair(const Tensor<1, 2> &v)
{
  return digits(v[0]) + ", " + digits(v[1]);
}

/** Forces, and their moments about a point. */
struct Sum
{
  void
  add(const Point<2> &place, const Tensor<1, 2> &f, const double couple = 0.)
  {
    force += f;
    moment += cross(place - about, f) + couple;
    size += f.norm();
  }
  void add(const double factor, const Sum &other)
  {
    force += factor * other.force;
    moment += factor * other.moment;
    size += std::abs(factor) * other.size;
  }

  Point<2> about;
  Tensor<1, 2> force;
  double moment = 0., size = 0.;
};

/** The difference of two sums, over the size of one and a length. */
double difference(const Sum &a, const Sum &b, const double length)
{
  return std::max((a.force - b.force).norm(),
                  std::abs(a.moment - b.moment) / length) /
         b.size;
}

/** A polynomial in x and y, two components of six coefficients. */
struct Polynomial
{
  Polynomial()
  {
    const unsigned int degree = whole(0, 2);
    for (unsigned int k = 0; k < 6; ++k)
      for (unsigned int i = 0; i < 2; ++i)
        of[i][k] = k < n_terms[degree] ? uniform(-1., 1.) : 0.;
  }
  Tensor<1, 2> operator()(const Point<2> &p) const
  {
    Tensor<1, 2> value;
    const double terms[6] = {1.,          p[0],        p[1],
                             p[0] * p[0], p[0] * p[1], p[1] * p[1]};
    for (unsigned int i = 0; i < 2; ++i)
      for (unsigned int k = 0; k < 6; ++k)
        value[i] += of[i][k] * terms[k];
    return value;
  }
  std::string words() const
  {
    const std::string terms[6] = {"1", "x", "y", "x*x", "x*y", "y*y"};
    std::string all;
    for (unsigned int i = 0; i < 2; ++i)
    {
      all += i == 0 ? "" : "; ";
      for (unsigned int k = 0; k < 6; ++k)
        if (k == 0 || of[i][k] != 0.)
          all += (k == 0 ? "(" : " + (") + digits(of[i][k]) + ")*" + terms[k];
    }
    return all;
  }

  static constexpr unsigned int n_terms[3] = {1, 3, 6};
  double of[2][6];
};

/** A packing as the files of a run have it. */
struct Geometry
{
  using Ring = std::vector<Point<2>>;
  struct Edge
  {
    Point<2> start, end;
    Tensor<1, 2> normal;
  };

  Point<2> centroid(const unsigned int c) const
  {
    const Ring &r = cells[c];
    double area = 0.;
    Tensor<1, 2> moment;
    for (unsigned int i = 1; i + 1 < r.size(); ++i)
    {
      const Tensor<1, 2> a = r[i] - r[0], b = r[i + 1] - r[0];
      area += 0.5 * cross(a, b);
      moment += cross(a, b) / 6. * (a + b);
    }
    return r[0] + moment / area;
  }
  double area(const unsigned int c) const { return signed_area(cells[c]); }
  /** A place in a cell, or on its boundary. */
  Point<2> place_in(const unsigned int c) const
  {
    const Ring &r = cells[c];
    const unsigned int i = whole(0, r.size() - 1);
    const Point<2> on_side =
        r[i] + uniform(0., 1.) * (r[(i + 1) % r.size()] - r[i]);
    const bool is_star = concave == 0;
    const double inwards = is_star && whole(0, 3) > 0 ? uniform(0., 1.) : 0.;
    return on_side + inwards * (centroid(c) - on_side);
  }

  std::vector<Ring> cells;
  std::vector<Edge> edges;
  unsigned int concave = 0;
  double length = 0.;
};

/** Add a polynomial over a cell: a rule of degree 3 on signed triangles. */
void add_over_cell(const Geometry &on,
                   const unsigned int c,
                   const Polynomial &b,
                   Sum &sum)
{
  const Geometry::Ring &r = on.cells[c];
  for (unsigned int i = 1; i + 1 < r.size(); ++i)
  {
    const Tensor<1, 2> u = r[i] - r[0], v = r[i + 1] - r[0];
    const double area = 0.5 * cross(u, v);
    const auto add = [&](const double s, const double t, const double weight) {
      const Point<2> x = r[0] + s * u + t * v;
      sum.add(x, weight * area * b(x));
    };
    add(1. / 3., 1. / 3., -27. / 48.);
    add(0.6, 0.2, 25. / 48.);
    add(0.2, 0.6, 25. / 48.);
    add(0.2, 0.2, 25. / 48.);
  }
}

/** Add a traction over a part of an edge, by Gauss's rule of degree 5. */
template <typename Traction>
void add_over_line(const Point<2> &a,
                   const Point<2> &b,
                   const Traction &g,
                   Sum &sum)
{
  const double length = a.distance(b), s = std::sqrt(0.6);
  for (const auto &[at, weight] :
       {std::pair(-s, 5. / 18.), std::pair(0., 8. / 18.),
        std::pair(s, 5. / 18.)})
  {
    const Point<2> x = a + 0.5 * (1. + at) * (b - a);
    sum.add(x, weight * length * g(x, 0.5 * (1. + at)));
  }
}

/** A section of loads, and what it asks for. */
class RandomLoads
{
public:
  RandomLoads(const Geometry &on, const Point<2> &about) : on(on)
  {
    on_cells.about = on_edges.about = about;
  }

  void add_one()
  {
    ++n;
    switch (whole(0, 5))
    {
    case 0: return body ? add_one() : add_body();
    case 1: return traction ? add_one() : add_traction();
    case 2: return on.edges.empty() ? add_one() : add_segment();
    case 3: return add_even_force();
    case 4: return add_force_in_cell();
    default: return add_force_at_place();
    }
  }

  std::string settings() const
  {
    return entries + "set Segment tractions = " + segments +
           "\nset Cell forces = " + forces + "\n";
  }

  /** Of all in cells and on edges; the number of loads. */
  Sum on_cells, on_edges;
  unsigned int n = 0;

private:
  static void append(std::string &list, const std::string &element)
  {
    list += (list.empty() ? "" : " | ") + element;
  }

  void add_body()
  {
    body = true;
    const Polynomial everywhere, of_one;
    const unsigned int other = whole(0, on.cells.size() - 1);
    entries += "set Body force = " + everywhere.words() +
               "\nset Group body forces = cell " + std::to_string(other) +
               ": " + of_one.words() + "\n";
    for (unsigned int c = 0; c < on.cells.size(); ++c)
      add_over_cell(on, c, c == other ? of_one : everywhere, on_cells);
  }

  void add_traction()
  {
    traction = true;
    const Polynomial g;
    const double a = uniform(-1., 1.);
    entries += "set Traction = " + g.words() + "\nset Where = nx > " +
               digits(a) + "\n";
    bool any = false;
    for (const auto &edge : on.edges)
      any |= edge.normal[0] > a;
    if (!any)
      entries += "set Where = 1\n";
    for (const auto &edge : on.edges)
      if (!any || edge.normal[0] > a)
        add_over_line(
            edge.start, edge.end,
            [&](const Point<2> &x, double) { return g(x); }, on_edges);
  }

  void add_segment()
  {
    const auto &edge = on.edges[whole(0, on.edges.size() - 1)];
    const double s = uniform(0., 0.5), t = uniform(0.5, 1.);
    Point<2> a = edge.start + s * (edge.end - edge.start);
    Point<2> b = edge.start + t * (edge.end - edge.start);
    if (whole(0, 1) == 0)
      std::swap(a, b);
    const Tensor<1, 2> first = random_force();
    const Tensor<1, 2> last = whole(0, 1) == 0 ? first : random_force();
    append(segments, pair(a) + " to " + pair(b) + ": " + pair(first) +
                         (last == first ? "" : " to " + pair(last)));
    add_over_line(
        a, b,
        [&](const Point<2> &, const double t) {
          return first + t * (last - first);
        },
        on_edges);
  }

  void add_even_force()
  {
    const unsigned int c = whole(0, on.cells.size() - 1);
    const Tensor<1, 2> f = random_force();
    append(forces, "cell " + std::to_string(c) + ": " + pair(f));
    on_cells.add(on.centroid(c), f);
  }

  void add_force_in_cell()
  {
    const unsigned int c = whole(0, on.cells.size() - 1);
    const Point<2> x = on.place_in(c);
    const Tensor<1, 2> f = random_force();
    append(forces,
           "cell " + std::to_string(c) + ": " + pair(f) + " at " + pair(x));
    on_cells.add(x, f);
  }

  void add_force_at_place()
  {
    const Point<2> x = on.place_in(whole(0, on.cells.size() - 1));
    const Tensor<1, 2> f = random_force();
    append(forces, "at " + pair(x) + ": " + pair(f));
    on_cells.add(x, f);
  }

  const Geometry &on;
  std::string entries, segments, forces;
  bool body = false, traction = false;
};

/** What every scene has: joints that carry all, and the packing in a file. */
const std::string common =
    "set Accuracy = draft\nset Formulation = least energy\n"
    "subsection Output\n set Files = csv\n set Report = false\n"
    " set Packing = OFF\nend\n"
    "subsection Friction\n set Strength = 100\nend\n"
    "subsection Contact\n set Tensile strength = 100\nend\n";

int run(const std::string &settings)
{
  std::ofstream("scene.prm") << common << settings;
  std::ostringstream out, error;
  const int status = run_command_line({"scene.prm"}, out, error);
  if (status != 0)
    std::cout << "FAILED: status " << status << ' ' << error.str() << settings;
  return status;
}

Geometry read_geometry()
{
  Geometry on;
  std::ifstream off("output/packing.off");
  std::string word;
  unsigned int n_vertices, n_cells, n_edges;
  off >> word >> n_vertices >> n_cells >> n_edges;
  Geometry::Ring vertices(n_vertices);
  double z;
  for (Point<2> &v : vertices)
    off >> v[0] >> v[1] >> z;
  on.cells.resize(n_cells);
  for (Geometry::Ring &ring : on.cells)
  {
    unsigned int n, k;
    off >> n;
    for (unsigned int i = 0; i < n; ++i)
    {
      off >> k;
      ring.push_back(vertices[k]);
    }
    for (unsigned int i = 0; i < n; ++i)
      on.concave += cross(ring[(i + 1) % n] - ring[i],
                          ring[(i + 2) % n] - ring[(i + 1) % n]) < -1e-9;
  }
  Table b = read_table("output/boundary.csv");
  for (unsigned int k = 0; k < b["nx"].size(); ++k)
    on.edges.push_back({{b["x0"][k], b["y0"][k]},
                        {b["x1"][k], b["y1"][k]},
                        Tensor<1, 2>({b["nx"][k], b["ny"][k]})});
  const dealii::BoundingBox<2> box(vertices);
  on.length = std::hypot(box.side_length(0), box.side_length(1));
  return on;
}

/** The sum of the tractions in boundary.csv. */
Sum sum_of_edges(const Point<2> &about)
{
  Sum sum;
  sum.about = about;
  Table b = read_table("output/boundary.csv");
  for (unsigned int k = 0; k < b["nx"].size(); ++k)
    sum.add(Point<2>(0.5 * (b["x0"][k] + b["x1"][k]),
                     0.5 * (b["y0"][k] + b["y1"][k])),
            Tensor<1, 2>({b["force_x"][k], b["force_y"][k]}),
            -b["ny"][k] * b["moment_y"][k] - b["nx"][k] * b["moment_x"][k]);
  return sum;
}

/**
 * The sum of the loads in cells.csv. Without rotations only the torque of all
 * forces is there, of which that of the interfaces is taken away.
 */
Sum sum_of_cells(const Point<2> &about)
{
  Sum sum;
  sum.about = about;
  Table c = read_table("output/cells.csv");
  std::vector<double> torque = c["load_torque"];
  if (torque.empty())
  {
    torque = c["torque"];
    Table e = read_table("output/interfaces.csv");
    for (unsigned int k = 0; k < e["nx"].size(); ++k)
    {
      const double n = e["normal_force"][k], t = e["tangential_force"][k];
      const Tensor<1, 2> f(
          {n * e["nx"][k] - t * e["ny"][k], n * e["ny"][k] + t * e["nx"][k]});
      const Point<2> x(0.5 * (e["x0"][k] + e["x1"][k]),
                       0.5 * (e["y0"][k] + e["y1"][k]));
      const unsigned int minus = e["cell_minus"][k];
      torque[minus] -= cross(x - Point<2>(c["x"][minus], c["y"][minus]), f);
      if (e["cell_plus"][k] < 0.)
        continue;
      const unsigned int plus = e["cell_plus"][k];
      torque[plus] += cross(x - Point<2>(c["x"][plus], c["y"][plus]), f);
    }
  }
  for (unsigned int k = 0; k < torque.size(); ++k)
    sum.add(Point<2>(c["x"][k], c["y"][k]),
            Tensor<1, 2>({c["load_x"][k], c["load_y"][k]}), torque[k]);
  return sum;
}

/** A random packing of a generator, with all or some of its boundary free. */
std::string random_packing_of(const std::string &generator)
{
  const auto number = [](const std::string &name, const double x) {
    return "set " + name + " = " + digits(x) + "\n";
  };
  const auto count = [](const std::string &name, const unsigned int n) {
    return "set " + name + " = " + std::to_string(n) + "\n";
  };
  std::string of, own = generator;
  if (generator == "Voronoi")
    of = count("Number of points", whole(3, 30)) + count("Seed", whole(1, 99));
  else if (generator == "wall")
    of = count("Courses", whole(2, 6)) +
         count("Bricks per course", whole(1, 5)) +
         number("Width", uniform(0.5, 2.)) +
         number("Height", uniform(0.5, 2.)) + "set Bond = " +
         std::array<std::string, 3>{
             {"running", "stack", "English"}}[whole(0, 2)] +
         "\n";
  else if (generator == "arch")
    of = number("Embrace", uniform(60., 180.)) +
         count("Voussoirs", whole(3, 15)) +
         number("Thickness", uniform(0.1, 0.5)) +
         count("Abutments", whole(0, 3));
  else if (generator == "honeycomb")
    of = count("Columns", whole(2, 5)) + count("Rows", whole(2, 5)) +
         number("Cell size", uniform(0.1, 1.));
  else if (generator == "perturbed grid")
    of = count("Columns", whole(2, 5)) + count("Rows", whole(2, 5)) +
         count("Seed", whole(1, 99));
  else
  {
    // An L and a Z that interlock, a gap beside them, and centres of their own.
    const double w = 0.01;
    const double x = uniform(0.3, 0.7), y = uniform(0.3, 0.7);
    std::ofstream wkt("blocks.wkt");
    wkt.precision(17);
    const auto block = [&](const std::vector<Point<2>> &ring) {
      wkt << "POLYGON ((";
      for (const Point<2> &v : ring)
        wkt << v[0] << ' ' << v[1] << ", ";
      wkt << ring[0][0] << ' ' << ring[0][1] << "))\n";
    };
    block({{0., 0.}, {1., 0.}, {1., y}, {x, y}, {x, 1.}, {0., 1.}});
    block({{x, y}, {1., y}, {1., 1.5}, {0., 1.5}, {0., 1.}, {x, 1.}});
    block({{1. + w, 0.}, {2., 0.}, {2., 1.5}, {1. + w, 1.5}});
    std::ofstream centres("centres.txt");
    centres << "0.1 0.1\n0.9 1.2\n" << uniform(1.2, 1.8) << " 0.7\n";
    of = "set File = blocks.wkt\nset Joint width = 0.02\n"
         "set Centres file = centres.txt\n";
    own = "polygons";
  }
  return std::string("set Rotations = ") + (whole(0, 1) ? "true" : "false") +
         "\nsubsection Packing\nset Generator = " + own + "\nsubsection " +
         own + '\n' + of + "end\nend\n" + "subsection Supports\nset Where = " +
         (whole(0, 9) == 0
              ? "1"
              : "nx < " + digits(uniform(-0.8, 0.)) + " || ny < -0.5") +
         "\nend\n";
}

std::string section(const std::string &name, const std::string &content)
{
  return "subsection " + name + '\n' + content + "end\n";
}

int main()
{
  work_in_own_directory();
  double worst_of_cells = 0., worst_of_edges = 0.;
  unsigned int n = 0, n_turning = 0, n_with_cases = 0;
  for (unsigned int k = 0; n < n_loads; ++k)
  {
    const std::string packing = random_packing_of(
        std::array<std::string, 6>{{"Voronoi", "wall", "arch", "honeycomb",
                                    "perturbed grid", "stones"}}[k % 6]);
    if (run(packing) != 0)
      return 0;
    const Geometry on = read_geometry();
    const Point<2> about = on.cells[0][0];
    for (unsigned int scene = 0; scene < 20; ++scene)
    {
      RandomLoads loads(on, about), of_case(on, about);
      const unsigned int n_here = whole(1, 12);
      for (unsigned int i = 0; i < n_here; ++i)
        loads.add_one();
      Sum edges = loads.on_edges, cells = loads.on_cells;
      std::string content = loads.settings(), cases;
      if (whole(0, 3) == 0)
      {
        ++n_with_cases;
        const double factor = uniform(0.1, 2.);
        const bool minus = whole(0, 1) == 0;
        for (unsigned int i = 0; i < 3; ++i)
          of_case.add_one();
        content += std::string("set Combination = ") + (minus ? "-" : "") +
                   digits(factor) + " other\n";
        cases = section("Load cases", section("other", of_case.settings()));
        edges.add(minus ? -factor : factor, of_case.on_edges);
        cells.add(minus ? -factor : factor, of_case.on_cells);
      }
      n += loads.n + of_case.n;
      if (run(packing + section("Loads", content) + cases) != 0)
        return 0;
      n_turning += read_table("output/cells.csv").count("load_torque");
      Sum all = edges;
      all.add(1., cells);
      if (edges.size > 0.)
        worst_of_edges = std::max(
            worst_of_edges, difference(sum_of_edges(about), edges, on.length));
      worst_of_cells = std::max(
          worst_of_cells, difference(sum_of_cells(about), all, on.length));
    }
  }
  check("ten thousand loads, with rotations and without, and load cases",
        n >= n_loads && n_turning > n / 30 && n_with_cases > n / 60);
  check_error("tractions in boundary.csv", worst_of_edges, 1e-12);
  check_error("loads in cells.csv", worst_of_cells, 1e-12);
}
