#include <algorithm>
#include <limits>

#include "scene/readers/png_file.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/surfaces/height_filters.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

/// Largest ratio by which Deflate expands data.
constexpr std::uint64_t kMostDeflated = 1032;

/// The columns and rows that are kept, lowest first.
struct KeptPlaces {
  std::vector<std::size_t> x, y;
};

template <typename Sample>
std::vector<Sample> read_interlaced(PngFile& png, int passes) {
  const std::size_t columns = png.columns(), rows = png.rows();
  std::vector<Sample> samples(columns * rows);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t row = 0; row < rows; ++row) png.read_row(reinterpret_cast<png_bytep>(samples.data() + row * columns));
  }
  return samples;
}

/// The kept samples, from the first row of the picture, which is the highest.
template <typename Sample>
std::vector<Sample> read_samples(PngFile& png, const KeptPlaces& kept) {
  const int passes = png.begin_rows(false);
  const std::size_t columns = png.columns(), rows = png.rows();
  std::vector<Sample> all, line(columns), samples;
  if (passes > 1) all = read_interlaced<Sample>(png, passes);
  auto next = kept.y.rbegin();
  for (std::size_t row = 0; row < rows && next != kept.y.rend(); ++row) {
    if (passes == 1) png.read_row(reinterpret_cast<png_bytep>(line.data()));
    if (*next != rows - 1 - row) continue;
    ++next;
    const Sample* const from = passes == 1 ? line.data() : all.data() + row * columns;
    // Memory grows as heights are read, since the size in the header may be wrong.
    for (const std::size_t i : kept.x) samples.push_back(from[i]);
  }
  return samples;
}

template <typename Sample>
std::unique_ptr<HeightSource> read_heights(PngFile& png, const KeptPlaces& kept, const std::string& name) {
  const std::optional<unsigned> transparent = png.transparent();
  std::vector<Sample> samples = read_samples<Sample>(png, kept);
  const SampleOrder order = SampleOrder::first_row_highest(kept.x.size(), kept.y.size());
  const std::vector<double> x(kept.x.begin(), kept.x.end()), y(kept.y.begin(), kept.y.end());
  if (!transparent) return held_heights(x, y, std::move(samples), order, name);

  std::vector<float> heights(samples.size());  // float holds every 16-bit value, and NaN
  std::transform(samples.begin(), samples.end(), heights.begin(), [&](Sample value) {
    return value == *transparent ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(value);
  });
  return held_heights(x, y, std::move(heights), order, name);
}

/// Throws InputError if the file is too small for the number of values in its header.
void check_size(std::size_t columns, std::size_t rows, unsigned bits, std::size_t bytes, const std::string& name) {
  const std::uint64_t most = bytes * kMostDeflated * 8 / bits;
  if (rows > most / columns) {
    throw InputError(name, "is a broken PNG picture: " + std::to_string(columns) + " x " + std::to_string(rows) +
                               " values do not fit into " + std::to_string(bytes) + " bytes");
  }
}

/// Reads colours that are heights in the Terrarium encoding, R 256 + G + B / 256 - 32768 metres. It maps the earth from
/// its deepest to its highest place to a narrow band of red; other pictures have colours outside that band.
std::unique_ptr<HeightSource> read_terrarium(PngFile& png, std::size_t bytes, const std::string& name, Warnings& warnings) {
  constexpr double kZero = 32768, kDeepest = -11'500, kHighest = 9'000;
  const std::size_t columns = png.columns(), rows = png.rows();
  check_counts(columns, rows, name);
  check_size(columns, rows, 24, bytes, name);
  const int passes = png.begin_rows(false);
  std::vector<std::uint8_t> line(3 * columns), all;
  if (passes > 1) all.resize(3 * columns * rows);
  std::vector<float> heights;
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t row = 0; row < rows; ++row) {
      if (passes > 1) std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(row * line.size()), line.size(), line.begin());
      png.read_row(line.data());
      if (passes > 1) std::copy(line.begin(), line.end(), all.begin() + static_cast<std::ptrdiff_t>(row * line.size()));
      if (pass + 1 < passes) continue;
      for (std::size_t i = 0; i < columns; ++i) {
        const double height = 256. * line[3 * i] + line[3 * i + 1] + line[3 * i + 2] / 256. - kZero;
        if (height < kDeepest || height > kHighest) {
          throw InputError(name,
                           "is a PNG picture of colours; heights need one grey channel of 8 or 16 bits, or the "
                           "Terrarium encoding");
        }
        heights.push_back(static_cast<float>(height));
      }
    }
  }
  warnings.add("pictures of colours read as Terrarium heights");
  return held_heights(counted_positions(columns), counted_positions(rows), std::move(heights),
                      SampleOrder::first_row_highest(columns, rows), name);
}

}  // namespace

std::unique_ptr<HeightSource> read_png_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                            const GridChoice& choice) {
  PngFile png(bytes, name);
  png.read_header();
  if (png.color_type() == PNG_COLOR_TYPE_RGB && png.bit_depth() == 8)
    return read_terrarium(png, bytes.size(), name, warnings);
  if (png.color_type() != PNG_COLOR_TYPE_GRAY) {
    const char* const kind = png.color_type() == PNG_COLOR_TYPE_GRAY_ALPHA ? "grey with an alpha channel"
                             : png.color_type() == PNG_COLOR_TYPE_PALETTE  ? "colours from a palette"
                                                                           : "colours";
    throw InputError(name, std::string("is a PNG picture of ") + kind + "; heights need one grey channel of 8 or 16 bits");
  }
  const std::size_t columns = png.columns(), rows = png.rows();
  check_counts(columns, rows, name);
  check_size(columns, rows, static_cast<unsigned>(png.bit_depth()), bytes.size(), name);
  const std::size_t step = thinning_step(columns, rows, choice);
  if (step > 1) warn_of_thinning(columns, rows, step, warnings);
  const KeptPlaces kept{kept_places(columns, step), kept_places(rows, step)};
  auto heights =
      png.bit_depth() == 16 ? read_heights<std::uint16_t>(png, kept, name) : read_heights<std::uint8_t>(png, kept, name);
  heights->set_thinned_by(step);
  return heights;
}

}  // namespace ligne
