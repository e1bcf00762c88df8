// Large binary PLY files, whose triangles are read in blocks.

#include "reader_tools.hpp"
#include "scene/readers/ply/ply_reader.hpp"

namespace ligne {
namespace {

using namespace reader_test;

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
