#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <unordered_map>

#include "base/no_index.hpp"
#include "geometry/small_matrices.hpp"
#include "scene/patches/swept/swept_facets.hpp"

namespace ligne {
namespace {

// Adjustable.
/// Largest sine of the angle between the axes of two bands, and largest distance of these axes, divided by the larger
/// radius.
constexpr double kAxisSine = 0.03, kAxisDistance = 0.03;
/// Factor of the tolerance before the axis is fitted to the corners of all bands.
constexpr double kFirstTolerance = 4;
/// Fewest rows that are looked at further.
constexpr std::size_t kFewestRows = 4;
/// Most fits of an axis, each to more facets.
constexpr int kMostRounds = 4;
/// Largest part of a facet's normal along the circle: 17 degrees, half of the turn of facets of which ten go round.
constexpr double kMostAside = 0.3;
/// Corners of a facet of one row.
constexpr std::size_t kFewCorners = 4;
/// Fewest bands of one axis that are looked at; one fewer where a free form is beside them.
constexpr std::size_t kFewestBands = 3;
/// Fewest of them that are no cylinders: a chamfer or a fillet between two cylinders is one.
constexpr std::ptrdiff_t kFewestRound = 2;
/// Fewest facets between two circles. The corners of two have one distance from many axes.
constexpr std::size_t kFewestFacets = 3;

class RevolvedFinder {
 public:
  RevolvedFinder(const FacetObject& object, const FacetPatches& surfaces, SweptPatches& swept)
      : object_(object),
        graph_(object.graph),
        surfaces_(surfaces),
        swept_(swept),
        tolerance_(swept_tolerance(object.object)),
        found_(surfaces.patches.size()),
        stamp_(object.graph.size(), 0) {}

  void run() {
    if (surfaces_.patches.empty()) return;
    list_neighbours();
    std::vector<std::uint32_t> order(found_);
    for (std::uint32_t p = 0; p < found_; ++p) order[p] = p;
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::uint32_t p) { return counts_[p]; });
    is_done_.assign(found_, 0);
    for (const std::uint32_t p : order) {
      while (!is_done_[p] && counts_[p] > 0 && has_axis(p)) {
        const std::vector<std::uint32_t> bands = bands_about(p);
        if (!may_have_profile(bands)) {
          is_done_[p] = 1;
          break;
        }
        const std::uint32_t seed = *std::ranges::min_element(bands, {}, [&](std::uint32_t q) { return residual(q); });
        is_done_[seed] = 1;
        try_axis(seed);
      }
    }
  }

 private:
  bool has_axis(std::uint32_t p) const {
    const SurfaceKind kind = surfaces_.patches[p].surface.kind;
    return kind == SurfaceKind::cylinder || kind == SurfaceKind::cone || kind == SurfaceKind::torus;
  }

  bool is_free(std::uint32_t f) const { return surfaces_.is_freeform[f] && surfaces_.patch_of[f] == kNone; }

  /// Whether bands about one axis may be rows of a profile: those of a free form are cones, but for accidents.
  bool may_have_profile(const std::vector<std::uint32_t>& bands) const {
    const auto is_beside_freeform = [&](std::uint32_t p) { return beside_freeform_[p] != 0; };
    const auto is_round = [&](std::uint32_t p) { return surfaces_.patches[p].surface.kind != SurfaceKind::cylinder; };
    const std::size_t fewest = std::ranges::any_of(bands, is_beside_freeform) ? kFewestBands - 1 : kFewestBands;
    return bands.size() >= fewest && std::ranges::count_if(bands, is_round) >= kFewestRound;
  }

