#include "picture/z_buffer.hpp"
#include <cairo.h>

namespace ligne::test {
namespace {

constexpr double kMarginMm = 10;
constexpr double kNothing = std::numeric_limits<double>::infinity();

/// One face is far before another when it is so by this many pixels in depth.
constexpr double kFarBefore = 8;
/// Two planes meet at a steep angle when their normals differ by more: well above the 30 degrees of a crease.
const double kSteepCosine = std::cos(40 * 3.14159265358979323846 / 180);
/// Faces that make a smaller angle with the sight are seen edge on: one as long as the sheet is narrower than half a pixel.
constexpr double kEdgeOnSine = 0.5 / kWidth;
/// An edge is clearly behind a face when it is so by this many pixels in depth, at every pixel around.
constexpr double kClearlyBehind = 0.5;

}  // namespace

ZBuffer::ZBuffer(const Scene& scene, const ViewPoint& view)
    : scene_(scene),
      perspective_(view.eye.has_value()),
      planes_(scene.faces.size()),
      face_(static_cast<std::size_t>(kWidth) * kHeight, -1),
      depth_(face_.size(), kNothing) {
  const Point3 forward = glm::normalize(view.direction);
  const Point3 right = glm::normalize(glm::cross(forward, Point3{0, 0, 1})), down = glm::cross(forward, right);
  const Point3 eye = view.eye.value_or(Point3{0, 0, 0});
  double low_x = kNothing, low_y = kNothing, high_x = -kNothing, high_y = -kNothing;
  for (const Point3& v : scene.vertices) {
    const Point3 d = v - eye;
    const double w = glm::dot(forward, d), shrink = perspective_ ? 1 / w : 1;
    vertices_.push_back({glm::dot(right, d) * shrink, glm::dot(down, d) * shrink, w});
    low_x = std::min(low_x, vertices_.back().x);
    high_x = std::max(high_x, vertices_.back().x);
    low_y = std::min(low_y, vertices_.back().y);
    high_y = std::max(high_y, vertices_.back().y);
  }
  const double free_width = kWidth - 2 * kMarginMm * kPixelsPerMm, free_height = kHeight - 2 * kMarginMm * kPixelsPerMm;
  const double scale = std::min(free_width / (high_x - low_x), free_height / (high_y - low_y));
  const double mean_depth = perspective_ ? glm::length(view.direction) : 1;
  const double shift_x = kWidth / 2.0 - scale * (low_x + high_x) / 2, shift_y = kHeight / 2.0 - scale * (low_y + high_y) / 2;
  for (Projected& p : vertices_) p = {p.x * scale + shift_x, p.y * scale + shift_y, p.depth * scale / mean_depth};

  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    std::vector<std::vector<Projected>> contours(scene.faces.contour_count(f));
    Point3 normal{0, 0, 0};
    const auto outer = scene.faces.contour(f, 0);
    const Point3 origin = scene.vertices[outer[0]];
    for (std::size_t i = 0; i < outer.size(); ++i)
      normal += glm::cross(scene.vertices[outer[i]] - origin, scene.vertices[outer[(i + 1) % outer.size()]] - origin);
    if (glm::length(normal) == 0) continue;
    normal = glm::normalize(normal);
    const Point3 sight = perspective_ ? glm::normalize(origin - eye) : forward;
    if (glm::dot(normal, sight) > 0) normal = -normal;
    if (-glm::dot(normal, sight) < kEdgeOnSine) continue;
    for (std::size_t c = 0; c < contours.size(); ++c)
      for (const std::uint32_t v : scene.faces.contour(f, c)) contours[c].push_back(vertices_[v]);
    // In camera coordinates the plane is n.x X + n.y Y + n.z W = e. With X = u W and Y = v W in a perspective, e / W is
    // linear in the page.
    const Point3 n{glm::dot(normal, right), glm::dot(normal, down), glm::dot(normal, forward)};
    const double e = glm::dot(normal, origin - eye), to_pixels = scale / mean_depth;
    Plane& plane = planes_[f];
    plane.normal = normal;
    if (perspective_) {
      const double k = e * to_pixels;
      plane.b = n.x / scale / k;
      plane.c = n.y / scale / k;
      plane.a = n.z / k - plane.b * shift_x - plane.c * shift_y;
    } else {
      plane.b = -n.x / n.z;
      plane.c = -n.y / n.z;
      plane.a = e * scale / n.z - plane.b * shift_x - plane.c * shift_y;
    }
    fill(static_cast<std::int32_t>(f), contours);
  }
}

double ZBuffer::depth(std::int32_t face, double x, double y) const {
  const Plane& plane = planes_[static_cast<std::size_t>(face)];
  const double value = plane.a + plane.b * x + plane.c * y;
  return perspective_ ? 1 / value : value;
}

void ZBuffer::fill(std::int32_t face, const std::vector<std::vector<Projected>>& contours) {
  std::vector<double> crossings;
  for (int y = 0; y < kHeight; ++y) {
    const double row = y + 0.5;
    crossings.clear();
    for (const auto& contour : contours) {
      for (std::size_t i = 0; i < contour.size(); ++i) {
        const Projected &p = contour[i], &q = contour[(i + 1) % contour.size()];
        if ((p.y > row) == (q.y > row)) continue;
        crossings.push_back(p.x + (row - p.y) / (q.y - p.y) * (q.x - p.x));
      }
    }
    std::sort(crossings.begin(), crossings.end());
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const int first = std::max(0, static_cast<int>(std::ceil(crossings[i] - 0.5)));
      const int last = std::min(kWidth - 1, static_cast<int>(std::floor(crossings[i + 1] - 0.5)));
      for (int x = first; x <= last; ++x) {
        const double z = depth(face, x + 0.5, row);
        double& nearest = depth_[index({x, y})];
        if (z >= nearest) continue;
        nearest = z;
        face_[index({x, y})] = face;
      }
    }
  }
}

