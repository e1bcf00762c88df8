#pragma once
/// Visible strokes that continue each other on the page.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "drawing/stroke.hpp"

namespace ligne {

/// Seen directly, not only through glass.
inline bool is_seen(const Stroke& s) { return s.visible && s.level == 0; }

/// True for edges of the scene; lines of surfaces and axes are as they are.
inline bool is_edge(const Stroke& s) { return static_cast<std::size_t>(s.line_class) < kEdgeClassCount; }

inline bool any_hidden(const std::vector<Stroke>& strokes) {
  return std::ranges::any_of(strokes, [](const Stroke& s) { return !s.visible; });
}

/// The length of a stroke on the page, lattice steps.
double page_length(const Stroke& s);

/// The strokes that are seen, in chains: strokes continue each other where two of them end and no third one does.
class StrokeChains {
 public:
  struct Chain {
    double length = 0;           ///< lattice steps
    std::uint8_t free_ends = 0;  ///< at which no other stroke ends
    std::uint8_t cut_ends = 0;   ///< of those, where the source goes on: visibility ends the stroke there
  };

  /// O(n).
  explicit StrokeChains(const std::vector<Stroke>& strokes);

  /// The strokes that are seen, in ascending order.
  const std::vector<std::uint32_t>& seen() const { return seen_; }
  /// The lowest stroke of the chain of a stroke that is seen stands for the chain.
  std::uint32_t chain_of(std::uint32_t stroke) const { return chain_of_[stroke]; }
  const Chain& chain(std::uint32_t lowest) const { return chains_[lowest]; }
  /// No other stroke that is seen ends where this one, that is seen, does with its `from` or `to`.
  bool is_free(std::uint32_t stroke, bool at_from) const { return (free_[stroke] & (at_from ? 1 : 2)) != 0; }

 private:
  std::vector<std::uint32_t> seen_, chain_of_;
  std::vector<Chain> chains_;
  std::vector<std::uint8_t> free_;  ///< per stroke
};

/// Hides the chains (StrokeChains, or the runs of StrokeLines) for which is_left_out(lowest stroke) holds; where no stroke
/// is hidden, takes them out. Returns their number. O(n).
template <class Chains, class IsLeftOut>
std::size_t leave_out(std::vector<Stroke>& strokes, const Chains& chains, const IsLeftOut& is_left_out) {
  const bool hidden_too = any_hidden(strokes);
  std::size_t count = 0;
  for (const std::uint32_t i : chains.seen()) {
    const std::uint32_t lowest = chains.chain_of(i);
    if (!is_left_out(lowest)) continue;
    count += lowest == i;
    strokes[i].visible = false;
  }
  if (!hidden_too) std::erase_if(strokes, [](const Stroke& s) { return !s.visible; });
  return count;
}

}  // namespace ligne
