// Debug layers that --show draws of a method: numbers of an order, planes of a tree, zones and slabs, spans, clipped
// polygons.

#include "main/tier.hpp"
#include "newell_sorted.hpp"
#include "support/corpus_scene.hpp"
#include "support/standard_views.hpp"
#include "support/variants.hpp"

namespace ligne::test {
namespace {

/// The viewer looks along +y: what has the larger y is farther.
VisibilityResult shown(const Scene& scene, const char* method, std::string_view what) {
  const Picture picture = listed(scene);
  VisibilityOptions options;
  const auto parameters = find_method(method)->traits().parameters;
  const auto show = std::ranges::find(parameters, "show", &MethodParameter::name);
  const auto word = std::ranges::find(show->words, what);
  options.settings.set("show", ParameterWord{static_cast<std::size_t>(word - show->words.begin())});
  return find_method(method)->compute_visibility(picture.projected, options);
}

const Scene kThreePlates = plates({{0, 6, 0, 6, 5, 5}, {3, 9, 3, 9, 2, 2}, {5, 7, 5, 7, 0, 0}});

TEST(Show, NumbersStandOnWhatIsSeenOfTheFacesInTheOrderOfPainting) {
  for (const char* method : {"newell", "bsp", "convex-tree", "painter"}) {
    const VisibilityResult result = shown(kThreePlates, method, "order");
    ASSERT_EQ(result.debug_numbers.size(), 3u) << method;
    for (const PageNumber& n : result.debug_numbers) {
      std::uint32_t last = kNone;
      for (const PaintPiece& piece : result.order->pieces)
        if (holds(piece, n.middle)) last = piece.face;
      EXPECT_EQ(last + 1, n.number) << "the faces are numbered from the farthest on; " << method;
    }
  }
}

TEST(Show, AHiddenFaceHasNoNumber) {
  const VisibilityResult result = shown(plates({{0, 6, 0, 6, 5, 5}, {-1, 9, -1, 9, 2, 2}}), "newell", "order");
  ASSERT_EQ(result.debug_numbers.size(), 1u);
  EXPECT_EQ(result.debug_numbers[0].number, 2u);
}

TEST(Show, PlanesOfATreeAreClosedLines) {
  const VisibilityResult result = shown(studies::ring(5), "bsp", "tree");
  EXPECT_GE(result.debug.size(), 5u);
  for (const auto& line : result.debug) EXPECT_EQ(line.front(), line.back());
  ASSERT_EQ(result.debug_numbers.size(), result.debug.size());
  EXPECT_EQ(result.debug_numbers[0].number, 1u) << "the root";
  for (std::size_t i = 0; i < result.debug.size(); ++i) {
    if (i > 0) {
      EXPECT_LT(result.debug_numbers[i - 1].number, result.debug_numbers[i].number);
    }
    Rect extent;
    for (const Point2 p : result.debug[i]) extent.extend(p);
    const Point2 middle = result.debug_numbers[i].middle;
    EXPECT_TRUE(extent.min.x <= middle.x && middle.x <= extent.max.x && extent.min.y <= middle.y &&
                middle.y <= extent.max.y);
  }
  Scene cube;
  add_box(cube, {0, 0, 0}, {2, 2, 2});
  EXPECT_TRUE(shown(cube, "convex-tree", "tree").debug.empty()) << "a convex body needs no plane";
}

TEST(Show, SlabsAreNumberedFromTheFarthest) {
  const VisibilityResult result = shown(kThreePlates, "newell", "slabs");
  ASSERT_EQ(result.debug.size(), 3u);
  ASSERT_EQ(result.debug_numbers.size(), 3u);
  const auto width = [&](std::size_t i) { return result.debug[i][1].x - result.debug[i][0].x; };
  for (std::size_t i = 0; i < 3; ++i) {
    if (result.debug_numbers[i].number != 3) continue;
    EXPECT_NEAR(width(i) * 3, width((i + 1) % 3), 1e-6) << "the smallest is nearest";
  }
  EXPECT_TRUE(shown(kThreePlates, "newell", "zones").debug.empty());
}

TEST(Show, ZonesAreSetsBesideEachOther) {
  const Scene scene = plates({{0, 4, 0, 4, 5, 1}, {1, 3, 1, 3, 4, 2}, {6, 9, 0, 4, 5, 1}});
  const VisibilityResult result = shown(scene, "newell", "zones");
  ASSERT_EQ(result.debug.size(), 2u);
  EXPECT_LE(result.debug[0][1].x, result.debug[1][0].x);
}

TEST(Show, SpansEndWhereAnotherFaceIsSeen) {
  const VisibilityResult result = shown(plates({{0, 90, 0, 90, 5, 5}, {30, 60, 30, 60, 2, 2}}), "watkins", "spans");
  std::map<double, int> on_line;
  for (const auto& span : result.debug) {
    ASSERT_EQ(span.size(), 4u);
    EXPECT_EQ(span[1].y, span[2].y);
    ++on_line[span[1].y];
  }
  EXPECT_EQ(on_line.begin()->second, 1) << "above the nearer plate";
  int most = 0;
  for (const auto& [y, count] : on_line) most = std::max(most, count);
  EXPECT_EQ(most, 3);
}

TEST(Show, ClipsAreTheContoursOfWhatIsLeft) {
  const Scene scene = plates({{0, 9, 0, 9, 5, 5}, {3, 6, 3, 6, 2, 2}});
  EXPECT_EQ(shown(scene, "atherton-weiler", "clips").debug.size(), 3u) << "a plate with a hole, and the other plate";
}

/// All methods are judged without their debug layers (all_methods_test.cpp): these add to a drawing and change nothing of
/// it.
TEST(Show, ChangesNothingElse) {
  std::map<std::string, int> shown;
  for (const char* name : {"bricks", "cyclic_3", "penetrating_plates_with_holes", "cube_in_glass", "thesis_2_64", "gear"}) {
    const Scene scene = corpus_scene(name);
    for (const StandardView& view : standard_views(scene)) {
      // Seen from the front some scenes have zones beside each other, which newell shows.
      if (view.name != "front" && view.name != "near" && !(view.name == "odd" && runs_all())) continue;
      const Picture picture = draw(scene, {view.camera, "all", false, 0, "appel"});
      std::map<const Method*, std::string> plain_bytes;
      for (const Variant& variant : variants()) {
        if (!variant.is_show) continue;
        VisibilityOptions options;
        options.hidden_strokes = true;
        std::string& plain = plain_bytes[variant.method];
        if (plain.empty()) {
          const VisibilityResult result = variant.method->compute_visibility(picture.projected, options);
          EXPECT_TRUE(result.debug.empty() && result.debug_numbers.empty()) << variant.name;
          plain = bytes_of(result);
        }
        options.settings = variant.settings;
        const VisibilityResult with_layer = variant.method->compute_visibility(picture.projected, options);
        EXPECT_TRUE(plain == bytes_of(with_layer)) << variant.name << ", " << name << ", view " << view.name;
        shown[variant.name] += !with_layer.debug.empty() || !with_layer.debug_numbers.empty() || with_layer.plane;
      }
    }
  }
  EXPECT_GT(shown.size(), 10u);
  for (const auto& [variant, count] : shown) EXPECT_GT(count, 0) << variant << " shows nothing";
}

}  // namespace
}  // namespace ligne::test
