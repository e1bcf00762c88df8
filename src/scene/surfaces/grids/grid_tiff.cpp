// Reads TIFF with libtiff: strips and tiles, integers and floats, every compression of libtiff (deflate, LZW, PackBits,
// ZSTD, LERC, with predictors), classic and BigTIFF. One band is read; a mask in the file makes holes.

#include "scene/surfaces/grids/grid_formats.hpp"

#ifdef LIGNE_HAVE_TIFF

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "scene/readers/load_bytes.hpp"
#include "scene/surfaces/grids/raster_placement.hpp"
#include "scene/surfaces/grids/tiff_tags.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

/// Largest ratio by which libtiff expands data: one LZW code for 3840 bytes.
constexpr std::uint64_t kMostUnpacked = 4096;
/// Largest number of directories that are read. Grids have far fewer masks and overviews, but a damaged chain of
/// directories may be as long as the file.
constexpr int kMostDirectories = 1000;
/// Floats below this are ESRI's sign for a missing height, -3.4e38, in files that do not define one.
constexpr double kLowestHeight = -1e38;
/// The sign for a missing height closest to zero (drop_missing_values).
constexpr double kFirstSign = -9999;

/// Size and sample format of one directory.
struct TiffShape {
  std::size_t columns = 0, rows = 0;
  unsigned bits = 1, channels = 1, format = SAMPLEFORMAT_UINT, photometric = PHOTOMETRIC_MINISBLACK;
  bool planes = false;  ///< each band is stored separately

  explicit TiffShape(const TiffTags& tags)
      : columns(tags.long_number(TIFFTAG_IMAGEWIDTH)),
        rows(tags.long_number(TIFFTAG_IMAGELENGTH)),
        bits(tags.number(TIFFTAG_BITSPERSAMPLE, 1)),
        channels(tags.number(TIFFTAG_SAMPLESPERPIXEL, 1)),
        format(tags.number(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT)),
        photometric(tags.number(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK)),
        planes(tags.number(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) != PLANARCONFIG_CONTIG) {}

  /// Distance between consecutive samples of a band, in bits.
  std::size_t step_bits() const { return std::size_t{bits} * (planes ? 1 : channels); }
  std::size_t row_bytes(std::size_t count) const { return (count * step_bits() + 7) / 8; }
};

/// Reads one band of the current directory, block by block: take(first sample, column, row, count). The pointer to the
/// samples is null for blocks that a sparse file leaves out.
class TiffBlocks {
 public:
  TiffBlocks(const TiffTags& tags, const TiffShape& shape, unsigned band)
      : tags_(tags), shape_(shape), plane_(static_cast<std::uint16_t>(shape.planes ? band : 0)) {}

  template <class Take>
  void read(Take take) const {
    TIFFIsTiled(tags_.file()) ? read_tiles(take) : read_lines(take);
  }

 private:
  template <class Take>
  void read_lines(Take take) const {
    std::vector<std::byte> line(static_cast<std::size_t>(std::max<tmsize_t>(TIFFScanlineSize(tags_.file()), 0)));
    if (line.size() < shape_.row_bytes(shape_.columns)) throw tags_.broken();
    for (std::size_t j = 0; j < shape_.rows; ++j) {
      if (is_left_out(TIFFComputeStrip(tags_.file(), static_cast<std::uint32_t>(j), plane_))) {
        take(static_cast<const std::byte*>(nullptr), std::size_t{0}, j, shape_.columns);
        continue;
      }
      if (TIFFReadScanline(tags_.file(), line.data(), static_cast<std::uint32_t>(j), plane_) != 1) throw tags_.broken();
      take(line.data(), std::size_t{0}, j, shape_.columns);
    }
  }

