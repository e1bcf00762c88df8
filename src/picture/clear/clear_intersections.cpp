#include "picture/clear/tidy_strokes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "geometry/degrees.hpp"
#include "geometry/nearest_on_segment.hpp"
#include "scene/contacts/chord_errors.hpp"
#include "scene/heal/edge_tree.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/model/topology.hpp"

namespace ligne {
namespace {

void sort_once(std::vector<std::uint32_t>& faces) {
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

/// Returns the faces of the intersections and their neighbours, ascending.
std::vector<std::uint32_t> faces_near(const Scene& scene, const std::vector<SourceEdge>& segments) {
  std::vector<std::uint32_t> faces;
  for (const SourceEdge& s : segments) {
    if (s.intersection) faces.insert(faces.end(), s.faces.begin(), s.faces.end());
  }
  sort_once(faces);
  const FaceNeighbours neighbours(scene, faces);
  neighbours.for_each_pair([&](std::uint32_t a, std::uint32_t b, std::uint32_t, std::uint32_t) {
    faces.insert(faces.end(), {a, b});
  });
  sort_once(faces);
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

  /// Whether the faces of an intersection only touch.
  bool is_contact(const SourceEdge& s) const {
    const double distance = s.intersection ? contact_distance(s.faces) : 0;
    return distance > 0 && within_distance(scene_, s.faces, s.ends, distance);
  }

 private:
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

  struct Turn {
    double angle = 0, error = 0;
  };

  /// The turn of the shape over a face. Beside a sliver that lies on no recognised surface, as one of a fan across a dome,
  /// the shape bends along the sliver as it does across.
  Turn turn_of(std::uint32_t face) const {
    const Turn across{errors_.bend(face), errors_.of(face)};
    if (patches_.patch_of.size() > face && patches_.patch_of[face] != kNone) return across;
    double length = 0;
    for_sides(scene_.faces, face, [&](std::uint32_t v, std::uint32_t w) {
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

/// Whether the face is turned towards the viewer.
bool looks_at(const Scene& scene, std::uint32_t face, const Camera& camera) {
  const Point3 sight = camera.perspective ? scene.vertices[scene.faces.contour(face, 0)[0]] - camera.eye : camera.forward;
  return glm::dot(face_normal(scene, face), sight) < 0;
}

Point3 between(const Point3& a, const Point3& b, double t) { return a + t * (b - a); }

/// Rims near intersections. Where a pin leaves its bore, its triangles hide parts of the rim of the bore and cut the
/// face around it instead, within the distance of the triangles from the exact shapes. A piece of an intersection this
/// near to a rim is drawn as a piece of the rim. A rim is a border of one of its faces, or an edge that bends by more
/// than `smooth_degrees`.
class RimLines {
 public:
  RimLines(const Scene& scene, const FaceNeighbours& neighbours, const ChordErrors& errors,
           const std::vector<SourceEdge>& segments, double smooth_degrees);

  /// Returns one or two pieces of rims that replace a stroke of an intersection, and appends their sources to
  /// `model.intersections`. Returns none if the stroke runs along no rim, or along a rim whose class is not in
  /// `classes`.
  std::vector<Stroke> pieces(StrokeModel& model, const Stroke& stroke, const View& view, LineClasses classes) const {
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

 private:
  struct Rim {
    std::uint32_t v0, v1;
    std::uint32_t face, neighbour;
    double distance;  ///< the error of its neighbour: distance of the triangles from the exact shape
  };
  struct Place {
    std::uint32_t rim;
    double at;  ///< 0 at its v0, 1 at its v1
  };
  std::optional<Place> nearest(std::uint32_t face, double distance, const Point3& p) const;

  LineClass line_class(const Rim& rim, const Camera& camera) const {
    if (rim.neighbour == kNone) return LineClass::border;
    return looks_at(scene_, rim.face, camera) != looks_at(scene_, rim.neighbour, camera) ? LineClass::outline
                                                                                         : LineClass::crease;
  }

  /// Adds a piece between two places of one rim.
  void add_piece(StrokeModel& model, std::vector<Stroke>& pieces, const Stroke& stroke, const View& view, const Place& begin,
                 double to) const {
    double from = begin.at;
    if (from > to) std::swap(from, to);
    const Rim& r = rims_[begin.rim];
    const Point3 a = scene_.vertices[r.v0], b = scene_.vertices[r.v1];
    const auto tip_at = [&](double t) -> StrokeTip {
      const HomogeneousPoint p = to_homogeneous(view, between(a, b, t));
      return {model.lattice.snap({p.x / p.w, p.y / p.w}), static_cast<float>(p.z / p.w), static_cast<float>(p.w)};
    };
    Stroke piece = stroke_between(stroke, tip_at(from), tip_at(to));
    if (piece.from == piece.to) return;
    piece.t_from = from;
    piece.t_to = to;
    piece.source = model.edge_count + static_cast<std::uint32_t>(model.intersections.size());
    piece.line_class = line_class(r, view.camera);
    piece.needs_overlap_check = true;
    model.intersections.push_back({{a, b}, {r.face, r.neighbour}, false});
    pieces.push_back(piece);
  }

  const Scene& scene_;
  const ChordErrors& errors_;
  std::vector<Rim> rims_;
  EdgeTree tree_{{}};
};

RimLines::RimLines(const Scene& scene, const FaceNeighbours& neighbours, const ChordErrors& errors,
                   const std::vector<SourceEdge>& segments, double smooth_degrees)
    : scene_(scene), errors_(errors) {
  std::vector<std::uint32_t> faces;
  for (const SourceEdge& s : segments) {
    if (!s.intersection) continue;
    for (int k = 0; k < 2; ++k) {
      if (errors.of(s.faces[1 - k]) > 0) faces.push_back(s.faces[k]);
    }
  }
  sort_once(faces);
  const double smooth = 2 * sine_cosine_degrees(smooth_degrees / 2).sine;
  std::vector<EdgeTree::Segment> places;
  for (const std::uint32_t face : faces) {
    const Point3 normal = face_normal(scene, face);
    for_sides(scene.faces, face, [&](std::uint32_t v, std::uint32_t w) {
      const std::uint32_t other = neighbours.across(face, v, w);
      if (other != kNone && glm::distance(face_normal(scene, other), normal) <= smooth) return;
      rims_.push_back({std::min(v, w), std::max(v, w), face, other, other == kNone ? 0 : errors.of(other)});
      places.push_back({scene.vertices[std::min(v, w)], scene.vertices[std::max(v, w)]});
    });
  }
  tree_ = EdgeTree(std::move(places));
}

std::optional<RimLines::Place> RimLines::nearest(std::uint32_t face, double distance, const Point3& p) const {
  double widest = 0;
  const auto first = std::ranges::lower_bound(rims_, face, {}, &Rim::face);
  for (auto rim = first; rim != rims_.end() && rim->face == face; ++rim) widest = std::max(widest, rim->distance);
  const auto of_face = [&](std::uint32_t rim, double) { return rims_[rim].face == face; };
  const NearestPoint found = tree_.nearest(p, distance + widest, of_face);
  if (found.segment == kNone || found.distance > distance + rims_[found.segment].distance) return std::nullopt;
  return Place{found.segment, found.at};
}

}  // namespace

void clear_intersections(StrokeModel& model, const Scene& scene, const ProjectedScene& projected, const LineRequest& request,
                         const Patches& patches, RunReport& run) {
  if (request.quality == Quality::exact || model.intersections.empty()) return;
  std::vector<std::uint32_t> faces = faces_near(scene, model.intersections);
  const FaceNeighbours neighbours(scene, faces);
  const ChordErrors errors(scene, neighbours, std::move(faces), request.crease_degrees);
  const ContactErrors contacts(scene, patches, errors);
  std::vector<bool> contact;  // by segment
  for (const SourceEdge& s : model.intersections) contact.push_back(contacts.is_contact(s));
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
  run.count_clear("intersections of surfaces that touch", static_cast<std::uint64_t>(std::ranges::count(contact, true)));
  run.count_clear("intersections along rims", static_cast<std::uint64_t>(std::ranges::count(on_rim, true)));
}

}  // namespace ligne
