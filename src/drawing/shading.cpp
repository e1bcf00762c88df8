#include "drawing/shading.hpp"

#include <algorithm>
#include <cmath>

namespace ligne {

GrayPicture shade(const SpanModel& spans, const std::vector<double>& brightness, std::uint32_t width, std::uint32_t height,
                  double pixels_per_mm) {
  GrayPicture picture{width, height, std::vector<std::uint8_t>(std::size_t{width} * height, 255)};
  std::vector<double> row(width);
  const std::vector<Span>& all = spans.spans;
  for (std::size_t i = 0; i < all.size();) {
    const std::uint32_t line = all[i].line;
    std::fill(row.begin(), row.end(), 1.0);
    for (; i < all.size() && all[i].line == line; ++i) {
      const double darkness = 1 - (all[i].face < brightness.size() ? brightness[all[i].face] : 1);
      const double from = std::clamp(all[i].x_from * pixels_per_mm, 0.0, double(width)),
                   to = std::clamp(all[i].x_to * pixels_per_mm, 0.0, double(width));
      for (auto x = static_cast<std::uint32_t>(from); x < to; ++x) {
        row[x] -= darkness * (std::min(to, x + 1.0) - std::max(from, double(x)));
      }
    }
    if (line >= height) continue;
    for (std::uint32_t x = 0; x < width; ++x) {
      picture.gray[std::size_t{line} * width + x] =
          static_cast<std::uint8_t>(std::lround(255 * std::clamp(row[x], 0.0, 1.0)));
    }
  }
  return picture;
}

}  // namespace ligne
