#include "oracle/parts.hpp"

namespace oracle {
namespace {

/// docs/numerics.md, "The near plane and faces seen edge on": a face as high as an A4 sheet is then a micrometre wide.
constexpr double kEdgeOnSine = 0.001 / 297;
/// Sines that differ from it by less than this factor may be told either way.
constexpr double kEdgeOnDoubt = 2;

using Contour = std::vector<SightPoint>;

Contour contour_of(const ligne::Scene& scene, std::size_t face, std::size_t contour, const Projection& projection) {
  Contour points;
  for (const std::uint32_t v : scene.faces.contour(face, contour))
    points.push_back(projection.sight_point(exact(scene.vertices[v])));
  return points;
}

/// Cuts off what is nearer than the near plane. A contour that leaves and comes back runs along the plane between; such
/// sides lie on each other in pairs where nothing is between them, and the count of sides comes out right.
Contour behind_near_plane(const Contour& contour, const Projection& projection) {
  Contour kept;
  for (std::size_t k = 0; k < contour.size(); ++k) {
    const SightPoint &p = contour[k], &q = contour[k + 1 == contour.size() ? 0 : k + 1];
    const bool p_out = projection.too_near(p), q_out = projection.too_near(q);
    if (!p_out) kept.push_back(p);
    if (p_out != q_out) {
      const Exact t = (projection.near() - p.f) / (q.f - p.f);
      kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y), projection.near()});
    }
  }
  return kept;
}

void set_plane(Face& face, const ligne::Scene& scene, std::size_t f) {
  const auto outer = scene.faces.contour(f, 0);
  const Vector3 origin = exact(scene.vertices[outer[0]]);
  Vector3 normal{0, 0, 0}, sum{0, 0, 0};
  for (std::size_t k = 0; k < outer.size(); ++k) {
    const Vector3 p = exact(scene.vertices[outer[k]]) - origin;
    const Vector3 q = exact(scene.vertices[outer[k + 1 == outer.size() ? 0 : k + 1]]) - origin;
    normal = normal + cross(p, q);
    sum = sum + p;
  }
  face.normal = normal;
  face.centre = origin + (Exact(1) / Exact(static_cast<double>(outer.size()))) * sum;
  face.flat = is_zero(normal);
}

void set_facing(Face& face, const ligne::Scene& scene, std::size_t f, const Projection& projection) {
  const Vector3 first = exact(scene.vertices[scene.faces.contour(f, 0)[0]]);
  const Vector3 sight = projection.perspective() ? first - projection.eye() : projection.forward();
  const Exact d = dot(face.normal, sight);
  if (face.flat || d == 0) return;
  const double sine = std::abs(to_double(d)) / (length(face.normal) * length(sight));
  face.facing_sure = sine < kEdgeOnSine / kEdgeOnDoubt || sine > kEdgeOnSine * kEdgeOnDoubt;
  if (sine > kEdgeOnSine) face.facing = d < 0 ? 1 : -1;
}

}  // namespace

void Box::add(const PagePoint& p) {
  x0 = std::min(x0, lower(p.x)), x1 = std::max(x1, upper(p.x));
  y0 = std::min(y0, lower(p.y)), y1 = std::max(y1, upper(p.y));
  z0 = std::min(z0, lower(p.z)), z1 = std::max(z1, upper(p.z));
}

std::vector<Face> make_faces(const ligne::Scene& scene, const Projection& projection, double input_error) {
  std::vector<Face> faces(scene.faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) {
    Face& face = faces[f];
    set_plane(face, scene, f);
    if (face.flat) continue;
    set_facing(face, scene, f, projection);
    bool edge_on = false;
    face.plane = projection.page_plane(face.normal, face.centre, input_error, edge_on);
    if (edge_on) continue;
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      const Contour contour = behind_near_plane(contour_of(scene, f, c, projection), projection);
      const auto first = static_cast<std::uint32_t>(face.corners.size()), n = static_cast<std::uint32_t>(contour.size());
      for (std::uint32_t k = 0; k < n; ++k) {
        const PagePoint p = projection.page_point(contour[k]);
        face.slack_mm = std::max(face.slack_mm, projection.mm_z() * std::abs(to_double(p.z - face.plane.z(p.x, p.y))));
        face.box.add(p);
        face.corners.push_back(p);
        face.corners_mm.push_back(projection.page_mm(p));
        face.sides.push_back({first + k, k + 1 == n ? first : first + k + 1});
      }
    }
    face.hides = face.corners.size() >= 3;
    face.gradient = std::hypot(to_double(face.plane.b) * projection.mm_z() / projection.mm_x(),
                               to_double(face.plane.c) * projection.mm_z() / projection.mm_y());
  }
  return faces;
}

// Edges of the scene and their classes (docs: "What a drawing is").

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
