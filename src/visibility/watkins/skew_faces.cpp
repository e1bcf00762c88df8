#include "visibility/watkins/skew_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "scene/model/planarity.hpp"

namespace ligne::watkins {
namespace {

/// Heights at which a side begins, ends or crosses another.
std::vector<double> heights_of(std::span<const RuledSide> sides) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    const RuledSide& a = sides[i];
    heights.push_back(a.top.p.y);
    heights.push_back(a.bottom.p.y);
    for (std::size_t k = i + 1; k < sides.size(); ++k) {
      const RuledSide& b = sides[k];
      const double from = std::max(a.top.p.y, b.top.p.y), to = std::min(a.bottom.p.y, b.bottom.p.y);
      if (!(from < to)) continue;
      const double at_from = a.x(from) - b.x(from), at_to = a.x(to) - b.x(to);
      if (at_from * at_to < 0) heights.push_back(from + (to - from) * (at_from / (at_from - at_to)));
    }
  }
  std::ranges::sort(heights);
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

/// A linear function on [0, 1] by its values at the ends.
struct Linear {
  double first, last;
  double operator()(double s) const { return first + s * (last - first); }
};

/// A line over the heights of a part. The parameter s is 0 and 1 where the line enters and leaves these heights.
struct LineOverPart {
  HiddenSides sides = HiddenSides::none;  ///< none: the line is beside the part
  double t0 = 0, t1 = 1;                  ///< parameters on the line
  Linear from_left{}, to_right{};         ///< distances from the sides, in steps
  Linear z{}, z_left{}, z_right{};        ///< depths of the line and of the sides
  double enter = 0, leave = 1;            ///< the part that lies between the sides

