// libpng reports errors by longjmp: every function here that calls setjmp has no local variable with a destructor.

#include "scene/readers/png_file.hpp"

#include <bit>
#include <csetjmp>
#include <cstring>

#include "files/input_error.hpp"
#include "files/message_text.hpp"

namespace ligne {

void PngFile::on_error(png_structp png, png_const_charp cause) {
  auto* const self = static_cast<PngFile*>(png_get_error_ptr(png));
  std::strncpy(self->cause_.data(), cause, self->cause_.size() - 1);
  png_longjmp(png, 1);
}

void PngFile::on_read(png_structp png, png_bytep to, std::size_t size) {
  auto* const self = static_cast<PngFile*>(png_get_io_ptr(png));
  if (size > self->rest_.size()) png_error(png, "the file ends early");
  std::memcpy(to, self->rest_.data(), size);
  self->rest_ = self->rest_.subspan(size);
}

PngFile::PngFile(std::span<const std::byte> bytes, const std::string& name) : rest_(bytes), name_(name) {
  png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, on_error, [](png_structp, png_const_charp) {});
  info_ = png_ ? png_create_info_struct(png_) : nullptr;
  if (!info_) {
    png_destroy_read_struct(&png_, nullptr, nullptr);
    throw InputError(name_, "libpng can not be set up");
  }
  png_set_read_fn(png_, this, on_read);
}

void PngFile::read_header() {
  if (!try_header()) throw_error();
}

int PngFile::begin_rows(bool as_rgb) {
  if (!try_begin_rows(as_rgb)) throw_error();
  return passes_;
}

void PngFile::read_row(png_bytep row) {
  if (!try_row(row)) throw_error();
}

std::optional<unsigned> PngFile::transparent() const {
  png_color_16p color = nullptr;
  if (png_get_tRNS(png_, info_, nullptr, nullptr, &color) == 0 || color == nullptr) return {};
  return color->gray;
}

bool PngFile::try_header() {
  if (setjmp(png_jmpbuf(png_)) != 0) return false;
  png_read_info(png_, info_);
  return true;
}

bool PngFile::try_begin_rows(bool as_rgb) {
  if (setjmp(png_jmpbuf(png_)) != 0) return false;
  if (as_rgb) {
    png_set_expand(png_);
    png_set_scale_16(png_);
    png_set_gray_to_rgb(png_);
    png_set_strip_alpha(png_);
  } else {
    png_set_packing(png_);
    if (std::endian::native == std::endian::little) png_set_swap(png_);
  }
  passes_ = png_set_interlace_handling(png_);
  png_read_update_info(png_, info_);
  return true;
}

bool PngFile::try_row(png_bytep row) {
  if (setjmp(png_jmpbuf(png_)) != 0) return false;
  png_read_row(png_, row, nullptr);
  return true;
}

void PngFile::throw_error() const {
  throw InputError(name_, std::string("is a broken PNG picture: ") + printable(cause_.data(), cause_.size()));
}

}  // namespace ligne
