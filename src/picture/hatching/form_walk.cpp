#include "picture/hatching/form_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "geometry/nearest_on_segment.hpp"
#include "picture/light/face_carrier.hpp"

namespace ligne {
namespace {

/// Largest number of triangles around a vertex that a walk may pass without moving on.
constexpr int kMostTurns = 64;

Weights weights_in(const FormMesh& mesh, std::uint32_t triangle, const Point3& point) {
  const Point3 a = mesh.point(triangle, 0), e1 = mesh.point(triangle, 1) - a, e2 = mesh.point(triangle, 2) - a;
  const Point3 normal = glm::cross(e1, e2);
  const double square = glm::dot(normal, normal);
  const double b1 = glm::dot(glm::cross(point - a, e2), normal) / square,
               b2 = glm::dot(glm::cross(e1, point - a), normal) / square;
  return {1 - b1 - b2, b1, b2};
}

/// Distance within which two points coincide, in mm: the accuracy of drawings.
constexpr double kTouchMm = 1e-3;

double distance_to(Point2 p, Point2 from, Point2 to) {
  return glm::distance(p, from + (to - from) * nearest_on_segment(p, from, to));
}

bool contains(const Region& region, Point2 p) {
  bool inside = false;
  for (const auto& contour : region.contours) {
    for (std::size_t i = 0, before = contour.size() - 1; i < contour.size(); before = i++) {
      const Point2 a = contour[before], b = contour[i];
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * ((p.y - a.y) / (b.y - a.y))) inside = !inside;
    }
  }
  return inside;
}

}  // namespace

Point3 FormWalk::point(const FormPlace& place) const {
  Point3 sum{0, 0, 0};
  for (int k = 0; k < 3; ++k) sum += mesh_.point(place.triangle, k) * place.weights[static_cast<std::size_t>(k)];
  return sum;
}

std::optional<FormPlace> FormWalk::place_on(std::uint32_t face, Point2 page_mm) const {
  std::optional<FormPlace> best;
  double least = -std::numeric_limits<double>::infinity();
  for (std::uint32_t t = mesh_.first[face]; t < mesh_.first[face + 1]; ++t) {
    const Point3 area = mesh_.area_vector(t);
    Point3 on_face;
    if (!(glm::dot(area, area) > 0) || !point_on_face(view_, page_mm, {area, mesh_.point(t, 0)}, on_face)) continue;
    const Weights weights = weights_in(mesh_, t, on_face);
    const double inside = *std::min_element(weights.begin(), weights.end());
    if (!(inside > least)) continue;
    least = inside;
    best = FormPlace{t, weights, page_mm};
  }
  return best && least >= 0 ? best : std::nullopt;
}

Point2 FormWalk::page_velocity(const Point3& point, const Point3& direction) const {
  const HomogeneousPoint at = to_homogeneous(view_, point);
  const glm::dvec4 d = view_.model_to_page * glm::dvec4(direction, 0);
  return Point2{d.x * at.w - at.x * d.w, d.y * at.w - at.y * d.w} / (at.w * at.w);
}

double FormWalk::scale_at(const Point3& point) const {
  if (!view_.camera.perspective) return view_.scale;
  return view_.scale * view_.camera.target_distance / camera_coordinates(view_.camera, point).z;
}

/// Rates at which the weights change along the direction.
Weights FormWalk::rates(std::uint32_t triangle, const Point3& direction) const {
  const Weights ends = weights_in(mesh_, triangle, mesh_.point(triangle, 0) + direction);
  return {ends[0] - 1, ends[1], ends[2]};
}

FormWalk::Exit FormWalk::exit_of(const FormPlace& place, const Point3& direction) const {
  const Weights rate = rates(place.triangle, direction);
  Exit exit{std::numeric_limits<double>::infinity(), 0};
  for (int corner = 0; corner < 3; ++corner) {
    const auto k = static_cast<std::size_t>(corner);
    if (!(rate[k] < 0)) continue;
    const double length = std::max(0.0, place.weights[k]) / -rate[k];
    if (length < exit.length) exit = {length, (corner + 1) % 3};
  }
  return exit;
}

