#include "chart.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace ligne::bench {
namespace {

constexpr double kWidth = 640, kHeight = 400, kLeft = 70, kRight = 150, kTop = 40, kBottom = 50;
constexpr const char* kDashes[] = {"none", "8 4", "2 3", "10 3 2 3", "5 2", "1 2"};

/// A round number of units between ticks, so that there are about five.
double tick(double largest) {
  const double raw = std::max(largest, 1e-300) / 5, power = std::pow(10, std::floor(std::log10(raw)));
  for (const double m : {1.0, 2.0, 5.0, 10.0}) {
    if (m * power >= raw) return m * power;
  }
  return raw;
}

std::string text(double x, double y, const char* anchor, const std::string& words) {
  char buffer[128];
  std::snprintf(buffer, sizeof buffer, "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"%s\">", x, y, anchor);
  return buffer + words + "</text>\n";
}

std::string line(double x0, double y0, double x1, double y1, const char* style) {
  char buffer[256];
  std::snprintf(buffer, sizeof buffer, "<path d=\"M%.1f %.1fL%.1f %.1f\" %s/>\n", x0, y0, x1, y1, style);
  return buffer;
}

std::string number(double v) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%g", v);
  return buffer;
}

}  // namespace

void write_chart(const std::filesystem::path& file, const Chart& chart) {
  double x_max = 0, y_max = 0;
  for (const Curve& c : chart.curves) {
    for (const auto& [x, y] : c.points) {
      x_max = std::max(x_max, x);
      y_max = std::max(y_max, y);
    }
  }
  const double x_tick = tick(x_max), y_tick = tick(y_max);
  const double x_end = std::ceil(x_max / x_tick) * x_tick, y_end = std::ceil(y_max / y_tick) * y_tick;
  const auto px = [&](double x) { return kLeft + (kWidth - kLeft - kRight) * x / x_end; };
  const auto py = [&](double y) { return kHeight - kBottom - (kHeight - kTop - kBottom) * y / y_end; };
  std::string out =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"640\" height=\"400\" viewBox=\"0 0 640 400\" font-family=\"sans-serif\" "
      "font-size=\"12\">\n<rect width=\"640\" height=\"400\" fill=\"white\"/>\n";
  constexpr const char* kGrid = "stroke=\"#ccc\" fill=\"none\"";
  constexpr const char* kAxis = "stroke=\"black\" fill=\"none\"";
  for (double x = 0; x <= x_end * 1.0001; x += x_tick) {
    out += line(px(x), py(0), px(x), py(y_end), kGrid) + text(px(x), py(0) + 18, "middle", number(x));
  }
  for (double y = 0; y <= y_end * 1.0001; y += y_tick) {
    out += line(px(0), py(y), px(x_end), py(y), kGrid) + text(px(0) - 6, py(y) + 4, "end", number(y));
  }
  out += line(px(0), py(0), px(x_end), py(0), kAxis) + line(px(0), py(0), px(0), py(y_end), kAxis);
  out += text(kWidth / 2 - 40, 22, "middle", chart.title) +
         text((px(0) + px(x_end)) / 2, kHeight - 12, "middle", chart.x_label);
  out += text(6, kTop - 14, "start", chart.y_label);
  for (std::size_t i = 0; i < chart.curves.size(); ++i) {
    const Curve& c = chart.curves[i];
    const char* const dash = kDashes[i % std::size(kDashes)];
    out += "<path d=\"";
    for (std::size_t k = 0; k < c.points.size(); ++k) {
      char buffer[64];
      std::snprintf(buffer, sizeof buffer, "%s%.1f %.1f", k == 0 ? "M" : "L", px(c.points[k].first), py(c.points[k].second));
      out += buffer;
    }
    out += std::string("\" stroke=\"black\" stroke-width=\"1.5\" fill=\"none\" stroke-dasharray=\"") + dash + "\"/>\n";
    const double y = kTop + 20 * static_cast<double>(i);
    out += line(kWidth - kRight + 15, y, kWidth - kRight + 45, y,
                (std::string("stroke=\"black\" stroke-width=\"1.5\" stroke-dasharray=\"") + dash + "\"").c_str());
    out += text(kWidth - kRight + 50, y + 4, "start", c.name);
  }
  out += "</svg>\n";
  std::ofstream stream(file, std::ios::binary);
  stream << out;
  if (!stream.flush()) throw std::runtime_error(file.string() + ": can not be written");
}

}  // namespace ligne::bench
