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

/// The value of a grid where it has no height.
inline constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();

/// Lines of x, y and z as they stand in the file.
struct PointRows {
  std::vector<double> values;             ///< x, y, z of every line
  std::vector<std::size_t> lines;         ///< their numbers
  std::vector<std::size_t> block_begins;  ///< the first row of every block of lines; blank lines stand between the blocks
};

/// Tells the format by content and reads. `name` stands in error messages. What only GDAL reads needs the file itself and is
/// refused when `file` is empty; files beside it that were read too are added to `opened`.
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

/// Rows of a table as heights, by number from 0; `columns` are used, all in order where it is empty.
std::unique_ptr<HeightSource> matrix_of_rows(const Table& table, RowRange rows, const std::vector<std::size_t>& columns,
                                             const std::string& name, Warnings& warnings);

/// Rows of a table whose first row and first column, or the names of whose columns, are positions; null where these neither
/// ascend nor descend.
std::unique_ptr<HeightSource> frame_of_rows(const Table& table, RowRange rows, const std::string& name, Warnings& warnings);
std::unique_ptr<HeightSource> frame_of_names(const Table& table, RowRange rows, const std::vector<double>& positions,
                                             const std::string& name, Warnings& warnings);
/// gnuplot's "nonuniform matrix": the corner holds the number of the other columns.
bool is_counted_frame(const Table& table, RowRange rows);

/// How the first column of a matrix can be understood.
enum class FirstColumn : std::uint8_t {
  heights,
  positions,  ///< it alone has even steps, and it differs from its neighbour far more than the others do from theirs
  doubtful,   ///< it alone has even steps, and may be positions or heights
};

/// `values` are rows of `columns` numbers.
FirstColumn kind_of_first_column(std::span<const double> values, std::size_t columns);
/// Whether the numbers of a column, eight or more, ascend or descend by equal steps, up to the rounding of their digits.
bool has_even_steps(std::span<const double> values, std::size_t columns, std::size_t column);
/// Rows of `columns` numbers, of which the first is y and the others are heights over x = 0, 1, 2 ...; null where the first
/// ones neither ascend nor descend.
std::unique_ptr<HeightSource> series_of_rows(std::span<const double> values, std::size_t columns, const std::string& name,
                                             Warnings& warnings);

/// Heights row by row over positions that ascend or descend. Throws InputError for others.
std::unique_ptr<HeightSource> heights_over(std::vector<double> x, std::vector<double> y, std::vector<double> z,
                                           const std::string& name);

/// Named arrays: one of two dimensions with its positions, or three of one. See docs/data-formats.md.
GridSurface surface_of_arrays(std::vector<DataArray> arrays, const std::string& name, const GridChoice& choice,
                              Warnings& warnings);

/// Grids of Surfer, as text and in two binary forms.
bool is_surfer_grid(std::string_view bytes);
std::unique_ptr<HeightSource> read_surfer_grid(std::span<const std::byte> bytes, const std::string& name,
                                               Warnings& warnings);

/// The scan lines of a mesh: blocks of equally many points.
SurfacePoints mesh_of_blocks(const PointRows& rows, const std::string& name);
/// Blocks are the corners of polygons of a solid, whose corners stand in several of them.
bool are_polygons(const PointRows& rows);
/// Blocks of equally many points, two or more.
bool are_even_blocks(const PointRows& rows);

/// A text that begins with a key of the header of an ESRI ASCII grid.
bool is_esri_grid(std::string_view text);
std::unique_ptr<HeightSource> read_esri_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings);

/// Netpbm's grey maps, P2 and P5. Those of pictures that are thinned are so while they are read.
std::unique_ptr<HeightSource> read_pgm_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                            const GridChoice& choice);

/// PNG of one channel, 8 or 16 bits.
std::unique_ptr<HeightSource> read_png_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                            const GridChoice& choice);

/// A tile of SRTM heights, "N47E008.hgt", which its name alone tells from other bytes.
bool is_hgt_name(std::string_view name);
std::unique_ptr<HeightSource> read_hgt_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings);

/// A TIFF whose numbers or packing libtiff does not read.
class UnreadTiff : public InputError {
 public:
  using InputError::InputError;
};

/// One band of a TIFF or GeoTIFF, by libtiff. A world file beside `file` is read where the TIFF says no positions, and is
/// added to `opened`. Throws UnreadTiff for what GDAL may read.
std::unique_ptr<HeightSource> read_tiff_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                             const GridChoice& choice = {}, const std::filesystem::path& file = {},
                                             InputFiles* opened = nullptr);
/// Whether libtiff, and GDAL, are in the build.
bool reads_tiff();
bool reads_by_gdal();

/// One band of what GDAL reads (GeoTIFF and many more). Without GDAL in the build an InputError says that it is needed. Adds
/// what GDAL reads beside the file to `opened`.
std::unique_ptr<HeightSource> read_gdal_grid(const std::filesystem::path& file, const std::string& name, Warnings& warnings,
                                             const GridChoice& choice, InputFiles& opened);

/// The likely unit of the positions of a grid of terrain whose file does not say it.
GroundUnit likely_unit(const HeightSource& heights);

/// Heights over the positions of the file. Blocks are of one x or of one y each.
std::unique_ptr<HeightSource> grid_of_points(PointRows rows, const std::string& name);
/// Whether it takes the blocks, or throws InputError.
bool is_grid_of_blocks(const PointRows& rows, const std::string& name);
/// Makes blocks where no blank line does: true, and `rows` has them, when each x or y comes with the same positions of the
/// other.
bool find_blocks(PointRows& rows);

/// Files without a header that names it say -9999, -32768 or -99999 where there is no height. Of each `step` values the last
/// one is a height; those that are such a number, and far below all others, become NaN.
void leave_out_signs_of_nothing(std::vector<double>& values, std::size_t step, Warnings& warnings);

/// Points in any order: a grid with holes where they are enough of one, else scattered points (scattered_points.hpp).
std::unique_ptr<HeightSource> surface_of_rows(const PointRows& rows, const GridChoice& choice, const std::string& name,
                                              Warnings& warnings);
/// Whether most of the places of x and y are different, as those of points are and heights in three columns need not be.
bool are_places(const PointRows& rows);

/// The height that a word of a text stands for: a number, or NaN for a sign of no value (is_missing); nothing for other
/// words.
std::optional<double> height_in(std::string_view word);

}  // namespace ligne
