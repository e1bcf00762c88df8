#include "scene/patches/swept/profile_pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "base/no_index.hpp"
#include "scene/patches/borders/patch_edges.hpp"
#include "scene/patches/freeform.hpp"

namespace ligne {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
/// Least ratio of the bend at a corner to the bends next to it. Coarse meshes of curves bend unevenly. Adjustable.
constexpr double kCornerBends = 2.5;
/// Largest ratio between bends, and between lengths, of sides that go on evenly. Adjustable, as kEvenBends is.
constexpr double kEvenRatio = 1.4;
/// Largest relative change of curvature where an arc continues, if too few sides follow to show how it goes on.
constexpr double kLikeEnd = 0.3;
/// Least further change of curvature beyond the end of an arc that shows a curve, relative to the change there. Adjustable.
constexpr double kFurtherPart = 0.4;
/// Largest bend, in radians, at which planes beside each other may be a nearly straight part of a curve.
constexpr double kFlatPlanes = kDegree;
/// A plane that bends by no more ends a curve if it is this many times as long as the side beside it, since several strips
/// may be one facet there. Other planes: kPlaneDepths.
constexpr double kFlatDepths = 6;
/// Most sides of an arc that may lie on a curve by accident where it is even at its ends.
constexpr std::size_t kMostArcSides = 4;
/// Least number of sides of a piece, and least sum of its bends, in radians. Three sides lie on a torus or a cylinder.
constexpr std::size_t kFewestSides = 4;
/// Least number of curved sides of a piece.
constexpr std::ptrdiff_t kFewestCurved = 3;
constexpr double kLeastTurn = 8 * kDegree;

/// Sides from one end to another.
struct Chain {
  std::vector<std::uint32_t> points, sides;
  bool is_closed = false;
};

class PieceFinder {
 public:
  PieceFinder(std::span<const Point2> points, std::span<const ProfileSide> sides, const ProfileOwners& owners)
      : points_(points), sides_(sides), owners_(owners), at_(points.size(), {kNone, kNone}), degree_(points.size(), 0) {}

  std::vector<ProfilePiece> find() {
    for (std::uint32_t s = 0; s < sides_.size(); ++s) {
      for (const std::uint32_t p : {sides_[s].from, sides_[s].to}) {
        if (degree_[p] < 2) at_[p][degree_[p]] = s;
        ++degree_[p];
      }
    }
    is_done_.assign(sides_.size(), 0);
    for (std::uint32_t s = 0; s < sides_.size(); ++s) {
      for (const std::uint32_t p : {sides_[s].from, sides_[s].to}) {
        if (degree_[p] != 2 && !is_done_[s]) divide(chain_from(p, s));
      }
    }
    for (std::uint32_t s = 0; s < sides_.size(); ++s) {
      if (!is_done_[s]) divide(chain_from(sides_[s].from, s));
    }
    return std::move(found_);
  }

 private:
  Chain chain_from(std::uint32_t point, std::uint32_t side) {
    Chain chain;
    chain.points.push_back(point);
    while (!is_done_[side]) {
      is_done_[side] = 1;
      chain.sides.push_back(side);
      point = sides_[side].from == point ? sides_[side].to : sides_[side].from;
      if (point == chain.points.front()) {
        chain.is_closed = degree_[point] == 2;
        if (chain.is_closed) return chain;
      }
      chain.points.push_back(point);
      if (degree_[point] != 2) break;
      side = at_[point][0] == side ? at_[point][1] : at_[point][0];
    }
    return chain;
  }

  double length(std::uint32_t side) const { return glm::distance(points_[sides_[side].from], points_[sides_[side].to]); }

  /// Sets bends_: per point of a chain, 0 at its ends.
  void measure(const Chain& chain) {
    const std::size_t n = chain.points.size();
    bends_.assign(n, 0);
    for (std::size_t i = 0; i < n; ++i) {
      if (!chain.is_closed && (i == 0 || i + 1 == n)) continue;
      const Point2 &before = points_[chain.points[(i + n - 1) % n]], &here = points_[chain.points[i]],
                   &after = points_[chain.points[(i + 1) % n]];
      bends_[i] = std::atan2(cross(here - before, after - here), glm::dot(here - before, after - here));
    }
    counts_.clear();
    bent_.clear();
    lengths_.clear();
    for (const std::uint32_t side : chain.sides) ++counts_[sides_[side].owner];
    for (std::size_t i = chain.is_closed ? 0 : 1; i < chain.sides.size(); ++i) {
      const std::uint32_t before = chain.sides[(i + chain.sides.size() - 1) % chain.sides.size()], after = chain.sides[i];
      const double off = std::abs(bends_[i]) * std::min(length(before), length(after)) / 2;
      if (sides_[before].owner == sides_[after].owner && off > owners_.tolerance) bent_.insert(sides_[after].owner);
    }
    for (const std::uint32_t side : chain.sides) {
      double& total = lengths_[sides_[side].owner];
      total = bent_.contains(sides_[side].owner) ? std::max(total, length(side)) : total + length(side);
    }
  }

