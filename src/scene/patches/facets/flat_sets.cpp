#include "scene/patches/facets/flat_sets.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/index_lists.hpp"
#include "base/no_index.hpp"
#include "geometry/degrees.hpp"
#include "geometry/point.hpp"
#include "scene/model/faces_and_edges.hpp"
#include "scene/model/planarity.hpp"
#include "scene/patches/facet_graph.hpp"

namespace ligne {
namespace {

/// A plane with the range of its points along the normal.
struct FlatRange {
  Point3 at{0, 0, 0}, normal{0, 0, 0};
  double low = std::numeric_limits<double>::infinity(), high = -low;

  void add(const Point3& p) {
    const double height = glm::dot(p - at, normal);
    low = std::min(low, height), high = std::max(high, height);
  }
  double width() const { return high - low; }
  void turn_to_unit() {
    if (const double length = glm::length(normal); length > 0) normal /= length;
  }
  /// Moves the point of the plane to the middle of the range.
  void move_to_middle() { at += (low + high) / 2 * normal; }
};

/// Distance from a fitted plane within which a divided set collects corners, in errors of a point: one of the corner and
/// one of the plane.
constexpr double kCollectErrors = 2;
/// Factor of the tolerance at which a collected set is tried again, and the largest factor by which the area of a plane
/// grows then. A part of a cylinder becomes twice as large, a part of a sphere four times.
constexpr double kWider = 4, kMostGrowth = 1.25;
/// Factor of the tolerance up to which a face beside a plane may be a part of the same surface. Such a face lies within
/// the wider tolerance with two thirds of its area or more.
constexpr double kDoubtful = 1.5 * kWider;
/// Largest factor of the least tolerance at which the faces of a plane are collected.
constexpr double kWidest = 4;
/// Most fits of the plane of one set.
constexpr int kMostFits = 24;
/// Work on an object after which no more planes are collected, in faces that are looked at: so many for each of its faces,
/// and so many in all, which take two or three seconds. 3DBenchy needs 230 for each of its 225,000 faces. On rough ground of
/// half a million, whose heights are some roundings, every face would collect thousands of others in vain.
constexpr std::uint64_t kMostLooks = 32, kLooksInAll = 64'000'000;
/// Limits of the looks by sets that are rejected, and how many more each face of a plane allows.
constexpr std::uint64_t kMostVainLooks = 8, kVainLooksInAll = 4'000'000, kVainLooksPerFace = 4096;
/// Number of rejected sets that may collect the same face.
constexpr std::uint8_t kMostRejections = 4;

class FlatSetFinder {
 public:
  FlatSetFinder(const Scene& scene, const Object& object, std::span<const Edge> edges, std::span<const std::uint32_t> joints)
      : scene_(scene), object_(object), edges_(edges), joints_(joints), set_of_(object.face_end - object.face_begin) {}

  FlatSets run(std::span<const std::uint32_t> order) {
    DisjointSets sets(set_of_.size());
    for (const std::uint32_t e : joints_) sets.join(local(edges_[e].face0), local(edges_[e].face1));
    for (std::uint32_t f = 0; f < set_of_.size(); ++f) set_of_[f] = sets.find(f);
    measure_sets();
    if (find_doubtful_sets()) {
      list_neighbours();
      keep_flat_sets();
      divide(order);
      // One of two faces may be left without the one that names their set.
      for (std::uint32_t f = 0; f < set_of_.size(); ++f) {
        if (set_of_[set_of_[f]] != set_of_[f]) set_of_[f] = f;
      }
    }
    return {std::move(set_of_), has_small_faces_, looks_};
  }

 private:
  /// Judgement of a set of three faces or more.
  enum class State : std::uint8_t { flat, doubtful, uneven };

  struct Set {
    FlatRange range;
    double doubtful = 0;  ///< distance from the plane up to which a face beside it makes the set doubtful
    State state = State::flat;
  };

  std::uint32_t local(std::uint32_t face) const { return face - object_.face_begin; }

  std::span<const std::uint32_t> corners(std::uint32_t f) const { return corners_of(scene_.faces, object_.face_begin + f); }

  Point3 area_of(std::uint32_t f) const { return double_area(scene_, object_.face_begin + f); }

