#pragma once
/// The plates of [Boulle1980] redrawn: pages of captioned drawings with their counts.

#include <span>
#include <string>
#include <vector>

#include "drawing/drawing.hpp"

namespace ligne::studies {

/// One A4 page in portrait format.
struct Plate {
  std::string figure;   ///< number in the source, such as "2.2"
  std::string title;    ///< subject
  std::string caption;  ///< differences from the source in scene or drawing
  Drawing drawing{};    ///< page mm, all texts included
};

/// All plates, in the order of the source.
std::vector<Plate> make_plates();

/// The plates as the pages of a PDF.
std::string plates_pdf(std::span<const Plate> plates);

}  // namespace ligne::studies
