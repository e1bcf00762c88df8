#pragma once
/// Reads the rows of a PNG picture.

#include <png.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>

namespace ligne {

/// A PNG picture in memory. Its functions throw InputError(name, "is a broken PNG picture: ...").
class PngFile {
 public:
  /// `bytes` and `name` must outlive the object.
  PngFile(std::span<const std::byte> bytes, const std::string& name);
  ~PngFile() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  void read_header();
  /// Prepares reading rows with one byte per sample, or two in the machine's order; `as_rgb`: with three bytes per pixel,
  /// whatever the file holds. Returns the number of passes.
  int begin_rows(bool as_rgb);
  void read_row(png_bytep row);

  std::size_t columns() const { return png_get_image_width(png_, info_); }
  std::size_t rows() const { return png_get_image_height(png_, info_); }
  int bit_depth() const { return png_get_bit_depth(png_, info_); }
  int color_type() const { return png_get_color_type(png_, info_); }
  /// The value that means transparent.
  std::optional<unsigned> transparent() const;

 private:
  static void on_error(png_structp png, png_const_charp cause);
  static void on_read(png_structp png, png_bytep to, std::size_t size);
  bool try_header();
  bool try_begin_rows(bool as_rgb);
  bool try_row(png_bytep row);
  [[noreturn]] void throw_error() const;

  std::span<const std::byte> rest_;
  const std::string& name_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  int passes_ = 1;
  std::array<char, 128> cause_{};
};

}  // namespace ligne
