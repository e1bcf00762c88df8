/// Creases by what the file says, and by what the mesh shows.

#include "scene/creases/face_normals.hpp"
#include "scene/creases/file_shading.hpp"
#include "scene/creases/find_creases.hpp"
#include "scene/readers/reader.hpp"
#include "support/mesh_script.hpp"
#include "support/standard.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

Scene read(const std::string& text, ModelFormat format, bool shading = true) {
  Warnings warnings;
  return read_scene({std::as_bytes(std::span(text)), "model"}, format, {.shading = shading}, warnings);
}

struct Found {
  Scene scene;
  Topology topology;
  Creases creases;
  std::size_t count() const { return std::accumulate(creases.lines.begin(), creases.lines.end(), std::size_t{0}); }
};

Found find(Scene scene, double degrees = 30, double surface_degrees = kSurfaceCreaseDegrees) {
  Found found{std::move(scene), {}, {}};
  found.topology = build_topology(found.scene);
  found.creases = find_creases(found.scene, found.topology, {degrees, surface_degrees});
  return found;
}

/// The faces of rows of n + 1 vertices, of which every other row is shifted by half a step.
void write_triangles(std::ostream& obj, int n) {
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const int v = i * (n + 1) + k + 1, up = v + n + 1;
      if (i % 2 == 0) obj << "f " << v << ' ' << v + 1 << ' ' << up << "\nf " << v + 1 << ' ' << up + 1 << ' ' << up << '\n';
      if (i % 2 == 1) obj << "f " << v << ' ' << v + 1 << ' ' << up + 1 << "\nf " << v << ' ' << up + 1 << ' ' << up << '\n';
    }
}

/// A steep ridge, rounded over about `round`, that runs across an uneven mesh of triangles with edges of about 1; `turned`
/// radians from the direction to which the triangles are perpendicular. Its heights are noisy.
Scene rounded_ridge(int n, double round, double turned, double rough = 0.3) {
  std::ostringstream obj;
  std::uint32_t state = 7;
  const auto noise = [&] {
    state = state * 1664525u + 1013904223u;
    return (state >> 8) / 16777216.0 - 0.5;
  };
  for (int i = 0; i <= n; ++i)
    for (int k = 0; k <= n; ++k) {
      const double x = k - n / 2.0 + (i % 2) * 0.5 + 0.25 * noise(), y = (i - n / 2.0) * 0.866 + 0.25 * noise();
      const double across = x * std::cos(turned) + y * std::sin(turned);
      obj << "v " << x << ' ' << y << ' ' << rough * noise() - 2 * std::sqrt(across * across + round * round) << '\n';
    }
  write_triangles(obj, n);
  return read(obj.str(), ModelFormat::obj);
}

// Creases by what the file says, and by what the mesh shows.

enum class Shading { none, smooth, averaged, flat, groups, one_group };

/// An upright prism of `sides` quadrilaterals between two caps, as OBJ.
std::string prism(int sides, Shading shading) {
  std::ostringstream obj;
  const auto angle = [&](double i) { return 2 * std::numbers::pi * i / sides; };
  for (int z = 0; z < 2; ++z)
    for (int i = 0; i < sides; ++i) obj << "v " << std::cos(angle(i)) << ' ' << std::sin(angle(i)) << ' ' << 2 * z << '\n';
  // Normals: of the sides at their corners, of the sides in their middles, of the caps, averaged over all faces.
  for (int i = 0; i < sides; ++i) obj << "vn " << std::cos(angle(i)) << ' ' << std::sin(angle(i)) << " 0\n";
  for (int i = 0; i < sides; ++i) obj << "vn " << std::cos(angle(i + 0.5)) << ' ' << std::sin(angle(i + 0.5)) << " 0\n";
  obj << "vn 0 0 -1\nvn 0 0 1\n";
  for (int z = 0; z < 2; ++z)
    for (int i = 0; i < sides; ++i)
      obj << "vn " << std::cos(angle(i)) << ' ' << std::sin(angle(i)) << ' ' << 2 * z - 1 << '\n';
  const auto corner = [&](int z, int i, int side) {
    i %= sides;
    const int normal = shading == Shading::averaged ? 2 * sides + 2 + z * sides + i
                       : side < 0                   ? 2 * sides + z
                       : shading == Shading::flat   ? sides + side
                                                    : i;
    obj << ' ' << z * sides + i + 1;
    const bool with_normals = shading == Shading::smooth || shading == Shading::flat || shading == Shading::averaged;
    if (with_normals) obj << "//" << normal + 1;
  };
  const bool groups = shading == Shading::groups || shading == Shading::one_group;
  if (groups) obj << "s 1\n";
  for (int i = 0; i < sides; ++i) {
    obj << 'f';
    corner(0, i, i), corner(0, i + 1, i), corner(1, i + 1, i), corner(1, i, i);
    obj << '\n';
  }
  if (shading == Shading::groups) obj << "s off\n";
  for (int z = 0; z < 2; ++z) {
    obj << 'f';
    for (int i = 0; i < sides; ++i) corner(z, z == 0 ? sides - i : i, -1);
    obj << '\n';
  }
  return obj.str();
}

