#pragma once
/// Module of analysis: how faces lie to a window.
///
/// A child window only looks at what its parent handed down: a surrounder stays one without a test, a disjoint face is gone,
/// and of an intersector the side that made it one in the parent is tried first. Faces come from near to far; once a
/// surrounder covers the window, no face that begins behind its farthest depth there is studied any more.

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "visibility/warnock/faces.hpp"

namespace ligne::warnock {

enum class Relation : std::uint8_t { disjoint, intersector, surrounder };

/// Box round a face in frame units, rounded outwards: decides most relations without a look at the face.
struct FaceBox {
  float u0 = 0, u1 = 0, v0 = 0, v1 = 0;

  bool meets(const Window& w) const { return u0 <= w.u1 && w.u0 <= u1 && v0 <= w.v1 && w.v0 <= v1; }
  bool inside(const Window& w) const { return w.u0 <= u0 && u1 <= w.u1 && w.v0 <= v0 && v1 <= w.v1; }
};

/// A face in the list of a window.
struct Element {
  std::uint32_t face = 0;  ///< index in the face table
  std::uint32_t side = 0;  ///< intersector: index of a side that meets the window, counted from the face's first
  float near = 0;          ///< of the face over the window
  Relation relation = Relation::intersector;
  FaceBox box;
};

/// The scene as a window knows it: elements from near to far (as FaceTable::by_depth), and the depth behind which nothing
/// is seen.
struct Lists {
  std::vector<Element> elements;
  float occluder_depth = std::numeric_limits<float>::infinity();
};

struct AnalysisCounts {
  std::uint64_t faces = 0;        ///< faces looked at, over all windows
  std::uint64_t inherited = 0;    ///< of them surrounders already in the parent
  std::uint64_t box = 0;          ///< disjoint by their boxes
  std::uint64_t inside = 0;       ///< intersectors by their boxes, which lie in the window
  std::uint64_t remembered = 0;   ///< intersectors by the remembered side
  std::uint64_t side_tests = 0;   ///< side against window
  std::uint64_t not_studied = 0;  ///< left out at once, for what covers the window
  void operator+=(const AnalysisCounts& o);
};

/// The face against the closed window. `side` is tried first, and is set to the side that meets the window.
/// surrounder: the window lies inside the contours and meets none of their sides; disjoint: outside, and meets none.
/// Exact, for convex faces and others, with holes or without.
Relation relation_to(const FaceTable& table, const Face& face, const Window& window, std::uint32_t& side,
                     AnalysisCounts& counts);

class Analysis {
 public:
  /// `drop_hidden`: faces behind a cover are left out. `margin` in frame units: faces are compared with windows that are so
  /// much larger, so that a line along the border of a window finds there the faces on both of its sides. Without
  /// `remember_sides` children try the sides of an intersector from its first on.
  Analysis(const FaceTable& table, double margin, bool drop_hidden, bool remember_sides = true)
      : table_(table), margin_(margin), drop_hidden_(drop_hidden), remember_sides_(remember_sides) {}

  /// The lists of the initial window.
  Lists begin(const Window& window, AnalysisCounts& counts) const;

  /// The lists of the children of the window that has the lists `parent`. Empty windows are no children.
  std::array<Lists, 4> children(const Lists& parent, const std::array<Window, 4>& windows, AnalysisCounts& counts) const;

 private:
  /// `larger` is the window with the margin.
  void add(Element element, const Window& larger, Lists& lists, AnalysisCounts& counts) const;
  void finish(Lists& lists) const;

  const FaceTable& table_;
  double margin_;
  bool drop_hidden_, remember_sides_;
};

}  // namespace ligne::warnock
