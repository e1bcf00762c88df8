#include "scene/patches/parts/large_freeform.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "base/indices_where.hpp"
#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/patches/borders/patch_outlines.hpp"
#include "scene/patches/facet_graph.hpp"
#include "scene/patches/facets/flat_joints.hpp"
#include "scene/patches/freeform.hpp"
#include "scene/patches/search/patch_finder.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Least number of triangles of a large object. The parts round the samples of a smaller one would be most of it.
constexpr std::uint32_t kFewestFaces = 150'000;
/// Number of samples, twice as many as PatchFinder::run() takes for the same number of successes: an object that seems free
/// here seems so there.
constexpr std::uint32_t kSamples = 128;
/// Number of faces round a sample: more than a surface is fitted to before it grows.
constexpr std::size_t kFacesAtSample = 400;
/// Largest part of the edges that may lie inside planes, or in pairs of triangles that may be planes.
constexpr std::size_t kFlatShare = 64;
/// Least cosine of a bend that is surely below kLargestBend, however the normals of facets are computed (25 degrees).
constexpr float kSurelySmooth = 0.906F;
/// Largest ratio of the depths of two facets that is surely below kPlaneDepths, however they are computed.
constexpr double kSurelyAlike = 0.999 * kPlaneDepths;
/// Rings of faces round those in planes: they contain kFewestFreeform facets. Rings round planes that may end free forms:
/// they contain what freeform_borders() looks at.
constexpr int kRingsRoundFlat = 2, kRingsRoundPlanes = 6;

/// A face at each of some edges, spread evenly: the one whose third corner is the lower, so that the order of faces does not
/// matter.
std::vector<std::uint32_t> sampled_faces(const TriangleObject& whole) {
  std::vector<std::uint32_t> faces;
  const auto sum = [&](std::uint32_t face) {
    const auto contour = whole.scene.faces.contour(face, 0);
    return std::accumulate(contour.begin(), contour.end(), std::uint64_t{0});
  };
  for (std::uint64_t i = 0; i < kSamples; ++i) {
    const Edge& edge = whole.edge((2 * i + 1) * whole.edge_count() / (2 * kSamples));
    const bool is_second = edge.face1 != kNone && sum(edge.face1) < sum(edge.face0);
    faces.push_back((is_second ? edge.face1 : edge.face0) - whole.object.face_begin);
  }
  return faces;
}

/// The graph of a part. `joints`: those of the whole object.
FacetGraph graph_of(const MeshPart& part, const TriangleObject& whole, std::span<const std::uint32_t> joints) {
  std::vector<std::uint32_t> own;
  auto joint = joints.begin();
  const auto count = static_cast<std::uint32_t>(part.topology.edges.size());
  for (std::uint32_t e = 0; e < count; ++e) {
    while (joint != joints.end() && whole.edges.begin + *joint < part.edges[e]) ++joint;
    if (joint == joints.end()) break;
    const bool is_joint = whole.edges.begin + *joint == part.edges[e];
    if (is_joint && part.topology.edges[e].face1 != kNone) own.push_back(e);
  }
  return facet_graph(part.scene, part.topology, part.scene.objects[0], {0, count}, part.normals, own);
}

/// Whether hardly any surface is found near samples, and few faces lie in planes.
bool seems_free(const FaceWalk& walk, std::span<const std::uint32_t> joints) {
  const TriangleObject& whole = walk.whole();
  const std::vector<std::uint32_t> samples = sampled_faces(whole);
  FaceSet near_samples(whole);
  constexpr std::uint8_t kNotReached = 255;
  static_assert(kSamples < kNotReached);
  std::vector<std::uint8_t> reached_by(whole.face_count(), kNotReached);
  std::vector<std::uint32_t> near;
  for (std::size_t sample = 0; sample < samples.size(); ++sample) {
    const auto i = static_cast<std::uint8_t>(sample);
    near.assign(1, samples[i]);
    reached_by[samples[i]] = i;
    for (std::size_t k = 0; k < near.size() && near.size() < kFacesAtSample; ++k) {
      walk.for_neighbours(near[k], [&](std::uint32_t f) {
        if (std::exchange(reached_by[f], i) != i) near.push_back(f);
      });
    }
    for (const std::uint32_t f : near) near_samples.add(f);
  }
  const MeshPart part = part_of(walk, near_samples);
  const FacetGraph graph = graph_of(part, whole, joints);
  // The limit for all edges, with some room: there are 1.5 for each face. Two triangles are seldom a plane.
  std::size_t in_planes = 0;
  for (std::uint32_t facet = 0; facet < graph.size(); ++facet) {
    if (const std::size_t count = graph.faces[facet].size(); count > 2) in_planes += count - 1;
  }
  if (kFlatShare * in_planes > 2 * part.faces.size()) return false;
  std::vector<std::uint32_t> facets;
  for (const std::uint32_t f : samples) {
    const auto at = std::ranges::lower_bound(part.faces, f);
    facets.push_back(graph.facet_of[static_cast<std::size_t>(at - part.faces.begin())]);
  }
  return PatchFinder(part.scene, part.topology, part.scene.objects[0], graph).seems_free(facets, whole.face_count());
}

