#include <cmath>

#include "files/bytes.hpp"
#include "visibility/raster/depth_buffer.hpp"

namespace ligne::zbuffer {

void DepthBuffer::write(ByteWriter& bytes) const {
  for (const double value : {grid_.corner_mm.x, grid_.corner_mm.y, grid_.pixel_mm, scale_.nearest, scale_.step})
    bytes.number(value);
  bytes.number(grid_.width);
  bytes.number(grid_.height);
  bytes.list(std::span(depth_));
  bytes.list(std::span(hiding_depth_));
  bytes.list(std::span(face_));
}

DepthBuffer DepthBuffer::read(ByteReader& bytes, const Rect& window, std::uint32_t faces) {
  PixelGrid grid;
  DepthScale scale;
  for (double* value : {&grid.corner_mm.x, &grid.corner_mm.y, &grid.pixel_mm, &scale.nearest, &scale.step}) {
    *value = bytes.number<double>();
    bytes.need(std::isfinite(*value), "a number of the buffer is not finite");
  }
  grid.width = bytes.number<std::uint32_t>();
  grid.height = bytes.number<std::uint32_t>();
  // The pixels cover the window exactly, but for the rounding to whole pixels.
  constexpr double kMostBeyond = 2;
  const double most_mm = kMostBeyond * grid.pixel_mm;
  const auto near = [&](double a, double b) { return std::abs(a - b) <= most_mm; };
  bytes.need(grid.pixel_mm > 0 && grid.width > 0 && grid.height > 0 && near(grid.corner_mm.x, window.min.x) &&
                 near(grid.corner_mm.y, window.min.y) && near(grid.pixel_mm * grid.width, window.width()) &&
                 near(grid.pixel_mm * grid.height, window.height()),
             "the pixels do not cover the page");
  bytes.need(scale.step >= 0, "the steps of the depths are less than nothing");
  DepthBuffer buffer({}, scale);
  buffer.grid_ = grid;
  buffer.depth_ = bytes.list<float>();
  buffer.hiding_depth_ = bytes.list<float>();
  buffer.face_ = bytes.list<std::uint32_t>();
  const std::size_t pixels = std::size_t{grid.width} * grid.height;
  bytes.need(buffer.depth_.size() == pixels && buffer.hiding_depth_.size() == pixels && buffer.face_.size() == pixels,
             "there are not as many depths as pixels");
  constexpr float kBehindAll = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < pixels; ++i) {
    const bool shows = buffer.face_[i] != kNothing;
    bytes.need(!shows || buffer.face_[i] < faces, "a pixel shows a face that there is not");
    const float depth = buffer.depth_[i], hiding = buffer.hiding_depth_[i];
    bytes.need(shows ? std::isfinite(depth) && std::isfinite(hiding) : depth == kBehindAll && hiding == kBehindAll,
               "a pixel has no depth, or one that nothing has");
  }
  return buffer;
}

}  // namespace ligne::zbuffer
