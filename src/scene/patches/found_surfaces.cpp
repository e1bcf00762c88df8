#include "scene/patches/found_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <span>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

constexpr double kWholeTurn = 2 * std::numbers::pi;
/// Largest gap between facets, in radians, that may come from rounding the angles of one corner.
constexpr double kAngleRounding = 1e-9;
/// Components of an axis below this are rounding errors of a unit vector.
constexpr double kUnitRounding = 1e-15;
/// A corner nearer to the axis than this part of its face's largest distance is the tip of a cone and has no angle.
constexpr double kTipPart = 1e-3;
/// Least rise of an arc over its chord, in radii, by which an uncertainty is divided: arcs of two degrees determine no
/// radius.
constexpr double kLeastRise = 1e-4;

struct AngleSpan {
  double from = 0, to = 0;  ///< radians, `from` in [-pi, pi]
};

/// Part of the turn that spans cover, in radians.
double covered_turn(std::vector<AngleSpan>& spans) {
  if (spans.empty()) return 0;
  const auto begins_first = [](const AngleSpan& l, const AngleSpan& r) {
    return l.from != r.from ? l.from < r.from : l.to < r.to;
  };
  std::sort(spans.begin(), spans.end(), begins_first);
  // A span that runs over the end of the turn covers its beginning too.
  double reach = spans.front().from;
  for (const AngleSpan& span : spans) reach = std::max(reach, span.to - kWholeTurn);
  double gaps = 0;
  for (const AngleSpan& span : spans) {
    if (span.from - reach > kAngleRounding) gaps += span.from - reach;
    reach = std::max(reach, span.to);
  }
  const double last = spans.front().from + kWholeTurn - reach;
  if (last > kAngleRounding) gaps += last;
  return kWholeTurn - gaps;
}

template <class Visit>
void for_corners_of(const Scene& scene, std::span<const std::uint32_t> faces, Visit visit) {
  for (const std::uint32_t f : faces) {
    for (const std::uint32_t v : corners_of(scene.faces, f)) visit(scene.vertices[v]);
  }
}

/// Measures the faces of one patch.
class PatchMeasure {
 public:
  PatchMeasure(const Scene& scene, const Patch& patch, std::span<const std::uint32_t> faces) : scene_(scene), faces_(faces) {
    found_.surface = patch.surface;
    found_.outward = patch.outward;
    found_.sag = patch.sag;
    found_.faces = faces.size();
  }

  FoundSurface run(const Object& object) {
    turn_axis();
    if (found_.has_length()) begin_at_faces();
    surface_.profile.reset();  // it has another frame now
    if (!found_.has_radius()) return found_;
    found_.error = 2 * std::max(median_distance(), object.precision / 2) / std::clamp(rise(), kLeastRise, 1.0);
    return found_;
  }

 private:
  /// Gives the axis a direction that does not depend on the fit.
  void turn_axis() {
    if (!found_.has_axis()) return;
    for (int c = 0; c < 3; ++c) {
      if (std::abs(surface_.axis[c]) < kUnitRounding) surface_.axis[c] = 0;
    }
    for (int c = 0; c < 3; ++c) {
      if (std::abs(surface_.axis[c]) <= 0.5) continue;
      if (surface_.axis[c] < 0) {
        surface_.axis = Point3(0, 0, 0) - surface_.axis;  // unlike a negation, this leaves zeros positive
        surface_.slope = -surface_.slope;
      }
      return;
    }
  }

  void begin_at_faces() {
    double first = 0, last = 0;
    bool is_first = true;
    for_corners_of(scene_, faces_, [&](const Point3& p) {
      const double along = axis_place(surface_, p).along;
      first = is_first ? along : std::min(first, along);
      last = is_first ? along : std::max(last, along);
      is_first = false;
    });
    surface_.at += first * surface_.axis;
    // At the tip of a cone, rounding may leave a negative radius.
    surface_.radius = std::max(0.0, surface_.radius + first * surface_.slope);
    found_.along = {0, last - first};
    if (found_.has_turn()) found_.turn = std::min(360.0, arc(false) / kWholeTurn * 360);
  }