/// Finds pairs of triangles in one plane that are surely a part of a free form, as freeform_facets() says. Its facets are
/// single triangles and such pairs here. Two of them are alike if the surface is surely smooth between them and neither is
/// much deeper than the other; so both are no planes. kFewestFreeform that are connected so are a free form.
class FreePairs {
 public:
  FreePairs(const FaceWalk& walk, std::span<const std::uint32_t> joints)
      : walk_(walk), whole_(walk.whole()), partner_(whole_.face_count(), kNone), is_free_(whole_.face_count()) {
    const std::uint32_t many = whole_.face_count();
    for (const std::uint32_t k : joints) {
      const auto [f, g] = faces_at(k);
      partner_[f] = partner_[f] == kNone ? g : many;
      partner_[g] = partner_[g] == kNone ? f : many;
    }
  }

  /// Whether the two faces at a joint are such a pair. Several threads may ask.
  bool has(std::uint32_t joint) {
    const auto [f, g] = faces_at(joint);
    if (partner_[f] != g || partner_[g] != f) return false;
    std::array<std::uint32_t, kFewestFreeform> facets{std::min(f, g)};
    std::size_t count = 1;
    bool is_found = is_free_[facets[0]].load(std::memory_order_relaxed) != 0;
    if (!is_found && (is_narrow(f) || is_narrow(g))) return false;
    for (std::size_t i = 0; i < count && !is_found; ++i) {
      const std::uint32_t one = facets[i], other = partner_[one];
      for (const std::uint32_t face : {one, other}) {
        if (face == kNone || is_found) continue;
        walk_.for_edges(face, [&](std::uint32_t k) {
          const std::uint32_t next = is_found ? kNone : alike_beyond(face, k);
          const auto end = facets.begin() + count;
          if (next == kNone || std::find(facets.begin(), end, next) != end) return;
          facets[count++] = next;
          is_found = count == facets.size() || is_free_[next].load(std::memory_order_relaxed) != 0;
        });
      }
    }
    if (!is_found) return false;
    for (std::size_t i = 0; i < count; ++i) is_free_[facets[i]].store(1, std::memory_order_relaxed);
    return true;
  }

 private:
  std::array<std::uint32_t, 2> faces_at(std::uint32_t k) const {
    const Edge& edge = whole_.edge(k);
    return {edge.face0 - whole_.object.face_begin, edge.face1 - whole_.object.face_begin};
  }

  bool is_narrow(std::uint32_t face) const {
    return is_narrow_triangle(whole_.scene, whole_.object, whole_.object.face_begin + face);
  }

  /// Square of the largest distance of the corners of the facet of a face from the line of an edge of the face, times that
  /// of its length.
  double squared_depth(std::uint32_t face, const Edge& edge) const {
    const Point3& from = whole_.scene.vertices[edge.v0];
    const Point3 along = whole_.scene.vertices[edge.v1] - from;
    double most = 0;
    for (const std::uint32_t f : {face, partner_[face]}) {
      if (f == kNone) continue;
      for (const std::uint32_t v : whole_.scene.faces.contour(whole_.object.face_begin + f, 0)) {
        if (v == edge.v0 || v == edge.v1) continue;
        const Point3 across = glm::cross(along, whole_.scene.vertices[v] - from);
        most = std::max(most, glm::dot(across, across));
      }
    }
    return most;
  }

  /// The lower face of the facet beyond an edge of a face, if both are alike; else kNone.
  std::uint32_t alike_beyond(std::uint32_t face, std::uint32_t k) const {
    if (!may_be_smooth(whole_.topology, whole_.edges.begin + k)) return kNone;
    const std::array faces = faces_at(k);
    const std::uint32_t next = faces[0] == face ? faces[1] : faces[0], partner = partner_[next];
    if (partner == face || partner == whole_.face_count() || (partner != kNone && partner_[partner] != next)) return kNone;
    const std::uint32_t first = whole_.object.face_begin;
    if (glm::dot(whole_.angles.normals[first + face], whole_.angles.normals[first + next]) < kSurelySmooth) return kNone;
    const double here = squared_depth(face, whole_.edge(k)), there = squared_depth(next, whole_.edge(k));
    constexpr double kMost = kSurelyAlike * kSurelyAlike;
    if (!(here < kMost * there && there < kMost * here) || is_narrow(next)) return kNone;
    if (partner == kNone) return next;
    return is_narrow(partner) ? kNone : std::min(next, partner);
  }

