#pragma once
/// The readers of grid files, one per format. All of them throw InputError("NAME[:LINE]: cause").

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_file.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/surfaces/grids/grid_surfaces.hpp"
#include "scene/surfaces/height_source.hpp"
#include "scene/tables/data_array.hpp"
#include "scene/tables/table.hpp"

namespace ligne {

/// The value for a missing height.
inline constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();

/// Lines of x, y and z in the order of the file.
struct PointRows {
  std::vector<double> values;             ///< x, y, z of each line
  std::vector<std::size_t> lines;         ///< line numbers
  std::vector<std::size_t> block_begins;  ///< first row of each block; blank lines separate blocks
};

/// Recognises the format by content and reads the file. `name` is used in error messages. Formats that only GDAL reads
/// need the path `file`, and are refused if it is empty. Further files that were read are added to `opened`.
std::vector<GridSurface> read_surfaces(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                       const std::filesystem::path& file = {}, InputFiles* opened = nullptr,
                                       const GridChoice& choice = {});
/// Reads a file that holds one surface z = f(x, y); throws InputError for others.
std::unique_ptr<HeightSource> read_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                        const std::filesystem::path& file = {}, InputFiles* opened = nullptr,
                                        const GridChoice& choice = {});

/// The surfaces of a table: matrices, frames of positions, columns of x, y and z (docs/data-formats.md).
std::vector<GridSurface> read_text_surfaces(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                            const GridChoice& choice = {});

/// One data set of a table.
GridSurface surface_of_data_set(const Table& table, RowRange rows, const std::string& name, const GridChoice& choice,
                                Warnings& warnings);

/// Makes heights of rows of a table, numbered from 0. Uses `columns`, or all in their order if it is empty.
std::unique_ptr<HeightSource> matrix_of_rows(const Table& table, RowRange rows, const std::vector<std::size_t>& columns,
                                             const std::string& name, Warnings& warnings);

/// Makes heights of rows whose positions are in the first row and the first column, or in the names of the columns and
/// the first column; null if the positions neither ascend nor descend.
std::unique_ptr<HeightSource> frame_of_rows(const Table& table, RowRange rows, const std::string& name, Warnings& warnings);
std::unique_ptr<HeightSource> frame_of_names(const Table& table, RowRange rows, const std::vector<double>& positions,
                                             const std::string& name, Warnings& warnings);
/// Whether the rows are gnuplot's "nonuniform matrix", whose corner holds the number of the other columns.
bool is_counted_frame(const Table& table, RowRange rows);

/// Possible meanings of the first column of a matrix.
enum class FirstColumn : std::uint8_t {
  heights,
  positions,  ///< only it has even steps, and it differs from its neighbour much more than the others from theirs
  doubtful,   ///< only it has even steps; it may hold positions or heights
};

/// `values` are rows of `columns` numbers.
FirstColumn kind_of_first_column(std::span<const double> values, std::size_t columns);
/// Whether the numbers of a column, at least eight, ascend or descend by equal steps, within the rounding of their
/// digits.
bool has_even_steps(std::span<const double> values, std::size_t columns, std::size_t column);
/// Makes heights of rows of `columns` numbers: y, then heights at x = 0, 1, 2 ...; null if y neither ascends nor
/// descends.
std::unique_ptr<HeightSource> series_of_rows(std::span<const double> values, std::size_t columns, const std::string& name,
                                             Warnings& warnings);

/// 1 if the numbers ascend, -1 if they descend, 0 otherwise.
int direction_of(const std::vector<double>& at);

/// Makes heights given row by row at ascending or descending positions. Throws InputError for other positions.
std::unique_ptr<HeightSource> heights_over(std::vector<double> x, std::vector<double> y, std::vector<double> z,
                                           const std::string& name);

/// Makes a surface of named arrays: of a two-dimensional one with its positions, or of three one-dimensional ones. See
/// docs/data-formats.md.
GridSurface surface_of_arrays(std::vector<DataArray> arrays, const std::string& name, const GridChoice& choice,
                              Warnings& warnings);

