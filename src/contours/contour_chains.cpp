#include "contours/contour_chains.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include <glm/geometric.hpp>

#include "base/indices_where.hpp"
#include "base/parallel.hpp"
#include "contours/surfaces/known_surfaces.hpp"
#include "contours/surfaces/rulings.hpp"

namespace ligne {
namespace {

/// A curve whose end normals are those of a mesh edge rises above the edge by an eighth of its length times the angle
/// between them, which below the crease angle of 30 degrees is less than this share. More comes of normals that have gone
/// astray.
constexpr double kHighestRise = 0.07;
/// A curve rises over its edge by at most this many sags: the sag of uneven triangles falls short of the surface's rise.
constexpr double kHighestRiseInSags = 2;
/// Segments of a contour that are shorter, in sags, have no direction: nodes of float32 coordinates are off by less where
/// 240 facets go round a circle.
constexpr double kNoLengthInSags = 0.01;
/// A fraction of an edge is found to 2^-20: a micrometre of a metre.
constexpr int kHalvings = 20;
/// Tangents of a contour and the chord between its nodes differ by less than the angle of this cosine (60 degrees);
/// otherwise the surface is not known well enough.
constexpr double kLeastAlong = 0.5;

/// The zero of the cubic with these values and slopes at 0 and 1; the values have different signs.
double zero_between(double v0, double v1, double slope0, double slope1) {
  const auto value = [&](double t) {
    const double s = 1 - t;
    return s * s * ((1 + 2 * t) * v0 + t * slope0) + t * t * ((1 + 2 * s) * v1 - s * slope1);
  };
  double low = 0, high = 1;
  for (int step = 0; step < kHalvings; ++step) {
    const double middle = (low + high) / 2;
    ((value(middle) >= 0) == (v0 >= 0) ? low : high) = middle;
  }
  return (low + high) / 2;
}

class ContourTracer {
 public:
  ContourTracer(const Scene& scene, const Camera& camera, const SmoothPatch& patch)
      : scene_(scene), camera_(camera), patch_(patch), done_(patch.triangles.size(), 0) {}