  /// Lists which patches lie beside each other and beside free forms.
  void list_neighbours() {
    counts_.assign(found_, 0);
    first_.assign(found_, kNone);
    beside_freeform_.assign(found_, 0);
    std::vector<std::array<std::uint32_t, 2>> pairs;
    for (std::uint32_t f = 0; f < graph_.size(); ++f) {
      const std::uint32_t p = surfaces_.patch_of[f];
      if (p == kNone) continue;
      if (counts_[p]++ == 0) first_[p] = f;
      for (const FacetGraph::Arc& arc : graph_.arcs_of(f)) {
        const std::uint32_t q = surfaces_.patch_of[arc.facet];
        if (q == p) continue;
        if (q != kNone) pairs.push_back({p, q});
        if (is_free(arc.facet)) beside_freeform_[p] = 1;
      }
    }
    std::ranges::sort(pairs);
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    neighbours_.assign(found_, {});
    is_listed_.assign(found_, 0);
    for (const Patch& patch : surfaces_.patches) {
      is_arc_.push_back(patch.surface.kind == SurfaceKind::torus || patch.surface.kind == SurfaceKind::sphere);
      is_cylinder_.push_back(patch.surface.kind == SurfaceKind::cylinder);
    }
    for (const auto& [p, q] : pairs) neighbours_[p].push_back(q);
  }

  /// Largest distance of corners of a patch from its surface; infinite if it tells no axis or was looked at. Bands that lie
  /// on a surface by accident tell the axis less exactly.
  double residual(std::uint32_t p) const {
    constexpr std::size_t kMostFacets = 64;
    if (is_done_[p] || !has_axis(p)) return std::numeric_limits<double>::infinity();
    double most = 0;
    std::size_t left = std::min(counts_[p], kMostFacets);
    for (std::uint32_t f = first_[p]; f < graph_.size() && left > 0; ++f) {
      if (surfaces_.patch_of[f] != p) continue;
      --left;
      for (const std::uint32_t v : graph_.vertices[f])
        most = std::max(most, std::abs(surfaces_.patches[p].surface.distance(object_.scene.vertices[v])));
    }
    return most;
  }

  /// Whether a patch is round about the axis of a surface.
  bool is_about(const PatchSurface& axis, std::uint32_t p) const {
    const PatchSurface& s = surfaces_.patches[p].surface;
    if (p >= found_) return false;
    if (s.kind != SurfaceKind::sphere && glm::length(glm::cross(axis.axis, s.axis)) > kAxisSine) return false;
    const Point3 way = s.at - axis.at;
    const double off = glm::length(way - glm::dot(way, axis.axis) * axis.axis);
    return off <= kAxisDistance * std::max(axis.radius, s.radius);
  }

  /// A patch and those about its axis that are connected with it.
  std::vector<std::uint32_t> bands_about(std::uint32_t p) {
    std::vector<std::uint32_t> bands{p};
    is_listed_[p] = 1;
    for (std::size_t i = 0; i < bands.size(); ++i) {
      for (const std::uint32_t q : neighbours_[bands[i]]) {
        if (is_listed_[q] || !is_about(surfaces_.patches[p].surface, q)) continue;
        is_listed_[q] = 1;
        bands.push_back(q);
      }
    }
    for (const std::uint32_t q : bands) is_listed_[q] = 0;
    return bands;
  }

  void try_axis(std::uint32_t seed) {
    PatchSurface frame = surfaces_.patches[seed].surface;
    frame.kind = SurfaceKind::revolved;
    frame.at += glm::dot(graph_.frames[first_[seed]].middle - frame.at, frame.axis) * frame.axis;
    // The axis of a band of few rows is inexact, and so is that which was fitted to the rows near it.
    std::size_t count = 0;
    for (int round = 0; round < kMostRounds; ++round) {
      const std::vector<SweptFacet> near = walk(seed, frame, kFirstTolerance * tolerance_);
      if (near.size() <= count) break;
      if (count == 0 && profile_of(near, surfaces_, 2 * kFirstTolerance * tolerance_).sides.size() < kFewestRows) return;
      count = near.size();
      fit_axis(near, kFirstTolerance * tolerance_, frame);
    }
    const std::vector<SweptFacet> facets = walk(seed, frame, tolerance_);
    for (const SweptFacet& f : facets) {
      if (surfaces_.patch_of[f.facet] != kNone) is_done_[surfaces_.patch_of[f.facet]] = 1;
    }
    FacetProfile profile = profile_of(facets, surfaces_, 2 * tolerance_);
    drop_short_rows(profile);
    frame.radius = frame.slope = frame.tube = 0;
    swept_.add(frame, frame_of(frame.axis), profile,
               smooth_pieces(profile.points, profile.sides, {is_arc_, is_cylinder_, 2 * tolerance_}));
  }

