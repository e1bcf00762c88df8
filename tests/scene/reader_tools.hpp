#pragma once
/// Tools that the tests of the readers share.

#include "scene/readers/format_readers.hpp"
#include "scene/readers/reader.hpp"
#include "support/test.hpp"

namespace ligne::reader_test {

inline std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

/// A reader's shape.
using Reader = Scene (*)(const ModelReading&);

struct Result {
  Scene scene;
  ReadReport report;
  Warnings warnings;
};

/// Reads with one reader, without cleaning.
inline Result read_raw(Reader reader, const std::string& text) {
  Result result;
  result.scene = reader({{bytes_of(text), "M"}, result.report, result.warnings});
  return result;
}

/// The error line of a function; "no error" when there is none.
template <typename Function>
std::string error_line(Function&& function) {
  try {
    function();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "more than one line";
    return error.what();
  }
  return "no error";
}

inline std::string error_of(Reader reader, const std::string& text) {
  return error_line([&] { read_raw(reader, text); });
}

/// Half a unit of the fourth decimal, with which the bounding boxes of the shared models are written down.
inline constexpr double kBoxTolerance = 0.5001e-4;

inline void expect_bounds(const Scene& scene, Point3 min, Point3 max) {
  Point3 low(1e300), high(-1e300);
  for (const Point3& p : scene.vertices) low = glm::min(low, p), high = glm::max(high, p);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(low[k], min[k], kBoxTolerance) << "axis " << k;
    EXPECT_NEAR(high[k], max[k], kBoxTolerance) << "axis " << k;
  }
}

/// Objects own contiguous ranges that cover the scene; corners name vertices of their own object. `may_be_exact`: the
/// coordinates are whole numbers in the file.
inline void expect_sound(const Scene& scene, bool may_be_exact = false) {
  std::uint32_t vertex = 0, face = 0;
  for (const Object& object : scene.objects) {
    EXPECT_EQ(object.vertex_begin, vertex);
    EXPECT_EQ(object.face_begin, face);
    EXPECT_LT(object.face_begin, object.face_end);
    EXPECT_TRUE(object.precision > 0 || may_be_exact);
    for (std::size_t f = object.face_begin; f < object.face_end; ++f) {
      for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
        EXPECT_GE(scene.faces.contour(f, c).size(), 3u);
        for (const std::uint32_t v : scene.faces.contour(f, c))
          EXPECT_TRUE(v >= object.vertex_begin && v < object.vertex_end);
      }
    }
    vertex = object.vertex_end;
    face = object.face_end;
  }
  EXPECT_EQ(vertex, scene.vertices.size());
  EXPECT_EQ(face, scene.faces.size());
  EXPECT_TRUE(scene.face_material.empty() || scene.face_material.size() == scene.faces.size());
  EXPECT_TRUE(scene.corner_flags.empty() || scene.corner_flags.size() == scene.faces.corners().size());
  for (const std::uint32_t m : scene.face_material) EXPECT_LT(m, scene.materials.size());
}

}  // namespace ligne::reader_test

/// The folder of models made by others; the test ends when it is absent.
#define LIGNE_NEED_MODELS(folder)                        \
  const std::filesystem::path folder = LIGNE_MODELS_DIR; \
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "shared models are absent"
