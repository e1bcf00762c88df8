#include "visibility/watkins/ruled_parts.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace ligne::watkins {
namespace {

/// Heights at which a side begins, ends or crosses another.
std::vector<double> heights_of(std::span<const RuledSide> sides) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const RuledSide& a = sides[i];
    heights.push_back(a.top.p.y);
    heights.push_back(a.bottom.p.y);
    for (std::size_t k = i + 1; k < sides.size(); ++k) {
      const RuledSide& b = sides[k];
      const double from = std::max(a.top.p.y, b.top.p.y), to = std::min(a.bottom.p.y, b.bottom.p.y);
      if (!(from < to)) continue;
      const double at_from = a.x(from) - b.x(from), at_to = a.x(to) - b.x(to);
      if (at_from * at_to < 0) heights.push_back(from + (to - from) * (at_from / (at_from - at_to)));
    }
  }
  std::ranges::sort(heights);
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

/// A linear function on [0, 1] by its values at the ends.
struct Linear {
  double first, last;
  double operator()(double s) const { return first + s * (last - first); }
};

/// A line over the heights of a part. The parameter s is 0 and 1 where the line enters and leaves these heights.
struct LineOverPart {
  HiddenSides sides = HiddenSides::none;  ///< none: the line is beside the part
  double t0 = 0, t1 = 1;                  ///< parameters on the line
  Linear from_left{}, to_right{};         ///< distances from the sides, in steps
  Linear z{}, z_left{}, z_right{};        ///< depths of the line and of the sides
  double enter = 0, leave = 1;            ///< the part that lies between the sides

  double t(double s) const { return s == 0 ? t0 : s == 1 ? t1 : t0 + s * (t1 - t0); }
  /// How much farther the line is than the surface, times the distance of the sides.
  double scaled_difference(double s) const {
    const double a = from_left(s), b = to_right(s);
    return z(s) * (a + b) - (z_left(s) * b + z_right(s) * a);
  }
  double difference(double s) const {
    const double width = from_left(s) + to_right(s);
    return width > 0 ? scaled_difference(s) / width : 0;
  }
  /// The zeros of scaled_difference(); infinite or not a number where there is none.
  std::array<double, 2> roots() const {
    constexpr double kHalf = 0.5;
    const double c0 = scaled_difference(0), at_half = scaled_difference(kHalf), at_one = scaled_difference(1);
    const double c2 = 2 * (c0 + at_one - 2 * at_half), c1 = at_one - c0 - c2;
    const double q = -kHalf * (c1 + std::copysign(std::sqrt(c1 * c1 - 4 * c2 * c0), c1));
    return {q / c2, c0 / q};
  }
};

/// Narrows [enter, leave] to where the function is not negative.
void narrow(const Linear& f, double& enter, double& leave) {
  if (f.first < 0 && f.last < 0) {
    leave = enter;
  } else if (f.first < 0) {
    enter = std::max(enter, f.first / (f.first - f.last));
  } else if (f.last < 0) {
    leave = std::min(leave, f.first / (f.first - f.last));
  }
}

bool lies_along(const PageLine& line, const RuledSide& side) {
  return orientation(side.top.p, side.bottom.p, line.p0) == 0 && orientation(side.top.p, side.bottom.p, line.p1) == 0;
}

