#include "picture/choice/scene_traits.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "geometry/connected_boxes.hpp"
#include "geometry/point.hpp"
#include "geometry/predicates.hpp"
#include "scene/model/bounds.hpp"
#include "scene/model/face_shape.hpp"
#include "scene/model/planarity.hpp"
#include "view/tolerances.hpp"
#include "visibility/common/convex_body.hpp"
#include "visibility/common/facet.hpp"

namespace ligne {
namespace {

/// Counts the triangles of a set over the points of a regular grid.

/// A triangle costs one step for each of its rows, whatever its size. A point on the common side of two triangles
/// counts for one of them.
class CoverSamples {
 public:
  struct Cover {
    double mean = 0;         ///< over the points with at least one triangle
    std::uint32_t most = 0;  ///< at any point
    double share = 0;        ///< share of the points that have a triangle
  };

  /// Sample points in `rows` rows over the rectangle. Their columns make the cells square, up to kMostColumns.
  CoverSamples(const Rect& around, std::uint32_t rows);

  void add(const std::array<Point2, 3>& corners);
  Cover cover() const;

 private:
  static constexpr std::uint32_t kMostColumns = 4096;

  std::uint32_t columns_, rows_;
  Point2 corner_;
  double width_, height_;            ///< size of a cell, whose centre is the sample point
  std::vector<std::int32_t> steps_;  ///< change of the count from one point of a row to the next
};

/// x of the side at that height. It is bit for bit equal for the triangles on both sides of it.
double x_at(Point2 a, Point2 b, double y) {
  if (std::pair(b.y, b.x) < std::pair(a.y, a.x)) std::swap(a, b);
  return a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
}

CoverSamples::CoverSamples(const Rect& around, std::uint32_t rows) : rows_(rows), corner_(around.min) {
  const double width = around.max.x - around.min.x, height = around.max.y - around.min.y;
  const double columns = height > 0 ? std::ceil(rows * width / height) : kMostColumns;
  columns_ = static_cast<std::uint32_t>(std::clamp(columns, 1.0, double(kMostColumns)));
  width_ = width > 0 ? width / columns_ : 1;
  height_ = height > 0 ? height / rows_ : 1;
  steps_.assign(std::size_t{columns_ + 1} * rows_, 0);
}

void CoverSamples::add(const std::array<Point2, 3>& corners) {
  // The sample points have rows r with r + 1/2 in [low, high), and columns likewise.
  const auto first = [](double v, std::uint32_t n) {
    return static_cast<std::uint32_t>(std::clamp(std::ceil(v - 0.5), 0.0, double(n)));
  };
  std::array<Point2, 3> p{};
  for (int k = 0; k < 3; ++k) p[k] = {(corners[k].x - corner_.x) / width_, (corners[k].y - corner_.y) / height_};
  const auto [low, high] = std::minmax({p[0].y, p[1].y, p[2].y});
  for (std::uint32_t row = first(low, rows_); row < first(high, rows_); ++row) {
    const double y = row + 0.5;
    double left = columns_, right = 0;
    for (int k = 0; k < 3; ++k) {
      const Point2 a = p[k], b = p[(k + 1) % 3];
      if ((a.y <= y) == (b.y <= y)) continue;
      const double x = x_at(a, b, y);
      left = std::min(left, x);
      right = std::max(right, x);
    }
    if (!(left < right)) continue;
    std::int32_t* steps = steps_.data() + std::size_t{columns_ + 1} * row;
    ++steps[first(left, columns_)];
    --steps[first(right, columns_)];
  }
}

CoverSamples::Cover CoverSamples::cover() const {
  Cover cover;
  std::uint64_t sum = 0, covered = 0;
  for (std::uint32_t row = 0; row < rows_; ++row) {
    std::int32_t count = 0;
    for (std::uint32_t column = 0; column < columns_; ++column) {
      count += steps_[std::size_t{columns_ + 1} * row + column];
      sum += static_cast<std::uint64_t>(count);
      covered += count > 0;
      cover.most = std::max(cover.most, static_cast<std::uint32_t>(count));
    }
  }
  if (covered > 0) cover.mean = static_cast<double>(sum) / static_cast<double>(covered);
  cover.share = static_cast<double>(covered) / (double(rows_) * columns_);
  return cover;
}

/// Number of rows of sample points, on the page and on the plan, at which faces are counted.
constexpr std::uint32_t kSampleRows = 512;

Point2 at(LatticePoint p) { return {double(p.x), double(p.y)}; }

bool is_transparent(const ProjectedScene& scene, std::uint32_t face) {
  return face < scene.face_is_transparent.size() && scene.face_is_transparent[face];
}

double area_of(const ProjectedScene& scene, const Triangle& t) {
  return orientation(scene.vertices[t.v[0]].p, scene.vertices[t.v[1]].p, scene.vertices[t.v[2]].p);
}

/// The faces with facets, and their extents.
struct FaceBoxes {
  std::vector<std::uint32_t> faces;
  std::vector<AxisBox> boxes;
  std::vector<FaceExtent> extents;
  Rect around{};  ///< of all of them
};

FaceBoxes boxes_of(const ProjectedScene& scene, const std::vector<Facet>& facets) {
  FaceBoxes found;
  std::vector<std::uint32_t> number;
  for (const Facet& f : facets) {
    if (f.face >= number.size()) number.resize(f.face + 1, kNone);
    if (number[f.face] == kNone) {
      number[f.face] = static_cast<std::uint32_t>(found.faces.size());
      found.faces.push_back(f.face);
      found.extents.push_back({{1e300, 1e300, f.z_near}, {-1e300, -1e300, f.z_far}});
    }
    auto& [low, high] = found.extents[number[f.face]];
    low[2] = std::min<double>(low[2], f.z_near);
    high[2] = std::max<double>(high[2], f.z_far);
    for (const std::uint32_t v : f.v) {
      const Point2 p = at(scene.vertices[v].p);
      low[0] = std::min(low[0], p.x), low[1] = std::min(low[1], p.y);
      high[0] = std::max(high[0], p.x), high[1] = std::max(high[1], p.y);
    }
  }
  for (const auto& [low, high] : found.extents) {
    if (found.boxes.empty()) found.around = {{low[0], low[1]}, {high[0], high[1]}};
    found.around = {glm::min(found.around.min, Point2{low[0], low[1]}),
                    glm::max(found.around.max, Point2{high[0], high[1]})};
    found.boxes.push_back({low[0], low[1], high[0], high[1]});
  }
  return found;
}

void count_zones(const std::vector<AxisBox>& boxes, SceneTraits& traits) {
  DisjointSets sets = connect_boxes(boxes);
  std::vector<std::size_t> size(boxes.size(), 0);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const std::size_t n = ++size[sets.find(i)];
    traits.zones += n == 1;
    traits.largest_zone = std::max(traits.largest_zone, n);
  }
}

/// Counts the faces by their windings, and the projected area of those that are visible.
void count_faces(const ProjectedScene& scene, const FaceBoxes& boxes, const FacesInFront& visible, SceneTraits& traits) {
  std::vector<double> areas(visible.flags.size(), 0);  // twice the area, negative if it faces the viewer
  for (const Triangle& t : scene.triangles) {
    if (t.face < areas.size()) areas[t.face] += area_of(scene, t);
  }
  double visible_area = 0;
  traits.faces = boxes.faces.size();
  for (const std::uint32_t f : boxes.faces) {
    // Counter-clockwise as seen is a negative turn on the page, whose y axis points down.
    traits.front_faces += areas[f] < 0;
    traits.transparent_faces += is_transparent(scene, f);
    if (!visible.flags[f]) continue;
    ++traits.visible_faces.n;
    visible_area += std::abs(areas[f]) / 2;
  }
  traits.visible_faces.complete = visible.complete;
  const double picture = boxes.around.width() * boxes.around.height();
  if (traits.visible_faces.n > 0) traits.mean_visible_part = visible_area / double(traits.visible_faces.n) / picture;
}

/// Counts corners, and the faces that are not convex.
void count_corners(const Scene& scene, std::vector<std::uint32_t> faces, SceneTraits& traits) {
  if (faces.empty()) return;
  if (scene.faces.all_triangles()) {
    traits.mean_corners = 3;
    traits.most_corners = 3;
    return;
  }
  std::sort(faces.begin(), faces.end());
  std::uint64_t sum = 0;
  std::size_t next = 0;
  for (const Object& object : scene.objects) {
    if (object.face_begin == object.face_end) continue;
    const auto [low, high] = bounds_of(scene, object.vertex_begin, object.vertex_end);
    const double tolerance = straightness_tolerance(object.precision, glm::distance(low, high));
    for (; next < faces.size() && faces[next] < object.face_end; ++next) {
      std::size_t corners = 0;
      for (std::size_t c = 0; c < scene.faces.contour_count(faces[next]); ++c) {
        corners += scene.faces.contour(faces[next], c).size();
      }
      sum += corners;
      traits.most_corners = std::max(traits.most_corners, corners);
      traits.nonconvex_faces += !is_convex_face(scene, faces[next], tolerance);
    }
  }
  traits.mean_corners = double(sum) / double(faces.size());
}

/// Counts the vertices that are above, or below, both their neighbours on a contour of a face. Of two vertices at equal
/// height, the left one counts as higher, so that a horizontal side makes one such vertex and not two. Contours consist
/// of the sides that belong to one triangle of the face.
std::size_t count_turning_vertices(const ProjectedScene& scene, const std::vector<Facet>& facets) {
  struct Side {
    std::uint32_t face, from, to;
    auto key() const { return std::tuple(face, std::min(from, to), std::max(from, to)); }
  };
  std::vector<Side> sides;
  for (const Facet& f : facets) {
    for (int k = 0; k < 3; ++k) sides.push_back({f.face, scene.place(f.v[k]), scene.place(f.v[(k + 1) % 3])});
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.key() < b.key(); });
  // For each side of a contour, whether it goes down or up from each of its ends.
  std::vector<std::array<std::uint32_t, 3>> ends;  // face, vertex, 1 for a side that goes down
  const auto above = [&](std::uint32_t a, std::uint32_t b) {
    const LatticePoint p = scene.vertices[a].p, q = scene.vertices[b].p;
    return p.y != q.y ? p.y < q.y : p.x < q.x;
  };
  for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
    for (end = i + 1; end < sides.size() && sides[end].key() == sides[i].key(); ++end) {
    }
    if (end - i != 1) continue;
    const bool down = above(sides[i].from, sides[i].to);
    ends.push_back({sides[i].face, sides[i].from, down});
    ends.push_back({sides[i].face, sides[i].to, !down});
  }
  std::sort(ends.begin(), ends.end());
  std::vector<std::uint32_t> turning;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    if (ends[i] == ends[i + 1]) turning.push_back(ends[i++][1]);
  }
  std::sort(turning.begin(), turning.end());
  return static_cast<std::size_t>(std::unique(turning.begin(), turning.end()) - turning.begin());
}

