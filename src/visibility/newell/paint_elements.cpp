#include "visibility/newell/paint_elements.hpp"

#include <cmath>
#include <tuple>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/stop.hpp"
#include "geometry/convex_hull.hpp"
#include "scene/model/face_shape.hpp"
#include "visibility/newell/separated_cells.hpp"

namespace ligne::newell {
namespace {

/// Rounding error of a depth, relative to the summed magnitudes: two products, and plane coefficients through two matrices.
constexpr double kDepthRounding = 0x1p-44;
/// Width of strips that may result from rounding, in lattice steps. Rounding itself is far smaller.
constexpr double kStripRounding = 0x1p-10;

/// True if all of `b` lies outside one side of `a`, or less than `margin` inside it.
bool has_side_between(std::span<const Point2> a, std::span<const Point2> b, double margin) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Point2 side = a[i + 1 == a.size() ? 0 : i + 1] - a[i];
    const double limit = margin * glm::length(side);
    if (limit == 0) continue;
    if (std::ranges::all_of(b, [&](Point2 p) { return cross(side, p - a[i]) <= limit; })) return true;
  }
  return false;
}

std::shared_ptr<const FaceFacts> find_facts(const ProjectedScene& projected, const ModelPieces& pieces) {
  const Scene& scene = *projected.model;
  const Viewpoint viewpoint = viewpoint_of(projected.view.camera);
  FaceFacts facts{ConvexBodies(scene, pieces, viewpoint), separated_cells(scene, viewpoint), {}};
  if (scene.stated.has(StatedFact::no_penetration)) {
    facts.is_convex.resize(scene.faces.size());
    for (std::uint32_t f = 0; f < facts.is_convex.size(); ++f) facts.is_convex[f] = is_convex_face(scene, f, 0);
  }
  return std::make_shared<const FaceFacts>(std::move(facts));
}

}  // namespace

void Extents::extend(const Extents& o) {
  for (int k = 0; k < 3; ++k) {
    low[k] = std::min(low[k], o.low[k]);
    high[k] = std::max(high[k], o.high[k]);
  }
}

void CommonPart::clip_by_side(Point2 from, Point2 to) {
  spare.clear();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2 a = corners[i], b = corners[i + 1 == corners.size() ? 0 : i + 1];
    const double inside_a = cross(to - from, a - from), inside_b = cross(to - from, b - from);
    if (inside_a >= 0) spare.push_back(a);
    if ((inside_a >= 0) != (inside_b >= 0)) spare.push_back(a + (b - a) * (inside_a / (inside_a - inside_b)));
  }
  corners.swap(spare);
}

PaintElements::PaintElements(const ProjectedScene& scene, const EarlierElements* earlier, bool whole_bodies)
    : view_(scene.view),
      scene_(scene),
      pieces_(earlier ? earlier->pieces : ModelPieces(*scene.model)),
      facts_(find_facts(scene, pieces_)),
      volume_(face_volume(scene.view, scene.lattice)),
      viewpoint_(viewpoint_of(scene.view.camera)),
      page_planes_(scene.view),
      shown_(shown_faces(scene)) {
  const auto count = static_cast<std::uint32_t>(pieces_.pieces().size());
  std::vector<std::uint8_t> added(count, 0);
  if (earlier) {
    for (const EarlierElements::Part& part : earlier->list) {
      add(part.face, part.pieces);
      for (const std::uint32_t piece : part.pieces) added[piece] = 1;
    }
    in_order_ = elements_.size();
  }
  // The pieces of a cut face need not be adjacent.
  std::vector<std::uint32_t> others, parts;
  for (std::uint32_t piece = 0; piece < count; ++piece) {
    if (!added[piece]) others.push_back(piece);
  }
  std::ranges::stable_sort(others, [&](std::uint32_t a, std::uint32_t b) { return pieces_.face(a) < pieces_.face(b); });
  for (std::size_t i = 0; i < others.size(); ++i) {
    check_stop();
    parts.push_back(others[i]);
    if (i + 1 < others.size() && pieces_.face(others[i + 1]) == pieces_.face(others[i])) continue;
    add(pieces_.face(others[i]), parts);
    parts.clear();
  }
  face_count_ = elements_.size();
  if (whole_bodies && !earlier) make_whole_bodies();
}