  double t(double s) const { return s == 0 ? t0 : s == 1 ? t1 : t0 + s * (t1 - t0); }
  /// How much farther the line is than the surface, times the distance of the sides.
  double scaled_difference(double s) const {
    const double a = from_left(s), b = to_right(s);
    return z(s) * (a + b) - (z_left(s) * b + z_right(s) * a);
  }
  double difference(double s) const {
    const double width = from_left(s) + to_right(s);
    return width > 0 ? scaled_difference(s) / width : 0;
  }
  /// The zeros of scaled_difference(); infinite or not a number where there is none.
  std::array<double, 2> roots() const {
    constexpr double kHalf = 0.5;
    const double c0 = scaled_difference(0), at_half = scaled_difference(kHalf), at_one = scaled_difference(1);
    const double c2 = 2 * (c0 + at_one - 2 * at_half), c1 = at_one - c0 - c2;
    const double q = -kHalf * (c1 + std::copysign(std::sqrt(c1 * c1 - 4 * c2 * c0), c1));
    return {q / c2, c0 / q};
  }
};

/// Narrows [enter, leave] to where the function is not negative.
void narrow(const Linear& f, double& enter, double& leave) {
  if (f.first < 0 && f.last < 0) {
    leave = enter;
  } else if (f.first < 0) {
    enter = std::max(enter, f.first / (f.first - f.last));
  } else if (f.last < 0) {
    leave = std::min(leave, f.first / (f.first - f.last));
  }
}

bool lies_along(const PageLine& line, const RuledSide& side) {
  return orientation(side.top.p, side.bottom.p, line.p0) == 0 && orientation(side.top.p, side.bottom.p, line.p1) == 0;
}

/// Sides as in hidden_interval(): a line along a border of the part has the part on one side only.
LineOverPart line_over_part(const PageLine& line, const RuledPart& part) {
  LineOverPart over;
  HiddenSides sides = HiddenSides::both;
  const double y = line.p0.y;
  if (line.dy == 0) {
    if (y < part.y_top || y > part.y_bottom) return over;
    if (y == part.y_top) sides = line.dx > 0 ? HiddenSides::left : HiddenSides::right;
    if (y == part.y_bottom) sides = line.dx > 0 ? HiddenSides::right : HiddenSides::left;
  } else {
    const double a = (part.y_top - y) / line.dy, b = (part.y_bottom - y) / line.dy;
    over.t0 = std::max(0.0, std::min(a, b));
    over.t1 = std::min(1.0, std::max(a, b));
    if (!(over.t0 < over.t1)) return over;
  }
  const auto linear = [&](auto value) { return Linear{value(over.t0), value(over.t1)}; };
  const auto y_at = [&](double t) { return y + t * line.dy; };
  const auto x_at = [&](double t) { return line.p0.x + t * line.dx; };
  over.from_left = linear([&](double t) { return x_at(t) - part.left.x(y_at(t)); });
  over.to_right = linear([&](double t) { return part.right.x(y_at(t)) - x_at(t); });
  over.z = linear([&](double t) { return line.z(t); });
  over.z_left = linear([&](double t) { return part.left.z(y_at(t)); });
  over.z_right = linear([&](double t) { return part.right.z(y_at(t)); });
  if (lies_along(line, part.left)) {
    over.from_left = {0, 0};
    sides = line.dy < 0 ? HiddenSides::left : HiddenSides::right;
  } else if (lies_along(line, part.right)) {
    over.to_right = {0, 0};
    sides = line.dy > 0 ? HiddenSides::left : HiddenSides::right;
  }
  narrow(over.from_left, over.enter, over.leave);
  narrow(over.to_right, over.enter, over.leave);
  if (over.enter < over.leave) over.sides = sides;
  return over;
}

/// Edges that cutting made, each with a face: sorted, so that the triangles of one polygon are neighbours.
struct InnerEdge {
  std::uint32_t v0, v1, face;  ///< v0 < v1
  friend auto operator<=>(const InnerEdge&, const InnerEdge&) = default;
};

std::vector<InnerEdge> inner_edges(const Scene& scene) {
  std::vector<InnerEdge> edges;
  if (scene.corner_flags.empty()) return edges;
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    if (scene.faces.contour_count(f) != 1) continue;
    const std::span<const std::uint32_t> corners = scene.faces.contour(f, 0);
    if (corners.size() != 3) continue;
    const std::size_t first = scene.faces.corner_index(f, 0);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
      if (scene.corner_flags[first + k] & kCornerInner) edges.push_back({std::min(a, b), std::max(a, b), f});
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Per face: the lowest face of its polygon. An edge that coincident polygons share has two triangles of each, one
/// polygon after the other.
std::vector<std::uint32_t> polygon_of_faces(const Scene& scene) {
  const std::vector<InnerEdge> edges = inner_edges(scene);
  DisjointSets sets(scene.faces.size());
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].v0 == edges[i].v0 && edges[end].v1 == edges[i].v1) ++end;
    for (; (end - i) % 2 == 0 && i + 1 < end; i += 2) sets.join(edges[i].face, edges[i + 1].face);
    i = end;
  }
  std::vector<std::uint32_t> polygon(scene.faces.size());
  for (std::uint32_t f = 0; f < polygon.size(); ++f) polygon[f] = sets.find(f);
  return polygon;
}

/// True if the corners of the faces are farther from a plane than the precision of their object explains.
bool is_skew(const Scene& scene, std::span<const std::uint32_t> faces, double precision) {
  std::vector<Point3> points;
  for (const std::uint32_t f : faces) {
    for (const std::uint32_t v : scene.faces.contour(f, 0)) points.push_back(scene.vertices[v]);
  }
  const SpanningPlane plane = spanning_plane(points);
  const double tolerance = planarity_tolerance(precision, plane.span);
  return std::ranges::any_of(points, [&](const Point3& p) { return std::abs(plane.distance(p)) > tolerance; });
}

/// Faces grouped by their polygon, for polygons of more than one face.
std::vector<std::vector<std::uint32_t>> skew_polygons(const Scene& scene) {
  const std::vector<std::uint32_t> polygon = polygon_of_faces(scene);
  std::vector<std::uint32_t> place(polygon.size(), kNone);
  std::vector<std::vector<std::uint32_t>> polygons;
  for (std::uint32_t f = 0; f < polygon.size(); ++f) {
    if (polygon[f] == f) continue;
    std::uint32_t& p = place[polygon[f]];
    if (p == kNone) {
      p = static_cast<std::uint32_t>(polygons.size());
      polygons.push_back({polygon[f]});
    }
    polygons[p].push_back(f);
  }
  std::vector<std::vector<std::uint32_t>> skew;
  std::size_t object = 0;
  std::ranges::sort(polygons);
  for (std::vector<std::uint32_t>& faces : polygons) {
    while (object < scene.objects.size() && faces[0] >= scene.objects[object].face_end) ++object;
    const double precision = object < scene.objects.size() ? scene.objects[object].precision : 0;
    if (is_skew(scene, faces, precision)) skew.push_back(std::move(faces));
  }
  return skew;
}

