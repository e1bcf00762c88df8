#include "scene/heal/heal.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <memory>
#include <span>

#include "base/parallel.hpp"
#include "scene/clean/cut_nonplanar.hpp"
#include "scene/heal/agree_windings.hpp"
#include "scene/heal/border_edges.hpp"
#include "scene/heal/border_gaps.hpp"
#include "scene/heal/collapse_edges.hpp"
#include "scene/heal/duplicate_faces.hpp"
#include "scene/heal/face_writer.hpp"
#include "scene/heal/merge_fine_vertices.hpp"
#include "scene/heal/sew_borders.hpp"
#include "scene/model/bounds.hpp"
#include "scene/model/paired_edges.hpp"

namespace ligne {
namespace {

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
  report.vertices_collapsed = collapse_short_edges(scene) + merge_fine_vertices(scene);
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
  count_edges_left(scene, topology, report);
  report.faces_turned = agree_windings(scene, topology);
  if (report.faces_turned > 0) topology = build_topology(scene);
  return report;
}

}  // namespace ligne
