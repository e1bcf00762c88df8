#include "plotting/paths/optimize.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "geometry/search/nearest_points.hpp"
#include "plotting/paths/tour.hpp"

namespace ligne {
namespace {

/// Counts the crossings of a ray to the right: an odd number means inside.
bool is_inside(std::span<const Point2> loop, Point2 p) {
  bool inside = false;
  for (std::size_t i = 1; i < loop.size(); ++i) {
    const Point2 a = loop[i - 1], b = loop[i];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

/// For each stroke the smallest closed one that it lies in, or kNone. Sweeps down the page.
std::vector<std::uint32_t> surrounders(const Polylines& lines) {
  const auto n = static_cast<std::uint32_t>(lines.size());
  std::vector<Rect> boxes(n);
  std::vector<std::uint32_t> strokes, loops;
  for (std::uint32_t s = 0; s < n; ++s) {
    for (const Point2 p : lines[s]) boxes[s].extend(p);
    if (!lines[s].empty()) strokes.push_back(s);
    if (lines[s].size() > 3 && is_loop(lines[s])) loops.push_back(s);
  }
  std::ranges::sort(strokes, {}, [&](std::uint32_t s) { return std::pair(lines[s].front().y, s); });
  std::ranges::sort(loops, {}, [&](std::uint32_t s) { return std::pair(boxes[s].min.y, s); });
  std::vector<std::uint32_t> around(n, kNone), open;
  std::size_t next = 0;
  for (const std::uint32_t s : strokes) {
    const Point2 p = lines[s].front();
    for (; next < loops.size() && boxes[loops[next]].min.y <= p.y; ++next) open.push_back(loops[next]);
    std::erase_if(open, [&](std::uint32_t loop) { return boxes[loop].max.y < p.y; });
    const double own = boxes[s].width() * boxes[s].height();
    double smallest = std::numeric_limits<double>::infinity();
    for (const std::uint32_t loop : open) {
      const Rect& box = boxes[loop];
      const double area = box.width() * box.height();
      if (loop == s || p.x < box.min.x || p.x > box.max.x || area <= own || area >= smallest) continue;
      if (!is_inside(lines[loop], p)) continue;
      smallest = area;
      around[s] = loop;
    }
  }
  return around;
}

/// Changes an order of strokes so that every stroke inside a closed one is drawn before it. Inner strokes that come
/// later move to just before the closed stroke. A stroke is inside if its first point is, and its bounding box is
/// smaller. Time: O(n log n), plus for each stroke the closed strokes whose boxes reach over the height of its first
/// point.
std::vector<std::uint32_t> inside_first(const Polylines& lines, const std::vector<std::uint32_t>& order) {
  const std::vector<std::uint32_t> around = surrounders(lines);
  std::vector<std::vector<std::uint32_t>> inside(lines.size());
  for (const std::uint32_t s : order) {
    if (around[s] != kNone) inside[around[s]].push_back(s);
  }
  std::vector<std::uint8_t> is_drawn(lines.size(), 0);
  std::vector<std::uint32_t> result, found, waiting;
  for (const std::uint32_t first : order) {
    // Finds a stroke and those inside it in the reverse of the order in which they are drawn.
    for (waiting.assign(1, first), found.clear(); !waiting.empty();) {
      const std::uint32_t stroke = waiting.back();
      waiting.pop_back();
      if (std::exchange(is_drawn[stroke], 1)) continue;
      found.push_back(stroke);
      waiting.insert(waiting.end(), inside[stroke].begin(), inside[stroke].end());
    }
    result.insert(result.end(), found.rbegin(), found.rend());
  }
  return result;
}

/// The strokes, the point at which each loop is entered, and the home position as one stroke after all others.
class Strokes {
 public:
  Strokes(const Polylines& lines, const OrderOptions& options) : lines_(lines), options_(options), start_(lines.size(), 0) {}

  Tour nearest_neighbours();

  /// The tour in the order of the drawing, with every loop entered at its first point.
  Tour as_given() {
    std::fill(start_.begin(), start_.end(), 0);
    Tour tour;
    tour.push_back(2 * count());
    for (std::uint32_t s = 0; s < count(); ++s) tour.push_back(2 * s);
    if (options_.returns) tour.push_back(2 * count() + 2);
    return tour;
  }

  double way_up(const Tour& tour) const {
    double way = 0;
    for (std::size_t i = 1; i < tour.size(); ++i) way += glm::distance(end_point(tour[i - 1] ^ 1), end_point(tour[i]));
    return way;
  }

  /// Enters each loop at the point that is best between its neighbours in the tour.
  void choose_starts(const Tour& tour) {
    for (std::size_t i = 1; i < tour.size(); ++i) {
      const std::uint32_t stroke = tour[i] / 2;
      if (stroke >= count() || !is_loop(lines_[stroke])) continue;
      const auto line = lines_[stroke];
      const Point2 from = end_point(tour[i - 1] ^ 1);
      const auto way = [&](Point2 p) {
        return glm::distance(from, p) + (i + 1 < tour.size() ? glm::distance(p, end_point(tour[i + 1])) : 0);
      };
      const auto best = std::ranges::min_element(line.begin(), line.end() - 1, {}, way);
      start_[stroke] = static_cast<std::uint32_t>(best - line.begin());
    }
  }

  Tour inside_before(const Tour& tour);

  std::vector<Point2> ends() const {
    std::vector<Point2> points(2 * lines_.size() + (options_.returns ? 4 : 2), options_.home);
    for (std::uint32_t e = 0; e < 2 * count(); ++e) points[e] = end_point(e);
    return points;
  }

  /// The strokes of a tour in their order, without the home positions.
  std::vector<std::uint32_t> strokes_of(const Tour& tour) const {
    std::vector<std::uint32_t> strokes;
    for (const std::uint32_t entry : tour) {
      if (entry / 2 < count()) strokes.push_back(entry / 2);
    }
    return strokes;
  }
  Polylines in_order(const Tour& tour) const;

 private:
  std::uint32_t count() const { return static_cast<std::uint32_t>(lines_.size()); }
  Point2 end_point(std::uint32_t end) const {
    const std::uint32_t stroke = end / 2;
    if (stroke >= count()) return options_.home;
    const auto line = lines_[stroke];
    if (is_loop(line)) return line[start_[stroke]];
    return end % 2 == 0 ? line.front() : line.back();
  }

  const Polylines& lines_;
  const OrderOptions& options_;
  std::vector<std::uint32_t> start_;  ///< per loop: index of the point at which it is entered
};

/// Builds a tour by nearest neighbours. The pen can enter a line at its two ends, and a loop at every point.
Tour Strokes::nearest_neighbours() {
  std::vector<Point2> points;
  std::vector<std::uint32_t> stroke_of, first_of;
  for (std::uint32_t s = 0; s < count(); ++s) {
    const auto line = lines_[s];
    first_of.push_back(static_cast<std::uint32_t>(points.size()));
    if (is_loop(line)) {
      points.insert(points.end(), line.begin(), line.end() - 1);
    } else {
      points.insert(points.end(), {line.front(), line.back()});
    }
    stroke_of.resize(points.size(), s);
  }
  first_of.push_back(static_cast<std::uint32_t>(points.size()));

  NearestPoints tree(points);
  std::vector<NearestPoints::Neighbour> nearest;
  Tour tour;
  tour.push_back(2 * count());
  Point2 pen = options_.home;
  for (std::uint32_t n = 0; n < count(); ++n) {
    tree.nearest(pen, 1, nearest);
    const std::uint32_t found = nearest[0].point, stroke = stroke_of[found];
    std::uint32_t entry = 2 * stroke;
    if (is_loop(lines_[stroke])) {
      start_[stroke] = found - first_of[stroke];
    } else {
      entry += found - first_of[stroke];
    }
    for (std::uint32_t p = first_of[stroke]; p < first_of[stroke + 1]; ++p) tree.remove(p);
    tour.push_back(entry);
    pen = end_point(entry ^ 1);
  }
  if (options_.returns) tour.push_back(2 * count() + 2);
  return tour;
}
/// Moves the strokes inside a closed stroke before it.
Tour Strokes::inside_before(const Tour& tour) {
  std::vector<std::uint32_t> entry_of(count() + 2);  // also of the home positions
  for (const std::uint32_t entry : tour) entry_of[entry / 2] = entry;
  Tour changed;
  changed.push_back(tour.front());
  for (const std::uint32_t stroke : inside_first(lines_, strokes_of(tour))) changed.push_back(entry_of[stroke]);
  if (options_.returns) changed.push_back(tour.back());
  choose_starts(changed);
  return changed;
}
Polylines Strokes::in_order(const Tour& tour) const {
  Polylines out;
  out.points.reserve(lines_.points.size());
  out.begin.reserve(lines_.begin.size());
  for (const std::uint32_t entry : tour) {
    const std::uint32_t stroke = entry / 2;
    if (stroke >= count()) continue;
    const auto line = lines_[stroke];
    if (is_loop(line)) {
      const auto n = static_cast<std::uint32_t>(line.size() - 1);
      for (std::uint32_t k = 0; k <= n; ++k) out.points.push_back(line[(start_[stroke] + k) % n]);
    } else if (entry % 2 == 0) {
      out.points.insert(out.points.end(), line.begin(), line.end());
    } else {
      out.points.insert(out.points.end(), line.rbegin(), line.rend());
    }
    out.begin.push_back(static_cast<std::uint32_t>(out.points.size()));
  }
  return out;
}

}  // namespace

Polylines order_strokes(const Polylines& lines, const OrderOptions& options, std::vector<std::uint32_t>* order) {
  if (order) order->clear();
  if (lines.size() == 0) return lines;
  Strokes strokes(lines, options);
  const double given = strokes.way_up(strokes.as_given());
  std::uint64_t work = options.most_work;
  // The starts of loops depend on the order, and the order on the starts. Two rounds settle both.
  const auto improved = [&](Tour tour) {
    for (int round = 0; round < 2; ++round) {
      improve(tour, strokes.ends(), options.returns, work);
      strokes.choose_starts(tour);
    }
    return tour;
  };
  Tour tour = improved(strokes.nearest_neighbours());
  // Nearest neighbours leave some strokes for the end. If the given order is still better, it is improved instead.
  if (strokes.way_up(tour) > given) {
    work = options.most_work;
    tour = improved(strokes.as_given());
  }
  if (options.inside_first) tour = strokes.inside_before(tour);
  if (order) *order = strokes.strokes_of(tour);
  return strokes.in_order(tour);
}

std::vector<std::uint32_t> long_strokes(const Polylines& lines, double min_length_mm) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    if (path_length(lines[i]) >= min_length_mm) kept.push_back(i);
  }
  return kept;
}

Polylines picked(const Polylines& lines, std::span<const std::uint32_t> numbers) {
  Polylines some;
  for (const std::uint32_t i : numbers) some.add(lines[i]);
  return some;
}

Polylines optimize_paths(const Polylines& lines, const PathOptions& options) {
  const bool joins = options.optimize == Optimize::join || options.optimize == Optimize::full,
             orders = options.optimize == Optimize::order || options.optimize == Optimize::full;
  Polylines strokes = joins ? join_strokes(lines, options.tolerances) : lines;
  if (options.min_length_mm > 0) strokes = picked(strokes, long_strokes(strokes, options.min_length_mm));
  return orders ? order_strokes(strokes, options.order) : strokes;
}

double PathPace::seconds(const PathLengths& lengths) const {
  return lengths.down_mm / down_mm_s + lengths.up_mm / up_mm_s + static_cast<double>(lengths.strokes) * lift_s;
}

PathLengths& PathLengths::operator+=(const PathLengths& other) {
  strokes += other.strokes;
  down_mm += other.down_mm;
  up_mm += other.up_mm;
  return *this;
}

PathLengths measure(const Polylines& lines, Point2 home, bool returns) {
  PathLengths lengths;
  Point2 pen = home;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines[i];
    if (line.empty()) continue;
    ++lengths.strokes;
    lengths.up_mm += glm::distance(pen, line.front());
    lengths.down_mm += path_length(line);
    pen = line.back();
  }
  if (returns && lengths.strokes > 0) lengths.up_mm += glm::distance(pen, home);
  return lengths;
}

}  // namespace ligne
