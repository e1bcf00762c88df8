// Spans and pixels with the transparent faces in front of them: worked out by hand, and against a search at single points.

#include "support/scenes.hpp"

namespace ligne::test::transparent_layers_test {
namespace {

using Faces = std::vector<std::uint32_t>;

/// The visible faces at a point: transparent ones from front to back, then the opaque one or kNone.
struct Seen {
  Faces in_front;
  std::uint32_t face = kNone;
  friend bool operator==(const Seen&, const Seen&) = default;
};

std::ostream& operator<<(std::ostream& out, const Seen& seen) {
  out << "glass";
  for (const std::uint32_t f : seen.in_front) out << ' ' << f;
  return out << " before " << static_cast<std::int32_t>(seen.face);
}

Seen seen_of(const TransparentLayers& layers, std::uint32_t face, std::uint32_t list) {
  Seen seen{{}, face};
  layers.for_each(list, [&](std::uint32_t f) { seen.in_front.push_back(f); });
  return seen;
}

/// A scene with its faces from below the page corner (0, 0) upwards, at a scale of 1, seen from above.
struct PanesScene {
  Scene scene;
  ProjectedScene projected;

  PanesScene(const std::vector<std::vector<Point3>>& faces, const std::vector<std::uint32_t>& transparent) {
    scene = scene_of_faces(faces);
    scene.materials = {{"plain", {0.8, 0.8, 0.8}, 1}, {"glass", {0.5, 0.7, 0.9}, 0.4}};
    scene.face_material.assign(faces.size(), 0);
    for (const std::uint32_t f : transparent) scene.face_material[f] = 1;
    finish(scene);
    const View view =
        make_view(scene, make_camera(along({0, 0, -1}), scene), {{{0, 0}, {100, 100}}}, {{0, 0}, {100, 100}}, 1);
    projected = project(scene, build_topology(scene), view, {classes("all"), 30});
  }

  VisibilityResult result(const char* method) const {
    VisibilityOptions options;
    options.span_lines = SpanLines{0.25, 0.5, 200};
    options.with_transparent_faces = true;
    return find_method(method)->compute_visibility(projected, options);
  }
};

Seen span_at(const SpanModel& model, std::uint32_t line, double x) {
  for (const Span& s : model.spans)
    if (s.line == line && s.x_from <= x && x < s.x_to) return seen_of(model.layers, s.face, s.in_front);
  return {};
}

Seen pixel_at(const PixelModel& model, Point2 page_mm) {
  const auto column = static_cast<std::uint32_t>((page_mm.x - model.corner_mm.x) / model.pixel_mm),
             row = static_cast<std::uint32_t>((page_mm.y - model.corner_mm.y) / model.pixel_mm);
  const std::size_t i = std::size_t{row} * model.width + column;
  return seen_of(model.layers, model.face[i], model.in_front.empty() ? 0 : model.in_front[i]);
}

std::vector<Point3> plate(double x0, double x1, double z0, double z1) {
  return {{x0, 0, z0}, {x1, 0, z1}, {x1, 80, z1}, {x0, 80, z0}};
}

/// Two panes before a plate, beside each other and beside the plate.
TEST(TransparentFaces, ListsAreFromFrontToBack) {
  const PanesScene s({plate(40, 80, 0, 0), plate(0, 60, 20, 20), plate(20, 80, 10, 10)}, {1, 2});
  const VisibilityResult spans = s.result("watkins"), pixels = s.result("zbuffer");
  EXPECT_EQ(spans.left_out, "");
  const std::vector<std::pair<double, Seen>> expected = {
      {10, {{1}, kNone}}, {30, {{1, 2}, kNone}}, {50, {{1, 2}, 0}}, {70, {{2}, 0}}};
  for (const auto& [x, seen] : expected) {
    for (const std::uint32_t line : {30u, 100u, 170u}) {
      const Point2 page{10 + x, line * 0.5 + 0.25};
      EXPECT_EQ(span_at(*spans.spans, line, page.x), seen) << x;
      EXPECT_EQ(pixel_at(*pixels.pixels, page), seen) << x;
    }
  }
  EXPECT_EQ(span_at(*spans.spans, 100, 5), Seen{});
  // Four spans a line, and their ends are those of the faces.
  const auto on_line = [](const Span& span) { return span.line == 100; };
  EXPECT_EQ(std::ranges::count_if(spans.spans->spans, on_line), 4);
  const auto first = std::ranges::find_if(spans.spans->spans, on_line);
  EXPECT_NEAR(first->x_from, 10, 1e-6);
  EXPECT_NEAR(first->x_to, 30, 1e-6);
}

/// Panes of one plane: the lower number is in front on every line. A pane in the plane of an opaque face likewise.
TEST(TransparentFaces, TouchingFacesKeepOneOrder) {
  const PanesScene s({plate(0, 80, 3, 7), plate(10, 70, 3.5, 6.5), plate(20, 60, 4, 6)}, {0, 2});
  const VisibilityResult spans = s.result("watkins"), pixels = s.result("zbuffer");
  for (std::uint32_t line = 30; line < 170; ++line) {
    EXPECT_EQ(span_at(*spans.spans, line, 15), (Seen{{0}, kNone})) << line;
    EXPECT_EQ(span_at(*spans.spans, line, 50), (Seen{{0}, 1})) << line;
    EXPECT_EQ(pixel_at(*pixels.pixels, {15, line * 0.5 + 0.25}), (Seen{{0}, kNone})) << line;
  }
}

/// Depths of the faces over a point of the scene, nearest first. Nothing if a border or another depth is near.
std::optional<Seen> search(const std::vector<std::vector<Point3>>& faces, const std::vector<std::uint32_t>& transparent,
                           double x, double y) {
  constexpr double kNearBorder = 0.02, kNearDepth = 0.05;
  std::vector<std::pair<double, std::uint32_t>> over;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    const Point3 &a = faces[f][0], &b = faces[f][1], &c = faces[f][2];
    const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const double v = ((x - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) / area,
                 w = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x)) / area, u = 1 - v - w;
    const double least = std::min({u, v, w});
    if (std::abs(least) < kNearBorder) return std::nullopt;
    if (least > 0) over.emplace_back(-(u * a.z + v * b.z + w * c.z), f);
  }
  std::ranges::sort(over);
  Seen seen;
  for (std::size_t i = 0; i < over.size(); ++i) {
    if (i > 0 && over[i].first - over[i - 1].first < kNearDepth) return std::nullopt;
    if (std::ranges::find(transparent, over[i].second) == transparent.end()) {
      seen.face = over[i].second;
      break;
    }
    seen.in_front.push_back(over[i].second);
  }
  return seen;
}

