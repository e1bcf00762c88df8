#include "scene/patches/refine/bodies_apart.hpp"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "base/disjoint_sets.hpp"
#include "base/no_index.hpp"

namespace ligne {
namespace {

/// Adjustable: number of bodies from which on a scene is not looked at, as all pairs of boxes are compared; and number of
/// pairs of faces of two bodies from which on these count as touching.
constexpr std::size_t kMostBodies = 64, kMostFacePairs = 1 << 21;
/// Faces touch where a corner of one lies nearer to the surface of the other than so many times the sum of both sags, and
/// both surfaces have one direction by this cosine (15 degrees).
constexpr double kTouchSags = 1.5, kTouchCosine = 0.966;

struct BodyBox {
  Point3 low{1e300}, high{-1e300};

  void add(const Point3& p) { low = glm::min(low, p), high = glm::max(high, p); }
  bool meets(const BodyBox& other, double within) const {
    return glm::all(glm::lessThanEqual(low - within, other.high)) && glm::all(glm::lessThanEqual(other.low - within, high));
  }
};

class BodyComparer {
 public:
  BodyComparer(const Scene& scene, const Bodies& bodies, const Patches& patches, EdgeLevels& levels)
      : scene_(scene),
        bodies_(bodies),
        patches_(patches),
        levels_(levels),
        boxes_(bodies.size()),
        is_blocked_(patches.list.size(), 0) {}