/// Counts the convex ones among the sets of triangles that are connected by vertices. Each set is tested as a scene of
/// its own.
std::size_t count_convex_objects(const ProjectedScene& scene) {
  DisjointSets sets(scene.vertices.size());
  for (const Triangle& t : scene.triangles) {
    sets.join(t.v[0], t.v[1]);
    sets.join(t.v[1], t.v[2]);
  }
  std::vector<std::uint32_t> by_set(scene.triangles.size());
  for (std::uint32_t i = 0; i < by_set.size(); ++i) by_set[i] = i;
  const auto set_of = [&](std::uint32_t triangle) { return sets.find(scene.triangles[triangle].v[0]); };
  std::stable_sort(by_set.begin(), by_set.end(), [&](std::uint32_t a, std::uint32_t b) { return set_of(a) < set_of(b); });
  std::size_t convex = 0;
  std::vector<std::uint32_t> vertex_number(scene.vertices.size(), kNone);
  for (std::size_t begin = 0, end = 0; begin < by_set.size(); begin = end) {
    ProjectedScene body{.lattice = scene.lattice, .view = scene.view, .input_error_mm = scene.input_error_mm};
    std::map<std::uint32_t, std::uint32_t> face_number;
    bool opaque = true;
    for (end = begin; end < by_set.size() && set_of(by_set[end]) == set_of(by_set[begin]); ++end) {
      const Triangle& t = scene.triangles[by_set[end]];
      Triangle copy = t;
      copy.face = face_number.emplace(t.face, static_cast<std::uint32_t>(face_number.size())).first->second;
      for (std::uint32_t& v : copy.v) {
        if (vertex_number[v] == kNone) {
          vertex_number[v] = static_cast<std::uint32_t>(body.vertices.size());
          body.vertices.push_back(scene.vertices[v]);
        }
        v = vertex_number[v];
      }
      opaque = opaque && !is_transparent(scene, t.face);
      body.triangles.push_back(copy);
    }
    if (!opaque) continue;
    if (!scene.face_is_edge_on.empty()) {
      body.face_is_edge_on.resize(face_number.size());
      for (const auto& [face, number] : face_number) body.face_is_edge_on[number] = scene.face_is_edge_on[face];
    }
    convex += convexity::why_not_one_convex_body(body, convexity::face_the_viewer(body)).empty();
  }
  return convex;
}

