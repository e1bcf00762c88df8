#include "scene/surfaces/grids/grid_formats.hpp"

#ifdef LIGNE_HAVE_GDAL

#include <cpl_error.h>
#include <cpl_string.h>
#include <gdal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

#include "scene/readers/text_lines.hpp"
#include "scene/surfaces/grids/raster_placement.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

/// Largest number of columns or rows: more than anybody draws, so a larger number means a wrong header.
constexpr int kMostPerSide = 1 << 24;

struct CloseDataset {
  void operator()(GDALDatasetH dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, CloseDataset>;

/// Keeps GDAL's messages off standard error during its lifetime, and gives the last one.
class QuietErrors {
 public:
  QuietErrors() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~QuietErrors() { CPLPopErrorHandler(); }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

  static std::string last() {
    constexpr std::size_t kLongest = 200;
    const std::string message = printable(CPLGetLastErrorMsg(), kLongest);
    return message.empty() ? "no reason given" : message;
  }
};

/// Conversion of the values of a band to heights.
struct Meaning {
  std::optional<double> no_data;
  bool is_float32 = false;  ///< NODATA may have more or fewer digits than the values
  GDALRasterBandH mask = nullptr;
  double scale = 1, offset = 0;

  double height(double value) const {
    const double scaled = value * scale + offset;
    const bool none =
        no_data && (value == *no_data || (is_float32 && static_cast<float>(value) == static_cast<float>(*no_data)));
    return none || !std::isfinite(scaled) ? std::numeric_limits<double>::quiet_NaN() : scaled;
  }
};

/// Reads rows from the file. A data set is for one thread at a time.
class GdalHeights : public HeightSource {
 public:
  GdalHeights(RasterPlacement placement, Dataset dataset, GDALRasterBandH band, Meaning meaning, std::string name)
      : HeightSource(std::move(placement.x), std::move(placement.y)),
        dataset_(std::move(dataset)),
        band_(band),
        meaning_(meaning),
        north_up_(placement.order.step_y < 0),
        west_first_(placement.order.step_x > 0),
        name_(std::move(name)) {}

  void read_row(std::size_t j, std::span<double> z) const override {
    const auto line = static_cast<int>(north_up_ ? y().size() - 1 - j : j);
    const auto columns = static_cast<int>(z.size());
    std::vector<std::uint8_t> valid;
    {
      const std::lock_guard lock(mutex_);
      const QuietErrors quiet;
      read_line(band_, line, z.data(), columns, GDT_Float64);
      if (meaning_.mask) {
        valid.resize(z.size());
        read_line(meaning_.mask, line, valid.data(), columns, GDT_Byte);
      }
    }
    for (double& height : z) height = meaning_.height(height);
    for (std::size_t i = 0; i < valid.size(); ++i) {
      if (valid[i] == 0) z[i] = std::numeric_limits<double>::quiet_NaN();
    }
    if (!west_first_) std::reverse(z.begin(), z.end());
  }

  bool has_height() const {
    std::vector<double> row(x().size());
    for (std::size_t j = 0; j < y().size(); ++j) {
      read_row(j, row);
      if (!std::all_of(row.begin(), row.end(), [](double z) { return std::isnan(z); })) return true;
    }
    return false;
  }

 private:
  void read_line(GDALRasterBandH band, int line, void* to, int columns, GDALDataType type) const {
    if (GDALRasterIO(band, GF_Read, 0, line, columns, 1, to, columns, 1, type, 0, 0) == CE_None) return;
    throw InputError(name_, "row " + std::to_string(line + 1) + " can not be read: " + QuietErrors::last());
  }

  Dataset dataset_;
  GDALRasterBandH band_;
  Meaning meaning_;
  bool north_up_, west_first_;
  std::string name_;
  mutable std::mutex mutex_;
};

Meaning meaning_of(GDALRasterBandH band) {
  Meaning meaning;
  int is_given = 0;
  const double no_data = GDALGetRasterNoDataValue(band, &is_given);
  if (is_given != 0) meaning.no_data = no_data;
  const double scale = GDALGetRasterScale(band, &is_given);
  if (is_given != 0 && scale != 0) meaning.scale = scale;
  const double offset = GDALGetRasterOffset(band, &is_given);
  if (is_given != 0) meaning.offset = offset;
  meaning.is_float32 = GDALGetRasterDataType(band) == GDT_Float32;
  if (GDALGetMaskFlags(band) == GMF_PER_DATASET) meaning.mask = GDALGetMaskBand(band);
  return meaning;
}

GDALRasterBandH chosen_band(GDALDatasetH dataset, const GridChoice& choice, const std::string& name, Warnings& warnings) {
  const int count = GDALGetRasterCount(dataset);
  if (count < 1) throw InputError(name, "has no raster band");
  const unsigned number = choice.band.value_or(1);
  if (number > static_cast<unsigned>(count)) {
    throw InputError(name, "has " + std::to_string(count) + (count == 1 ? " band" : " bands") + ", but no band " +
                               std::to_string(number));
  }
  const GDALRasterBandH band = GDALGetRasterBand(dataset, static_cast<int>(number));
  if (!choice.band && count >= 3 && GDALGetRasterColorInterpretation(band) == GCI_RedBand) {
    throw InputError(name, "is a picture in colours; heights need one band, which --band N chooses");
  }
  if (!choice.band && count > 1) {
    warnings.leave_out("bands after the first, which --band N chooses", static_cast<std::size_t>(count - 1));
  }
  return band;
}

/// GDAL reads rows in the order of the file, so the raster may be mirrored, but not turned by a right angle.
RasterPlacement placed_rows(GDALDatasetH dataset, std::size_t columns, std::size_t rows, const std::string& name,
                            Warnings& warnings) {
  std::array<double, 6> t{};
  if (GDALGetGeoTransform(dataset, t.data()) != CE_None) return count_raster(columns, rows);
  RasterTransform transform{.at = {t[0], t[3]}, .per_column = {t[1], t[4]}, .per_row = {t[2], t[5]}};
  std::optional<RasterPlacement> placement = place_raster(transform, columns, rows);
  if (!placement || std::abs(placement->order.step_x) != 1) {
    throw InputError(name, "its rows do not run east; rotate it with gdalwarp first");
  }
  warn_of_turned_raster(*placement, warnings);
  return std::move(*placement);
}

}  // namespace

std::unique_ptr<HeightSource> read_gdal_grid(const std::filesystem::path& file, const std::string& name, Warnings& warnings,
                                             const GridChoice& choice, InputFiles& opened) {
  if (file.empty()) throw InputError(name, "is standard input, but GDAL reads files only");
  const QuietErrors quiet;
  GDALAllRegister();
  Dataset dataset(GDALOpen(file.c_str(), GA_ReadOnly));
  if (!dataset) throw InputError(name, "can not be read by GDAL: " + QuietErrors::last());
  char** const files = GDALGetFileList(dataset.get());
  for (char** at = files; at && *at; ++at) opened.emplace_back(*at);
  CSLDestroy(files);
  const GDALRasterBandH band = chosen_band(dataset.get(), choice, name, warnings);
  const int columns = GDALGetRasterBandXSize(band), rows = GDALGetRasterBandYSize(band);
  const auto width = static_cast<std::size_t>(std::max(columns, 0)), height = static_cast<std::size_t>(std::max(rows, 0));
  check_counts(width, height, name);
  if (columns > kMostPerSide || rows > kMostPerSide) {
    throw InputError(name,
                     "has " + std::to_string(columns) + " x " + std::to_string(rows) + " heights, more than can be drawn");
  }
  RasterPlacement placement = placed_rows(dataset.get(), width, height, name, warnings);
  check_positions(placement.x, "x", name);
  check_positions(placement.y, "y", name);
  auto heights = std::make_unique<GdalHeights>(std::move(placement), std::move(dataset), band, meaning_of(band), name);
  if (!heights->has_height()) throw InputError(name, "contains only NODATA values");
  return heights;
}

bool reads_by_gdal() { return true; }

}  // namespace ligne

#else

namespace ligne {

std::unique_ptr<HeightSource> read_gdal_grid(const std::filesystem::path&, const std::string& name, Warnings&,
                                             const GridChoice&, InputFiles&) {
  throw InputError(name, "needs GDAL (a GeoTIFF, HDF5 or netCDF file), and this ligne is built without it");
}

bool reads_by_gdal() { return false; }

}  // namespace ligne

#endif