  /// Drops the sides of few facets.
  static void drop_short_rows(FacetProfile& profile) {
    FacetProfile kept{std::move(profile.points), {}, {}};
    for (std::size_t s = 0; s < profile.sides.size(); ++s) {
      if (profile.facets[s].size() < kFewestFacets) continue;
      kept.sides.push_back(profile.sides[s]);
      kept.facets.push_back(std::move(profile.facets[s]));
    }
    profile = std::move(kept);
  }

  /// The facets between circles about an axis, from a patch on.
  std::vector<SweptFacet> walk(std::uint32_t seed, const PatchSurface& axis, double tolerance) {
    ++round_;
    std::vector<SweptFacet> found;
    const auto visit = [&](std::uint32_t f) {
      if (stamp_[f] == round_ || (surfaces_.patch_of[f] != kNone && surfaces_.patch_of[f] >= found_)) return;
      stamp_[f] = round_;
      if (const auto ends = ends_of(f, axis, tolerance)) found.push_back({f, *ends});
    };
    std::size_t left = counts_[seed];
    for (std::uint32_t f = first_[seed]; f < graph_.size() && left > 0 && found.empty(); ++f) {
      if (surfaces_.patch_of[f] != seed) continue;
      visit(f);
      --left;
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
      for (const FacetGraph::Arc& arc : graph_.arcs_of(found[i].facet)) visit(arc.facet);
    }
    // Bands about another axis are accidents if they lie on these circles with all of their facets.
    std::unordered_map<std::uint32_t, std::size_t> counts;
    for (const SweptFacet& f : found) ++counts[surfaces_.patch_of[f.facet]];
    std::erase_if(found, [&](const SweptFacet& f) {
      const std::uint32_t p = surfaces_.patch_of[f.facet];
      return p != kNone && counts.at(p) < counts_[p] && !is_about(surfaces_.patches[seed].surface, p);
    });
    return found;
  }

  /// The two points of the profile at which all corners of a facet lie, or between which those of several rows in one
  /// plane lie; nothing if there are none.
  std::optional<std::array<Point2, 2>> ends_of(std::uint32_t f, const PatchSurface& axis, double tolerance) {
    std::vector<Point2>& places = places_;
    places.clear();
    for (const std::uint32_t v : graph_.vertices[f]) {
      const AxisPlace place = axis_place(axis, object_.scene.vertices[v]);
      places.emplace_back(place.radius, place.along);
    }
    // The two that are farthest apart, as all lie on one line.
    const auto farthest = [&](const Point2& from) {
      return *std::ranges::max_element(places, {}, [&](const Point2& p) { return glm::distance(p, from); });
    };
    const Point2 first = farthest(places[0]), second = farthest(first), side = second - first;
    const double width = glm::length(side);
    const std::array<Point2, 2> ends{first, second};
    if (!(width > 2 * tolerance)) return std::nullopt;
    const auto is_beside = [&](const Point2& p) {
      const double along = glm::dot(p - first, side) / width;
      if (graph_.vertices[f].size() <= kFewCorners && std::min(std::abs(along), std::abs(along - width)) > 2 * tolerance)
        return true;
      return std::abs(cross(side, p - first)) > largest_offset(tolerance, width) * width;
    };
    if (std::ranges::any_of(places, is_beside)) return std::nullopt;
    const FacetFrame& frame = graph_.frames[f];
    const Point3 round = glm::cross(axis.axis, axis_place(axis, frame.middle).out);
    if (!graph_.is_sliver[f] && std::abs(glm::dot(frame.normal, round)) > kMostAside) return std::nullopt;
    return ends;
  }

  /// A corner on a circle.
  struct CircleCorner {
    std::uint32_t circle, vertex;
    auto operator<=>(const CircleCorner&) const = default;
  };

  /// The corners on the circles of facets, each once, by circles.
  std::vector<CircleCorner> circle_corners(const std::vector<SweptFacet>& facets, double tolerance,
                                           const PatchSurface& axis) const {
    const FacetProfile profile = profile_of(facets, surfaces_, 2 * tolerance);
    std::vector<CircleCorner> corners;
    for (std::size_t s = 0; s < profile.sides.size(); ++s) {
      const ProfileSide& side = profile.sides[s];
      for (const std::uint32_t f : profile.facets[s]) {
        for (const std::uint32_t vertex : graph_.vertices[f]) {
          const AxisPlace place = axis_place(axis, object_.scene.vertices[vertex]);
          const auto off = [&](std::uint32_t circle) {
            return glm::distance(profile.points[circle], Point2(place.radius, place.along));
          };
          const std::uint32_t circle = off(side.from) <= off(side.to) ? side.from : side.to;
          if (off(circle) <= 2 * tolerance) corners.push_back({circle, vertex});
        }
      }
    }
    std::ranges::sort(corners);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
  }

