#include "areas/coverage.hpp"

#include <algorithm>
#include <iterator>

namespace ligne::svg {

bool Coverage::add(const StepSegment& stroke, const Area& area, std::size_t clip, std::uint32_t place) {
  const std::size_t before = changes_.size();
  const Windings at_begin = area.wind_along(stroke, static_cast<std::uint32_t>(beside_.size()), changes_);
  if (changes_.size() == before && at_begin.plus == 0 && at_begin.minus == 0) return false;
  beside_.push_back({&area, clip, place, {}});
  update(beside_.back(), at_begin, true);
  return true;
}

void Coverage::add_clips(const StepSegment& stroke, const Clip* clip, std::size_t depth) {
  for (const Clip* one = clip; one; one = one->outer.get()) {
    const std::size_t place = clips_.size();
    clips_.push_back({one, depth});
    for (std::uint32_t i = 0; i < one->any_of.size(); ++i) {
      if (!add(stroke, one->any_of[i], place, i) || one->within.empty()) continue;
      const std::size_t beside = beside_.size() - 1, first = clips_.size();
      add_clips(stroke, one->within[i].get(), depth + 1);
      clips_[place].cut.push_back({beside, first, clips_.size()});
    }
  }
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

bool Coverage::shows(std::size_t number, bool on_plus) const {
  const OneClip& one = clips_[number];
  const Clip& clip = *one.clip;
  const Side& side = on_plus ? one.plus : one.minus;
  if (!clip.opens.empty()) return !side.painted.empty() && clip.opens[*side.painted.rbegin()] != 0;
  if (clip.within.empty()) return side.inside > 0;
  return std::ranges::any_of(one.cut, [&](const CutArea& cut) {
    const Beside& beside = beside_[cut.beside];
    return beside.area->is_inside(on_plus ? beside.windings.plus : beside.windings.minus) &&
           all_show(cut.first, cut.end, one.depth + 1, on_plus);
  });
}

bool Coverage::all_show(std::size_t first, std::size_t end, std::size_t depth, bool on_plus) const {
  for (std::size_t i = first; i < end; ++i) {
    if (clips_[i].depth == depth && !shows(i, on_plus)) return false;
  }
  return true;
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
  state.plus = state.plus && all_show(0, clips_.size(), 0, true);
  state.minus = state.minus && all_show(0, clips_.size(), 0, false);
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
  if (!nothing) add_clips(stroke, clip, 0);
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
