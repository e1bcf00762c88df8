// Locally convex closed surfaces that cover the directions of their normals once are convex: edges that bend outwards show
// the first, one highest place in a direction shows the second for that direction (a surface that winds twice round an axis
// has two in directions across it). Six directions and 16 faces stand for all.

#include "scene/clean/check_facts.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"
#include "files/message_text.hpp"
#include "scene/clean/named_objects.hpp"
#include "scene/model/bounds.hpp"

namespace ligne {
namespace {

/// Pairs of triangles that are looked at: about four milliseconds.
constexpr std::size_t kMostPairs = std::size_t{1} << 20;
/// Rounding of a height over a plane, as a part of the largest coordinate.
constexpr double kHeightRounding = 0x1p-44;
/// Faces of a body that are compared with all its vertices.
constexpr std::size_t kComparedFaces = 16;

struct PaddedBox {
  Point3 low, high;
  bool meets(const PaddedBox& o) const {
    for (int k = 0; k < 3; ++k) {
      if (!(low[k] < o.high[k] && o.low[k] < high[k])) return false;
    }
    return true;
  }
};

/// A contradiction of a stated fact. In the text, "@" stands for the name of the next object.
struct Contradiction {
  std::string text;
  std::vector<std::size_t> objects;
};

std::string in_words(const Contradiction& found, const std::vector<Object>& objects) {
  std::string text;
  auto object = found.objects.begin();
  for (const char c : found.text) {
    if (c == '@') {
      text += shown(object_name(objects[*object], *object), '"');
      ++object;
    } else {
      text += c;
    }
  }
  return text;
}

// Separating planes.

std::optional<Contradiction> find_cut_object(const Scene& scene, double rounding) {
  for (std::size_t k = 0; k < scene.stated.planes.size(); ++k) {
    const SeparatingPlane& plane = scene.stated.planes[k];
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
      const Object& object = scene.objects[i];
      const double tolerance = 8 * object.precision + rounding;
      bool before = false, behind = false;
      for (std::uint32_t v = object.vertex_begin; v < object.vertex_end; ++v) {
        const double height = glm::dot(plane.normal, scene.vertices[v] - plane.point);
        before = before || height > tolerance;
        behind = behind || height < -tolerance;
      }
      if (before && behind) return Contradiction{"separating_planes[" + std::to_string(k) + "] cuts object @", {i}};
    }
  }
  return std::nullopt;
}

// Adjacency.

/// Why the edges do not join faces in pairs; empty if they do. With `any_way`, both faces may run along an edge the same
/// way.
std::string why_unpaired(const Topology& topology, EdgeRange edges, bool any_way) {
  for (std::uint32_t e = edges.begin; e < edges.end; ++e) {
    const std::uint16_t flags = topology.edge_flags[e];
    if (topology.edges[e].face1 == kNone) return "has a border edge";
    if (flags & kEdgeManyFaces) return "has an edge of more than two faces";
    if ((flags & kEdgeUnlikeWound) && !any_way) return "has an edge along which both faces run the same way";
  }
  return {};
}

// Convex bodies.

/// The plane of a face, turned outwards, and the mean of its corners.
struct FacePlane {
  Point3 normal{0, 0, 0}, point{0, 0, 0}, middle{0, 0, 0};
  double height(const Point3& p) const { return glm::dot(normal, p - point); }
};

/// Why an object is not one closed convex body; empty if nothing shows that it is not.
class ConvexCheck {
 public:
  ConvexCheck(const Scene& scene, const Topology& topology, const Object& object, EdgeRange edges, double rounding)
      : scene_(scene), topology_(topology), object_(object), edges_(edges), tolerance_(8 * object.precision + rounding) {}

  std::string why_not() {
    std::string why = why_unpaired(topology_, edges_, true);
    if (!why.empty()) return why;
    if (!is_one_part()) return "has several parts";
    find_planes();
    for (std::uint32_t e = edges_.begin; e < edges_.end; ++e) {
      const FacePlane &a = plane(topology_.edges[e].face0), &b = plane(topology_.edges[e].face1);
      if (a.height(b.middle) > tolerance_ || b.height(a.middle) > tolerance_) return "is concave at an edge";
    }
    if (!has_one_top_each()) return "has several local maxima";
    const std::size_t step = std::max<std::size_t>(planes_.size() / kComparedFaces, 1);
    for (std::size_t f = 0; f < planes_.size(); f += step) {
      for (std::uint32_t v = object_.vertex_begin; v < object_.vertex_end; ++v) {
        if (planes_[f].height(scene_.vertices[v]) > tolerance_) return "crosses the plane of a face";
      }
    }
    return {};
  }

