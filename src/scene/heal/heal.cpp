#include "scene/heal/heal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/clean/cut_nonplanar.hpp"
#include "scene/heal/border_edges.hpp"
#include "scene/heal/border_gaps.hpp"
#include "scene/heal/close_steps.hpp"
#include "scene/heal/duplicate_faces.hpp"
#include "scene/heal/face_writer.hpp"
#include "scene/heal/merge_ends.hpp"
#include "scene/heal/merge_fine_vertices.hpp"
#include "scene/heal/sew_borders.hpp"
#include "scene/model/bounds.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/model/find_edges.hpp"
#include "scene/model/precision.hpp"

namespace ligne {
namespace {

/// Collapses the edges that rounding has left of nothing.

/// Edges of this many roundings or more are not collapsed. A step of the coordinates is two roundings, so vertices that lie
/// on neighbouring steps of the coarsest coordinate stay apart.
constexpr double kLeastRoundings = 1.9;
/// Adjustable. A chain of such edges is collapsed over up to this many roundings.
constexpr double kChainRoundings = 8;

using VertexPair = std::array<std::uint32_t, 2>;

/// The least length of the edges of a face that stay.
double least_length(const Scene& scene, std::size_t face, double precision) {
  double largest = 0;
  for (const std::uint32_t v : scene.faces.contour(face, 0)) {
    const Point3& p = scene.vertices[v];
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  }
  return kLeastRoundings * std::min(precision, half_ulp_float32(largest));
}

/// Appends the short edges of some faces of an object.
void append_short_edges(const Scene& scene, const Object& object, std::span<const std::uint32_t> faces,
                        std::vector<VertexPair>& edges) {
  const double most = kLeastRoundings * object.precision;
  for (const std::uint32_t f : faces) {
    for_sides(scene.faces, f, [&](std::uint32_t v, std::uint32_t w) {
      const Point3 &p = scene.vertices[v], &q = scene.vertices[w];
      if (are_within(most, p, q) && are_within(least_length(scene, f, object.precision), p, q)) edges.push_back({v, w});
    });
  }
}

/// Merges the ends of edges that are shorter than a step of the coordinates, and drops the faces that vanish. Where
/// programs find one corner several times, each time rounded differently, needles without thickness connect these, and
/// some of them are turned over: their sides would be outlines in the midst of a plane. A step is
/// twice Object::precision, and that of a float32 at the largest coordinate of a face if this is less. A vertex moves by
/// up to four steps, over a chain of such edges. Returns the number of vertices that were merged. Takes O(n) time.
std::size_t collapse_short_edges(Scene& scene, const NarrowFaces& narrow) {
  std::vector<VertexPair> edges;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) append_short_edges(scene, scene.objects[i], narrow.faces[i], edges);
  std::vector<double> distances;
  for (const Object& object : scene.objects) distances.push_back(kChainRoundings * object.precision);
  return merge_ends(scene, edges, distances);
}

/// Makes windings agree: decides which side of a sheet is the front.

/// Reverses faces so that neighbours traverse their common edge in opposite directions. Works on each set of faces
/// connected by edges of two faces; of the two solutions it takes the one that reverses fewer faces. A one-sided set (a
/// Moebius strip) stays as it is. Returns the number of faces reversed. `topology` is that of the scene before. O(n);

bool joins_two_faces(const Topology& topology, std::size_t e) {
  const Edge& edge = topology.edges[e];
  return edge.face1 != kNone && edge.face0 != edge.face1 && !(topology.edge_flags[e] & kEdgeManyFaces);
}

/// The neighbours of each face across edges of two faces.
class Neighbours {
 public:
  struct Neighbour {
    std::uint32_t face;
    bool unlike;  ///< the windings disagree
  };

  Neighbours(std::size_t faces, const Topology& topology) : first_(faces + 1, 0) {
    for_each(topology, [&](std::uint32_t face, Neighbour) { ++first_[face + 1]; });
    for (std::size_t f = 0; f < faces; ++f) first_[f + 1] += first_[f];
    all_.resize(first_.back());
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for_each(topology, [&](std::uint32_t face, Neighbour n) { all_[next[face]++] = n; });
  }

  const Neighbour* begin(std::uint32_t face) const { return all_.data() + first_[face]; }
  const Neighbour* end(std::uint32_t face) const { return all_.data() + first_[face + 1]; }

 private:
  template <class Visit>
  static void for_each(const Topology& topology, Visit visit) {
    for (std::size_t e = 0; e < topology.edges.size(); ++e) {
      if (!joins_two_faces(topology, e)) continue;
      const Edge& edge = topology.edges[e];
      const bool unlike = (topology.edge_flags[e] & kEdgeUnlikeWound) != 0;
      visit(edge.face0, {edge.face1, unlike});
      visit(edge.face1, {edge.face0, unlike});
    }
  }