/// Grids of Surfer, as text and in two binary formats.
bool is_surfer_grid(std::string_view bytes);
std::unique_ptr<HeightSource> read_surfer_grid(std::span<const std::byte> bytes, const std::string& name,
                                               Warnings& warnings);

/// Makes a mesh of scan lines, which are blocks of equally many points.
SurfacePoints mesh_of_blocks(const PointRows& rows, const std::string& name);
/// Whether the blocks are polygons of a solid, whose corners occur in several blocks.
bool are_polygons(const PointRows& rows);
/// Whether all blocks have equally many points, at least two.
bool are_even_blocks(const PointRows& rows);

/// Whether a text begins with a key of the header of an ESRI ASCII grid.
bool is_esri_grid(std::string_view text);
std::unique_ptr<HeightSource> read_esri_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings);

/// Netpbm's grey maps, P2 and P5. Thinned pictures are thinned while they are read.
std::unique_ptr<HeightSource> read_pgm_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                            const GridChoice& choice);

/// PNG of one channel, 8 or 16 bits.
std::unique_ptr<HeightSource> read_png_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                            const GridChoice& choice);

/// A tile of SRTM heights, recognised only by its name, such as "N47E008.hgt".
bool is_hgt_name(std::string_view name);
std::unique_ptr<HeightSource> read_hgt_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings);

/// A TIFF whose number type or compression libtiff does not read.
class UnreadTiff : public InputError {
 public:
  using InputError::InputError;
};

/// Reads one band of a TIFF or GeoTIFF with libtiff. If the TIFF has no positions, a world file beside `file` is read,
/// and is added to `opened`. Throws UnreadTiff for files that GDAL may read.
std::unique_ptr<HeightSource> read_tiff_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                             const GridChoice& choice = {}, const std::filesystem::path& file = {},
                                             InputFiles* opened = nullptr);
/// Whether libtiff, and GDAL, are in the build.
bool reads_tiff();
bool reads_by_gdal();

/// Reads one band of a file with GDAL (GeoTIFF and many more). Throws an InputError if the build is without GDAL. Adds
/// the files that GDAL reads beside it to `opened`.
std::unique_ptr<HeightSource> read_gdal_grid(const std::filesystem::path& file, const std::string& name, Warnings& warnings,
                                             const GridChoice& choice, InputFiles& opened);

/// The likely unit of the positions of a terrain grid whose file does not define it.
GroundUnit likely_unit(const HeightSource& heights);

/// Makes heights at the positions of the file. All points of a block have the same x, or the same y.
std::unique_ptr<HeightSource> grid_of_points(PointRows rows, const std::string& name);
/// Whether grid_of_points() accepts the blocks; it throws InputError for others.
bool is_grid_of_blocks(const PointRows& rows, const std::string& name);
/// Finds the blocks of rows without blank lines. Returns true and sets the blocks of `rows` if every x or every y has
/// the same positions of the other coordinate.
bool find_blocks(PointRows& rows);

/// Turns signs for missing heights (-9999, -32768 or -99999) into NaN, in files without a header that defines them. In
/// each group of `step` values the last one is a height. A sign counts only if it is far below all other heights.
void drop_missing_values(std::vector<double>& values, std::size_t step, Warnings& warnings);

/// Makes a surface of points in any order: a grid with holes if they fill enough of one, else scattered points
/// (scattered_points.hpp).
std::unique_ptr<HeightSource> surface_of_rows(const PointRows& rows, const GridChoice& choice, const std::string& name,
                                              Warnings& warnings);
std::unique_ptr<HeightSource> surface_of_cloud(std::vector<Point3> points, const GridChoice& choice, const std::string& name,
                                               Warnings& warnings);
/// Whether most pairs of x and y are different, as for points, but not necessarily for three columns of heights.
bool are_places(const PointRows& rows);

/// The height that a word of a text means: a number, or NaN for a sign of a missing value (is_missing); nothing for
/// other words.
std::optional<double> height_in(std::string_view word);

}  // namespace ligne
