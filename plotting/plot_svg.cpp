/// Writes plots as SVG: one layer for every pen, and a preview of the way of the pens.

#include <algorithm>
#include <array>

#include "plotting/plot.hpp"
#include "plotting/writers/writers.hpp"

namespace ligne {
namespace {

/// Number of colours for the strokes of the preview.
constexpr std::size_t kOrderColors = 24;
constexpr double kTravelWidthMm = 0.12;

/// The colour at t, 0 to 1: from blue over green and yellow to red.
std::array<double, 3> order_color(double t) {
  constexpr std::array<std::array<double, 3>, 5> stops{
      {{0.1, 0.2, 0.8}, {0.0, 0.6, 0.7}, {0.1, 0.65, 0.2}, {0.85, 0.65, 0.0}, {0.85, 0.1, 0.1}}};
  const double at = t * (stops.size() - 1);
  const auto i = std::min<std::size_t>(static_cast<std::size_t>(at), stops.size() - 2);
  std::array<double, 3> color{};
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = stops[i][c] + (at - static_cast<double>(i)) * (stops[i + 1][c] - stops[i][c]);
  return color;
}

}  // namespace

Drawing drawing_of(const Plot& plot) {
  Drawing drawing;
  for (const PenLines& pen : plot.pens) {
    const std::string label = layer_label(pen.pen);
    if (pen.looks.empty()) {
      drawing.layers.push_back({label, pen.lines});
      continue;
    }
    // Strokes keep their order, so only consecutive strokes of one look are put together.
    for (std::size_t i = 0; i < pen.lines.size(); ++i) {
      if (i == 0 || pen.look_of[i] != pen.look_of[i - 1]) {
        const StrokeStyle& look = pen.looks[pen.look_of[i]];
        Layer& part = drawing.layers.emplace_back(Layer{label, {}});
        part.color = look.color;
        part.width_mm = look.width_mm;
      }
      drawing.layers.back().lines.add(pen.lines[i]);
    }
  }
  return drawing;
}

std::function<LineStyle(const std::string&)> styles_of(const Plot& plot) {
  std::map<std::string, LineStyle> styles;
  for (const PenLines& pen : plot.pens)
    styles[layer_label(pen.pen)] = {pen.pen.width_mm.value_or(LineStyle{}.width_mm), pen.pen.color, {}};
  return [styles](const std::string& layer) { return styles.at(layer); };
}

std::string write_preview(const Plot& plot, Point2 home, bool returns) {
  std::size_t count = 0;
  double width = kTravelWidthMm;
  for (const PenLines& pen : plot.pens) {
    if (pen.pen.skip) continue;
    count += pen.lines.size();
    width = std::max(width, pen.pen.width_mm.value_or(width));
  }
  Drawing drawing;
  drawing.layers.push_back({"pen-up", {}});
  std::size_t number = 0;
  for (const PenLines& pen : plot.pens) {
    if (pen.pen.skip) continue;
    Point2 at = home;
    for (std::size_t i = 0; i < pen.lines.size(); ++i, ++number) {
      const auto line = pen.lines[i];
      if (line.empty()) continue;
      drawing.layers[0].lines.add(std::array{at, line.front()});
      at = line.back();
      const std::string name = "order-" + std::to_string(number * kOrderColors / count + 1);
      if (drawing.layers.back().name != name) drawing.layers.push_back({name, {}});
      drawing.layers.back().lines.add(line);
    }
    if (returns) drawing.layers[0].lines.add(std::array{at, home});
  }
  PlotOptions options;
  options.page = plot.page;
  options.style = [&](const std::string& layer) {
    LineStyle style{kTravelWidthMm, {0.6, 0.6, 0.6}, {}};
    if (layer == "pen-up") return style;
    style.width_mm = width;
    style.color = order_color((std::stod(layer.substr(6)) - 1) / (kOrderColors - 1));
    return style;
  };
  return write_svg(drawing, options);
}

}  // namespace ligne
