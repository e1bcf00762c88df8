#include "study/chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ligne::studies {
namespace {

constexpr double kWidth = 680, kHeight = 400, kLeft = 80, kRight = 190, kTop = 50, kBottom = 50;
constexpr const char* kDashes[] = {"none", "8 4", "2 3", "10 3 2 3", "5 2", "1 2", "14 4", "6 2 1 2"};
constexpr const char* kGrid = "stroke=\"#ccc\" fill=\"none\"";
constexpr const char* kFrame = "stroke=\"black\" fill=\"none\"";

std::string number(double v) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", v);
  return buffer;
}

/// A tenth of a unit is enough on the screen, and keeps files small.
std::string place(double v) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.1f", v);
  return buffer;
}

std::string escaped(const std::string& words) {
  std::string out;
  for (const char c : words) out += c == '<' ? "&lt;" : c == '&' ? "&amp;" : std::string(1, c);
  return out;
}

std::string text(double x, double y, const char* anchor, const std::string& words) {
  return "<text x=\"" + place(x) + "\" y=\"" + place(y) + "\" text-anchor=\"" + anchor + "\">" + escaped(words) +
         "</text>\n";
}

std::string line(double x0, double y0, double x1, double y1, const std::string& style) {
  return "<path d=\"M" + place(x0) + " " + place(y0) + "L" + place(x1) + " " + place(y1) + "\" " + style + "/>\n";
}

/// One axis: from a value to its place, and where its ticks stand.
struct Axis {
  double from = 0, to = 1;  ///< values, or their logarithms
  bool logarithmic = false;
  std::vector<double> ticks;

  double part(double v) const { return ((logarithmic ? std::log10(v) : v) - from) / (to - from); }
};

/// A round step, so that there are about five ticks.
double step_for(double range) {
  const double raw = range / 5, power = std::pow(10, std::floor(std::log10(raw)));
  for (const double m : {1.0, 2.0, 5.0}) {
    if (m * power >= raw) return m * power;
  }
  return 10 * power;
}

Axis axis_for(const std::vector<double>& values, bool logarithmic) {
  Axis axis;
  axis.logarithmic = logarithmic;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  if (logarithmic) {
    axis.from = std::floor(std::log10(*low));
    axis.to = std::max(std::ceil(std::log10(*high)), axis.from + 1);
    for (double e = axis.from; e <= axis.to; ++e) axis.ticks.push_back(std::pow(10, e));
    return axis;
  }
  const double largest = *high > 0 ? *high : 1, step = step_for(largest);
  const auto steps = static_cast<int>(std::ceil(largest / step));
  axis.to = steps * step;
  for (int i = 0; i <= steps; ++i) axis.ticks.push_back(i * step);
  return axis;
}

std::string chart_body(const Chart& chart) {
  std::vector<double> xs, ys;
  for (const Curve& c : chart.curves) {
    for (const auto& [x, y] : c.points) {
      xs.push_back(x);
      ys.push_back(y);
    }
  }
  if (xs.empty()) return {};
  const Axis x_axis = axis_for(xs, chart.logarithmic), y_axis = axis_for(ys, chart.logarithmic);
  const auto px = [&](double x) { return kLeft + (kWidth - kLeft - kRight) * x_axis.part(x); };
  const auto py = [&](double y) { return kHeight - kBottom - (kHeight - kTop - kBottom) * y_axis.part(y); };
  const double left = kLeft, right = kWidth - kRight, top = kTop, bottom = kHeight - kBottom;
  std::string out;
  for (const double x : x_axis.ticks)
    out += line(px(x), bottom, px(x), top, kGrid) + text(px(x), bottom + 18, "middle", number(x));
  for (const double y : y_axis.ticks)
    out += line(left, py(y), right, py(y), kGrid) + text(left - 6, py(y) + 4, "end", number(y));
  out += line(left, bottom, right, bottom, kFrame) + line(left, bottom, left, top, kFrame);
  out +=
      text((left + right) / 2, 20, "middle", chart.title) + text((left + right) / 2, kHeight - 12, "middle", chart.x_label);
  out += text(6, kTop - 12, "start", chart.y_label);
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    const Curve& c = chart.curves[i];
    const std::string style = std::string("stroke=\"black\" stroke-width=\"1.5\" fill=\"none\" stroke-dasharray=\"") +
                              kDashes[i % std::size(kDashes)] + "\"";
    out += "<path d=\"";
    for (std::size_t k = 0; k < c.points.size(); ++k)
      out += (k == 0 ? "M" : "L") + place(px(c.points[k].first)) + " " + place(py(c.points[k].second));
    out += "\" " + style + "/>\n";
    const double y = kTop + 20 * static_cast<double>(i);
    out += line(right + 15, y, right + 45, y, style) + text(right + 50, y + 4, "start", c.name);
  }
  return out;
}

}  // namespace

std::string charts_svg(std::span<const Chart> charts) {
  const std::string width = number(kWidth),
                    height = number(kHeight * static_cast<double>(std::max<std::size_t>(charts.size(), 1)));
  std::string out =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" + height + "\" viewBox=\"0 0 " + width +
      " " + height +
      "\" font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n";
  for (std::size_t i = 0; i < charts.size(); ++i)
    out += "<g transform=\"translate(0 " + number(kHeight * static_cast<double>(i)) + ")\">\n" + chart_body(charts[i]) +
           "</g>\n";
  return out + "</svg>\n";
}

}  // namespace ligne::studies
