// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_output_random_loads_h
#define voussoir_tests_output_random_loads_h

#include "tests.h"
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

// Random loads of all kinds as a .prm file has them, and what they add up to,
// by arithmetic that the program has no part in.

inline std::mt19937_64 engine(1);

inline double uniform(const double low, const double high)
{
  return low + (high - low) * std::ldexp(double(engine() >> 11), -53);
}

inline unsigned int whole(const unsigned int low, const unsigned int high)
{
  return low + engine() % (high - low + 1);
}

inline dealii::Tensor<1, 2> random_force()
{
  return dealii::Tensor<1, 2>({uniform(-1., 1.), uniform(-1., 1.)});
}

inline std::string pair(const dealii::Tensor<1, 2> &v)
{
  return digits(v[0]) + ", " + digits(v[1]);
}

/** Forces, and their moments about a point. */
struct Sum
{
  void add(const dealii::Point<2> &place,
           const dealii::Tensor<1, 2> &f,
           const double couple = 0.)
  {
    force += f;
    moment += Voussoir::cross(place - about, f) + couple;
    size += f.norm();
  }
  void add(const double factor, const Sum &other)
  {
    force += factor * other.force;
    moment += factor * other.moment;
    size += std::abs(factor) * other.size;
  }

  dealii::Point<2> about;
  dealii::Tensor<1, 2> force;
  double moment = 0., size = 0.;
};

/** The difference of two sums, over the size of one and a length. */
inline double difference(const Sum &a, const Sum &b, const double length)
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
  dealii::Tensor<1, 2> operator()(const dealii::Point<2> &p) const
  {
    dealii::Tensor<1, 2> value;
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
  using Ring = std::vector<dealii::Point<2>>;
  struct Edge
  {
    dealii::Point<2> start, end;
    dealii::Tensor<1, 2> normal;
  };

  dealii::Point<2> centroid(const unsigned int c) const
  {
    const Ring &r = cells[c];
    double area = 0.;
    dealii::Tensor<1, 2> moment;
    for (unsigned int i = 1; i + 1 < r.size(); ++i)
    {
      const dealii::Tensor<1, 2> a = r[i] - r[0], b = r[i + 1] - r[0];
      area += 0.5 * Voussoir::cross(a, b);
      moment += Voussoir::cross(a, b) / 6. * (a + b);
    }
    return r[0] + moment / area;
  }
  double area(const unsigned int c) const
  {
    return Voussoir::signed_area(cells[c]);
  }
  /** A place in a cell, or on its boundary. */
  dealii::Point<2> place_in(const unsigned int c) const
  {
    const Ring &r = cells[c];
    const unsigned int i = whole(0, r.size() - 1);
    const dealii::Point<2> on_side =
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
inline void add_over_cell(const Geometry &on,
                          const unsigned int c,
                          const Polynomial &b,
                          Sum &sum)
{
  const Geometry::Ring &r = on.cells[c];
  for (unsigned int i = 1; i + 1 < r.size(); ++i)
  {
    const dealii::Tensor<1, 2> u = r[i] - r[0], v = r[i + 1] - r[0];
    const double area = 0.5 * Voussoir::cross(u, v);
    const auto add = [&](const double s, const double t, const double weight) {
      const dealii::Point<2> x = r[0] + s * u + t * v;
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
void add_over_line(const dealii::Point<2> &a,
                   const dealii::Point<2> &b,
                   const Traction &g,
                   Sum &sum)
{
  const double length = a.distance(b), s = std::sqrt(0.6);
  for (const auto &[at, weight] :
       {std::pair(-s, 5. / 18.), std::pair(0., 8. / 18.),
        std::pair(s, 5. / 18.)})
  {
    const dealii::Point<2> x = a + 0.5 * (1. + at) * (b - a);
    sum.add(x, weight * length * g(x, 0.5 * (1. + at)));
  }
}

/** A section of loads, and what it asks for. */
class RandomLoads
{
public:
  RandomLoads(const Geometry &on, const dealii::Point<2> &about) : on(on)
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
            [&](const dealii::Point<2> &x, double) { return g(x); }, on_edges);
  }

  void add_segment()
  {
    const auto &edge = on.edges[whole(0, on.edges.size() - 1)];
    const double s = uniform(0., 0.5), t = uniform(0.5, 1.);
    dealii::Point<2> a = edge.start + s * (edge.end - edge.start);
    dealii::Point<2> b = edge.start + t * (edge.end - edge.start);
    if (whole(0, 1) == 0)
      std::swap(a, b);
    const dealii::Tensor<1, 2> first = random_force();
    const dealii::Tensor<1, 2> last = whole(0, 1) == 0 ? first : random_force();
    append(segments, pair(a) + " to " + pair(b) + ": " + pair(first) +
                         (last == first ? "" : " to " + pair(last)));
    add_over_line(
        a, b,
        [&](const dealii::Point<2> &, const double t) {
          return first + t * (last - first);
        },
        on_edges);
  }

  void add_even_force()
  {
    const unsigned int c = whole(0, on.cells.size() - 1);
    const dealii::Tensor<1, 2> f = random_force();
    append(forces, "cell " + std::to_string(c) + ": " + pair(f));
    on_cells.add(on.centroid(c), f);
  }

  void add_force_in_cell()
  {
    const unsigned int c = whole(0, on.cells.size() - 1);
    const dealii::Point<2> x = on.place_in(c);
    const dealii::Tensor<1, 2> f = random_force();
    append(forces,
           "cell " + std::to_string(c) + ": " + pair(f) + " at " + pair(x));
    on_cells.add(x, f);
  }

  void add_force_at_place()
  {
    const dealii::Point<2> x = on.place_in(whole(0, on.cells.size() - 1));
    const dealii::Tensor<1, 2> f = random_force();
    append(forces, "at " + pair(x) + ": " + pair(f));
    on_cells.add(x, f);
  }

  const Geometry &on;
  std::string entries, segments, forces;
  bool body = false, traction = false;
};

#endif
