#pragma once
/// Benchmark inputs: shapes and the two file formats in which they are written. Standard library only, and no function of
/// the mathematics library but the square root, which IEEE 754 rounds correctly: the bytes are the same everywhere.

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace ligne::bench {

using Vec3 = std::array<double, 3>;
using Corner3 = std::array<std::uint32_t, 3>;

/// A triangle mesh, wound counter-clockwise seen from outside.
struct TriangleMesh {
  std::vector<Vec3> positions;
  std::vector<Corner3> triangles;
};

/// A linear map and a shift: x -> rows * x + shift.
struct Placement {
  std::array<Vec3, 3> rows{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 shift{0, 0, 0};

  Vec3 operator()(const Vec3& p) const;
};

/// SplitMix64 (Steele, Lea, Flood 2014).
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next();
  /// In [from, to), a multiple of 2^-53 of the range.
  double uniform(double from, double to);

 private:
  std::uint64_t state_;
};

/// The rotation of a quaternion (w, x, y, z), which need not be of length one.
Placement rotation(double w, double x, double y, double z);

/// Wavefront OBJ: "v" and "f" lines; polygons become fans. Throws std::runtime_error with one line.
TriangleMesh read_obj(const std::filesystem::path& file);

/// Splits every triangle in four by the rules of Loop (1987), with the weights of Warren (1995) for inner vertices and the
/// cubic B-spline rules along borders; edges with more than two faces are held like borders, their ends in place.
TriangleMesh subdivide(const TriangleMesh& mesh);

/// A tube along the (2, 3) torus knot: 2^(log2_along + log2_around + 1) triangles, closed.
TriangleMesh torus_knot(int log2_along, int log2_around);

/// The cube [-1/2, 1/2]^3 of 12 triangles; vertex v has coordinate +1/2 along axis k when bit k of v is set.
TriangleMesh unit_cube();

/// The six faces of unit_cube() as quadrilaterals.
extern const std::array<std::array<std::uint32_t, 4>, 6> kCubeFaces;

/// `n` boxes with centres in the unit cube, turned at random, sides between 1/2 and 3/2 of `side`: placements of
/// unit_cube().
std::vector<Placement> random_boxes(std::size_t n, double side, std::uint64_t seed);

/// Number of pairs of triangles of different boxes that have a segment in common.
std::size_t count_crossing_triangles(const std::vector<Placement>& boxes);

/// A cube for ligne-scene files: eight corners in the order of unit_cube().
using CubeCorners = std::array<Vec3, 8>;

/// n^3 unit cubes, touching face to face, in [0, n]^3.
std::vector<CubeCorners> cube_block(int n);
/// The block turned: every corner of the lattice turned once, so that touching cubes have equal corners.
std::vector<CubeCorners> turned_block_shared(int n, const Placement& turn);
/// The block turned: each cube by its turned centre and half diagonals, so that corners that should be equal differ by
/// rounding.
std::vector<CubeCorners> turned_block_rounded(int n, const Placement& turn);

/// Binary glTF 2.0: one mesh (float32 positions, u16 or u32 indices), one node for each placement, or one plain node when
/// there are none. Placements are rounded to float32. Throws std::runtime_error.
void write_glb(const std::filesystem::path& file, const TriangleMesh& mesh, const std::vector<Placement>& placements = {});

/// ligne-scene JSON, one object a cube; numbers are the shortest that read back as the same double.
void write_cube_scene(const std::filesystem::path& file, const std::vector<CubeCorners>& cubes);

}  // namespace ligne::bench