std::size_t creases_of_prism(int sides, Shading shading) {
  return find(read(prism(sides, shading), ModelFormat::obj)).count();
}

TEST(Creases, NormalsAndGroupsMakeAPrismACylinder) {
  for (const Shading shading : {Shading::smooth, Shading::groups}) {
    EXPECT_EQ(creases_of_prism(8, shading), 16u) << "the rims of both caps alone";
    EXPECT_EQ(creases_of_prism(8, Shading::none), 24u);
  }
}

TEST(Creases, FlatShadingSaysNothing) {
  EXPECT_EQ(creases_of_prism(8, Shading::flat), 24u);
  EXPECT_EQ(creases_of_prism(16, Shading::flat), 32u) << "22.5 degrees: below the crease angle";
}

TEST(Creases, AveragedNormalsKeepCorners) {
  // One normal at every vertex, or one group for all, is no knowledge of the shape: bends of 45 and 90 degrees stay.
  for (const Shading shading : {Shading::averaged, Shading::one_group}) {
    EXPECT_EQ(creases_of_prism(8, shading), 24u);
    EXPECT_EQ(creases_of_prism(10, shading), 20u) << "36 degrees";
    EXPECT_EQ(creases_of_prism(4, shading), 12u);
  }
}

TEST(Creases, FileShadingIsReadWhereItIsAskedForAlone) {
  const Scene without = read(prism(8, Shading::groups), ModelFormat::obj, false);
  EXPECT_TRUE(without.corner_flags.empty());
}

std::string in_base64(std::span<const std::byte> bytes) {
  constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i + 2 < bytes.size(); i += 3) {
    const auto three = std::to_integer<unsigned>(bytes[i]) << 16 | std::to_integer<unsigned>(bytes[i + 1]) << 8 |
                       std::to_integer<unsigned>(bytes[i + 2]);
    for (const int shift : {18, 12, 6, 0}) text += kDigits[three >> shift & 63];
  }
  return text;
}

/// Two triangles that bend by 35 degrees, with one normal at their common vertices. `normal`: the accessor said to have it.
std::string bent_gltf(const std::string& normal) {
  const std::vector<float> numbers{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0.5f,  // positions
                                   0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};    // normals
  const std::vector<std::uint16_t> corners{0, 1, 2, 2, 1, 3};
  const std::span<const std::byte> data = std::as_bytes(std::span(numbers)), indices = std::as_bytes(std::span(corners));
  return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":108,"uri":"data:application/octet-stream;base64,)" +
         in_base64(data) + in_base64(indices) +
         R"("}],"bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":12}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},)"
         R"({"bufferView":0,"byteOffset":48,"componentType":5126,"count":4,"type":"VEC3"},)"
         R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":)" +
         normal + R"(},"indices":2}]}],"nodes":[{"mesh":0}]})";
}

