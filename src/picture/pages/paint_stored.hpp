#pragma once
/// Paints a stored drawing in its painting order, without computing visibility again ([Boulle1980] 1.1.3, 2.5.2.6).

#include <array>
#include <map>
#include <string>

#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "plotting/readers/drawing_reader.hpp"

namespace ligne {

struct StoredPaint {
  FillKind kind = FillKind::none;
  std::map<std::string, std::array<double, 3>, std::less<>> colors{};  ///< by material, instead of the stored colours
};

/// Puts the areas of the painting order below the lines, as `ligne draw --fill` would. Requires ReadDrawing::order, and
/// consumes it. Warns of colours for materials that no piece has.
void paint_stored(ReadDrawing& read, const StoredPaint& paint, RunReport& run);

}  // namespace ligne
