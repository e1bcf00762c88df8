#pragma once
/// Line charts as SVG. Ticks, texts, layers and the writer are those of any picture.

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace ligne::studies {

struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;
};

/// Linear axes begin at zero. With `logarithmic` all values must be positive.
struct Chart {
  std::string title, x_label, y_label;
  std::vector<Curve> curves{};
  bool logarithmic = false;
};

/// One SVG file with the charts one below the other.
std::string charts_svg(std::span<const Chart> charts);

}  // namespace ligne::studies
