#include "visibility/common/cell_cover.hpp"

#include <bit>
#include <utility>

namespace ligne {
namespace {

/// Facets of the largest patch whose planes are kept; of a larger one only the farthest depth is known. Adjustable.
constexpr std::size_t kMostPlanes = 8;
/// Distance from a side within which a sample point is covered, as a fraction of the cell: more than rounding, which is
/// 2^-27 lattice steps.
constexpr double kSampleRounding = 0x1p-20;

struct ClippedFacet {
  std::array<Point2, 7> corners;
  std::size_t count = 0;
};

/// Clips the facet to the square of half side `reach` round (x, y).
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

void CellCover::begin_cell(const CellSquare& square) {
  square_ = square;
  members_.clear();
  uses_.clear();
  sample_depths_.fill(kNotCovered);
}

/// Takes a sample point on a side, within rounding, as covered: that no member covers a point must be certain.
void CellCover::cover_samples(const Member& member) {
  const FacetFunctions& g = member.functions;
  const double half = square_.size / 2, x = square_.x + half, y = square_.y + half, reach = half + margin_;
  std::array<double, kSamples> inside{};
  for (int i = 0; i < 3; ++i) {
    const double dx = g.ex[i] * reach, dy = g.ey[i] * reach;
    const double centre = g.ex[i] * x + g.ey[i] * y + g.e[i] + kSampleRounding * (std::abs(dx) + std::abs(dy));
    const std::array<double, kSamples> values{centre, centre + dx + dy, centre + dx - dy, centre - dx + dy,
                                              centre - dx - dy};
    for (std::size_t k = 0; k < kSamples; ++k) inside[k] = std::min(inside[k], values[k]);
  }
  for (std::size_t k = 0; k < kSamples; ++k) {
    if (inside[k] >= 0) sample_depths_[k] = std::min(sample_depths_[k], member.z_far);
  }
}

void CellCover::add(const Facet& f) {
  Member member{FacetFunctions(f, scene_.vertices.data())};
  const FacetFunctions& g = member.functions;
  double z_near = 0;
  const Meeting meeting = meet(g, f, square_, margin_, z_near, member.z_far);
  if (meeting == Meeting::apart) return;
  member.z_far += f.depth_tolerance;
  cover_samples(member);
  const double half = square_.size / 2, x = square_.x + half, y = square_.y + half, reach = half + margin_;
  const auto index = static_cast<std::uint32_t>(members_.size());
  const std::size_t before = uses_.size();
  for (int i = 0; i < 3; ++i) {
    const double centre = g.ex[i] * x + g.ey[i] * y + g.e[i];
    if (centre - (std::abs(g.ex[i]) + std::abs(g.ey[i])) * reach > 0) continue;  // the whole cell lies inside this side
    const std::uint32_t a = scene_.place(f.v[i]), b = scene_.place(f.v[(i + 1) % 3]);
    const LatticePoint from = scene_.vertices[a].p, to = scene_.vertices[b].p;
    if (std::min(from.x, to.x) > x + reach || std::max(from.x, to.x) < x - reach) continue;
    if (std::min(from.y, to.y) > y + reach || std::max(from.y, to.y) < y - reach) continue;
    uses_.push_back({std::uint64_t{std::min(a, b)} << 32 | std::max(a, b), a > b, index});
  }
  if (uses_.size() > before || meeting == Meeting::covers) members_.push_back(member);
}

void CellCover::number_sides() {
  const std::size_t mask = std::bit_ceil(2 * uses_.size() + 1) - 1;
  if (slots_.size() <= mask) slots_.assign(mask + 1, {}), filled_ = 0;
  if (++filled_ == 0) slots_.assign(slots_.size(), {}), filled_ = 1;
  first_use_.clear();
  for (auto& counts : alive_) counts.clear();
  member_sides_.assign(members_.size() * 3, kNone);
  for (std::uint32_t i = 0; i < uses_.size(); ++i) {
    SideUse& use = uses_[i];
    // Finalizer of SplitMix64 (Steele, Lea, Flood 2014), but for its first step.
    const std::uint64_t h = (use.side ^ use.side >> 27) * 0x94d049bb133111ebu;
    std::size_t at = (h ^ h >> 31) & mask;
    while (slots_[at].filled == filled_ && slots_[at].side != use.side) at = (at + 1) & mask;
    Slot& slot = slots_[at];
    if (slot.filled != filled_) {
      slot = {use.side, static_cast<std::uint32_t>(first_use_.size()), filled_};
      first_use_.push_back(kNone);
      for (auto& counts : alive_) counts.push_back(0);
    }
    use.next = std::exchange(first_use_[slot.number], i);
    ++alive_[use.reversed][slot.number];
    std::uint32_t* side = &member_sides_[use.member * 3];
    while (*side != kNone) ++side;
    *side = slot.number << 1 | use.reversed;
  }
}

void CellCover::remove(std::uint32_t member, std::uint32_t round) {
  const auto take = [&](std::uint32_t m) {
    if (members_[m].round != kNotRemoved) return;
    members_[m].round = round;
    removed_.push_back(m);
  };
  take(member);
  while (!removed_.empty()) {
    const std::uint32_t* sides = &member_sides_[removed_.back() * 3];
    removed_.pop_back();
    for (int k = 0; k < 3 && sides[k] != kNone; ++k) {
      const std::uint32_t side = sides[k] >> 1;
      if (--alive_[sides[k] & 1][side] > 0) continue;
      for (std::uint32_t i = first_use_[side]; i != kNone; i = uses_[i].next) take(uses_[i].member);
    }
  }
}

void CellCover::remove_ends() {
  for (std::uint32_t side = 0; side < first_use_.size(); ++side) {
    if (alive_[0][side] > 0 && alive_[1][side] > 0) continue;
    for (std::uint32_t i = first_use_[side]; i != kNone; i = uses_[i].next) remove(uses_[i].member, 0);
  }
}

/// Where several surfaces meet in a side, a patch may continue on any one of them. So the loop removes the farthest
/// member, with all members that this leaves without a neighbour, until none remains. The members removed last hide
/// most.
std::optional<float> CellCover::choose_patch() {
  planes_.clear();
  if (members_.empty()) return std::nullopt;
  for (Member& member : members_) member.round = kNotRemoved;
  number_sides();
  remove_ends();
  by_depth_.clear();
  for (std::uint32_t i = 0; i < members_.size(); ++i) {
    if (members_[i].round == kNotRemoved) by_depth_.push_back(i);
  }
  if (by_depth_.empty()) return std::nullopt;
  std::sort(by_depth_.begin(), by_depth_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return members_[a].z_far != members_[b].z_far ? members_[a].z_far > members_[b].z_far : a < b;
  });
  std::uint32_t round = 0;
  double z_far = 0;
  for (const std::uint32_t farthest : by_depth_) {
    if (members_[farthest].round != kNotRemoved) continue;
    z_far = members_[farthest].z_far;
    remove(farthest, ++round);
  }
  for (std::uint32_t i = 0; i < members_.size() && planes_.size() <= kMostPlanes; ++i) {
    if (members_[i].round == round) planes_.push_back(members_[i].functions);
  }
  if (planes_.size() > kMostPlanes) planes_.clear();
  return round_up(z_far);
}

/// The patch is nowhere deeper than the farthest of its planes, which is a convex function; the facet's depth is a
/// linear one. So the test at the corners of the clipped facet holds between them.
bool CellCover::hides(const Facet& f) const {
  if (planes_.empty()) return false;
  const double half = square_.size / 2, x = square_.x + half, y = square_.y + half;
  const ClippedFacet part = clip_to_square(f, scene_.vertices.data(), x, y, half + margin_);
  if (part.count == 0) return false;
  const FacetFunctions g(f, scene_.vertices.data());
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