  /// The arc that faces cover about the axis, or about the middle circle of a torus, in radians.
  double arc(bool about_circle) const {
    const std::array<Point3, 2> frame = frame_of(surface_.axis);
    std::vector<AngleSpan> spans;
    std::vector<std::array<double, 2>> places;  // angle, distance from the axis or the circle
    for (const std::uint32_t f : faces_) {
      places.clear();
      double farthest = 0;
      for_corners_of(scene_, std::span(&f, 1), [&](const Point3& p) {
        const AxisPlace place = axis_place(surface_, p);
        const double x = about_circle ? place.radius - surface_.radius : place.radius * glm::dot(place.out, frame[0]);
        const double y = about_circle ? place.along : place.radius * glm::dot(place.out, frame[1]);
        places.push_back({std::atan2(y, x), std::hypot(x, y)});
        farthest = std::max(farthest, places.back()[1]);
      });
      std::erase_if(places, [&](const auto& place) { return !(place[1] > kTipPart * farthest); });
      if (places.empty()) continue;
      AngleSpan span{places[0][0], places[0][0]};
      for (const auto& place : places) {
        const double angle = places[0][0] + std::remainder(place[0] - places[0][0], kWholeTurn);
        span = {std::min(span.from, angle), std::max(span.to, angle)};
      }
      if (span.from < -std::numbers::pi) span = {span.from + kWholeTurn, span.to + kWholeTurn};
      spans.push_back(span);
    }
    return covered_turn(spans);
  }

  double median_distance() const {
    std::vector<double> distances;
    for_corners_of(scene_, faces_, [&](const Point3& p) { distances.push_back(std::abs(surface_.distance(p))); });
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
  }

  /// Rise over its chord, in radii, of the arc or the cap that determines the radius; 1 for half a turn.
  double rise() const {
    if (surface_.kind != SurfaceKind::sphere) return rise_of_arc(arc(surface_.kind == SurfaceKind::torus));
    Point3 sum(0, 0, 0);
    for_corners_of(scene_, faces_, [&](const Point3& p) { sum += p - surface_.at; });
    const double length = glm::length(sum);
    if (!(length > 0)) return 1;
    double least = 1;
    for_corners_of(scene_, faces_,
                   [&](const Point3& p) { least = std::min(least, glm::dot(surface_.normal(p), sum) / length); });
    return 1 - least;
  }

  static double rise_of_arc(double arc) { return 1 - std::cos(std::min(arc, std::numbers::pi) / 2); }

  const Scene& scene_;
  std::span<const std::uint32_t> faces_;
  FoundSurface found_;
  PatchSurface& surface_ = found_.surface;
};

}  // namespace

FoundSurfaces found_surfaces(const Scene& scene, const Patches& patches) {
  FoundSurfaces found;
  if (patches.list.empty()) return found;
  std::vector<std::vector<std::uint32_t>> faces(patches.list.size());
  for (std::uint32_t f = 0; f < patches.patch_of.size(); ++f) {
    if (patches.patch_of[f] != kNone) faces[patches.patch_of[f]].push_back(f);
  }
  // Patches that became part of another one have no faces.
  std::vector<std::uint32_t> number(faces.size(), kNone), with_faces;
  for (std::uint32_t p = 0; p < faces.size(); ++p) {
    if (faces[p].empty()) continue;
    number[p] = static_cast<std::uint32_t>(with_faces.size());
    with_faces.push_back(p);
  }
  found.list.resize(with_faces.size());
  parallel_for(with_faces.size(), [&](std::size_t i) {
    const std::uint32_t p = with_faces[i];
    const auto owner = std::ranges::upper_bound(scene.objects, faces[p].front(), {}, &Object::face_end);
    found.list[i] = PatchMeasure(scene, patches.list[p], faces[p]).run(*owner);
    found.list[i].object = static_cast<std::uint32_t>(owner - scene.objects.begin());
  });
  found.of_face.assign(scene.faces.size(), kNone);
  for (std::uint32_t f = 0; f < patches.patch_of.size(); ++f) {
    if (patches.patch_of[f] != kNone) found.of_face[f] = number[patches.patch_of[f]];
  }
  return found;
}

}  // namespace ligne
