#pragma once
/// The elements of the priority list: faces, pieces of cut faces and convex bodies, with the tests on them.

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "view/clip.hpp"
#include "view/projected_scene.hpp"
#include "visibility/newell/convex_bodies.hpp"
#include "visibility/order/model_pieces.hpp"
#include "visibility/order/paint_pieces.hpp"

namespace ligne::newell {

/// The result of comparing two elements in depth over their common part of the page.
struct Hiding {
  bool first = false, second = false;  ///< the first (second) is in front of the other somewhere
};

/// The list of an earlier view: faces with their pieces, farthest first, and all pieces of the scene.
struct EarlierElements {
  struct Part {
    std::uint32_t face = 0;
    std::vector<std::uint32_t> pieces;
  };
  std::vector<Part> list;
  ModelPieces pieces;
};

/// Scratch memory of a comparison: the common part of two projections.
struct CommonPart {
  std::vector<Point2> corners, spare;

  /// Clips to the inside of one side of a positively oriented contour.
  void clip_by_side(Point2 from, Point2 to);
};

/// Knowledge about the faces of a scene in a view, found before any comparison.
struct FaceFacts {
  ConvexBodies bodies;
  std::vector<std::uint32_t> cells;     ///< per face its cell by separating planes, or empty
  std::vector<std::uint8_t> is_convex;  ///< per face; empty if faces may penetrate
};

/// All elements ever made, by number. A cut element keeps its number but is no longer used.
class PaintElements {
 public:
  /// The faces visible in the projected scene. With `earlier`, the elements begin with the pieces of its list, in its order;
  /// the other faces follow. `whole_bodies`: each convex body is one element until it is opened; only without `earlier`.
  explicit PaintElements(const ProjectedScene& scene, const EarlierElements* earlier = nullptr, bool whole_bodies = false);
  /// Copies the elements with these rising numbers into a set of their own, numbered from 0 in the same order. Another
  /// thread may cut them. O(n log n).
  PaintElements(const PaintElements& whole, std::span<const std::uint32_t> list);
  /// Takes over the new elements of the copy of a list. Returns the number here of each element of the copy.
  std::vector<std::uint32_t> take_over(const PaintElements& copy, std::span<const std::uint32_t> list);

  std::size_t in_order() const { return in_order_; }  ///< number of elements from the earlier list

  std::size_t size() const { return elements_.size(); }
  std::size_t face_count() const { return face_count_; }  ///< visible faces at the beginning
  std::size_t whole_bodies() const { return whole_.size(); }
  const Element& operator[](std::uint32_t i) const { return elements_[i]; }
  const ModelPieces& pieces() const { return pieces_; }

  const ConvexBodies& bodies() const { return facts_->bodies; }
  /// True if it is known without comparison that `a` does not hide `b`: both are of one face, whose pieces are coplanar, or
  /// of one convex body, or a separating plane orders them.
  bool never_hides(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t f = elements_[a].face, g = elements_[b].face;
    return f == g || facts_->bodies.never_hides(f, g) || separated(f, g);
  }
  /// True if `face` lies behind `other` by a separating plane of the scene.
  bool separated(std::uint32_t face, std::uint32_t other) const {
    const std::vector<std::uint32_t>& cells = facts_->cells;
    return !cells.empty() && cells[face] < cells[other];
  }
  /// Cell of an element by the separating planes: lower numbers are painted first.
  std::uint32_t cell(std::uint32_t element) const {
    return facts_->cells.empty() ? 0 : facts_->cells[elements_[element].face];
  }

  /// True if at most one of the two can hide the other: parts of convex faces that do not penetrate.
  bool hide_one_way(std::uint32_t a, std::uint32_t b) const {
    const std::vector<std::uint8_t>& is_convex = facts_->is_convex;
    if (is_convex.empty() || is_body(a) || is_body(b)) return false;  // one body may lie inside another
    return is_convex[elements_[a].face] && is_convex[elements_[b].face];
  }

  /// True if the element is a convex body that is not opened.
  bool is_body(std::uint32_t element) const { return elements_[element].body != kNone; }
  /// Replaces a body by its faces. Returns their numbers, back faces first.
  std::vector<std::uint32_t> open(std::uint32_t body);

  /// True if a plane of `of` proves that the element lies wholly behind it. A body has one plane per back face.
  bool lies_behind(std::uint32_t element, std::uint32_t of) const {
    const Element& e = elements_[of];
    return e.body == kNone ? is_back(side(elements_[element], e.plane)) : lies_behind_body(element, whole_[e.body]);
  }
  /// True if a plane of `of` proves that the element lies wholly in front. A body has one plane per front face.
  bool lies_before(std::uint32_t element, std::uint32_t of) const {
    const Element& e = elements_[of];
    return e.body == kNone ? is_front(side(elements_[element], e.plane)) : lies_before_body(element, whole_[e.body]);
  }

