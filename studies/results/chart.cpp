#include "studies/results/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "plotting/stroke_text.hpp"
#include "plotting/writers/writers.hpp"
#include "view/axes/ticks.hpp"

namespace ligne::studies {
namespace {

// Lengths of the chart, mm. Taste.
constexpr double kWidth = 180, kHeight = 105, kLeft = 24, kTop = 13, kBottom = 19;
constexpr double kPen = 0.45, kText = 2.3, kTitle = 2.8, kTick = 1.2, kMarker = 0.9, kSample = 11, kLegendLine = 5.2;
constexpr std::size_t kMostTicks = 8;

/// Colours of Okabe and Ito, distinct for colour-blind readers. On grey paper marks and dashes distinguish the curves.
constexpr std::array<std::array<double, 3>, 8> kColors{{{0, 0, 0},
                                                        {0, 0.447, 0.698},
                                                        {0.835, 0.369, 0},
                                                        {0, 0.62, 0.451},
                                                        {0.8, 0.475, 0.655},
                                                        {0.902, 0.624, 0},
                                                        {0.337, 0.706, 0.914},
                                                        {0.45, 0.45, 0.45}}};
const std::array<std::vector<double>, 4> kDashes{{{}, {2.4, 1.2}, {0.5, 1.1}, {3, 1, 0.5, 1}}};
constexpr int kMarkShapes = 4;

struct Axis {
  double from = 0, to = 1;  ///< range of values or of their logarithms
  bool logarithmic = false;
  std::vector<Tick> ticks{};

  double part(double v) const { return (v - from) / (to - from); }
  double part_of(double value) const { return part(logarithmic ? std::log10(value) : value); }
};

Axis axis_for(const std::vector<double>& values, bool logarithmic) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  Axis axis{0, *high > 0 ? *high : 1, logarithmic};
  if (logarithmic) {
    // Adds a margin at both ends; the axis spans at least half a decade.
    const double from = std::log10(*low), to = std::log10(*high), room = std::max((to - from) / 20, (0.5 - (to - from)) / 2);
    axis.from = from - room;
    axis.to = to + room;
    axis.ticks = round_ticks(TickScale::decades, axis.from, axis.to, kMostTicks);
    return axis;
  }
  axis.ticks = round_ticks(TickScale::linear, 0, axis.to, kMostTicks);
  const double step = axis.ticks.size() > 1 ? axis.ticks[1].at - axis.ticks[0].at : axis.to;
  axis.to = step * std::ceil(axis.to / step);
  axis.ticks = round_ticks(TickScale::linear, 0, axis.to, kMostTicks + 1);
  return axis;
}

/// Draws charts into one drawing, one layer per kind of line.
class ChartDrawer {
 public:
  explicit ChartDrawer(Drawing& drawing) : drawing_(drawing) {}

  void draw(const Chart& chart, double down) {
    std::vector<double> xs, ys;
    for (const Curve& c : chart.curves) {
      for (const auto& [x, y] : c.points) {
        xs.push_back(x);
        ys.push_back(y);
      }
    }
    if (xs.empty()) return;
    x_ = axis_for(xs, chart.logarithmic);
    y_ = axis_for(ys, chart.logarithmic);
    double legend = 0;
    for (const Curve& c : chart.curves) legend = std::max(legend, text_extent(c.name, kText, TextStyle::font).width);
    box_ = {{kLeft, down + kTop}, {kWidth - legend - kSample - 8, down + kHeight - kBottom}};
    draw_axes(chart);
    draw_curves(chart);
  }

 private:
  Point2 place(double part_x, double part_y) const {
    return {box_.min.x + box_.width() * part_x, box_.max.y - box_.height() * part_y};
  }
  void line(const std::string& layer, std::vector<Point2> points) {
    auto found = std::ranges::find_if(drawing_.layers, [&](const Layer& l) { return l.name == layer; });
    if (found == drawing_.layers.end()) {
      drawing_.layers.push_back({layer, {}});
      found = drawing_.layers.end() - 1;
    }
    found->lines.add(points);
  }
  void text(const std::string& words, Point2 at, TextAcross across, TextUp up, double height = kText, double turned = 0) {
    drawing_.texts.push_back({words, at, height, across, up, turned});
  }

