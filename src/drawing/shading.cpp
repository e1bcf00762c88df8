#include "drawing/shading.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"

namespace ligne {
namespace {

/// Maps the pixels of a picture to the pixels of a model, along one axis. Lengths are in pixels of the model.
struct Resampling {
  double corner, size;
  std::uint32_t count;  ///< number of pixels of the model

  /// Calls part(i, share) for each pixel i of the model that pixel `at` of the picture covers. `share` is the fraction
  /// of the picture's pixel that it fills.
  template <class Part>
  void of(std::uint32_t at, Part part) const {
    const double from = std::max(corner + at * size, 0.0), to = std::min(corner + (at + 1) * size, double(count));
    for (auto i = static_cast<std::uint32_t>(from); i < to; ++i) {
      part(i, (std::min(to, i + 1.0) - std::max(from, double(i))) / size);
    }
  }
};

std::uint8_t gray_of(double brightness) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(brightness, 0.0, 1.0)));
}

}  // namespace

GrayPicture shade(const SpanModel& spans, const std::vector<double>& brightness, std::uint32_t width, std::uint32_t height,
                  double pixels_per_mm) {
  GrayPicture picture{width, height, std::vector<std::uint8_t>(std::size_t{width} * height, 255), {}, 0};
  std::vector<double> row(width);
  const std::vector<Span>& all = spans.spans;
  for (std::size_t i = 0; i < all.size();) {
    const std::uint32_t line = all[i].line;
    std::fill(row.begin(), row.end(), 1.0);
    for (; i < all.size() && all[i].line == line; ++i) {
      const double darkness = 1 - (all[i].face < brightness.size() ? brightness[all[i].face] : 1);
      const double from = std::clamp(all[i].x_from * pixels_per_mm, 0.0, double(width)),
                   to = std::clamp(all[i].x_to * pixels_per_mm, 0.0, double(width));
      for (auto x = static_cast<std::uint32_t>(from); x < to; ++x) {
        row[x] -= darkness * (std::min(to, x + 1.0) - std::max(from, double(x)));
      }
    }
    if (line >= height) continue;
    for (std::uint32_t x = 0; x < width; ++x) {
      picture.gray[std::size_t{line} * width + x] = gray_of(row[x]);
    }
  }
  return picture;
}

GrayPicture shade(const PixelModel& pixels, const std::vector<double>& brightness, std::uint32_t width, std::uint32_t height,
                  double pixels_per_mm) {
  GrayPicture picture{width, height, std::vector<std::uint8_t>(std::size_t{width} * height, 255), {}, 0};
  const double size = 1 / (pixels_per_mm * pixels.pixel_mm);
  const Resampling columns{-pixels.corner_mm.x / pixels.pixel_mm, size, pixels.width},
      rows{-pixels.corner_mm.y / pixels.pixel_mm, size, pixels.height};
  const auto darkness = [&](std::uint32_t face) { return face < brightness.size() ? 1 - brightness[face] : 0; };
  constexpr std::size_t kRows = 16;
  parallel_blocks(height, kRows, [&](std::size_t begin, std::size_t end) {
    std::vector<double> dark(pixels.width);  // sum of the rows that one row of the picture covers
    for (std::size_t y = begin; y < end; ++y) {
      std::fill(dark.begin(), dark.end(), 0.0);
      rows.of(static_cast<std::uint32_t>(y), [&](std::uint32_t row, double share) {
        const std::uint32_t* faces = pixels.face.data() + std::size_t{row} * pixels.width;
        for (std::uint32_t x = 0; x < pixels.width; ++x) dark[x] += share * darkness(faces[x]);
      });
      for (std::uint32_t x = 0; x < width; ++x) {
        double sum = 0;
        columns.of(x, [&](std::uint32_t column, double share) { sum += share * dark[column]; });
        picture.gray[y * width + x] = gray_of(1 - sum);
      }
    }
  });
  return picture;
}

GrayPicture gray_pixels(const PixelModel& pixels, const std::vector<double>& brightness) {
  GrayPicture picture{pixels.width, pixels.height, {}, pixels.corner_mm, pixels.pixel_mm};
  picture.gray.reserve(pixels.face.size());
  for (const std::uint32_t face : pixels.face) {
    picture.gray.push_back(face < brightness.size() ? gray_of(brightness[face]) : 255);
  }
  return picture;
}

}  // namespace ligne