  std::vector<std::uint32_t> first_;
  std::vector<Neighbour> all_;
};

/// Reverses a face. Each edge keeps its flags, which belong to the corner where it begins.
void turn(Scene& scene, std::uint32_t face) {
  const std::span<std::uint32_t> corners = scene.faces.corners();
  for (std::size_t c = 0; c < scene.faces.contour_count(face); ++c) {
    const auto first = static_cast<std::ptrdiff_t>(scene.faces.corner_index(face, c));
    const auto count = static_cast<std::ptrdiff_t>(std::as_const(scene.faces).contour(face, c).size());
    std::reverse(corners.begin() + first + 1, corners.begin() + first + count);
    if (scene.corner_flags.empty()) continue;
    std::reverse(scene.corner_flags.begin() + first, scene.corner_flags.begin() + first + count);
  }
}

/// if all windings agree, only the edges are read.
std::size_t agree_windings(Scene& scene, const Topology& topology) {
  const auto disagrees = [&](std::uint32_t e) { return joins_two_faces(topology, e); };
  if (std::ranges::none_of(edges_with(topology, kEdgeUnlikeWound), disagrees)) return 0;
  const Neighbours neighbours(scene.faces.size(), topology);
  enum : std::uint8_t { unknown, as_first, turned };
  std::vector<std::uint8_t> winding(scene.faces.size(), unknown);
  std::vector<std::uint32_t> together;
  std::size_t count = 0;
  for (std::uint32_t start = 0; start < scene.faces.size(); ++start) {
    if (winding[start] != unknown) continue;
    together.assign(1, start);
    winding[start] = as_first;
    bool two_sided = true;
    std::size_t turns = 0;
    for (std::size_t i = 0; i < together.size(); ++i) {
      const std::uint32_t face = together[i];
      turns += winding[face] == turned;
      for (auto n = neighbours.begin(face); n != neighbours.end(face); ++n) {
        const std::uint8_t wanted = (winding[face] == turned) != n->unlike ? turned : as_first;
        if (winding[n->face] == unknown) {
          winding[n->face] = wanted;
          together.push_back(n->face);
        } else {
          two_sided = two_sided && winding[n->face] == wanted;
        }
      }
    }
    if (!two_sided) continue;
    const std::uint8_t fewer = 2 * turns <= together.size() ? turned : as_first;
    for (const std::uint32_t face : together) {
      if (winding[face] != fewer) continue;
      turn(scene, face);
      ++count;
    }
  }
  return count;
}

/// Largest number of rounds in which border edges are split. Adjustable.
constexpr int kMostRounds = 4;

double size_of(const Scene& scene) {
  if (scene.vertices.empty()) return 0;
  const auto [low, high] = bounds_of(scene, 0, scene.vertices.size());
  return glm::distance(low, high);
}

/// Marks the vertices and faces at which sewing may make borders. Triangles get new borders only between border
/// vertices; polygons may be cut anywhere. `faces`: all faces with a vertex on a border.
void take_border(const Scene& scene, const Object& object, const Border& border, std::span<const std::uint32_t> faces,
                 Sewing& sewing) {
  std::vector<std::uint8_t>& marked = sewing.may_be_on_border;
  if (scene.faces.all_triangles()) {
    for (const std::uint32_t v : border.vertices()) marked[v] = 1;
    const std::span<const std::uint32_t> own = faces_of(object, faces);
    sewing.faces.insert(sewing.faces.end(), own.begin(), own.end());
  } else {
    std::fill(marked.begin() + object.vertex_begin, marked.begin() + object.vertex_end, std::uint8_t{1});
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) sewing.faces.push_back(f);
  }
}

/// The places where borders may be.
struct NearBorders {
  std::vector<std::uint8_t> marked;  ///< per vertex: it may be on a border
  std::vector<std::uint32_t> faces;  ///< faces that have such a vertex
};

/// `ends`: marks of the ends of odd edges.
NearBorders near_borders(const Scene& scene, std::vector<std::uint8_t> ends) {
  NearBorders near{std::move(ends), {}};
  near.faces = faces_at(scene, near.marked);
  return near;
}

/// Finds the borders of the objects to be sewn. Sets their distances, and the findings in the report.
std::vector<std::unique_ptr<Border>> borders_to_sew(const Scene& scene, const HealOptions& options, const NearBorders& near,
                                                    Sewing& sewing, HealReport& report) {
  std::vector<std::unique_ptr<Border>> borders(scene.objects.size());
  const std::vector<std::uint8_t>& marked = near.marked;
  const std::vector<std::uint32_t>& faces = near.faces;
  if (faces.empty()) return borders;
  const double size = size_of(scene);
  sewing.may_be_on_border.assign(scene.vertices.size(), 0);
  std::vector<GapBreak> gaps(scene.objects.size());
  std::vector<std::size_t> counts(scene.objects.size());
  parallel_tasks(scene.objects.size(), [&](std::size_t i) {
    const Object& object = scene.objects[i];
    const std::span<const std::uint32_t> own = faces_of(object, faces);
    if (own.empty()) return;
    std::vector<Edge> edges = border_edges(scene, object, marked, own);
    counts[i] = edges.size();
    if (edges.empty()) return;
    auto border = std::make_unique<Border>(scene, std::move(edges));
    gaps[i] =
        options.sew_distance ? gaps_within(*border, *options.sew_distance) : find_gap_break(*border, object.precision, size);
    if (gaps[i].near > 0 && gaps[i].distance > 0) borders[i] = std::move(border);
  });
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    report.border_edges += counts[i];
    if (gaps[i].near == 0) continue;
    sewing.distances[i] = gaps[i].distance;
    if (borders[i]) take_border(scene, scene.objects[i], *borders[i], faces, sewing);
    report.sewn.push_back({i, gaps[i].distance, counts[i], counts[i], gaps[i].near, gaps[i].next});
  }
  return borders;
}