/// The sides of a face that its triangles do not share, without horizontal ones.
std::vector<RuledSide> sides_of(const ProjectedScene& scene, std::span<const std::uint32_t> triangles) {
  std::vector<std::array<std::uint32_t, 2>> ends;
  for (const std::uint32_t t : triangles) {
    const auto& v = scene.triangles[t].v;
    for (std::size_t k = 0; k < 3; ++k) ends.push_back({std::min(v[k], v[(k + 1) % 3]), std::max(v[k], v[(k + 1) % 3])});
  }
  std::ranges::sort(ends);
  std::vector<RuledSide> sides;
  for (std::size_t i = 0; i < ends.size();) {
    std::size_t end = i + 1;
    while (end < ends.size() && ends[end] == ends[i]) ++end;
    ProjectedVertex a = scene.vertices[ends[i][0]], b = scene.vertices[ends[i][1]];
    if (a.p.y > b.p.y) std::swap(a, b);
    if ((end - i) % 2 == 1 && a.p.y < b.p.y) sides.push_back({a, b});
    i = end;
  }
  return sides;
}

/// The triangles of each polygon in the projected scene, without those seen edge on.
std::vector<std::vector<std::uint32_t>> triangles_of(const ProjectedScene& scene, const std::vector<std::uint32_t>& polygon,
                                                     std::size_t count) {
  std::vector<std::vector<std::uint32_t>> triangles(count);
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    const std::uint32_t p = polygon[scene.triangles[t].face];
    if (p != kNone && !scene.is_edge_on(scene.triangles[t])) triangles[p].push_back(t);
  }
  return triangles;
}

}  // namespace

void SkewFaces::add(std::uint32_t face, Face surface) {
  if (number_.size() <= face) number_.resize(face + 1, kNone);
  number_[face] = static_cast<std::uint32_t>(faces_.size());
  faces_.push_back(std::move(surface));
}

namespace {

/// Replaces the face numbers of the triangles and edges by those of whole faces.
void renumber(ProjectedScene& scene, const SkewFaces& faces, const std::vector<std::uint32_t>& whole) {
  const auto is_part = [&](std::uint32_t face) { return whole[face] != face || faces.has(face); };
  std::erase_if(scene.triangles, [&](const Triangle& t) { return scene.is_edge_on(t) && is_part(t.face); });
  for (Triangle& t : scene.triangles) t.face = whole[t.face];
  for (std::uint32_t f = 0; f < scene.face_is_edge_on.size(); ++f) {
    if (faces.has(f)) scene.face_is_edge_on[f] = 0;
  }
  const auto whole_of = [&](std::uint32_t face) { return face < whole.size() ? whole[face] : face; };
  std::vector<ProjectedEdge> edges;
  std::vector<std::array<double, 2>> edge_parts;
  for (std::size_t i = 0; i < scene.edges.size(); ++i) {
    ProjectedEdge edge = scene.edges[i];
    edge.face0 = whole_of(edge.face0);
    edge.face1 = whole_of(edge.face1);
    const bool is_inner = edge.face0 == edge.face1 && edge.face0 != kNone;
    if (is_inner && edge.line_class != LineClass::outline) continue;
    edges.push_back(edge);
    if (!scene.edge_parts.empty()) edge_parts.push_back(scene.edge_parts[i]);
  }
  scene.edges = std::move(edges);
  scene.edge_parts = std::move(edge_parts);
}

/// Largest depth tolerance of the facets of each polygon.
std::vector<double> tolerances_of(const std::vector<Facet>& facets, const std::vector<std::uint32_t>& polygon,
                                  std::size_t count) {
  std::vector<double> tolerances(count, 0);
  for (const Facet& f : facets) {
    const std::uint32_t p = polygon[f.face];
    if (p != kNone) tolerances[p] = std::max(tolerances[p], double(f.depth_tolerance));
  }
  return tolerances;
}

}  // namespace