  const Point3& first_corner(std::uint32_t f) const {
    return scene_.vertices[scene_.faces.contour(object_.face_begin + f, 0)[0]];
  }

  /// Distance from a fitted plane within which its corners are collected.
  double tolerance() const { return kCollectErrors * std::sqrt(3.0) * object_.precision; }
  double tolerance_of(const FlatRange& plane) const { return std::max(tolerance(), plane.width() / 2); }

  /// Largest distance from a plane of some corners of a face, evenly spread: a large polygon may lie beside many planes.
  double distance(std::uint32_t f, const FlatRange& plane) const {
    constexpr std::size_t kMostCorners = 64;
    const auto contour = scene_.faces.contour(object_.face_begin + f, 0);
    const std::size_t step = contour.size() / kMostCorners + 1;
    double most = 0;
    for (std::size_t i = 0; i < contour.size(); i += step) {
      most = std::max(most, std::abs(glm::dot(scene_.vertices[contour[i]] - plane.at, plane.normal)));
    }
    return most;
  }

  /// Whether all corners of a face lie within `tolerance` of a plane. Stops at the first that does not.
  bool lies_within(std::uint32_t f, const FlatRange& plane, double tolerance) const {
    return std::ranges::all_of(corners(f), [&](std::uint32_t v) {
      return std::abs(glm::dot(scene_.vertices[v] - plane.at, plane.normal)) <= tolerance;
    });
  }

  /// Finds the planes of the sets of three faces or more. Two faces are flat if they say so.
  void measure_sets() {
    std::vector<std::uint32_t> sizes(set_of_.size(), 0);
    for (const std::uint32_t set : set_of_) ++sizes[set];
    number_.assign(set_of_.size(), kNone);
    for (std::uint32_t f = 0; f < set_of_.size(); ++f) {
      if (sizes[set_of_[f]] < 3) continue;
      if (set_of_[f] == f) {
        number_[f] = static_cast<std::uint32_t>(sets_.size());
        sets_.emplace_back().range.at = first_corner(f);
      }
      number_[f] = number_[set_of_[f]];
      faces_.push_back(f);
      sets_[number_[f]].range.normal += area_of(f);
    }
    for (Set& set : sets_) set.range.turn_to_unit();
    for (const std::uint32_t f : faces_) {
      FlatRange& range = sets_[number_[f]].range;
      for (const std::uint32_t v : corners(f)) range.add(scene_.vertices[v]);
    }
    for (Set& set : sets_) {
      set.range.move_to_middle();
      set.doubtful = kDoubtful * tolerance_of(set.range);
    }
  }

  /// Finds the sets that lie in no plane.
  void find_uneven_sets() {
    const double least = planarity_tolerance(object_.precision, 0);
    if (std::ranges::all_of(sets_, [&](const Set& set) { return set.range.width() <= 2 * least; })) return;
    std::vector<double> extents(sets_.size(), 0);
    for (const std::uint32_t f : faces_) {
      const Point3& at = sets_[number_[f]].range.at;
      double& extent = extents[number_[f]];
      for (const std::uint32_t v : corners(f)) {
        const Point3 off = scene_.vertices[v] - at;
        extent = std::max(extent, glm::dot(off, off));
      }
    }
    const double flat_sine = sine_cosine_degrees(kFlatBend).sine;
    for (std::size_t i = 0; i < sets_.size(); ++i) {
      const double extent = std::sqrt(extents[i]);
      const double tolerance = std::max(planarity_tolerance(object_.precision, extent), flat_sine * extent);
      if (sets_[i].range.width() > 2 * tolerance) sets_[i].state = State::uneven;
    }
  }

  /// Finds the sets that lie in no plane, and those whose plane may go on beyond them. Whether there are any.
  bool find_doubtful_sets() {
    find_uneven_sets();
    const auto look = [&](std::uint32_t f, std::uint32_t beside) {
      if (number_[f] == kNone) return;
      Set& set = sets_[number_[f]];
      if (set.state == State::flat && lies_within(beside, set.range, set.doubtful)) {
        set.state = State::doubtful;
      }
    };
    for (const Edge& edge : edges_) {
      if (edge.face1 == kNone) continue;
      const std::uint32_t a = local(edge.face0), b = local(edge.face1);
      if (number_[a] == number_[b]) continue;
      look(a, b);
      look(b, a);
    }
    return std::ranges::any_of(sets_, [](const Set& set) { return set.state != State::flat; });
  }

