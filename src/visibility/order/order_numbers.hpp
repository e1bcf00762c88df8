#pragma once
/// An order of painting shown as numbers.

#include <cstdint>
#include <span>
#include <vector>

#include "drawing/result_models.hpp"

namespace ligne {

/// A number for each group of pieces of which something is seen, at a point of it that no later piece covers. `group_of`:
/// per piece of the order the number of its group. Points are tried, so a piece of which only a corner is seen may go
/// without.
std::vector<PageNumber> order_numbers(const PaintOrder& order, std::span<const std::uint32_t> group_of);

/// Pieces of one face that follow each other are one group: 1 is painted first.
std::vector<PageNumber> order_numbers(const PaintOrder& order);

}  // namespace ligne
