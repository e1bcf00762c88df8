/// Creases where more than two faces meet, and where faces are too thin to have a normal of their own.

#include "drawn_lengths.hpp"
#include "heal/found_creases.hpp"
#include "scene/creases/face_normals.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using test::find;
using test::read;
using test::rounded_ridge;

TEST(Creases, SheetsThatCrossWithoutABendHaveNone) {
  const std::string four = "v 0 0 0\nv 0 1 0\nv -1 0 0\nv -1 1 0\nv 1 0 0\nv 1 1 0\nv 2 0 0\nv 2 1 0\nv 0 0 1\nv 0 1 1\n";
  // Two coplanar sheets that overlap along an edge, and with a wall on it.
  const std::string flat = four + "f 3 1 2 4\nf 1 5 6 2\nf 1 7 8 2\n";
  EXPECT_EQ(find(read(flat, ModelFormat::obj)).count(), 0u);
  EXPECT_EQ(find(read(flat, ModelFormat::obj)).creases.straight_sheets, 1u);
  EXPECT_EQ(find(read(flat + "f 1 9 10 2\n", ModelFormat::obj)).count(), 1u);
}

TEST(Creases, SheetsThatAllEndAtAnEdgeHaveOne) {
  // Three nearly coplanar triangles on one side of the edge from 1 to 2, as where thin walls end.
  const std::string ends = "v 0 0 0\nv 1 0 0\nv 0.2 1 0\nv 0.5 1 0.1\nv 0.8 1 -0.1\nf 1 2 3\nf 1 2 4\nf 2 1 5\n";
  const Found found = find(read(ends, ModelFormat::obj));
  EXPECT_EQ(found.count(), 1u);
  EXPECT_EQ(found.creases.straight_sheets, 0u);
}

TEST(Creases, ASliverTakesTheNormalOfItsNeighbour) {
  // A flat square with a triangle of no height along its diagonal, off the plane by the rounding of its writer.
  const std::string text =
      "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 5.000000 5.000000 0.000001\nf 1 2 3\nf 1 3 5\nf 1 5 4\nf 5 3 4\n";
  Scene scene = read(text, ModelFormat::obj);
  EXPECT_GT(scene.objects[0].precision, 1e-7);
  EXPECT_EQ(find(scene).count(), 0u);
  for (const auto& normal : face_normals(scene, build_topology(scene))) EXPECT_NEAR(normal.z, 1, 1e-6);
}

/// A slab of 4 x 2 x 1 in two halves, as polygons, with a wall between them inside, given as faces of the vertices 2 and 3
/// of the seam on top and 6 and 7 at the bottom.
std::string slab_with(const std::string& walls) {
  return "v 0 0 1\nv 2 0 1\nv 2 2 1\nv 0 2 1\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 4 0 1\nv 4 2 1\nv 4 0 0\nv 4 2 0\n"
         "f 1 2 3 4\nf 2 9 10 3\nf 5 8 7 6\nf 6 7 12 11\nf 1 5 6 2\nf 2 6 11 9\nf 3 7 8 4\nf 10 12 7 3\n"
         "f 4 8 5 1\nf 9 11 12 10\n" +
         walls;
}

TEST(Creases, AWallInsideABodyIsSeenFromItsSideAlone) {
  // The slab has 16 edges of its own; a wall adds a frame of four, which stand on faces that run on past it.
  for (const char* wall : {"f 2 3 7 6\n", "f 2 6 7 3\n"}) {
    const auto found = find(read(slab_with(wall), ModelFormat::obj));
    EXPECT_EQ(found.count(), 20u);
    ASSERT_EQ(found.creases.walls.size(), 4u);
    const Point3 middle(2, 1, 0.5);
    for (const WallEdge& edge : found.creases.walls) {
      const Edge& ends = found.topology.edges[edge.edge];
      const Point3 at = 0.5 * (found.scene.vertices[ends.v0] + found.scene.vertices[ends.v1]);
      EXPECT_GT(glm::dot(edge.side, middle - at), 0.49);
    }
  }
  // The sides of two bodies that touch lie on each other: there is a joint between the bodies.
  const auto touching = find(read(slab_with("f 2 3 7 6\nf 2 6 7 3\n"), ModelFormat::obj));
  EXPECT_EQ(touching.count(), 20u);
  EXPECT_TRUE(touching.creases.walls.empty());
}

/// An open tube of 16 sides as an OBJ file, its sides cut along one diagonal, and with `twice` along the other one too.
std::string tube(bool twice) {
  std::ostringstream obj;
  for (int i = 0; i < 16; ++i) {
    const double angle = 2 * std::numbers::pi * i / 16;
    for (const int z : {0, 4}) obj << "v " << std::cos(angle) << " " << std::sin(angle) << " " << z << "\n";
  }
  for (int i = 0; i < 16; ++i) {
    const int a = 2 * i + 1, d = a + 1, b = 2 * ((i + 1) % 16) + 1, c = b + 1;
    obj << "f " << a << " " << b << " " << c << "\nf " << a << " " << c << " " << d << "\n";
    if (twice) obj << "f " << a << " " << b << " " << d << "\nf " << b << " " << c << " " << d << "\n";
  }
  return obj.str();
}

TEST(Creases, DoubledSheetsHaveTheOutlineOfOne) {
  const auto drawn = [](bool twice) {
    PictureRequest request;
    request.view.up_axis = Axis::z;
    return test::length_of_all(test::drawn_lengths(read(tube(twice), ModelFormat::obj), request));
  };
  EXPECT_GT(drawn(false), 100);
  EXPECT_NEAR(drawn(true), drawn(false), 0.1);
}

TEST(Creases, WhereAllFacesAreThinnerThanThePrecisionTheirNormalsCount) {
  // Northings of six digits, in steps of the last of them: each triangle is as high as what its writer rounded away.
  std::ostringstream obj;
  const int n = 12;
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= n; ++k) {
      const double height = 6 * std::exp(-(i - 6) * (i - 6) / 20.0 - (k - 6) * (k - 6) / 20.0);
      obj << "v " << 581311 + 10 * k << ' ' << 4.78527 + 0.00001 * i << "e+06 " << height << '\n';
    }
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const int v = i * (n + 1) + k + 1, up = v + n + 1;
      obj << "f " << v << ' ' << v + 1 << ' ' << up + 1 << "\nf " << v << ' ' << up + 1 << ' ' << up << '\n';
    }
  const Scene scene = read(obj.str(), ModelFormat::obj);
  ASSERT_GT(scene.objects[0].precision, 1);
  EXPECT_EQ(find(scene).count(), 0u);
}

TEST(Creases, AStrayTriangleDoesNotSpoilAScan) {
  Scene clean = rounded_ridge(40, 0.3, 0.15), with_fin = clean;
  const auto& corners = with_fin.faces.contour(100, 0);
  const std::uint32_t a = corners[0], b = corners[1];
  with_fin.vertices.push_back(with_fin.vertices[a] + Point3(0, 0, 3));
  with_fin.faces.add_face(std::vector<std::uint32_t>{a, b, static_cast<std::uint32_t>(with_fin.vertices.size() - 1)});
  with_fin.objects[0].vertex_end += 1;
  with_fin.objects[0].face_end += 1;
  const auto found = find(with_fin);
  EXPECT_EQ(found.creases.scans.size(), 1u);
  EXPECT_NEAR(double(found.count()), double(find(clean).count()), 3);
}

}  // namespace
}  // namespace ligne
