#pragma once
/// Thins grids of more samples than a picture can show.

#include <cstddef>
#include <memory>
#include <vector>

#include "scene/model/diagnostics.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne {

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