  const FaceWalk& walk_;
  const TriangleObject& whole_;
  /// Per face of the object: the other one if it lies in one plane with exactly one, kNone if with none, else the number of
  /// faces.
  std::vector<std::uint32_t> partner_;
  std::vector<std::atomic<std::uint8_t>> is_free_;  ///< per face: 1 where its facet, named by the lower face, is known to be
};

/// The findings of a part of a free form.
class PartFindings {
 public:
  PartFindings(const MeshPart& part, const TriangleObject& whole, std::span<const std::uint32_t> joints)
      : part_(part), graph_(graph_of(part, whole, joints)), patch_of_(graph_.size(), kNone), freeform_(find_freeform()) {}

  /// The faces of the facets that are planes and have several faces, as numbers of the object. Single triangles are none.
  std::vector<std::uint32_t> faces_of_planes() const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t facet = 0; facet < graph_.size(); ++facet) {
      if (freeform_[facet]) continue;
      for (const std::uint32_t f : graph_.faces[facet]) found.push_back(part_.faces[f]);
    }
    return found;
  }

  /// Appends the edges inside planes.
  void add_plane_edges(std::vector<std::uint32_t>& edges) const {
    const auto count = static_cast<std::uint32_t>(part_.topology.edges.size());
    for (const std::uint32_t e :
         edges_inside_planes(part_.topology, part_.scene.objects[0], graph_, 0, count, part_.normals))
      edges.push_back(part_.edges[e]);
  }

  /// The borders of planes; other facets count as free.
  std::vector<FreeformBorder> borders(const std::vector<std::uint8_t>& is_freeform_face) {
    for (std::uint32_t facet = 0; facet < graph_.size(); ++facet) {
      freeform_[facet] = is_freeform_face[part_.faces[graph_.faces[facet][0]]];
    }
    std::vector<FreeformBorder> found =
        freeform_borders(part_.scene, part_.topology, graph_, {{}, patch_of_, freeform_}, {});
    for (FreeformBorder& border : found) border.edge = part_.edges[border.edge];
    return found;
  }

 private:
  std::vector<std::uint8_t> find_freeform() const {
    const EdgeRows rows(part_.scene, part_.topology, part_.normals);
    return freeform_facets(part_.scene, part_.topology, graph_, {{}, patch_of_, {}}, rows);
  }

  const MeshPart& part_;
  FacetGraph graph_;
  std::vector<std::uint32_t> patch_of_;  ///< per facet: kNone
  std::vector<std::uint8_t> freeform_;   ///< per facet
};

}  // namespace

std::optional<LargeFreeform> find_large_freeform(const TriangleObject& whole, std::vector<std::uint32_t>& joints) {
  joints = flat_joints(whole.scene, whole.topology, whole.object, whole.edges, whole.angles.normals, whole.angles.flat);
  if (whole.face_count() < kFewestFaces || !whole.scene.faces.all_triangles()) return std::nullopt;
  const FaceWalk walk(whole);
  if (!seems_free(walk, joints)) return std::nullopt;
  FreePairs pairs(walk, joints);
  const std::vector<std::uint32_t> in_planes =
      indices_where(joints.size(), [&](std::size_t i) { return !pairs.has(joints[i]); });
  if (in_planes.size() > whole.edge_count() / kFlatShare) return std::nullopt;
  LargeFreeform found;
  found.is_freeform.assign(whole.face_count(), 1);
  FaceSet planes(whole);
  {
    FaceSet flat(whole);
    for (const std::uint32_t i : in_planes) {
      const Edge& edge = whole.edge(joints[i]);
      for (const std::uint32_t f : {edge.face0, edge.face1}) flat.add(f - whole.object.face_begin);
    }
    flat.add_rings(walk, kRingsRoundFlat);
    const MeshPart part = part_of(walk, flat);
    const PartFindings findings(part, whole, joints);
    findings.add_plane_edges(found.plane_edges);
    for (const std::uint32_t f : findings.faces_of_planes()) planes.add(f);
  }
  if (planes.faces.empty()) return found;
  // Facets at the border of that part may seem to be planes.
  const std::vector<std::uint8_t> may_be_plane = planes.holds;
  planes.add_rings(walk, kRingsRoundPlanes);
  const MeshPart part = part_of(walk, planes);
  PartFindings findings(part, whole, joints);
  for (const std::uint32_t f : findings.faces_of_planes()) {
    if (may_be_plane[f]) found.is_freeform[f] = 0;
  }
  found.borders = findings.borders(found.is_freeform);
  return found;
}

}  // namespace ligne
