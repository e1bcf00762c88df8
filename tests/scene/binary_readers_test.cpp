// Readers of binary formats: 3D Studio, STL, PLY.

#include "scene/readers/studio/three_ds_reader.hpp"

#include "reader_tools.hpp"
#include "scene/readers/ply/ply_reader.hpp"
#include "scene/readers/stl_reader.hpp"

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
  EXPECT_EQ(warnings.left_out().text(), "left out: 1 texture");
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

std::string binary(const std::string& header, std::uint32_t claimed, const std::vector<float>& coordinates) {
  std::string out = header + std::string(80 - header.size(), '\0');
  const auto append = [&](const auto& value) { out.append(reinterpret_cast<const char*>(&value), sizeof(value)); };
  append(claimed);
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (i % 9 == 0) out.append(12, '\0');
    append(coordinates[i]);
    if (i % 9 == 8) out.append(2, '\0');
  }
  return out;
}

const std::vector<float> kTriangle{0, 0, 0, 1, 0, 0, 0, 1, 0};

TEST(StlReader, BinaryEvenWithAHeaderThatBeginsWithSolid) {
  const std::string bytes = binary("solid made by a careless exporter", 1, kTriangle);
  EXPECT_EQ(detect_format(bytes_of(bytes), ".stl", "M"), ModelFormat::stl_binary);
  const Result r = read_raw(read_stl_binary, bytes);
  expect_sound(r.scene);
  EXPECT_EQ(r.scene.vertices[1], Point3(1, 0, 0));
  EXPECT_EQ(r.scene.objects[0].precision, std::ldexp(1.0, -24));
  EXPECT_EQ(r.report.vertices, 3u);
}

TEST(StlReader, BinaryCountsThatLie) {
  const std::string one = binary("", 2, kTriangle);
  EXPECT_EQ(error_of(read_stl_binary, one),
            "M: binary STL declares 2 triangles, which need 184 bytes, but the file has 134");
  EXPECT_EQ(error_of(read_stl_binary, binary("", 4294967295u, kTriangle)),
            "M: binary STL declares 4294967295 triangles, which need 214748364834 bytes, but the file has 134");
  EXPECT_EQ(read_raw(read_stl_binary, binary("", 0, kTriangle)).report.faces, 1u);  // a count that was never written
  const Result longer = read_raw(read_stl_binary, binary("", 1, kTriangle) + "comment");
  EXPECT_EQ(longer.report.faces, 1u);
  EXPECT_EQ(longer.warnings.lines(), std::vector<std::string>{"left out: 7 bytes behind the triangles"});
  EXPECT_EQ(error_of(read_stl_binary, std::string(50, '\0')), "M: binary STL of 50 bytes, shorter than its header of 84");
  EXPECT_EQ(error_of(read_stl_binary, binary("", 0, {})), "M: holds no faces");
}

TEST(StlReader, BinaryCoordinatesThatAreNotFiniteAreErrors) {
  std::vector<float> two = kTriangle;
  two.insert(two.end(), {0, 0, 0, NAN, 0, 0, 0, INFINITY, 0});
  EXPECT_EQ(error_of(read_stl_binary, binary("", 2, two)), "M: triangle 1 of 2: a coordinate is not finite");
}

/// Without shading.
Scene plain_ply(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings) {
  return read_ply(bytes, name, report, warnings);
}

std::string ply_error(const std::string& text) { return error_of(plain_ply, text); }

std::string header(const std::string& format, const std::string& vertices, const std::string& faces) {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " + vertices +
         "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

/// Appends a number in the byte order.
template <typename T>
void put(std::string& out, std::endian order, T value) {
  const char* p = reinterpret_cast<const char*>(&value);
  std::string raw(p, p + sizeof(T));
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  out += raw;
}

TEST(PlyReader, BinaryInBothByteOrders) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    std::string bytes =
        "ply\nformat binary_" + std::string(order == std::endian::little ? "little" : "big") +
        "_endian 1.0\nelement vertex 3\nproperty double x\nproperty float y\nproperty short z\nproperty list ushort uchar "
        "tags\n"
        "element face 1\nproperty list uint ushort vertex_indices\nproperty int8 mark\nend_header\n";
    for (int i = 0; i < 3; ++i) {
      put(bytes, order, 0.1 * i);
      put(bytes, order, 1.5f * static_cast<float>(i));
      put(bytes, order, static_cast<std::int16_t>(-300 * i));
      put(bytes, order, static_cast<std::uint16_t>(i));
      bytes += std::string(static_cast<std::size_t>(i), 'x');
    }
    put(bytes, order, std::uint32_t{3});
    for (const std::uint16_t v : {2, 1, 0}) put(bytes, order, v);
    bytes += '\x07';
    const Result r = read_raw(plain_ply, bytes);
    EXPECT_EQ(r.scene.vertices[2], Point3(0.2, 3, -600));
    EXPECT_EQ(r.scene.faces.corners()[0], 2u);
    EXPECT_EQ(r.scene.objects[0].precision, std::ldexp(0.5, 10 - 24));
    EXPECT_EQ(ply_error(bytes + "!"), "M: has 1 bytes more than the header declares");
    EXPECT_EQ(ply_error(bytes.substr(0, bytes.size() - 1)), "M: the file ends in face 0 of 1");
    EXPECT_EQ(ply_error(bytes.substr(0, bytes.size() - 20)), "M: the file ends in vertex 2 of 3");
  }
}