  template <class Take>
  void read_tiles(Take take) const {
    const std::size_t width = tags_.long_number(TIFFTAG_TILEWIDTH), length = tags_.long_number(TIFFTAG_TILELENGTH);
    const tmsize_t size = TIFFTileSize(tags_.file());
    if (width == 0 || length == 0 || size <= 0 || size > kLargestTiffBlock ||
        static_cast<std::uint64_t>(size) / shape_.row_bytes(width) < length)
      throw tags_.broken();
    std::vector<std::byte> tile(static_cast<std::size_t>(size));
    for (std::size_t top = 0; top < shape_.rows; top += length) {
      const std::size_t count = std::min(length, shape_.rows - top);
      for (std::size_t left = 0; left < shape_.columns; left += width) {
        const auto column = static_cast<std::uint32_t>(left), row = static_cast<std::uint32_t>(top);
        const bool left_out = is_left_out(TIFFComputeTile(tags_.file(), column, row, 0, plane_));
        if (!left_out && TIFFReadTile(tags_.file(), tile.data(), column, row, 0, plane_) < 0) throw tags_.broken();
        for (std::size_t j = 0; j < count; ++j) {
          const std::byte* const first = left_out ? nullptr : tile.data() + j * shape_.row_bytes(width);
          take(first, left, top + j, std::min(width, shape_.columns - left));
        }
      }
    }
  }

  bool is_left_out(std::uint32_t block) const {
    return TIFFGetStrileByteCount(tags_.file(), block) == 0 && TIFFGetStrileOffset(tags_.file(), block) == 0;
  }

  const TiffTags& tags_;
  const TiffShape& shape_;
  std::uint16_t plane_;
};

class TiffFile {
 public:
  TiffFile(std::span<const std::byte> bytes, const std::string& name, const GridChoice& choice, Warnings& warnings)
      : tags_(bytes, name), shape_(tags_), band_(choice.band.value_or(1) - 1), warnings_(warnings) {
    no_data_ = tags_.no_data();
    check_shape(choice);
    scale_ = tags_.scale_of(band_);
  }

  bool needs_double() const {
    return scale_.is_given() || shape_.bits == 64 || (shape_.bits == 32 && type_ != NumberType::float32);
  }

  template <class Height>
  std::unique_ptr<HeightSource> read(const std::filesystem::path& file, InputFiles& opened) {
    RasterPlacement placement = placed(file, opened);
    const bool geographic = tags_.is_geographic();
    std::vector<Height> heights = read_band<Height>();
    if (!no_data_) leave_out_signs(heights);
    if (alpha_ && *alpha_ != band_) apply_alpha(heights);
    read_other_directories(heights);
    if (scale_.is_given()) {
      for (Height& z : heights) z = static_cast<Height>(z * scale_.scale + scale_.offset);
    }
    std::unique_ptr<HeightSource> source =
        held_heights(std::move(placement.x), std::move(placement.y), std::move(heights), placement.order, tags_.name());
    const GroundUnit seen = from_world_file_ ? likely_unit(*source) : GroundUnit::same;
    source->set_unit(geographic ? GroundUnit::degrees : seen);
    return source;
  }

 private:
  /// The error for a file that libtiff does not read, but GDAL may.
  UnreadTiff not_read(const std::string& what) const {
    return UnreadTiff(tags_.name(), "is a TIFF file with " + what +
                                        ", which is not read; gdal_translate -ot Float32 -co COMPRESS=DEFLATE makes one "
                                        "that is");
  }