  /// Whether the profile has a corner at a point of a chain: the bend beside it, to the same side, is much smaller.
  bool is_corner(const Chain& chain, std::size_t i) const {
    const std::size_t n = chain.points.size();
    const double here = std::abs(bends_[i]);
    if (here < kSurfaceCreaseDegrees * kDegree) return false;
    const auto goes_on = [&](std::size_t k) { return bends_[k] * bends_[i] * kCornerBends >= here * here; };
    return !(goes_on((i + n - 1) % n) || goes_on((i + 1) % n));
  }

  static bool alike(double a, double b) { return a * kEvenRatio >= b && b * kEvenRatio >= a; }

  /// Whether the sides before and behind a point of a chain bend on evenly.
  bool is_even(const Chain& chain, std::size_t i) const {
    const std::size_t n = chain.points.size(), m = chain.sides.size();
    if (!alike(length(chain.sides[(i + m - 1) % m]), length(chain.sides[i % m]))) return false;
    for (const std::size_t k : {(i + n - 1) % n, (i + 1) % n}) {
      if (!chain.is_closed && (k == 0 || k + 1 == n)) continue;
      if (bends_[k] * bends_[i] < 0 || !alike(std::abs(bends_[k]), std::abs(bends_[i]))) return false;
    }
    return true;
  }

  /// Curvature at a point of a chain; nothing at its ends and beyond.
  std::optional<double> curvature(const Chain& chain, std::ptrdiff_t i) const {
    const auto n = static_cast<std::ptrdiff_t>(chain.points.size());
    if (!chain.is_closed && (i <= 0 || i + 1 >= n)) return std::nullopt;
    const auto k = static_cast<std::size_t>((i + n) % n), m = chain.sides.size();
    return 2 * bends_[k] / (length(chain.sides[(k + m - 1) % m]) + length(chain.sides[k]));
  }

  /// Whether the curve continues beyond the end of an arc at a point, in the direction +1 or -1: the curvature stays the
  /// same, or keeps changing beyond the sides at the point. Between two arcs it jumps once.
  bool goes_on(const Chain& chain, std::size_t point, int direction) const {
    const auto i = static_cast<std::ptrdiff_t>(point);
    const auto before = curvature(chain, i - direction), here = curvature(chain, i),
               behind = curvature(chain, i + direction), far = curvature(chain, i + 3 * direction);
    if (!before || !here) return false;
    const double jump = behind ? *behind - *before : *here - *before;
    if (std::abs(jump) <= (far ? kLikeCurvature : kLikeEnd) * std::abs(*before)) return true;
    return far && behind && (*far - *behind) * jump >= kFurtherPart * jump * jump;
  }

  /// Whether the owners of the sides before and after a point show that two surfaces meet there.
  bool separates_owners(const Chain& chain, std::size_t i) const {
    const std::size_t m = chain.sides.size();
    const std::array<std::uint32_t, 2> sides{chain.sides[(i + m - 1) % m], chain.sides[i % m]};
    const std::array<std::uint32_t, 2> owners{sides_[sides[0]].owner, sides_[sides[1]].owner};
    const std::array<bool, 2> are_planes{sides_[sides[0]].is_plane, sides_[sides[1]].is_plane};
    const bool is_flat = std::abs(bends_[i]) <= kFlatPlanes;
    if (are_planes[0] && are_planes[1] && !is_flat) return true;
    const double depths = is_flat ? kFlatDepths : kPlaneDepths;
    for (const std::size_t k : {0, 1}) {
      if (are_planes[k] && length(sides[k]) >= depths * length(sides[1 - k])) return true;
    }
    if (owners[0] == owners[1]) return false;
    for (const std::size_t k : {0, 1}) {
      if (owners[k] == kNone) continue;
      if (owners_.is_arc[owners[k]]) {
        if (counts_.at(owners[k]) == 1 && !is_cylinder(owners[1 - k])) continue;
        const bool is_short = counts_.at(owners[k]) <= kMostArcSides;
        if (!(is_short && is_even(chain, i)) && !goes_on(chain, i, k == 0 ? 1 : -1)) return true;
      } else if (length_of(owners[k]) >= kPlaneDepths * length(sides[1 - k])) {
        return true;
      }
    }
    return false;
  }

  /// Whether a patch is a cylinder about the axis. Every row of a profile lies on a cone and near spheres about the axis,
  /// but few on cylinders: where one ends beside a row of a sphere, this is where a curve begins.
  bool is_cylinder(std::uint32_t owner) const {
    return owner != kNone && !owners_.is_cylinder.empty() && owners_.is_cylinder[owner];
  }

