#pragma once
/// Free-form surfaces of OBJ files: Bezier and B-spline patches, including rational ones.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.hpp"
#include "scene/model/diagnostics.hpp"

namespace ligne {

/// A vertex with the weight of its control point.
struct ObjControlPoint {
  Point3 position{0};
  double weight = 1;
};

/// A patch as in the file: control points, with u varying fastest, and the knots of both directions.
struct ObjPatch {
  std::array<std::size_t, 2> degree{};
  std::array<std::vector<double>, 2> knots;
  std::array<double, 2> from{}, to{};  ///< the part that is drawn
  std::vector<std::size_t> control;    ///< indices of vertices, from 0
  bool is_rational = false;

  std::size_t control_count(std::size_t axis) const { return knots[axis].size() - degree[axis] - 1; }
};

/// Collects the statements from `surf` to `end`.
class ObjSurfaces {
 public:
  explicit ObjSurfaces(Warnings& warnings) : warnings_(warnings) {}

  /// Reads a statement of free-form geometry; false for others. `vertex_count` is the number of vertices so far. Sets
  /// `cause` to a phrase if the statement is wrong.
  bool take(std::string_view keyword, std::string_view rest, std::size_t vertex_count, std::string& cause);

  /// Returns the patch that the last `end` closed, only once.
  std::optional<ObjPatch> closed();

 private:
  enum class Basis { bezier, bspline, other };
  void begin_surface(std::string_view rest, std::size_t vertex_count, std::string& cause);
  void end_surface(std::string& cause);

  Warnings& warnings_;
  Basis basis_ = Basis::other;
  std::string basis_name_ = "none";
  bool is_rational_ = false, is_open_ = false;
  std::array<std::size_t, 2> degree_{};
  ObjPatch patch_;
  std::optional<ObjPatch> closed_;
};

/// Points on a patch with its control points, u varying fastest. Every knot span is cut into 12 pieces in a curved
/// direction, and not cut in a straight one.
struct PatchGrid {
  std::size_t columns = 0, rows = 0;
  std::vector<Point3> points;
};
PatchGrid sample_patch(const ObjPatch& patch, const std::vector<ObjControlPoint>& control);

}  // namespace ligne
