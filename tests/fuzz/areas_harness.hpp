#pragma once
/// Areas that hide and clip each other, made of bytes, for the fuzzers and the replay of their corpus.

#include "support/standard.hpp"

namespace ligne {

/// The first byte chooses between rectangles that abut, polygons with common corners, and any contours at all. Of the first
/// two the plotted borders must be those of a sampled picture; of the last ones they must be lines at all.
void hide_areas_as_fuzzer(std::span<const std::byte> bytes);

}  // namespace ligne
