#pragma once
/// Module of analysis: how faces lie to a window.
///
/// A child window only looks at what its parent handed down: a surrounder stays one without a test, a disjoint face is gone, and of an
/// intersector the side that made it one in the parent is tried first. Faces come from near to far; once a surrounder covers the window,
/// no face that begins behind its farthest depth there is studied any more.

#include <cstdint>
#include <limits>
#include <vector>

#include "visibility/warnock/faces.hpp"

namespace ligne::warnock {

enum class Relation : std::uint8_t { disjoint, intersector, surrounder };

/// A face in the list of a window.
struct Element {
  std::uint32_t face = 0;  ///< index in the face table
  std::uint32_t side = 0;  ///< intersector: index of a side that meets the window, counted from the face's first
  float near = 0;          ///< of the face over the window
  Relation relation = Relation::intersector;
};

/// What a window knows of the scene: elements from near to far (in the order of the face table), and the depth behind which nothing is seen.
struct Lists {
  std::vector<Element> elements;
  float cover = std::numeric_limits<float>::infinity();
};

struct AnalysisCounts {
  std::uint64_t faces = 0;             ///< faces looked at, over all windows
  std::uint64_t inherited = 0;         ///< of them surrounders already in the parent
  std::uint64_t box = 0;               ///< disjoint by their bounding boxes
  std::uint64_t remembered = 0;        ///< intersectors by the remembered side
  std::uint64_t side_tests = 0;        ///< side against window
  std::uint64_t not_studied = 0;       ///< left out at once, for what covers the window
  void operator+=(const AnalysisCounts& o);
};

/// The face against the closed window. `side` is tried first, and is set to the side that meets the window.
/// surrounder: the window lies inside the contours and meets none of their sides; disjoint: outside, and meets none.
/// Exact, for convex faces and others, with holes or without.
Relation relation_to(const FaceTable& table, const Face& face, const Window& window, std::uint32_t& side, AnalysisCounts& counts);

class Analysis {
 public:
  /// `drop_hidden`: faces behind a cover are left out. `margin` in frame units: faces are held against windows that are so much larger,
  /// so that a line along the border of a window finds there the faces on both of its banks.
  Analysis(const FaceTable& table, double margin, bool drop_hidden) : table_(table), margin_(margin), drop_hidden_(drop_hidden) {}

  /// The lists of the initial window.
  Lists begin(const Window& window, AnalysisCounts& counts) const;

  /// The lists of a child of the window that has the lists `parent`.
  Lists child(const Lists& parent, const Window& window, AnalysisCounts& counts) const;

 private:
  void add(Element element, const Window& window, Lists& lists, AnalysisCounts& counts) const;
  void finish(Lists& lists) const;

  const FaceTable& table_;
  double margin_;
  bool drop_hidden_;
};

}  // namespace ligne::warnock
