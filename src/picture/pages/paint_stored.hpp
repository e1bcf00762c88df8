#pragma once
/// Paints a stored drawing from its order of painting, without a new study of visibility ([Boulle1980] 1.1.3, 2.5.2.6).

#include <array>
#include <map>
#include <string>

#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "plotting/readers/drawing_reader.hpp"

namespace ligne {

struct StoredPaint {
  FillKind kind = FillKind::none;
  std::map<std::string, std::array<double, 3>, std::less<>> colors{};  ///< by material, in place of the stored ones
};

/// Puts the areas of the order under the lines, which become those that `ligne draw --fill` makes of the same study.
/// Needs ReadDrawing::order, which is used up. Warns of colours for materials that no piece has.
void paint_stored(ReadDrawing& read, const StoredPaint& paint, RunReport& run);

}  // namespace ligne