/// Sides as in hidden_interval(): a line along a border of the part has the part on one side only.
LineOverPart line_over_part(const PageLine& line, const RuledPart& part) {
  LineOverPart over;
  HiddenSides sides = HiddenSides::both;
  const double y = line.p0.y;
  if (line.dy == 0) {
    if (y < part.y_top || y > part.y_bottom) return over;
    if (y == part.y_top) sides = line.dx > 0 ? HiddenSides::left : HiddenSides::right;
    if (y == part.y_bottom) sides = line.dx > 0 ? HiddenSides::right : HiddenSides::left;
  } else {
    const double a = (part.y_top - y) / line.dy, b = (part.y_bottom - y) / line.dy;
    over.t0 = std::max(0.0, std::min(a, b));
    over.t1 = std::min(1.0, std::max(a, b));
    if (!(over.t0 < over.t1)) return over;
  }
  const auto linear = [&](auto value) { return Linear{value(over.t0), value(over.t1)}; };
  const auto y_at = [&](double t) { return y + t * line.dy; };
  const auto x_at = [&](double t) { return line.p0.x + t * line.dx; };
  over.from_left = linear([&](double t) { return x_at(t) - part.left.x(y_at(t)); });
  over.to_right = linear([&](double t) { return part.right.x(y_at(t)) - x_at(t); });
  over.z = linear([&](double t) { return line.z(t); });
  over.z_left = linear([&](double t) { return part.left.z(y_at(t)); });
  over.z_right = linear([&](double t) { return part.right.z(y_at(t)); });
  if (lies_along(line, part.left)) {
    over.from_left = {0, 0};
    sides = line.dy < 0 ? HiddenSides::left : HiddenSides::right;
  } else if (lies_along(line, part.right)) {
    over.to_right = {0, 0};
    sides = line.dy > 0 ? HiddenSides::left : HiddenSides::right;
  }
  narrow(over.from_left, over.enter, over.leave);
  narrow(over.to_right, over.enter, over.leave);
  if (over.enter < over.leave) over.sides = sides;
  return over;
}

}  // namespace

std::vector<RuledPart> ruled_parts(std::span<const RuledSide> sides) {
  std::vector<RuledPart> parts;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> open;  // by sides: a part that ends at the current height
  const std::vector<double> heights = heights_of(sides);
  std::vector<std::size_t> met;
  for (std::size_t h = 0; h + 1 < heights.size(); ++h) {
    const double from = heights[h], to = heights[h + 1], middle = (from + to) / 2;
    met.clear();
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (sides[i].top.p.y <= from && to <= sides[i].bottom.p.y) met.push_back(i);
    }
    std::ranges::sort(met, {}, [&](std::size_t i) { return std::pair(sides[i].x(middle), i); });
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> next;
    for (std::size_t i = 0; i + 1 < met.size(); i += 2) {
      const std::pair pair(met[i], met[i + 1]);
      const auto above = open.find(pair);
      if (above != open.end()) {
        parts[above->second].y_bottom = to;
        next[pair] = above->second;
      } else {
        next[pair] = parts.size();
        parts.push_back({sides[pair.first], sides[pair.second], from, to});
      }
    }
    open = std::move(next);
  }
  return parts;
}

std::array<HiddenInterval, 2> behind_ruled_part(const PageLine& line, const RuledPart& part, double tolerance) {
  std::array<HiddenInterval, 2> hidden{};
  const LineOverPart over = line_over_part(line, part);
  if (over.sides == HiddenSides::none) return hidden;
  // The depth difference times the width is quadratic in s. It has one sign between two stops.
  std::array<double, 4> stops{over.enter, over.leave};
  std::size_t count = 2;
  for (const double root : over.roots()) {
    if (root > over.enter && root < over.leave) stops[count++] = root;
  }
  std::sort(stops.begin(), stops.begin() + static_cast<std::ptrdiff_t>(count));
  std::size_t found = 0;
  bool is_open = false, is_behind = false;
  double begin = 0;
  const auto close = [&](double end) {
    if (is_open && is_behind && begin < end && found < hidden.size())
      hidden[found++] = {over.t(begin), over.t(end), over.sides};
    is_open = is_behind = false;
  };
  for (std::size_t i = 0; i + 1 < count; ++i) {
    bool behind = false, in_front = false;
    for (const double s : {stops[i], (stops[i] + stops[i + 1]) / 2, stops[i + 1]}) {
      const double d = over.difference(s);
      behind |= d > tolerance;
      in_front |= d < -tolerance;
    }
    if (in_front) {
      close(stops[i]);
      continue;
    }
    if (!is_open) begin = stops[i];
    is_open = true;
    is_behind |= behind;
  }
  close(stops[count - 1]);
  return hidden;
}

}  // namespace ligne::watkins