  void draw_axes(const Chart& chart) {
    for (const Tick& t : x_.ticks) {
      const Point2 foot = place(x_.part(t.at), 0);
      line("grid", {foot, place(x_.part(t.at), 1)});
      line("axes", {foot, foot + Point2{0, kTick}});
      text(t.label, foot + Point2{0, 2 * kTick}, TextAcross::center, TextUp::top);
    }
    for (const Tick& t : y_.ticks) {
      const Point2 foot = place(0, y_.part(t.at));
      line("grid", {foot, place(1, y_.part(t.at))});
      line("axes", {foot, foot - Point2{kTick, 0}});
      text(t.label, foot - Point2{2 * kTick, 0}, TextAcross::right, TextUp::middle);
    }
    line("axes", {place(0, 1), place(0, 0), place(1, 0)});
    text(chart.title, {(box_.min.x + box_.max.x) / 2, box_.min.y - 3}, TextAcross::center, TextUp::base, kTitle);
    text(chart.x_label, {(box_.min.x + box_.max.x) / 2, box_.max.y + 8.5}, TextAcross::center, TextUp::top);
    text(chart.y_label, {4 + kText, (box_.min.y + box_.max.y) / 2}, TextAcross::center, TextUp::base, kText, 90);
  }

  void draw_curves(const Chart& chart) {
    // The legend lists the curves by their last values, highest first.
    std::vector<std::size_t> order(chart.curves.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t i) { return chart.curves[i].points.empty(); });
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
      return chart.curves[a].points.back().second > chart.curves[b].points.back().second;
    });
    Point2 legend{box_.max.x + 4, box_.min.y + 2};
    for (const std::size_t i : order) {
      const std::string layer = "curve-" + std::to_string(i + 1), marks = layer + "-marks";
      std::vector<Point2> points;
      for (const auto& [x, y] : chart.curves[i].points) points.push_back(place(x_.part_of(x), y_.part_of(y)));
      line(layer, points);
      for (const Point2 p : points) mark(marks, i, p);
      line(layer, {legend, legend + Point2{kSample, 0}});
      mark(marks, i, legend + Point2{kSample / 2, 0});
      text(chart.curves[i].name, legend + Point2{kSample + 2, 0}, TextAcross::left, TextUp::middle);
      legend.y += kLegendLine;
    }
  }

  /// Marks: a square, a diamond, and a triangle pointing down or up.
  void mark(const std::string& layer, std::size_t curve, Point2 at) {
    constexpr double r = kMarker;
    const std::array<std::vector<Point2>, kMarkShapes> shapes{
        {{{-r, -r}, {r, -r}, {r, r}, {-r, r}, {-r, -r}},
         {{0, -1.3 * r}, {1.3 * r, 0}, {0, 1.3 * r}, {-1.3 * r, 0}, {0, -1.3 * r}},
         {{-r, r}, {r, r}, {0, -r}, {-r, r}},
         {{-r, -r}, {r, -r}, {0, r}, {-r, -r}}}};
    std::vector<Point2> points;
    for (const Point2 p : shapes[curve % kMarkShapes]) points.push_back(at + p);
    line(layer, std::move(points));
  }

  Drawing& drawing_;
  Axis x_, y_;
  Rect box_{};
};

LineStyle style_of(const std::string& layer) {
  if (layer == "grid") return {0.15, {0.8, 0.8, 0.8}, {}};
  if (!layer.starts_with("curve-")) return {0.25, {0, 0, 0}, {}};
  const std::size_t i = static_cast<std::size_t>(std::stoi(layer.substr(6))) - 1;
  const bool marks = layer.ends_with("-marks");
  return {marks ? kPen / 2 : kPen, kColors[i % kColors.size()],
          marks ? std::vector<double>{} : kDashes[i / kMarkShapes % kDashes.size()]};
}

}  // namespace

std::string charts_svg(std::span<const Chart> charts) {
  Drawing drawing;
  drawing.layers.push_back({"grid", {}});
  drawing.layers.push_back({"axes", {}});
  ChartDrawer drawer(drawing);
  for (std::size_t i = 0; i < charts.size(); ++i) drawer.draw(charts[i], kHeight * static_cast<double>(i));
  PlotOptions options{.page = {kWidth, kHeight * static_cast<double>(std::max<std::size_t>(charts.size(), 1)), 0},
                      .style = style_of};
  return write_svg(drawing, options);
}

}  // namespace ligne::studies
