#include "scene/readers/stl_reader.hpp"

#include "reader_tools.hpp"

namespace ligne {
namespace {

using namespace reader_test;

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

}  // namespace
}  // namespace ligne