/// Replaces the faces of each body of two or more faces by one element.
void PaintElements::make_whole_bodies() {
  const ConvexBodies& bodies = facts_->bodies;
  std::vector<std::vector<std::uint32_t>> members(bodies.count());
  for (std::uint32_t e = 0; e < elements_.size(); ++e) {
    const std::uint32_t body = bodies.body(elements_[e].face);
    if (body != kNone) members[body].push_back(e);
  }
  std::vector<std::uint8_t> is_made(bodies.count(), 0);
  std::vector<Element> faces;
  faces.swap(elements_);
  element_corners_.clear();
  for (std::uint32_t e = 0; e < faces.size(); ++e) {
    const std::uint32_t number = bodies.body(faces[e].face);
    const std::size_t size = number == kNone ? 1 : members[number].size();
    if (size == 1) {
      append(faces[e]);
      continue;
    }
    if (is_made[number]) continue;
    is_made[number] = 1;
    std::stable_partition(members[number].begin(), members[number].end(),
                          [&](std::uint32_t m) { return !bodies.is_front(faces[m].face); });
    Element body{faces[e].face, kNone, {}, {}, {}};
    BodyElement whole;
    std::vector<Point2> points;
    for (const std::uint32_t m : members[number]) {
      whole.back_count += !bodies.is_front(faces[m].face);
      body.extents.extend(faces[m].extents);
      body.parts.insert(body.parts.end(), faces[m].parts.begin(), faces[m].parts.end());
      for (const std::uint32_t part : faces[m].parts) {
        points.insert(points.end(), contour(part).begin(), contour(part).end());
      }
      whole.members.push_back(faces[m]);
    }
    whole.silhouette = convex_hull(std::move(points), [](Point2 a, Point2 b, Point2 c) { return cross(b - a, c - b); });
    body.body = static_cast<std::uint32_t>(whole_.size());
    whole_.push_back(std::move(whole));
    append(std::move(body));
  }
}

std::vector<std::uint32_t> PaintElements::open(std::uint32_t body) {
  std::vector<std::uint32_t> numbers;
  for (const Element& member : whole_[elements_[body].body].members) {
    numbers.push_back(static_cast<std::uint32_t>(elements_.size()));
    append(member);
  }
  return numbers;
}

/// Adds an element of the visible ones among these pieces of a face.
void PaintElements::add(std::uint32_t face, std::span<const std::uint32_t> parts) {
  if (!shown_[face]) return;
  Element element{face, kNone, {}, {}, pieces_.plane_of(parts[0])};
  for (const std::uint32_t piece : parts) {
    const Extents extents = project(piece);
    if (extents.low[0] > extents.high[0]) continue;
    if (element.parts.empty()) element.plane = pieces_.plane_of(piece);
    element.parts.push_back(piece);
    element.extents.extend(extents);
  }
  if (element.parts.empty()) return;
  if (!viewpoint_.in_front_of(element.plane)) element.plane.normal = -element.plane.normal;
  element.page_plane = page_planes_(element.plane);
  append(std::move(element));
}

void PaintElements::append(Element element) {
  element.corner_begin = element_corners_.size();
  if (element.body == kNone) {
    for (const std::uint32_t part : element.parts) {
      for (const std::uint32_t corner : pieces_.corners(part)) element_corners_.push_back(pieces_.point(corner));
    }
  } else {
    // Stores each corner of a body once: its pieces share corners.
    std::vector<std::uint32_t> corners;
    for (const std::uint32_t part : element.parts) {
      corners.insert(corners.end(), pieces_.corners(part).begin(), pieces_.corners(part).end());
    }
    std::ranges::sort(corners);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    for (const std::uint32_t corner : corners) element_corners_.push_back(pieces_.point(corner));
  }
  element.corner_end = element_corners_.size();
  elements_.push_back(std::move(element));
}

/// Stores the visible contour of the piece and returns its extents.
Extents PaintElements::project(std::uint32_t piece) {
  corners_.clear();
  for (const std::uint32_t corner : pieces_.corners(piece)) corners_.push_back(to_homogeneous(view_, pieces_.point(corner)));
  clip_contour(corners_, volume_);
  contours_.resize(std::max<std::size_t>(contours_.size(), piece + 1), {0, 0});
  piece_extents_.resize(contours_.size());
  Extents extents;
  const std::size_t begin = points_.size();
  if (corners_.size() >= 3) {
    for (const HomogeneousPoint& p : corners_) {
      points_.emplace_back(p.x / p.w, p.y / p.w);
      const Point2 q = points_.back();
      const double z = p.z / p.w;
      extents.extend({{q.x, q.y, z}, {q.x, q.y, z}});
    }
    double twice_area = 0;
    for (std::size_t i = begin + 1; i + 1 < points_.size(); ++i) {
      twice_area += cross(points_[i] - points_[begin], points_[i + 1] - points_[begin]);
    }
    if (twice_area < 0) std::reverse(points_.begin() + static_cast<std::ptrdiff_t>(begin), points_.end());
  }
  contours_[piece] = {begin, points_.size()};
  piece_extents_[piece] = extents;
  return extents;
}

