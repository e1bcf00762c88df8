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
  std::uint32_t level = 0;  ///< of what is seen: how many transparent faces are in front of it
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

  /// The ends of the open parts: nothing outside them can matter. Not when empty().
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

  /// The open parts, in order, when every interval has been taken.
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

/// Appends a part; one of the same level that begins where the last one ends continues it.
inline void append_part(std::vector<LinePart>& parts, const LinePart& part) {
  if (!parts.empty() && parts.back().to == part.from && parts.back().level == part.level) {
    parts.back().to = part.to;
  } else {
    parts.push_back(part);
  }
}

/// Joins parts of [0, 1] over hidden gaps shorter than the least length and drops parts that are shorter; what remains of a
/// line that is shorter as a whole is the line or nothing. What goes on in another level is a part of its own; where it is
/// too short the one before goes on. Lengths are in page steps.
void drop_short_parts(std::vector<LinePart>& parts, double length, double least);

}  // namespace ligne
