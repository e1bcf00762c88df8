#pragma once
/// A picture of a scene, pixel by pixel: of every face the pixels whose centres lie in it by the even-odd rule, at the
/// depths of its plane. Made from model coordinates and the camera's numbers alone; nothing of the library's geometry is
/// used.

#include "scene/model/scene.hpp"
#include "support/standard.hpp"

namespace ligne::test {

inline constexpr int kPixelsPerMm = 4;
inline constexpr int kWidth = 297 * kPixelsPerMm, kHeight = 210 * kPixelsPerMm;

struct ViewPoint {
  Point3 direction{0, 1, 0};    ///< line of sight; in a perspective from the eye to the target
  std::optional<Point3> eye{};  ///< perspective; all of the scene is in front of it and within the field of view
};

struct Pixel {
  int x = 0, y = 0;
};

/// The picture fills an A4 sheet on its long side, but for 10 mm on each side, and z is up.
class ZBuffer {
 public:
  ZBuffer(const Scene& scene, const ViewPoint& view);

  std::int32_t face_at(Pixel p) const { return face_[index(p)]; }  ///< -1: none

  /// Whether something must be drawn between two neighbouring pixels: one sees a face and the other nothing, one sees a face
  /// far before the other's, or two planes at a steep angle.
  bool is_strong_jump(Pixel a, Pixel b) const;
  /// Pixels at which something may be drawn: neighbours see different faces, or an edge runs there and no face is clearly
  /// before it.
  std::vector<std::uint8_t> lines_allowed() const;

 private:
  struct Projected {
    double x, y, depth;  ///< pixels; distance along the line of sight in pixels on the page
  };
  /// Depth at a pixel is a + b x + c y, in a perspective its reciprocal is.
  struct Plane {
    double a = 0, b = 0, c = 0;
    Point3 normal{0, 0, 0};  ///< towards the viewer
  };

  static std::size_t index(Pixel p) { return static_cast<std::size_t>(p.y) * kWidth + static_cast<std::size_t>(p.x); }
  double depth(std::int32_t face, double x, double y) const;
  void fill(std::int32_t face, const std::vector<std::vector<Projected>>& contours);

  const Scene& scene_;
  bool perspective_;
  std::vector<Projected> vertices_;
  std::vector<Plane> planes_;
  std::vector<std::int32_t> face_;
  std::vector<double> depth_;
};

// A drawing's pixels against a z-buffer.

/// Dark pixels of a drawing, kWidth x kHeight; 1 where the paper is more than half covered.
using Ink = std::vector<std::uint8_t>;

/// Throws std::runtime_error when the file is no PNG of that size.
Ink read_ink(const std::filesystem::path& png);

struct Disagreement {
  std::size_t ink = 0, jumps = 0;  ///< pixels looked at
  std::size_t stray = 0;           ///< dark pixels that have no line near them
  std::size_t missing = 0;         ///< strong jumps that have no ink near them
  Pixel first_stray, first_missing;

  bool none() const { return ink > 0 && jumps > 0 && stray == 0 && missing == 0; }
  std::string words() const;
};

Disagreement compare(const Ink& ink, const ZBuffer& picture);

}  // namespace ligne::test
