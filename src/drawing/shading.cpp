#include "drawing/shading.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace ligne {

GrayPicture shade(const SpanModel& spans, const std::vector<double>& brightness, std::uint32_t width, std::uint32_t height, double pixels_per_mm) {
  GrayPicture picture{width, height, std::vector<std::uint8_t>(std::size_t{width} * height, 255)};
  std::vector<double> row(width);
  const std::vector<Span>& all = spans.spans;
  for (std::size_t i = 0; i < all.size();) {
    const std::uint32_t line = all[i].line;
    std::fill(row.begin(), row.end(), 1.0);
    for (; i < all.size() && all[i].line == line; ++i) {
      const double darkness = 1 - (all[i].face < brightness.size() ? brightness[all[i].face] : 1);
      const double from = std::clamp(all[i].x_from * pixels_per_mm, 0.0, double(width)), to = std::clamp(all[i].x_to * pixels_per_mm, 0.0, double(width));
      for (auto x = static_cast<std::uint32_t>(from); x < to; ++x) {
        row[x] -= darkness * (std::min(to, x + 1.0) - std::max(from, double(x)));
      }
    }
    if (line >= height) continue;
    for (std::uint32_t x = 0; x < width; ++x) {
      picture.gray[std::size_t{line} * width + x] = static_cast<std::uint8_t>(std::lround(255 * std::clamp(row[x], 0.0, 1.0)));
    }
  }
  return picture;
}

Polylines hatch(const SpanModel& spans, const std::vector<double>& brightness, unsigned levels) {
  levels = std::clamp(levels, 1u, kMostHatchLevels);
  // 0 is the darkest.
  const auto level_of = [&](std::uint32_t face) {
    const double b = face < brightness.size() ? brightness[face] : 1;
    return std::min(levels - 1, static_cast<unsigned>(std::max(0.0, b) * levels));
  };
  Polylines lines;
  const std::vector<Span>& all = spans.spans;
  std::vector<std::array<double, 2>> runs;
  bool backwards = false;
  for (std::size_t i = 0; i < all.size();) {
    const std::uint32_t line = all[i].line;
    runs.clear();
    for (; i < all.size() && all[i].line == line; ++i) {
      if (line % (1u << level_of(all[i].face)) != 0) continue;
      if (!runs.empty() && runs.back()[1] == all[i].x_from) {
        runs.back()[1] = all[i].x_to;
      } else {
        runs.push_back({all[i].x_from, all[i].x_to});
      }
    }
    if (runs.empty()) continue;
    if (backwards) {
      std::reverse(runs.begin(), runs.end());
      for (auto& r : runs) std::swap(r[0], r[1]);
    }
    backwards = !backwards;
    const double y = spans.lines.y_mm(line);
    for (const auto& r : runs) {
      lines.points.push_back({r[0], y});
      lines.points.push_back({r[1], y});
      lines.begin.push_back(static_cast<std::uint32_t>(lines.points.size()));
    }
  }
  return lines;
}

}  // namespace ligne
