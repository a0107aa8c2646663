// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef voussoir_tests_table_h
#define voussoir_tests_table_h

#include <boost/algorithm/string.hpp>
#include <boost/lexical_cast.hpp>

#include <fstream>
#include <map>
#include <string>
#include <vector>

/** The columns of a .csv file by name. */
using Table = std::map<std::string, std::vector<double>>;

inline Table read_table(const std::string &file)
{
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  std::vector<std::string> names, words;
  boost::split(names, line, boost::is_any_of(","));
  Table table;
  while (std::getline(in, line))
  {
    boost::split(words, line, boost::is_any_of(","));
    for (unsigned int i = 0; i < names.size(); ++i)
    {
      // A name among the numbers, as that of a group, is of no interest here.
      double value = 0.;
      boost::conversion::try_lexical_convert(words.at(i), value);
      table[names[i]].push_back(value);
    }
  }
  return table;
}

#endif