TEST(TransparentFaces, IsThatOfASearchAtPoints) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(0, 80), height(-15, 15);
  std::size_t points = 0, stacked = 0;
  for (int round = 0; round < 12; ++round) {
    // Two plates span the drawing, so that it lies at the same place of the page.
    std::vector<std::vector<Point3>> faces = {{{0, 0, -40}, {80, 0, -40}, {0, 80, -40}},
                                              {{80, 80, -41}, {79, 80, -41}, {80, 79, -41}}};
    for (int i = 0; i < 14; ++i) {
      std::vector<Point3> triangle;
      for (int k = 0; k < 3; ++k) triangle.emplace_back(place(random), place(random), height(random));
      faces.push_back(triangle);
    }
    const std::vector<std::uint32_t> transparent = {2, 3, 4, 5, 6, 7, 8, 9, 10};
    const PanesScene s(faces, transparent);
    const VisibilityResult spans = s.result("watkins"), pixels = s.result("zbuffer");
    for (std::uint32_t line = 22; line < 178; line += 5) {
      for (double x = 10.25; x < 90; x += 0.5) {
        const double y = line * 0.5 + 0.25;
        const std::optional<Seen> expected = search(faces, transparent, x - 10, 90 - y);
        if (!expected) continue;
        ++points;
        stacked += expected->in_front.size() > 2;
        ASSERT_EQ(span_at(*spans.spans, line, x), *expected) << x << ", " << y;
        ASSERT_EQ(pixel_at(*pixels.pixels, {x, y}), *expected) << x << ", " << y;
      }
    }
  }
  EXPECT_GT(points, 10000u);
  EXPECT_GT(stacked, 500u);
}

/// Without VisibilityOptions::with_transparent_faces spans and pixels are those of the opaque faces, and a warning says so.
TEST(TransparentFaces, IsLeftOutIfNotAskedFor) {
  const PanesScene s({plate(40, 80, 0, 0), plate(0, 60, 20, 20)}, {1});
  VisibilityOptions options;
  options.span_lines = SpanLines{0.25, 0.5, 200};
  const VisibilityResult result = find_method("watkins")->compute_visibility(s.projected, options);
  EXPECT_TRUE(result.spans->layers.empty());
  EXPECT_EQ(result.left_out, "1 transparent faces from the areas");
  for (const Span& span : result.spans->spans) EXPECT_EQ(span.face, 0u);
}

}  // namespace
}  // namespace ligne::test::transparent_layers_test