/// The position on the plan of the scene, by its two horizontal axes.
Point2 in_plan(const Point3& p, Axis up) {
  return up == Axis::x ? Point2{p.y, p.z} : up == Axis::y ? Point2{p.z, p.x} : Point2{p.x, p.y};
}

/// Whether no vertical line meets the scene twice. Tests exactly that neighbours lie on opposite sides of their common
/// line, and by samples that no point of the plan has two triangles.
bool is_height_field(const Scene& scene, const Topology& topology, Axis up) {
  if (topology.triangles.empty()) return false;
  struct Side {
    std::uint32_t low, high, third;
  };
  std::vector<Side> sides;
  const auto plan = [&](std::uint32_t v) { return in_plan(scene.vertices[v], up); };
  Rect around{plan(topology.triangles[0].v[0]), plan(topology.triangles[0].v[0])};
  for (const Triangle& t : topology.triangles) {
    const Point2 p[3] = {plan(t.v[0]), plan(t.v[1]), plan(t.v[2])};
    if (orientation_sign(p[0], p[1], p[2]) == 0) return false;
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t.v[k], b = t.v[(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), t.v[(k + 2) % 3]});
      around = {glm::min(around.min, p[k]), glm::max(around.max, p[k])};
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tuple(a.low, a.high, a.third) < std::tuple(b.low, b.high, b.third);
  });
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &a = sides[i], &b = sides[i + 1];
    if (a.low != b.low || a.high != b.high) continue;
    const auto side_of = [&](std::uint32_t v) { return orientation_sign(plan(a.low), plan(a.high), plan(v)); };
    if (side_of(a.third) == side_of(b.third)) return false;
  }
  CoverSamples samples(around, kSampleRows);
  for (const Triangle& t : topology.triangles) samples.add({plan(t.v[0]), plan(t.v[1]), plan(t.v[2])});
  return samples.cover().most <= 1;
}