/// A binary file of `count` triangles in a strip, and a face more with the given corners.
std::string strip_ply(std::endian order, std::uint32_t count, const std::vector<std::int32_t>& last) {
  std::string bytes = header(order == std::endian::little ? "binary_little_endian" : "binary_big_endian",
                             std::to_string(count + 2), std::to_string(count + 1));
  for (std::uint32_t i = 0; i < count + 2; ++i)
    for (const std::uint32_t c : {i, i % 2, i % 7}) put(bytes, order, 0.5f * static_cast<float>(c));
  for (std::uint32_t i = 0; i < count; ++i) {
    bytes += '\x03';
    for (const std::uint32_t v : {i, i + 1, i + 2}) put(bytes, order, static_cast<std::int32_t>(v));
  }
  bytes += static_cast<char>(last.size());
  for (const std::int32_t v : last) put(bytes, order, v);
  return bytes;
}

TEST(PlyReader, BlocksOfTrianglesAreAsItemsOneByOne) {
  constexpr std::uint32_t kCount = 40'000;  // several blocks
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const Result blocks = read_raw(plain_ply, strip_ply(order, kCount, {0, 1, 3}));
    // A face of four corners has all read one by one.
    const Result items = read_raw(plain_ply, strip_ply(order, kCount, {0, 1, 3, 2}));
    EXPECT_TRUE(blocks.scene.faces.all_triangles());
    EXPECT_FALSE(items.scene.faces.all_triangles());
    EXPECT_EQ(blocks.scene.vertices, items.scene.vertices);
    EXPECT_EQ(blocks.scene.vertices[kCount], Point3(0.5 * kCount, 0, 0.5 * (kCount % 7)));
    EXPECT_EQ(blocks.scene.objects[0].precision, items.scene.objects[0].precision);
    const auto triangles = blocks.scene.faces.corners().first(3 * kCount);
    EXPECT_TRUE(std::ranges::equal(triangles, items.scene.faces.corners().first(3 * kCount)));
    EXPECT_EQ(blocks.scene.faces.corners()[3 * kCount + 2], 3u);
    EXPECT_EQ(blocks.report.faces, kCount + 1);
    EXPECT_EQ(blocks.report.triangles, kCount + 1);
    EXPECT_EQ(items.report.triangles, kCount + 2);
    EXPECT_EQ(blocks.report.vertices, kCount + 2);
    EXPECT_EQ(blocks.scene.materials.size(), items.scene.materials.size());
  }
}

TEST(PlyReader, WhatIsAmissInBlocksIsNamed) {
  constexpr std::uint32_t kCount = 20'000;
  const std::endian order = std::endian::native;
  EXPECT_EQ(ply_error(strip_ply(order, kCount, {0, -1, 3})),
            "M: face 20000 of 20001: corner of a face is not a vertex index");
  EXPECT_EQ(ply_error(strip_ply(order, kCount, {0, 1})), "M: face 20000 of 20001: face with 2 corners, needs 3 or more");
  EXPECT_EQ(ply_error(strip_ply(order, kCount, {0, 1, 20'002})), "M: face 20000 names vertex 20002 of 20002");
  std::string bytes = strip_ply(order, kCount, {0, 1, 3});
  EXPECT_EQ(ply_error(bytes.substr(0, bytes.size() - 1)), "M: the file ends in face 20000 of 20001");
  const float infinite = HUGE_VALF;
  const std::size_t vertices = bytes.find("end_header\n") + 11;
  bytes.replace(vertices + 12 * 17'000 + 4, sizeof(float), reinterpret_cast<const char*>(&infinite), sizeof(float));
  EXPECT_EQ(ply_error(bytes), "M: vertex 17000 of 20002: a coordinate is not finite");
  const std::string lying = header("binary_little_endian", "4000000000", "1");
  EXPECT_EQ(ply_error(lying + std::string(30, '\0')), "M: the file ends in vertex 2 of 4000000000");
}

}  // namespace
}  // namespace ligne
