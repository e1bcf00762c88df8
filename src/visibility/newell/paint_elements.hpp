#pragma once
/// The elements of the priority list: faces, and pieces of faces that were cut, with what the tests ask of them.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "view/clip.hpp"
#include "view/projected_scene.hpp"
#include "visibility/newell/convex_bodies.hpp"
#include "visibility/order/model_pieces.hpp"
#include "visibility/order/paint_pieces.hpp"

namespace ligne::newell {

/// Extents on the page and in depth: [low, high] along x, y, z.
struct Extents {
  std::array<double, 3> low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};

  void extend(const Extents& o);
  double longest_side() const { return std::max(high[0] - low[0], high[1] - low[1]); }  ///< on the page
  /// Whether they have more than a border in common along the axis.
  bool overlap(const Extents& o, int axis) const { return low[axis] < o.high[axis] && o.low[axis] < high[axis]; }
};

/// A connected part of a face. Its parts are convex pieces of the face's triangles.
struct Element {
  std::uint32_t face = 0;
  std::vector<std::uint32_t> parts;  ///< numbers of pieces
  Extents extents;
  ModelPlane plane;                              ///< its normal points to the viewer's side
  std::array<double, 3> page_plane{};            ///< see PagePlanes
  std::size_t corner_begin = 0, corner_end = 0;  ///< of its parts in the model, see PaintElements
};

/// The result of a comparison of depths over a common part of the page.
struct Hiding {
  bool first = false, second = false;  ///< somewhere it is in front of the other
};

/// Elements for another view: faces and their pieces, the farthest first, and all pieces of the scene.
struct EarlierElements {
  struct Part {
    std::uint32_t face = 0;
    std::vector<std::uint32_t> pieces;
  };
  std::vector<Part> list;
  ModelPieces pieces;
};

/// Working memory of a comparison: the common part of two projections.
struct CommonPart {
  std::vector<Point2> corners, spare;

  /// Leaves what is inside the side of a positively turned contour.
  void clip_by_side(Point2 from, Point2 to);
};

/// All elements that there ever were, by number: one that is cut keeps its number and is no longer used.
class PaintElements {
 public:
  /// The faces that the projected scene shows. With those of an earlier view they begin with the pieces of its list, in its
  /// order; what that did not show comes behind.
  explicit PaintElements(const ProjectedScene& scene, const EarlierElements* earlier = nullptr);
  std::size_t in_order() const { return in_order_; }  ///< so many come from the earlier list

  std::size_t size() const { return elements_.size(); }
  const Element& operator[](std::uint32_t i) const { return elements_[i]; }
  const ModelPieces& pieces() const { return pieces_; }

  const ConvexBodies& bodies() const { return bodies_; }
  /// That the first does not hide the second is known without a comparison: they are of one face, whose pieces lie in one
  /// plane, or of one convex body.
  bool never_hides(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t f = elements_[a].face, g = elements_[b].face;
    return f == g || bodies_.never_hides(f, g);
  }

  /// On which side of the plane of `of` the element lies: front is the viewer's.
  PlaneSide side(std::uint32_t element, std::uint32_t of) const;

  /// Whether the projections have no inner point in common, compared edge by edge. Pieces smaller than a step of the
  /// lattice, of which nothing can be seen, have none. A long strip has, however narrow: a line that lies in it is hidden
  /// with it.
  bool disjoint(std::uint32_t a, std::uint32_t b) const;

  /// Which of two elements that are not disjoint is in front, over all that their projections have in common. What differs
  /// less in depth than the error of the input explains touches. That is less than the depth tolerance within which a facet
  /// hides no line, which has room for the lattice too: so the order never leaves out what hides.
  Hiding hiding(std::uint32_t a, std::uint32_t b, CommonPart& work) const;

  /// Cuts the element by a plane into connected elements, whose numbers are returned: none when nothing was cut. An element
  /// of c corners falls into c / 2 + 1 at the most, into two when it is convex.
  std::vector<std::uint32_t> cut(std::uint32_t element, ModelPlane plane);

  /// The plane through the eye that halves the element on the page: across the axis along which it is longer.
  ModelPlane halving_plane(std::uint32_t element) const;

 private:
  void add(std::uint32_t face, std::span<const std::uint32_t> parts);
  void append(Element element);
  Extents project(std::uint32_t piece);
  std::vector<std::vector<std::uint32_t>> connected(const std::vector<std::uint32_t>& parts) const;
  std::span<const Point2> contour(std::uint32_t piece) const {
    return std::span(points_).subspan(contours_[piece][0], contours_[piece][1] - contours_[piece][0]);
  }
  bool disjoint_pieces(std::uint32_t p, std::uint32_t q) const;

  const View& view_;
  const ProjectedScene& scene_;
  ModelPieces pieces_;
  ConvexBodies bodies_;
  ClipVolume volume_;
  Viewpoint viewpoint_;
  PagePlanes page_planes_;
  std::vector<std::uint8_t> shown_;
  std::vector<Element> elements_;
  std::vector<Point3> element_corners_;  ///< of all elements: nothing is asked for as often
  std::size_t in_order_ = 0;
  std::vector<Extents> piece_extents_;
  std::vector<std::array<std::size_t, 2>> contours_;  ///< per piece: of points_
  std::vector<Point2> points_;                        ///< page mm, positively turned
  std::vector<HomogeneousPoint> corners_;             ///< while a piece is projected
};

}  // namespace ligne::newell