  void list_neighbours() {
    neighbours_ = IndexLists(set_of_.size(), [&](const auto& add) {
      for (const Edge& edge : edges_) {
        if (edge.face1 == kNone) continue;
        add(local(edge.face0), local(edge.face1));
        add(local(edge.face1), local(edge.face0));
      }
    });
    area_.resize(set_of_.size());
    for (std::uint32_t f = 0; f < area_.size(); ++f) area_[f] = glm::length(area_of(f));
    reached_.assign(set_of_.size(), kNone);
    rejections_.assign(set_of_.size(), 0);
  }

  /// Decides on the doubtful sets, the largest first.
  void keep_flat_sets() {
    std::vector<std::vector<std::uint32_t>> members(sets_.size());
    std::vector<double> areas(sets_.size(), 0);
    std::vector<std::uint32_t> doubtful;
    for (std::uint32_t f = 0; f < set_of_.size(); ++f) {
      if (number_[f] == kNone) continue;
      if (sets_[number_[f]].state == State::flat) rejections_[f] = kMostRejections;
      if (sets_[number_[f]].state != State::doubtful) continue;
      if (members[number_[f]].empty()) doubtful.push_back(number_[f]);
      members[number_[f]].push_back(f);
      areas[number_[f]] += area_[f];
    }
    std::ranges::stable_sort(doubtful, [&](std::uint32_t a, std::uint32_t b) { return areas[a] > areas[b]; });
    for (const std::uint32_t set : doubtful) {
      if (is_worked_out()) {
        sets_[set].state = State::uneven;
        continue;
      }
      std::erase_if(members[set], [&](std::uint32_t f) { return rejections_[f] == kMostRejections; });
      if (members[set].empty()) continue;
      if (collect_plane(members[set], tolerance_of(sets_[set].range))) {
        has_small_faces_ = has_small_faces_ || members_.size() > members[set].size();
        keep(members[set][0]);
      } else {
        sets_[set].state = State::uneven;
      }
    }
  }

  bool is_worked_out() const {
    const std::uint64_t vain = kVainLooksInAll + kMostVainLooks * set_of_.size() + kVainLooksPerFace * faces_of_planes_;
    return vain_looks_ > vain || looks_ > kLooksInAll + kMostLooks * set_of_.size();
  }

  /// Makes one set of the members.
  void keep(std::uint32_t set) {
    faces_of_planes_ += members_.size();
    for (const std::uint32_t f : members_) set_of_[f] = set, rejections_[f] = kMostRejections;
  }

  bool is_uneven(std::uint32_t f) const { return number_[f] != kNone && sets_[number_[f]].state == State::uneven; }

  /// Divides the uneven sets.
  void divide(std::span<const std::uint32_t> order) {
    std::vector<std::uint32_t> seeds;
    for (const std::uint32_t f : order) {
      if (rejections_[f] == 0 && is_uneven(f)) seeds.push_back(f), set_of_[f] = f;
    }
    std::ranges::stable_sort(seeds, [&](std::uint32_t a, std::uint32_t b) { return area_[a] > area_[b]; });
    bool has_sampled = false;
    for (const std::uint32_t seed : seeds) {
      if (is_worked_out() && !std::exchange(has_sampled, true)) foresee_planes(seeds);
      if (is_worked_out()) return;
      if (rejections_[seed] != 0) continue;
      if (collect_plane(std::span(&seed, 1), tolerance())) {
        has_small_faces_ = true;
        keep(seed);
      } else {
        for (const std::uint32_t f : members_) ++rejections_[f];
      }
    }
  }

  /// Counts the faces of planes of some seeds, spread evenly over all: planes may have smaller faces than rough ground.
  void foresee_planes(std::span<const std::uint32_t> seeds) {
    constexpr std::size_t kSamples = 128;
    for (std::size_t i = 0; i < seeds.size(); i += seeds.size() / kSamples + 1) {
      if (rejections_[seeds[i]] == 0 && collect_plane(seeds.subspan(i, 1), tolerance())) faces_of_planes_ += members_.size();
    }
  }

