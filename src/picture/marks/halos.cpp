#include "picture/marks/halos.hpp"

#include <array>

namespace ligne {
namespace {

// Adjustable, in heights of capitals.
constexpr double kHalo = 0.25;    ///< around letters; as wide as two stems
constexpr double kGround = 0.15;  ///< around the box of a label of single strokes

Fill ground_below(const TextItem& label) {
  constexpr std::array<double, 3> kWhite{1, 1, 1};
  TextBox box = text_box(label, text_extent(label.text, label.height_mm, TextStyle::stroke));
  box.half += Point2{kGround, kGround} * label.height_mm;
  const auto corners = box.corners();
  return {{std::vector<Point2>(corners.begin(), corners.end())}, kWhite};
}

}  // namespace

void set_off_from_fills(Drawing& drawing, std::span<TextItem> labels, TextStyle style) {
  if (drawing.fills.empty()) return;
  for (TextItem& label : labels) {
    if (style == TextStyle::font) {
      label.halo_mm = kHalo * label.height_mm;
    } else {
      drawing.fills.push_back(ground_below(label));
    }
  }
}

}  // namespace ligne
