#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "base/add_counts.hpp"
#include "base/no_index.hpp"
#include "view/tolerances.hpp"
#include "visibility/common/clock.hpp"
#include "visibility/edges/line_strokes.hpp"
#include "visibility/methods.hpp"
#include "visibility/penetration/intersections.hpp"
#include "visibility/roberts/bodies.hpp"

// Phases: (1) bodies and their inequalities, (2) lines of penetration, (3) every line against the bodies in front of
// it. See docs/methods/roberts.md.

namespace ligne {
namespace {

using namespace roberts;

/// Counts for the statistics.
struct BodyCounts {
  std::uint64_t own = 0;     ///< lines hidden by their own body
  std::uint64_t bodies = 0;  ///< tests of a line against a body
  std::uint64_t beside = 0;  ///< such tests in which the line is outside the silhouette
  std::uint64_t before = 0;  ///< such tests in which the line is in front of the body
  std::uint64_t behind = 0;  ///< such tests in which the line is behind all planes
  std::uint64_t planes = 0;  ///< tests of a line against a plane
  std::uint64_t facets = 0;  ///< tests of a line against a facet: where the line touches or pierces the front
  void operator+=(const BodyCounts& o) { add_counts(*this, o); }
};

/// Counts of all threads.
struct BodyTotals {
  std::mutex mutex;
  BodyCounts counts;
};

enum class LineKind : std::uint8_t { edge, intersection };

/// Tests lines one by one. It keeps its working memory from line to line; the destructor adds the counts to `totals`.
class BodyLines {
 public:
  BodyLines(const Bodies& bodies, double coincidence_steps, LineKind kind, BodyTotals& totals)
      : bodies_(bodies), coincidence_steps_(coincidence_steps), kind_(kind), totals_(totals) {}
  BodyLines(const BodyLines&) = delete;
  BodyLines& operator=(const BodyLines&) = delete;
  ~BodyLines() {
    const std::lock_guard lock(totals_.mutex);
    totals_.counts += counts_;
  }

  /// Finds the visible parts of the line, in order, disjoint.
  void find(const PageLine& line, std::vector<LinePart>& parts);

 private:
  /// The bodies on which the line lies.
  struct Own {
    std::uint32_t bodies[2] = {kNone, kNone};
    bool hidden = false;     ///< one of them hides the whole line
    bool by_facets = false;  ///< they may hide it, and only facets can decide: the line names only one face of each
                             ///< body
  };
  /// Position of the line relative to a body's whole front.
  enum class Depth : std::uint8_t { before, behind, unknown };

  Own own_of(const PageLine& line) const;
  void take_body(const PageLine& line, const Body& body);
  bool clip_to_silhouette(const PageLine& line, const Body& body, HiddenInterval& inside) const;
  Depth depth_of(const PageLine& line, const Body& body, double enter, double leave);
  void take_facets(const PageLine& line, const Body& body);
  void take_facet(const PageLine& line, std::uint32_t facet);

