#pragma once
/// Points of surfaces over a grid of two parameters.

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "scene/surfaces/formula/height_function.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {

/// Roundings that a formula's value may carry, relative to the largest coordinate: 2^13 units of 2^-53. That is many more
/// than the operations of any formula that is written down, and a thousandth of the step of the page's lattice.
inline constexpr double kFormulaRounding = 0x1p-40;

/// Samples of one surface, row by row: that of column i and row j is points[j * columns + i]. A column is a curve of
/// constant x (or u), a row one of constant y (or v). NaN in any coordinate is a hole.
struct SurfacePoints {
  std::string name;
  std::size_t columns = 0, rows = 0;
  std::vector<Point3> points;
  /// Every how many samples there is a curve, as in HorizonOptions: at columns, at rows; 0 for none; the last one in any
  /// case.
  std::size_t x_stride = 1, y_stride = 1;
  /// Cells that are left out whatever their corners, row by row, columns - 1 in a row; may be empty.
  std::vector<char> left_out;
  bool parametric = false;                         ///< points may come together: where the surface closes, and at poles
  bool from_formula = false;                       ///< coordinates carry the roundings of a formula (kFormulaRounding)
  std::shared_ptr<const HeightFunction> function;  ///< of z = f(x, y) as a formula
  GroundUnit unit = GroundUnit::unknown;
};

/// Whether there is a curve at the i-th of `count` columns or rows.
inline bool is_curve_at(std::size_t i, std::size_t count, std::size_t stride) {
  return stride != 0 && (i % stride == 0 || i + 1 == count);
}

/// The most samples that the meshes of one drawing may have in all: with about half a kilobyte for each from the scene to
/// the strokes, 2 GB.
inline constexpr std::size_t kMostMeshSamples = 4'000'000;

/// Throws InputError("NAME: ...") when `taken` samples and these are more than kMostMeshSamples; adds them otherwise.
void take_samples(std::size_t& taken, std::size_t columns, std::size_t rows, const std::string& name);

/// The heights of samples over a grid, which must outlive them.
std::unique_ptr<HeightSource> heights_of(const SurfacePoints& surface);

/// All samples of heights. Strides and names are left to the caller.
SurfacePoints points_of(const HeightSource& heights);

/// The surface of x, y and z as formulas in u and v. Throws InputError("formula of x:COLUMN: cause").
SurfacePoints parametric_points(const std::array<std::string, 3>& formulas, const std::vector<double>& u,
                                const std::vector<double>& v);

/// A number as typed in an option: a constant formula, such as "2*pi". Throws InputError.
double constant_of(const std::string& formula);

}  // namespace ligne