 private:
  FacePlane& plane(std::uint32_t face) { return planes_[face - object_.face_begin]; }
  std::uint32_t vertex_count() const { return object_.vertex_end - object_.vertex_begin; }

  bool is_one_part() const {
    DisjointSets sets(vertex_count());
    for (std::uint32_t e = edges_.begin; e < edges_.end; ++e) {
      sets.join(topology_.edges[e].v0 - object_.vertex_begin, topology_.edges[e].v1 - object_.vertex_begin);
    }
    for (std::uint32_t v = 1; v < vertex_count(); ++v) {
      if (sets.find(v) != sets.find(0)) return false;
    }
    return true;
  }

  void find_planes() {
    Point3 inside{0, 0, 0};
    for (std::uint32_t v = object_.vertex_begin; v < object_.vertex_end; ++v)
      inside += scene_.vertices[v] / double(vertex_count());
    planes_.resize(object_.face_end - object_.face_begin);
    for (std::uint32_t f = object_.face_begin; f < object_.face_end; ++f) {
      FacePlane& p = plane(f);
      const auto corners = scene_.faces.contour(f, 0);
      for (const std::uint32_t v : corners) p.middle += scene_.vertices[v] / double(corners.size());
      p.normal = face_normal(scene_, f);
      p.point = p.middle;
      if (p.height(inside) > 0) p.normal = -p.normal;
    }
  }

  /// Whether in each direction one vertex only is higher than its neighbours.
  bool has_one_top_each() const {
    // Directions that no plane of a drawn part is square to.
    for (const Point3& d : {Point3{1, 0.137, 0.271}, Point3{-0.119, 1, 0.313}, Point3{0.173, -0.211, 1}}) {
      std::vector<std::uint8_t> has_higher(vertex_count(), 0), has_lower(vertex_count(), 0);
      for (std::uint32_t e = edges_.begin; e < edges_.end; ++e) {
        std::uint32_t low = topology_.edges[e].v0, high = topology_.edges[e].v1;
        if (glm::dot(d, scene_.vertices[low]) > glm::dot(d, scene_.vertices[high])) std::swap(low, high);
        has_higher[low - object_.vertex_begin] = 1;
        has_lower[high - object_.vertex_begin] = 1;
      }
      if (std::ranges::count(has_higher, 0) != 1 || std::ranges::count(has_lower, 0) != 1) return false;
    }
    return true;
  }

  const Scene& scene_;
  const Topology& topology_;
  const Object& object_;
  EdgeRange edges_;
  double tolerance_;
  std::vector<FacePlane> planes_;
};

/// Finds an object that is not one closed convex body, or whose faces do not join in pairs.
std::optional<Contradiction> find_false_object(const Scene& scene, const Topology& topology, bool is_convex,
                                               double rounding) {
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const Object& object = scene.objects[i];
    const EdgeRange edges = edges_of(topology, object);
    const std::string why =
        is_convex ? ConvexCheck(scene, topology, object, edges, rounding).why_not() : why_unpaired(topology, edges, false);
    if (why.empty()) continue;
    return Contradiction{(is_convex ? "object @ is not one closed convex body: it " : "object @ ") + why, {i}};
  }
  return std::nullopt;
}

// Penetrations.

using Triangle3 = std::array<Point3, 3>;

/// Whether the segment passes through the triangle, at a distance of more than `tolerance` from its sides and with both ends
/// that far from its plane.
bool pierces(const Point3& p, const Point3& q, const Triangle3& t, double tolerance) {
  const Point3 across = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double length = glm::length(across);
  if (!(length > 0)) return false;
  const Point3 normal = across / length;
  const double hp = glm::dot(normal, p - t[0]), hq = glm::dot(normal, q - t[0]);
  if (std::min(hp, hq) >= -tolerance || std::max(hp, hq) <= tolerance) return false;
  const Point3 x = p + (q - p) * (hp / (hp - hq));
  for (int k = 0; k < 3; ++k) {
    const Point3 side = t[(k + 1) % 3] - t[k];
    if (glm::dot(glm::cross(normal, side), x - t[k]) <= tolerance * glm::length(side)) return false;
  }
  return true;
}

