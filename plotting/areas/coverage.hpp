#pragma once
/// Which parts of a stroke have an area, as far as it shows through clip paths, on their two sides. Private to plotting.

#include <array>
#include <cstddef>
#include <cstdint>
#include <set>
#include <vector>

#include "areas/clip.hpp"

namespace ligne::svg {

/// A part of a stroke, from where the part before it ends, with the areas beside it.
struct CoveredPart {
  Along end;
  bool plus = false, minus = false;  ///< covered there
  bool on_rim = false;               ///< the area itself, without its clip paths, lies on one side only
};

/// Finds covered parts, and keeps its memory from stroke to stroke.
class Coverage {
 public:
  /// The parts of the stroke, in order; the last one ends at kEnd, and neighbours differ. Without an area all that shows
  /// through the clip paths is covered. Time: as Area::wind_along() of all areas, and n log n of the changes.
  const std::vector<CoveredPart>& find(const StepSegment& stroke, const Area* area, const Clip* clip);

 private:
  static constexpr std::size_t kNone = ~std::size_t{0};
  /// Sides of a stroke.
  static constexpr std::size_t kPlus = 0, kMinus = 1, kSides = 2;

  /// An area that lies beside the stroke.
  struct Beside {
    const Area* area;
    std::size_t clip = kNone;  ///< its place in clips_
    std::uint32_t place_in_clip = 0;
    std::size_t chain = kNone;  ///< the clip paths that cut this area alone
    Windings windings{};
    std::array<bool, kSides> counts{};  ///< it covers the side, and its own clip paths show it
  };
  struct Side {
    std::uint32_t inside = 0;           ///< areas that count
    std::set<std::uint32_t> painted{};  ///< of a mask: those round the side
    bool shows = false;
  };
  struct OneClip {
    const Clip* clip;
    std::size_t chain;
    std::array<Side, kSides> sides{};
  };
  /// Clip paths all of which must show: those of the stroke, or those that cut one area.
  struct Chain {
    std::size_t owner;                              ///< that area in beside_; kNone: the stroke
    std::array<std::size_t, kSides> not_showing{};  ///< number of its clip paths that do not
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
  std::vector<Chain> chains_;  ///< that of the stroke first
  std::vector<WindingChange> changes_;
  std::vector<CoveredPart> parts_;
};

}  // namespace ligne::svg
