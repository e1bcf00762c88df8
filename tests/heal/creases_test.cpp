/// Creases by what the file says, and by what the mesh shows.

#include "main/script.hpp"
#include "scene/creases/face_normals.hpp"
#include "scene/creases/file_shading.hpp"
#include "scene/creases/find_creases.hpp"
#include "scene/readers/reader.hpp"
#include "support/mesh_script.hpp"
#include "support/mesh_text.hpp"
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

/// A steep ridge, rounded over about `round`, that runs across an uneven mesh of triangles with edges of about 1; `turned`
/// radians from the direction to which the triangles are perpendicular. Its heights are noisy. Every other row of vertices
/// is shifted by half a step.
Scene rounded_ridge(double round, double turned, double rough = 0.3) {
  const auto noise = [](const char* seed) { return std::string("(mod(abs(43758.5453*sin(k*") + seed + ")),1)-0.5)"; };
  const std::string row = "floor(k/41)", x = "(mod(k,41)-20+mod(" + row + ",2)/2+" + noise("12.9898") + "/4)",
                    y = "((" + row + "-20)*0.866+" + noise("78.233") + "/4)",
                    across = "(" + x + "*cos(" + test::as_text(turned) + ")+" + y + "*sin(" + test::as_text(turned) + "))",
                    z = test::as_text(rough) + "*" + noise("39.425") + "-2*sqrt(" + across + "^2+" +
                        test::as_text(round * round) + ")",
                    v = "k+floor(k/40)+1", odd = "mod(floor(k/40),2)";
  return read(test::repeated("[[1681*v @" + x + "@ @" + y + "@ @" + z + "@\n]][[1600*f @" + v + "@ @" + v + "+1@ @" + v +
                             "+41+" + odd + "@\nf @" + v + "+1-" + odd + "@ @" + v + "+42@ @" + v + "+41@\n]]"),
              ModelFormat::obj);
}

TEST(Creases, FileShadingIsReadWhereItIsAskedForAlone) {
  const std::string bent = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.5\ns 1\nf 1 2 3\nf 3 2 4\n";
  EXPECT_FALSE(read(bent, ModelFormat::obj).corner_flags.empty());
  EXPECT_TRUE(read(bent, ModelFormat::obj, false).corner_flags.empty());
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
    const Found found = find(rounded_ridge(0.3, turned));
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

TEST(Creases, ARidgeRoundOverManyTrianglesHasNone) { EXPECT_EQ(find(rounded_ridge(12, 0.3)).count(), 0u); }

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

TEST(Creases, AStrayTriangleDoesNotSpoilAScan) {
  Scene clean = rounded_ridge(0.3, 0.15), with_fin = clean;
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

/// The zone of a ball, in even triangles, and a cube of 12 triangles.
std::string ball_and_cube() {
  const std::string row = "(pi*(floor(k/64)/30-0.2667))", turn = "(pi*k/32)", next = "(k-mod(k,64)+mod(k+1,64)+1)";
  return test::repeated("[[1088*v @10*cos(" + row + ")*cos(" + turn + ")@ @10*cos(" + row + ")*sin(" + turn + ")@ @10*sin(" +
                        row + ")@\n]][[1024*f @k+1@ @" + next + "@ @" + next + "+64@\nf @k+1@ @" + next +
                        "+64@ @k+65@\n]]") +
         "v 15 0 0\nv 23 0 0\nv 15 8 0\nv 23 8 0\nv 15 0 8\nv 23 0 8\nv 15 8 8\nv 23 8 8\n"
         "f -8 -6 -5\nf -8 -5 -7\nf -4 -3 -1\nf -4 -1 -2\nf -8 -7 -3\nf -8 -3 -4\nf -6 -2 -1\nf -6 -1 -5\n"
         "f -8 -4 -2\nf -8 -2 -6\nf -7 -5 -1\nf -7 -1 -3\n";
}

TEST(Creases, APartOfSpheresIsNoScan) {
  const Found found = find(read(ball_and_cube(), ModelFormat::obj));
  EXPECT_EQ(found.creases.patches.list.size(), 1u);
  EXPECT_TRUE(found.creases.scans.empty());
  EXPECT_EQ(found.count(), 12u);
}

TEST(Creases, AFineScanBendsLittleAndAPlaneNotAtAll) {
  EXPECT_EQ(find(rounded_ridge(0.3, 0.15, 0.03)).creases.decimated, 0u);
  EXPECT_TRUE(find(rounded_ridge(0.3, 0.15, 0)).creases.scans.at(0).is_decimated);
}

[[maybe_unused]] const bool scripts_are_added = test::add_mesh_scripts(LIGNE_SOURCE_DIR "/tests/heal/scripts");

}  // namespace
}  // namespace ligne
