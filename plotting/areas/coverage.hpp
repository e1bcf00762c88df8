#pragma once
/// Which parts of a stroke have an area, as far as it shows through clip paths, on their two sides. Private to plotting.

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
  /// An area that lies beside the stroke.
  struct Beside {
    const Area* area;
    std::size_t clip;  ///< its place in clips_, or kNoClip
    std::uint32_t place_in_clip;
    Windings windings{};
  };
  struct Side {
    std::uint32_t inside = 0;           ///< areas that show
    std::set<std::uint32_t> painted{};  ///< of a mask: those round the side
  };
  /// An area beside the stroke that clip paths of its own cut: those in clips_[first, end) that are one deeper.
  struct CutArea {
    std::size_t beside, first, end;
  };
  struct OneClip {
    const Clip* clip;
    std::size_t depth;  ///< 0: it cuts the stroke itself
    Side plus{}, minus{};
    std::vector<CutArea> cut{};  ///< of a clip path whose areas are cut
  };
  static constexpr std::size_t kNoClip = ~std::size_t{0};

  bool add(const StepSegment& stroke, const Area& area, std::size_t clip, std::uint32_t place);
  void add_clips(const StepSegment& stroke, const Clip* clip, std::size_t depth);
  void update(Beside& beside, Windings by, bool is_first);
  static void update_side(const Clip& clip, Side& side, std::uint32_t place, bool was_inside, bool is_inside);
  bool shows(std::size_t clip, bool on_plus) const;
  bool all_show(std::size_t first, std::size_t end, std::size_t depth, bool on_plus) const;
  CoveredPart state() const;
  void end_part(const Along& at, const CoveredPart& next);

  const Area* area_ = nullptr;
  std::vector<Beside> beside_;
  std::vector<OneClip> clips_;
  std::vector<WindingChange> changes_;
  std::vector<CoveredPart> parts_;
};

}  // namespace ligne::svg
