#include "visibility/zbuffer/edge_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ligne::zbuffer {
namespace {

/// Parameters, in order, at which a coordinate that runs from `from` to `to` is a whole number.
class WholePlaces {
 public:
  WholePlaces(double from, double to) : from_(from), change_(to - from) {
    if (change_ > 0) {
      next_ = std::floor(from) + 1;
      step_ = 1;
    } else if (change_ < 0) {
      next_ = std::ceil(from) - 1;
      step_ = -1;
    }
  }

  /// Infinity if there is none.
  double next() const { return change_ == 0 ? std::numeric_limits<double>::infinity() : (next_ - from_) / change_; }
  void advance() { next_ += step_; }

 private:
  double from_, change_, next_ = 0, step_ = 0;
};

}  // namespace

EdgeSampling::EdgeSampling(const DepthBuffer& buffer, const Lattice& lattice, const Rect& window)
    : buffer_(buffer), places_(buffer.grid(), lattice) {
  const PixelGrid& grid = buffer.grid();
  const auto from = [&](double mm, double corner) {
    return std::max<std::int64_t>(static_cast<std::int64_t>(std::ceil((mm - corner) / grid.pixel_mm - 0.5)), 0);
  };
  const auto to = [&](double mm, double corner, std::int64_t count) {
    return std::min<std::int64_t>(static_cast<std::int64_t>(std::floor((mm - corner) / grid.pixel_mm - 0.5)), count - 1);
  };
  first_column_ = from(window.min.x, grid.corner_mm.x);
  first_row_ = from(window.min.y, grid.corner_mm.y);
  last_column_ = to(window.max.x, grid.corner_mm.x, grid.width);
  last_row_ = to(window.max.y, grid.corner_mm.y, grid.height);
}

bool EdgeSampling::hidden(double u, double v, double z) const {
  const auto column = static_cast<std::int64_t>(std::floor(u)), row = static_cast<std::int64_t>(std::floor(v));
  bool any = false;
  for (std::int64_t j = std::max(row, first_row_); j <= std::min(row + 1, last_row_); ++j) {
    for (std::int64_t i = std::max(column, first_column_); i <= std::min(column + 1, last_column_); ++i) {
      if (z <= buffer_.hiding_depth(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j))) return false;
      any = true;
    }
  }
  return any;
}

void EdgeSampling::find(const PageLine& line, std::vector<LinePart>& parts) const {
  parts.clear();
  const double u0 = places_.u(line.p0), v0 = places_.v(line.p0), u1 = places_.u(line.p1), v1 = places_.v(line.p1);
  WholePlaces columns(u0, u1), rows(v0, v1);
  for (double from = 0; from < 1;) {
    const double to = std::min({columns.next(), rows.next(), 1.0});
    if (columns.next() <= to) columns.advance();
    if (rows.next() <= to) rows.advance();
    if (to <= from) continue;
    const double middle = (from + to) / 2;
    if (!hidden(u0 + middle * (u1 - u0), v0 + middle * (v1 - v0), line.z(middle))) append_part(parts, {from, to});
    from = to;
  }
}

}  // namespace ligne::zbuffer