TEST(Creases, GltfNormals) {
  const auto flags = [](const std::string& normal) { return read(bent_gltf(normal), ModelFormat::gltf).corner_flags; };
  EXPECT_EQ(std::ranges::count(flags("1"), kCornerSmooth), 2) << "both sides of the common edge";
  for (const char* broken : {"2", "3", "-1", "\"one\""}) {
    const std::vector<std::uint8_t> of_broken = flags(broken);
    EXPECT_EQ(std::ranges::count(of_broken, kCornerSmooth), 0) << broken << " is left out, not refused";
  }
}

/// A floor and a wall at an angle, with a rounding between them of that radius in two facets, all shaded smoothly; or, as a
/// channel, facets of the same kind on and on.
std::string rounded_corner(double degrees, double radius, int facets, bool sides) {
  std::ostringstream obj;
  const double turn = degrees / facets * std::numbers::pi / 180;
  const auto row = [&](double u, double v, double angle) {
    obj << "v " << u << " 0 " << v << "\nv " << u << " 3 " << v << '\n';
    for (int k = 0; k < 2; ++k) obj << "vn " << -std::sin(angle) << " 0 " << std::cos(angle) << '\n';
  };
  if (sides) row(0, 0, 0);
  for (int i = 0; i <= facets; ++i) row(1 + radius * std::sin(i * turn), radius * (1 - std::cos(i * turn)), i * turn);
  const double end = facets * turn;
  if (sides) row(1 + radius * std::sin(end) + std::cos(end), radius * (1 - std::cos(end)) + std::sin(end), end);
  for (int i = 1, rows = facets + (sides ? 3 : 1); i < rows; ++i) {
    const int a = 2 * i - 1;
    obj << 'f';
    for (const int v : {a, a + 2, a + 3, a + 1}) obj << ' ' << v << "//" << v;
    obj << '\n';
  }
  return obj.str();
}

TEST(Creases, ANarrowRoundingBetweenSidesIsDrawnAsTheEdgeInItsMiddle) {
  const auto count = [](const std::string& obj) { return find(read(obj, ModelFormat::obj)).count(); };
  EXPECT_EQ(count(rounded_corner(70, 0.025, 2, true)), 1u);
  EXPECT_EQ(count(rounded_corner(50, 0.04, 2, true)), 1u) << "though no edge of it bends by the angle";
  EXPECT_EQ(count(rounded_corner(70, 0.1, 2, true)), 0u) << "wide enough to be seen as a surface";
  EXPECT_EQ(count(rounded_corner(20, 0.04, 2, true)), 0u) << "the sides hardly bend";
  EXPECT_EQ(count(rounded_corner(210, 0.02, 6, false)), 0u) << "a rod has no sides";
}

TEST(Creases, PackedDirectionsAreRightToATenthOfADegree) {
  EXPECT_EQ(packed_direction({0, 0, 0}), 0u);
  for (int i = 0; i < 1000; ++i) {
    const Point3 direction{std::sin(i), std::cos(1.7 * i), std::sin(2.3 * i + 1)};
    const double length = std::hypot(direction.x, direction.y, direction.z);
    const Point3 back = glm::normalize(unpacked_direction(packed_direction(direction)));
    const double cosine = (direction.x * back.x + direction.y * back.y + direction.z * back.z) / length;
    EXPECT_LT(std::acos(std::min(1.0, cosine)) * 180 / std::numbers::pi, 0.15);
  }
}

/// Triangles all of whose edges are marked, and vertices at which more than two are.
std::pair<std::size_t, std::size_t> teeth(const Found& found, const std::vector<std::uint8_t>& marked) {
  std::map<std::uint32_t, std::size_t> at_face, at_vertex;
  for (std::size_t e = 0; e < marked.size(); ++e) {
    if (!marked[e]) continue;
    const Edge& edge = found.topology.edges[e];
    for (const std::uint32_t f : {edge.face0, edge.face1}) ++at_face[f];
    for (const std::uint32_t v : {edge.v0, edge.v1}) ++at_vertex[v];
  }
  const auto more_than_two = [](const auto& entry) { return entry.second > 2; };
  return {std::count_if(at_face.begin(), at_face.end(), more_than_two),
          std::count_if(at_vertex.begin(), at_vertex.end(), more_than_two)};
}

