#pragma once
/// Height sources made of others.

#include <limits>
#include <memory>
#include <string>

#include "scene/height_source.hpp"

namespace ligne {

/// log10 of the heights; what is not above zero is a hole.
std::unique_ptr<HeightSource> log_heights(std::unique_ptr<HeightSource> heights);

/// A part of an axis, both ends included.
struct AxisWindow {
  double from = -std::numeric_limits<double>::infinity(), to = std::numeric_limits<double>::infinity();
};

/// The samples whose positions lie in the window. Throws InputError(name, ...) when that leaves fewer than two columns or rows.
std::unique_ptr<HeightSource> window_heights(std::unique_ptr<HeightSource> heights, AxisWindow x, AxisWindow y, const std::string& name);

}  // namespace ligne
