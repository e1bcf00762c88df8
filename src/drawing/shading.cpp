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

constexpr std::uint32_t kNoFace = 0xffffffffu;
constexpr std::size_t kRows = 16;  ///< rows of a task

/// Paints spans. darkness(span, x_mm) is called with the middle of the part of the span in a pixel.
template <class Darkness>
GrayPicture shade_spans(const SpanModel& spans, std::uint32_t width, std::uint32_t height, double pixels_per_mm,
                        Darkness darkness) {
  GrayPicture picture{width, height, std::vector<std::uint8_t>(std::size_t{width} * height, 255), {}, 0};
  const std::vector<Span>& all = spans.spans;
  parallel_blocks(height, kRows, [&](std::size_t begin, std::size_t end) {
    std::vector<double> row(width);
    auto span = std::partition_point(all.begin(), all.end(), [&](const Span& s) { return s.line < begin; });
    for (; span != all.end() && span->line < end;) {
      const std::uint32_t line = span->line;
      std::fill(row.begin(), row.end(), 1.0);
      for (; span != all.end() && span->line == line; ++span) {
        const double from = std::clamp(span->x_from * pixels_per_mm, 0.0, double(width)),
                     to = std::clamp(span->x_to * pixels_per_mm, 0.0, double(width));
        for (auto x = static_cast<std::uint32_t>(from); x < to; ++x) {
          const double left = std::max(from, double(x)), right = std::min(to, x + 1.0);
          row[x] -= darkness(*span, (left + right) / 2 / pixels_per_mm) * (right - left);
        }
      }
      for (std::uint32_t x = 0; x < width; ++x) picture.gray[std::size_t{line} * width + x] = gray_of(row[x]);
    }
  });
  return picture;
}

/// Paints the mean of the pixels of a model. darkness(column, row) is that of one of them.
template <class Darkness>
GrayPicture shade_pixels(const PixelModel& pixels, std::uint32_t width, std::uint32_t height, double pixels_per_mm,
                         Darkness darkness) {
  GrayPicture picture{width, height, std::vector<std::uint8_t>(std::size_t{width} * height, 255), {}, 0};
  const double size = 1 / (pixels_per_mm * pixels.pixel_mm);
  const Resampling columns{-pixels.corner_mm.x / pixels.pixel_mm, size, pixels.width},
      rows{-pixels.corner_mm.y / pixels.pixel_mm, size, pixels.height};
  parallel_blocks(height, kRows, [&](std::size_t begin, std::size_t end) {
    std::vector<double> dark(pixels.width);  // sum of the rows that one row of the picture covers
    for (std::size_t y = begin; y < end; ++y) {
      std::fill(dark.begin(), dark.end(), 0.0);
      rows.of(static_cast<std::uint32_t>(y), [&](std::uint32_t row, double share) {
        for (std::uint32_t x = 0; x < pixels.width; ++x) dark[x] += share * darkness(x, row);
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

/// The tone at the middle of a pixel of a model; 1 where it shows no face.
double tone_of_pixel(const PixelModel& pixels, std::uint32_t column, std::uint32_t row, ToneAt tone) {
  const std::uint32_t face = pixels.face[std::size_t{row} * pixels.width + column];
  if (face == kNoFace) return 1;
  return tone(face, pixels.corner_mm + pixels.pixel_mm * Point2{column + 0.5, row + 0.5});
}

}  // namespace

GrayPicture shade(const SpanModel& spans, const std::vector<double>& brightness, std::uint32_t width, std::uint32_t height,
                  double pixels_per_mm) {
  return shade_spans(spans, width, height, pixels_per_mm, [&](const Span& span, double) {
    return 1 - (span.face < brightness.size() ? brightness[span.face] : 1);
  });
}

GrayPicture shade(const SpanModel& spans, ToneAt tone, std::uint32_t width, std::uint32_t height, double pixels_per_mm) {
  return shade_spans(spans, width, height, pixels_per_mm, [&](const Span& span, double x_mm) {
    return 1 - tone(span.face, {x_mm, spans.lines.y_mm(span.line)});
  });
}

GrayPicture shade(const PixelModel& pixels, const std::vector<double>& brightness, std::uint32_t width, std::uint32_t height,
                  double pixels_per_mm) {
  return shade_pixels(pixels, width, height, pixels_per_mm, [&](std::uint32_t column, std::uint32_t row) {
    const std::uint32_t face = pixels.face[std::size_t{row} * pixels.width + column];
    return face < brightness.size() ? 1 - brightness[face] : 0;
  });
}

GrayPicture shade(const PixelModel& pixels, ToneAt tone, std::uint32_t width, std::uint32_t height, double pixels_per_mm) {
  return shade_pixels(pixels, width, height, pixels_per_mm,
                      [&](std::uint32_t column, std::uint32_t row) { return 1 - tone_of_pixel(pixels, column, row, tone); });
}

GrayPicture gray_pixels(const PixelModel& pixels, ToneAt tone) {
  GrayPicture picture{pixels.width, pixels.height, {}, pixels.corner_mm, pixels.pixel_mm};
  picture.gray.resize(pixels.face.size());
  parallel_blocks(pixels.height, kRows, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      for (std::uint32_t x = 0; x < pixels.width; ++x) {
        picture.gray[row * pixels.width + x] = gray_of(tone_of_pixel(pixels, x, static_cast<std::uint32_t>(row), tone));
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
