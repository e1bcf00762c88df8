#pragma once
/// Convex pieces of faces in model space, and planes that cut them.
///
/// A plane is its coefficients: a unit normal and a point, as doubles. Any plane may divide a set, so nothing is asked of it
/// but that the sides found are right. Which side a point lies on is a comparison of its height over the plane with
/// `tolerance`, a bound of what rounding makes of heights and of the corners of cuts: within that it is on the plane. So a
/// cut never contradicts itself: what was found in front of a plane stays there or on it, whatever is cut from it later.
/// Two pieces that a plane separates hide each other the wrong way round by no more than two tolerances, which is far below
/// the depth tolerance of surfaces that touch (docs/numerics.md).

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "geometry/point.hpp"
#include "scene/model/topology.hpp"

namespace ligne {

class ByteReader;
class ByteWriter;

struct ModelPlane {
  Point3 normal{0, 0, 1};  ///< unit vector
  Point3 point{0, 0, 0};

  double height(const Point3& p) const {
    return (p.x - point.x) * normal.x + (p.y - point.y) * normal.y + (p.z - point.z) * normal.z;
  }
  bool is_finite() const {
    return std::isfinite(normal.x + normal.y + normal.z) && std::isfinite(point.x + point.y + point.z);
  }
};

/// The plane through three points. The normal is right to a few units in the last place however thin the triangle; zero when
/// the points are in a line.
ModelPlane plane_through(const Point3& a, const Point3& b, const Point3& c);

/// From where a model is seen: an eye, or one at infinity.
struct Viewpoint {
  Point3 eye{0, 0, 0};
  Point3 to_eye{0, 0, 1};  ///< parallel projection: against the line of sight
  bool perspective = false;

  /// Whether the viewer is on the side to which the normal points, or in the plane.
  bool in_front_of(const ModelPlane& plane) const {
    return (perspective ? plane.height(eye) : glm::dot(plane.normal, to_eye)) >= 0;
  }
};

struct ModelPiece {
  std::uint32_t begin = 0, end = 0;  ///< its corners
  std::uint32_t triangle = 0;        ///< of which it is a piece
};

enum class PlaneSide : std::uint8_t { on, front, back, both };

/// The triangles of a scene and the pieces that were cut from them.
class ModelPieces {
 public:
  /// Triangles without area are left out.
  explicit ModelPieces(const Scene& scene);
  /// Those of that scene that were written. Throws InputError.
  ModelPieces(ByteReader& bytes, const Scene& scene);
  void write(ByteWriter& bytes) const;

  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<ModelPiece>& pieces() const { return pieces_; }
  std::uint32_t face(std::uint32_t piece) const { return triangles_[pieces_[piece].triangle].face; }
  std::span<const std::uint32_t> corners(std::uint32_t piece) const {
    return std::span(corners_).subspan(pieces_[piece].begin, pieces_[piece].end - pieces_[piece].begin);
  }
  const Point3& point(std::uint32_t corner) const { return points_[corner]; }
  double tolerance() const { return tolerance_; }
  /// The plane of the triangle of which it is a piece.
  ModelPlane plane_of(std::uint32_t piece) const { return plane_of_triangle(pieces_[piece].triangle); }
  /// Without a normal where the triangle has no area.
  ModelPlane plane_of_triangle(std::uint32_t triangle) const {
    return {normals_[triangle], points_[triangles_[triangle].v[0]]};
  }

  PlaneSide side(std::uint32_t piece, const ModelPlane& plane) const;
  /// The side of a range of heights: it may begin on or below the plane and end on or above it.
  PlaneSide side_of_heights(double low, double high) const {
    const bool front = high > tolerance_, back = low < -tolerance_;
    return front && back ? PlaneSide::both : front ? PlaneSide::front : back ? PlaneSide::back : PlaneSide::on;
  }

  /// Cuts a piece that lies on both sides into the piece in front, which takes its number, and the piece behind, whose
  /// number is returned. Neighbours with a common side get the same corner on it.
  std::uint32_t cut(std::uint32_t piece, const ModelPlane& plane);

 private:
  void find_planes();
  std::uint32_t crossing(std::uint32_t a, std::uint32_t b, const ModelPlane& plane);

  std::vector<Triangle> triangles_;
  std::vector<Point3> normals_;  ///< of the triangles
  std::vector<Point3> points_;
  std::vector<std::uint32_t> corners_;
  std::vector<ModelPiece> pieces_;
  std::size_t vertices_ = 0;  ///< of the scene; the points behind them are corners of cuts
  double tolerance_ = 0;
  std::vector<std::uint32_t> front_, back_;  ///< corners, while a piece is cut
};

}  // namespace ligne
