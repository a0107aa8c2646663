// SPDX-License-Identifier: LGPL-2.1-or-later

// Lists of numbers in the place of expressions: each double is read as it was
// written, and what is no list, or of another length, is told.

#include <voussoir/formula/value_list.h>

#include "tests.h"
#include <cstdlib>
#include <iomanip>
#include <random>

namespace test_value_lists
{
using namespace Voussoir;

void run()
{
  check("lists", is_value_list(" list 1") && is_value_list("list") &&
                     is_value_list("list 0; list -1") &&
                     is_value_list("0; list -1") && is_value_list("list\t1"));
  check("expressions", !is_value_list("1 + x") && !is_value_list("listed") &&
                           !is_value_list("0; -1") && !is_value_list(""));

  // Of all sizes, each against the C library's function.
  std::mt19937 numbers(1);
  std::uniform_real_distribution<double> digits(-1., 1.);
  std::uniform_int_distribution<int> exponents(-300, 300);
  std::ostringstream list;
  std::vector<double> expected;
  for (unsigned int k = 0; k < 1000; ++k)
  {
    std::ostringstream word;
    word << std::setprecision(17) << digits(numbers) << 'e'
         << exponents(numbers);
    list << (k == 0 ? "list " : ",  ") << word.str();
    expected.push_back(std::strtod(word.str().c_str(), nullptr));
  }
  check("a thousand numbers",
        numbers_of_list(list.str(), "entry", 1000, "cell") == expected);
  check("none", numbers_of_list("list ", "entry", 0, "cell").empty());
  const double infinite = std::numeric_limits<double>::infinity();
  check("infinite", numbers_of_list("list inf, -inf", "entry", 2, "cell") ==
                        std::vector<double>{infinite, -infinite});
  check("signs", numbers_of_list("list +0.5, -0.5", "entry", 2, "cell") ==
                     std::vector<double>{0.5, -0.5});
  const std::vector<std::vector<double>> vectors = {{1., 2., 3.}, {4., 5., 6.}};
  check("vectors", vectors_of_lists("list 1, 2, 3; list 4, 5, 6", "entry", 2, 3,
                                    "cell") == vectors);

  for (const char *const faulty :
       {"list 1, 2", "list 1, 2, 3, 4", "list 1,, 3", "list 1 2 3",
        "list 1, x, 3", "list 1, 1e999, 3", "list 1, 2, 3,"})
    show_refusal([&] { numbers_of_list(faulty, "entry", 3, "cell"); });
  for (const char *const faulty :
       {"list 1, 2, 3", "list 1, 2, 3; 0", "list 1, 2, 3; list 1, 2",
        "list 1, 2, 3; list 1, 2, inf", "list nan, 2, 3; list 1, 2, 3"})
    show_refusal([&] { vectors_of_lists(faulty, "entry", 2, 3, "cell"); });
}

const RoomTest test("value_lists", run);
} // namespace test_value_lists