  /// Fits the axis so that the corners on each circle have one place beside it: least squares, to first order.
  void fit_axis(const std::vector<SweptFacet>& facets, double tolerance, PatchSurface& axis) const {
    using Row = std::array<double, 4>;  // by a shift of the axis along its frame, and a turn towards it
    const std::array<Point3, 2> frame = frame_of(axis.axis);
    const std::vector<CircleCorner> corners = circle_corners(facets, tolerance, axis);
    std::array<Row, 4> normal{};
    Row by{};
    const auto add = [&](const Row& row, double off) {
      for (std::size_t i = 0; i < 4; ++i) {
        by[i] -= row[i] * off;
        for (std::size_t k = 0; k <= i; ++k) normal[i][k] += row[i] * row[k];
      }
    };
    for (std::size_t i = 0, k = 0; i < corners.size(); i = k) {
      while (k < corners.size() && corners[k].circle == corners[i].circle) ++k;
      std::array<Row, 2> mean{};
      Point2 middle(0, 0);
      const auto rows_of = [&](const AxisPlace& place) {
        const double x = glm::dot(place.out, frame[0]), y = glm::dot(place.out, frame[1]);
        return std::array{Row{-x, -y, -place.along * x, -place.along * y}, Row{0, 0, place.radius * x, place.radius * y}};
      };
      const auto n = static_cast<double>(k - i);
      for (std::size_t c = i; c < k; ++c) {
        const AxisPlace place = axis_place(axis, object_.scene.vertices[corners[c].vertex]);
        const auto rows = rows_of(place);
        middle += Point2(place.radius, place.along) / n;
        for (std::size_t j = 0; j < 4; ++j) mean[0][j] += rows[0][j] / n, mean[1][j] += rows[1][j] / n;
      }
      for (std::size_t c = i; c < k; ++c) {
        const AxisPlace place = axis_place(axis, object_.scene.vertices[corners[c].vertex]);
        auto rows = rows_of(place);
        for (std::size_t j = 0; j < 4; ++j) rows[0][j] -= mean[0][j], rows[1][j] -= mean[1][j];
        add(rows[0], place.radius - middle.x);
        add(rows[1], place.along - middle.y);
      }
    }
    if (!solve_symmetric(normal, by)) return;
    axis.at += by[0] * frame[0] + by[1] * frame[1];
    axis.axis = glm::normalize(axis.axis + by[2] * frame[0] + by[3] * frame[1]);
  }

  const FacetObject& object_;
  const FacetGraph& graph_;
  const FacetPatches& surfaces_;
  SweptPatches& swept_;
  double tolerance_;
  std::size_t found_;                                   ///< number of patches that were found before
  std::vector<std::uint8_t> is_done_;                   ///< per patch: its axis was tried
  std::vector<std::size_t> counts_;                     ///< per patch: its facets
  std::vector<std::uint32_t> first_;                    ///< per patch: the first of these
  std::vector<std::uint8_t> beside_freeform_;           ///< per patch
  std::vector<std::vector<std::uint32_t>> neighbours_;  ///< per patch: those beside it, ascending
  std::vector<std::uint8_t> is_arc_, is_cylinder_;      ///< per patch: its profile is an arc; it is a cylinder
  std::vector<std::uint8_t> is_listed_;                 ///< per patch: in the list of bands_about()
  std::vector<std::uint32_t> stamp_;                    ///< per facet: the value of round_ when a walk visited it last
  std::uint32_t round_ = 0;
  std::vector<Point2> places_;  ///< of ends_of()
};

}  // namespace

void find_revolved(const FacetObject& object, const FacetPatches& surfaces, SweptPatches& swept) {
  RevolvedFinder(object, surfaces, swept).run();
}

}  // namespace ligne
