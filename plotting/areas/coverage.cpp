#include "areas/coverage.hpp"

#include <algorithm>
#include <iterator>

namespace ligne::svg {

void Coverage::add(const StepSegment& stroke, const Area& area, std::size_t clip, std::uint32_t place) {
  const std::size_t before = changes_.size();
  const Windings at_begin = area.wind_along(stroke, static_cast<std::uint32_t>(beside_.size()), changes_);
  if (changes_.size() == before && at_begin.plus == 0 && at_begin.minus == 0) return;
  beside_.push_back({&area, clip, place, {}});
  update(beside_.back(), at_begin, true);
}

void Coverage::update_side(const Clip& clip, Side& side, std::uint32_t place, bool was_inside, bool is_inside) {
  if (was_inside == is_inside) return;
  if (clip.opens.empty()) {
    is_inside ? ++side.inside : --side.inside;
  } else if (is_inside) {
    side.painted.insert(place);
  } else {
    side.painted.erase(place);
  }
}

void Coverage::update(Beside& beside, Windings by, bool is_first) {
  const Windings before = beside.windings;
  beside.windings.plus += by.plus;
  beside.windings.minus += by.minus;
  if (beside.clip == kNoClip) return;
  OneClip& one = clips_[beside.clip];
  const Area& area = *beside.area;
  update_side(*one.clip, one.plus, beside.place_in_clip, !is_first && area.is_inside(before.plus),
              area.is_inside(beside.windings.plus));
  update_side(*one.clip, one.minus, beside.place_in_clip, !is_first && area.is_inside(before.minus),
              area.is_inside(beside.windings.minus));
}

bool Coverage::shows(const Clip& clip, const Side& side) {
  if (clip.opens.empty()) return side.inside > 0;
  return !side.painted.empty() && clip.opens[*side.painted.rbegin()] != 0;
}

CoveredPart Coverage::state() const {
  CoveredPart state{kEnd, true, true, false};
  if (area_) {
    // The area comes first, if it lies beside the stroke at all.
    const bool is_beside = !beside_.empty() && beside_[0].clip == kNoClip;
    state.plus = is_beside && area_->is_inside(beside_[0].windings.plus);
    state.minus = is_beside && area_->is_inside(beside_[0].windings.minus);
    state.on_rim = state.plus != state.minus;
  }
  for (const OneClip& one : clips_) {
    state.plus = state.plus && shows(*one.clip, one.plus);
    state.minus = state.minus && shows(*one.clip, one.minus);
  }
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
  changes_.clear();
  parts_.clear();
  if (area) add(stroke, *area, kNoClip, 0);
  const bool nothing = area && beside_.empty();
  for (const Clip* one = nothing ? nullptr : clip; one; one = one->outer.get()) {
    clips_.push_back({one});
    for (std::uint32_t i = 0; i < one->any_of.size(); ++i) add(stroke, one->any_of[i], clips_.size() - 1, i);
  }
  parts_.push_back(state());
  std::sort(changes_.begin(), changes_.end(),
            [](const WindingChange& p, const WindingChange& q) { return compare(p.at, q.at) < 0; });
  for (std::size_t k = 0; k < changes_.size();) {
    const Along at = changes_[k].at;
    do {
      update(beside_[changes_[k].area], changes_[k].by, false);
    } while (++k < changes_.size() && compare(changes_[k].at, at) == 0);
    end_part(at, state());
  }
  return parts_;
}

}  // namespace ligne::svg
