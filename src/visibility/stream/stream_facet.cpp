#include "visibility/stream/stream_facet.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "base/hash.hpp"
#include "view/clip.hpp"
#include "view/edge_classes.hpp"
#include "view/edge_on.hpp"
#include "view/tolerances.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {
namespace {

/// Factor on the sine of the "edge on" angle: a face seen at a smaller angle than that is odd.
constexpr double kOddSines = 64;
/// Least height of a plain facet on the page, in coincidence tolerances. Merging of vertices may move a corner by one
/// tolerance; a facet of this height then keeps its kind, and its depth tolerance grows by at most half.
constexpr double kHeightInCoincidences = 4;
/// Factor on the depth tolerance in the padding of depths: more than it grows.
constexpr double kToleranceGrowth = 2;
/// Padding of depths and of the margin of squares, in coincidence tolerances.
constexpr double kPadInCoincidences = 4;

constexpr double kUnit = 127;  ///< scale of the bytes of looks

Point3 triangle_normal(const Point3* p) {
  const Point3 sum = glm::cross(p[1] - p[0], p[2] - p[0]);
  const double length = glm::length(sum);
  return length > 0 ? sum / length : Point3{0, 0, 0};
}

}  // namespace

std::uint64_t place_number(const Point3& p) {
  return mix_bits(mix_bits(mix_bits(bits_of_number(p.x) + kGoldenRatio) + bits_of_number(p.y)) + bits_of_number(p.z));
}

std::uint64_t packed_look(const Point3& unit_normal, std::uint64_t bits) {
  std::uint64_t packed = bits;
  for (int k = 0; k < 6; ++k) {
    const double component = k % 2 == 0 ? unit_normal[k / 2] : -unit_normal[k / 2];
    packed |= static_cast<std::uint64_t>(std::clamp(std::ceil(component * kUnit) + kUnit, 0.0, 2 * kUnit)) << (8 * k);
  }
  return packed;
}

std::uint64_t put_together(std::uint64_t a, std::uint64_t b) {
  std::uint64_t result = (a | b) & ~((std::uint64_t{1} << 48) - 1);
  for (int k = 0; k < 48; k += 8) result |= std::max(a >> k & 0xff, b >> k & 0xff) << k;
  return result;
}

bool look_alike(std::uint64_t looks, double crease_cosine) {
  if (looks & kLooksOdd) return false;
  if (((looks & kLooksHere) != 0) == ((looks & kLooksAway) != 0)) return false;
  if (((looks & kLooksRight) != 0) == ((looks & kLooksLeft) != 0)) return false;
  double square = 0;  // bound on the squared distance of two normals: |a - b|^2 = 2 - 2 a b
  for (int k = 0; k < 48; k += 16) {
    const double highest = static_cast<double>(looks >> k & 0xff) - kUnit;
    const double lowest = kUnit - static_cast<double>(looks >> (k + 8) & 0xff);
    square += (highest - lowest) * (highest - lowest) / (kUnit * kUnit);
  }
  constexpr double kFloatRounding = 0x1p-20;  // normals are compared as floats
  return 1 - square / 2 > crease_cosine + kFloatRounding;
}

StreamFacets::StreamFacets(const View& view, double precision, double largest, double near, double far)
    : precision_(precision), sight_rounding_(ligne::view_rounding(view.camera, largest)), near_(near) {
  page_.view = view;
  page_.lattice = page_lattice(view);
  page_.input_error_mm = projected_error_mm(view, precision, largest);
  per_mm_ = far > near ? kSlices / (far - near) : 0;
  const double coincidence = coincidence_mm(page_), steps = coincidence / page_.lattice.step_mm;
  pad_mm_ = kPadInCoincidences * coincidence;
  least_height_ = std::ceil(kHeightInCoincidences * steps) + 1;
  margin_ = 2 * static_cast<std::int64_t>(std::ceil(kPadInCoincidences * steps) + 2);
}

std::uint8_t StreamFacets::slice(double z) const {
  return static_cast<std::uint8_t>(std::clamp((z - near_) * per_mm_, 0.0, double{kSlices - 1}));
}

std::array<double, 3> StreamFacets::page_place(const Point3& p) const {
  const HomogeneousPoint h = to_homogeneous(page_.view, p);
  return {h.x / h.w, h.y / h.w, h.z / h.w};
}

StreamFacet StreamFacets::make(const Point3* corners) const {
  StreamFacet facet;
  if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) return facet;
  const ClipVolume volume = line_volume(page_.view, page_.lattice);
  std::array<double, 3> z{};
  for (std::size_t k = 0; k < 3; ++k) {
    const HomogeneousPoint h = to_homogeneous(page_.view, corners[k]);
    if (!volume.contains(h)) {
      facet.kind = StreamFacet::Kind::outside;
      return facet;
    }
    facet.p[k] = page_.lattice.snap({h.x / h.w, h.y / h.w});
    z[k] = h.z / h.w;
    facet.corner[k] = place_number(corners[k]);
  }
  const Camera& camera = page_.view.camera;
  const Point3 normal = triangle_normal(corners);
  const Point3 sight = camera.perspective ? corners[0] - camera.eye : camera.forward;
  const double facing = glm::dot(normal, sight);
  const double z_near = std::min({z[0], z[1], z[2]}), z_far = std::max({z[0], z[1], z[2]});
  const double area = orientation(facet.p[0], facet.p[1], facet.p[2]);
  const LatticePoint a = facet.p[0], b = facet.p[1], c = facet.p[2];
  const double abx = double(b.x) - a.x, aby = double(b.y) - a.y, acx = double(c.x) - a.x, acy = double(c.y) - a.y;
  const double size =
      std::max({std::abs(abx) + std::abs(aby), std::abs(acx) + std::abs(acy), std::abs(acx - abx) + std::abs(acy - aby)});
  const bool odd = std::abs(facing) <= kOddSines * kEdgeOnSine * glm::length(sight) ||
                   std::abs(area) <= least_height_ * size ||
                   is_seen_edge_on(corners[0], corners[1], corners[2], camera, precision_, sight_rounding_);
  facet.kind = odd ? StreamFacet::Kind::odd : StreamFacet::Kind::plain;
  double pad = pad_mm_;
  if (area != 0) {
    const double zb = z[1] - z[0], zc = z[2] - z[0];
    const double gradient = (std::abs(zb * acy - zc * aby) + std::abs(zc * abx - zb * acx)) / std::abs(area);
    pad += kToleranceGrowth * depth_tolerance_mm(page_, gradient, z_near);
  }
  facet.nearest = slice(z_near - pad);
  facet.farthest = slice(z_far + pad);
  if (odd) {
    facet.looks = kLooksOdd;
    return facet;
  }
  facet.looks = packed_look(normal, (facing < 0 ? kLooksHere : kLooksAway) | (area > 0 ? kLooksRight : kLooksLeft));
  if (area < 0) {
    std::swap(facet.p[1], facet.p[2]);
    std::swap(facet.corner[1], facet.corner[2]);
  }
  return facet;
}

}  // namespace ligne
