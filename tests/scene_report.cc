// SPDX-License-Identifier: LGPL-2.1-or-later

// Run a scene through the command line, read its files back, and print what a
// reader can check by hand: counts, ranges of stresses, and the equilibrium of
// every cell recomputed from the .csv files alone.

#include <voussoir/base/floating_point.h>
#include <voussoir/run/command_line/command_line.h>

#include <nlohmann/json.hpp>

#include "table.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <sstream>

namespace
{
void print_range(const std::string &name, const std::vector<double> &values)
{
  if (values.empty())
    return;
  // Four digits are the physics; what is below 1e-7 is rounding.
  const auto rounded = [](const double x) {
    std::ostringstream out;
    out.precision(4);
    out << (std::abs(x) < 1e-7 ? 0. : x);
    return out.str();
  };
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  std::cout << name << ": " << rounded(*low) << " to " << rounded(*high)
            << std::endl;
}

/** The largest torque on a cell, over the largest load times the cell's size.
 */
double largest_torque(const Table &cells, const Table &interfaces)
{
  std::vector<double> sum = cells.at("load_torque");
  double largest_load = 0., largest = 0.;
  for (unsigned int c = 0; c < sum.size(); ++c)
    largest_load = std::max(
        largest_load, std::hypot(cells.at("load_x")[c], cells.at("load_y")[c]));
  for (unsigned int e = 0; e < interfaces.at("nx").size(); ++e)
  {
    const auto of = [&](const std::string &name) {
      return interfaces.at(name)[e];
    };
    // Friction acts along the edge, at either end.
    const auto add = [&](const double cell, const std::string &end,
                         const double fn, const double ft) {
      if (cell < 0.)
        return;
      const double x = of("x" + end) - cells.at("x")[cell];
      const double y = of("y" + end) - cells.at("y")[cell];
      sum[cell] += x * (fn * of("ny") + ft * of("nx")) -
                   y * (fn * of("nx") - ft * of("ny"));
    };
    for (const double sign : {1., -1.})
    {
      const double cell = of(sign > 0. ? "cell_minus" : "cell_plus");
      add(cell, "0", sign * of("normal_force_0"),
          sign * of("tangential_force"));
      add(cell, "1", sign * of("normal_force_1"), 0.);
    }
  }
  for (unsigned int c = 0; c < sum.size(); ++c)
    largest =
        std::max(largest, std::abs(sum[c]) / std::sqrt(cells.at("area")[c]));
  return largest / largest_load;
}

double largest_imbalance(const Table &cells, const Table &interfaces)
{
  const unsigned int n = cells.at("id").size();
  std::vector<std::array<double, 2>> sum(n);
  std::array<double, 2> ground = {{0., 0.}};
  double largest_load = 0., largest = 0.;
  for (unsigned int c = 0; c < n; ++c)
  {
    sum[c] = {{cells.at("load_x")[c], cells.at("load_y")[c]}};
    largest_load = std::max(largest_load, std::hypot(sum[c][0], sum[c][1]));
  }
  for (unsigned int e = 0;
       interfaces.count("nx") != 0 && e < interfaces.at("nx").size(); ++e)
  {
    const double nx = interfaces.at("nx")[e], ny = interfaces.at("ny")[e];
    const double fn = interfaces.at("normal_force")[e];
    const double ft = interfaces.at("tangential_force")[e];
    auto &minus = sum[interfaces.at("cell_minus")[e]];
    const double cell_plus = interfaces.at("cell_plus")[e];
    auto &plus = cell_plus < 0. ? ground : sum[cell_plus];
    const double fx = fn * nx - ft * ny, fy = fn * ny + ft * nx;
    minus[0] += fx;
    minus[1] += fy;
    plus[0] -= fx;
    plus[1] -= fy;
  }
  for (const auto &s : sum)
    largest = std::max(largest, std::hypot(s[0], s[1]));
  return largest / largest_load;
}
} // namespace

int main(int, char **argv)
{
  Voussoir::trap_invalid_operations();
  std::ostringstream out, error;
  const int status = Voussoir::run_command_line(
      {argv[1], "--set", "Output directory=results"}, out, error);
  std::cout << "exit status: " << status << std::endl << error.str();
  if (status != 0)
    return 0;

  const auto summary =
      nlohmann::json::parse(std::ifstream("results/summary.json"));
  for (const auto &[name, value] : summary["packing"].items())
    std::cout << name << ": " << value << std::endl;
  for (const char *name : {"equilibrium_residual", "admissibility_violation"})
    std::cout << "certificate " << name << " <= 1e-9: "
              << (summary["certificate"][name].get<double>() <= 1e-9 ? "OK"
                                                                     : "FAILED")
              << std::endl;

  Table cells = read_table("results/cells.csv");
  Table interfaces = read_table("results/interfaces.csv");
  std::cout << "imbalance recomputed from the .csv files <= 1e-7 of the load: "
            << (largest_imbalance(cells, interfaces) <= 1e-7 ? "OK" : "FAILED")
            << std::endl;
  if (interfaces.count("normal_force_0") != 0)
    std::cout << "torque recomputed from the .csv files <= 1e-7 of the load: "
              << (largest_torque(cells, interfaces) <= 1e-7 ? "OK" : "FAILED")
              << std::endl;
  if (summary.contains("load_factor"))
  {
    // Which of the states that carry the loads is written is left open.
    const auto &factor = summary["load_factor"];
    std::cout << "load factor: " << factor["carried"] << std::endl
              << "width <= 1e-7: "
              << (factor["width"].get<double>() <= 1e-7 ? "OK" : "FAILED")
              << std::endl;
    return 0;
  }
  std::vector<double> &length = interfaces["length"];
  for (const char *name : {"normal_force", "tangential_force"})
  {
    std::vector<double> stress = interfaces[name];
    for (unsigned int e = 0; e < stress.size(); ++e)
      stress[e] /= length[e];
    print_range(std::string(name) + " over length", stress);
  }
  for (const char *name : {"sxx", "sxy", "syx", "syy"})
    print_range(std::string("cell mean ") + name, cells[name]);
}
