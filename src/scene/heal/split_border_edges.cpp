#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <tuple>
#include <utility>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "base/parallel_each.hpp"
#include "scene/heal/border_edges.hpp"
#include "scene/heal/corner_uses.hpp"
#include "scene/heal/face_writer.hpp"
#include "scene/heal/sew_borders.hpp"
#include "scene/model/planarity.hpp"

namespace ligne {
namespace {

/// A vertex that lies on an edge of a face.
struct Split {
  std::uint32_t face = 0;
  std::uint32_t v0 = 0, v1 = 0;  ///< the ends of the edge, in ascending order
  double at = 0;                 ///< 0 at v0, 1 at v1
  std::uint32_t vertex = 0;

  friend bool operator<(const Split& a, const Split& b) {
    return std::tuple(a.face, a.v0, a.v1, a.at, a.vertex) < std::tuple(b.face, b.v0, b.v1, b.at, b.vertex);
  }
};

/// Moves vertices beside an edge onto it, if that bends the faces around the vertex less than the split would bend the
/// face of the edge. So straight edges and flat faces stay so.
std::size_t move_onto_edges(Scene& scene, const Object& object, std::span<const std::uint32_t> faces,
                            std::span<const Split> splits, std::vector<std::uint8_t>& settled) {
  std::vector<std::uint32_t> vertices;
  for (const Split& split : splits) vertices.push_back(split.vertex);
  const CornerUses uses(scene, object, faces, vertices);
  std::size_t moved = 0;
  for (const Split& split : splits) {
    if (settled[split.vertex]) continue;
    Point3& p = scene.vertices[split.vertex];
    const Point3 foot = scene.vertices[split.v0] + split.at * (scene.vertices[split.v1] - scene.vertices[split.v0]);
    const double bend_of_edge = std::abs(glm::dot(foot - p, face_normal(scene, split.face)));
    const bool moves = std::ranges::all_of(uses.of(split.vertex), [&](const CornerUse& use) {
      if (std::abs(glm::dot(foot - p, face_normal(scene, use.face))) >= bend_of_edge) return false;
      return !use.triangle || !turns_over(p, foot, scene.vertices[use.before], scene.vertices[use.after], object.precision);
    });
    if (!moves) continue;
    p = foot;
    settled[split.vertex] = 1;
    ++moved;
  }
  return moved;
}

/// Finds the splits. `inside`: a foot nearer than this to an end of the edge counts as that end.
std::vector<Split> splits_of(const Border& border, double distance, double inside) {
  const std::vector<std::uint32_t>& vertices = border.vertices();
  const BorderSearch search(border);
  std::vector<NearestPoint> nearest(vertices.size());
  parallel_each(
      vertices.size(), [&](std::size_t k) { nearest[k] = search.nearest(vertices[k], distance, inside); }, kSearchBlock);
  std::vector<Split> splits;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (nearest[k].segment == kNone) continue;
    const Edge& edge = border.edges()[nearest[k].segment];
    splits.push_back({edge.face0, edge.v0, edge.v1, nearest[k].at, vertices[k]});
  }
  return splits;
}

/// The vertices to be inserted between two corners, in order from the first to the second.
std::vector<std::uint32_t> between(std::span<const Split> splits, std::uint32_t from, std::uint32_t to) {
  const auto [low, high] = std::minmax(from, to);
  std::vector<std::uint32_t> vertices;
  for (const Split& split : splits) {
    if (split.v0 == low && split.v1 == high) vertices.push_back(split.vertex);
  }
  if (from > to) std::reverse(vertices.begin(), vertices.end());
  return vertices;
}

/// Cuts a triangle edge by edge, each from the opposite corner, so that no piece has all its corners on one edge.
class TriangleSplitter {
 public:
  TriangleSplitter(const std::vector<Point3>& vertices, std::span<const Split> splits)
      : vertices_(vertices), splits_(splits) {}

  /// Returns nothing if a piece would turn over.
  std::optional<std::vector<CutTriangle>> run(const CutTriangle& triangle) {
    normal_ = normal_of(triangle);
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::pair(triangle.vertices[k], triangle.vertices[(k + 1) % 3]);
      along_[k] = between(splits_, a, b);
    }
    cut(triangle, {0, 1, 2});
    for (const CutTriangle& piece : pieces_) {
      if (!(glm::dot(normal_of(piece), normal_) > 0)) return std::nullopt;
    }
    return std::move(pieces_);
  }

 private:
  Point3 normal_of(const CutTriangle& t) const {
    const Point3 a = vertices_[t.vertices[0]];
    return glm::cross(vertices_[t.vertices[1]] - a, vertices_[t.vertices[2]] - a);
  }

