#pragma once
/// The elements of the priority list: faces, and pieces of faces that were cut, with what the tests ask of them.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "view/clip.hpp"
#include "view/projected_scene.hpp"
#include "visibility/newell/body_elements.hpp"
#include "visibility/newell/convex_bodies.hpp"
#include "visibility/newell/element.hpp"
#include "visibility/order/model_pieces.hpp"
#include "visibility/order/paint_pieces.hpp"

namespace ligne::newell {

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
  /// `whole_bodies`: each convex body is one element until it is opened; without an earlier view only.
  explicit PaintElements(const ProjectedScene& scene, const EarlierElements* earlier = nullptr, bool whole_bodies = false);
  std::size_t in_order() const { return in_order_; }  ///< so many come from the earlier list

  std::size_t size() const { return elements_.size(); }
  std::size_t face_count() const { return face_count_; }  ///< faces in view at the beginning
  std::size_t whole_bodies() const { return whole_.size(); }
  const Element& operator[](std::uint32_t i) const { return elements_[i]; }
  const ModelPieces& pieces() const { return pieces_; }

  const ConvexBodies& bodies() const { return bodies_; }
  /// That the first does not hide the second is known without a comparison: they are of one face, whose pieces lie in one
  /// plane, or of one convex body.
  bool never_hides(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t f = elements_[a].face, g = elements_[b].face;
    return f == g || bodies_.never_hides(f, g) || separated(f, g);
  }
  /// Whether the first face lies behind the second by a separating plane of the scene.
  bool separated(std::uint32_t face, std::uint32_t other) const { return !cells_.empty() && cells_[face] < cells_[other]; }
  /// The place of an element in the order that separating planes give: lower numbers are painted first.
  std::uint32_t cell(std::uint32_t element) const { return cells_.empty() ? 0 : cells_[elements_[element].face]; }

  /// Whether it is known that not each of the two hides the other: parts of convex faces that do not penetrate.
  bool hide_one_way(std::uint32_t a, std::uint32_t b) const {
    if (is_convex_.empty() || is_body(a) || is_body(b)) return false;  // a body may be inside another
    return is_convex_[elements_[a].face] && is_convex_[elements_[b].face];
  }

  /// Whether an element is a convex body that was not opened.
  bool is_body(std::uint32_t element) const { return elements_[element].body != kNone; }
  /// Puts the faces of a body in its place. Returns their numbers, the back faces first.
  std::vector<std::uint32_t> open(std::uint32_t body);

  /// Whether the plane of `of` shows that the element lies wholly behind it. A body has a plane for each back face.
  bool lies_behind(std::uint32_t element, std::uint32_t of) const;
  /// Whether the plane of `of` shows that the element lies wholly before it. A body has a plane for each front face.
  bool lies_before(std::uint32_t element, std::uint32_t of) const;

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
  void make_whole_bodies();
  void find_convex_faces();
  PlaneSide side(std::uint32_t element, const ModelPlane& plane) const;
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
  struct Outline {
    const Extents* extents;
    std::span<const Point2> contour;  ///< convex
  };
  /// The contour of a piece; of a body its only one, the silhouette.
  Outline outline(const Element& element, std::size_t part) const;
  std::size_t outline_count(const Element& element) const { return element.body == kNone ? element.parts.size() : 1; }
  bool disjoint_outlines(const Outline& p, const Outline& q) const;

  const View& view_;
  const ProjectedScene& scene_;
  ModelPieces pieces_;
  ConvexBodies bodies_;
  std::vector<std::uint32_t> cells_;     ///< per face, or empty
  std::vector<std::uint8_t> is_convex_;  ///< per face, or empty where faces may penetrate
  std::vector<BodyElement> whole_;
  std::size_t face_count_ = 0;
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
