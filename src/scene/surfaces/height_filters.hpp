#pragma once
/// Height sources made of others.

#include <limits>
#include <memory>
#include <string>

#include "scene/surfaces/height_source.hpp"

namespace ligne {

/// All heights read once and held.
std::unique_ptr<HeightSource> held(const HeightSource& heights);

/// The same with x and y in each other's place.
std::unique_ptr<HeightSource> transposed(const HeightSource& heights);

/// log10 of the heights; what is not above zero is a hole.
std::unique_ptr<HeightSource> log_heights(std::unique_ptr<HeightSource> heights);

/// For a ridgeline plot, seen from (0, -1, 1): x from 0 to 1, `rows_height` in y; heights from 0, so that the range from
/// `low` to `high` is as large as the distance of `rows` neighbouring rows.
std::unique_ptr<HeightSource> ridgeline_heights(std::unique_ptr<HeightSource> heights, double low, double high, double rows,
                                                double rows_height);

/// A part of an axis, both ends included.
struct AxisWindow {
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
};

/// The samples whose positions lie in the window. Throws InputError(name, ...) when that leaves fewer than two columns or
/// rows.
std::unique_ptr<HeightSource> window_heights(std::unique_ptr<HeightSource> heights, AxisWindow x, AxisWindow y,
                                             const std::string& name);

}  // namespace ligne
