// SPDX-License-Identifier: LGPL-2.1-or-later
#include <voussoir/output/vtu/vtu_file.h>

#include <deal.II/base/exceptions.h>
#include <deal.II/base/multithread_info.h>
#include <deal.II/base/parallel.h>

#include <algorithm>
#include <iomanip>
#include <lz4.h>
#include <numeric>
#include <ostream>
#include <zlib.h>

namespace Voussoir
{
namespace
{
/** Bytes of a block before compression: enough to find repetitions. */
constexpr std::size_t block_size = 1 << 19;

/** The cells of a grid that zlib compresses, at most; see Compressor. */
constexpr std::size_t most_cells_by_zlib = 1000000;

/** Speed counts for more than size. */
constexpr int zlib_level = 1;

/**
 * Either of two libraries. Readers without VTK behind them know zlib only; LZ4
 * takes a fraction of its time, which counts in large files.
 */
struct Compressor
{
  explicit Compressor(const std::size_t n_cells)
      : by_zlib(n_cells <= most_cells_by_zlib)
  {}

  const char *name() const
  {
    return by_zlib ? "vtkZLibDataCompressor" : "vtkLZ4DataCompressor";
  }

  /** Compress into @p bytes. @return their number, which is not zero. */
  std::size_t compress(const std::vector<char> &plain,
                       const std::size_t size,
                       std::vector<char> &bytes) const
  {
    if (!by_zlib)
    {
      bytes.resize(LZ4_compressBound(size));
      return LZ4_compress_default(plain.data(), bytes.data(), size,
                                  bytes.size());
    }
    uLongf n = compressBound(size);
    bytes.resize(n);
    const int status = compress2(reinterpret_cast<Bytef *>(bytes.data()), &n,
                                 reinterpret_cast<const Bytef *>(plain.data()),
                                 size, zlib_level);
    return status == Z_OK ? n : 0;
  }