  /// The side of the plane of `of` on which the element lies; front is the viewer's side.
  PlaneSide side(std::uint32_t element, std::uint32_t of) const;

  /// True if the projections share no inner point, compared edge by edge. Pieces smaller than a lattice step are invisible
  /// and always disjoint. A long strip is not, however narrow, because it hides a line inside it.
  bool disjoint(std::uint32_t a, std::uint32_t b) const;

  /// Compares the depths of two non-disjoint elements over the whole common part of their projections. Depth differences
  /// within the input error count as touching. That error is below the depth tolerance within which a facet hides no line,
  /// so the order never omits an occluder.
  Hiding hiding(std::uint32_t a, std::uint32_t b, CommonPart& work) const;

  /// Cuts the element by a plane and returns the connected new elements; empty if the plane does not cut it. An element of c
  /// corners gives at most c / 2 + 1 elements, a convex one two.
  std::vector<std::uint32_t> cut(std::uint32_t element, ModelPlane plane);

  /// The plane through the eye that halves the element on the page, across its longer axis.
  ModelPlane halving_plane(std::uint32_t element) const;

 private:
  PaintElements(const PaintElements& whole, std::span<const std::uint32_t> list, std::vector<std::uint32_t> parts);
  void add(std::uint32_t face, std::span<const std::uint32_t> parts);
  void append(Element element);
  void copy_element(const PaintElements& whole, Element element);
  void copy_contour(const PaintElements& from, std::uint32_t piece, std::size_t to);
  void make_whole_bodies();
  static bool is_back(PlaneSide s) { return s == PlaneSide::back || s == PlaneSide::on; }
  static bool is_front(PlaneSide s) { return s == PlaneSide::front || s == PlaneSide::on; }
  PlaneSide side(const Element& e, const ModelPlane& plane) const {
    double low = 0, high = 0;
    for (std::size_t i = e.corner_begin; i < e.corner_end; ++i) {
      const double h = plane.height(element_corners_[i]);
      low = std::min(low, h);
      high = std::max(high, h);
    }
    return pieces_.side_of_heights(low, high);
  }
  bool lies_behind_body(std::uint32_t element, const BodyElement& body) const;
  bool lies_before_body(std::uint32_t element, const BodyElement& body) const;
  void compare_depths(const Element& a, const Element& b, CommonPart& work, Hiding& result) const;
  /// The faces of a body, or the element itself.
  std::span<const Element> faces_of(const Element& element) const {
    return element.body == kNone ? std::span(&element, 1) : std::span(whole_[element.body].members);
  }
  Extents project(std::uint32_t piece);
  std::vector<std::vector<std::uint32_t>> connected(const std::vector<std::uint32_t>& parts) const;
  std::span<const Point2> contour(std::uint32_t piece) const {
    return std::span(points_).subspan(contours_[piece][0], contours_[piece][1] - contours_[piece][0]);
  }
  bool disjoint_pieces(std::uint32_t p, std::uint32_t q) const;
  bool disjoint_silhouettes(const Element& e, const Element& f) const;
  bool disjoint_outlines(const Extents& e, std::span<const Point2> p, const Extents& f, std::span<const Point2> q) const;

  const View& view_;
  const ProjectedScene& scene_;
  ModelPieces pieces_;
  std::shared_ptr<const FaceFacts> facts_;  ///< shared with the copies of lists
  std::vector<BodyElement> whole_;
  std::size_t face_count_ = 0;
  ClipVolume volume_;
  Viewpoint viewpoint_;
  PagePlanes page_planes_;
  std::vector<std::uint8_t> shown_;
  std::vector<Element> elements_;
  std::vector<Point3> element_corners_;  ///< corners of all elements in one array, since the tests read them most
  std::size_t in_order_ = 0;
  std::vector<Extents> piece_extents_;
  std::vector<std::array<std::size_t, 2>> contours_;  ///< per piece: range in points_
  std::vector<Point2> points_;                        ///< page mm, in positive orientation
  std::vector<HomogeneousPoint> corners_;             ///< scratch: corners of a piece under projection
  std::vector<std::uint32_t> copied_pieces_;          ///< copies of lists only: numbers of the pieces in the whole, rising
  std::size_t copied_points_ = 0;                     ///< copies of lists only: points of contours before the first cut
};

}  // namespace ligne::newell
