#include "picture/clear/clear_intersections.hpp"

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

/// Whether two faces cross at an angle no larger than the bends on either side: the shapes behind them may run side by side,
/// and the line of crossing jumps from facet to facet.
bool grazes(const Scene& scene, const std::array<std::uint32_t, 2>& faces, const ChordErrors& errors) {
  const double bends = errors.bend(faces[0]) + errors.bend(faces[1]);
  const double sine = glm::length(glm::cross(face_normal(scene, faces[0]), face_normal(scene, faces[1])));
  return sine <= std::sin(std::min(bends, kEdgeAngle));
}

/// Per segment whether its faces only touch.
std::vector<bool> find_contacts(const Scene& scene, const std::vector<SourceEdge>& segments, const ChordErrors& errors) {
  std::vector<bool> contact(segments.size(), false);
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const SourceEdge& s = segments[i];
    if (!s.intersection) continue;
    const double error = errors.of(s.faces[0]) + errors.of(s.faces[1]);
    if (error == 0) continue;
    const double precision = object_precision(scene, s.faces[0]) + object_precision(scene, s.faces[1]);
    const double distance = (grazes(scene, s.faces, errors) ? kGrazingErrors : 1) * error + precision;
    contact[i] = within_distance(scene, s.faces, s.ends, distance);
  }
  return contact;
}

}  // namespace

void clear_intersections(StrokeModel& model, const Scene& scene, const ProjectedScene& projected, const LineRequest& request,
                         RunReport& run) {
  if (request.quality == Quality::exact || model.intersections.empty()) return;
  std::vector<std::uint32_t> faces = with_neighbours(scene, faces_of(model.intersections));
  const FaceNeighbours neighbours(scene, faces);
  const ChordErrors errors(scene, neighbours, std::move(faces), request.crease_degrees);
  const std::vector<bool> contact = find_contacts(scene, model.intersections, errors);
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
  const auto count = [&](const char* name, const std::vector<bool>& which) {
    const auto n = std::count(which.begin(), which.end(), true);
    if (n > 0) run.clear.count(name, static_cast<std::uint64_t>(n));
  };
  count("intersections of surfaces that touch", contact);
  count("intersections along rims", on_rim);
}

}  // namespace ligne