  /// Length of the sides of a straight patch if they lie on one line, otherwise of the longest.
  double length_of(std::uint32_t owner) const { return lengths_.at(owner); }

  /// Whether a patch is a surface of its own by its sides: more than two on one line. The curvature of a curve vanishes at
  /// an inflection, so two lie on a line by symmetry.
  bool is_firm(std::uint32_t owner) const {
    return owner != kNone && !owners_.is_arc[owner] && counts_.at(owner) > 2 && !bent_.contains(owner);
  }

  void divide(const Chain& chain) {
    if (chain.sides.size() < kFewestSides) return;
    measure(chain);
    const std::size_t m = chain.sides.size();
    // Cuts between side i - 1 and side i.
    std::vector<std::uint8_t> is_cut(m, 0);
    std::size_t first = m;
    for (std::size_t i = chain.is_closed ? 0 : 1; i < m; ++i) {
      const std::uint32_t before = sides_[chain.sides[(i + m - 1) % m]].owner, after = sides_[chain.sides[i]].owner;
      const bool parts_firm = before != after && (is_firm(before) || is_firm(after));
      is_cut[i] = parts_firm || is_corner(chain, i) || separates_owners(chain, i);
      if (is_cut[i] && first == m) first = i;
    }
    if (first == m || !chain.is_closed) first = 0;
    const std::size_t n = chain.points.size();
    ProfilePiece piece;
    for (std::size_t k = 0; k < m; ++k) {
      const std::size_t i = (first + k) % m;
      if (k > 0 && is_cut[i]) finish(piece);
      if (piece.sides.empty()) piece.points.push_back(chain.points[i]);
      piece.sides.push_back(chain.sides[i]);
      piece.points.push_back(chain.points[(i + 1) % n]);
    }
    piece.is_closed = chain.is_closed && piece.sides.size() == m && !is_cut[first];
    if (piece.is_closed) piece.points.pop_back();
    finish(piece);
  }

  /// Angle by which the profile turns at a point between two others.
  double bend(const std::vector<std::uint32_t>& points, std::size_t i) const {
    const Point2 before = points_[points[i]] - points_[points[i - 1]], after = points_[points[i + 1]] - points_[points[i]];
    return std::atan2(cross(before, after), glm::dot(before, after));
  }

  /// Removes planes from the ends of a piece, unless they hardly bend there.
  void drop_end_planes(ProfilePiece& piece) const {
    const auto bends = [&](std::size_t i) {
      return piece.sides.size() == 1 || std::abs(bend(piece.points, i)) > kFlatPlanes;
    };
    while (!piece.sides.empty() && sides_[piece.sides.back()].is_plane && bends(piece.points.size() - 2)) {
      piece.sides.pop_back();
      piece.points.pop_back();
    }
    while (!piece.sides.empty() && sides_[piece.sides.front()].is_plane && bends(1)) {
      piece.sides.erase(piece.sides.begin());
      piece.points.erase(piece.points.begin());
    }
  }

  void finish(ProfilePiece& piece) {
    ProfilePiece done = std::exchange(piece, {});
    if (!done.is_closed) drop_end_planes(done);
    if (done.sides.size() < kFewestSides) return;
    const std::uint32_t owner = sides_[done.sides[0]].owner;
    const auto is_whole = [&](std::uint32_t side) { return sides_[side].owner == owner; };
    if (owner != kNone && std::ranges::all_of(done.sides, is_whole)) return;
    const auto is_curved = [&](std::uint32_t side) { return !sides_[side].is_plane; };
    if (std::ranges::count_if(done.sides, is_curved) < kFewestCurved) return;
    double turn = 0;
    for (std::size_t i = 1; i + 1 < done.points.size(); ++i) turn += std::abs(bend(done.points, i));
    if (turn >= kLeastTurn) found_.push_back(std::move(done));
  }

  std::span<const Point2> points_;
  std::span<const ProfileSide> sides_;
  const ProfileOwners& owners_;
  std::vector<std::array<std::uint32_t, 2>> at_;  ///< per point: its first two sides
  std::vector<std::uint32_t> degree_;             ///< per point: the number of its sides
  std::vector<std::uint8_t> is_done_;             ///< per side
  std::vector<double> bends_;
  std::unordered_map<std::uint32_t, std::size_t> counts_;  ///< by owner: its sides in the chain
  std::unordered_map<std::uint32_t, double> lengths_;      ///< by owner: length_of()
  std::unordered_set<std::uint32_t> bent_;                 ///< by owner, if its sides in the chain bend
  std::vector<ProfilePiece> found_;
};

}  // namespace

std::vector<ProfilePiece> smooth_pieces(std::span<const Point2> points, std::span<const ProfileSide> sides,
                                        const ProfileOwners& owners) {
  return PieceFinder(points, sides, owners).find();
}

}  // namespace ligne