  void run() {
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      for (const std::uint32_t f : bodies_[i]) {
        for (const std::uint32_t v : scene_.faces.contour(f, 0)) boxes_[i].add(scene_.vertices[v]);
      }
    }
    for (const Patch& patch : patches_.list) largest_sag_ = std::max(largest_sag_, patch.sag);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (boxes_[i].meets(boxes_[k], 2 * kTouchSags * largest_sag_)) compare(i, k);
      }
    }
    for (std::size_t p = 0; p < is_blocked_.size(); ++p) {
      if (is_blocked_[levels_.set_of[p]]) levels_.of_patch[p] = 0;
    }
  }

 private:
  /// A face near another body.
  struct NearFace {
    std::uint32_t face;
    BodyBox box;
    double sag;
    std::uint32_t patch;
  };

  bool is_refined(const NearFace& f) const {
    return f.patch != kNone && levels_.of_patch[f.patch] > 0 && !is_blocked_[levels_.set_of[f.patch]];
  }
  void block(std::uint32_t patch) {
    if (patch != kNone) is_blocked_[levels_.set_of[patch]] = 1;
  }

  std::vector<NearFace> faces_near(std::size_t body, const BodyBox& other) const {
    std::vector<NearFace> found;
    for (const std::uint32_t f : bodies_[body]) {
      BodyBox box;
      for (const std::uint32_t v : scene_.faces.contour(f, 0)) box.add(scene_.vertices[v]);
      if (!box.meets(other, 2 * kTouchSags * largest_sag_)) continue;
      const std::uint32_t patch = patches_.patch_of[f];
      found.push_back({f, box, patch == kNone ? 0 : patches_.list[patch].sag, patch});
    }
    return found;
  }

  /// Blocks the surfaces along which two bodies touch, or all of both if there are too many faces to tell. A surface is
  /// blocked if it touches any other one, so the order of the faces has no say.
  void compare(std::size_t a, std::size_t b) {
    const std::vector<NearFace> ours = faces_near(a, boxes_[b]);
    std::vector<NearFace> theirs = faces_near(b, boxes_[a]);
    if (ours.size() * theirs.size() > kMostFacePairs) {
      for (const NearFace& f : ours) block(f.patch);
      for (const NearFace& g : theirs) block(g.patch);
      return;
    }
    // By their lower ends, with the upper ends of all up to each, a range of them reaches those of a face.
    const auto low_end = [](const NearFace& f) { return f.box.low.x; };
    std::ranges::sort(theirs, {}, low_end);
    std::vector<double> high_ends;
    high_ends.reserve(theirs.size());
    for (const NearFace& g : theirs)
      high_ends.push_back(std::max(g.box.high.x, high_ends.empty() ? g.box.high.x : high_ends.back()));
    const double most = 2 * kTouchSags * largest_sag_;
    for (const NearFace& f : ours) {
      const auto first = theirs.begin() + (std::ranges::lower_bound(high_ends, f.box.low.x - most) - high_ends.begin());
      const auto end = std::ranges::upper_bound(theirs, f.box.high.x + most, {}, low_end);
      for (auto g = std::min(first, end); g != end; ++g) {
        const double within = kTouchSags * (f.sag + g->sag);
        if ((!is_refined(f) && !is_refined(*g)) || !f.box.meets(g->box, within)) continue;
        if (!touches(f.face, g->face, within) && !touches(g->face, f.face, within)) continue;
        block(f.patch);
        block(g->patch);
      }
    }
  }

  /// Whether a corner of face f lies on the surface of face g, with the same normal up to its sign. Faces of one normal and
  /// surface, as of bores that continue each other, are not in the way of each other.
  bool touches(std::uint32_t f, std::uint32_t g, double within) const {
    const Point3 normal_f = face_normal(scene_, f), normal_g = face_normal(scene_, g);
    const std::uint32_t patch = patches_.patch_of[g];
    const Point3& on_g = scene_.vertices[scene_.faces.contour(g, 0)[0]];
    const auto lies_on_g = [&](std::uint32_t v) {
      const Point3& p = scene_.vertices[v];
      const double off = patch == kNone ? glm::dot(p - on_g, normal_g) : patches_.list[patch].surface.distance(p);
      return std::abs(off) <= within;
    };
    const auto cosine_at = [&](std::uint32_t v) {
      const Point3& p = scene_.vertices[v];
      return glm::dot(patches_.normal(f, p, normal_f), patches_.normal(g, p, normal_g));
    };
    const auto contour = scene_.faces.contour(f, 0);
    if (patch != kNone && patches_.patch_of[f] != kNone && std::ranges::all_of(contour, lies_on_g) &&
        std::ranges::all_of(contour, [&](std::uint32_t v) { return cosine_at(v) >= kTouchCosine; }))
      return false;
    return std::ranges::any_of(contour,
                               [&](std::uint32_t v) { return lies_on_g(v) && std::abs(cosine_at(v)) >= kTouchCosine; });
  }

  const Scene& scene_;
  const Bodies& bodies_;
  const Patches& patches_;
  EdgeLevels& levels_;
  std::vector<BodyBox> boxes_;            ///< per body
  std::vector<std::uint8_t> is_blocked_;  ///< per set of surfaces
  double largest_sag_ = 0;
};

}  // namespace

std::optional<Bodies> find_few_bodies(const Scene& scene, const Topology& topology) {
  DisjointSets sets(scene.faces.size());
  for (const Edge& edge : topology.edges) {
    if (edge.face1 != kNone) sets.join(edge.face0, edge.face1);
  }
  Bodies bodies;
  std::vector<std::uint32_t> number(scene.faces.size(), kNone);
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    std::uint32_t& n = number[sets.find(f)];
    if (n == kNone) {
      if (bodies.size() == kMostBodies) return std::nullopt;
      n = static_cast<std::uint32_t>(bodies.size());
      bodies.emplace_back();
    }
    bodies[n].push_back(f);
  }
  return bodies;
}

void block_touching(const Scene& scene, const Bodies& bodies, const Patches& patches, EdgeLevels& levels) {
  BodyComparer(scene, bodies, patches, levels).run();
}

bool has_few_objects(const Scene& scene) {
  const auto has_faces = [](const Object& object) { return object.face_begin != object.face_end; };
  return std::ranges::count_if(scene.objects, has_faces) <= static_cast<std::ptrdiff_t>(kMostBodies);
}

}  // namespace ligne