PlaneSide PaintElements::side(std::uint32_t element, std::uint32_t of) const {
  return side(elements_[element], elements_[of].plane);
}

// A body lies in front of the plane of each of its back faces and behind the plane of each of its front faces.
bool PaintElements::lies_behind_body(std::uint32_t element, const BodyElement& body) const {
  return std::ranges::any_of(std::span(body.members).first(body.back_count),
                             [&](const Element& face) { return is_back(side(elements_[element], face.plane)); });
}

bool PaintElements::lies_before_body(std::uint32_t element, const BodyElement& body) const {
  return std::ranges::any_of(std::span(body.members).subspan(body.back_count),
                             [&](const Element& face) { return is_front(side(elements_[element], face.plane)); });
}

/// Whether two convex outlines, whose extents overlap, have no inner point in common.
bool PaintElements::disjoint_outlines(const Extents& e, std::span<const Point2> p, const Extents& f,
                                      std::span<const Point2> q) const {
  const double step = scene_.lattice.step_mm, margin = kStripRounding * step;
  if (std::min(e.longest_side(), f.longest_side()) < step) return true;
  return has_side_between(p, q, margin) || has_side_between(q, p, margin);
}

bool PaintElements::disjoint_pieces(std::uint32_t p, std::uint32_t q) const {
  const Extents &e = piece_extents_[p], &f = piece_extents_[q];
  if (!e.overlap(f, 0) || !e.overlap(f, 1)) return true;  // decides most pairs
  return disjoint_outlines(e, contour(p), f, contour(q));
}

bool PaintElements::disjoint(std::uint32_t a, std::uint32_t b) const {
  const Element &e = elements_[a], &f = elements_[b];
  if (e.body != kNone || f.body != kNone) return disjoint_silhouettes(e, f);
  for (const std::uint32_t p : e.parts) {
    for (const std::uint32_t q : f.parts) {
      if (!disjoint_pieces(p, q)) return false;
    }
  }
  return true;
}

/// As disjoint(), where one of the two is a body at least: its silhouette stands for its pieces.
bool PaintElements::disjoint_silhouettes(const Element& e, const Element& f) const {
  if (e.body == kNone) return disjoint_silhouettes(f, e);
  const auto apart = [&](const Extents& extents, std::span<const Point2> outline) {
    return !e.extents.overlap(extents, 0) || !e.extents.overlap(extents, 1) ||
           disjoint_outlines(e.extents, whole_[e.body].silhouette, extents, outline);
  };
  if (f.body != kNone) return apart(f.extents, whole_[f.body].silhouette);
  return std::ranges::all_of(f.parts, [&](std::uint32_t p) { return apart(piece_extents_[p], contour(p)); });
}

Hiding PaintElements::hiding(std::uint32_t a, std::uint32_t b, CommonPart& work) const {
  Hiding result;
  if (!is_body(a) && !is_body(b)) {
    compare_depths(elements_[a], elements_[b], work, result);
    return result;
  }
  for (const Element& face : faces_of(elements_[a])) {
    for (const Element& other : faces_of(elements_[b])) {
      compare_depths(face, other, work, result);
      if (result.first && result.second) return result;
    }
  }
  return result;
}

/// Adds the result for two faces.
void PaintElements::compare_depths(const Element& a, const Element& b, CommonPart& work, Hiding& result) const {
  const std::array<double, 3>&p = a.page_plane, &q = b.page_plane;
  const std::array<double, 3> d{p[0] - q[0], p[1] - q[1], p[2] - q[2]};
  const double slope = std::min(std::abs(p[0]) + std::abs(p[1]), std::abs(q[0]) + std::abs(q[1]));
  for (const std::uint32_t i : a.parts) {
    for (const std::uint32_t k : b.parts) {
      if (disjoint_pieces(i, k)) continue;
      work.corners.assign(contour(i).begin(), contour(i).end());
      const auto clip = contour(k);
      for (std::size_t s = 0; s < clip.size(); ++s) work.clip_by_side(clip[s], clip[s + 1 == clip.size() ? 0 : s + 1]);
      for (const Point2 c : work.corners) {
        const double difference = d[0] * c.x + d[1] * c.y + d[2];
        const double sizes = std::abs(p[0] * c.x) + std::abs(p[1] * c.y) + std::abs(p[2]) + std::abs(q[0] * c.x) +
                             std::abs(q[1] * c.y) + std::abs(q[2]);
        const double magnification = scene_.magnification(p[0] * c.x + p[1] * c.y + p[2]);
        const double error_mm = scene_.input_error_mm * magnification;
        const double tolerance = 2 * error_mm * (slope + magnification) + kDepthRounding * sizes;
        result.first |= difference < -tolerance;
        result.second |= difference > tolerance;
      }
    }
  }
}