  const bool by_zlib;
};

/**
 * Bytes of white space before the data. VTK's reader takes 4096 bytes at a
 * time, and stops when expat has told it of the element AppendedData. Since its
 * version 2.6, and as Debian has it, expat tells that only when there is more
 * to read; then this must not yet be the data, which is no XML. Two times 4096
 * bytes are enough, wherever the element stands.
 */
constexpr std::size_t padding = 3 * 4096;

void write_binary(std::ostream &out, const std::vector<std::uint64_t> &numbers)
{
  out.write(reinterpret_cast<const char *>(numbers.data()),
            numbers.size() * sizeof(std::uint64_t));
}

/**
 * A number that is known later, with the quotation mark behind it, in as many
 * letters as it may need. Spaces follow, as some readers compare the digits.
 */
void write_later(std::ostream &out, const std::uint64_t number)
{
  out << std::left << std::setw(21) << std::to_string(number) + '"';
}

void write_begin(std::ostream &out,
                 const char *type,
                 const Compressor &compressor)
{
  const std::uint16_t one = 1;
  const bool little = *reinterpret_cast<const char *>(&one) == 1;
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"" << type
      << "\" version=\"1.0\" byte_order=\""
      << (little ? "LittleEndian" : "BigEndian")
      << "\" header_type=\"UInt64\" compressor=\"" << compressor.name()
      << "\">\n<" << type;
}

/** All of a DataArray but its end. */
template <typename Array>
void write_head(std::ostream &out, const Array &array, const char *element)
{
  out << '<' << element << " type=\"" << array.type << "\" Name=\""
      << array.name << "\" NumberOfComponents=\"" << array.n_components << '"';
}
} // namespace

VtuFile::VtuFile(const Items<double> &places,
                 const Array &connectivity,
                 const Items<std::int64_t> &ends,
                 const Shape shape)
    : points(make_array("Points", 3, places.number, places.fill)),
      cells({connectivity, make_array("offsets", 1, ends.number, ends.fill)})
{
  const Fill<std::uint8_t> types = [shape](auto begin, auto end,
                                           std::uint8_t *values) {
    std::fill_n(values, end - begin, static_cast<std::uint8_t>(shape));
  };
  cells.push_back(make_array("types", 1, ends.number, types));
}

VtuFile VtuFile::quadrilaterals(const Items<double> &points,
                                const Items<std::int64_t> &corners)
{
  Array connectivity =
      make_array("connectivity", 4, corners.number, corners.fill);
  connectivity.n_components = 1; // as VTK has it; an item is still a cell
  const Fill<std::int64_t> ends = [](auto begin, auto end, auto *values) {
    for (; begin < end; ++begin)
      *values++ = 4 * (begin + 1);
  };
  return {points, connectivity, {corners.number, ends}, Shape::quadrilateral};
}

VtuFile VtuFile::separate(const Shape shape,
                          const Items<double> &points,
                          const Items<std::int64_t> &ends)
{
  const Fill<std::int64_t> in_order = [](auto begin, auto end, auto *values) {
    std::iota(values, values + (end - begin), begin);
  };
  return {points, make_array("connectivity", 1, points.number, in_order), ends,
          shape};
}

VtuFile VtuFile::polyhedra(const Items<double> &points,
                           const Items<std::int64_t> &ends,
                           const Items<std::int64_t> &faces,
                           const Items<std::int64_t> &face_ends)
{
  VtuFile file = separate(Shape::polyhedron, points, ends);
  file.cells.push_back(make_array("faces", 1, faces.number, faces.fill));
  file.cells.push_back(
      make_array("faceoffsets", 1, face_ends.number, face_ends.fill));
  return file;
}

void VtuFile::write(std::ostream &out) const
{
  // The positions in the file of the offsets of the arrays, and the arrays.
  std::vector<std::streampos> places;
  std::vector<const Array *> arrays;
  const auto announce = [&](const Array &array) {
    write_head(out, array, "DataArray");
    out << " format=\"appended\" offset=\"";
    places.push_back(out.tellp());
    arrays.push_back(&array);
    write_later(out, 0);
    out << "/>\n";
  };
  const Compressor compressor(number_of_cells());
  write_begin(out, "UnstructuredGrid", compressor);
  out << ">\n<Piece NumberOfPoints=\"" << points.n_items
      << "\" NumberOfCells=\"" << number_of_cells() << "\">\n<Points>\n";
  announce(points);
  out << "</Points>\n<Cells>\n";
  std::for_each(cells.begin(), cells.end(), announce);
  out << "</Cells>\n<PointData>\n";
  std::for_each(point_fields.begin(), point_fields.end(), announce);
  out << "</PointData>\n<CellData>\n";
  std::for_each(cell_fields.begin(), cell_fields.end(), announce);
  out << "</CellData>\n</Piece>\n</UnstructuredGrid>\n"
         "<AppendedData encoding=\"raw\">\n"
      << std::string(padding, ' ') << '_';

  const std::streampos begin = out.tellp();
  for (unsigned int i = 0; i < arrays.size(); ++i)
  {
    const std::streampos here = out.tellp();
    out.seekp(places[i]);
    write_later(out, here - begin);
    out.seekp(here);
    write_data(out, *arrays[i]);
  }
  out << "\n</AppendedData>\n</VTKFile>\n";
}

void VtuFile::write_record(std::ostream &out,
                           const std::vector<std::string> &pieces) const
{
  const auto announce = [&](const Array &array) {
    write_head(out, array, "PDataArray");
    out << "/>\n";
  };
  write_begin(out, "PUnstructuredGrid", Compressor(number_of_cells()));
  out << " GhostLevel=\"0\">\n<PPoints>\n";
  announce(points);
  out << "</PPoints>\n<PPointData>\n";
  std::for_each(point_fields.begin(), point_fields.end(), announce);
  out << "</PPointData>\n<PCellData>\n";
  std::for_each(cell_fields.begin(), cell_fields.end(), announce);
  out << "</PCellData>\n";
  for (const std::string &piece : pieces)
    out << "<Piece Source=\"" << piece << "\"/>\n";
  out << "</PUnstructuredGrid>\n</VTKFile>\n";
}

/**
 * The number of blocks, their size, that of the last if it is a smaller one,
 * the compressed size of each, and the compressed blocks.
 */
void VtuFile::write_data(std::ostream &out, const Array &array) const
{
  const Compressor compressor(number_of_cells());
  const std::size_t n = array.n_items;
  const std::size_t per_block = block_size / array.item_size;
  const std::size_t n_blocks = (n + per_block - 1) / per_block;
  std::vector<std::uint64_t> head(3 + n_blocks);
  head[0] = n_blocks;
  head[1] = per_block * array.item_size;
  head[2] = n % per_block * array.item_size;
  const std::streampos place = out.tellp();
  write_binary(out, head); // the sizes follow when they are known

  std::vector<std::vector<char>> compressed(
      4 * dealii::MultithreadInfo::n_threads());
  for (std::size_t first = 0; first < n_blocks; first += compressed.size())
  {
    const std::size_t n_now = std::min(compressed.size(), n_blocks - first);
    const auto compress = [&](const std::size_t begin, const std::size_t end) {
      std::vector<char> plain(head[1]);
      for (std::size_t k = begin; k < end; ++k)
      {
        const std::size_t from = (first + k) * per_block;
        const std::size_t to = std::min(from + per_block, n);
        array.fill(from, to, plain.data());
        const std::size_t size = (to - from) * array.item_size;
        head[3 + first + k] = compressor.compress(plain, size, compressed[k]);
        Assert(head[3 + first + k] > 0, dealii::ExcInternalError());
      }
    };
    dealii::parallel::apply_to_subranges(std::size_t(0), n_now, compress, 1);
    for (std::size_t k = 0; k < n_now; ++k)
      out.write(compressed[k].data(), head[3 + first + k]);
  }
  const std::streampos end = out.tellp();
  out.seekp(place);
  write_binary(out, head);
  out.seekp(end);
}
} // namespace Voussoir
