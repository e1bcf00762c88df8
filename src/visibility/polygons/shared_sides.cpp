#include "visibility/polygons/shared_sides.hpp"

#include <cstddef>

#include "base/hash.hpp"
#include "base/no_index.hpp"

namespace ligne {
namespace {

std::size_t hash_of(const LatticeSegment& s) {
  std::uint64_t h = 0;
  for (const std::int32_t v : {s.a.x, s.a.y, s.b.x, s.b.y}) h = extend_hash(h, static_cast<std::uint32_t>(v));
  return h;
}

}  // namespace

void SharedSides::clear() {
  sides_.clear();
  partner_.clear();
  ++round_;
}

void SharedSides::add(const ClipPart& clip, bool transparent) {
  const auto first = static_cast<std::uint32_t>(partner_.size());
  partner_.resize(partner_.size() + kMostSides, kNone);
  for (std::uint32_t k = 0; k < clip.count; ++k) {
    const ContourEdge& e = clip.edges[k];
    if (e.source == kCutSource || e.from.num != 0 || e.to.num != e.to.den) continue;
    sides_.push_back({e.segment, transparent, e.reversed, first + k});
    if (2 * sides_.size() > slots_.size()) {
      grow();
    } else {
      insert(static_cast<std::uint32_t>(sides_.size() - 1));
    }
  }
}

void SharedSides::grow() {
  slots_.assign(slots_.empty() ? 64 : 2 * slots_.size(), {});
  round_ = 1;
  for (std::uint32_t i = 0; i < sides_.size(); ++i) insert(i);
}

void SharedSides::insert(std::uint32_t side) {
  const Side& s = sides_[side];
  std::uint32_t& partner = partner_[s.number];
  const std::size_t mask = slots_.size() - 1;
  std::size_t i = hash_of(s.segment) & mask;
  for (; slots_[i].round == round_; i = (i + 1) & mask) {
    const Side& other = sides_[slots_[i].side];
    if (partner == kNone && partner_[other.number] == kNone && other.reversed != s.reversed &&
        other.transparent == s.transparent && other.segment == s.segment) {
      partner = other.number / kMostSides;
      partner_[other.number] = s.number / kMostSides;
    }
  }
  slots_[i] = {round_, side};
}

}  // namespace ligne