void count_overlap(const ProjectedScene& scene, const std::vector<Facet>& facets, const Rect& around, SceneTraits& traits) {
  if (facets.empty()) return;
  CoverSamples samples(around, kSampleRows);
  for (const Facet& f : facets) {
    samples.add({at(scene.vertices[f.v[0]].p), at(scene.vertices[f.v[1]].p), at(scene.vertices[f.v[2]].p)});
  }
  const CoverSamples::Cover cover = samples.cover();
  traits.mean_overlap = cover.mean;
  traits.most_overlap = cover.most;
  traits.covered_part = cover.share;
}

}  // namespace

SceneTraits scene_traits(const Scene& scene, const Topology& topology, const ProjectedScene& projected, Axis up) {
  SceneTraits traits;
  const double coincidence_steps = coincidence_mm(projected) / projected.lattice.step_mm;
  const std::vector<Facet> facets = make_facets(projected, coincidence_steps).facets;
  const FaceBoxes boxes = boxes_of(projected, facets);
  count_zones(boxes.boxes, traits);
  count_corners(scene, boxes.faces, traits);
  traits.spread = spread_of(boxes.extents);
  count_overlap(projected, facets, boxes.around, traits);
  traits.convex_objects = count_convex_objects(projected);
  traits.turning_vertices = count_turning_vertices(projected, facets);
  const CellGrid grid = grid_of_all(projected, facets, coincidence_steps);
  count_faces(projected, boxes, find_faces_in_front(projected, facets, grid, boxes.around), traits);
  const FacePairs pairs = find_face_pairs(projected, facets, grid);
  traits.penetrations = {pairs.penetrating.size(), pairs.complete};
  traits.conflicts = {pairs.overlapping.size(), pairs.complete};
  traits.height_field = is_height_field(scene, topology, up);
  return traits;
}

}  // namespace ligne
