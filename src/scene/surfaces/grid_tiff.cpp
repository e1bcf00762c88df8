// TIFF by libtiff: strips and tiles, integers and floats of one channel, whatever libtiff unpacks (deflate, LZW, PackBits,
// with predictors). Of GeoTIFF the scale, the tie point, the kind of coordinates and GDAL's NODATA are read, which is what
// grids of heights have; their projection is not needed.

#include "scene/surfaces/grid_formats.hpp"

#ifdef LIGNE_HAVE_TIFF

#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <limits>

#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

/// The tightest packing that libtiff unpacks: a code of LZW for 3840 bytes.
constexpr std::uint64_t kMostUnpacked = 4096;
/// No strip or tile of a grid that fits into memory takes more.
constexpr tmsize_t kLargestBlock = tmsize_t{1} << 30;

constexpr std::uint32_t kScaleTag = 33550, kTiePointTag = 33922, kGeoKeysTag = 34735, kNoDataTag = 42113;
constexpr std::uint16_t kModelType = 1024, kRasterType = 1025, kGeographic = 2, kPixelIsPoint = 2;

/// The bytes of a file, as libtiff asks for them.
struct Source {
  std::span<const std::byte> bytes;
  std::uint64_t at = 0;
  std::string message;

  static tmsize_t read(thandle_t handle, void* to, tmsize_t size) {
    auto* const self = static_cast<Source*>(handle);
    if (self->at >= self->bytes.size() || size <= 0) return 0;
    const std::size_t n = std::min<std::uint64_t>(static_cast<std::uint64_t>(size), self->bytes.size() - self->at);
    std::memcpy(to, self->bytes.data() + self->at, n);
    self->at += n;
    return static_cast<tmsize_t>(n);
  }
  static tmsize_t write(thandle_t, void*, tmsize_t) { return 0; }
  static toff_t seek(thandle_t handle, toff_t offset, int whence) {
    auto* const self = static_cast<Source*>(handle);
    const std::uint64_t from = whence == SEEK_CUR ? self->at : whence == SEEK_END ? self->bytes.size() : 0;
    return self->at = from + offset;
  }
  static int close(thandle_t) { return 0; }
  static toff_t size(thandle_t handle) { return static_cast<Source*>(handle)->bytes.size(); }

  static int on_error(TIFF*, void* self, const char*, const char* format, va_list arguments) {
    std::array<char, 160> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    std::string& message = static_cast<Source*>(self)->message;
    if (message.empty()) message = text.data();
    return 1;
  }
  static int on_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }
};

struct CloseTiff {
  void operator()(TIFF* tiff) const { TIFFClose(tiff); }
};

class TiffFile {
 public:
  TiffFile(std::span<const std::byte> bytes, const std::string& name) : source_{bytes, 0, {}}, name_(name) {
    TIFFOpenOptions* const options = TIFFOpenOptionsAlloc();
    TIFFOpenOptionsSetErrorHandlerExtR(options, Source::on_error, &source_);
    TIFFOpenOptionsSetWarningHandlerExtR(options, Source::on_warning, &source_);
    TIFFOpenOptionsSetMaxSingleMemAlloc(options, kLargestBlock);
    tiff_.reset(TIFFClientOpenExt(name.c_str(), "rm", &source_, Source::read, Source::write, Source::seek, Source::close,
                                  Source::size, nullptr, nullptr, options));
    TIFFOpenOptionsFree(options);
    if (!tiff_) throw broken();
    read_shape();
  }

  std::size_t columns() const { return columns_; }
  std::size_t rows() const { return rows_; }
  bool needs_double() const { return bits_ == 64 || (bits_ == 32 && format_ != SAMPLEFORMAT_IEEEFP); }

  /// The heights row by row, from the first one.
  template <class Height>
  std::vector<Height> read() {
    std::vector<Height> heights;
    const std::optional<double> no_data = no_data_value();
    const auto take = [&](const std::byte* row, std::size_t count, Height* to) {
      for (std::size_t i = 0; i < count; ++i) {
        const double z = value(row + i * pixel_bytes());
        const bool none =
            !std::isfinite(z) || (no_data && (z == *no_data || static_cast<float>(z) == static_cast<float>(*no_data)));
        to[i] = none ? std::numeric_limits<Height>::quiet_NaN() : static_cast<Height>(z);
      }
    };
    TIFFIsTiled(tiff_.get()) ? read_tiles(heights, take) : read_lines(heights, take);
    return heights;
  }

