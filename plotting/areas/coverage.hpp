#pragma once
/// Divides a stroke by the sides on which an area, cut by clip paths, is visible. Private to plotting.

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "areas/clip.hpp"

namespace ligne::svg {

/// A part of a stroke, from the end of the part before it, and whether its two sides are covered.
struct CoveredPart {
  Along end;
  bool plus = false, minus = false;  ///< whether the side is covered
  bool on_rim = false;               ///< the area itself, without its clip paths, lies on one side only
};

/// Finds the covered parts of strokes. Reuses its buffers from stroke to stroke.
class Coverage {
 public:
  /// Returns the parts of the stroke in order. The last one ends at kEnd, and neighbouring parts differ. Without an
  /// area, a side is covered where the clip paths show it. Time: Area::wind_along() for every area, plus O(n log n) for
  /// n changes.
  const std::vector<CoveredPart>& find(const StepSegment& stroke, const Area* area, const Clip* clip);

 private:
  static constexpr std::size_t kNone = ~std::size_t{0};
  /// Indices of the sides of a stroke.
  static constexpr std::size_t kPlus = 0, kMinus = 1, kSides = 2;

  /// An area that lies beside the stroke.
  struct Beside {
    const Area* area;
    std::size_t clip = kNone;  ///< index in clips_
    std::uint32_t place_in_clip = 0;
    std::size_t chain = kNone;  ///< chain of the clip paths that cut only this area
    Windings windings{};
    std::array<bool, kSides> counts{};  ///< whether it covers the side and its own clip paths show it
  };
  struct Side {
    std::uint32_t inside = 0;           ///< number of areas that count on this side
    std::set<std::uint32_t> painted{};  ///< masks: the areas that count on this side
    bool shows = false;
  };
  struct OneClip {
    const Clip* clip;
    std::size_t chain;
    std::array<Side, kSides> sides{};
  };
  /// Clip paths that must all show: the clip paths of the stroke, or the ones that cut one area.
  struct Chain {
    std::size_t owner;                              ///< index in beside_ of the area that it cuts; kNone: the stroke
    std::array<std::size_t, kSides> not_showing{};  ///< number of its clip paths that do not show the side
  };

  std::size_t add(const StepSegment& stroke, const Area& area, std::size_t clip, std::uint32_t place);
  std::size_t add_chain(const StepSegment& stroke, const Clip* clip, std::size_t owner);
  void refresh(std::size_t beside);
  void set_counts(std::size_t beside, std::size_t side, bool counts);
  CoveredPart state() const;
  void end_part(const Along& at, const CoveredPart& next);

  const Area* area_ = nullptr;
  std::vector<Beside> beside_;
  std::vector<OneClip> clips_;
  std::vector<Chain> chains_;  ///< the chain of the stroke is the first
  std::vector<WindingChange> changes_;
  std::vector<CoveredPart> parts_;
};

}  // namespace ligne::svg