FormPlace FormWalk::moved(const FormPlace& place, const Point3& way) const {
  const Weights rate = rates(place.triangle, way);
  FormPlace to = place;
  for (std::size_t k = 0; k < 3; ++k) to.weights[k] += rate[k];
  const HomogeneousPoint p = to_homogeneous(view_, point(to));
  to.page = {p.x / p.w, p.y / p.w};
  return to;
}

/// Moves by the length, or across a side if the triangle ends before.
bool FormWalk::advance(FormPlace& place, const Point3& direction, const Exit& exit, double length) const {
  const bool leaves = !(length < exit.length);
  FormPlace to = moved(place, direction * std::min(length, exit.length));
  const double seen = regions_.seen_until(mesh_.triangles[place.triangle].face, place.page, to.page);
  if (seen < 1) {
    place = moved(place, direction * (seen * std::min(length, exit.length)));
    return false;
  }
  if (!leaves) {
    place = to;
    return true;
  }
  const FormTriangle& triangle = mesh_.triangles[place.triangle];
  const auto side = static_cast<std::size_t>(exit.side);
  const std::uint32_t ends[] = {triangle.node[side], triangle.node[(side + 1) % 3]};
  const double weights[] = {std::max(0.0, to.weights[side]), std::max(0.0, to.weights[(side + 1) % 3])};
  to.weights[(side + 2) % 3] = 0;
  const std::uint32_t next = triangle.across[side];
  const int corners[] = {next == kNone ? -1 : corner_at(mesh_, next, ends[0]),
                         next == kNone ? -1 : corner_at(mesh_, next, ends[1])};
  place = to;
  if (corners[0] < 0 || corners[1] < 0) return false;
  place.triangle = next;
  place.weights = {0, 0, 0};
  const double sum = weights[0] + weights[1];
  for (std::size_t k = 0; k < 2; ++k) place.weights[static_cast<std::size_t>(corners[k])] = weights[k] / sum;
  return true;
}

bool FormWalk::step(const FormField& field, FormPlace& place, Point3& along, bool& second, double step_mm) const {
  for (int turns = 0; turns < kMostTurns; ++turns) {
    const Point3 at = point(place);
    Point3 way = field.onward(mesh_, place.triangle, place.weights, along, second);
    double speed = glm::length(page_velocity(at, way));
    if (!(speed > 0)) return false;
    Exit exit = exit_of(place, way);
    if (!std::isfinite(exit.length)) return false;
    if (exit.length > 0) {  // use the direction in the middle of the step
      const FormPlace middle = moved(place, way * (std::min(step_mm / speed, exit.length) / 2));
      const Point3 better = field.onward(mesh_, middle.triangle, middle.weights, way, second);
      const Exit better_exit = exit_of(place, better);
      if (better_exit.length > 0 && std::isfinite(better_exit.length)) {
        way = better;
        exit = better_exit;
        speed = glm::length(page_velocity(at, way));
        if (!(speed > 0)) return false;
      }
    }
    along = way;
    const Point2 before = place.page;
    if (!advance(place, way, exit, step_mm / speed)) return false;
    if (place.page != before) return true;
  }
  return false;
}

bool FormWalk::cross(FormPlace& place, Point2 direction, double length_mm) const {
  int turns = 0;
  double rest = length_mm;
  while (rest > 0) {
    const Point3 at = point(place), e1 = glm::normalize(mesh_.point(place.triangle, 1) - mesh_.point(place.triangle, 0));
    const Point3 area = mesh_.area_vector(place.triangle), e2 = glm::normalize(glm::cross(area, e1));
    const Point2 v1 = page_velocity(at, e1), v2 = page_velocity(at, e2);
    const double det = v1.x * v2.y - v1.y * v2.x;
    if (det == 0) return false;
    const Point3 way = e1 * ((direction.x * v2.y - direction.y * v2.x) / det) +
                       e2 * ((v1.x * direction.y - v1.y * direction.x) / det);  // one mm on the page per unit of length
    const Exit exit = exit_of(place, way);
    if (!std::isfinite(exit.length)) return false;
    const Point2 before = place.page;
    if (!advance(place, way, exit, rest)) return false;
    rest -= exit.length > rest ? rest : exit.length;
    turns = place.page == before ? turns + 1 : 0;
    if (turns > kMostTurns) return false;
  }
  return true;
}