  /// Positions and their unit. `x` and `y` are counted where the file does not say them.
  GroundUnit positions(std::vector<double>& x, std::vector<double>& y) {
    x = counted_positions(columns_);
    y = counted_positions(rows_);
    const std::vector<double> scale = doubles(kScaleTag), tie = doubles(kTiePointTag);
    if (scale.size() < 2 || tie.size() < 6 || !(scale[0] > 0) || !(scale[1] > 0)) return GroundUnit::same;
    const double middle = geo_key(kRasterType) == kPixelIsPoint ? 0 : 0.5;
    for (std::size_t i = 0; i < columns_; ++i) x[i] = tie[3] + (static_cast<double>(i) + middle - tie[0]) * scale[0];
    for (std::size_t j = 0; j < rows_; ++j) {
      y[rows_ - 1 - j] = tie[4] - (static_cast<double>(j) + middle - tie[1]) * scale[1];
    }
    return geo_key(kModelType) == kGeographic ? GroundUnit::degrees : GroundUnit::same;
  }

 private:
  InputError broken() const {
    const std::string cause = source_.message.empty() ? "" : ": " + printable(source_.message);
    return InputError(name_, "is a TIFF file that can not be read" + cause);
  }
  InputError not_read(const std::string& what) const {
    return InputError(name_,
                      "is a TIFF file with " + what + ", which is not read; gdal_translate -ot Float32 makes one that is");
  }

