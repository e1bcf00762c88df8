#pragma once
/// Module of analysis: the relations of faces to a window.
///
/// A child window examines only the list of its parent: a surrounder stays one without a test, a disjoint face is dropped,
/// and an intersector is tested first with the side that met the parent. Faces come from near to far. Once a surrounder
/// covers the window, faces that begin behind the surrounder's farthest depth there are skipped.

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/add_counts.hpp"
#include "visibility/warnock/faces.hpp"

namespace ligne::warnock {

enum class Relation : std::uint8_t { disjoint, intersector, surrounder };

/// Bounding box of a face in frame units, rounded outwards. It decides most relations without the face.
struct FaceBox {
  float u0 = 0, u1 = 0, v0 = 0, v1 = 0;

  bool meets(const Window& w) const { return u0 <= w.u1 && w.u0 <= u1 && v0 <= w.v1 && w.v0 <= v1; }
  bool inside(const Window& w) const { return w.u0 <= u0 && u1 <= w.u1 && w.v0 <= v0 && v1 <= w.v1; }
};

/// A face in the list of a window.
struct Element {
  std::uint32_t face = 0;  ///< index in the face table
  std::uint32_t side = 0;  ///< intersector: index of a side that meets the window, counted from the face's first
  float near = 0;          ///< nearest depth of the face over the window
  Relation relation = Relation::intersector;
  FaceBox box;
};

/// The faces of a window: elements from near to far (in the order of FaceTable::by_depth), and the depth behind which
/// everything is hidden.
struct Lists {
  std::vector<Element> elements;
  float occluder_depth = std::numeric_limits<float>::infinity();
};

struct AnalysisCounts {
  std::uint64_t faces = 0;        ///< examined faces, summed over all windows
  std::uint64_t inherited = 0;    ///< of these, surrounders already in the parent
  std::uint64_t box = 0;          ///< of these, disjoint by their boxes
  std::uint64_t inside = 0;       ///< of these, intersectors whose boxes lie inside the window
  std::uint64_t remembered = 0;   ///< of these, intersectors by the remembered side
  std::uint64_t side_tests = 0;   ///< tests of a side against a window
  std::uint64_t not_studied = 0;  ///< skipped because the window is covered
  void operator+=(const AnalysisCounts& o) { add_counts(*this, o); }
};

/// The relation of a face to the closed window. Tests `side` first, and sets it to a side that meets the window. surrounder:
/// the window lies inside the contours and meets none of their sides; disjoint: it lies outside and meets none. Exact for
/// convex and other faces, with or without holes.
Relation relation_to(const FaceTable& table, const Face& face, const Window& window, std::uint32_t& side,
                     AnalysisCounts& counts);

/// The relation of a face to a convex window enlarged by `margin` frame units. A face that only comes near may count as an
/// intersector; the other two relations are certain.
Relation relation_to(const FaceTable& table, const Face& face, const ConvexWindow& window, double margin,
                     std::uint32_t& side, AnalysisCounts& counts);

class Analysis {
 public:
  /// `drop_hidden`: omits faces behind a cover. `margin`, frame units: windows are enlarged by it when compared with faces,
  /// so that a line along a window's border finds the faces on both of its sides there. Without `remember_sides` children
  /// test the sides of an intersector from its first one.
  Analysis(const FaceTable& table, double margin, bool drop_hidden, bool remember_sides = true)
      : table_(table), margin_(margin), drop_hidden_(drop_hidden), remember_sides_(remember_sides) {}

  /// The lists of the initial window.
  Lists begin(const Window& window, AnalysisCounts& counts) const;

  /// The lists of the window's children, from its own lists `parent`. Empty windows are skipped.
  std::array<Lists, 4> children(const Lists& parent, const std::array<Window, 4>& windows, AnalysisCounts& counts) const;
  std::array<Lists, 2> children(const Lists& parent, const std::array<ConvexWindow, 2>& windows,
                                AnalysisCounts& counts) const;

 private:
  struct LargerRectangle;
  struct LargerPolygon;

  template <class Larger, std::size_t kCount>
  std::array<Lists, kCount> children_of(const Lists& parent, const std::array<Larger, kCount>& windows,
                                        AnalysisCounts& counts) const;
  /// `larger` is the window enlarged by the margin.
  template <class Larger>
  void add(Element element, const Larger& larger, Lists& lists, AnalysisCounts& counts) const;
  void finish(Lists& lists) const;

  const FaceTable& table_;
  double margin_;
  bool drop_hidden_, remember_sides_;
};

}  // namespace ligne::warnock
