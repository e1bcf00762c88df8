#pragma once
/// Points of surfaces at a grid of two parameters.

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "scene/surfaces/formula/height_function.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {

/// Largest rounding error of a formula's value, relative to the largest coordinate: 2^13 units of 2^-53. That exceeds
/// the number of operations of any formula that is typed, and is a thousandth of the step of the page's lattice.
inline constexpr double kFormulaRounding = 0x1p-40;

/// Samples of one surface, row by row; column i and row j is points[j * columns + i]. A column is a curve of constant x
/// (or u), a row one of constant y (or v). A sample with NaN in any coordinate is a hole.
struct SurfacePoints {
  std::string name{};
  std::size_t columns = 0, rows = 0;
  std::vector<Point3> points{};
  /// Number of samples between curves, as in HorizonOptions, along columns and along rows; 0: no curves. The last
  /// column and row always carry a curve.
  std::size_t x_stride = 1, y_stride = 1;
  /// Cells that are left out regardless of their corners, row by row, columns - 1 per row; may be empty.
  std::vector<char> left_out{};
  bool parametric = false;                           ///< points may coincide: where the surface closes, and at poles
  bool from_formula = false;                         ///< coordinates have the error of a formula (kFormulaRounding)
  std::shared_ptr<const HeightFunction> function{};  ///< z = f(x, y), if given as a formula
  GroundUnit unit = GroundUnit::unknown;
};

/// Whether there is a curve at the i-th of `count` columns or rows.
inline bool is_curve_at(std::size_t i, std::size_t count, std::size_t stride) {
  return stride != 0 && (i % stride == 0 || i + 1 == count);
}

/// Largest number of samples in the meshes of one drawing. At about half a kilobyte each, from the scene to the
/// strokes, they take 2 GB.
inline constexpr std::size_t kMostMeshSamples = 4'000'000;

/// Adds the samples to `taken`. Throws InputError("NAME: ...") if there are more than kMostMeshSamples.
void take_samples(std::size_t& taken, std::size_t columns, std::size_t rows, const std::string& name);

/// The heights of samples at a grid, which must outlive the result.
std::unique_ptr<HeightSource> heights_of(const SurfacePoints& surface);

/// All samples of a height source. The caller sets strides and names.
SurfacePoints points_of(const HeightSource& heights);

/// The surface of x, y and z as formulas in u and v. Throws InputError("formula of x:COLUMN: cause").
SurfacePoints parametric_points(const std::array<std::string, 3>& formulas, const std::vector<double>& u,
                                const std::vector<double>& v);

/// A number as typed in an option: a constant formula, such as "2*pi". Throws InputError.
double constant_of(const std::string& formula);

}  // namespace ligne
