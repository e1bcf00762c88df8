#pragma once
/// The open parts of a line while facets take their intervals from it.

#include <cassert>
#include <span>
#include <vector>

#include "visibility/common/hidden_interval.hpp"

namespace ligne {

/// A part of a line, as parameters.
struct LinePart {
  double from = 0, to = 0;
  std::uint32_t level = 0;  ///< number of transparent faces in front of it
};

/// Whether every part has a length and begins where the one before it ends, or later.
bool are_ascending(std::span<const LinePart> parts);

/// Begins with one open part; intervals are taken from it in any order.
class OpenParts {
 public:
  void reset(double from, double to) {
    open_.assign(1, {from, to});
    one_sided_.clear();
  }

  /// The first and the last end of the open parts; facets outside them can be ignored. Not when empty().
  double from() const { return open_.front().from; }
  double to() const { return open_.back().to; }
  bool empty() const { return open_.empty(); }

  void take(const HiddenInterval& hidden) {
    if (hidden.sides == HiddenSides::both) {
      take(hidden.from, hidden.to);
    } else if (hidden.sides != HiddenSides::none) {
      one_sided_.push_back(hidden);
    }
  }

  /// Returns the open parts, in order. To be called after the last interval was taken.
  const std::vector<LinePart>& finish() {
    if (one_sided_.size() > 1) take_one_sided();
    assert(are_ascending(open_));
    return open_;
  }

 private:
  void take(double from, double to);
  void take_one_sided();

  std::vector<LinePart> open_, spare_;
  std::vector<HiddenInterval> one_sided_;  ///< intervals that cover one side
};

/// Appends a part, or extends the last part if that has the same level and ends where this one begins.
inline void append_part(std::vector<LinePart>& parts, const LinePart& part) {
  if (!parts.empty() && parts.back().to == part.from && parts.back().level == part.level) {
    parts.back().to = part.to;
  } else {
    parts.push_back(part);
  }
}

/// Joins parts of [0, 1] over hidden gaps no longer than the least length, and drops parts no longer than that. A line
/// that is itself no longer stays whole if more than half is visible, else it goes. A part of another level stays
/// separate, unless it is too short: then the part before it is extended over it. Lengths are in page steps.
void drop_short_parts(std::vector<LinePart>& parts, double length, double least);

}  // namespace ligne
