#include "visibility/common/occluder_cache.hpp"

#include <algorithm>
#include <cmath>

namespace ligne {

/// Moves the facet to the front of the list, and the others one place back; a full list drops its last one.
void OccluderCache::Known::remember(std::uint32_t facet) {
  const auto end = facets.begin() + static_cast<std::ptrdiff_t>(count);
  auto place = std::find(facets.begin(), end, facet);
  if (place == end) {
    if (count < kKnown) {
      ++count;
    } else {
      --place;
    }
  }
  std::copy_backward(facets.begin(), place, place + 1);
  facets.front() = facet;
}

/// A line and the same line backwards have one direction.
std::size_t OccluderCache::direction_of(const PageLine& line) {
  const bool flat = std::abs(line.dx) >= std::abs(line.dy);
  const double slope = flat ? line.dy / line.dx : line.dx / line.dy;  // from -1 to 1
  const auto part = static_cast<std::size_t>(std::clamp(static_cast<int>((slope + 1) * kSlopes), 0, 2 * kSlopes - 1));
  return flat ? part : part + 2 * kSlopes;
}

/// Removes the part that the facet hides from the open parts of the line; returns whether it hides any.
bool OccluderCache::take(const PageLine& line, std::uint32_t facet) {
  const Facet& f = facets_[facet];
  if (f.face == line.face0 || f.face == line.face1) return false;
  if (!scene_.face_is_transparent.empty() && scene_.face_is_transparent[f.face]) return false;
  bool near_side = false;
  const HiddenInterval hidden =
      hidden_interval(line, f, scene_.vertices.data(), {open_.from(), open_.to()}, /*coincidence_steps=*/0, near_side);
  open_.take(hidden);
  return hidden.sides != HiddenSides::none;
}

bool OccluderCache::is_hidden(const PageLine& line) {
  if (open_.empty()) return true;
  const double length = std::sqrt(line.dx * line.dx + line.dy * line.dy);
  if ((open_.to() - open_.from()) * length > least_) return false;
  parts_.assign(1, {open_.from(), open_.to()});
  drop_short_parts(parts_, length, least_);
  return parts_.empty();
}

bool OccluderCache::hide(const PageLine& line, std::span<const CellFacet> list, const CellSquare& square) {
  if (line.p0 == line.p1) return false;
  patience_ += kFailedTestsPerLine;
  open_.reset(0, 1);
  Known& known = known_[direction_of(line)];
  for (std::size_t i = 0; i < known.count; ++i) {
    const std::uint32_t facet = known.facets[i];
    if (!take(line, facet) || !is_hidden(line)) continue;
    known.remember(facet);
    return true;
  }
  if (in_vain_ > patience_) return false;
  found_.clear();
  const double z_far = std::max(line.z0, line.z1);
  const CellBox box = square.box(std::min(line.p0.x, line.p1.x), std::max(line.p0.x, line.p1.x),
                                 std::min(line.p0.y, line.p1.y), std::max(line.p0.y, line.p1.y));
  auto entry = list.begin();
  for (; entry != list.end() && entry->z_near <= z_far; ++entry) {
    if (!entry->box.meets(box) || !take(line, entry->facet)) continue;
    found_.push_back(entry->facet);
    if (!is_hidden(line)) continue;
    for (const std::uint32_t facet : found_) known.remember(facet);
    return true;
  }
  in_vain_ += static_cast<std::size_t>(entry - list.begin());
  return false;
}

}  // namespace ligne