std::optional<SkewScene> join_skew_faces(const ProjectedScene& scene, const std::vector<Facet>& facets) {
  const std::vector<std::vector<std::uint32_t>> polygons = skew_polygons(*scene.model);
  if (polygons.empty()) return std::nullopt;
  std::vector<std::uint32_t> polygon(scene.model->faces.size(), kNone), whole(polygon.size());
  std::iota(whole.begin(), whole.end(), 0u);
  for (std::uint32_t p = 0; p < polygons.size(); ++p) {
    for (const std::uint32_t f : polygons[p]) polygon[f] = p;
  }
  const std::vector<double> tolerances = tolerances_of(facets, polygon, polygons.size());
  const std::vector<std::vector<std::uint32_t>> triangles = triangles_of(scene, polygon, polygons.size());
  SkewScene joined{scene, {}, 0};
  for (std::uint32_t p = 0; p < polygons.size(); ++p) {
    const std::vector<RuledSide> sides = sides_of(scene, triangles[p]);
    if (sides.size() > kMostSkewSides) {
      ++joined.left_as_triangles;
      continue;
    }
    for (const std::uint32_t f : polygons[p]) whole[f] = polygons[p][0];
    SkewFaces::Face surface{ruled_parts(sides), -std::numeric_limits<double>::infinity(), tolerances[p]};
    for (const std::uint32_t t : triangles[p]) {
      for (const std::uint32_t v : scene.triangles[t].v) surface.farthest = std::max(surface.farthest, scene.vertices[v].z);
    }
    joined.faces.add(polygons[p][0], std::move(surface));
  }
  renumber(joined.scene, joined.faces, whole);
  return joined;
}

std::vector<RuledPart> ruled_parts(std::span<const RuledSide> sides) {
  std::vector<RuledPart> parts;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> open;  // by sides: a part that ends at the current height
  const std::vector<double> heights = heights_of(sides);
  std::vector<std::size_t> met;
  for (std::size_t h = 0; h + 1 < heights.size(); ++h) {
    const double from = heights[h], to = heights[h + 1], middle = (from + to) / 2;
    met.clear();
    for (std::size_t i = 0; i < sides.size(); ++i) {
      if (sides[i].top.p.y <= from && to <= sides[i].bottom.p.y) met.push_back(i);
    }
    std::ranges::sort(met, {}, [&](std::size_t i) { return std::pair(sides[i].x(middle), i); });
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> next;
    for (std::size_t i = 0; i + 1 < met.size(); i += 2) {
      const std::pair pair(met[i], met[i + 1]);
      const auto above = open.find(pair);
      if (above != open.end()) {
        parts[above->second].y_bottom = to;
        next[pair] = above->second;
      } else {
        next[pair] = parts.size();
        parts.push_back({sides[pair.first], sides[pair.second], from, to});
      }
    }
    open = std::move(next);
  }
  return parts;
}

std::array<HiddenInterval, 2> behind_ruled_part(const PageLine& line, const RuledPart& part, double tolerance) {
  std::array<HiddenInterval, 2> hidden{};
  const LineOverPart over = line_over_part(line, part);
  if (over.sides == HiddenSides::none) return hidden;
  // The depth difference times the width is quadratic in s. It has one sign between two stops.
  std::array<double, 4> stops{over.enter, over.leave};
  std::size_t count = 2;
  for (const double root : over.roots()) {
    if (root > over.enter && root < over.leave) stops[count++] = root;
  }
  std::sort(stops.begin(), stops.begin() + static_cast<std::ptrdiff_t>(count));
  std::size_t found = 0;
  bool is_open = false, is_behind = false;
  double begin = 0;
  const auto close = [&](double end) {
    if (is_open && is_behind && begin < end && found < hidden.size())
      hidden[found++] = {over.t(begin), over.t(end), over.sides};
    is_open = is_behind = false;
  };
  for (std::size_t i = 0; i + 1 < count; ++i) {
    bool behind = false, in_front = false;
    for (const double s : {stops[i], (stops[i] + stops[i + 1]) / 2, stops[i + 1]}) {
      const double d = over.difference(s);
      behind |= d > tolerance;
      in_front |= d < -tolerance;
    }
    if (in_front) {
      close(stops[i]);
      continue;
    }
    if (!is_open) begin = stops[i];
    is_open = true;
    is_behind |= behind;
  }
  close(stops[count - 1]);
  return hidden;
}

}  // namespace ligne::watkins