/// Groups of parts connected by common sides.
std::vector<std::vector<std::uint32_t>> PaintElements::connected(const std::vector<std::uint32_t>& parts) const {
  if (parts.size() <= 1) return {parts};
  using Corner = std::tuple<double, double, double>;
  const auto corner = [&](std::uint32_t c) {
    const Point3& p = pieces_.point(c);
    return Corner{p.x, p.y, p.z};
  };
  std::vector<std::pair<std::array<Corner, 2>, std::size_t>> sides;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto corners = pieces_.corners(parts[i]);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      std::array<Corner, 2> side{corner(corners[k]), corner(corners[k + 1 == corners.size() ? 0 : k + 1])};
      if (side[1] < side[0]) std::swap(side[0], side[1]);
      sides.emplace_back(side, i);
    }
  }
  std::ranges::sort(sides);
  DisjointSets sets(parts.size());
  for (std::size_t k = 1; k < sides.size(); ++k) {
    if (sides[k].first == sides[k - 1].first) {
      sets.join(static_cast<std::uint32_t>(sides[k - 1].second), static_cast<std::uint32_t>(sides[k].second));
    }
  }
  std::vector<std::vector<std::uint32_t>> result;
  std::vector<std::size_t> number(parts.size());
  for (std::uint32_t i = 0; i < parts.size(); ++i) {
    const std::uint32_t root = sets.find(i);
    if (root == i) {
      number[i] = result.size();
      result.emplace_back();
    }
  }
  for (std::uint32_t i = 0; i < parts.size(); ++i) result[number[sets.find(i)]].push_back(parts[i]);
  return result;
}

std::vector<std::uint32_t> PaintElements::cut(std::uint32_t element, ModelPlane plane) {
  std::vector<std::uint32_t> front, back;
  for (const std::uint32_t part : elements_[element].parts) {
    switch (pieces_.side(part, plane)) {
      case PlaneSide::back:
        back.push_back(part);
        break;
      case PlaneSide::both: {
        const std::uint32_t behind = pieces_.cut(part, plane);
        project(part);
        project(behind);
        front.push_back(part);
        back.push_back(behind);
        break;
      }
      default:
        front.push_back(part);
    }
  }
  if (front.empty() || back.empty()) return {};
  std::vector<std::uint32_t> numbers;
  for (const auto& half : {front, back}) {
    for (std::vector<std::uint32_t>& parts : connected(half)) {
      Element piece{elements_[element].face,      kNone, std::move(parts), {}, elements_[element].plane,
                    elements_[element].page_plane};
      for (const std::uint32_t p : piece.parts) piece.extents.extend(piece_extents_[p]);
      if (piece.extents.low[0] > piece.extents.high[0]) continue;  // outside the view
      numbers.push_back(static_cast<std::uint32_t>(elements_.size()));
      append(std::move(piece));
    }
  }
  return numbers;
}

ModelPlane PaintElements::halving_plane(std::uint32_t element) const {
  const Extents& e = elements_[element].extents;
  const int axis = e.high[1] - e.low[1] > e.high[0] - e.low[0] ? 1 : 0;
  const double middle = (e.low[axis] + e.high[axis]) / 2;
  // In homogeneous page coordinates (X, Y, Z, W) the plane is X - middle W = 0, or with Y.
  const glm::dmat4& m = view_.model_to_page;
  const auto coefficient = [&](int column) { return m[column][axis] - middle * m[column][3]; };
  const Point3 normal{coefficient(0), coefficient(1), coefficient(2)};
  const double length = glm::length(normal);
  const Point3 near = pieces_.point(pieces_.corners(elements_[element].parts[0])[0]);
  const Point3 unit = normal / length;
  return {unit, near - unit * ((glm::dot(normal, near) + coefficient(3)) / length)};
}

}  // namespace ligne::newell