  /// The plane through the middle of the members.
  FlatRange fit() const {
    FlatRange plane;
    plane.at = first_corner(members_[0]);
    for (const std::uint32_t f : members_) plane.normal += area_of(f);
    plane.turn_to_unit();
    for (const std::uint32_t f : members_) {
      for (const std::uint32_t v : corners(f)) plane.add(scene_.vertices[v]);
    }
    plane.move_to_middle();
    return plane;
  }

  /// Collects the faces of the plane of some, at the first of several tolerances at which they are flat. If there is none,
  /// the members are those of the least tolerance.
  bool collect_plane(std::span<const std::uint32_t> seeds, double tolerance) {
    const std::uint64_t before = looks_;
    std::vector<std::uint32_t> first;
    do {
      const FlatRange plane = collect(seeds, tolerance);
      if (members_.size() > 1 && is_flat(plane)) return true;
      if (first.empty()) first = members_;
      tolerance *= 2;
    } while (tolerance <= kWidest * this->tolerance());
    members_ = first;
    vain_looks_ += looks_ - before;
    return false;
  }

  /// Collects the faces that lie within `tolerance` of the plane of some.
  FlatRange collect(std::span<const std::uint32_t> seeds, double tolerance) {
    members_.assign(seeds.begin(), seeds.end());
    FlatRange plane = fit();
    std::size_t before = 0;
    for (int i = 0; i < kMostFits && members_.size() > before; ++i) {
      before = members_.size();
      members_.assign(seeds.begin(), seeds.end());
      ++round_;
      for (const std::uint32_t f : seeds) reached_[f] = round_;
      for (std::size_t k = 0; k < members_.size(); ++k) {
        for (const std::uint32_t next : neighbours_[members_[k]]) {
          ++looks_;
          if (reached_[next] == round_ || rejections_[next] >= kMostRejections) continue;
          if (!lies_within(next, plane, tolerance)) continue;
          reached_[next] = round_;
          members_.push_back(next);
        }
      }
      plane = fit();
    }
    return plane;
  }

  /// Whether the members, which this round has reached, lie in a plane, rather than on a surface that leaves any plane
  /// slowly.
  bool is_flat(const FlatRange& plane) {
    double area = 0;
    for (const std::uint32_t f : members_) area += area_[f];
    const std::size_t count = members_.size();
    const double most = (kMostGrowth - 1) * area, wide = kWider * tolerance_of(plane);
    double added = 0;
    for (std::size_t i = 0; i < members_.size() && added <= most; ++i) {
      for (const std::uint32_t next : neighbours_[members_[i]]) {
        if (reached_[next] == round_) continue;
        reached_[next] = round_;
        const bool is_near = lies_within(next, plane, wide);
        if (is_near) members_.push_back(next);
        // If a face leaves the plane, about this part of it lies within the tolerance.
        added += is_near ? area_[next] : wide / std::max(wide, distance(next, plane)) * area_[next];
      }
    }
    members_.resize(count);
    return added <= most;
  }

  const Scene& scene_;
  const Object& object_;
  std::span<const Edge> edges_;
  std::span<const std::uint32_t> joints_;
  std::vector<std::uint32_t> set_of_;  ///< per face: a face of its set
  std::vector<Set> sets_;
  std::vector<std::uint32_t> faces_;   ///< those of these sets
  std::vector<std::uint32_t> number_;  ///< per face: its set in sets_, kNone if that has less than three faces
  IndexLists neighbours_;              ///< per face: those beside it
  std::vector<double> area_;
  std::vector<std::uint8_t> rejections_;  ///< per face: number of rejected sets that collected it
  std::vector<std::uint32_t> reached_;    ///< per face: the last round that reached it
  std::vector<std::uint32_t> members_;
  std::uint32_t round_ = 0;
  std::uint64_t looks_ = 0, vain_looks_ = 0;  ///< faces looked at; those of them by sets that were rejected
  std::uint64_t faces_of_planes_ = 0;         ///< found or, when the work is to end, foreseen
  bool has_small_faces_ = false;
};

}  // namespace

FlatSets flat_sets(const Scene& scene, const Object& object, std::span<const Edge> edges,
                   std::span<const std::uint32_t> joints, std::span<const std::uint32_t> order) {
  return FlatSetFinder(scene, object, edges, joints).run(order);
}

}  // namespace ligne