  void check_shape(const GridChoice& choice) {
    check_counts(shape_.columns, shape_.rows, tags_.name());
    const auto compression = tags_.number(TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    if (TIFFIsCODECConfigured(compression) != 1) throw not_read("the packing " + std::to_string(compression));
    const bool colored = shape_.photometric == PHOTOMETRIC_RGB || shape_.photometric == PHOTOMETRIC_PALETTE;
    if (shape_.photometric == PHOTOMETRIC_YCBCR || (colored && !choice.band)) {
      throw InputError(tags_.name(), "is a picture in colours; heights need one band, which --band N chooses");
    }
    const bool is_number = shape_.format >= SAMPLEFORMAT_UINT && shape_.format <= SAMPLEFORMAT_IEEEFP;
    const NumberKind kind = shape_.format == SAMPLEFORMAT_UINT  ? NumberKind::unsigned_integer
                            : shape_.format == SAMPLEFORMAT_INT ? NumberKind::signed_integer
                                                                : NumberKind::floating;
    const auto type = is_number && shape_.bits % 8 == 0 ? number_type(kind, shape_.bits / 8) : std::nullopt;
    if (!type) {
      constexpr const char* kKinds[] = {"unknown", "unsigned integer", "integer", "float",
                                        "unknown", "complex integer",  "complex"};
      throw not_read("values of " + std::to_string(shape_.bits) + " bits of kind " +
                     kKinds[shape_.format < std::size(kKinds) ? shape_.format : 0]);
    }
    type_ = *type;
    if (shape_.channels == 0) throw tags_.broken();
    if (band_ >= shape_.channels) {
      throw InputError(tags_.name(), "has " + std::to_string(shape_.channels) + (shape_.channels == 1 ? " band" : " bands") +
                                         ", but no band " + std::to_string(band_ + 1));
    }
    if (!no_data_) alpha_ = tags_.alpha_band(shape_.channels);  // NODATA has priority over transparency, as in GDAL
    if (!choice.band) {
      warnings_.leave_out("bands after the first, which --band N chooses",
                          shape_.channels - (alpha_.value_or(0) > 0 ? 2 : 1));
    }
    if (shape_.rows > kMostUnpacked * tags_.bytes() / shape_.row_bytes(shape_.columns)) {
      throw InputError(tags_.name(), "is a TIFF file that declares " + std::to_string(shape_.columns) + " x " +
                                         std::to_string(shape_.rows) + " heights, more than its " +
                                         std::to_string(tags_.bytes()) + " bytes can hold");
    }
  }

  double value(const std::byte* at) const { return load_number(at, type_, std::endian::native); }

  /// Whether a value is NODATA, which may be written with fewer or more digits than a float has.
  bool is_no_data(double z) const {
    if (!no_data_) return false;
    return z == *no_data_ || (type_ == NumberType::float32 && static_cast<float>(z) == static_cast<float>(*no_data_));
  }

  /// The numbers of the band, row by row from the first one.
  template <class Height>
  std::vector<Height> read_band() const {
    std::vector<Height> heights;
    const std::size_t step = shape_.step_bits() / 8;
    const std::size_t first = shape_.planes ? 0 : std::size_t{band_} * shape_.bits / 8;
    TiffBlocks(tags_, shape_, band_).read([&](const std::byte* from, std::size_t left, std::size_t row, std::size_t count) {
      if (heights.size() <= row * shape_.columns) heights.resize((row + 1) * shape_.columns);  // takes room as rows come
      Height* const to = heights.data() + row * shape_.columns + left;
      for (std::size_t i = 0; i < count; ++i) {
        const double z = from ? value(from + first + i * step) : no_data_.value_or(0);
        to[i] = !std::isfinite(z) || is_no_data(z) ? std::numeric_limits<Height>::quiet_NaN() : static_cast<Height>(z);
      }
    });
    return heights;
  }

  /// Makes holes where the picture is transparent.
  template <class Height>
  void apply_alpha(std::vector<Height>& heights) const {
    const std::size_t step = shape_.step_bits() / 8;
    const std::size_t first = shape_.planes ? 0 : std::size_t{*alpha_} * shape_.bits / 8;
    TiffBlocks(tags_, shape_, *alpha_)
        .read([&](const std::byte* from, std::size_t left, std::size_t row, std::size_t count) {
          for (std::size_t i = 0; i < count; ++i) {
            if (!from || value(from + first + i * step) == 0) {
              heights[row * shape_.columns + left + i] = std::numeric_limits<Height>::quiet_NaN();
            }
          }
        });
  }

  /// Turns the usual signs for missing heights into holes, in a file that defines none.
  template <class Height>
  void leave_out_signs(std::vector<Height>& heights) const {
    std::size_t lowest = 0;
    bool has_sign = false;
    for (Height& z : heights) {
      if (z < kLowestHeight) {
        z = std::numeric_limits<Height>::quiet_NaN();
        ++lowest;
      }
      has_sign = has_sign || z <= kFirstSign;
    }
    warnings_.add("heights below -1e38 read as NODATA", lowest);
    if (!has_sign) return;
    std::vector<double> values(heights.begin(), heights.end());
    drop_missing_values(values, 1, warnings_);
    for (std::size_t k = 0; k < values.size(); ++k) {
      if (std::isnan(values[k])) heights[k] = std::numeric_limits<Height>::quiet_NaN();
    }
  }

  /// Makes holes where the file's mask has them, and counts pages that are not drawn.
  template <class Height>
  void read_other_directories(std::vector<Height>& heights) {
    bool masked = false;
    for (int k = 0; k < kMostDirectories && TIFFReadDirectory(tags_.file()) == 1; ++k) {
      const std::uint32_t kind = tags_.long_number(TIFFTAG_SUBFILETYPE);
      if (kind & FILETYPE_REDUCEDIMAGE) continue;
      if (!(kind & FILETYPE_MASK)) {
        warnings_.leave_out("pages after the first");
        continue;
      }
      const TiffShape mask(tags_);
      const bool fits = mask.columns == shape_.columns && mask.rows == shape_.rows && mask.channels == 1 &&
                        (mask.bits == 1 || mask.bits == 8);
      if (!fits) {
        warnings_.leave_out("masks that differ in size from the heights");
      } else if (!masked) {
        apply_mask(mask, heights);
        masked = true;
      }
    }
  }

  template <class Height>
  void apply_mask(const TiffShape& mask, std::vector<Height>& heights) const {
    TiffBlocks(tags_, mask, 0).read([&](const std::byte* from, std::size_t left, std::size_t row, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) {
        const bool valid = from && (mask.bits == 8 ? from[i] : from[i / 8] >> (7 - i % 8) & std::byte{1}) != std::byte{0};
        if (!valid) heights[row * shape_.columns + left + i] = std::numeric_limits<Height>::quiet_NaN();
      }
    });
  }

