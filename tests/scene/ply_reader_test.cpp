#include "scene/readers/ply/ply_reader.hpp"

#include <bit>
#include <cmath>

#include "reader_tools.hpp"

namespace ligne {
namespace {

/// Without shading.
Scene plain_ply(std::span<const std::byte> bytes, const std::string& name, ReadReport& report, Warnings& warnings) {
  return read_ply(bytes, name, report, warnings);
}

using namespace reader_test;

std::string ply_error(const std::string& text) { return error_of(plain_ply, text); }

std::string header(const std::string& format, const std::string& vertices, const std::string& faces,
                   const std::string& type = "float") {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " + vertices + "\nproperty " + type +
         " x\nproperty " + type + " y\nproperty " + type + " z\nelement face " + faces +
         "\nproperty list uchar int vertex_indices\nend_header\n";
}

const std::string kSquareCorners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

/// Appends a number in the byte order.
template <typename T>
void put(std::string& out, std::endian order, T value) {
  const char* p = reinterpret_cast<const char*>(&value);
  std::string raw(p, p + sizeof(T));
  if (order != std::endian::native) std::reverse(raw.begin(), raw.end());
  out += raw;
}

TEST(PlyReader, TextWithPolygons) {
  const Result r = read_raw(plain_ply, header("ascii", "4", "2") + kSquareCorners + "4 0 1 2 3\n3 0 1 2\n");
  expect_sound(r.scene);
  EXPECT_EQ(r.scene.faces.contour(0, 0).size(), 4u);
  EXPECT_EQ(r.report.triangles, 3u);
  EXPECT_EQ(r.report.vertices, 4u);
  EXPECT_EQ(r.scene.up_axis, Axis::z);
}

TEST(PlyReader, ByteOrderMarkAndBlankLinesInFront) {
  const std::string front = "\xEF\xBB\xBF\r\n \n";
  const std::string text = front + header("ascii", "4", "1") + kSquareCorners + "4 0 1 2 3\n";
  EXPECT_EQ(detect_format(bytes_of(text), "", "M"), ModelFormat::ply);
  EXPECT_EQ(read_raw(plain_ply, text).scene.faces.size(), 1u);
  EXPECT_EQ(ply_error(front + header("ascii", "4", "1") + "0 0\n"), "M:13: line with too few numbers");
}

TEST(PlyReader, ExtraElementsAndPropertiesInAnyOrder) {
  const std::string text =
      "ply\r\nformat ascii 1.0\r\nobj_info whatever\r\nelement face 1\r\nproperty uchar red\r\nproperty list uint8 uint32 "
      "vertex_index\r\n"
      "property list short float weights\r\nelement empty 1000000000\r\nelement edge 2\r\nproperty int a\r\nelement vertex "
      "3\r\nproperty float nx\r\n"
      "property double z\r\nproperty list char int ring\r\nproperty short y\r\nproperty uchar x\r\nend_header\r\n"
      "255 3 2 1 0 2 0.5 0.5\r\n7\r\n\r\n8\r\n0.1 3.5 2 9 9 -2 1\r\n0.1 4.5 0 -3 200\r\n0 1e-3 0 4 5\r\n";
  const Result r = read_raw(plain_ply, text);
  EXPECT_EQ(r.scene.vertices[0], Point3(1, -2, 3.5));
  EXPECT_EQ(r.scene.vertices[1], Point3(200, -3, 4.5));
  EXPECT_EQ(r.scene.faces.corners()[0], 2u);
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
  for (std::uint32_t i = 0; i < count + 2; ++i) {
    for (const std::uint32_t c : {i, i % 2, i % 7}) put(bytes, order, 0.5f * static_cast<float>(c));
  }
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
}

TEST(PlyReader, DoublesKeepTheirPlaces) {
  const Result r = read_raw(plain_ply, header("ascii", "3", "1", "double") + "559705.123456 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  EXPECT_EQ(r.scene.vertices[0].x, 559705.123456);
  EXPECT_DOUBLE_EQ(r.scene.objects[0].precision, 0.5e-6);
}

TEST(PlyReader, ErrorsInTextNameTheLine) {
  const std::string three = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(ply_error(header("ascii", "3", "1") + three + "3 0 1 9\n"), "M: face 0 names vertex 9 of 3");
  EXPECT_EQ(ply_error(header("ascii", "3", "1") + three + "3 0 1 -1\n"), "M:14: corner of a face is not a vertex index");
  EXPECT_EQ(ply_error(header("ascii", "3", "1") + three + "3 0 1 1.5\n"), "M:14: '1.5' is not a whole number");
  EXPECT_EQ(ply_error(header("ascii", "3", "1") + three + "2 0 1\n"), "M:14: face with 2 corners, needs 3 or more");
  EXPECT_EQ(ply_error(header("ascii", "3", "1") + three + "-3 0 1\n"), "M:14: list of negative length");
  EXPECT_EQ(ply_error(header("ascii", "3", "1") + three + "4e38 0 1\n"), "M:14: list is too long");
  EXPECT_EQ(ply_error(header("ascii", "3", "1") + three + "4 0 1 2\n"), "M:14: line with too few numbers");
  EXPECT_EQ(ply_error(header("ascii", "3", "1") + "0 0 0\n1 zero 0\n"), "M:12: 'zero' is not a number");
  EXPECT_EQ(ply_error(header("ascii", "3", "1") + "0 0 0\n1 nan 0\n"), "M:12: 'nan' is not a number");
  EXPECT_EQ(ply_error(header("ascii", "3", "1") + "0 0 0\n1 0"), "M:12: line with too few numbers");
  EXPECT_EQ(ply_error(header("ascii", "3", "1") + "0 0 0\n1 0 0\n"), "M:12: the file ends before vertex 2 of 3");
  EXPECT_EQ(ply_error(header("ascii", "3", "1") + three), "M:13: the file ends before face 0 of 1");
  EXPECT_EQ(ply_error(header("ascii", "9000000000000000000", "1") + three),
            "M:13: the file ends before vertex 3 of 9000000000000000000");
  EXPECT_EQ(ply_error(header("ascii", "3", "1") + three + "3 0 1 2\n3 0 1 2\n"),
            "M:15: more lines than the header declares elements");
  EXPECT_EQ(ply_error(header("ascii", "3", "0") + three), "M: holds no faces");
}

TEST(PlyReader, HostileBinaryCounts) {
  const std::string lying = header("binary_little_endian", "4000000000", "1");
  EXPECT_EQ(ply_error(lying + std::string(30, '\0')), "M: the file ends in vertex 2 of 4000000000");
  const std::string list =
      "ply\nformat binary_big_endian 1.0\nelement x 1\nproperty list uint double p\nelement vertex 0\nproperty float "
      "x\nproperty float y\n"
      "property float z\nelement face 0\nproperty list uchar int vertex_indices\nend_header\n";
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement a\x1b[2J\x07 1\nproperty int a\n" +
                      list.substr(list.find("element vertex"))),
            "M:11: the file ends before a\\x1b[2J\\x07 0 of 1");
  EXPECT_EQ(ply_error(list + "\xFF\xFF\xFF\xFF"), "M: the file ends in x 0 of 1");
  EXPECT_EQ(ply_error(header("binary_little_endian", "0", "1") + std::string("\x02\0\0\0\0\0\0\0\0", 9)),
            "M: face 0 of 1: face with 2 corners, needs 3 or more");
}

TEST(PlyReader, ErrorsInTheHeader) {
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\n"), "M:3: PLY header without 'end_header'");
  EXPECT_EQ(ply_error("ply"), "M:2: PLY header without 'end_header'");
  EXPECT_EQ(ply_error("ply\nend_header\n"), "M:2: PLY header without 'format'");
  EXPECT_EQ(ply_error("plyx\n"), "M:1: a PLY file begins with a line 'ply'");
  EXPECT_EQ(ply_error("ply\nformat ascii 2.0\n"), "M:2: PLY version '2.0' is not known, only 1.0 is");
  EXPECT_EQ(ply_error("ply\nformat text 1.0\n"),
            "M:2: 'text' is not a PLY format (ascii, binary_little_endian, binary_big_endian)");
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement vertex many\n"), "M:3: 'many' is not a number of elements");
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement vertex -1\n"), "M:3: '-1' is not a number of elements");
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement\n"), "M:3: element without a name");
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement a 1\nelement a 1\n"), "M:4: element 'a' a second time");
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nproperty float x\n"), "M:3: property before the first element");
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement a 1\nproperty half x\n"), "M:4: 'half' is not a PLY type");
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement a 1\nproperty list float int x\n"),
            "M:4: the length of a list can not be a float");
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement a 1\nproperty int\n"), "M:4: property without a name");
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement a 1\nwhatever\n"),
            "M:4: 'whatever' is not a statement of a PLY header");
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nend_header\n"),
            "M: PLY header declares no z of vertices");
  EXPECT_EQ(
      ply_error(
          "ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\nend_header\n"),
      "M: holds no faces");
  EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement vertex 0\nproperty float x\nproperty float y\nproperty float z\n"
                      "element face 1\nproperty int label\nend_header\n"),
            "M: PLY header declares no list vertex_indices of faces");
}

TEST(PlyReader, ModelOfOthers) {
  LIGNE_NEED_MODELS(folder);
  Warnings warnings;
  ReadReport report;
  const Scene scene = read_scene(folder / "octagonal_pocket.ply", {}, warnings, &report);
  EXPECT_EQ(report.format, ModelFormat::ply);
  EXPECT_EQ(report.vertices, 1658u);
  EXPECT_EQ(report.faces, 3262u);
  EXPECT_EQ(report.triangles, 3262u);
  expect_sound(scene);
}

}  // namespace
}  // namespace ligne
