#pragma once
/// What the oracle keeps, and how it judges a line.

#include "oracle/line.hpp"

namespace oracle {

/// A part of a line, from tau0 to tau1.
struct Part {
  double tau0 = 0, tau1 = 1;
  Answer answer = Answer::undecided;
  bool exactly_hidden = false;
};

/// An intersection with its line, exact.
struct CrossingLine {
  PagePoint a, b;
  std::vector<std::uint32_t> own_faces;  ///< which do not hide it
};

/// The part from t0 to t1 of a segment of the model.
struct LineInView {
  double t0, t1;
  Line line;
};

struct Oracle::State {
  State(const ligne::Scene& scene, const View& view, double crease_degrees, Glass glass);

  View view;
  Projection projection;
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<Intersection> intersections;
  std::vector<CrossingLine> crossings;  ///< parallel to intersections
  double touch_distance;                ///< 2^-44 of the scene's size, model units
  double input_error_mm;                ///< error of the input's coordinates on the page, at the target

  /// The largest depth, in units of PagePoint, by which face and line may be off for all that is known.
  double delta(const Face& face, const Line& line) const;
  bool lies_in_plane(const Vector3& p, const Face& face) const;

  /// The part of the segment inside the window and before the near plane, as parameters in model space.
  std::optional<std::array<double, 2>> part_in_view(const Vector3& a, const Vector3& b) const;
  /// The same as a line; nothing when it is seen end on.
  std::optional<LineInView> line_in_view(const Vector3& a, const Vector3& b) const;

  /// The visibility of the line from model point a to b; `own_faces` do not hide it. Parts follow each other from 0 to 1.
  std::vector<Part> judge(const Line& line, const Vector3& a, const Vector3& b,
                          std::span<const std::uint32_t> own_faces) const;

  void find_intersections();  ///< intersections.cpp
};

}  // namespace oracle
