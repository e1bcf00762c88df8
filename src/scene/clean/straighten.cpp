// A vertex can be removed if every contour that visits it goes straight on there, all between the same two neighbours:
// the contours on both sides then lose the same vertex and still fit. Small bends add up along a gentle curve. So a run
// of such vertices is removed only if all of it lies on the chord between its ends; otherwise all of it stays.

#include <algorithm>
#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "scene/clean/merge_contours.hpp"
#include "scene/model/planarity.hpp"

namespace ligne {
namespace {

class Straightener {
 public:
  Straightener(const std::vector<Point3>& vertices, const Object& object, std::vector<MergedFace>& faces)
      : vertices_(vertices), object_(object), faces_(faces), seen_(object.vertex_end - object.vertex_begin) {}

  void run() {
    find_straight_vertices();
    for_merged([&](Contour& contour) { check_runs(contour); });
    for_merged([&](Contour& contour) { keep_three(contour); });
    for_merged([&](Contour& contour) { drop(contour); });
  }

 private:
  /// Findings of the contours at a vertex.
  struct Seen {
    std::uint32_t low = kNone, high = kNone;  ///< its two neighbours
    bool straight = false;
  };

  Seen& seen(std::uint32_t v) { return seen_[v - object_.vertex_begin]; }

  template <class Work>
  void for_merged(const Work& work) {
    for (MergedFace& face : faces_) {
      if (!face.merged) continue;
      for (Contour& contour : face.contours) work(contour);
    }
  }

  /// Whether q lies on the chord from a to b within the precision of the coordinates.
  bool is_on_chord(std::uint32_t a, std::uint32_t q, std::uint32_t b) const {
    const Point3 chord = vertices_[b] - vertices_[a], to_q = vertices_[q] - vertices_[a];
    const double length = glm::length(chord);
    const double along = glm::dot(to_q, chord);
    if (!(along > 0 && along < length * length)) return false;
    return glm::length(glm::cross(chord, to_q)) / length <= straightness_tolerance(object_.precision, length);
  }

  void find_straight_vertices() {
    for (const MergedFace& face : faces_) {
      for (const Contour& contour : face.contours) {
        const std::size_t n = contour.corners.size();
        for (std::size_t k = 0; k < n; ++k) {
          const std::size_t before = k == 0 ? n - 1 : k - 1;
          const auto [low, high] = std::minmax({contour.corners[before], contour.corners[k + 1 == n ? 0 : k + 1]});
          Seen& s = seen(contour.corners[k]);
          const bool first = s.low == kNone;
          const bool agrees = face.merged && contour.flags[before] == contour.flags[k] &&
                              (first ? is_on_chord(low, contour.corners[k], high) : s.low == low && s.high == high);
          s = {low, high, (first || s.straight) && agrees};
        }
      }
    }
  }

  /// Marks runs of straight vertices as not straight if they leave the chord between their ends.
  void check_runs(Contour& contour) {
    const std::size_t n = contour.corners.size();
    const auto at = [&](std::size_t k) { return contour.corners[k % n]; };
    std::size_t anchor = 0;
    while (anchor < n && seen(at(anchor)).straight) ++anchor;
    if (anchor == n) {  // a smooth closed curve
      for (const std::uint32_t v : contour.corners) seen(v).straight = false;
      return;
    }
    for (std::size_t begin = anchor; begin < anchor + n;) {
      std::size_t end = begin + 1;
      while (seen(at(end)).straight) ++end;
      bool on_chord = true;
      for (std::size_t k = begin + 1; k < end; ++k) on_chord = on_chord && is_on_chord(at(begin), at(k), at(end));
      for (std::size_t k = begin + 1; k < end && !on_chord; ++k) seen(at(k)).straight = false;
      begin = end;
    }
  }

  /// Keeps all vertices of a contour that would have fewer than three left.
  void keep_three(Contour& contour) {
    const auto is_bend = [&](std::uint32_t v) { return !seen(v).straight; };
    if (std::count_if(contour.corners.begin(), contour.corners.end(), is_bend) >= 3) return;
    for (const std::uint32_t v : contour.corners) seen(v).straight = false;
  }

  void drop(Contour& contour) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < contour.corners.size(); ++k) {
      if (seen(contour.corners[k]).straight) continue;
      contour.corners[kept] = contour.corners[k];
      contour.flags[kept] = contour.flags[k];
      ++kept;
    }
    contour.corners.resize(kept);
    contour.flags.resize(kept);
  }

  const std::vector<Point3>& vertices_;
  const Object& object_;
  std::vector<MergedFace>& faces_;
  std::vector<Seen> seen_;
};

}  // namespace

void straighten(const std::vector<Point3>& vertices, const Object& object, std::vector<MergedFace>& faces) {
  Straightener(vertices, object, faces).run();
}

}  // namespace ligne
