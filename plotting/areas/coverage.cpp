#include "areas/coverage.hpp"

#include <algorithm>

namespace ligne::svg {

/// Adds an area if it lies beside the stroke. Returns its number, or kNone. The area has no effect before refresh().
std::size_t Coverage::add(const StepSegment& stroke, const Area& area, std::size_t clip, std::uint32_t place) {
  const std::size_t before = changes_.size(), number = beside_.size();
  const Windings at_begin = area.wind_along(stroke, static_cast<std::uint32_t>(number), changes_);
  if (changes_.size() == before && at_begin.plus == 0 && at_begin.minus == 0) return kNone;
  beside_.push_back({&area, clip, place, kNone, at_begin, {}});
  return number;
}

/// Adds a clip path and the clip paths around it, with their areas beside the stroke. Returns the number of the chain.
std::size_t Coverage::add_chain(const StepSegment& stroke, const Clip* clip, std::size_t owner) {
  const std::size_t number = chains_.size();
  chains_.push_back({owner, {}});
  for (const Clip* one = clip; one; one = one->outer.get()) {
    const std::size_t place = clips_.size();
    clips_.push_back({one, number, {}});
    for (std::size_t& count : chains_[number].not_showing) ++count;
    for (std::uint32_t i = 0; i < one->any_of.size(); ++i) {
      const std::size_t beside = add(stroke, one->any_of[i], place, i);
      if (beside == kNone) continue;
      if (i < one->within.size()) {
        const std::size_t chain = add_chain(stroke, one->within[i].get(), beside);
        beside_[beside].chain = chain;
      }
      refresh(beside);
    }
  }
  return number;
}

/// Decides again whether an area counts on either side, after its windings or its clip paths have changed.
void Coverage::refresh(std::size_t number) {
  const Beside& beside = beside_[number];
  if (beside.clip == kNone) return;
  for (std::size_t side = 0; side < kSides; ++side) {
    const bool is_inside = beside.area->is_inside(side == kPlus ? beside.windings.plus : beside.windings.minus);
    set_counts(number, side, is_inside && (beside.chain == kNone || chains_[beside.chain].not_showing[side] == 0));
  }
}

/// Passes a change on to the clip path of the area, to its chain, and to the area that the chain cuts.
void Coverage::set_counts(std::size_t number, std::size_t side, bool counts) {
  Beside& beside = beside_[number];
  if (beside.counts[side] == counts) return;
  beside.counts[side] = counts;
  OneClip& one = clips_[beside.clip];
  Side& here = one.sides[side];
  bool shows = false;
  if (one.clip->opens.empty()) {
    counts ? ++here.inside : --here.inside;
    shows = here.inside > 0;
  } else {
    counts ? static_cast<void>(here.painted.insert(beside.place_in_clip))
           : static_cast<void>(here.painted.erase(beside.place_in_clip));
    shows = !here.painted.empty() && one.clip->opens[*here.painted.rbegin()] != 0;
  }
  if (here.shows == shows) return;
  here.shows = shows;
  Chain& chain = chains_[one.chain];
  shows ? --chain.not_showing[side] : ++chain.not_showing[side];
  if (chain.owner != kNone && beside_[chain.owner].chain == one.chain) refresh(chain.owner);
}

CoveredPart Coverage::state() const {
  CoveredPart state{kEnd, true, true, false};
  if (area_) {
    // The area comes first, if it lies beside the stroke at all.
    const bool is_beside = !beside_.empty() && beside_[0].clip == kNone;
    state.plus = is_beside && area_->is_inside(beside_[0].windings.plus);
    state.minus = is_beside && area_->is_inside(beside_[0].windings.minus);
    state.on_rim = state.plus != state.minus;
  }
  if (chains_.empty()) return state;
  state.plus = state.plus && chains_[0].not_showing[kPlus] == 0;
  state.minus = state.minus && chains_[0].not_showing[kMinus] == 0;
  return state;
}

void Coverage::end_part(const Along& at, const CoveredPart& next) {
  const CoveredPart& last = parts_.back();
  if (last.plus == next.plus && last.minus == next.minus && last.on_rim == next.on_rim) return;
  parts_.back().end = at;
  parts_.push_back(next);
}

const std::vector<CoveredPart>& Coverage::find(const StepSegment& stroke, const Area* area, const Clip* clip) {
  area_ = area;
  beside_.clear();
  clips_.clear();
  chains_.clear();
  changes_.clear();
  parts_.clear();
  if (area) add(stroke, *area, kNone, 0);
  const bool nothing = area && beside_.empty();
  if (!nothing) add_chain(stroke, clip, kNone);
  parts_.push_back(state());
  std::ranges::sort(changes_, [](const WindingChange& p, const WindingChange& q) { return compare(p.at, q.at) < 0; });
  for (std::size_t k = 0; k < changes_.size();) {
    const Along at = changes_[k].at;
    do {
      Windings& windings = beside_[changes_[k].area].windings;
      windings.plus += changes_[k].by.plus;
      windings.minus += changes_[k].by.minus;
      refresh(changes_[k].area);
    } while (++k < changes_.size() && compare(changes_[k].at, at) == 0);
    end_part(at, state());
  }
  return parts_;
}

}  // namespace ligne::svg
