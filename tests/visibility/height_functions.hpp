#pragma once
/// Surfaces z = f(x, y) that several tests of the horizon draw.

#include "drawing/measures.hpp"
#include "scene/surfaces/height_source.hpp"
#include "support/scenes.hpp"
#include "visibility/horizon/horizon.hpp"

namespace ligne::test {

inline constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

using Function = std::function<double(double, double)>;

class FunctionHeights : public HeightSource {
 public:
  FunctionHeights(Function f, std::vector<double> x, std::vector<double> y)
      : HeightSource(std::move(x), std::move(y)), f_(std::move(f)) {}
  void read_row(std::size_t j, std::span<double> z) const override {
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = at(i, j);
  }
  double at(std::size_t i, std::size_t j) const { return f_(x()[i], y()[j]); }

 private:
  Function f_;
};

/// So many positions from -half to half.
inline std::vector<double> positions(std::size_t n, double half = 1) {
  std::vector<double> at;
  for (std::size_t i = 0; i < n; ++i) at.push_back(half * (2.0 * static_cast<double>(i) / static_cast<double>(n - 1) - 1));
  return at;
}

/// The view of a surface on A4; where what is drawn ends is `window`.
inline View view_of(const HeightSource& heights, const CameraRequest& request, double z_scale = 1,
                    const Rect& window = {{0, 0}, {297, 210}}) {
  const Camera camera = make_camera(request, box_of(heights, survey(heights), z_scale));
  return make_view(extent_scene(heights, z_scale, camera), camera, {{{10, 10}, {287, 200}}}, window);
}

/// The sight along an azimuth and an elevation, in degrees.
inline CameraRequest along_angles(double azimuth, double elevation) {
  const double a = azimuth * std::numbers::pi / 180, e = elevation * std::numbers::pi / 180;
  return along({-std::cos(a) * std::cos(e), -std::sin(a) * std::cos(e), -std::sin(e)});
}

inline double waves(double x, double y) { return 0.3 * std::sin(5 * x * y + 0.1) + 0.1 * x; }
inline double sombrero(double x, double y) {
  const double r = std::hypot(x, y) * 12;
  return r == 0 ? 1 : std::sin(r) / r;
}

}  // namespace ligne::test
