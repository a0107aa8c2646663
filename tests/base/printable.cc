// SPDX-License-Identifier: LGPL-2.1-or-later

// Messages that quote whatever a file has: nothing in them that a terminal
// would obey, no byte that is no text, and no line that nobody reads to its
// end.

#include <voussoir/base/printable.h>

#include "tests.h"

namespace test_printable
{
using namespace Voussoir;

void run()
{
  std::cout << printable("a title \x1b]0;owned\x07 of a window\ta\x7f\n b\n")
            << printable("nach M\xc3\xbcnchen") << '\n'
            << printable("nach M\xfcnchen") << std::endl;
  show_refusal([] { throw InputError("'\x1b[2J' is no number."); });
  check("controls of two bytes", printable("a\xc2\x9b"
                                           "2J \xc2\xb0") == "a??2J \xc2\xb0");

  const std::string umlauts = [] {
    std::string many;
    for (unsigned int k = 0; k < 5000; ++k)
      many += "\xc3\xbc";
    return many;
  }();
  const std::string message =
      "a line\nthe name '" + umlauts + "' is long; cut.";
  const std::string shown = printable(message);
  check("a long line has no middle", shown.size() < 2000);
  check("its beginning is there",
        shown.rfind("a line\nthe name '\xc3", 0) == 0);
  const std::string end = "\xc3\xbc' is long; cut.";
  check("its end is there", shown.substr(shown.size() - end.size()) == end);
  check("letters are whole", is_utf8(shown));
  check("it can be shown as it is", printable(shown) == shown);
}

const RoomTest test("printable", run);
} // namespace test_printable
