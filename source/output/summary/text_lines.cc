// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/summary/text_lines.h>

#include <deal.II/base/multithread_info.h>
#include <deal.II/base/parallel.h>

#include <algorithm>
#include <ostream>
#include <vector>

namespace Voussoir
{
namespace
{
/** Lines that a thread formats at a time: a millisecond or a few. */
constexpr unsigned int chunk_size = 4096;
} // namespace

void write_pieces(
    std::ostream &out,
    const unsigned int n,
    const std::function<void(TextLines &, unsigned int, unsigned int)> &lines)
{
  const unsigned int n_chunks = (n + chunk_size - 1) / chunk_size;
  // As many at a time as keep the threads busy, so that little text waits.
  std::vector<TextLines> chunks(4 * dealii::MultithreadInfo::n_threads());
  for (unsigned int first = 0; first < n_chunks; first += chunks.size())
  {
    const unsigned int n_now =
        std::min<unsigned int>(chunks.size(), n_chunks - first);
    const auto format = [&](const unsigned int begin, const unsigned int end) {
      for (unsigned int k = begin; k < end; ++k)
      {
        chunks[k].clear();
        const unsigned int start = (first + k) * chunk_size;
        lines(chunks[k], start, std::min(start + chunk_size, n));
      }
    };
    dealii::parallel::apply_to_subranges(0U, n_now, format, 1);
    for (unsigned int k = 0; k < n_now; ++k)
      out.write(chunks[k].text().data(), chunks[k].text().size());
  }
}

void write_lines(std::ostream &out,
                 const unsigned int n,
                 const std::function<void(TextLines &, unsigned int)> &line)
{
  write_pieces(out, n, [&](TextLines &lines, unsigned int i, unsigned int end) {
    for (; i < end; ++i)
      line(lines, i);
  });
}
} // namespace Voussoir