std::uint64_t grid_cell(std::int32_t column, std::int32_t row) {
  return std::uint64_t{static_cast<std::uint32_t>(column)} << 32 | static_cast<std::uint32_t>(row);
}

std::uint64_t FormRegions::cell(double x, double y) const {
  return grid_cell(static_cast<std::int32_t>(std::floor(x / cell_mm_)), static_cast<std::int32_t>(std::floor(y / cell_mm_)));
}

FormRegions::FormRegions(const Scene& scene, const FormMesh& mesh, const View& view, std::span<const Region> regions,
                         double cell_mm)
    : regions_(regions),
      of_face_(scene.faces.size(),
               [&](const auto& put) {
                 for (std::uint32_t r = 0; r < regions.size(); ++r) {
                   if (regions[r].level == 0) put(regions[r].face, r);
                 }
               }),
      cell_mm_(cell_mm) {
  std::vector<Point2> page;
  for (const Point3& point : mesh.points) {
    const HomogeneousPoint p = to_homogeneous(view, point);
    page.push_back({p.x / p.w, p.y / p.w});
  }
  for (std::uint32_t face = 0; face < scene.faces.size(); ++face) {
    if (!of_face_[face].empty()) add_rims(mesh, page, face);
  }
}

void FormRegions::add_rim(const Rim& rim) {
  const auto number = static_cast<std::uint32_t>(rims_.size());
  rims_.push_back(rim);
  const auto index = [this](double v) { return static_cast<std::int32_t>(std::floor(v / cell_mm_)); };
  // Splits the rim into pieces no longer than a cell, so that a long slanting rim is not listed in all cells of its
  // bounding box.
  const int pieces = 1 + static_cast<int>(glm::distance(rim.from, rim.to) / cell_mm_);
  for (int i = 0; i < pieces; ++i) {
    const Point2 a = rim.from + (rim.to - rim.from) * (double(i) / pieces);
    const Point2 b = rim.from + (rim.to - rim.from) * (double(i + 1) / pieces);
    for (std::int32_t x = index(std::min(a.x, b.x)); x <= index(std::max(a.x, b.x)); ++x) {
      for (std::int32_t y = index(std::min(a.y, b.y)); y <= index(std::max(a.y, b.y)); ++y) {
        std::vector<std::uint32_t>& list = cells_[grid_cell(x, y)];
        if (list.empty() || list.back() != number) list.push_back(number);
      }
    }
  }
}

/// Collects the sides of a face's regions as rims, except sides over which the visible surface continues: to a
/// neighbour that also faces the viewer, or to another region of the face, where a shadow ends.
void FormRegions::add_rims(const FormMesh& mesh, std::span<const Point2> page, std::uint32_t face) {
  std::vector<Rim> open;  // sides of the face over which the surface continues
  for (std::uint32_t t = mesh.first[face]; t < mesh.first[face + 1]; ++t) {
    const FormTriangle& triangle = mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t next = triangle.across[k];
      if (next == kNone || mesh.triangles[next].face == face) continue;
      const std::uint32_t ends[] = {triangle.node[k], triangle.node[(k + 1) % 3]};
      const int corners[] = {corner_at(mesh, next, ends[0]), corner_at(mesh, next, ends[1])};
      if (corners[0] < 0 || corners[1] < 0) continue;
      const Point2 a = page[ends[0]], b = page[ends[1]], mine = page[triangle.node[(k + 2) % 3]],
                   other = page[mesh.triangles[next].node[static_cast<std::size_t>(3 - corners[0] - corners[1])]];
      // A neighbour on the same side faces away.
      if ((cross(b - a, mine - a) > 0) != (cross(b - a, other - a) > 0)) open.push_back({a, b});
    }
  }
  const auto goes_on = [&](Point2 a, Point2 b) {
    return std::any_of(open.begin(), open.end(), [&](const Rim& side) {
      return distance_to(a, side.from, side.to) <= kTouchMm && distance_to(b, side.from, side.to) <= kTouchMm;
    });
  };
  const bool several = of_face_[face].size() > 1;
  for (const std::uint32_t number : of_face_[face]) {
    for (const auto& contour : regions_[number].contours) {
      for (std::size_t i = 0, before = contour.size() - 1; i < contour.size(); before = i++) {
        const Point2 a = contour[before], b = contour[i];
        if (goes_on(a, b)) continue;
        const double length = glm::distance(a, b);
        if (several && length > 0) {
          const Point2 beside = Point2{b.y - a.y, a.x - b.x} * (2 * kTouchMm / length), middle = (a + b) * 0.5;
          if (region_at(face, middle + beside) && region_at(face, middle - beside)) continue;
        }
        add_rim({a, b});
      }
    }
  }
}

