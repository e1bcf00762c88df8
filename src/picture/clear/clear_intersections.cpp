#include "picture/clear/tidy_strokes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <numbers>
#include <utility>
#include <vector>

#include "picture/clear/rim_lines.hpp"
#include "scene/contacts/chord_errors.hpp"
#include "scene/contacts/face_contact.hpp"
#include "scene/model/face_area.hpp"
#include "scene/model/topology.hpp"

namespace ligne {
namespace {

/// Returns the faces of the intersections, ascending.
std::vector<std::uint32_t> faces_of(const std::vector<SourceEdge>& segments) {
  std::vector<std::uint32_t> faces;
  for (const SourceEdge& s : segments) {
    if (s.intersection) faces.insert(faces.end(), s.faces.begin(), s.faces.end());
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

/// Returns the faces and their neighbours.
std::vector<std::uint32_t> with_neighbours(const Scene& scene, std::vector<std::uint32_t> faces) {
  const FaceNeighbours neighbours(scene, faces);
  neighbours.for_each_pair([&](std::uint32_t a, std::uint32_t b, std::uint32_t, std::uint32_t) {
    faces.insert(faces.end(), {a, b});
  });
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

/// Adjustable, 10 degrees in radians: surfaces that cross at a larger angle have a line there, as planes do that meet at it.
constexpr double kEdgeAngle = std::numbers::pi / 18;
/// Distance of two chords of width w that cross at twice their bend b within their width, 2 w b, by the sum of their
/// errors, 2 w/2 tan(b/4).
constexpr double kGrazingErrors = 8;
/// Adjustable: least ratio of the length of a sliver to its height.
constexpr double kSliver = 8;

/// The distances of the faces of a scene from their shapes, and the angles by which these turn over a face.
class ContactErrors {
 public:
  /// `errors`: those of the faces that will be asked for, and of their neighbours.
  ContactErrors(const Scene& scene, const Patches& patches, const ChordErrors& errors)
      : scene_(scene), patches_(patches), errors_(errors) {}

  /// Distance within which two faces that cross only touch.
  double contact_distance(const std::array<std::uint32_t, 2>& faces) const {
    const double error = errors_.of(faces[0]) + errors_.of(faces[1]);
    if (error == 0) return 0;
    const double precision = object_precision(scene_, faces[0]) + object_precision(scene_, faces[1]);
    const Turn a = turn_of(faces[0]), b = turn_of(faces[1]);
    // The shapes behind the faces may run side by side where these cross at an angle no larger than the shapes turn.
    const double sine = glm::length(glm::cross(face_normal(scene_, faces[0]), face_normal(scene_, faces[1])));
    if (sine > std::sin(std::min(a.angle + b.angle, kEdgeAngle))) return error + precision;
    return kGrazingErrors * (a.error + b.error) + precision;
  }

 private:
  struct Turn {
    double angle = 0, error = 0;
  };

  /// The turn of the shape over a face. Beside a sliver that lies on no recognised surface, as one of a fan across a dome,
  /// the shape bends along the sliver as it does across.
  Turn turn_of(std::uint32_t face) const {
    const Turn across{errors_.bend(face), errors_.of(face)};
    if (patches_.patch_of.size() > face && patches_.patch_of[face] != kNone) return across;
    double length = 0;
    for_each_edge(scene_, face, [&](std::uint32_t v, std::uint32_t w) {
      length = std::max(length, glm::distance(scene_.vertices[v], scene_.vertices[w]));
    });
    const double area = glm::length(double_area(scene_, face));
    if (!(length * length > kSliver * area)) return across;
    const double angle = std::min(across.angle * length * length / area, kEdgeAngle);
    return {std::max(across.angle, angle), std::max(across.error, length / 2 * std::tan(angle / 4))};
  }

  const Scene& scene_;
  const Patches& patches_;
  const ChordErrors& errors_;
};

/// Per segment whether its faces only touch.
std::vector<bool> find_contacts(const Scene& scene, const std::vector<SourceEdge>& segments, const ContactErrors& errors) {
  std::vector<bool> contact(segments.size(), false);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const SourceEdge& s = segments[i];
    if (!s.intersection) continue;
    const double distance = errors.contact_distance(s.faces);
    contact[i] = distance > 0 && within_distance(scene, s.faces, s.ends, distance);
  }
  return contact;
}

}  // namespace

void clear_intersections(StrokeModel& model, const Scene& scene, const ProjectedScene& projected, const LineRequest& request,
                         const Patches& patches, RunReport& run) {
  if (request.quality == Quality::exact || model.intersections.empty()) return;
  std::vector<std::uint32_t> faces = with_neighbours(scene, faces_of(model.intersections));
  const FaceNeighbours neighbours(scene, faces);
  const ChordErrors errors(scene, neighbours, std::move(faces), request.crease_degrees);
  const std::vector<bool> contact = find_contacts(scene, model.intersections, ContactErrors(scene, patches, errors));
  const RimLines rims(scene, neighbours, errors, model.intersections, request.crease_degrees);

  const std::size_t segments = model.intersections.size();
  std::vector<bool> on_rim(segments, false);
  std::vector<Stroke> strokes, pieces;
  std::swap(strokes, model.strokes);
  for (const Stroke& s : strokes) {
    const std::size_t i = s.source - std::size_t{model.edge_count};
    if (s.source < model.edge_count || !model.intersections[i].intersection) {
      model.strokes.push_back(s);
    } else if (!contact[i]) {
      pieces = rims.pieces(model, s, projected.view, request.studied());
      on_rim[i] = on_rim[i] || !pieces.empty();
      if (pieces.empty()) pieces.push_back(s);
      model.strokes.insert(model.strokes.end(), pieces.begin(), pieces.end());
    }
  }
  const auto count_of = [](const std::vector<bool>& which) {
    return static_cast<std::uint64_t>(std::count(which.begin(), which.end(), true));
  };
  run.count_clear("intersections of surfaces that touch", count_of(contact));
  run.count_clear("intersections along rims", count_of(on_rim));
}

}  // namespace ligne
