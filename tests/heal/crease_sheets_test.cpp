/// Creases where more than two faces meet, and where faces are too thin to have a normal of their own.

#include "heal/found_creases.hpp"
#include "scene/creases/face_normals.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

using test::find;
using test::read;
using test::rounded_ridge;

TEST(Creases, ASliverTakesTheNormalOfItsNeighbour) {
  // A flat square with a triangle of no height along its diagonal, off the plane by the rounding of its writer.
  const std::string text =
      "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 5.000000 5.000000 0.000001\nf 1 2 3\nf 1 3 5\nf 1 5 4\nf 5 3 4\n";
  Scene scene = read(text, ModelFormat::obj);
  EXPECT_GT(scene.objects[0].precision, 1e-7);
  EXPECT_EQ(find(scene).count(), 0u);
  for (const auto& normal : face_normals(scene, build_topology(scene))) EXPECT_NEAR(normal.z, 1, 1e-6);
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
