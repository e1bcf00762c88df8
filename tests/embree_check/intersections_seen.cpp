#include "check.hpp"

#include "base/parallel.hpp"
#include "support/page_lines.hpp"

namespace ligne::check {

namespace {

/// Cauchy-Crofton: a curve of length L crosses the lines of a square grid of spacing s about 4 L / (pi s) times.
constexpr double kLengthPerCrossing = 3.14159265358979323846 / 4;
/// The place of a change is found to this part of the tolerance.
constexpr double kBisectedPart = 1.0 / 16;
/// Faces that come apart by less than this many tolerances of the input, where each is seen by itself, touch.
constexpr double kApartTolerances = 32;

class Search {
 public:
  Search(const CheckedScene& scene, const PageMap& map, const Sight& sight, const CheckOptions& options)
      : scene_(scene), map_(map), sight_(sight), options_(options) {}

  std::optional<SeenCrossing> between(Point2 p, Point2 q, std::optional<Hit> at_p, std::optional<Hit> at_q) const {
    if (!at_p || !at_q || at_p->face == at_q->face) return std::nullopt;
    while (glm::distance(p, q) > options_.tolerance_mm * kBisectedPart) {
      const Point2 middle = (p + q) * 0.5;
      const auto at_middle = sight_.seen_at(middle);
      if (!at_middle) return std::nullopt;
      // Go on where p's face gives way; faces between p's and q's are found by their own neighbours.
      if (at_middle->face == at_p->face) {
        p = middle, at_p = at_middle;
      } else {
        q = middle, at_q = at_middle;
      }
    }
    const CheckedFace &a = scene_.faces[at_p->face], &b = scene_.faces[at_q->face];
    if (!continues(at_p->face, p) || !continues(at_q->face, q)) return std::nullopt;
    if (!comes_apart(a, b, p)) return std::nullopt;
    return SeenCrossing{p, at_p->point, {at_p->face, at_q->face}, options_.seen_step_mm * kLengthPerCrossing};
  }

 private:
  /// Whether all sides of the face are well away from the page point.
  bool continues(std::uint32_t face, Point2 p) const {
    for (std::size_t c = 0; c < scene_.contours->contour_count(face); ++c) {
      const auto contour = scene_.contours->contour(face, c);
      for (std::size_t k = 0; k < contour.size(); ++k) {
        const Point3 &a = scene_.points[contour[k]], &b = scene_.points[contour[(k + 1) % contour.size()]];
        const auto part = map_.clip(a, b, 0);
        if (!part) continue;
        const Point2 from = map_.page(a + (b - a) * part->from), to = map_.page(a + (b - a) * part->to);
        if (test::distance_to_segment(p, from, to) <= 2 * options_.tolerance_mm) return false;
      }
    }
    return true;
  }

  /// Whether the planes are further apart than the input's errors at the distance of a tolerance from the crossing.
  bool comes_apart(const CheckedFace& a, const CheckedFace& b, Point2 p) const {
    const auto [start, away] = map_.sight_through(p);
    const double slope_a = glm::dot(a.normal, away), slope_b = glm::dot(b.normal, away);
    if (slope_a == 0 || slope_b == 0) return false;
    const Point3 on_a = start + away * (glm::dot(a.normal, a.middle - start) / slope_a);
    const double sine = glm::length(glm::cross(a.normal, b.normal));
    const Point3 moved = map_.shifted(on_a, {options_.tolerance_mm, 0});
    return sine * glm::distance(moved, on_a) > kApartTolerances * (a.tolerance + b.tolerance);
  }

  const CheckedScene& scene_;
  const PageMap& map_;
  const Sight& sight_;
  const CheckOptions& options_;
};

}  // namespace

std::vector<SeenCrossing> find_intersections_seen(const CheckedScene& scene, const PageMap& map, const Sight& sight,
                                                  const CheckOptions& options) {
  const Rect& window = map.window();
  const double step = options.seen_step_mm, margin = 2 * options.tolerance_mm;
  const auto columns = static_cast<std::size_t>(std::max(0.0, (window.width() - 2 * margin) / step)) + 1;
  const auto rows = static_cast<std::size_t>(std::max(0.0, (window.height() - 2 * margin) / step)) + 1;
  const auto point = [&](std::size_t column, std::size_t row) {
    return window.min + Point2{margin + static_cast<double>(column) * step, margin + static_cast<double>(row) * step};
  };
  std::vector<std::optional<Hit>> seen(columns * rows);
  parallel_for(rows, [&](std::size_t row) {
    for (std::size_t column = 0; column < columns; ++column)
      seen[row * columns + column] = sight.seen_at(point(column, row));
  });
  const Search search(scene, map, sight, options);
  std::vector<std::vector<SeenCrossing>> by_row(rows);
  parallel_for(rows, [&](std::size_t row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const auto look = [&](std::size_t to_column, std::size_t to_row) {
        if (to_column >= columns || to_row >= rows) return;
        const auto crossing = search.between(point(column, row), point(to_column, to_row), seen[row * columns + column],
                                             seen[to_row * columns + to_column]);
        if (crossing) by_row[row].push_back(*crossing);
      };
      look(column + 1, row);
      look(column, row + 1);
    }
  });
  std::vector<SeenCrossing> crossings;
  for (const auto& found : by_row) crossings.insert(crossings.end(), found.begin(), found.end());
  return crossings;
}

}  // namespace ligne::check