  std::vector<ContourChain> trace() {
    const std::vector<Path> paths = find_paths();
    std::vector<std::uint32_t> sides;
    std::vector<std::uint8_t> is_end;
    for (const Path& path : paths) {
      sides.insert(sides.end(), path.sides.begin(), path.sides.end());
      is_end.resize(sides.size(), 0);
      is_end[sides.size() - path.sides.size()] = is_end.back() = 1;
    }
    // The triangle of a side is the one before it on the path, so each is asked once, but for those at the ends.
    std::vector<double> sags(sides.size());
    std::vector<ContourNode> nodes(sides.size());
    parallel_blocks(sides.size(), kSearchBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) sags[i] = sag_of(scene_, patch_, sides[i] / 3);
    });
    parallel_blocks(sides.size(), kSearchBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const std::uint32_t across = patch_.across[sides[i]];
        const double beyond = !is_end[i] ? sags[i + 1] : across != kNone ? sag_of(scene_, patch_, across / 3) : 0;
        nodes[i] = node(sides[i], std::max(sags[i], beyond));
      }
    });
    std::vector<std::size_t> first(paths.size() + 1, 0);  // node of each path
    for (std::size_t p = 0; p < paths.size(); ++p) first[p + 1] = first[p] + paths[p].sides.size();
    std::vector<ContourChain> chains(paths.size());
    parallel_blocks(paths.size(), kChainsPerTask, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = begin; p < end; ++p) {
        for (std::size_t i = first[p]; i + 1 < first[p + 1]; ++i) nodes[i].sag_ahead = sags[i + 1];
        chains[p] = chain_of(paths[p], {nodes.data() + first[p], first[p + 1] - first[p]});
      }
    });
    return chains;
  }

 private:
  /// The triangles that a chain runs through, and the sides that it crosses: one more.
  struct Path {
    std::vector<std::uint32_t> triangles, sides;
    bool closed;
  };

  std::vector<Path> find_paths() {
    std::vector<Path> paths;
    const std::vector<std::uint32_t> crossed =
        indices_where(patch_.triangles.size(), [&](std::size_t t) { return is_crossed(static_cast<std::uint32_t>(t)); });
    for (const std::uint32_t t : crossed) {  // from their loose ends
      if (done_[t]) continue;
      for (const std::uint32_t side : crossed_sides(t)) {
        if (!done_[t] && beyond(side) == kNone) paths.push_back(walk(t, side, false));
      }
    }
    for (const std::uint32_t t : crossed) {
      if (!done_[t]) paths.push_back(walk(t, crossed_sides(t)[0], true));
    }
    return paths;
  }

  bool crosses(std::uint32_t side) const {
    return patch_.looks_at_viewer(side) != patch_.looks_at_viewer(next_corner(side));
  }
  bool is_crossed(std::uint32_t t) const {
    if (!patch_.complete[3 * t] || !patch_.complete[3 * t + 1] || !patch_.complete[3 * t + 2]) return false;
    return crosses(3 * t) || crosses(3 * t + 1);
  }
  std::array<std::uint32_t, 2> crossed_sides(std::uint32_t t) const {
    if (!crosses(3 * t)) return {3 * t + 1, 3 * t + 2};
    return {3 * t, crosses(3 * t + 1) ? 3 * t + 1 : 3 * t + 2};
  }
  /// The triangle that continues the chain beyond a side, or kNone.
  std::uint32_t beyond(std::uint32_t side) const {
    const std::uint32_t other = patch_.across[side];
    return other == kNone || !is_crossed(other / 3) ? kNone : other / 3;
  }

  Path walk(std::uint32_t t, std::uint32_t entry, bool closed) {
    Path path{{}, {entry}, closed};
    while (t != kNone && !done_[t]) {
      done_[t] = 1;
      const auto sides = crossed_sides(t);
      const std::uint32_t exit = sides[0] == entry ? sides[1] : sides[0];
      path.triangles.push_back(t);
      path.sides.push_back(exit);
      t = beyond(exit);
      entry = patch_.across[exit];
    }
    return path;
  }

  /// `nodes`: of the sides of the path.
  ContourChain chain_of(const Path& path, std::span<const ContourNode> nodes) const {
    ContourChain chain;
    chain.closed = path.closed;
    chain.nodes.push_back(nodes[0]);
    for (std::size_t i = 0; i < path.triangles.size(); ++i) {
      const ContourNode& end = nodes[i + 1];
      if (const auto cusp = cusp_between(nodes[i], end)) {
        chain.triangles.push_back(path.triangles[i]);
        chain.nodes.push_back(*cusp);
        chain.nodes.back().sag_ahead = nodes[i].sag_ahead;
      }
      chain.triangles.push_back(path.triangles[i]);
      chain.nodes.push_back(end);
    }
    if (path.closed) chain.nodes.back() = chain.nodes.front();
    if (patch_.surfaces) mark_joints(chain);
    return chain;
  }

  /// Marks where one surface runs into another. There the contour may have a corner: as at the foot of a column with a
  /// fillet, where it turns back on the page. That is a cusp, too.
  void mark_joints(ContourChain& chain) const {
    std::size_t last = kNone;  // the last segment that has a length
    for (std::size_t i = 0; i < chain.size(); ++i) {
      const ContourNode &from = chain.nodes[i], &to = chain.nodes[i + 1];
      // Where the outline passes through a vertex, roundings set the nodes of its sides apart.
      if (glm::distance(from.on_surface, to.on_surface) <= kNoLengthInSags * std::max(from.sag, to.sag)) continue;
      if (last != kNone && surface_at(patch_, chain.triangles[last]) != surface_at(patch_, chain.triangles[i])) {
        ContourNode& corner = chain.nodes[last + 1];
        corner.is_joint = true;
        if (corner.meets == kNone && turns_back(chain, last, i)) {
          corner.tangent = glm::normalize(chain.nodes[last + 1].on_surface - chain.nodes[last].on_surface);
          corner.radial = 0;
          corner.is_corner = true;
        }
      }
      last = i;
    }
  }

  /// Curvature of a surface along the sight, positive where it bends away from the normal of its faces.
  double bend_along_sight(const Patch& patch, const Point3& at) const {
    const double k = patch.surface.curvature(at, glm::normalize(to_eye(camera_, at)));
    return patch.outward ? k : -k;
  }

  /// Whether the contour turns back on the page between two segments on different surfaces. It does where the surfaces bend
  /// to different sides along the sight; where one of them is not known, the chords between nodes tell.
  bool turns_back(const ContourChain& chain, std::size_t before, std::size_t after) const {
    const Point3& at = chain.nodes[before + 1].on_surface;
    const Point3 eye = to_eye(camera_, at);
    const Patch *first = surface_at(patch_, chain.triangles[before]), *second = surface_at(patch_, chain.triangles[after]);
    if (first && second) return bend_along_sight(*first, at) * bend_along_sight(*second, at) < 0;
    const auto on_page = [&](std::size_t k) {
      return glm::cross(chain.nodes[k + 1].on_surface - chain.nodes[k].on_surface, eye);
    };
    return glm::dot(on_page(before), on_page(after)) < 0;
  }

  /// The node at which a contour runs along the sight.
  std::optional<ContourNode> cusp_between(const ContourNode& a, const ContourNode& b) const {
    if (!(a.radial * b.radial < 0)) return std::nullopt;
    const auto curve = ContourCubic::between(a, b);
    if (!curve) return std::nullopt;
    const Point3 across = glm::cross(a.normal + b.normal, to_eye(camera_, a.on_surface));
    const double t0 = glm::dot(curve->tangent(0), across), t1 = glm::dot(curve->tangent(1), across);
    if ((t0 >= 0) == (t1 >= 0)) return std::nullopt;
    double low = 0, high = 1;
    for (int step = 0; step < kHalvings; ++step) {
      const double middle = (low + high) / 2;
      ((glm::dot(curve->tangent(middle), across) >= 0) == (t0 >= 0) ? low : high) = middle;
    }
    ContourNode cusp;
    const double t = (low + high) / 2;
    cusp.side = a.side;
    cusp.sag = std::max(a.sag, b.sag);
    cusp.on_mesh = (1 - t) * a.on_mesh + t * b.on_mesh;
    cusp.on_surface = curve->point(t);
    cusp.normal = glm::normalize((1 - t) * a.normal + t * b.normal);
    const Point3 tangent = curve->tangent(t);
    cusp.tangent = (curve->with_chain ? 1.0 : -1.0) * tangent / glm::length(tangent);
    return cusp;
  }

  std::uint32_t vertex_at(std::uint32_t corner) const { return patch_.triangles[corner / 3].v[corner % 3]; }
  const Point3& vertex(std::uint32_t corner) const { return scene_.vertices[vertex_at(corner)]; }

  ContourNode node(std::uint32_t side, double sag) const {
    ContourNode out{.side = side, .edge = {vertex_at(side), vertex_at(next_corner(side))}};
    if (!patch_.looks_at_viewer(side)) std::swap(out.edge[0], out.edge[1]);
    // One end is first from both triangles, so that both get equal points.
    std::uint32_t a = side, b = next_corner(side);
    if (patch_.triangles[a / 3].v[a % 3] > patch_.triangles[b / 3].v[b % 3]) std::swap(a, b);
    const Point3 &p = vertex(a), &q = vertex(b);
    const Point3 &np = patch_.normals[patch_.sector[a]], &nq = patch_.normals[patch_.sector[b]];
    const double ga = patch_.g[patch_.sector[a]], gb = patch_.g[patch_.sector[b]];
    const std::uint32_t fit_a = patch_.fit[patch_.sector[a]], fit_b = patch_.fit[patch_.sector[b]];
    const bool fitted = fit_a != kNone && fit_b != kNone;
    const Point3 d = q - p;
    static constexpr NormalTurn kNoTurn{};
    const NormalTurn &wa = fitted ? patch_.turns[fit_a] : kNoTurn, &wb = fitted ? patch_.turns[fit_b] : kNoTurn;
    double t = ga == gb ? 0.5 : std::clamp(ga / (ga - gb), 0.0, 1.0);
    if (fitted) {
      const auto slope = [&](const Point3& at, const Point3& n, const NormalTurn& turn) {
        return glm::dot(turned(turn, d), to_eye(camera_, at)) - (camera_.perspective ? glm::dot(n, d) : 0);
      };
      t = zero_between(ga, gb, slope(p, np, wa), slope(q, nq, wb));
    }
    out.on_mesh = p + t * (q - p);
    Point3 n = (1 - t) * np + t * nq;
    if (fitted) n += (1 - t) * t * ((1 - t) * (turned(wa, d) - (nq - np)) - t * (turned(wb, d) - (nq - np)));
    const double size = glm::length(n);
    out.normal = size > 0 ? n / size : np;
    // Cubic with tangents in the tangent planes of the ends [Vlachos2001].
    const Point3 rise = (1 - t) * t * (t * glm::dot(d, nq) * nq - (1 - t) * glm::dot(d, np) * np);
    out.sag = sag;
    const double most = std::min(kHighestRise * glm::length(d), kHighestRiseInSags * out.sag), height = glm::length(rise);
    out.on_surface = out.on_mesh + (height > most ? rise * (most / height) : rise);
    if (const Patch* surface = surface_of(side)) lay_on(*surface, p, q, out);
    if (fitted) {
      NormalTurn turn;
      for (std::size_t i = 0; i < turn.size(); ++i) turn[i] = (1 - t) * wa[i] + t * wb[i];
      const Point3 eye = to_eye(camera_, out.on_surface), grows = turned(turn, eye);
      const Point3 along = glm::cross(out.normal, grows);
      const double length = glm::length(along);
      if (length > 0) {
        out.tangent = along / length;
        out.radial = glm::dot(grows, eye) / (length * glm::length(eye));
      }
    }
    if (patch_.across[side] == kNone) {
      const bool facing = patch_.facing[side / 3] >= 0;
      const std::uint32_t corner = patch_.looks_at_viewer(side) != facing ? side : next_corner(side);
      out.meets = patch_.triangles[corner / 3].v[corner % 3];
    }
    return out;
  }

  /// The surface on both sides of a side, or on the only one.
  const Patch* surface_of(std::uint32_t side) const {
    const Patch* surface = surface_at(patch_, side / 3);
    const std::uint32_t across = patch_.across[side];
    return across == kNone || surface_at(patch_, across / 3) == surface ? surface : nullptr;
  }

  /// Moves a node of the edge from p to q to the outline of the surface.
  void lay_on(const Patch& surface, const Point3& p, const Point3& q, ContourNode& node) const {
    if (const auto t = outline_crossing(surface, camera_, p, q)) node.on_mesh = p + *t * (q - p);
    node.on_surface = nearest_point(surface, node.on_mesh);
    node.normal = facing_normal(surface, node.on_surface);
    node.sag = std::max(node.sag, std::abs(surface.surface.distance(node.on_mesh)));
  }

  const Scene& scene_;
  const Camera& camera_;
  const SmoothPatch& patch_;
  std::vector<std::uint8_t> done_;
};

}  // namespace

std::optional<ContourCubic> ContourCubic::between(const ContourNode& a, const ContourNode& b) {
  const Point3 chord = b.on_surface - a.on_surface;
  const double length = glm::length(chord);
  if (!(length > 0) || a.tangent == Point3(0.0) || b.tangent == Point3(0.0)) return std::nullopt;
  const bool with_chain = glm::dot(a.tangent + b.tangent, chord) >= 0;
  const Point3 from = with_chain ? a.tangent : -a.tangent, to = with_chain ? b.tangent : -b.tangent;
  if (std::min(glm::dot(from, chord), glm::dot(to, chord)) < kLeastAlong * length) return std::nullopt;
  return ContourCubic{{a.on_surface, a.on_surface + length / 3 * from, b.on_surface - length / 3 * to, b.on_surface},
                      with_chain};
}

std::vector<ContourChain> trace_contours(const Scene& scene, const Camera& camera, const SmoothPatch& patch) {
  return ContourTracer(scene, camera, patch).trace();
}

}  // namespace ligne