  void read_shape() {
    std::uint32_t width = 0, length = 0;
    std::uint16_t planar = PLANARCONFIG_CONTIG, photometric = PHOTOMETRIC_MINISBLACK;
    TIFF* const tiff = tiff_.get();
    TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &width);
    TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &length);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &bits_);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &channels_);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &format_);
    TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &planar);
    TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &photometric);
    columns_ = width;
    rows_ = length;
    check_counts(columns_, rows_, name_);
    if (photometric == PHOTOMETRIC_RGB || photometric == PHOTOMETRIC_PALETTE || photometric == PHOTOMETRIC_YCBCR)
      throw InputError(name_, "is a picture in colours; heights need one band");
    if (planar != PLANARCONFIG_CONTIG) channels_ = 1;  // the first plane stands first
    const bool whole = bits_ == 8 || bits_ == 16 || bits_ == 32;
    const bool is_float = format_ == SAMPLEFORMAT_IEEEFP && (bits_ == 32 || bits_ == 64);
    const bool is_whole = whole && (format_ == SAMPLEFORMAT_UINT || format_ == SAMPLEFORMAT_INT);
    if (!is_float && !is_whole)
      throw not_read("values of " + std::to_string(bits_) + " bits of kind " + std::to_string(format_));
    if (channels_ == 0 || channels_ > 4) throw not_read(std::to_string(channels_) + " channels");
    if (rows_ > kMostUnpacked * source_.bytes.size() / (columns_ * pixel_bytes())) {
      throw InputError(name_, "is a TIFF file that speaks of " + std::to_string(columns_) + " x " + std::to_string(rows_) +
                                  " heights, more than its " + std::to_string(source_.bytes.size()) + " bytes can hold");
    }
  }

  std::size_t pixel_bytes() const { return std::size_t{channels_} * bits_ / 8; }

  template <class Number>
  static double as(const std::byte* at) {
    Number number;
    std::memcpy(&number, at, sizeof number);
    return static_cast<double>(number);
  }
  double value(const std::byte* at) const {
    const bool is_signed = format_ == SAMPLEFORMAT_INT;
    if (format_ == SAMPLEFORMAT_IEEEFP) return bits_ == 32 ? as<float>(at) : as<double>(at);
    if (bits_ == 8) return is_signed ? as<std::int8_t>(at) : as<std::uint8_t>(at);
    if (bits_ == 16) return is_signed ? as<std::int16_t>(at) : as<std::uint16_t>(at);
    return is_signed ? as<std::int32_t>(at) : as<std::uint32_t>(at);
  }

  template <class Height, class Take>
  void read_lines(std::vector<Height>& heights, Take take) {
    std::vector<std::byte> line(static_cast<std::size_t>(std::max<tmsize_t>(TIFFScanlineSize(tiff_.get()), 0)));
    if (line.size() < columns_ * pixel_bytes()) throw broken();
    for (std::size_t j = 0; j < rows_; ++j) {
      if (TIFFReadScanline(tiff_.get(), line.data(), static_cast<std::uint32_t>(j), 0) != 1) throw broken();
      heights.resize((j + 1) * columns_);  // they take room as they come
      take(line.data(), columns_, heights.data() + j * columns_);
    }
  }

  template <class Height, class Take>
  void read_tiles(std::vector<Height>& heights, Take take) {
    std::uint32_t width = 0, length = 0;
    TIFFGetField(tiff_.get(), TIFFTAG_TILEWIDTH, &width);
    TIFFGetField(tiff_.get(), TIFFTAG_TILELENGTH, &length);
    const tmsize_t size = TIFFTileSize(tiff_.get());
    if (width == 0 || length == 0 || size <= 0 || size > kLargestBlock ||
        static_cast<std::uint64_t>(size) < std::uint64_t{width} * length * pixel_bytes())
      throw broken();
    std::vector<std::byte> tile(static_cast<std::size_t>(size));
    for (std::size_t top = 0; top < rows_; top += length) {
      const std::size_t count = std::min<std::size_t>(length, rows_ - top);
      for (std::size_t left = 0; left < columns_; left += width) {
        if (TIFFReadTile(tiff_.get(), tile.data(), static_cast<std::uint32_t>(left), static_cast<std::uint32_t>(top), 0, 0) <
            0)
          throw broken();
        if (left == 0) heights.resize((top + count) * columns_);
        for (std::size_t j = 0; j < count; ++j) {
          take(tile.data() + j * width * pixel_bytes(), std::min<std::size_t>(width, columns_ - left),
               heights.data() + (top + j) * columns_ + left);
        }
      }
    }
  }

  /// Tags that libtiff does not know have a count and a block of values.
  template <class Number>
  std::vector<Number> values(std::uint32_t tag, TIFFDataType type) {
    const TIFFField* const field = TIFFFindField(tiff_.get(), tag, TIFF_ANY);
    if (!field || TIFFFieldDataType(field) != type || !TIFFFieldPassCount(field)) return {};
    void* data = nullptr;
    std::size_t count = 0;
    if (TIFFFieldReadCount(field) == TIFF_VARIABLE2) {
      std::uint32_t found = 0;
      if (TIFFGetField(tiff_.get(), tag, &found, &data) != 1) return {};
      count = found;
    } else {
      std::uint16_t found = 0;
      if (TIFFGetField(tiff_.get(), tag, &found, &data) != 1) return {};
      count = found;
    }
    std::vector<Number> out(count);
    if (count > 0) std::memcpy(out.data(), data, count * sizeof(Number));
    return out;
  }
  std::vector<double> doubles(std::uint32_t tag) {
    std::vector<double> all = values<double>(tag, TIFF_DOUBLE);
    const bool finite = std::all_of(all.begin(), all.end(), [](double v) { return std::isfinite(v); });
    return finite ? all : std::vector<double>{};
  }

  /// The short value of a key of the GeoTIFF directory, 0 where there is none.
  std::uint16_t geo_key(std::uint16_t key) {
    const std::vector<std::uint16_t> keys = values<std::uint16_t>(kGeoKeysTag, TIFF_SHORT);
    for (std::size_t k = 4; k + 3 < keys.size(); k += 4) {
      if (keys[k] == key && keys[k + 1] == 0) return keys[k + 3];
    }
    return 0;
  }

  std::optional<double> no_data_value() {
    const std::vector<char> text = values<char>(kNoDataTag, TIFF_ASCII);
    const auto length = std::find(text.begin(), text.end(), '\0') - text.begin();
    return number_in(trimmed(std::string_view(text.data(), static_cast<std::size_t>(length))));
  }

  Source source_;
  const std::string& name_;
  std::unique_ptr<TIFF, CloseTiff> tiff_;
  std::size_t columns_ = 0, rows_ = 0;
  std::uint16_t bits_ = 1, channels_ = 1, format_ = SAMPLEFORMAT_UINT;
};

template <class Height>
std::unique_ptr<HeightSource> read_heights(TiffFile& tiff, const std::string& name) {
  std::vector<Height> heights = tiff.read<Height>();
  std::vector<double> x, y;
  const GroundUnit unit = tiff.positions(x, y);
  const SampleOrder order = SampleOrder::first_row_highest(tiff.columns(), tiff.rows());
  std::unique_ptr<HeightSource> source = held_heights(std::move(x), std::move(y), std::move(heights), order, name);
  source->set_unit(unit);
  return source;
}

}  // namespace

std::unique_ptr<HeightSource> read_tiff_grid(std::span<const std::byte> bytes, const std::string& name, Warnings&) {
  TiffFile tiff(bytes, name);
  return tiff.needs_double() ? read_heights<double>(tiff, name) : read_heights<float>(tiff, name);
}

bool reads_tiff() { return true; }

}  // namespace ligne

#else

namespace ligne {

std::unique_ptr<HeightSource> read_tiff_grid(std::span<const std::byte>, const std::string& name, Warnings&) {
  throw InputError(name, "is a TIFF file, and this ligne is built without libtiff");
}

bool reads_tiff() { return false; }

}  // namespace ligne

#endif
