#pragma once
/// Height sources that change other ones.

#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "geometry/point.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {

/// Reads all heights once and keeps them in memory.
std::unique_ptr<HeightSource> held(const HeightSource& heights);

/// Exchanges x and y.
std::unique_ptr<HeightSource> transposed(const HeightSource& heights);

/// Gives heights that differ by the rounding of their formula alone (kFormulaRounding) one height: their noise would be
/// drawn as high as any other surface. Returns whether it did.
bool level_noise(std::unique_ptr<HeightSource>& heights);

/// log10 of the heights; heights not above zero become holes.
std::unique_ptr<HeightSource> log_heights(std::unique_ptr<HeightSource> heights);

/// The heights above a level; the others become holes.
std::unique_ptr<HeightSource> land_heights(std::unique_ptr<HeightSource> heights, double level);

/// log10 of the positions of the chosen axes; positions not above zero are dropped. Throws InputError(name, ...) if
/// fewer than two columns or rows remain.
std::unique_ptr<HeightSource> log_ground(std::unique_ptr<HeightSource> heights, bool log_x, bool log_y,
                                         const std::string& name);

/// Multiplies the positions by these factors, which must be above zero.
std::unique_ptr<HeightSource> scaled_ground(std::unique_ptr<HeightSource> heights, double factor_x, double factor_y);

/// Cells with a side along which heights change by more than `most` per unit of the ground, row by row, one less per
/// row than samples. Positions times `units` are in the unit of the heights. If `units` > 1, positions are degrees, and
/// those of x shrink with the cosine of y.
std::vector<char> steep_cells(const HeightSource& heights, double most, double units);

/// Maps a point along each axis separately, to (point - origin) * factor.
struct AxesScaling {
  Point3 origin{0, 0, 0}, factor{1, 1, 1};
};

/// The scaling of a ridgeline plot, seen from (0, -1, 1): x from 0 to 1, y from 0 to `rows_height`. Heights start at 0
/// and the range from `low` to `high` becomes `rows` times the mean distance of neighbouring rows.
AxesScaling ridgeline_scaling(const HeightSource& heights, double low, double high, double rows, double rows_height);

/// A scaled surface.
std::unique_ptr<HeightSource> scaled_heights(std::unique_ptr<HeightSource> heights, const AxesScaling& scaling);

/// A part of an axis, both ends included.
struct AxisWindow {
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
};

/// The samples whose positions lie in the window. Throws InputError(name, ...) if fewer than two columns or rows
/// remain.
std::unique_ptr<HeightSource> window_heights(std::unique_ptr<HeightSource> heights, AxisWindow x, AxisWindow y,
                                             const std::string& name);

/// The step n such that every nth row and column is read, and the last of each; 1 if the grid is read in full.
std::size_t thinning_step(std::size_t columns, std::size_t rows, const GridChoice& choice);

/// Indices of the `n` rows or columns that are kept.
std::vector<std::size_t> kept_places(std::size_t n, std::size_t step);

/// Warns that a grid is thinned.
void warn_of_thinning(std::size_t columns, std::size_t rows, std::size_t step, Warnings& warnings);

/// The heights, thinned if there are too many. Heights of a function stay unchanged.
std::unique_ptr<HeightSource> thinned_heights(std::unique_ptr<HeightSource> heights, const GridChoice& choice,
                                              Warnings& warnings);

}  // namespace ligne
