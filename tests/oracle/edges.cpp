// Edges of the scene and their classes (docs: "What a drawing is").

#include <cmath>
#include <map>
#include <tuple>

#include "oracle/faces.hpp"

namespace oracle {
namespace {

/// The library adds 0.01 degrees to the crease angle and computes normals in float32 (docs/numerics.md); within this of
/// the angle an edge may be told either way.
constexpr double kCreaseDoubtDegrees = 0.05;

/// Sorting by position welds the vertices.
using Position = std::tuple<double, double, double>;

Position position(const Point3& p) { return {p.x + 0.0, p.y + 0.0, p.z + 0.0}; }  // + 0.0: -0 is 0

/// One run of a contour along an edge.
struct Run {
  std::uint32_t face;
  bool backwards;  ///< from the edge's second end to its first
  std::uint8_t flags;
};

using RunsByEdge = std::map<std::tuple<std::uint32_t, Position, Position>, std::vector<Run>>;

RunsByEdge find_runs(const ligne::Scene& scene) {
  RunsByEdge runs;
  for (std::uint32_t o = 0; o < scene.objects.size(); ++o) {
    for (std::uint32_t f = scene.objects[o].face_begin; f < scene.objects[o].face_end; ++f) {
      for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
        const auto contour = scene.faces.contour(f, c);
        for (std::size_t k = 0; k < contour.size(); ++k) {
          Position from = position(scene.vertices[contour[k]]);
          Position to = position(scene.vertices[contour[k + 1 == contour.size() ? 0 : k + 1]]);
          if (from == to) continue;
          const bool backwards = to < from;
          if (backwards) std::swap(from, to);
          const std::uint8_t flags = scene.corner_flags.empty() ? 0 : scene.corner_flags[scene.faces.corner_index(f, c) + k];
          runs[{o, from, to}].push_back({f, backwards, flags});
        }
      }
    }
  }
  return runs;
}

EdgeClass class_of(const std::vector<Run>& runs, const std::vector<Face>& faces, double crease_degrees) {
  if (runs.size() == 1) return EdgeClass::border;
  if (runs.size() > 2) return EdgeClass::crease;
  if (runs[0].face == runs[1].face) return EdgeClass::mesh;  // a seam
  const Face &a = faces[runs[0].face], &b = faces[runs[1].face];
  if (a.flat || b.flat || !a.facing_sure || !b.facing_sure) return EdgeClass::undecided;
  // Faces that run through the edge in the same direction are wound against each other: one of them is turned.
  const int turn = runs[0].backwards == runs[1].backwards ? -1 : 1;
  if (a.facing != turn * b.facing) return EdgeClass::outline;
  if (runs[0].flags & runs[1].flags & (ligne::kCornerFileHidden | ligne::kCornerInner)) return EdgeClass::mesh;
  const double cosine = turn * to_double(dot(a.normal, b.normal)) / (length(a.normal) * length(b.normal));
  const double degrees = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / 3.14159265358979323846;
  if (std::abs(degrees - crease_degrees) < kCreaseDoubtDegrees) return EdgeClass::undecided;
  return degrees > crease_degrees ? EdgeClass::crease : EdgeClass::mesh;
}

}  // namespace

std::vector<Edge> make_edges(const ligne::Scene& scene, const std::vector<Face>& faces, double crease_degrees) {
  std::vector<Edge> edges;
  for (const auto& [key, runs] : find_runs(scene)) {
    const auto& [object, from, to] = key;
    Edge edge;
    edge.object = object;
    edge.a = {std::get<0>(from), std::get<1>(from), std::get<2>(from)};
    edge.b = {std::get<0>(to), std::get<1>(to), std::get<2>(to)};
    for (const Run& run : runs) edge.faces.push_back(run.face);
    edge.edge_class = class_of(runs, faces, crease_degrees);
    edges.push_back(std::move(edge));
  }
  return edges;
}

}  // namespace oracle
