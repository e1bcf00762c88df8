#pragma once
/// Convex pieces of faces in model space, and planes that cut them.
///
/// A plane is a unit normal and a point, as doubles. Any plane may divide a set; only the side found for each point matters.
/// A point within `tolerance` of the plane counts as on it. The tolerance bounds the rounding of heights and of the corners
/// of cuts, so cuts never contradict each other: a point found in front of a plane stays in front of it or on it after later
/// cuts. Two pieces separated by a plane are ordered wrongly by at most two tolerances, far below the depth tolerance of
/// touching surfaces (docs/numerics.md).

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "base/hash.hpp"
#include "base/no_index.hpp"
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

/// The plane through three points. The normal is accurate to a few units in the last place even for slivers; zero if the
/// points are collinear.
ModelPlane plane_through(const Point3& a, const Point3& b, const Point3& c);

/// The viewpoint of a model: an eye point, or a direction for parallel projection.
struct Viewpoint {
  Point3 eye{0, 0, 0};
  Point3 to_eye{0, 0, 1};  ///< parallel projection: opposite of the view direction
  bool perspective = false;

  /// True if the viewer is on the side to which the normal points, or in the plane.
  bool in_front_of(const ModelPlane& plane) const {
    return (perspective ? plane.height(eye) : glm::dot(plane.normal, to_eye)) >= 0;
  }
};

struct ModelPiece {
  std::uint32_t begin = 0, end = 0;  ///< corners of the piece
  std::uint32_t triangle = 0;        ///< triangle that contains the piece
};

enum class PlaneSide : std::uint8_t { on, front, back, both };

/// The triangles of a scene, and the pieces cut from them.
class ModelPieces {
 public:
  /// Omits triangles without area.
  explicit ModelPieces(const Scene& scene);
  /// Reads the pieces that write() wrote for that scene. Throws InputError.
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
  /// The plane of the triangle that contains the piece.
  ModelPlane plane_of(std::uint32_t piece) const { return plane_of_triangle(pieces_[piece].triangle); }
  /// The normal is zero if the triangle has no area.
  ModelPlane plane_of_triangle(std::uint32_t triangle) const {
    return {normals_[triangle], points_[triangles_[triangle].v[0]]};
  }

  PlaneSide side(std::uint32_t piece, const ModelPlane& plane) const;
  /// The side of a piece whose heights span [low, high].
  PlaneSide side_of_heights(double low, double high) const {
    const bool front = high > tolerance_, back = low < -tolerance_;
    return front && back ? PlaneSide::both : front ? PlaneSide::front : back ? PlaneSide::back : PlaneSide::on;
  }

  /// Cuts a piece that lies on both sides. The front part keeps the number; returns the number of the back part. Adjacent
  /// pieces get one common corner on their common side.
  std::uint32_t cut(std::uint32_t piece, const ModelPlane& plane);

  /// Copies pieces into a set of their own, numbered in the given order, which another thread may cut. Corners keep their
  /// order, so cuts give the same corners, bit for bit, as in this set. O(n log n).
  ModelPieces extract(std::span<const std::uint32_t> pieces) const;
  /// Takes over the cuts of the set that extract(pieces) gave. Returns the number here of each piece of that set.
  std::vector<std::uint32_t> take_over(const ModelPieces& extracted, std::span<const std::uint32_t> pieces);

 private:
  ModelPieces() = default;
  void find_planes();
  std::uint32_t crossing(std::uint32_t a, std::uint32_t b, const ModelPlane& plane);

  std::vector<Triangle> triangles_;
  std::vector<Point3> normals_;  ///< by triangle
  std::vector<Point3> points_;
  std::vector<std::uint32_t> corners_;
  std::vector<ModelPiece> pieces_;
  std::size_t vertices_ = 0;  ///< vertices of the scene; later points are corners of cuts
  /// Extracted pieces only: by point, its number in the other set. Then vertices_ counts these points.
  std::vector<std::uint32_t> origins_;
  std::size_t uncut_corners_ = 0;  ///< extracted pieces only: corners before the first cut
  double tolerance_ = 0;
  std::vector<std::uint32_t> front_, back_;  ///< scratch: corners of the parts of a cut
};

struct DividingPlane {
  ModelPlane plane;
  std::uint32_t face = kNone;  ///< face in this plane; kNone: none
};

struct PlaneChoice {
  unsigned candidates = 5;  ///< faces tried, chosen at random
  /// Sets of many pieces may also be divided by planes of no face. With face planes alone the BSP tree of a convex body of n
  /// faces has depth n.
  bool free_planes = true;
};

/// Divides a non-empty set. Equal seeds give equal choices.
DividingPlane choose_plane(const ModelPieces& pieces, std::span<const std::uint32_t> set, const PlaneChoice& choice,
                           std::uint64_t seed);

/// A pseudo-random number from another number.
inline std::uint64_t scramble(std::uint64_t x) { return mix_bits(x + kGoldenRatio); }

}  // namespace ligne
