#pragma once
/// Surfaces z = f(x, y): heights over a grid of sample positions.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "files/input_file.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/surfaces/formula/height_function.hpp"

namespace ligne {

/// The unit of positions.
enum class GroundUnit : std::uint8_t {
  unknown,
  same,     ///< one unit in x, y and, as far as known, z
  degrees,  ///< longitude and latitude; heights are in metres
};

/// Heights at the positions x[i], y[j], given row by row, so that a large grid need not be in memory as a whole.
class HeightSource {
 public:
  virtual ~HeightSource() = default;

  /// Sample positions in model units, ascending, two or more each.
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }

  /// Sets z[i] to the height at (x[i], y[j]), or to NaN if there is none; z.size() == x().size(). Rows may be read in
  /// any order and by several threads at a time.
  virtual void read_row(std::size_t j, std::span<double> z) const = 0;

  /// A function that also gives heights between the positions; null for most grids.
  virtual std::shared_ptr<const HeightFunction> function() const { return nullptr; }

  /// The unit as the file states it or as it follows from its content.
  GroundUnit unit() const { return unit_; }
  void set_unit(GroundUnit unit) { unit_ = unit; }

  /// Number of rows, and of columns, of the file per sample.
  std::size_t thinned_by() const { return thinned_by_; }
  void set_thinned_by(std::size_t step) { thinned_by_ = step; }

 protected:
  HeightSource(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {}

 private:
  std::vector<double> x_, y_;
  GroundUnit unit_ = GroundUnit::unknown;
  std::size_t thinned_by_ = 1;
};

/// Heights of a formula in x and y (also r and theta, the polar coordinates; pi, e). Places where the result is not a
/// finite number are holes. Throws InputError with the column of the mistake: "formula:COLUMN: cause".
std::unique_ptr<HeightSource> formula_heights(const std::string& formula, std::vector<double> x, std::vector<double> y);

/// Largest number of samples before a grid is thinned: a page resolves fewer places (4096 x 4096).
inline constexpr std::size_t kMostGridSamples = std::size_t{1} << 24;

/// Meaning of the numbers of a table.
enum class TableLayout : std::uint8_t {
  automatic,
  matrix,   ///< all numbers are heights
  frame,    ///< the first row and the first column are positions: gnuplot's "nonuniform matrix"
  series,   ///< the first column is positions, all other numbers are heights
  columns,  ///< columns of x, y and z
};

/// How files of grids and points are read.
struct GridChoice {
  std::optional<unsigned> columns;  ///< of the grid at which scattered points are sampled (scattered_points.hpp)
  std::optional<unsigned> every{};  ///< one row and column in this many must stay when thinning
  bool may_thin = false;            ///< whether rows and columns of a grid above kMostGridSamples samples are dropped
  TableLayout layout = TableLayout::automatic;
  std::optional<unsigned> data_set{};        ///< number of the data set of a text, or of the array of a file, from 0
  std::vector<std::string> using_columns{};  ///< names, or numbers from 1, of the columns of x, y and z; or of z alone
  std::optional<unsigned> band{};            ///< of a raster, from 1; nothing: the first, with a warning for others
};

/// Reads the heights of a grid file: a CSV or TSV matrix, lines of "x y z", ESRI ASCII grid, PGM or PNG of 8 or 16
/// bits. The content decides the format; "-" is standard input. Grids are thinned (height_filters.hpp) if the choice
/// allows it. NODATA and NaN are holes; rows of pictures run from north (the largest y) to south. Throws
/// InputError("FILE[:LINE]: cause"). Adds the file, and others read with it, to `opened`.
std::unique_ptr<HeightSource> read_grid(const std::filesystem::path& file, Warnings& warnings, InputFiles* opened = nullptr,
                                        const GridChoice& choice = {});

}  // namespace ligne
