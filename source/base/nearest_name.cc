// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/base/nearest_name.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace Voussoir
{
namespace
{
/** The texts of which a part is nearest to @p name, and near enough. */
template <typename Part>
std::vector<std::string> nearest(const std::string &name,
                                 const std::vector<std::string> &texts,
                                 const std::size_t n_most,
                                 const Part &part)
{
  // A third of the letters may be wrong, and two of a short name.
  const unsigned int most = std::max<std::size_t>(2, name.size() / 3);
  unsigned int least = most + 1;
  std::vector<std::string> found;
  for (const std::string &text : texts)
  {
    const std::string other = part(text);
    // As many letters are wrong at least; a name may be a whole file.
    if (std::max(name.size(), other.size()) -
            std::min(name.size(), other.size()) >
        least)
      continue;
    const unsigned int distance = edit_distance(name, other);
    if (distance >= name.size())
      continue;
    if (distance < least)
    {
      found.clear();
      least = distance;
    }
    if (distance == least && least <= most && found.size() < n_most)
      found.push_back(text);
  }
  return found;
}
} // namespace

unsigned int edit_distance(const std::string &a, const std::string &b)
{
  const auto same = [](const char x, const char y) {
    return std::tolower(static_cast<unsigned char>(x)) ==
           std::tolower(static_cast<unsigned char>(y));
  };
  // Of the letters of a so far, to the beginning of b of each length.
  std::vector<unsigned int> to(b.size() + 1);
  std::iota(to.begin(), to.end(), 0);
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    unsigned int replaced = to[0];
    to[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const unsigned int kept = replaced + (same(a[i], b[j]) ? 0 : 1);
      replaced = to[j + 1];
      to[j + 1] = std::min({kept, replaced + 1, to[j] + 1});
    }
  }
  return to.back();
}

std::vector<std::string> nearest_texts(const std::string &text,
                                       const std::vector<std::string> &texts,
                                       const std::size_t n_most)
{
  return nearest(text, texts, n_most, [](const std::string &of) { return of; });
}

std::vector<std::string> nearest_names(const std::string &name,
                                       const std::vector<std::string> &paths,
                                       const std::size_t n_most)
{
  return nearest(name, paths, n_most, [](const std::string &path) {
    return path.substr(path.rfind('/') + 1);
  });
}
} // namespace Voussoir
