#pragma once
/// Module of understanding: decides whether a window is simple enough to be drawn at once.
///
/// All functions examine the inner window, which is smaller than the window by the margin. A face whose border runs within
/// the margin along the window's border therefore counts as a surrounder. This loses nothing: lines are clipped exactly
/// afterwards, against all faces of the lists.

#include <optional>
#include <span>

#include "base/add_counts.hpp"
#include "visibility/common/facet.hpp"
#include "visibility/warnock/analysis.hpp"

namespace ligne::warnock {

/// Tests of depth over a window.
///
/// [Boulle1980] compares the planes of two faces at the four corners of the window, and concludes that the faces penetrate
/// if their order differs there (its case 3). That is wrong where a face ends before the planes cross; the source then uses
/// the window round the intersector instead. Here a face is compared only where it lies: first over the common part of the
/// window and the face's bounding box, which decides most pairs; then at the corners of its contour clipped by the window,
/// where the difference of two planes has its extremes.

/// The result of comparing a face with another.
struct DepthComparison {
  /// `first`: the face is nowhere behind by more than the tolerance, and somewhere in front by more; `second`: the opposite;
  /// `apart`: the face has no part in the window.
  DepthOrder order = DepthOrder::apart;
  bool clear = false;  ///< the depths differ everywhere by more than the tolerance
};

struct DepthCounts {
  std::uint64_t depths = 0;       ///< computed depths
  std::uint64_t comparisons = 0;  ///< compared pairs of faces
  std::uint64_t clipped = 0;      ///< of these, pairs that needed the exact contour
  void operator+=(const DepthCounts& o) { add_counts(*this, o); }
};

/// Compares `face` (an element of the window) with the plane of `cover`, over the part of `face` in the window.
DepthComparison compare_depth(const FaceTable& table, const Element& face, const Face& cover, const WindowShape& window,
                              DepthCounts& counts);

/// The recognised configuration. Numbers are the cases of [Boulle1980].
enum class Understood : std::uint8_t {
  no,
  surrounder,               ///< 1: a surrounder in front of everything
  penetrating_surrounders,  ///< 2: two penetrating surrounders in front of everything
  one_line,                 ///< 3: intersectors in front of a cover, their visible edges in one line
  single_intersector,       ///< 4: one intersector, with or without a cover behind it
  one_vertex,               ///< figure 2.14d: all visible edges meet in one vertex
  apart,                    ///< figure 2.14d: intersectors side by side without overlap
};
inline constexpr std::size_t kUnderstoodCount = 7;

/// The cases that the module recognises: the choices of [Boulle1980] 2.2.3.2, and all cases.
enum class Knowledge : std::uint8_t {
  nothing,     ///< every window is divided
  two_cases,   ///< 1 and 4
  four_cases,  ///< 1 to 4
  all,
};

/// An element and its relation to the inner window.
struct Placed {
  Element element;  ///< its relation is to the inner window
  const Face* face = nullptr;
};

/// The result of comparing the surrounders: one in front of all others, two penetrating ones in front of all others, or
/// none.
struct Covers {
  const Placed* front = nullptr;
  const Placed* other = nullptr;  ///< penetrates `front`
  bool failed = false;            ///< more than two surrounders penetrate
};

/// The input of the functions: a window with its elements.
class Situation {
 public:
  /// `inner` is the window less its margin. With more than `most` elements the window is crowded.
  Situation(const FaceTable& table, const Lists& lists, const WindowShape& inner, std::size_t most, AnalysisCounts& analysis,
            DepthCounts& depth);

  const FaceTable& table;
  WindowShape inner;
  std::vector<Placed> placed;  ///< elements with a part in the inner window, from near to far
  bool crowded = false;        ///< too many elements to be understood; `placed` is empty
  DepthCounts& depth;

  DepthComparison compare(const Placed& face, const Placed& cover) const {
    return compare_depth(table, face.element, *cover.face, inner, depth);
  }
};

/// Compares the surrounders one after the other.
Covers study_surrounders(const Situation& s);

/// The intersectors not wholly behind the cover (all if it is null); empty optional if one penetrates it.
std::optional<std::vector<const Placed*>> seen_intersectors(const Situation& s, const Placed* cover);

/// 1. Everything but the cover lies clearly behind it.
bool surrounder_before_everything(const Situation& s, const Covers& covers);
/// 2. Two covers cross, and everything else lies clearly behind one of them.
bool penetrating_surrounders_before_everything(const Situation& s, const Covers& covers);
/// 3. All sides of the visible intersectors lie on one line of the page, and those on one side of it do not cross.
bool seen_edges_in_one_line(const Situation& s, std::span<const Placed* const> seen);
/// 4. Exactly one intersector is visible.
bool single_intersector(std::span<const Placed* const> seen);
/// 2.14d. All sides of the visible intersectors end in one point of the window.
bool seen_edges_meet_in_one_vertex(const Situation& s, std::span<const Placed* const> seen);
/// 2.14d. No visible intersector overlaps another.
bool seen_intersectors_apart(const Situation& s, std::span<const Placed* const> seen);

/// Tries all cases in `knowledge`. A window in which only a touched cover is visible, or nothing, counts as one line.
Understood understand(const Situation& s, Knowledge knowledge = Knowledge::all);

}  // namespace ligne::warnock
