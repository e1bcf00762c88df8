#include "picture/clear/rim_lines.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "base/no_index.hpp"
#include "geometry/degrees.hpp"
#include "geometry/nearest_on_segment.hpp"
#include "scene/contacts/face_contact.hpp"
#include "scene/model/topology.hpp"

namespace ligne {
namespace {

/// Whether the face is turned towards the viewer.
bool looks_at(const Scene& scene, std::uint32_t face, const Camera& camera) {
  const Point3 sight = camera.perspective ? scene.vertices[scene.faces.contour(face, 0)[0]] - camera.eye : camera.forward;
  return glm::dot(face_normal(scene, face), sight) < 0;
}

Point3 between(const Point3& a, const Point3& b, double t) { return a + t * (b - a); }

}  // namespace

std::vector<RimLines::Rim> RimLines::find_rims(const Scene& scene, const FaceNeighbours& neighbours,
                                               const ChordErrors& errors, const std::vector<SourceEdge>& segments,
                                               double smooth_degrees) {
  std::vector<std::uint32_t> faces;
  for (const SourceEdge& s : segments) {
    if (!s.intersection) continue;
    for (int k = 0; k < 2; ++k) {
      if (errors.of(s.faces[1 - k]) > 0) faces.push_back(s.faces[k]);
    }
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  const double smooth = 2 * sine_cosine_degrees(smooth_degrees / 2).sine;
  std::vector<Rim> rims;
  for (const std::uint32_t face : faces) {
    const Point3 normal = face_normal(scene, face);
    for_each_edge(scene, face, [&](std::uint32_t v, std::uint32_t w) {
      const std::uint32_t other = neighbours.across(face, v, w);
      if (other != kNone && glm::distance(face_normal(scene, other), normal) <= smooth) return;
      rims.push_back({std::min(v, w), std::max(v, w), face, other, other == kNone ? 0 : errors.of(other)});
    });
  }
  return rims;
}

std::vector<EdgeTree::Segment> RimLines::places_of(const Scene& scene, const std::vector<Rim>& rims) {
  std::vector<EdgeTree::Segment> places;
  places.reserve(rims.size());
  for (const Rim& r : rims) places.push_back({scene.vertices[r.v0], scene.vertices[r.v1]});
  return places;
}

RimLines::RimLines(const Scene& scene, const FaceNeighbours& neighbours, const ChordErrors& errors,
                   const std::vector<SourceEdge>& segments, double smooth_degrees)
    : scene_(scene),
      errors_(errors),
      rims_(find_rims(scene, neighbours, errors, segments, smooth_degrees)),
      tree_(places_of(scene, rims_)) {}

std::optional<RimLines::Place> RimLines::nearest(std::uint32_t face, double distance, const Point3& p) const {
  double widest = 0;
  const auto first =
      std::lower_bound(rims_.begin(), rims_.end(), face, [](const Rim& r, std::uint32_t f) { return r.face < f; });
  auto last = first;
  for (; last != rims_.end() && last->face == face; ++last) widest = std::max(widest, last->distance);
  const auto begin = static_cast<std::uint32_t>(first - rims_.begin()),
             end = static_cast<std::uint32_t>(last - rims_.begin());
  const auto of_face = [&](std::uint32_t rim, double) { return begin <= rim && rim < end; };
  const NearestPoint found = tree_.nearest(p, distance + widest, of_face);
  if (found.segment == kNone || found.distance > distance + rims_[found.segment].distance) return std::nullopt;
  return Place{found.segment, found.at};
}

LineClass RimLines::line_class(const Rim& rim, const Camera& camera) const {
  if (rim.neighbour == kNone) return LineClass::border;
  return looks_at(scene_, rim.face, camera) != looks_at(scene_, rim.neighbour, camera) ? LineClass::outline
                                                                                       : LineClass::crease;
}

void RimLines::add_piece(StrokeModel& model, std::vector<Stroke>& pieces, const Stroke& stroke, const View& view,
                         const Place& begin, double to) const {
  double from = begin.at;
  if (from > to) std::swap(from, to);
  const Rim& r = rims_[begin.rim];
  const Point3 a = scene_.vertices[r.v0], b = scene_.vertices[r.v1];
  const HomogeneousPoint p = to_homogeneous(view, between(a, b, from)), q = to_homogeneous(view, between(a, b, to));
  Stroke piece = stroke;
  piece.t_from = from;
  piece.t_to = to;
  piece.from = model.lattice.snap({p.x / p.w, p.y / p.w});
  piece.to = model.lattice.snap({q.x / q.w, q.y / q.w});
  if (piece.from == piece.to) return;
  piece.z_from = static_cast<float>(p.z / p.w);
  piece.z_to = static_cast<float>(q.z / q.w);
  piece.w_from = static_cast<float>(p.w);
  piece.w_to = static_cast<float>(q.w);
  piece.source = model.edge_count + static_cast<std::uint32_t>(model.intersections.size());
  piece.line_class = line_class(r, view.camera);
  piece.needs_overlap_check = true;
  model.intersections.push_back({{a, b}, {r.face, r.neighbour}, false});
  pieces.push_back(piece);
}

std::vector<Stroke> RimLines::pieces(StrokeModel& model, const Stroke& stroke, const View& view, LineClasses classes) const {
  const SourceEdge segment = model.intersections[stroke.source - model.edge_count];
  const Point3 from = between(segment.ends[0], segment.ends[1], stroke.t_from);
  const Point3 to = between(segment.ends[0], segment.ends[1], stroke.t_to);
  std::vector<Stroke> pieces;
  for (int k = 0; k < 2; ++k) {
    const std::uint32_t face = segment.faces[k], other = segment.faces[1 - k];
    const double error = errors_.of(other);
    if (error == 0) continue;
    const double distance = error + object_precision(scene_, face) + object_precision(scene_, other);
    const auto p = nearest(face, distance, from);
    if (!p) continue;
    const auto q = nearest(face, distance, to);
    if (!q || !classes.has(line_class(rims_[p->rim], view.camera))) continue;
    if (p->rim == q->rim) {
      add_piece(model, pieces, stroke, view, *p, q->at);
      return pieces;
    }
    const Rim &r = rims_[p->rim], &s = rims_[q->rim];
    const bool at_v0 = r.v0 == s.v0 || r.v0 == s.v1, at_v1 = r.v1 == s.v0 || r.v1 == s.v1;
    if (at_v0 == at_v1) continue;
    const std::uint32_t corner = at_v0 ? r.v0 : r.v1;
    // At the tip of a narrow face the two ends may lie near two rims that meet far away, or that turn back there.
    const Point3 turn = scene_.vertices[corner];
    const double farthest = distance + std::max(r.distance, s.distance);
    const Point3 nearest_of_piece = between(from, to, nearest_on_segment(turn, from, to));
    if (glm::distance(turn, nearest_of_piece) > farthest || glm::dot(from - turn, to - turn) > 0) continue;
    add_piece(model, pieces, stroke, view, *p, at_v0 ? 0 : 1);
    add_piece(model, pieces, stroke, view, {q->rim, corner == s.v0 ? 0.0 : 1.0}, q->at);
    return pieces;
  }
  return pieces;
}

}  // namespace ligne
