#include "sight.hpp"

#include "rays_of_embree.hpp"

namespace ligne::check {

namespace {

/// Error of each coordinate is at most the tolerance, so two points that should be one are up to sqrt(3) times the sum of
/// their tolerances apart.
constexpr double kStrictFactor = 2;
/// A program may add the rounding of its own projection to that, and measure along the sight.
constexpr double kGenerousFactor = 16;
/// Boxes are widened by this much: sixteen roundings of a float32 coordinate, against the rounding of the rays.
constexpr float kBoxPad = 0x1p-20f;
/// A float32 ray starts this much behind its point, so that rounding cannot make it miss the box of what is just before it.
constexpr double kStartBehind = 0x1p-19;

struct Query {
  RayContext context;
  Point3 origin, direction, u, v;  ///< u, v: a frame of the plane at right angles to the ray
  double length;
  double tolerance;
  Touching touching;
  Hit nearest{0, std::numeric_limits<double>::infinity(), {0, 0, 0}};
};

void set_direction(Query& query, const Point3& direction) {
  query.direction = direction;
  const Point3 away = std::abs(direction.x) < 0.6 ? Point3{1, 0, 0} : Point3{0, 1, 0};
  query.u = glm::normalize(glm::cross(direction, away));
  query.v = glm::cross(direction, query.u);
}

Query query_to_viewer(const PageMap& map, const Point3& q, double tolerance, Touching touching) {
  const Sightline line = map.to_viewer(q);
  Query query{};
  init_context(query.context);
  query.origin = q;
  query.length = line.length;
  query.tolerance = tolerance;
  query.touching = touching;
  set_direction(query, line.direction);
  return query;
}

RTCRay float_ray(const Query& query, bool start_behind) {
  const double back = start_behind ? kStartBehind : 0;
  const Point3 o = query.origin - query.direction * back;
  RTCRay ray{};
  ray.org_x = static_cast<float>(o.x), ray.org_y = static_cast<float>(o.y), ray.org_z = static_cast<float>(o.z);
  ray.dir_x = static_cast<float>(query.direction.x);
  ray.dir_y = static_cast<float>(query.direction.y);
  ray.dir_z = static_cast<float>(query.direction.z);
  ray.tnear = 0;
  ray.tfar = static_cast<float>(query.length + 2 * back);
  ray.mask = ~0u;
  return ray;
}

}  // namespace

struct Sight::Rays {
  const CheckedScene& scene;
  const PageMap& map;
  RTCDevice device = nullptr;
  RTCScene boxes = nullptr;

  /// Distance at which the ray meets the face, if it does and the face does not touch the ray's origin.
  std::optional<double> meets(std::uint32_t f, const Query& q) const {
    const CheckedFace& face = scene.faces[f];
    const double slope = glm::dot(face.normal, q.direction);
    const double apart = glm::dot(face.normal, face.middle - q.origin);
    const double tolerance = q.touching == Touching::strict ? kStrictFactor * (q.tolerance + face.tolerance)
                                                            : kGenerousFactor * 2 * scene.largest_tolerance;
    if (slope == 0 || std::abs(apart) <= tolerance) return std::nullopt;
    const double distance = apart / slope;
    if (!(distance > 0 && distance < q.length)) return std::nullopt;
    // Even-odd rule in the plane across the ray. The sides that two faces share give both the same answer to the last bit.
    bool inside = false;
    for (std::size_t c = 0; c < scene.contours->contour_count(f); ++c) {
      const auto contour = scene.contours->contour(f, c);
      Point3 p = scene.points[contour.back()] - q.origin;
      double au = glm::dot(p, q.u), av = glm::dot(p, q.v);
      for (const std::uint32_t corner : contour) {
        p = scene.points[corner] - q.origin;
        const double bu = glm::dot(p, q.u), bv = glm::dot(p, q.v);
        if ((av > 0) != (bv > 0)) {
          const double side = au * bv - bu * av;
          if ((bv > av ? side : -side) > 0) inside = !inside;
        }
        au = bu, av = bv;
      }
    }
    if (!inside) return std::nullopt;
    return distance;
  }