bool ZBuffer::is_strong_jump(Pixel a, Pixel b) const {
  const std::int32_t fa = face_at(a), fb = face_at(b);
  if (fa == fb) return false;
  if (fa < 0 || fb < 0) return true;
  const Plane &pa = planes_[static_cast<std::size_t>(fa)], &pb = planes_[static_cast<std::size_t>(fb)];
  if (glm::dot(pa.normal, pb.normal) < kSteepCosine) return true;
  const double at_a = depth(fb, a.x + 0.5, a.y + 0.5) - depth_[index(a)],
               at_b = depth_[index(b)] - depth(fa, b.x + 0.5, b.y + 0.5);
  return std::min(at_a, at_b) > kFarBefore || std::max(at_a, at_b) < -kFarBefore;
}

std::vector<std::uint8_t> ZBuffer::lines_allowed() const {
  std::vector<std::uint8_t> allowed(face_.size(), 0);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (const Pixel next : {Pixel{x + 1, y}, Pixel{x, y + 1}}) {
        if (next.x >= kWidth || next.y >= kHeight || face_at({x, y}) == face_at(next)) continue;
        allowed[index({x, y})] = allowed[index(next)] = 1;
      }
    }
  }
  const auto farthest_around = [&](int x, int y) {
    double farthest = 0;
    for (int v = std::max(0, y - 1); v <= std::min(kHeight - 1, y + 1); ++v) {
      for (int u = std::max(0, x - 1); u <= std::min(kWidth - 1, x + 1); ++u) {
        const std::int32_t face = face_at({u, v});
        if (face < 0) return kNothing;
        farthest = std::max(farthest, depth_[index({u, v})]);
      }
    }
    return farthest;
  };
  for (std::size_t f = 0; f < scene_.faces.size(); ++f) {
    for (std::size_t c = 0; c < scene_.faces.contour_count(f); ++c) {
      const auto contour = scene_.faces.contour(f, c);
      for (std::size_t i = 0; i < contour.size(); ++i) {
        const Projected &p = vertices_[contour[i]], &q = vertices_[contour[(i + 1) % contour.size()]];
        const int steps = 1 + static_cast<int>(2 * std::hypot(q.x - p.x, q.y - p.y));
        for (int s = 0; s <= steps; ++s) {
          const double t = double(s) / steps;
          const int x = static_cast<int>(p.x + t * (q.x - p.x)), y = static_cast<int>(p.y + t * (q.y - p.y));
          if (x < 0 || y < 0 || x >= kWidth || y >= kHeight) continue;
          const double z = perspective_ ? 1 / ((1 - t) / p.depth + t / q.depth) : p.depth + t * (q.depth - p.depth);
          if (z - kClearlyBehind < farthest_around(x, y)) allowed[index({x, y})] = 1;
        }
      }
    }
  }
  return allowed;
}

namespace {

/// Two pixels are near when their centres are no farther apart than 1.5 pixels, 0.375 mm: the pixel itself and its eight
/// neighbours. Half the pen is 0.7 pixels, and a jump is told within one.
constexpr int kNear = 1;

std::size_t index(int x, int y) { return static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x); }

std::vector<std::uint8_t> grown(const std::vector<std::uint8_t>& mask) {
  std::vector<std::uint8_t> result(mask.size(), 0);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (!mask[index(x, y)]) continue;
      for (int v = std::max(0, y - kNear); v <= std::min(kHeight - 1, y + kNear); ++v)
        for (int u = std::max(0, x - kNear); u <= std::min(kWidth - 1, x + kNear); ++u) result[index(u, v)] = 1;
    }
  }
  return result;
}

}  // namespace

Ink read_ink(const std::filesystem::path& png) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create_from_png(png.c_str()), cairo_surface_destroy);
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) throw std::runtime_error(png.string() + ": no PNG");
  if (cairo_image_surface_get_width(surface.get()) != kWidth || cairo_image_surface_get_height(surface.get()) != kHeight)
    throw std::runtime_error(png.string() + ": not of the size that was asked for");
  constexpr unsigned char kHalf = 128;
  Ink ink(static_cast<std::size_t>(kWidth) * kHeight, 0);
  const unsigned char* const data = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) ink[index(x, y)] = data[y * stride + 4 * x + 1] < kHalf;
  return ink;
}

std::string Disagreement::words() const {
  char buffer[256];
  const double mm = 1.0 / kPixelsPerMm;
  std::snprintf(
      buffer, sizeof buffer,
      "%zu of %zu dark pixels lie at no line, the first at page mm (%.2f, %.2f); of %zu jumps %zu have no line, the first at (%.2f, %.2f)",
      stray, ink, first_stray.x * mm, first_stray.y * mm, jumps, missing, first_missing.x * mm, first_missing.y * mm);
  return buffer;
}

Disagreement compare(const Ink& ink, const ZBuffer& picture) {
  Disagreement result;
  const std::vector<std::uint8_t> lines = grown(picture.lines_allowed()), inked = grown(ink);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (ink[index(x, y)]) {
        ++result.ink;
        if (!lines[index(x, y)] && result.stray++ == 0) result.first_stray = {x, y};
      }
      for (const Pixel next : {Pixel{x + 1, y}, Pixel{x, y + 1}}) {
        if (next.x >= kWidth || next.y >= kHeight || !picture.is_strong_jump({x, y}, next)) continue;
        ++result.jumps;
        if (inked[index(x, y)] || inked[index(next.x, next.y)]) continue;
        if (result.missing++ == 0) result.first_missing = {x, y};
      }
    }
  }
  return result;
}

}  // namespace ligne::test
