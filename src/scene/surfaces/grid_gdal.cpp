#include "scene/surfaces/grid_formats.hpp"

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
#include "scene/surfaces/held_heights.hpp"

namespace ligne {
namespace {

/// More columns or rows than anybody draws: beyond it a header lies.
constexpr int kMostPerSide = 1 << 24;

struct CloseDataset {
  void operator()(GDALDatasetH dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, CloseDataset>;

/// GDAL's own messages stay off standard error while one of these lives; it says what the last one was.
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

/// How the values of a band become heights.
struct Meaning {
  std::optional<double> no_data;
  double scale = 1, offset = 0;

  double height(double value) const {
    const double scaled = value * scale + offset;
    return (no_data && value == *no_data) || !std::isfinite(scaled) ? std::numeric_limits<double>::quiet_NaN() : scaled;
  }
};

/// Reads row by row from the file; a data set is for one thread at a time.
class GdalHeights : public HeightSource {
 public:
  GdalHeights(std::vector<double> x, std::vector<double> y, Dataset dataset, GDALRasterBandH band, Meaning meaning,
              bool north_up, std::string name)
      : HeightSource(std::move(x), std::move(y)),
        dataset_(std::move(dataset)),
        band_(band),
        meaning_(meaning),
        north_up_(north_up),
        name_(std::move(name)) {}

  void read_row(std::size_t j, std::span<double> z) const override {
    const auto line = static_cast<int>(north_up_ ? y().size() - 1 - j : j);
    const auto columns = static_cast<int>(z.size());
    {
      const std::lock_guard lock(mutex_);
      const QuietErrors quiet;
      if (GDALRasterIO(band_, GF_Read, 0, line, columns, 1, z.data(), columns, 1, GDT_Float64, 0, 0) != CE_None) {
        throw InputError(name_, "row " + std::to_string(line + 1) + " can not be read: " + QuietErrors::last());
      }
    }
    for (double& height : z) height = meaning_.height(height);
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
  Dataset dataset_;
  GDALRasterBandH band_;
  Meaning meaning_;
  bool north_up_;
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
  return meaning;
}

/// Of the middles of n cells along an axis, ascending.
std::vector<double> middles(double origin, double step, int n) {
  std::vector<double> out(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) out[static_cast<std::size_t>(i)] = origin + (i + 0.5) * step;
  if (step < 0) std::reverse(out.begin(), out.end());
  return out;
}

}  // namespace

std::unique_ptr<HeightSource> read_gdal_grid(const std::filesystem::path& file, const std::string& name,
                                             InputFiles& opened) {
  if (file.empty()) throw InputError(name, "is a file for GDAL, which reads files only");
  const QuietErrors quiet;
  GDALAllRegister();
  Dataset dataset(GDALOpen(file.c_str(), GA_ReadOnly));
  if (!dataset) throw InputError(name, "can not be read by GDAL: " + QuietErrors::last());
  char** const files = GDALGetFileList(dataset.get());
  for (char** at = files; at && *at; ++at) opened.emplace_back(*at);
  CSLDestroy(files);
  if (GDALGetRasterCount(dataset.get()) < 1) throw InputError(name, "has no raster band");
  const GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
  if (GDALGetRasterCount(dataset.get()) >= 3 && GDALGetRasterColorInterpretation(band) == GCI_RedBand) {
    throw InputError(name, "is a picture in colours; heights need one band");
  }
  const int columns = GDALGetRasterBandXSize(band), rows = GDALGetRasterBandYSize(band);
  check_counts(static_cast<std::size_t>(std::max(columns, 0)), static_cast<std::size_t>(std::max(rows, 0)), name);
  if (columns > kMostPerSide || rows > kMostPerSide) {
    throw InputError(name,
                     "has " + std::to_string(columns) + " x " + std::to_string(rows) + " heights, more than can be drawn");
  }

  std::array<double, 6> transform{};
  // Without a georeference positions are counted, as those of pictures.
  if (GDALGetGeoTransform(dataset.get(), transform.data()) != CE_None) transform = {-0.5, 1, 0, rows - 0.5, 0, -1};
  if (transform[2] != 0 || transform[4] != 0 || !(transform[1] > 0) || transform[5] == 0) {
    throw InputError(name, "its rows do not run east; put it upright with gdalwarp first");
  }
  std::vector<double> x = middles(transform[0], transform[1], columns), y = middles(transform[3], transform[5], rows);
  check_positions(x, "x", name);
  check_positions(y, "y", name);
  auto heights = std::make_unique<GdalHeights>(std::move(x), std::move(y), std::move(dataset), band, meaning_of(band),
                                               transform[5] < 0, name);
  if (!heights->has_height()) throw InputError(name, "holds no height, only places without one (NODATA)");
  return heights;
}

}  // namespace ligne

#else

namespace ligne {

std::unique_ptr<HeightSource> read_gdal_grid(const std::filesystem::path&, const std::string& name, InputFiles&) {
  throw InputError(name, "needs GDAL (a GeoTIFF, HDF5 or netCDF file), and this ligne is built without it");
}

}  // namespace ligne

#endif