  /// `edge[k]`: the edge of the whole triangle on which edge k lies, or -1 if it is a cut.
  void cut(const CutTriangle& t, std::array<int, 3> edge) {
    for (int k = 0; k < 3; ++k) {
      if (edge[k] < 0 || along_[edge[k]].empty()) continue;
      const int next = (k + 1) % 3, apex = (k + 2) % 3;
      const std::vector<std::uint32_t> inserted = std::exchange(along_[edge[k]], {});
      std::uint32_t from = t.vertices[k];
      for (std::size_t i = 0; i <= inserted.size(); ++i) {
        const bool first = i == 0, last = i == inserted.size();
        const std::uint32_t to = last ? t.vertices[next] : inserted[i];
        const CutTriangle piece{{from, to, t.vertices[apex]},
                                {t.flags[k], last ? t.flags[next] : std::uint8_t{kCornerInner},
                                 first ? t.flags[apex] : std::uint8_t{kCornerInner}}};
        cut(piece, {-1, last ? edge[next] : -1, first ? edge[apex] : -1});
        from = to;
      }
      return;
    }
    pieces_.push_back(t);
  }

  const std::vector<Point3>& vertices_;
  std::span<const Split> splits_;
  Point3 normal_{0, 0, 0};
  std::array<std::vector<std::uint32_t>, 3> along_;
  std::vector<CutTriangle> pieces_;
};

DetachedFace with_vertices(const DetachedFace& face, std::span<const Split> splits) {
  DetachedFace out;
  std::uint32_t begin = 0;
  for (const std::uint32_t end : face.contour_end) {
    for (std::uint32_t k = begin; k < end; ++k) {
      const std::uint32_t next = k + 1 == end ? begin : k + 1;
      out.corners.push_back(face.corners[k]);
      for (const std::uint32_t v : between(splits, face.corners[k], face.corners[next])) out.corners.push_back(v);
      out.flags.resize(out.corners.size(), face.flags[k]);
    }
    out.contour_end.push_back(static_cast<std::uint32_t>(out.corners.size()));
    begin = end;
  }
  return out;
}

/// The face or the triangles that replace a face with splits.
struct SplitFace {
  std::uint32_t face = 0;
  std::size_t splits = 0;
  std::optional<DetachedFace> whole{};
  std::vector<CutTriangle> pieces{};
};

/// Returns nothing if the face can not be split.
std::optional<SplitFace> split_face(const Scene& scene, double precision, std::span<const Split> splits) {
  SplitFace split{splits[0].face, splits.size()};
  const DetachedFace face = loose_face(scene, split.face);
  if (face.corners.size() == 3) {
    const CutTriangle triangle{{face.corners[0], face.corners[1], face.corners[2]},
                               {face.flags[0], face.flags[1], face.flags[2]}};
    auto pieces = TriangleSplitter(scene.vertices, splits).run(triangle);
    if (!pieces) return std::nullopt;
    split.pieces = std::move(*pieces);
    return split;
  }
  DetachedFace whole = with_vertices(face, splits);
  if (is_planar(scene.vertices, whole, precision)) {
    split.whole = std::move(whole);
    return split;
  }
  bool covered = true;
  split.pieces = cut_into_triangles(scene.vertices, whole, covered);
  if (!covered || split.pieces.empty()) return std::nullopt;
  return split;
}

/// `splits` are sorted.
std::vector<SplitFace> split_faces(const Scene& scene, double precision, std::span<const Split> splits) {
  std::vector<SplitFace> faces;
  for (std::size_t k = 0; k < splits.size();) {
    std::size_t end = k;
    while (end < splits.size() && splits[end].face == splits[k].face) ++end;
    std::optional<SplitFace> split = split_face(scene, precision, splits.subspan(k, end - k));
    if (split) faces.push_back(std::move(*split));
    k = end;
  }
  return faces;
}

}  // namespace

EdgeSplits split_border_edges(Scene& scene, Sewing& sewing) {
  struct OfObject {
    std::size_t moved = 0;
    std::vector<SplitFace> faces;
  };
  std::vector<OfObject> objects(scene.objects.size());
  // Objects share neither vertices nor faces.
  parallel_tasks(scene.objects.size(), [&](std::size_t i) {
    if (!(sewing.distances[i] > 0)) return;
    const Object& object = scene.objects[i];
    const std::span<const std::uint32_t> faces = faces_of(object, sewing.faces);
    const Border border(scene, border_edges(scene, object, sewing.may_be_on_border, faces));
    const double inside = straightness_tolerance(object.precision, border.median_length());
    std::vector<Split> splits = splits_of(border, sewing.distances[i], inside);
    if (splits.empty()) {
      sewing.distances[i] = 0;
      return;
    }
    std::sort(splits.begin(), splits.end());
    objects[i].moved = move_onto_edges(scene, object, faces, splits, sewing.settled);
    objects[i].faces = split_faces(scene, object.precision, splits);
  });
  EdgeSplits done;
  for (const OfObject& object : objects) {
    done.vertices_moved += object.moved;
    for (const SplitFace& split : object.faces) done.splits += split.splits;
  }
  if (done.splits == 0) return done;
  FaceWriter writer(scene);
  std::uint32_t written = 0;
  for (const OfObject& object : objects) {  // objects own ascending ranges of the faces
    for (const SplitFace& split : object.faces) {
      writer.keep(written, split.face);
      if (split.whole) writer.replace(split.face, *split.whole);
      for (const CutTriangle& piece : split.pieces) writer.replace(split.face, piece);
      written = split.face + 1;
    }
  }
  writer.keep(written, static_cast<std::uint32_t>(scene.faces.size()));
  writer.finish(&sewing.faces);
  return done;
}

}  // namespace ligne
