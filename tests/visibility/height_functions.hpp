#pragma once
/// Surfaces z = f(x, y) that several tests of the horizon draw.

#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "drawing/drawing.hpp"
#include "scene/surfaces/height_source.hpp"

namespace ligne::test {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

using Function = std::function<double(double, double)>;

class FunctionHeights : public HeightSource {
 public:
  FunctionHeights(Function f, std::vector<double> x, std::vector<double> y)
      : HeightSource(std::move(x), std::move(y)), f_(std::move(f)) {}
  void read_row(std::size_t j, std::span<double> z) const override {
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = f_(x()[i], y()[j]);
  }

 private:
  Function f_;
};

/// So many positions from -1 to 1.
inline std::vector<double> positions(std::size_t n) {
  std::vector<double> at;
  for (std::size_t i = 0; i < n; ++i) at.push_back(2.0 * static_cast<double>(i) / static_cast<double>(n - 1) - 1);
  return at;
}

/// Of all lines together.
inline double length_of(const Polylines& lines) {
  double sum = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    for (std::size_t k = 1; k < line.size(); ++k) sum += std::hypot(line[k].x - line[k - 1].x, line[k].y - line[k - 1].y);
  }
  return sum;
}

inline double waves(double x, double y) { return 0.3 * std::sin(5 * x * y + 0.1) + 0.1 * x; }
inline double sombrero(double x, double y) {
  const double r = std::hypot(x, y) * 12;
  return r == 0 ? 1 : std::sin(r) / r;
}

}  // namespace ligne::test
