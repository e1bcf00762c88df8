#pragma once
/// A convex contour clipped by a convex contour, exactly.
///
/// After [Boulle1980] 3.2.3.1, whose codes have one bit for each side of a convex contour, and 3.2.3.4 (figure 3.31): two
/// convex contours have a convex intersection, and a part outside is convex where one side alone of the clip contour cuts
/// it off. A convex contour is the intersection of the half planes on the left of its edges. The code of a corner tells on
/// which side of each edge of the other contour it lies. So a pair of contours takes one sign for each corner and edge, and
/// most pairs that lie apart are known after the corners of one have been coded for a few edges of the other.
///
/// Corners are the ends of runs on source segments, as in contour_face.hpp, and all signs are exact.

#include <cstdint>
#include <vector>

#include "geometry/polygons/contour_face.hpp"

namespace ligne {

/// Whether the face is one contour without holes that only turns positively or goes straight on, and whose edges end
/// exactly where the next ones begin. Exact.
bool is_convex(const ContourFace& face);

/// Position of a convex subject relative to a convex clip contour.
enum class ConvexMeeting : std::uint8_t {
  apart,   ///< no inner points in common
  within,  ///< the subject lies in the clip contour
  cut,     ///< a part of the subject lies inside, and a part outside
  thin     ///< a part is too thin for the fine lattice: clip_contour_by_contour() decides whether it is left out
};

/// Clips one pair of contours after the other. It keeps its working memory from pair to pair.
class ConvexClip {
 public:
  /// Compares two convex contours. With `cut`, inside() and outside() hold the parts. Time: the product of the numbers of
  /// edges.
  ConvexMeeting meet(const EdgeLoop& subject, const EdgeLoop& clip);

  /// The part inside as a convex contour, and the faces outside. Each is marked as convex where one side of the clip
  /// contour cuts it off. The faces cover the same points as those of clip_contour_by_contour(), with the same corners.
  const EdgeLoop& inside() const { return inside_; }
  std::vector<ContourFace>& outside() { return outside_; }

  /// Signs of corners against edges, since the beginning.
  std::uint64_t signs() const { return signs_; }
  /// Pairs whose outside was linked from its edges because the contours touch, since the beginning.
  std::uint64_t linked() const { return linked_; }

 private:
  /// Per corner of one contour, the side of each edge of the other: 1 inside, 0 on the line, -1 outside.
  struct Codes {
    std::vector<std::int8_t> sides;
    std::size_t width = 0;
    const std::int8_t* of(std::size_t corner) const { return &sides[corner * width]; }
  };
  enum class Origin : std::uint8_t { subject_inside, subject_outside, clip };
  /// A part of the subject's contour, or of the clip contour inside the subject.
  struct Part {
    ContourEdge edge;
    std::uint32_t number = 0;  ///< index in subject_parts_, or of the edge of the clip contour
    Origin origin = Origin::clip;
  };

  bool code(const EdgeLoop& corners, const EdgeLoop& edges, Codes& codes);
  void divide_subject(const EdgeLoop& subject, const EdgeLoop& clip);
  void find_clip_parts(const EdgeLoop& subject, const EdgeLoop& clip);
  void find_inside();
  bool touches(const Part& clip_part) const;
  bool find_outside();
  void link_outside();

  Codes subject_codes_, clip_codes_;
  std::vector<Part> subject_parts_;  ///< in the order of the contour
  std::vector<Part> clip_parts_;     ///< in the order of the contour
  std::vector<Part> round_;          ///< the contour of the intersection
  EdgeLoop inside_;
  std::vector<ContourFace> outside_;
  std::uint64_t signs_ = 0, linked_ = 0;
};

}  // namespace ligne
