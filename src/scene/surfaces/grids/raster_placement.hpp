#pragma once
/// Converts the affine map of a georeference to positions of samples along x and y.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

#include "files/input_file.hpp"
#include "geometry/point.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/surfaces/held_heights.hpp"

namespace ligne {

/// place = at + (column - pixel.x) * per_column + (row - pixel.y) * per_row. Pixel (0, 0) reaches from (0, 0) to (1,
/// 1), and its sample lies at (sample_at, sample_at).
struct RasterTransform {
  Point2 pixel{0, 0}, at{0, 0};
  Point2 per_column{1, 0}, per_row{0, -1};
  double sample_at = 0.5;

  bool is_finite() const;
};

/// Ascending positions of the samples, and the storage order of the samples in the file's rows.
struct RasterPlacement {
  std::vector<double> x, y;
  SampleOrder order;
  double turned_degrees = 0;  ///< from the axes of the ground to those of the raster, unless they are parallel
  bool sheared = false;       ///< columns and rows are not perpendicular
};

/// Rows and columns that are parallel to x and y, in either direction and in either order, get the positions of the
/// transform. For others, positions are lengths along rows and columns, and the middle sample keeps its place. Nothing
/// if the transform maps all samples to one line.
std::optional<RasterPlacement> place_raster(const RasterTransform& transform, std::size_t columns, std::size_t rows);

/// Positions in a file without a georeference: columns are counted from the left, rows from the last one.
RasterPlacement count_raster(std::size_t columns, std::size_t rows);

/// Warns if a raster is not parallel to x and y.
void warn_of_turned_raster(const RasterPlacement& placement, Warnings& warnings);

/// The transform in the world file beside a picture: NAME.tfw, NAME.wld or NAME with "w" at its end. It holds six
/// numbers for the centres of pixels. Nothing if there is no such file. Adds the file to `opened`. Warns of a file in
/// another form.
std::optional<RasterTransform> read_world_file(const std::filesystem::path& picture, InputFiles& opened, Warnings& warnings);

}  // namespace ligne