bool penetrate(const Triangle3& t, const Triangle3& u, double tolerance) {
  for (int k = 0; k < 3; ++k) {
    if (pierces(t[k], t[(k + 1) % 3], u, tolerance) || pierces(u[k], u[(k + 1) % 3], t, tolerance)) return true;
  }
  return false;
}

std::optional<Contradiction> find_penetration(const Scene& scene, const Topology& topology, double rounding) {
  const std::size_t n = topology.triangles.size();
  if (n == 0) return std::nullopt;
  double tolerance = rounding;
  for (const Object& object : scene.objects) tolerance = std::max(tolerance, 8 * object.precision + rounding);
  const auto corners = [&](std::size_t t) {
    const auto& v = topology.triangles[t].v;
    return Triangle3{scene.vertices[v[0]], scene.vertices[v[1]], scene.vertices[v[2]]};
  };
  std::vector<PaddedBox> boxes;
  boxes.reserve(n);
  for (std::size_t t = 0; t < n; ++t) {
    const Triangle3 c = corners(t);
    boxes.push_back({glm::min(glm::min(c[0], c[1]), c[2]), glm::max(glm::max(c[0], c[1]), c[2])});
    // Boxes without a depth would not meet strictly.
    boxes.back().low -= Point3(tolerance);
    boxes.back().high += Point3(tolerance);
  }
  const std::size_t samples = std::min(n, std::max<std::size_t>(kMostPairs / n, 1));
  const auto object_of = [&](std::size_t t) {
    const auto at = std::ranges::upper_bound(scene.objects, topology.triangles[t].face, {}, &Object::face_end);
    return static_cast<std::size_t>(at - scene.objects.begin());
  };
  for (std::size_t i = 0; i < samples; ++i) {
    const std::size_t t = i * n / samples;
    const Triangle3 c = corners(t);
    for (std::size_t u = samples == n ? t + 1 : 0; u < n; ++u) {
      if (!boxes[t].meets(boxes[u]) || topology.triangles[t].face == topology.triangles[u].face) continue;
      if (!penetrate(c, corners(u), tolerance)) continue;
      const std::size_t a = object_of(t), b = object_of(u);
      if (a == b) return Contradiction{"object @ has faces that pass through each other", {a}};
      return Contradiction{"objects @ and @ pass through each other", {a, b}};
    }
  }
  return std::nullopt;
}

std::optional<Contradiction> contradiction_of(const Scene& scene, const Topology& topology, StatedFact fact,
                                              double rounding) {
  if (fact == StatedFact::no_penetration) return find_penetration(scene, topology, rounding);
  return find_false_object(scene, topology, fact == StatedFact::convex, rounding);
}

}  // namespace

std::string why_false(const Scene& scene, const Topology& topology, StatedFact fact) {
  const auto found = contradiction_of(scene, topology, fact, kHeightRounding * largest_coordinate(scene));
  return found ? in_words(*found, scene.objects) : std::string();
}

bool tests_all_pairs(const Topology& topology) {
  const std::size_t n = topology.triangles.size();
  return n * n <= kMostPairs;
}

std::string find_false_fact(const Scene& scene, const Topology& topology) {
  if (!scene.stated.any()) return {};
  const double rounding = kHeightRounding * largest_coordinate(scene);
  std::string is_false;
  std::optional<Contradiction> found = find_cut_object(scene, rounding);
  for (const StatedFact fact : {StatedFact::adjacency, StatedFact::convex, StatedFact::no_penetration}) {
    if (found || !scene.stated.has(fact)) continue;
    found = contradiction_of(scene, topology, fact, rounding);
    is_false = "the fact '" + std::string(kStatedFactNames[static_cast<std::size_t>(fact)]) + "' is false: ";
  }
  return found ? is_false + in_words(*found, scene.objects) : std::string();
}

}  // namespace ligne