TEST(Creases, ARidgeOfAScanIsOneLineWithoutTeeth) {
  for (const double turned : {0.0, 0.15, 0.3}) {
    const Found found = find(rounded_ridge(40, 0.3, turned));
    // By the angle alone it is a ladder.
    const auto normals = face_normals(found.scene, found.topology);
    std::vector<std::uint8_t> by_angle;
    for (const Edge& edge : found.topology.edges) {
      const double cosine = edge.face1 == kNone ? 1 : glm::dot(normals[edge.face0], normals[edge.face1]);
      by_angle.push_back(cosine < std::cos(30 * std::numbers::pi / 180));
    }
    EXPECT_GT(teeth(found, by_angle).first, 15u) << turned;
    EXPECT_GT(teeth(found, by_angle).second, 30u) << turned;
    EXPECT_EQ(teeth(found, found.creases.lines).first, 0u) << turned;
    EXPECT_EQ(teeth(found, found.creases.lines).second, 0u) << turned;
    EXPECT_GT(found.creases.untraced, 30u) << turned;
    // No more edges than a line is long; and where the triangles let it be straight, there is one.
    EXPECT_LT(found.count(), 60u) << turned;
    if (turned == 0.3) {
      EXPECT_GT(found.count(), 15u);
    }
    for (std::size_t e = 0; e < found.topology.edges.size(); ++e) {
      if (!found.creases.lines[e]) continue;
      const Point3 v = found.scene.vertices[found.topology.edges[e].v0];
      EXPECT_LT(std::abs(v.x * std::cos(turned) + v.y * std::sin(turned)), 1.5) << turned;
    }
  }
}

TEST(Creases, ARidgeRoundOverManyTrianglesHasNone) { EXPECT_EQ(find(rounded_ridge(40, 12, 0.3)).count(), 0u); }

/// A ridge of height 12 and length `along`, rounded over about `round`, that runs out into a plane of triangles with edges
/// of about 1.
Scene short_ridge(double along, double round) {
  std::ostringstream obj;
  constexpr int kSteps = 100;
  for (int i = 0; i <= kSteps; ++i)
    for (int k = 0; k <= kSteps; ++k) {
      const double x = k - kSteps / 2.0 + (i % 2) * 0.5 + 0.05 * std::sin(5.0 * i * k), y = (i - kSteps / 2.0) * 0.866;
      const double fall = 1 / (1 + std::pow(2 * x / along, 4));
      obj << "v " << x << ' ' << y << ' '
          << 12 * fall * std::exp(-std::sqrt(y * y + round * round) / 12) + 0.05 * std::sin(7.0 * i + 3.0 * k) << '\n';
    }
  write_triangles(obj, kSteps);
  return read(obj.str(), ModelFormat::obj);
}

TEST(Creases, OfAScanAreLongOnARoundingAndMayBeShortOnAnEdge) {
  // Both are 14 long, the object 130.
  EXPECT_GT(find(short_ridge(14, 0)).count(), 8u);
  EXPECT_EQ(find(short_ridge(14, 0.6)).count(), 0u);
  EXPECT_GT(find(short_ridge(40, 0.6)).count(), 20u);
}

// Creases where more than two faces meet, and where faces are too thin to have a normal of their own.

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

TEST(Creases, AFineScanBendsLittleAndAPlaneNotAtAll) {
  EXPECT_EQ(find(rounded_ridge(40, 0.3, 0.15, 0.03)).creases.scans.size(), 1u);
  EXPECT_EQ(find(rounded_ridge(40, 0.3, 0.15, 0)).creases.scans.size(), 0u);
}

[[maybe_unused]] const bool scripts_are_added = test::add_mesh_scripts(LIGNE_SOURCE_DIR "/tests/heal/scripts");

}  // namespace
}  // namespace ligne
