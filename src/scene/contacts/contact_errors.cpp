#include "scene/contacts/contact_errors.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/no_index.hpp"
#include "scene/model/faces_and_edges.hpp"

namespace ligne {
namespace {

/// Adjustable, 10 degrees in radians: surfaces that cross at a larger angle have a line there, as planes do that meet at it.
constexpr double kEdgeAngle = std::numbers::pi / 18;
/// Distance of two chords of width w that cross at twice their bend b within their width, 2 w b, by the sum of their
/// errors, 2 w/2 tan(b/4).
constexpr double kGrazingErrors = 8;
/// Adjustable: least ratio of the length of a sliver to its height.
constexpr double kSliverRatio = 8;

}  // namespace

bool ContactErrors::is_contact(const std::array<std::uint32_t, 2>& faces, const std::array<Point3, 2>& segment) const {
  const double distance = contact_distance(faces);
  return distance > 0 && within_distance(scene_, faces, segment, distance);
}

/// Distance within which two faces that cross only touch.
double ContactErrors::contact_distance(const std::array<std::uint32_t, 2>& faces) const {
  const double error = errors_.of(faces[0]) + errors_.of(faces[1]);
  if (error == 0) return 0;
  const double precision = object_precision(scene_, faces[0]) + object_precision(scene_, faces[1]);
  const Turn a = turn_of(faces[0]), b = turn_of(faces[1]);
  // The shapes behind the faces may run side by side where these cross at an angle no larger than the shapes turn.
  const double sine = glm::length(glm::cross(face_normal(scene_, faces[0]), face_normal(scene_, faces[1])));
  if (sine > std::sin(std::min(a.angle + b.angle, kEdgeAngle))) return error + precision;
  return kGrazingErrors * (a.error + b.error) + precision;
}

/// The turn of the shape over a face. Beside a sliver that lies on no recognised surface, as one of a fan across a dome,
/// the shape bends along the sliver as it does across.
ContactErrors::Turn ContactErrors::turn_of(std::uint32_t face) const {
  const Turn across{errors_.bend(face), errors_.of(face)};
  if (patch_of_.size() > face && patch_of_[face] != kNone) return across;
  double length = 0;
  for_sides(scene_.faces, face, [&](std::uint32_t v, std::uint32_t w) {
    length = std::max(length, glm::distance(scene_.vertices[v], scene_.vertices[w]));
  });
  const double area = glm::length(double_area(scene_, face));
  if (!(length * length > kSliverRatio * area)) return across;
  const double angle = std::min(across.angle * length * length / area, kEdgeAngle);
  return {std::max(across.angle, angle), std::max(across.error, length / 2 * std::tan(angle / 4))};
}

}  // namespace ligne
