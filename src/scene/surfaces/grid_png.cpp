// libpng reports errors by longjmp: every function here that calls setjmp has no local variable with a destructor.

#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <limits>

#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grid_formats.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

/// What deflate can make of a byte at the most.
constexpr std::uint64_t kMostDeflated = 1032;

class PngFile {
 public:
  PngFile(std::span<const std::byte> bytes, const std::string& name) : rest_(bytes), name_(name) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, [](png_structp, png_const_charp) {});
    info_ = png_ ? png_create_info_struct(png_) : nullptr;
    if (!info_) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw InputError(name_, "libpng can not be set up");
    }
    png_set_read_fn(png_, this, on_read);
  }
  ~PngFile() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  void read_header() {
    if (!try_header()) throw_error();
  }
  /// Prepares for rows of a byte a sample, or of two in the machine's order; returns the number of passes.
  int begin_rows() {
    if (!try_begin_rows()) throw_error();
    return passes_;
  }
  void read_row(png_bytep row) {
    if (!try_row(row)) throw_error();
  }

  std::size_t columns() const { return png_get_image_width(png_, info_); }
  std::size_t rows() const { return png_get_image_height(png_, info_); }
  int bit_depth() const { return png_get_bit_depth(png_, info_); }
  int color_type() const { return png_get_color_type(png_, info_); }
  /// The value that stands for transparent.
  std::optional<unsigned> transparent() const {
    png_color_16p color = nullptr;
    if (png_get_tRNS(png_, info_, nullptr, nullptr, &color) == 0 || color == nullptr) return {};
    return color->gray;
  }

 private:
  static void on_error(png_structp png, png_const_charp cause) {
    auto* const self = static_cast<PngFile*>(png_get_error_ptr(png));
    std::strncpy(self->cause_.data(), cause, self->cause_.size() - 1);
    png_longjmp(png, 1);
  }

  static void on_read(png_structp png, png_bytep to, std::size_t size) {
    auto* const self = static_cast<PngFile*>(png_get_io_ptr(png));
    if (size > self->rest_.size()) png_error(png, "the file ends early");
    std::memcpy(to, self->rest_.data(), size);
    self->rest_ = self->rest_.subspan(size);
  }

  bool try_header() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_info(png_, info_);
    return true;
  }

  bool try_begin_rows() {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_packing(png_);
    if (std::endian::native == std::endian::little) png_set_swap(png_);
    passes_ = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }

  bool try_row(png_bytep row) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_row(png_, row, nullptr);
    return true;
  }

  [[noreturn]] void throw_error() const {
    throw InputError(name_, std::string("is a broken PNG picture: ") + printable(cause_.data(), cause_.size()));
  }

  std::span<const std::byte> rest_;
  const std::string& name_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  int passes_ = 1;
  std::array<char, 128> cause_{};
};

template <typename Sample>
std::vector<Sample> read_samples(PngFile& png) {
  const int passes = png.begin_rows();
  const std::size_t columns = png.columns(), rows = png.rows();
  std::vector<Sample> samples;
  if (passes > 1) samples.resize(columns * rows);
  for (int pass = 0; pass < passes; ++pass) {
    for (std::size_t row = 0; row < rows; ++row) {
      // The heights take room as they come: the size in the header may be a lie.
      if (passes == 1) samples.resize((row + 1) * columns);
      png.read_row(reinterpret_cast<png_bytep>(samples.data() + row * columns));
    }
  }
  return samples;
}

template <typename Sample>
std::unique_ptr<HeightSource> read_heights(PngFile& png, const std::string& name) {
  const std::size_t columns = png.columns(), rows = png.rows();
  const std::optional<unsigned> transparent = png.transparent();
  std::vector<Sample> samples = read_samples<Sample>(png);
  const SampleOrder order = SampleOrder::first_row_highest(columns, rows);
  if (!transparent)
    return held_heights(counted_positions(columns), counted_positions(rows), std::move(samples), order, name);

  std::vector<float> heights(samples.size());  // holds every value of 16 bits, and NaN
  std::transform(samples.begin(), samples.end(), heights.begin(), [&](Sample value) {
    return value == *transparent ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(value);
  });
  return held_heights(counted_positions(columns), counted_positions(rows), std::move(heights), order, name);
}

}  // namespace

std::unique_ptr<HeightSource> read_png_grid(std::span<const std::byte> bytes, const std::string& name, Warnings&) {
  PngFile png(bytes, name);
  png.read_header();
  if (png.color_type() != PNG_COLOR_TYPE_GRAY) {
    const char* const kind = png.color_type() == PNG_COLOR_TYPE_GRAY_ALPHA ? "grey with an alpha channel"
                             : png.color_type() == PNG_COLOR_TYPE_PALETTE  ? "colours from a palette"
                                                                           : "colours";
    throw InputError(name, std::string("is a PNG picture of ") + kind + "; heights need one grey channel of 8 or 16 bits");
  }
  const std::size_t columns = png.columns(), rows = png.rows();
  check_counts(columns, rows, name);
  const std::uint64_t most = bytes.size() * kMostDeflated * 8 / static_cast<unsigned>(png.bit_depth());
  if (rows > most / columns) {
    throw InputError(name, "is a broken PNG picture: " + std::to_string(columns) + " x " + std::to_string(rows) +
                               " values do not fit into " + std::to_string(bytes.size()) + " bytes");
  }
  return png.bit_depth() == 16 ? read_heights<std::uint16_t>(png, name) : read_heights<std::uint8_t>(png, name);
}

}  // namespace ligne
