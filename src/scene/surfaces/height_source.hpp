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
  same,     ///< one unit in x, y and, as far as is known, z
  degrees,  ///< longitude and latitude; heights are in metres
};

/// Heights over the positions x[i], y[j], given row by row, so that a large grid need not be held as a whole.
class HeightSource {
 public:
  virtual ~HeightSource() = default;

  /// Sample positions in model units, ascending, two or more each.
  const std::vector<double>& x() const { return x_; }
  const std::vector<double>& y() const { return y_; }

  /// z[i] becomes the height at (x[i], y[j]), NaN where there is none; z.size() == x().size(). Any order of rows; from
  /// several threads at a time.
  virtual void read_row(std::size_t j, std::span<double> z) const = 0;

  /// A function that gives heights between the positions too; null for most grids.
  virtual std::shared_ptr<const HeightFunction> function() const { return nullptr; }

  /// As the file says or lets see.
  GroundUnit unit() const { return unit_; }
  void set_unit(GroundUnit unit) { unit_ = unit; }

  /// So many rows and columns of the file one sample stands for.
  std::size_t thinned_by() const { return thinned_by_; }
  void set_thinned_by(std::size_t step) { thinned_by_ = step; }

 protected:
  HeightSource(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {}

 private:
  std::vector<double> x_, y_;
  GroundUnit unit_ = GroundUnit::unknown;
  std::size_t thinned_by_ = 1;
};

/// Heights of a formula in x and y (also r and theta, the polar coordinates; pi, e). A place where it is not a finite number
/// is a hole. Throws InputError that names the column of a mistake: "formula:COLUMN: cause".
std::unique_ptr<HeightSource> formula_heights(const std::string& formula, std::vector<double> x, std::vector<double> y);

/// Grids of more samples are thinned: a page has fewer places than this (4096 x 4096).
inline constexpr std::size_t kMostGridSamples = std::size_t{1} << 24;

/// How the numbers of a table are understood.
enum class TableLayout : std::uint8_t {
  automatic,
  matrix,   ///< all numbers are heights
  frame,    ///< the first row and the first column are positions: gnuplot's "nonuniform matrix"
  series,   ///< the first column is positions, all other numbers are heights
  columns,  ///< columns of x, y and z
};

/// How files of grids and points are read.
struct GridChoice {
  std::optional<unsigned> columns;  ///< of the grid on which scattered points are sampled (scattered_points.hpp)
  std::optional<unsigned> every{};  ///< rows and columns that have to stay: one of so many
  bool may_thin = false;            ///< of more than kMostGridSamples samples some rows and columns are left out
  TableLayout layout = TableLayout::automatic;
  std::optional<unsigned> data_set{};        ///< of a text with several, from 0; or of the arrays of a file
  std::vector<std::string> using_columns{};  ///< names, or numbers from 1, of the columns of x, y and z; or of z alone
  std::optional<unsigned> band{};  ///< of a raster, counted from 1; nothing: the first, with a warning where there are more
};

/// Heights of a grid file: a CSV or TSV matrix, lines of "x y z", ESRI ASCII grid, PGM or PNG of 8 or 16 bits. Told apart by
/// content; "-" is standard input. Grids are thinned (thinned_heights.hpp) where the choice allows it. NODATA and NaN are
/// holes; rows of pictures run from north (the largest y) to south. Throws InputError("FILE[:LINE]: cause"). Adds the file,
/// and others that were read with it, to `opened`.
std::unique_ptr<HeightSource> read_grid(const std::filesystem::path& file, Warnings& warnings, InputFiles* opened = nullptr,
                                        const GridChoice& choice = {});

}  // namespace ligne
