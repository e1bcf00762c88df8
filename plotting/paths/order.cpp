#include "plotting/paths/order.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "plotting/paths/inside_first.hpp"
#include "geometry/nearest_points.hpp"
#include "plotting/paths/path_length.hpp"
#include "plotting/paths/tour.hpp"

namespace ligne {
namespace {

/// The strokes, the point at which each loop is entered, and the home position as one stroke after all others.
class Strokes {
 public:
  Strokes(const Polylines& lines, const OrderOptions& options) : lines_(lines), options_(options), start_(lines.size(), 0) {}

  Tour nearest_neighbours();
  Tour as_given();
  double way_up(const Tour& tour) const;
  void choose_starts(const Tour& tour);
  Tour inside_before(const Tour& tour);
  std::vector<Point2> ends() const;
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

/// The tour in the order of the drawing, with every loop entered at its first point.
Tour Strokes::as_given() {
  std::fill(start_.begin(), start_.end(), 0);
  Tour tour;
  tour.push_back(2 * count());
  for (std::uint32_t s = 0; s < count(); ++s) tour.push_back(2 * s);
  if (options_.returns) tour.push_back(2 * count() + 2);
  return tour;
}

double Strokes::way_up(const Tour& tour) const {
  double way = 0;
  for (std::size_t i = 1; i < tour.size(); ++i) way += glm::distance(end_point(tour[i - 1] ^ 1), end_point(tour[i]));
  return way;
}

/// Enters each loop at the point that is best between its neighbours in the tour.
void Strokes::choose_starts(const Tour& tour) {
  for (std::size_t i = 1; i < tour.size(); ++i) {
    const std::uint32_t stroke = tour[i] / 2;
    if (stroke >= count() || !is_loop(lines_[stroke])) continue;
    const auto line = lines_[stroke];
    const Point2 from = end_point(tour[i - 1] ^ 1);
    double best = std::numeric_limits<double>::infinity();
    for (std::uint32_t p = 0; p + 1 < line.size(); ++p) {
      const double way =
          glm::distance(from, line[p]) + (i + 1 < tour.size() ? glm::distance(line[p], end_point(tour[i + 1])) : 0);
      if (way < best) {
        best = way;
        start_[stroke] = p;
      }
    }
  }
}

/// Moves the strokes inside a closed stroke before it.
Tour Strokes::inside_before(const Tour& tour) {
  std::vector<std::uint32_t> order, entry_of(count());
  for (const std::uint32_t entry : tour) {
    if (entry / 2 >= count()) continue;
    order.push_back(entry / 2);
    entry_of[entry / 2] = entry;
  }
  Tour changed;
  changed.push_back(tour.front());
  for (const std::uint32_t stroke : inside_first(lines_, order)) changed.push_back(entry_of[stroke]);
  if (options_.returns) changed.push_back(tour.back());
  choose_starts(changed);
  return changed;
}

std::vector<Point2> Strokes::ends() const {
  std::vector<Point2> points(2 * lines_.size() + (options_.returns ? 4 : 2), options_.home);
  for (std::uint32_t e = 0; e < 2 * count(); ++e) points[e] = end_point(e);
  return points;
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
  if (order) {
    for (const std::uint32_t entry : tour) {
      if (entry / 2 < lines.size()) order->push_back(entry / 2);
    }
  }
  return strokes.in_order(tour);
}

}  // namespace ligne
