#include "picture/raster/shading.hpp"

#include <algorithm>
#include <cmath>

#include "base/no_index.hpp"

namespace ligne {

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

namespace {

std::uint8_t gray_of(double brightness) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(brightness, 0.0, 1.0)));
}

constexpr std::size_t kRows = 16;  ///< rows of a task

/// A white picture of N components a pixel.
template <std::size_t N>
FacePicture white(std::uint32_t width, std::uint32_t height) {
  FacePicture picture{width, height, {}, {}, 0};
  (N == 1 ? picture.gray : picture.rgb).assign(N * width * height, 255);
  return picture;
}

/// Writes pixel number `i`.
template <std::size_t N>
void put(FacePicture& picture, std::size_t i, const std::array<double, N>& brightness) {
  std::uint8_t* const out = (N == 1 ? picture.gray : picture.rgb).data() + N * i;
  for (std::size_t c = 0; c < N; ++c) out[c] = gray_of(brightness[c]);
}

/// The colour at the middle of a pixel of a model; white where it shows no face.
template <std::size_t N>
std::array<double, N> color_at(const PixelModel& pixels, const ColorAt<N>& at, std::uint32_t column, std::uint32_t row) {
  const std::size_t i = std::size_t{row} * pixels.width + column;
  const SeenFace seen{pixels.face[i], pixels.in_front.empty() ? TransparentLayers::kEmptyList : pixels.in_front[i]};
  std::array<double, N> paper;
  paper.fill(1);
  if (seen.face == kNone && seen.in_front == TransparentLayers::kEmptyList) return paper;
  return at(seen, pixels.corner_mm + pixels.pixel_mm * Point2{column + 0.5, row + 0.5});
}

}  // namespace

template <std::size_t N>
FacePicture paint(const SpanModel& spans, ColorAt<N> at, std::uint32_t width, std::uint32_t height, double pixels_per_mm) {
  FacePicture picture = white<N>(width, height);
  const std::vector<Span>& all = spans.spans;
  parallel_blocks(height, kRows, [&](std::size_t begin, std::size_t end) {
    std::vector<std::array<double, N>> row(width);
    std::array<double, N> paper;
    paper.fill(1);
    auto span = std::partition_point(all.begin(), all.end(), [&](const Span& s) { return s.line < begin; });
    for (; span != all.end() && span->line < end;) {
      const std::uint32_t line = span->line;
      std::fill(row.begin(), row.end(), paper);
      for (; span != all.end() && span->line == line; ++span) {
        const double from = std::clamp(span->x_from * pixels_per_mm, 0.0, double(width)),
                     to = std::clamp(span->x_to * pixels_per_mm, 0.0, double(width));
        for (auto x = static_cast<std::uint32_t>(from); x < to; ++x) {
          const double left = std::max(from, double(x)), right = std::min(to, x + 1.0);
          const std::array<double, N> brightness =
              at({span->face, span->in_front}, {(left + right) / 2 / pixels_per_mm, spans.lines.y_mm(line)});
          for (std::size_t c = 0; c < N; ++c) row[x][c] -= (1 - brightness[c]) * (right - left);
        }
      }
      for (std::uint32_t x = 0; x < width; ++x) put<N>(picture, std::size_t{line} * width + x, row[x]);
    }
  });
  return picture;
}

template <std::size_t N>
FacePicture paint(const PixelModel& pixels, ColorAt<N> at, std::uint32_t width, std::uint32_t height, double pixels_per_mm) {
  FacePicture picture = white<N>(width, height);
  const double size = 1 / (pixels_per_mm * pixels.pixel_mm);
  const Resampling columns{-pixels.corner_mm.x / pixels.pixel_mm, size, pixels.width},
      rows{-pixels.corner_mm.y / pixels.pixel_mm, size, pixels.height};
  parallel_blocks(height, kRows, [&](std::size_t begin, std::size_t end) {
    std::vector<std::array<double, N>> dark(pixels.width);  // sum of the rows that one row of the picture covers
    for (std::size_t y = begin; y < end; ++y) {
      std::fill(dark.begin(), dark.end(), std::array<double, N>{});
      rows.of(static_cast<std::uint32_t>(y), [&](std::uint32_t row, double share) {
        for (std::uint32_t x = 0; x < pixels.width; ++x) {
          const std::array<double, N> brightness = color_at<N>(pixels, at, x, row);
          for (std::size_t c = 0; c < N; ++c) dark[x][c] += share * (1 - brightness[c]);
        }
      });
      for (std::uint32_t x = 0; x < width; ++x) {
        std::array<double, N> sum{};
        columns.of(x, [&](std::uint32_t column, double share) {
          for (std::size_t c = 0; c < N; ++c) sum[c] += share * dark[column][c];
        });
        for (double& component : sum) component = 1 - component;
        put<N>(picture, y * width + x, sum);
      }
    }
  });
  return picture;
}

template <std::size_t N>
FacePicture paint_each(const PixelModel& pixels, ColorAt<N> at) {
  FacePicture picture = white<N>(pixels.width, pixels.height);
  picture.corner_mm = pixels.corner_mm;
  picture.pixel_mm = pixels.pixel_mm;
  parallel_blocks(pixels.height, kRows, [&](std::size_t begin, std::size_t end) {
    for (std::size_t row = begin; row < end; ++row) {
      for (std::uint32_t x = 0; x < pixels.width; ++x) {
        put<N>(picture, row * pixels.width + x, color_at<N>(pixels, at, x, static_cast<std::uint32_t>(row)));
      }
    }
  });
  return picture;
}

template FacePicture paint<1>(const SpanModel&, ColorAt<1>, std::uint32_t, std::uint32_t, double);
template FacePicture paint<3>(const SpanModel&, ColorAt<3>, std::uint32_t, std::uint32_t, double);
template FacePicture paint<1>(const PixelModel&, ColorAt<1>, std::uint32_t, std::uint32_t, double);
template FacePicture paint<3>(const PixelModel&, ColorAt<3>, std::uint32_t, std::uint32_t, double);
template FacePicture paint_each<1>(const PixelModel&, ColorAt<1>);
template FacePicture paint_each<3>(const PixelModel&, ColorAt<3>);

}  // namespace ligne