std::optional<std::uint32_t> FormRegions::region_at(std::uint32_t face, Point2 page_mm) const {
  for (const std::uint32_t number : of_face_[face]) {
    if (contains(regions_[number], page_mm)) return number;
  }
  return std::nullopt;
}

std::uint32_t FormRegions::region_near(std::uint32_t face, Point2 page_mm) const {
  const auto list = of_face_[face];
  return list.size() == 1 ? list.front() : region_at(face, page_mm).value_or(list.front());
}

double FormRegions::seen_until(std::uint32_t face, Point2 from, Point2 to) const {
  const Point2 way = to - from;
  const double length = glm::length(way);
  std::vector<double> cuts{0, 1};
  for (const std::uint32_t number : of_face_[face]) {
    for (const auto& contour : regions_[number].contours) {
      for (std::size_t i = 0, before = contour.size() - 1; i < contour.size(); before = i++) {
        const Point2 side = contour[i] - contour[before];
        const double turn = cross(way, side);
        if (turn == 0) continue;
        const double on_side = cross(contour[before] - from, way) / turn, at = cross(contour[before] - from, side) / turn;
        if (at > 0 && at < 1 && on_side >= 0 && on_side <= 1) cuts.push_back(at);
      }
    }
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if ((cuts[i] - cuts[i - 1]) * length <= kTouchMm) continue;
    if (!region_at(face, from + way * ((cuts[i - 1] + cuts[i]) / 2))) return cuts[i - 1];
  }
  return 1;
}

bool FormRegions::near_rim(Point2 page_mm, double distance_mm) const {
  const auto reach = static_cast<int>(std::ceil(distance_mm / cell_mm_));
  for (int dx = -reach; dx <= reach; ++dx) {
    for (int dy = -reach; dy <= reach; ++dy) {
      const auto found = cells_.find(cell(page_mm.x + dx * cell_mm_, page_mm.y + dy * cell_mm_));
      if (found == cells_.end()) continue;
      for (const std::uint32_t number : found->second) {
        if (distance_to(page_mm, rims_[number].from, rims_[number].to) < distance_mm) return true;
      }
    }
  }
  return false;
}

std::optional<Point2> FormRegions::point_inside(const Region& region) {
  double low = 1e300, high = -1e300;
  for (const Point2 p : region.contours.front()) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  const double y = (low + high) / 2;
  std::vector<double> crossings;
  for (const auto& contour : region.contours) {
    for (std::size_t i = 0, before = contour.size() - 1; i < contour.size(); before = i++) {
      const Point2 a = contour[before], b = contour[i];
      if ((a.y > y) != (b.y > y)) crossings.push_back(a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)));
    }
  }
  std::sort(crossings.begin(), crossings.end());
  std::optional<Point2> widest;
  double width = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if (crossings[i + 1] - crossings[i] <= width) continue;
    width = crossings[i + 1] - crossings[i];
    widest = Point2{(crossings[i] + crossings[i + 1]) / 2, y};
  }
  return widest;
}

}  // namespace ligne
