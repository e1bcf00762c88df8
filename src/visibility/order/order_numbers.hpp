#pragma once
/// A painting order shown as numbers on the page.

#include <cstdint>
#include <span>
#include <vector>

#include "drawing/result_models.hpp"

namespace ligne {

/// One number for each visible group of pieces, at a point of the group that no later piece covers. `group_of`: group number
/// per piece of the order. Only sampled points are tried, so a group with a small visible part may get no number.
std::vector<PageNumber> order_numbers(const PaintOrder& order, std::span<const std::uint32_t> group_of);

/// Successive pieces of one face form a group. Number 1 is painted first.
std::vector<PageNumber> order_numbers(const PaintOrder& order);

}  // namespace ligne