  const Bodies& bodies_;
  double coincidence_steps_;
  LineKind kind_;
  BodyTotals& totals_;
  OpenParts open_;
  BodyCounts counts_;
};

/// Largest number of front faces of a body for which lines are tested plane by plane. Adjustable.
constexpr std::uint32_t kMostPlanes = 32;

/// Distance in depth of a point of the line behind the plane of a facet, and its error bound: each corner of the facet
/// may be off by the depth tolerance, weighted as its depth is.
struct PlaneDistance {
  double behind, error;
};

PlaneDistance distance_to_plane(const PageLine& line, double t, const Facet& facet, const ProjectedVertex* vertices) {
  const ProjectedVertex* p[3] = {&vertices[facet.v[0]], &vertices[facet.v[1]], &vertices[facet.v[2]]};
  const double x = line.p0.x + t * line.dx, y = line.p0.y + t * line.dy;
  const double area = orientation(p[0]->p, p[1]->p, p[2]->p);
  double depth = 0, weights = 0;
  for (int k = 0; k < 3; ++k) {
    const LatticePoint a = p[(k + 1) % 3]->p, b = p[(k + 2) % 3]->p;
    const double weight = ((double(b.x) - a.x) * (y - a.y) - (double(b.y) - a.y) * (x - a.x)) / area;
    depth += weight * p[k]->z;
    weights += std::abs(weight);
  }
  return {line.z(t) - depth, weights * facet.depth_tolerance};
}

void BodyLines::find(const PageLine& line, std::vector<LinePart>& parts) {
  const Own own = own_of(line);
  if (own.hidden) {
    ++counts_.own;
    return;
  }
  open_.reset(0, 1);
  bodies_.forest.for_each_before(bodies_.root, line, open_, [&](std::uint32_t number) {
    const Body& body = bodies_.list[number];
    if (number != own.bodies[0] && number != own.bodies[1]) {
      take_body(line, body);
    } else if (own.by_facets) {
      take_facets(line, body);
    }
  });
  if (!open_.empty()) parts = open_.finish();
}

/// A convex body does not hide its own edge if one of the edge's faces is a front face, or if the body has no front
/// faces. A line of penetration lies in a face of each of its two bodies.
BodyLines::Own BodyLines::own_of(const PageLine& line) const {
  Own own;
  if (line.face0 == kNone) return own;
  const auto body_of = [&](std::uint32_t face) { return face == kNone ? kNone : bodies_.of_face[face]; };
  const auto is_front = [&](std::uint32_t face) { return face != kNone && bodies_.is_front[face]; };
  const std::uint32_t first = body_of(line.face0), second = body_of(line.face1);
  own.bodies[0] = first;
  own.bodies[1] = second;
  const auto hides = [&](std::uint32_t body, bool seen) { return body != kNone && bodies_.has_front(body) && !seen; };
  if (line.face1 == kNone || first == second) {
    own.hidden = hides(first, is_front(line.face0) || is_front(line.face1));
  } else if (kind_ == LineKind::intersection) {
    own.hidden = hides(first, is_front(line.face0)) || hides(second, is_front(line.face1));
  } else {
    own.by_facets = true;  // bodies of one object meet in this edge, which has one face of each
  }
  return own;
}

void BodyLines::take_body(const PageLine& line, const Body& body) {
  ++counts_.bodies;
  HiddenInterval inside;
  if (!clip_to_silhouette(line, body, inside)) {
    ++counts_.beside;
    return;
  }
  switch (depth_of(line, body, inside.from, inside.to)) {
    case Depth::before:
      ++counts_.before;
      return;
    case Depth::unknown:
      take_facets(line, body);
      return;
    case Depth::behind:
      ++counts_.behind;
      open_.take(inside);
  }
}

/// Clips the line by the inequalities of the silhouette. The ends are quotients of exact determinants, as for facets.
/// If the line runs along a side of the silhouette, the body covers one side of the line.
bool BodyLines::clip_to_silhouette(const PageLine& line, const Body& body, HiddenInterval& inside) const {
  inside = {0, 1, HiddenSides::both};
  const LatticePoint* const corners = bodies_.hull.data();
  if (body.hull_end - body.hull_begin < 3) return false;
  LatticePoint a = corners[body.hull_end - 1];
  for (std::uint32_t i = body.hull_begin; i < body.hull_end; ++i) {
    const LatticePoint b = corners[i];
    const double q0 = orientation(a, b, line.p0), q1 = orientation(a, b, line.p1);
    if (q0 <= 0 && q1 <= 0) {
      if (q0 < 0 || q1 < 0) return false;
      const bool same_way = (double(b.x) - a.x) * line.dx + (double(b.y) - a.y) * line.dy > 0;
      inside.sides = same_way ? HiddenSides::left : HiddenSides::right;
    } else if (q0 < 0) {
      inside.from = std::max(inside.from, q0 / (q0 - q1));
    } else if (q1 < 0) {
      inside.to = std::min(inside.to, q0 / (q0 - q1));
    }
    a = b;
  }
  return std::max(inside.from, open_.from()) < std::min(inside.to, open_.to());
}

/// Applies the inequalities of the planes, as far as they are certain. The line is behind the body if it is behind all
/// planes, and in front if no part of it can be behind all of them.
BodyLines::Depth BodyLines::depth_of(const PageLine& line, const Body& body, double enter, double leave) {
  const double z_enter = line.z(enter), z_leave = line.z(leave);
  if (std::min(z_enter, z_leave) > double(body.z_far) + body.tolerance) return Depth::behind;
  if (std::max(z_enter, z_leave) <= body.box.z_near) return Depth::before;
  if (body.plane_end - body.plane_begin > kMostPlanes) return Depth::unknown;
  bool behind_all = true;
  double from = 0, to = 1;  // part of [enter, leave] that may be behind the planes so far
  for (std::uint32_t i = body.plane_begin; i < body.plane_end; ++i) {
    ++counts_.planes;
    const Facet& facet = bodies_.front[bodies_.planes[i]];
    const PlaneDistance first = distance_to_plane(line, enter, facet, bodies_.vertices.data());
    const PlaneDistance last = distance_to_plane(line, leave, facet, bodies_.vertices.data());
    const double error = std::max(first.error, last.error), d0 = first.behind + error, d1 = last.behind + error;
    if (d0 < 0 && d1 < 0) return Depth::before;
    if (d0 < 0) {
      from = std::max(from, d0 / (d0 - d1));
    } else if (d1 < 0) {
      to = std::min(to, d0 / (d0 - d1));
    }
    behind_all = behind_all && first.behind > first.error && last.behind > last.error;
  }
  if (behind_all) return Depth::behind;
  return from < to ? Depth::unknown : Depth::before;
}

void BodyLines::take_facets(const PageLine& line, const Body& body) {
  if (body.has_tree) {
    bodies_.forest.for_each_before(body.root, line, open_, [&](std::uint32_t f) { take_facet(line, body.front_begin + f); });
    return;
  }
  for (std::uint32_t f = body.front_begin; f < body.front_end && !open_.empty(); ++f) take_facet(line, f);
}

void BodyLines::take_facet(const PageLine& line, std::uint32_t number) {
  const Facet& facet = bodies_.front[number];
  if (facet.face == line.face0 || facet.face == line.face1) return;
  ++counts_.facets;
  bool near_side = false;
  open_.take(
      hidden_interval(line, facet, bodies_.vertices.data(), {open_.from(), open_.to()}, coincidence_steps_, near_side));
}

void report(const Bodies& bodies, const BodyCounts& counts, Statistics& statistics) {
  statistics.count("bodies", bodies.list.size());
  statistics.count("flat bodies", bodies.flat_faces);
  statistics.count("sides of silhouettes", bodies.hull.size());
  statistics.count("planes of front faces", bodies.planes.size());
  statistics.count("lines behind their own body", counts.own);
  statistics.count("line-body tests", counts.bodies);
  statistics.count("outside the silhouette", counts.beside);
  statistics.count("in front of the body", counts.before);
  statistics.count("behind all planes", counts.behind);
  statistics.count("line-plane tests", counts.planes);
  statistics.count("line-facet tests", counts.facets);
}

VisibilityResult roberts_visibility(const ProjectedScene& scene, const VisibilityOptions& options) {
  VisibilityResult result;
  Statistics& statistics = result.statistics;
  const double step = scene.lattice.step_mm;
  const double coincidence_steps = coincidence_mm(scene) / step;
  Clock clock;

  // 1. Bodies.
  const Bodies bodies = find_bodies(scene, coincidence_steps);
  result.unsupported_reason = bodies.unsupported;
  statistics.time("bodies", clock.lap());

  // 2. Lines of penetration, of the projected scene, which has only one of coincident faces.
  std::vector<Intersection> intersections;
  if (scene.with_intersections) {
    const Facets facets = make_facets(scene, coincidence_steps);
    intersections = find_intersections(scene, facets.facets, coincidence_steps, options.hidden_strokes);
  }
  statistics.time("intersections", clock.lap());

  // 3. Lines. Each may coincide with another.
  BodyTotals totals;
  const auto against_bodies = [&](LineKind kind) {
    return [&bodies, &totals, coincidence_steps, kind]() -> LineVisibility {
      const auto search = std::make_shared<BodyLines>(bodies, coincidence_steps, kind, totals);
      return [search](std::size_t, const PageLine& line, std::vector<LinePart>& parts) {
        search->find(line, parts);
        return true;
      };
    };
  };
  LineStrokes strokes(scene, bodies.facets, options.hidden_strokes, kLeastPartMm / step);
  const auto edges = against_bodies(LineKind::edge), penetrations = against_bodies(LineKind::intersection);
  strokes.add_edges(edges, options.progress);
  strokes.add_intersections(intersections, penetrations);
  result.strokes = strokes.take();
  statistics.time("lines", clock.lap());

  report(bodies, totals.counts, statistics);
  statistics.count("candidate edges", scene.edges.size());
  statistics.count("intersection segments tested", intersections.size());
  statistics.count("strokes", result.strokes->strokes.size());
  return result;
}

}  // namespace

const Method& roberts_method() {
  static const FunctionMethod method(
      {.name = "roberts",
       .summary = "each edge tested against the convex bodies in front of it, by linear inequalities",
       .paper = "L. G. Roberts, Machine perception of three-dimensional solids, 1963",
       .only_for = "scenes of convex bodies and flat convex faces entirely in view"},
      roberts_visibility);
  return method;
}

}  // namespace ligne