  RasterPlacement placed(const std::filesystem::path& file, InputFiles& opened) {
    std::optional<RasterTransform> transform = tags_.transform();
    if (!transform) {
      transform = read_world_file(file, opened, warnings_);
      from_world_file_ = transform.has_value();
    }
    if (!transform) {
      warnings_.leave_out("ground control points, which gdalwarp applies", tags_.control_points());
      return count_raster(shape_.columns, shape_.rows);
    }
    std::optional<RasterPlacement> placement = place_raster(*transform, shape_.columns, shape_.rows);
    if (!placement) {
      warnings_.add("georeference that maps the raster to a line: rows and columns used as positions");
      return count_raster(shape_.columns, shape_.rows);
    }
    warn_of_turned_raster(*placement, warnings_);
    return std::move(*placement);
  }

  TiffTags tags_;
  TiffShape shape_;
  unsigned band_;  ///< from 0
  NumberType type_ = NumberType::float32;
  Warnings& warnings_;
  BandScale scale_;
  std::optional<double> no_data_;
  std::optional<unsigned> alpha_;  ///< band of the transparency
  bool from_world_file_ = false;
};

}  // namespace

std::unique_ptr<HeightSource> read_tiff_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                             const GridChoice& choice, const std::filesystem::path& file,
                                             InputFiles* opened) {
  TiffFile tiff(bytes, name, choice, warnings);
  InputFiles unasked;
  InputFiles& files = opened ? *opened : unasked;
  return tiff.needs_double() ? tiff.read<double>(file, files) : tiff.read<float>(file, files);
}

bool reads_tiff() { return true; }

}  // namespace ligne

#else

namespace ligne {

std::unique_ptr<HeightSource> read_tiff_grid(std::span<const std::byte>, const std::string& name, Warnings&,
                                             const GridChoice&, const std::filesystem::path&, InputFiles*) {
  throw InputError(name, "is a TIFF file, and this ligne is built without libtiff");
}

bool reads_tiff() { return false; }

}  // namespace ligne

#endif
