#include "visibility/common/cell_cover.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

namespace ligne {
namespace {

/// Adjustable: of a patch of more facets only the farthest depth is known.
constexpr std::size_t kMostPlanes = 8;

struct ClippedFacet {
  std::array<Point2, 7> corners;
  std::size_t count = 0;
};

/// The part of the facet in the square of half side `reach` round (x, y).
ClippedFacet clip_to_square(const Facet& f, const ProjectedVertex* vertices, double x, double y, double reach) {
  ClippedFacet part;
  for (const std::uint32_t v : f.v) part.corners[part.count++] = {vertices[v].p.x - x, vertices[v].p.y - y};
  for (int side = 0; side < 4 && part.count > 0; ++side) {
    const auto inside = [&](const Point2& p) { return reach - (side % 2 ? -1 : 1) * (side < 2 ? p.x : p.y); };
    ClippedFacet kept;
    for (std::size_t i = 0; i < part.count; ++i) {
      const Point2 a = part.corners[i], b = part.corners[(i + 1) % part.count];
      const double da = inside(a), db = inside(b);
      if (da >= 0) kept.corners[kept.count++] = a;
      if ((da < 0) != (db < 0)) {
        const double t = da / (da - db);
        kept.corners[kept.count++] = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
      }
    }
    part = kept;
  }
  return part;
}

}  // namespace

void CellCover::add(const Facet& f) {
  Member member{FacetFunctions(f, vertices_), 0, true};
  const FacetFunctions& g = member.functions;
  double z_near = 0;
  const Meeting meeting = meet(g, f, square_, margin_, z_near, member.z_far);
  if (meeting == Meeting::apart) return;
  member.z_far += f.depth_tolerance;
  const double half = square_.size / 2, x = square_.x + half, y = square_.y + half, reach = half + margin_;
  const auto index = static_cast<std::uint32_t>(members_.size());
  const std::size_t before = uses_.size();
  for (int i = 0; i < 3; ++i) {
    const double centre = g.ex[i] * x + g.ey[i] * y + g.e[i];
    if (centre - (std::abs(g.ex[i]) + std::abs(g.ey[i])) * reach > 0) continue;  // the cell is on the facet's side of it
    const std::uint32_t a = f.v[i], b = f.v[(i + 1) % 3];
    const LatticePoint from = vertices_[a].p, to = vertices_[b].p;
    if (std::min(from.x, to.x) > x + reach || std::max(from.x, to.x) < x - reach) continue;
    if (std::min(from.y, to.y) > y + reach || std::max(from.y, to.y) < y - reach) continue;
    uses_.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), a > b, index});
  }
  if (uses_.size() > before || meeting == Meeting::covers) members_.push_back(member);
}

void CellCover::number_sides() {
  std::sort(uses_.begin(), uses_.end(), [](const SideUse& a, const SideUse& b) {
    return std::tie(a.side, a.reversed, a.member) < std::tie(b.side, b.reversed, b.member);
  });
  side_begin_.clear();
  for (auto& counts : alive_) counts.clear();
  member_sides_.assign(members_.size() * 3, kNone);
  for (std::uint32_t i = 0; i < uses_.size(); ++i) {
    if (i == 0 || uses_[i].side != uses_[i - 1].side) {
      side_begin_.push_back(i);
      for (auto& counts : alive_) counts.push_back(0);
    }
    const auto side = static_cast<std::uint32_t>(side_begin_.size() - 1);
    ++alive_[uses_[i].reversed][side];
    std::uint32_t* slot = &member_sides_[uses_[i].member * 3];
    while (*slot != kNone) ++slot;
    *slot = side << 1 | uses_[i].reversed;
  }
  side_begin_.push_back(static_cast<std::uint32_t>(uses_.size()));
}

/// Members that end at a side within the cell belong to no patch; nor do those that they leave alone, and so on.
void CellCover::remove_ends() {
  removed_.clear();
  const auto remove_unpaired = [&](std::uint32_t side) {
    if (alive_[0][side] > 0 && alive_[1][side] > 0) return;
    for (std::uint32_t i = side_begin_[side]; i < side_begin_[side + 1]; ++i) {
      Member& member = members_[uses_[i].member];
      if (member.alive) removed_.push_back(uses_[i].member);
      member.alive = false;
    }
  };
  for (std::uint32_t side = 0; side + 1 < side_begin_.size(); ++side) remove_unpaired(side);
  while (!removed_.empty()) {
    const std::uint32_t* sides = &member_sides_[removed_.back() * 3];
    removed_.pop_back();
    for (int k = 0; k < 3 && sides[k] != kNone; ++k) {
      if (--alive_[sides[k] & 1][sides[k] >> 1] == 0) remove_unpaired(sides[k] >> 1);
    }
  }
}

std::optional<float> CellCover::choose_patch() {
  planes_.clear();
  if (members_.empty()) return std::nullopt;
  number_sides();
  remove_ends();
  DisjointSets patches(members_.size());
  for (std::size_t side = 0; side + 1 < side_begin_.size(); ++side) {
    std::uint32_t first = kNone;
    for (std::uint32_t i = side_begin_[side]; i < side_begin_[side + 1]; ++i) {
      if (!members_[uses_[i].member].alive) continue;
      if (first == kNone) first = uses_[i].member;
      patches.join(first, uses_[i].member);
    }
  }
  // The lowest member of a patch collects its depth.
  std::uint32_t nearest = kNone;
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    if (!members_[i].alive) continue;
    Member& lowest = members_[patches.find(i)];
    lowest.z_far = std::max(lowest.z_far, members_[i].z_far);
  }
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    if (!members_[i].alive || patches.find(i) != i) continue;
    if (nearest == kNone || members_[i].z_far < members_[nearest].z_far) nearest = i;
  }
  if (nearest == kNone) return std::nullopt;
  for (std::uint32_t i = nearest; i < members_.size() && planes_.size() <= kMostPlanes; ++i) {
    if (members_[i].alive && patches.find(i) == nearest) planes_.push_back(members_[i].functions);
  }
  if (planes_.size() > kMostPlanes) planes_.clear();
  return round_up(members_[nearest].z_far);
}

/// The depth of the patch is nowhere beyond the farthest of its planes. That is a convex function and the depth of the facet
/// a linear one: what holds at the corners of the facet's part in the cell holds between them.
bool CellCover::hides(const Facet& f) const {
  if (planes_.empty()) return false;
  const double half = square_.size / 2, x = square_.x + half, y = square_.y + half;
  const ClippedFacet part = clip_to_square(f, vertices_, x, y, half + margin_);
  if (part.count == 0) return false;
  const FacetFunctions g(f, vertices_);
  for (std::size_t i = 0; i < part.count; ++i) {
    const double px = x + part.corners[i].x, py = y + part.corners[i].y;
    const double z = g.depth(px, py) - g.slack;
    for (const FacetFunctions& plane : planes_) {
      if (!(z > plane.depth(px, py) + plane.slack)) return false;
    }
  }
  return true;
}

}  // namespace ligne
