#include "contours/surfaces/known_surfaces.hpp"

#include <glm/geometric.hpp>

#include "base/no_index.hpp"

namespace ligne {
namespace {

/// Adjustable. Least cosine between the normals of two surfaces that join smoothly (10 degrees).
constexpr double kTangentCosine = 0.985;
/// Number of bisection steps for a fraction of a segment: 2^-30 of one metre is a millionth of a millimetre.
constexpr int kBisections = 30;
/// Number of steps of the false position before them.
constexpr int kFalsePositions = 8;

}  // namespace

const Patch* surface_at(const SmoothPatch& patch, std::uint32_t triangle) {
  if (!patch.surfaces) return nullptr;
  const std::uint32_t number = patch.surfaces->patch_of[patch.triangles[triangle].face];
  return number == kNone || patch.surfaces->list[number].is_band ? nullptr : &patch.surfaces->list[number];
}

Point3 facing_normal(const Patch& surface, const Point3& p) {
  const Point3 normal = surface.surface.normal(p);
  return surface.outward ? normal : -normal;
}

NormalTurn facing_turn(const Patch& surface, const Point3& p) {
  const PatchSurface& s = surface.surface;
  const Point3 normal = s.normal(p);
  // A sphere bends equally in all directions, so any axis serves.
  const Point3 round = glm::cross(s.axis, normal);
  const double length = glm::length(round);
  const auto frame = frame_of(normal);
  const Point3 first = length > 0 ? round / length : frame[0], second = glm::cross(normal, first);
  NormalTurn turn{};
  for (const Point3& way : {first, second}) {
    const double k = (surface.outward ? 1 : -1) * s.curvature(p, way);
    const NormalTurn square{way.x * way.x, way.x * way.y, way.x * way.z, way.y * way.y, way.y * way.z, way.z * way.z};
    for (std::size_t i = 0; i < turn.size(); ++i) turn[i] += k * square[i];
  }
  return turn;
}

Point3 nearest_point(const Patch& surface, const Point3& p) {
  return p - surface.surface.distance(p) * surface.surface.normal(p);
}

std::optional<KnownNormal> known_normal(const Scene& scene, const SmoothPatch& patch,
                                        std::span<const std::uint32_t> corners) {
  const std::uint32_t c0 = corners[0];
  const Point3& at = scene.vertices[patch.triangles[c0 / 3].v[c0 % 3]];
  const Patch *const common = surface_at(patch, c0 / 3), *last = nullptr;
  bool is_one = true;
  Point3 first(0.0), sum(0.0);
  for (const std::uint32_t c : corners) {
    const Patch* surface = surface_at(patch, c / 3);
    is_one &= surface == common;
    if (!surface || surface == last) continue;
    last = surface;
    const Point3 normal = facing_normal(*surface, at);
    if (first == Point3(0.0)) first = normal;
    if (glm::dot(first, normal) < kTangentCosine) return std::nullopt;
    sum += normal;
  }
  if (!last) return std::nullopt;
  KnownNormal known{glm::normalize(sum), std::nullopt};
  if (is_one) known.turn = facing_turn(*common, at);
  return known;
}

std::optional<double> outline_crossing(const Patch& surface, const Camera& camera, const Point3& p, const Point3& q) {
  const auto facing = [&](double t) {
    const Point3 at = nearest_point(surface, p + t * (q - p));
    return glm::dot(surface.surface.normal(at), to_eye(camera, at));
  };
  double at_low = facing(0), at_high = facing(1);
  const bool first = at_low >= 0;
  if ((at_high >= 0) == first) return std::nullopt;
  // The false position, with halved values at an end that stays, leaves few of the halvings to be looked at.
  double left = 0, right = 1;
  for (int step = 0; step < kFalsePositions; ++step) {
    const double middle = left + (right - left) * at_low / (at_low - at_high);
    if (!(middle > left && middle < right)) break;
    const double here = facing(middle);
    if ((here >= 0) == first) {
      left = middle;
      at_low = here;
      at_high /= 2;
    } else {
      right = middle;
      at_high = here;
      at_low /= 2;
    }
  }
  double low = 0, high = 1;
  for (int step = 0; step < kBisections; ++step) {
    const double middle = (low + high) / 2;
    const bool is_before = middle <= left || (middle < right && (facing(middle) >= 0) == first);
    (is_before ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace ligne
