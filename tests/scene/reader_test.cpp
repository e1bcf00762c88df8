/// Readers: strange archives, precision, blocks of PLY.

#include "scene/readers/reader.hpp"
#include "reader_tools.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/ply/ply_reader.hpp"
#include "scene/readers/text_lines.hpp"
#include "zip_builder.hpp"

namespace ligne {
namespace {

using namespace reader_test;

/// The message about an archive that is known and not read.
std::string refusal(const std::string& bytes) {
  return error_line([&] { detect_format(bytes_of(bytes), "", "M"); });
}

TEST(Strangers, AreNamedWithWhatToDo) {
  const std::string blender = ", which is not read: open it in Blender and export glTF";
  EXPECT_EQ(refusal(zip_test::zip({{"scene.usdc", "PXR-USDC"}}, false)), "M: is a USD file" + blender);
  EXPECT_EQ(refusal(zip_test::zip({{"readme.txt", "hello"}})), "M: is a ZIP archive, not a model");
  EXPECT_TRUE(refusal(zip_test::zip({{"duck.dae", "<COLLADA>"}})).starts_with("M: is an archive with a COLLADA file, "));
  EXPECT_TRUE(refusal(zip_test::zip({{"a.3DRep", "<x/>"}})).starts_with("M: is a 3DXML file, which is not read: "));
}

TEST(Precision, OfFloat32NumbersAsText) {
  // Coordinates of a part far from the origin, as float32 and as double, with so many decimals.
  const auto precision = [](bool as_float32, const char* format, double step) {
    DecimalPrecision p;
    for (int i = 0; i < 64; ++i) {
      const double place = 150 + std::sin(i), value = step > 0 ? std::round(place / step) * step : place;
      std::array<char, 32> word{};
      std::snprintf(word.data(), word.size(), format, as_float32 ? static_cast<double>(static_cast<float>(value)) : value);
      p.add(word.data(), *number_in(word.data()));
    }
    return p.value();
  };
  EXPECT_EQ(precision(true, "%.6f", 0), half_ulp_float32(150));
  EXPECT_EQ(precision(true, "%.17g", 0), half_ulp_float32(150));
  EXPECT_DOUBLE_EQ(precision(false, "%.6f", 0), 0.5e-6);
  EXPECT_DOUBLE_EQ(precision(true, "%.5f", 0), 0.5e-5) << "too few decimals to tell";
  EXPECT_DOUBLE_EQ(precision(false, "%.6f", 0.125), 0.5e-6) << "eighths are exact in any format";
}

TEST(Precision, OfCoordinatesRoundedToDecimals) {
  // A ring of 200 points, rounded to a step and then scaled; as float32.
  const auto ring = [](double step, double radius, double scale = 1) {
    std::vector<Point3> points;
    for (int i = 0; i < 200; ++i) {
      Point3 p(radius * std::cos(0.31 * i), radius * std::sin(0.31 * i), 0.1713 * i);
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = static_cast<float>(scale * (step > 0 ? std::round(p[axis] / step) * step : p[axis]));
      points.push_back(p);
    }
    return points;
  };
  EXPECT_DOUBLE_EQ(decimal_grid(ring(0.001, 10)), 0.0005);
  EXPECT_DOUBLE_EQ(decimal_grid(ring(0.1, 400)), 0.05);
  EXPECT_DOUBLE_EQ(decimal_grid(ring(0.001, 10, 2)), 0.001);          // doubled after it was rounded
  EXPECT_DOUBLE_EQ(decimal_grid(ring(0.001, 10, 1 + 1e-7)), 0.0005);  // moved by a unit in the last place
  EXPECT_EQ(decimal_grid(ring(0.001, 10, 1.00001)), 0);               // by more than the roundings of a float32
  EXPECT_EQ(decimal_grid(ring(0.001, 10, 1.03)), 0);                  // scaled after it was rounded
  EXPECT_EQ(decimal_grid(ring(0, 10)), 0);                            // not rounded
  EXPECT_EQ(decimal_grid(ring(0.1, 10)), 0);                          // as coarse as voxels
  EXPECT_EQ(decimal_grid(ring(0.00001, 100)), 0);                     // as fine as float32
  EXPECT_EQ(decimal_grid(ring(0.5, 4000)), 0);                        // drawn on a grid: the only decimals are 0 and 5
  EXPECT_EQ(decimal_grid(ring(1, 4000)), 0);                          // whole numbers
  EXPECT_EQ(decimal_grid({}), 0);
  EXPECT_EQ(decimal_grid(std::vector<Point3>(100, {1e300, 1, 1})), 0);
}

// Large binary PLY files, whose triangles are read in blocks.

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
  const std::string raw = test::raw(value);
  out += order == std::endian::native ? raw : std::string(raw.rbegin(), raw.rend());
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
