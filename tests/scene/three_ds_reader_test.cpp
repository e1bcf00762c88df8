#include "scene/readers/studio/three_ds_reader.hpp"

#include "reader_tools.hpp"

namespace ligne {
namespace {

/// Without shading.
Scene plain_3ds(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings) {
  return read_3ds(bytes, name, report, warnings);
}

using namespace reader_test;

template <typename T>
std::string raw(T value) {
  std::string text(sizeof value, '\0');
  for (std::size_t i = 0; i < sizeof value; ++i) text[i] = std::bit_cast<std::array<char, sizeof value>>(value)[i];
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(text);
  return text;
}
std::string u16(unsigned value) { return raw(static_cast<std::uint16_t>(value)); }
std::string floats(std::initializer_list<float> values) {
  std::string text;
  for (const float v : values) text += raw(v);
  return text;
}
std::string chunk(unsigned number, const std::string& contents) {
  return u16(number) + raw(static_cast<std::uint32_t>(contents.size() + 6)) + contents;
}
std::string zero_ended(std::string text) { return text + '\0'; }

std::string vertices(const std::vector<Point3>& points) {
  std::string text = u16(unsigned(points.size()));
  for (const Point3& p : points) text += floats({float(p.x), float(p.y), float(p.z)});
  return chunk(0x4110, text);
}

struct Facet {
  unsigned a, b, c, visible = 7;  ///< bits: CA 1, BC 2, AB 4
};
std::string faces(const std::vector<Facet>& all, const std::string& more = "") {
  std::string text = u16(unsigned(all.size()));
  for (const Facet& f : all) text += u16(f.a) + u16(f.b) + u16(f.c) + u16(f.visible);
  return chunk(0x4120, text + more);
}

/// Two triangles of a unit square, with a shared side that is not visible.
std::string square(const std::string& name, const std::string& more_of_faces = "", const std::string& more = "") {
  return chunk(0x4000, zero_ended(name) + chunk(0x4100, vertices({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}) +
                                                            faces({{0, 1, 2, 6}, {0, 2, 3, 3}}, more_of_faces) + more));
}
std::string file(const std::string& editor, const std::string& keyframes = "") {
  return chunk(0x4d4d, chunk(0x0002, raw(std::uint32_t{3})) + chunk(0x3d3d, editor) +
                           (keyframes.empty() ? "" : chunk(0xb000, keyframes)));
}
std::string track(unsigned number, const std::string& value) {
  return chunk(number, std::string(10, '\0') + raw(std::uint32_t{1}) + std::string(4, '\0') + u16(0) + value);
}
std::string node(const std::string& name, unsigned own, unsigned parent, Point3 position, float angle = 0) {
  return chunk(0xb002, chunk(0xb030, u16(own)) + chunk(0xb010, zero_ended(name) + std::string(4, '\0') + u16(parent)) +
                           chunk(0xb013, floats({0, 0, 0})) +
                           track(0xb020, floats({float(position.x), float(position.y), float(position.z)})) +
                           track(0xb021, floats({angle, 0, 0, 1})));
}

TEST(ThreeDsReader, MeshesWithSidesThatAreNotVisible) {
  const std::string text = file(square("Plate"));
  EXPECT_TRUE(is_3ds(bytes_of(text)));
  EXPECT_TRUE(is_3ds(bytes_of(text + "\r\n")));
  EXPECT_FALSE(is_3ds(bytes_of(text.substr(0, text.size() - 1))));
  const Result r = read_raw(plain_3ds, text);
  ASSERT_EQ(r.scene.objects.size(), 1u);
  EXPECT_EQ(r.scene.objects[0].name, "Plate");
  EXPECT_EQ(r.scene.corner_flags, (std::vector<std::uint8_t>{0, 0, kCornerFileHidden, kCornerFileHidden, 0, 0}));
  EXPECT_EQ(r.scene.vertices[2], Point3(1, 1, 0));
  EXPECT_EQ(r.scene.up_axis, Axis::z);
  EXPECT_EQ(r.report.triangles, 2u);
  EXPECT_EQ(r.report.vertices, 4u);
  EXPECT_TRUE(r.warnings.counts().empty());
}

TEST(ThreeDsReader, AMeshWithoutAnyVisibleSideHasNoMarks) {
  const std::string mesh =
      chunk(0x4100, faces({{0, 1, 2, 0}}) + vertices({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));  // the faces first
  EXPECT_TRUE(read_raw(plain_3ds, file(chunk(0x4000, zero_ended("a") + mesh))).scene.corner_flags.empty());
}

TEST(ThreeDsReader, MaterialsAndSmoothingGroups) {
  const std::string paint =
      chunk(0xafff, chunk(0xa000, zero_ended("R\xF6t")) + chunk(0xa020, chunk(0x0011, std::string("\xFF\x33\0", 3))) +
                        chunk(0xa050, chunk(0x0030, u16(25))) + chunk(0xa200, ""));
  const std::string of_faces = chunk(0x4130, zero_ended("R\xF6t") + u16(1) + u16(1)) +
                               chunk(0x4150, raw(std::uint32_t{1}) + raw(std::uint32_t{0x80000002}));
  FileShading shading;
  ReadReport report;
  Warnings warnings;
  const std::string text = file(paint + square("a", of_faces));
  const Scene scene = read_3ds(bytes_of(text), "M", report, warnings, &shading);
  ASSERT_EQ(scene.face_material.size(), 2u);
  const Material& painted = scene.materials[scene.face_material[1]];
  EXPECT_EQ(painted.name, "R\xC3\xB6t");
  EXPECT_EQ(painted.color, Point3(1, 0.2, 0));
  EXPECT_EQ(painted.opacity, 0.75);
  EXPECT_EQ(scene.materials[scene.face_material[0]].name, "");
  EXPECT_EQ(shading.face_groups, (std::vector<std::uint32_t>{1, 0x80000002}));
  EXPECT_TRUE(shading.groups_are_bits);
  EXPECT_EQ(warnings.left_out().text(), "left out: 1 textures");
}

TEST(ThreeDsReader, LightsAndCameras) {
  const std::string lamp = chunk(0x4000, zero_ended("lamp") + chunk(0x4600, floats({1, 2, 3})));
  const std::string eye = chunk(0x4000, zero_ended("eye") + chunk(0x4700, floats({0, -5, 0, 0, 0, 0, 90, 12})));
  const Scene scene = read_raw(plain_3ds, file(square("a") + lamp + eye)).scene;
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0].vector, Point3(1, 2, 3));
  ASSERT_EQ(scene.cameras.size(), 1u);
  EXPECT_EQ(scene.cameras[0].forward, Point3(0, 5, 0));
  EXPECT_NEAR(scene.cameras[0].fov_degrees, 90, 1e-9);  // 12 mm before a film 24 mm high
  ASSERT_TRUE(scene.cameras[0].up.has_value());
  EXPECT_NEAR(scene.cameras[0].up->x, 1, 1e-9);
}

TEST(ThreeDsReader, InstancesStandWhereTheKeyframesPlaceThem) {
  // The mesh is stored one unit to the right of its own axes.
  const std::string moved = chunk(0x4160, floats({1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0}));
  const std::string nodes = node("a", 0, 0xffff, {10, 0, 0}) + node("$$$DUMMY", 1, 0xffff, {0, 20, 0}) +
                            node("a", 2, 1, {0, 0, 5}, float(std::numbers::pi / 2));
  const Scene scene = read_raw(plain_3ds, file(square("a", "", moved), nodes)).scene;
  ASSERT_EQ(scene.objects.size(), 2u);
  EXPECT_EQ(scene.vertices[0], Point3(11, 0, 0));
  EXPECT_EQ(scene.vertices[2], Point3(12, 1, 0));
  // Clockwise about z: (1, 0) to (0, -1), and (2, 1) to (1, -2).
  EXPECT_NEAR(glm::distance(scene.vertices[4], Point3(0, 19, 5)), 0, 1e-6);
  EXPECT_NEAR(glm::distance(scene.vertices[6], Point3(1, 18, 5)), 0, 1e-6);
  // A single node leaves the mesh where it is stored.
  EXPECT_EQ(read_raw(plain_3ds, file(square("a", "", moved), node("a", 0, 0xffff, {10, 0, 0}))).scene.vertices[0],
            Point3(0, 0, 0));
}

TEST(ThreeDsReader, ErrorsNameTheByte) {
  const auto error = [](const std::string& text) { return error_of(plain_3ds, text); };
  EXPECT_EQ(error(file("")), "M: holds no faces");
  const std::string three = vertices({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  const auto mesh = [&](const std::string& parts) { return file(chunk(0x4000, zero_ended("a") + chunk(0x4100, parts))); };
  EXPECT_EQ(error(mesh(three + faces({{0, 1, 3}}))), "M: byte 94: face 0 names vertex 3 of 3");
  EXPECT_EQ(error(mesh(faces({{0, 1, 2}}))), "M: byte 46: face 0 names vertex 0 of 0");
  EXPECT_EQ(error(mesh(chunk(0x4110, u16(9) + floats({1, 2})))), "M: byte 52: the chunk ends within a number");
  EXPECT_EQ(error(mesh(vertices({{0, 0, 0}, {0, NAN, 0}}))), "M: byte 64: a number is not finite");
  EXPECT_EQ(error(mesh(u16(0x4110) + raw(std::uint32_t{900}) + "xx")), "M: byte 36: a chunk of 900 bytes does not fit");
  EXPECT_EQ(error(mesh(u16(0x4110) + raw(std::uint32_t{5}) + "xx")), "M: byte 36: a chunk of 5 bytes does not fit");
  EXPECT_EQ(error(file(chunk(0x4000, "no end"))), "M: byte 34: the chunk ends within a number");
  EXPECT_EQ(error(mesh(three + faces({{0, 1, 2}}, chunk(0x4130, zero_ended("m") + u16(1) + u16(1))))),
            "M: byte 108: a material names a face that is not there");
  const std::string circle = node("a", 0, 1, {0, 0, 0}) + node("a", 1, 0, {0, 0, 0});
  EXPECT_EQ(error(file(square("a"), circle)), "M: keyframes: node 'a' is its own ancestor");
}

}  // namespace
}  // namespace ligne
