#include "picture/hatching/form_walk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
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

}  // namespace ligne
