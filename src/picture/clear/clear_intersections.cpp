#include "picture/clear/tidy_strokes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "geometry/degrees.hpp"
#include "geometry/nearest_on_segment.hpp"
#include "linework/map/nodes.hpp"
#include "scene/contacts/chord_errors.hpp"
#include "scene/contacts/contact_errors.hpp"
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

/// Adjustable: least ratio of the length of a way along rims to that of its stroke, which the two have at 32 degrees.
/// Beside the edge of a coarse mesh a line that leaves the edge may well stay within the error of the mesh.
constexpr double kLeastAlong = 0.85;

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

  /// A place on a rim.
  struct Place {
    std::uint32_t rim;
    double at;  ///< 0 at its v0, 1 at its v1
  };
  /// A piece of a rim.
  struct Piece {
    Place begin;
    double end;
  };
  /// The way of an intersection along one rim, or along two round their corner.
  using Path = std::vector<Piece>;

  /// The longest way of a stroke of an intersection along rims of one of its faces. It is empty if the stroke runs along no
  /// rim whose class is in `classes`.
  Path path(const SourceEdge& segment, const Stroke& stroke, const View& view, LineClasses classes) const {
    if (rims_.empty()) return {};
    const std::array<Point3, 2> tips{between(segment.ends[0], segment.ends[1], stroke.t_from),
                                     between(segment.ends[0], segment.ends[1], stroke.t_to)};
    Path longest;
    double least = kLeastAlong * glm::distance(tips[0], tips[1]);
    for (int k = 0; k < 2; ++k) {
      Path path = path_on(segment.faces[k], segment.faces[1 - k], tips, view, classes);
      double length = 0;
      for (const Piece& piece : path) length += glm::distance(point_at(piece.begin), point_at({piece.begin.rim, piece.end}));
      if (path.empty() || length < least) continue;
      least = length;
      longest = std::move(path);
    }
    return longest;
  }

  /// Adds a piece of a rim in place of a stroke, and its source to `model.intersections`.
  void add_piece(StrokeModel& model, const Piece& piece, const Stroke& stroke, const View& view) const {
    const auto [low, high] = std::minmax(piece.begin.at, piece.end);
    const Rim& r = rims_[piece.begin.rim];
    const Point3 a = scene_.vertices[r.v0], b = scene_.vertices[r.v1];
    const auto tip_at = [&](double t) -> StrokeTip {
      const HomogeneousPoint p = to_homogeneous(view, between(a, b, t));
      return {model.lattice.snap({p.x / p.w, p.y / p.w}), static_cast<float>(p.z / p.w), static_cast<float>(p.w)};
    };
    Stroke added = stroke_between(stroke, tip_at(low), tip_at(high));
    if (added.from == added.to) return;
    added.t_from = low;
    added.t_to = high;
    added.source = model.edge_count + static_cast<std::uint32_t>(model.intersections.size());
    added.line_class = line_class(r, view.camera);
    added.needs_overlap_check = true;
    model.intersections.push_back({{a, b}, {r.face, r.neighbour}, false});
    model.strokes.push_back(added);
  }

 private:
  struct Rim {
    std::uint32_t v0, v1;
    std::uint32_t face, neighbour;
    double distance;  ///< the error of its neighbour: distance of the triangles from the exact shape
  };

  /// The way along rims of a face that crosses another one between two tips. It is empty if either tip lies near none.
  Path path_on(std::uint32_t face, std::uint32_t other, const std::array<Point3, 2>& tips, const View& view,
               LineClasses classes) const {
    const double error = errors_.of(other);
    if (error == 0) return {};
    const double distance = error + object_precision(scene_, face) + object_precision(scene_, other);
    const auto p = nearest(face, distance, tips[0]);
    if (!p) return {};
    const auto q = nearest(face, distance, tips[1]);
    if (!q || !classes.has(line_class(rims_[p->rim], view.camera))) return {};
    if (p->rim == q->rim) return {{*p, q->at}};
    const Rim &r = rims_[p->rim], &s = rims_[q->rim];
    const bool at_v0 = r.v0 == s.v0 || r.v0 == s.v1, at_v1 = r.v1 == s.v0 || r.v1 == s.v1;
    if (at_v0 == at_v1) return {};
    const std::uint32_t corner = at_v0 ? r.v0 : r.v1;
    // At the tip of a narrow face the two ends may lie near two rims that meet far away, or that turn back there.
    const Point3 turn = scene_.vertices[corner];
    const double farthest = distance + std::max(r.distance, s.distance);
    const Point3 nearest_of_piece = between(tips[0], tips[1], nearest_on_segment(turn, tips[0], tips[1]));
    if (glm::distance(turn, nearest_of_piece) > farthest || glm::dot(tips[0] - turn, tips[1] - turn) > 0) return {};
    return {{*p, at_v0 ? 0.0 : 1.0}, {{q->rim, corner == s.v0 ? 0.0 : 1.0}, q->at}};
  }

  Point3 point_at(const Place& p) const {
    return between(scene_.vertices[rims_[p.rim].v0], scene_.vertices[rims_[p.rim].v1], p.at);
  }
  std::optional<Place> nearest(std::uint32_t face, double distance, const Point3& p) const;

  LineClass line_class(const Rim& rim, const Camera& camera) const {
    if (rim.neighbour == kNone) return LineClass::border;
    return looks_at(scene_, rim.face, camera) != looks_at(scene_, rim.neighbour, camera) ? LineClass::outline
                                                                                         : LineClass::crease;
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

/// How the stroke of an intersection is drawn.
enum class Course : std::uint8_t {
  own,      ///< it has no path along rims
  on_rims,  ///< along its path
  kept      ///< as it is, since a line of which only a part moves would have a gap
};

/// Keeps the strokes that continue others which are not drawn on rims, and those that continue these. `courses`: those of
/// the members.
void keep_whole_lines(const std::vector<Stroke>& strokes, std::span<const std::uint32_t> members,
                      std::vector<Course>& courses) {
  const Nodes nodes(strokes, members);
  std::vector<std::uint32_t> staying;
  for (std::uint32_t i = 0; i < courses.size(); ++i) {
    if (courses[i] == Course::own) staying.push_back(i);
  }
  while (!staying.empty()) {
    const std::uint32_t i = staying.back();
    staying.pop_back();
    for (const std::uint32_t end : {2 * i, 2 * i + 1}) {
      nodes.for_each_end(nodes.of(end), [&](std::uint32_t e) {
        if (courses[e / 2] != Course::on_rims) return;
        courses[e / 2] = Course::kept;
        staying.push_back(e / 2);
      });
    }
  }
}

}  // namespace

