#pragma once
/// Module of understanding: is what a window shows plain enough to be drawn at once?
///
/// All functions look at the inner window, which is smaller than the window by the margin: a face whose rim runs along the
/// border of the window within the margin surrounds it. Nothing is lost by that: lines are cut exactly afterwards, against
/// all faces of the lists.

#include <optional>
#include <span>

#include "visibility/warnock/depth.hpp"

namespace ligne::warnock {

/// The shape that was recognised.
enum class Understood : std::uint8_t {
  no,
  surrounder,               ///< 1: a surrounder before everything
  penetrating_surrounders,  ///< 2: two penetrating surrounders before everything
  one_line,                 ///< 3: intersectors before a cover, their seen edges in one line
  single_intersector,       ///< 4: one intersector, before a cover or alone
  one_vertex,               ///< figure 2.14d: the seen edges meet in one vertex
  apart,                    ///< figure 2.14d: intersectors side by side, none over another
};
inline constexpr std::size_t kUnderstoodCount = 7;

/// How much the module knows: the choices of [Boulle1980] 2.2.3.2, and all that there is.
enum class Knowledge : std::uint8_t {
  nothing,     ///< every window is divided
  two_cases,   ///< 1 and 4
  four_cases,  ///< 1 to 4
  all,
};

/// An element and how it lies to the inner window.
struct Placed {
  Element element;  ///< with the relation to the inner window
  const Face* face = nullptr;
};

/// Outcome of the study of the surrounders: the one before all others, or two that penetrate each other before all others,
/// or nothing.
struct Covers {
  const Placed* front = nullptr;
  const Placed* other = nullptr;  ///< penetrates the front one
  bool failed = false;            ///< more than two penetrate
};

/// A window as the functions see it.
class Situation {
 public:
  /// `inner` is the window less its margin. With more than `most` elements it is crowded.
  Situation(const FaceTable& table, const Lists& lists, const Window& inner, std::size_t most, AnalysisCounts& analysis,
            DepthCounts& depth);

  const FaceTable& table;
  Window inner;
  std::vector<Placed> placed;  ///< elements that have a part in the inner window, from near to far
  bool crowded = false;        ///< too many to be understood; `placed` is empty
  DepthCounts& depth;

  DepthComparison compare(const Placed& face, const Placed& cover) const {
    return compare_depth(table, face.element, *cover.face, inner, depth);
  }
};

/// The surrounders, compared with each other one after the other.
Covers study_surrounders(const Situation& s);

/// The intersectors that are not wholly behind the cover (all of them when it is null); nothing when one crosses it.
std::optional<std::vector<const Placed*>> seen_intersectors(const Situation& s, const Placed* cover);

/// 1. Everything but the cover lies clearly behind it.
bool surrounder_before_everything(const Situation& s, const Covers& covers);
/// 2. Two covers cross, and everything else lies clearly behind one of them.
bool penetrating_surrounders_before_everything(const Situation& s, const Covers& covers);
/// 3. All sides of the seen intersectors lie in one line of the page, and those on one side of it do not cross.
bool seen_edges_in_one_line(const Situation& s, std::span<const Placed* const> seen);
/// 4. One intersector is seen.
bool single_intersector(std::span<const Placed* const> seen);
/// 2.14d. All sides of the seen intersectors end in one point of the window.
bool seen_edges_meet_in_one_vertex(const Situation& s, std::span<const Placed* const> seen);
/// 2.14d. No seen intersector lies over another.
bool seen_intersectors_apart(const Situation& s, std::span<const Placed* const> seen);

/// Tries all of them that are known. A window in which nothing is seen but a cover that something touches, or nothing at
/// all, counts as one line.
Understood understand(const Situation& s, Knowledge knowledge = Knowledge::all);

}  // namespace ligne::warnock
