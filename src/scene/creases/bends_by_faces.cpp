#include "scene/creases/bends_by_faces.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/creases/across_edge.hpp"
#include "scene/model/bounds.hpp"

namespace ligne {
namespace {

/// Adjustable. Parts are relative to the size of the object where nothing else is named.
constexpr double kLowPart = 0.5;          ///< of the crease angle: least angle of continued creases and sharp edges
constexpr double kFirmDegrees = 20;       ///< above the crease angle: such an edge stays even if isolated
constexpr double kSurelySharp = 60;       ///< edges from this angle on are creases, even if the file says smooth
constexpr double kRoundPart = 1.0 / 256;  ///< smaller radii are drawn as the edge that they round
constexpr double kNarrowPart = 1.0 / 96;  ///< as are narrower fillets between wide sides
/// Allowance for the error of float32 normals of small faces: an edge at exactly the crease angle is not a crease.
constexpr double kSlackDegrees = 0.01;

struct Limits {
  explicit Limits(double crease)
      : low(crease_cosine(kLowPart * crease)),
        crease(crease_cosine(crease)),
        firm(crease_cosine(crease + kFirmDegrees)),
        sharp(crease_cosine(std::max(kSurelySharp, crease))) {}
  float low, crease, firm, sharp;  ///< cosines: smaller is sharper
};

class BendClassifier {
 public:
  BendClassifier(const Scene& scene, const Topology& topology, const MeshAngles& angles, std::span<const double> sizes,
                 double crease_degrees)
      : scene_(scene), topology_(topology), angles_(angles), sizes_(sizes), limits_(crease_degrees) {}

  FaceBends run() const {
    FaceBends found;
    found.bends.assign(topology_.edges.size(), Bend::none);
    const Counts counts =
        parallel_reduce(topology_.edges.size(), kShortWorkBlock, Counts{}, [&](std::size_t begin, std::size_t end) {
          Counts sum;
          for (std::size_t first = begin, last = begin; first < end; first = last) {
            last = std::min(first + kTogether, end);
            if (are_plain(first, last)) continue;
            for (std::size_t e = first; e < last; ++e) found.bends[e] = bend_of(e, sum);
          }
          return sum;
        });
    found.smooth_by_file = counts.smooth;
    found.sharp_by_file = counts.sharp;
    return found;
  }

 private:
  static constexpr std::size_t kTogether = 16;  ///< edges that are passed together; adjustable

  /// Whether edges bend by little and have no flags, as nearly all edges of a fine mesh: bend_of() is none for them. There
  /// is no branch, so that the loop can be vectorized.
  bool are_plain(std::size_t begin, std::size_t end) const {
    std::uint32_t any = 0;
    for (std::size_t e = begin; e < end; ++e) {
      any |= static_cast<std::uint32_t>(!(angles_.cosines[e] >= limits_.low)) | topology_.edge_flags[e];
    }
    return any == 0;
  }

  struct Counts {
    std::size_t smooth = 0, sharp = 0;
    friend Counts operator+(const Counts& a, const Counts& b) { return {a.smooth + b.smooth, a.sharp + b.sharp}; }
  };

  Bend bend_of(std::size_t e, Counts& counts) const {
    const auto flags = topology_.edge_flags[e];
    if (angles_.cosines[e] >= limits_.low && flags == 0) return Bend::none;
    const Edge& edge = topology_.edges[e];
    if (edge.face1 == kNone || (flags & (kEdgeManyFaces | kEdgeFileHidden | kEdgeInner))) return Bend::none;
    const float turn = flags & kEdgeUnlikeWound ? -1 : 1;
    const float cosine = angles_.cosines[e] * turn;
    if (flags & kEdgeLimit) return Bend::none;
    if (flags & kEdgeSmooth) {
      if (cosine < limits_.sharp) return Bend::firm;
      if (cosine >= limits_.low) return Bend::none;
      const Bend bend = bend_of_smooth(edge, cosine);
      if (bend >= Bend::strong || cosine >= limits_.crease) return bend;
      ++counts.smooth;
      return Bend::weak;
    }
    if (flags & kEdgeSharp) {
      if (cosine >= limits_.low) return Bend::none;
      counts.sharp += cosine >= limits_.crease;
      return Bend::firm;
    }
    if (cosine < limits_.firm) return Bend::firm;
    if (cosine < limits_.crease) return Bend::strong;
    return cosine < limits_.low ? Bend::weak : Bend::none;
  }

  /// The bend of an edge that the file calls smooth: a surface too small to be drawn as curved is drawn as an edge.
  Bend bend_of_smooth(const Edge& edge, float cosine) const {
    const double size = sizes_[object_of_vertex(scene_, edge.v0)];
    const auto widths = widths_across(scene_, edge);
    const double narrow = std::min(widths[0], widths[1]);
    // The radius of the arc of which the faces are chords. One of them may be a flat side beside it, so the narrower
    // one counts.
    if (cosine < limits_.crease && narrow < kRoundPart * size * std::acos(std::max(-1.0f, cosine)))
      return cosine < limits_.firm ? Bend::firm : Bend::strong;
    // If the edge is in the middle, both its faces belong to the fillet.
    if (widths[0] + widths[1] >= kNarrowPart * size) return Bend::none;
    const auto fillet = fillet_at(scene_, topology_, edge, narrow);
    if (!fillet || fillet->width() >= kNarrowPart * size) return Bend::none;
    const float bend = glm::dot(angles_.normals[fillet->sides[0]], angles_.normals[fillet->sides[1]]);
    return bend < limits_.crease && fillet->in_middle() ? Bend::strong : Bend::none;
  }

  const Scene& scene_;
  const Topology& topology_;
  const MeshAngles& angles_;
  std::span<const double> sizes_;
  Limits limits_;
};

}  // namespace

float crease_cosine(double degrees) {
  return static_cast<float>(std::cos(std::min(180.0, degrees + kSlackDegrees) * std::numbers::pi / 180));
}

FaceBends bends_by_faces(const Scene& scene, const Topology& topology, const MeshAngles& angles,
                         std::span<const double> sizes, double crease_degrees) {
  return BendClassifier(scene, topology, angles, sizes, crease_degrees).run();
}

}  // namespace ligne