void clear_intersections(StrokeModel& model, const Scene& scene, const ProjectedScene& projected, const LineRequest& request,
                         const Patches& patches, RunReport& run) {
  if (request.quality == Quality::exact || model.intersections.empty()) return;
  std::vector<std::uint32_t> faces = faces_near(scene, model.intersections);
  const FaceNeighbours neighbours(scene, faces);
  const ChordErrors errors(scene, neighbours, std::move(faces), request.crease_degrees);
  const ContactErrors contacts(scene, patches.patch_of, errors);
  std::vector<bool> contact;  // by segment
  for (const SourceEdge& s : model.intersections) contact.push_back(s.intersection && contacts.is_contact(s.faces, s.ends));
  const RimLines rims(scene, neighbours, errors, model.intersections, request.crease_degrees);

  std::vector<Stroke> strokes;
  std::swap(strokes, model.strokes);
  std::vector<std::uint32_t> members;
  std::vector<Course> courses;
  std::vector<RimLines::Path> paths;  // of the members that have one
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    if (strokes[i].source < model.edge_count) continue;
    const std::size_t k = strokes[i].source - std::size_t{model.edge_count};
    const SourceEdge& segment = model.intersections[k];
    if (!segment.intersection || contact[k]) continue;
    members.push_back(i);
    RimLines::Path path = rims.path(segment, strokes[i], projected.view, request.studied());
    courses.push_back(path.empty() ? Course::own : Course::on_rims);
    if (!path.empty()) paths.push_back(std::move(path));
  }
  if (!paths.empty()) keep_whole_lines(strokes, members, courses);

  std::vector<bool> on_rim(contact.size(), false);
  auto path = paths.begin();
  std::size_t member = 0;
  for (std::uint32_t i = 0; i < strokes.size(); ++i) {
    const Stroke& s = strokes[i];
    const bool is_member = member < members.size() && members[member] == i;
    const Course course = is_member ? courses[member++] : Course::own;
    const std::size_t before = model.strokes.size();
    if (course == Course::on_rims) {
      for (const RimLines::Piece& piece : *path) rims.add_piece(model, piece, s, projected.view);
      if (model.strokes.size() > before) on_rim[s.source - std::size_t{model.edge_count}] = true;
    }
    if (course != Course::own) ++path;
    const bool is_contact = s.source >= model.edge_count && contact[s.source - std::size_t{model.edge_count}];
    if (model.strokes.size() == before && !is_contact) model.strokes.push_back(s);
  }
  run.count_clear("intersections of surfaces that touch", static_cast<std::uint64_t>(std::ranges::count(contact, true)));
  run.count_clear("intersections along rims", static_cast<std::uint64_t>(std::ranges::count(on_rim, true)));
}

}  // namespace ligne
