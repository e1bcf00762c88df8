#pragma once
/// An open TIFF file and its tags, by libtiff. Only for builds with libtiff.

#ifdef LIGNE_HAVE_TIFF

#include <tiffio.h>

#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "files/input_error.hpp"
#include "scene/surfaces/grids/raster_placement.hpp"

namespace ligne {

/// Conversion of the numbers of a band to heights: number * scale + offset.
struct BandScale {
  double scale = 1, offset = 0;
  bool is_given() const { return scale != 1 || offset != 0; }
};

/// Largest size of a strip or tile in bytes; no grid that fits into memory needs more.
inline constexpr tmsize_t kLargestTiffBlock = tmsize_t{1} << 30;

/// Reads tags of the current directory of a TIFF file in memory. Keeps libtiff's messages off standard error.
class TiffTags {
 public:
  /// Throws InputError.
  TiffTags(std::span<const std::byte> bytes, const std::string& name);

  TIFF* file() const { return tiff_.get(); }
  const std::string& name() const { return name_; }
  std::size_t bytes() const { return source_.bytes.size(); }
  /// The error that the file can not be read, with libtiff's first message.
  InputError broken() const;

  std::uint16_t number(std::uint32_t tag, std::uint16_t otherwise) const;
  std::uint32_t long_number(std::uint32_t tag) const;

  /// GDAL's NODATA.
  std::optional<double> no_data() const;
  /// SCALE and OFFSET of a band, counted from 0, in GDAL's metadata.
  BandScale scale_of(unsigned band) const;
  /// The georeference, from a matrix or from a tie point and a scale.
  std::optional<RasterTransform> transform() const;
  /// Number of tie points if there is no scale; using them would need a warp.
  std::size_t control_points() const;
  /// The band (from 0) that is 0 where the picture is transparent.
  std::optional<unsigned> alpha_band(unsigned channels) const;
  /// Whether positions are longitude and latitude.
  bool is_geographic() const;

 private:
  /// The bytes of a file, as libtiff's callbacks read them.
  struct Source {
    std::span<const std::byte> bytes;
    std::uint64_t at = 0;
    std::string message;

    static tmsize_t read(thandle_t handle, void* to, tmsize_t size);
    static tmsize_t write(thandle_t, void*, tmsize_t) { return 0; }
    static toff_t seek(thandle_t handle, toff_t offset, int whence);
    static int close(thandle_t) { return 0; }
    static toff_t size(thandle_t handle) { return static_cast<Source*>(handle)->bytes.size(); }
    static int on_error(TIFF*, void* self, const char*, const char* format, va_list arguments);
    static int on_warning(TIFF*, void*, const char*, const char*, va_list) { return 1; }
  };
  struct Close {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
  };

  template <class Number>
  std::vector<Number> values(std::uint32_t tag, TIFFDataType type) const;
  std::vector<double> doubles(std::uint32_t tag) const;
  std::string text(std::uint32_t tag) const;
  std::uint16_t geo_key(std::uint16_t key) const;

  Source source_;
  const std::string& name_;
  std::unique_ptr<TIFF, Close> tiff_;
};

}  // namespace ligne

#endif
