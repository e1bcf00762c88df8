/// Text as single strokes.

#include "plotting/stroke_text.hpp"
#include "plotting/readers/utf8.hpp"
#include "support/test.hpp"

namespace ligne {
namespace {

struct Drawn {
  Polylines lines;
  Rect ink;
  std::size_t boxes = 0;
};

Drawn drawn(const TextItem& item) {
  Drawn result;
  result.boxes = append_stroke_text(item, result.lines);
  for (const Point2 p : result.lines.points) result.ink.extend(p);
  return result;
}
Drawn drawn(const std::string& text) { return drawn({text, {0, 0}, 21, TextAcross::left, TextUp::base, 0}); }

TEST(StrokeText, Metrics) {
  // Hershey's capitals are 21 units high; H is 22 units wide and stands on the base line.
  const Drawn h = drawn("H");
  EXPECT_EQ(h.lines.size(), 3u);
  EXPECT_DOUBLE_EQ(h.ink.min.y, -21);
  EXPECT_DOUBLE_EQ(h.ink.max.y, 0);
  const TextExtent extent = text_extent("H", 21, TextStyle::stroke);
  EXPECT_DOUBLE_EQ(extent.width, 22);
  EXPECT_DOUBLE_EQ(extent.ascent, 21);
  EXPECT_DOUBLE_EQ(extent.descent, 0);
  EXPECT_GT(text_extent("g", 21, TextStyle::stroke).descent, 5);
  EXPECT_DOUBLE_EQ(text_extent("HH", 2.1, TextStyle::stroke).width, 4.4);
  EXPECT_DOUBLE_EQ(text_extent("", 21, TextStyle::stroke).width, 0);
  EXPECT_EQ(drawn(" ").lines.size(), 0u);
  EXPECT_GT(text_extent(" ", 21, TextStyle::stroke).width, 0);
}

TEST(StrokeText, InkLiesInTheBoxWhateverTheAnchor) {
  for (const std::string text : {"Ag(y)|", "−2.5·10⁻⁷", "Ålesund, été", "μ ± 3°"}) {
    for (const TextAcross across : {TextAcross::left, TextAcross::center, TextAcross::right}) {
      for (const TextUp up : {TextUp::base, TextUp::middle, TextUp::top}) {
        for (const double rotation : {0.0, 90.0, -90.0, 180.0, 30.0, -137.0}) {
          const TextItem item{text, {10, 20}, 3, across, up, rotation};
          const TextBox box = text_box(item, text_extent(text, 3, TextStyle::stroke));
          const auto [u, v] = box.axes();
          for (const Point2 p : drawn(item).lines.points) {
            const Point2 d = p - box.center;
            EXPECT_LE(std::abs(d.x * u.x + d.y * u.y), box.half.x + 1e-9) << text;
            EXPECT_LE(std::abs(d.x * v.x + d.y * v.y), box.half.y + 1e-9) << text;
          }
        }
      }
    }
  }
}

TEST(StrokeText, AccentsStandOverTheLetterAndRaisedDigitsAboveTheLine) {
  EXPECT_LT(drawn("é").ink.min.y, drawn("e").ink.min.y);
  EXPECT_DOUBLE_EQ(drawn("é").ink.max.y, drawn("e").ink.max.y);
  EXPECT_GT(drawn("ç").ink.max.y, drawn("c").ink.max.y);
  EXPECT_EQ(drawn("ï").lines.size(), drawn("i").lines.size() + 1) << "two dots in place of one";
  EXPECT_LT(drawn("⁷").ink.max.y, -10);
  EXPECT_LT(drawn("⁷").ink.min.y, -21);
}

TEST(StrokeText, WhatIsUnknownIsABoxAndCounted) {
  const Drawn unknown = drawn("a\u6f22\U0001f58b");
  EXPECT_EQ(unknown.boxes, 2u);
  EXPECT_EQ(unknown.lines.size(), drawn("a").lines.size() + 2);
}

TEST(StrokeText, MalformedTextIsHarmless) {
  std::mt19937 random(3);
  std::uniform_int_distribution<int> byte(0, 255), length(0, 40);
  for (int i = 0; i < 5000; ++i) {
    std::string text(static_cast<std::size_t>(length(random)), ' ');
    for (char& c : text) c = static_cast<char>(byte(random));
    const std::string clean = clean_utf8(text);
    EXPECT_EQ(clean_utf8(clean), clean);
    EXPECT_EQ(decode_utf8(clean), decode_utf8(text));
    EXPECT_LE(drawn(text).boxes, text.size());
  }
}

TEST(StrokeText, TextsOfADrawingBecomeALayer) {
  Drawing drawing;
  drawing.texts = {{"HI", {0, 0}, 3}, {"\u6f22", {9, 0}, 3}};
  EXPECT_EQ(draw_texts_as_strokes(drawing), 1u);
  EXPECT_TRUE(drawing.texts.empty());
  ASSERT_EQ(drawing.layers.size(), 1u);
  EXPECT_EQ(drawing.layers[0].name, "text");
  EXPECT_EQ(drawing.layers[0].lines.size(), 3u + 1 + 1);
  Drawing blank;
  blank.texts = {{" ", {0, 0}, 3}};
  EXPECT_EQ(draw_texts_as_strokes(blank), 0u);
  EXPECT_TRUE(blank.layers.empty());
}

}  // namespace
}  // namespace ligne
