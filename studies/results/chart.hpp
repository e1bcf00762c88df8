#pragma once
/// Line charts as SVG, drawn as any picture is: ticks, texts, layers and the writer are the program's own.

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace ligne::studies {

struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;
};

/// With linear axes both begin at zero; with `logarithmic` ones all values are positive.
struct Chart {
  std::string title, x_label, y_label;
  std::vector<Curve> curves{};
  bool logarithmic = false;
};

/// One SVG file with the charts below each other.
std::string charts_svg(std::span<const Chart> charts);

}  // namespace ligne::studies
