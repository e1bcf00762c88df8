#pragma once
/// Where the samples of a raster lie: from the affine map of a georeference to positions along x and y.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "files/input_file.hpp"
#include "geometry/point.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {

/// place = at + (column - pixel.x) * per_column + (row - pixel.y) * per_row. Pixel (0, 0) reaches from (0, 0) to (1, 1), and
/// its sample stands at (sample_at, sample_at).
struct RasterTransform {
  Point2 pixel{0, 0}, at{0, 0};
  Point2 per_column{1, 0}, per_row{0, -1};
  double sample_at = 0.5;

  bool is_finite() const;
};

/// Positions of the samples, ascending, and the order in which rows stored from first to last hold them.
struct RasterPlacement {
  std::vector<double> x, y;
  SampleOrder order;
  double turned_degrees = 0;  ///< from the axes of the ground to those of the raster, where they do not run along each other
  bool sheared = false;       ///< columns do not meet rows at right angles
};

/// Rows and columns that run along x and y, in either direction and either way round, have the positions that the transform
/// says. Others have lengths along their own directions as positions, and the middle sample keeps its place. Nothing where
/// the transform takes all samples to one line.
std::optional<RasterPlacement> place_raster(const RasterTransform& transform, std::size_t columns, std::size_t rows);

/// Samples of a file without a georeference: columns are counted from the left, rows from the last one.
RasterPlacement count_raster(std::size_t columns, std::size_t rows);

/// Warns of a raster that does not lie along x and y.
void warn_of_turned_raster(const RasterPlacement& placement, Warnings& warnings);

/// The transform in the world file beside a picture: NAME.tfw, NAME.wld or NAME with "w" at its end, which has six numbers
/// for the middles of pixels. Nothing where there is none. Adds the file to `opened`. A file of another form gives a
/// warning.
std::optional<RasterTransform> read_world_file(const std::filesystem::path& picture, InputFiles& opened, Warnings& warnings);

}  // namespace ligne