  static void bounds(const RTCBoundsFunctionArguments* args) {
    const auto& self = *static_cast<const Rays*>(args->geometryUserPtr);
    Point3 low{+1e300, +1e300, +1e300}, high{-1e300, -1e300, -1e300};
    for (const std::uint32_t corner : self.scene.contours->contour(args->primID, 0))
      low = glm::min(low, self.scene.points[corner]), high = glm::max(high, self.scene.points[corner]);
    RTCBounds& b = *args->bounds_o;
    b.lower_x = static_cast<float>(low.x) - kBoxPad, b.upper_x = static_cast<float>(high.x) + kBoxPad;
    b.lower_y = static_cast<float>(low.y) - kBoxPad, b.upper_y = static_cast<float>(high.y) + kBoxPad;
    b.lower_z = static_cast<float>(low.z) - kBoxPad, b.upper_z = static_cast<float>(high.z) + kBoxPad;
  }

  static void occluded(const RTCOccludedFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& self = *static_cast<const Rays*>(args->geometryUserPtr);
    const auto& query = *reinterpret_cast<const Query*>(args->context);
    if (self.meets(args->primID, query))
      reinterpret_cast<RTCRay*>(args->ray)->tfar = -std::numeric_limits<float>::infinity();
  }

  static void intersect(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    const auto& self = *static_cast<const Rays*>(args->geometryUserPtr);
    auto& query = *reinterpret_cast<Query*>(args->context);
    const auto distance = self.meets(args->primID, query);
    if (!distance || *distance >= query.nearest.distance) return;
    query.nearest = {args->primID, *distance, query.origin + query.direction * *distance};
    auto& hit = *reinterpret_cast<RTCRayHit*>(args->rayhit);
    hit.ray.tfar = static_cast<float>(*distance + kStartBehind);
    hit.hit.geomID = args->geomID, hit.hit.primID = args->primID;
  }
};

Sight::Sight(const CheckedScene& scene, const PageMap& map) : rays_(std::make_unique<Rays>(Rays{scene, map})) {
  rays_->device = rtcNewDevice(nullptr);
  if (rays_->device == nullptr) throw std::runtime_error("Embree can not be started");
  rays_->boxes = rtcNewScene(rays_->device);
  rtcSetSceneFlags(rays_->boxes, RTC_SCENE_FLAG_ROBUST);
  const RTCGeometry geometry = rtcNewGeometry(rays_->device, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(scene.faces.size()));
  rtcSetGeometryUserData(geometry, rays_.get());
  rtcSetGeometryBoundsFunction(geometry, Rays::bounds, nullptr);
  rtcSetGeometryOccludedFunction(geometry, Rays::occluded);
  rtcSetGeometryIntersectFunction(geometry, Rays::intersect);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(rays_->boxes, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(rays_->boxes);
}

Sight::~Sight() {
  rtcReleaseScene(rays_->boxes);
  rtcReleaseDevice(rays_->device);
}

bool Sight::blocked(const Point3& q, double tolerance, Touching touching) const {
  Query query = query_to_viewer(rays_->map, q, tolerance, touching);
  RTCRay ray = float_ray(query, true);
  shoot(rays_->boxes, query.context, ray);
  return ray.tfar < 0;
}

std::optional<Point3> Sight::in_front(const Point3& q, std::uint32_t face) const {
  const Query query = query_to_viewer(rays_->map, q, 0, Touching::strict);
  const auto distance = rays_->meets(face, query);
  if (!distance) return std::nullopt;
  return q + query.direction * *distance;
}

std::optional<Hit> Sight::seen_at(Point2 mm) const {
  const auto [origin, direction] = rays_->map.sight_through(mm);
  Query query{};
  init_context(query.context);
  query.origin = origin;
  query.length = std::numeric_limits<double>::infinity();
  query.touching = Touching::strict;
  query.nearest.distance = std::numeric_limits<double>::infinity();
  set_direction(query, direction);
  RTCRayHit hit{};
  hit.ray = float_ray(query, false);
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  shoot(rays_->boxes, query.context, hit);
  if (std::isinf(query.nearest.distance)) return std::nullopt;
  return query.nearest;
}

}  // namespace ligne::check
