#pragma once
/// Height sources made of others.

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {

/// All heights read once and held.
std::unique_ptr<HeightSource> held(const HeightSource& heights);

/// The heights with x and y in each other's place.
std::unique_ptr<HeightSource> transposed(const HeightSource& heights);

/// log10 of the heights; what is not above zero is a hole.
std::unique_ptr<HeightSource> log_heights(std::unique_ptr<HeightSource> heights);

/// The heights above a level; the others are holes.
std::unique_ptr<HeightSource> land_heights(std::unique_ptr<HeightSource> heights, double level);

/// log10 of the positions of the axes that are named; those not above zero are left out. Throws InputError(name, ...) when
/// that leaves fewer than two columns or rows.
std::unique_ptr<HeightSource> log_ground(std::unique_ptr<HeightSource> heights, bool log_x, bool log_y,
                                         const std::string& name);

/// The heights over positions that are multiplied by these factors, above zero.
std::unique_ptr<HeightSource> scaled_ground(std::unique_ptr<HeightSource> heights, double factor_x, double factor_y);

/// Cells with a side along which heights change by more than `most` for a unit of the ground, row by row, one less in a row
/// than samples. Positions times `units` are in the unit of the heights; with more than one they are degrees, and those of x
/// shrink with the cosine of y.
std::vector<char> steep_cells(const HeightSource& heights, double most, double units);

/// A point is moved along each axis on its own: to (point - origin) * factor.
struct AxesScaling {
  Point3 origin{0, 0, 0}, factor{1, 1, 1};
};

/// The scaling of a ridgeline plot, seen from (0, -1, 1): x from 0 to 1, y from 0 to `rows_height`; heights from 0, so that
/// the range from `low` to `high` is as large as the mean distance of neighbouring rows times `rows`.
AxesScaling ridgeline_scaling(const HeightSource& heights, double low, double high, double rows, double rows_height);

/// A scaled surface.
std::unique_ptr<HeightSource> scaled_heights(std::unique_ptr<HeightSource> heights, const AxesScaling& scaling);

/// A part of an axis, both ends included.
struct AxisWindow {
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
};

/// The samples whose positions lie in the window. Throws InputError(name, ...) when that leaves fewer than two columns or
/// rows.
std::unique_ptr<HeightSource> window_heights(std::unique_ptr<HeightSource> heights, AxisWindow x, AxisWindow y,
                                             const std::string& name);

}  // namespace ligne