/// Cuts the polygons that are no longer planar because vertices moved.
void cut_bent_faces(Scene& scene, std::vector<std::uint32_t>& faces) {
  if (scene.faces.all_triangles()) return;
  FaceWriter writer(scene);
  for (const Object& object : scene.objects) {
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
      const DetachedFace face = loose_face(scene, f);
      bool covered = true;
      std::vector<CutTriangle> triangles;
      if (!is_planar(scene.vertices, face, object.precision)) triangles = cut_into_triangles(scene.vertices, face, covered);
      if (triangles.empty()) {
        writer.keep(f, f + 1);
        continue;
      }
      for (const CutTriangle& triangle : triangles) writer.replace(f, triangle);
    }
  }
  writer.finish(&faces);
}

/// Sews borders; returns whether there was anything to sew.
bool sew(Scene& scene, const HealOptions& options, const NearBorders& near, HealReport& report) {
  Sewing sewing{std::vector<double>(scene.objects.size(), 0)};
  {
    const std::vector<std::unique_ptr<Border>> borders = borders_to_sew(scene, options, near, sewing, report);
    if (report.sewn.empty()) return false;
    report.vertices_moved = join_border_vertices(scene, borders, sewing);
  }
  if (report.vertices_moved > 0) cut_bent_faces(scene, sewing.faces);
  // A split edge may now lie beside another vertex.
  for (int round = 0; round < kMostRounds; ++round) {
    const EdgeSplits split = split_border_edges(scene, sewing);
    if (split.splits == 0) break;
    report.edges_split += split.splits;
    report.vertices_moved += split.vertices_moved;
    if (split.vertices_moved > 0) cut_bent_faces(scene, sewing.faces);
  }
  return true;
}

void count_edges_left(const Scene& scene, const Topology& topology, HealReport& report) {
  if (report.sewn.empty()) return;
  const std::vector<std::vector<Edge>> left = border_edges(scene, topology);
  for (SewnBorders& sewn : report.sewn) sewn.edges_left = left[sewn.object].size();
  std::erase_if(report.sewn, [](const SewnBorders& sewn) { return sewn.edges_left >= sewn.edges; });
}

}  // namespace

HealReport heal(Scene& scene, Topology& topology, const HealOptions& options) {
  HealReport report;
  NarrowFaces narrow = find_narrow_faces(scene, kLeastRoundings);
  report.vertices_collapsed = collapse_short_edges(scene, narrow) + merge_fine_vertices(scene);
  if (report.vertices_collapsed > 0) narrow = find_narrow_faces(scene, kLeastRoundings);
  report.vertices_at_steps = close_steps(scene, narrow);
  const bool sews = options.sew_distance != 0.0;
  // Whether `topology` is that of the scene, which has no repeated face.
  const bool stated = scene.stated.has(StatedFact::adjacency);
  bool known = stated || (scene.faces.all_triangles() && scene.faces.size() >= options.topology_first_from);
  if (known) topology = build_topology(scene);
  known = known && (scene.faces.all_triangles() || is_paired(topology)) && !may_repeat_triangles(topology);
  // Nearly all files have no duplicates, and the borders found in parallel are then right.
  DuplicateFaces duplicates;
  NearBorders near;
  parallel_tasks(sews ? 2 : 1, [&](std::size_t task) {
    if (task == 0) {
      duplicates = find_duplicate_faces(scene, !known);
    } else {
      near = near_borders(scene, known ? ends_of_odd_edges(scene, topology) : ends_of_odd_edges(scene));
    }
  });
  report.objects_twice = duplicates.objects;
  report.faces_twice = duplicates.faces;
  drop_duplicate_faces(scene, duplicates);
  if (duplicates.faces > 0) {
    known = false;
    if (sews) near = near_borders(scene, ends_of_odd_edges(scene));
  }
  if (sews && sew(scene, options, near, report)) known = false;
  if (!known) {
    topology = {};
    topology = build_topology(scene);
  }
  topology.may_repeat_triangles = !(known && scene.faces.all_triangles());
  count_edges_left(scene, topology, report);
  report.faces_turned = agree_windings(scene, topology);
  if (report.faces_turned > 0) {
    const bool may_repeat = topology.may_repeat_triangles;
    topology = build_topology(scene);
    topology.may_repeat_triangles = may_repeat;
  }
  return report;
}

}  // namespace ligne
