#pragma once
/// Grids of more samples than a picture can show: every so many rows and columns of them.

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "scene/model/diagnostics.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {

/// 1 where a grid is read as it is; n where every nth row and column is, and the last of each.
std::size_t thinning_step(std::size_t columns, std::size_t rows, const GridChoice& choice);

/// The rows or columns of `n` that stay.
std::vector<std::size_t> kept_places(std::size_t n, std::size_t step);

/// Warns that a grid is thinned.
void warn_of_thinning(std::size_t columns, std::size_t rows, std::size_t step, Warnings& warnings);

/// The heights, thinned where they are too many. Those of a function stay as they are.
std::unique_ptr<HeightSource> thinned_heights(std::unique_ptr<HeightSource> heights, const GridChoice& choice,
                                              Warnings& warnings);

}  // namespace ligne
