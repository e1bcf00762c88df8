#pragma once
/// Converts spans to areas, for vector files.

#include <vector>

#include "drawing/result_models.hpp"

namespace ligne {

/// Returns one scan line through the middle of each row of pixels, with one span for each run of pixels of a face behind
/// the same transparent faces.
SpanModel spans_of_pixels(const PixelModel& pixels);

/// Reconstructs areas from spans. Each area belongs to one face behind one list of transparent faces (Region::in_front), and
/// has no holes.
///
/// Overlapping spans of one face and list on successive scan lines form one area. Where an area splits or two areas merge,
/// new areas begin. The sides of an area are straight lines through the ends of its spans, accurate to a micrometre. They
/// are extended to the point where they meet between two scan lines; if they do not meet there, as at horizontal
/// borders, the area ends half way between the lines. So errors are smaller than the distance of two scan lines.
std::vector<Region> areas_of_spans(const SpanModel& spans);

}  // namespace ligne
