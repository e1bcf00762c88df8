#pragma once
/// The plates of [Boulle1980] made again: pages with drawings, their names and their counts.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/drawing.hpp"

namespace ligne::studies {

/// One page, A4, upright.
struct Plate {
  std::string figure;   ///< of the source, "2.2"
  std::string title;    ///< what it shows
  std::string caption;  ///< where our scene or drawing differs from the source
  Drawing drawing{};    ///< page mm, with all texts
};

/// All plates, in the order of the source.
std::vector<Plate> make_plates();

/// The plates as the pages of a PDF.
std::string plates_pdf(std::span<const Plate> plates);

}  // namespace ligne::studies
