#pragma once
/// The readers of grid files, one per format. All of them throw InputError("NAME[:LINE]: cause").

#include <cstddef>
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
#include "scene/surfaces/height_source.hpp"

namespace ligne {

/// What stands where a grid has no height.
inline constexpr double kNoHeight = std::numeric_limits<double>::quiet_NaN();

/// Tells the format by content and reads. `name` stands in error messages. What only GDAL reads needs the file itself and is
/// refused when `file` is empty; files beside it that were read too are added to `opened`.
std::unique_ptr<HeightSource> read_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                        const std::filesystem::path& file = {}, InputFiles* opened = nullptr,
                                        const GridChoice& choice = {});

/// A matrix of heights: a row a line, columns separated by commas, semicolons, tabs or blanks; or lines of x, y and z.
std::unique_ptr<HeightSource> read_text_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings,
                                             const GridChoice& choice = {});

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

/// TIFF and GeoTIFF of one band, by libtiff; whether it is in the build.
std::unique_ptr<HeightSource> read_tiff_grid(std::span<const std::byte> bytes, const std::string& name, Warnings& warnings);
bool reads_tiff();

/// What GDAL reads (GeoTIFF and many more): the first band. Without GDAL in the build an InputError says that it is needed.
/// Adds what GDAL reads beside the file to `opened`.
std::unique_ptr<HeightSource> read_gdal_grid(const std::filesystem::path& file, const std::string& name, InputFiles& opened);

/// Lines of x, y and z as they stand in the file.
struct PointRows {
  std::vector<double> values;             ///< x, y, z of every line
  std::vector<std::size_t> lines;         ///< their numbers
  std::vector<std::size_t> block_begins;  ///< the first row of every block of lines; blank lines stand between the blocks
};
/// Heights over the positions of the file. Blocks are of one x or of one y each.
std::unique_ptr<HeightSource> grid_of_points(PointRows rows, const std::string& name);
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

/// What the names of columns say.
struct NamedColumns {
  std::optional<std::size_t> x, y, z;
};
NamedColumns named_columns(const std::vector<std::string>& names);

/// The height that a word of a text stands for: a number, or NaN for "nan", "na", "inf" and "?"; nothing for other words.
std::optional<double> height_in(std::string_view word);

}  // namespace ligne
