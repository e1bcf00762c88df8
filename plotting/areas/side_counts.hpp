#pragma once
/// Counts areas and lines on the two sides of a stroke, part by part. Private to plotting.

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "areas/coverage.hpp"

namespace ligne::svg {

/// Kinds that are counted separately, on each side.
enum class SideKind : unsigned char { covered, own, rim };
inline constexpr std::size_t kSideKinds = 3;

struct SideCount {
  int plus = 0, minus = 0;
};
using SideCounts = std::array<SideCount, kSideKinds>;

/// Where an area draws a line of its own: nowhere, along its contours, or along all borders of its visible part.
enum class RimLine : unsigned char { none, contours, borders };

/// Merges lists of covered parts into counts.
class SideTally {
 public:
  void clear() {
    at_begin_ = {};
    changes_.clear();
  }

  /// Adds one area by its parts. Its own line, if any, counts as SideKind::rim on both sides.
  void add(std::span<const CoveredPart> parts, SideKind kind, RimLine line = RimLine::none) {
    Along at = kBegin;
    CoveredPart last{};
    for (const CoveredPart& part : parts) {
      change(at, kind, part.plus - last.plus, part.minus - last.minus);
      const int by = has_line(part, line) - has_line(last, line);
      change(at, SideKind::rim, by, by);
      last = part;
      at = part.end;
    }
  }

  /// Calls visit(counts, end) for all parts, in order.
  template <class Visit>
  void for_each_part(Visit visit) {
    std::sort(changes_.begin(), changes_.end(), [](const Change& p, const Change& q) { return compare(p.at, q.at) < 0; });
    SideCounts counts = at_begin_;
    for (std::size_t k = 0; k < changes_.size();) {
      const Along at = changes_[k].at;
      visit(counts, at);
      do apply(counts, changes_[k]);
      while (++k < changes_.size() && compare(changes_[k].at, at) == 0);
    }
    visit(counts, kEnd);
  }

 private:
  struct Change {
    Along at;
    SideKind kind;
    int plus, minus;
  };
  static int has_line(const CoveredPart& part, RimLine line) {
    if (line == RimLine::borders) return part.plus != part.minus;
    return line == RimLine::contours && part.on_rim && (part.plus || part.minus);
  }
  static void apply(SideCounts& counts, const Change& change) {
    SideCount& count = counts[static_cast<std::size_t>(change.kind)];
    count.plus += change.plus;
    count.minus += change.minus;
  }
  void change(const Along& at, SideKind kind, int plus, int minus) {
    if (plus == 0 && minus == 0) return;
    const Change one{at, kind, plus, minus};
    is_behind_begin(at) ? changes_.push_back(one) : apply(at_begin_, one);
  }

  SideCounts at_begin_{};
  std::vector<Change> changes_;
};

/// Whether `covering` hides all ink of a line. Half of the ink lies on each side; if the line represents the ink of an
/// area (`own`), all of it lies on the sides where the area lies.
inline bool is_hidden(SideCount covering, SideCount own) {
  const bool has_own = own.plus > 0 || own.minus > 0;
  const bool plus = !has_own || own.plus > 0, minus = !has_own || own.minus > 0;
  return (!plus || covering.plus > 0) && (!minus || covering.minus > 0);
}

}  // namespace ligne::svg
