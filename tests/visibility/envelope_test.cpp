#include "visibility/horizon/envelope.hpp"
#include "support/test.hpp"

namespace ligne::horizon {
namespace {

std::vector<Span> raised(ExactEnvelope& envelope, const Line& line) {
  std::vector<Span> above;
  envelope.raise(line, above);
  return above;
}

void expect_spans(const std::vector<Span>& spans, const std::vector<Span>& expected) {
  ASSERT_EQ(spans.size(), expected.size());
  for (std::size_t i = 0; i < spans.size(); ++i) {
    EXPECT_NEAR(spans[i].from, expected[i].from, 1e-12);
    EXPECT_NEAR(spans[i].to, expected[i].to, 1e-12);
  }
}

TEST(ExactEnvelope, BandsTogetherFindWhatTheWholeFinds) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> at(0, 10);
  const Columns columns(0, 10, 50);
  const Bands bands(columns);
  ASSERT_GT(bands.size(), 1u);
  ExactEnvelope whole(0, 10, 50);
  std::vector<ExactEnvelope> parts;
  for (std::size_t b = 0; b < bands.size(); ++b) parts.emplace_back(columns, bands.of_band(b));
  for (int k = 0; k < 2000; ++k) {
    const auto [from, to] = std::minmax({at(random), at(random)});
    const Line line{from, at(random) + k / 200., to, at(random) + k / 200.};
    std::vector<Span> all, joined;
    whole.find_above(line, all);
    for (ExactEnvelope& part : parts) {
      std::vector<Span> found, unused;
      part.find_above(line, found);
      part.raise(line, unused);
      for (const Span& span : found) append_span(joined, span, part.least());
    }
    ASSERT_EQ(joined.size(), all.size()) << k;
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_EQ(joined[i].from, all[i].from);
      EXPECT_EQ(joined[i].to, all[i].to);
    }
    whole.raise(line, all);
    // On both sides of a border each of the two bands knows the height.
    for (std::size_t b = 0; b < bands.size(); ++b) {
      const double border = columns.begin(bands.of_band(b).begin);
      EXPECT_EQ(parts[b].height(border), whole.height(border));
      EXPECT_EQ(parts[b].height_beside(border, -1), whole.height_beside(border, -1));
    }
  }
}

TEST(ExactEnvelope, WhatBeginsOnTheHorizonIsNeitherAboveNorBelow) {
  ExactEnvelope envelope(0, 10, 4);
  raised(envelope, {0, 1, 10, 7});
  expect_spans(raised(envelope, {0, 1, 5, 9}), {{0, 5}});
  expect_spans(raised(envelope, {5, 4, 10, 0}), {});
}

TEST(ExactEnvelope, EndsOfLinesAreTheirVeryEnds) {
  // Ends on borders of cells, where rounding may put them on either side.
  ExactEnvelope envelope(-0.3, 0.4, 7);
  for (int i = 0; i < 7; ++i) {
    const Line line{-0.3 + 0.1 * i, 1.0 * i, -0.3 + 0.1 * (i + 1), 3};
    const std::vector<Span> above = raised(envelope, line);
    ASSERT_EQ(above.size(), 1u);
    EXPECT_EQ(above[0].from, line.u0);
    EXPECT_EQ(above[0].to, line.u1);
  }
}

/// Random lines against all lines before them, sampled; the number of cells changes nothing.
TEST(ExactEnvelope, IsTheHighestOfAllLines) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(0, 1);
  std::vector<Line> lines;
  ExactEnvelope one(0, 1, 1), many(0, 1, 64);
  for (int i = 0; i < 300; ++i) {
    double u0 = place(random), u1 = place(random);
    if (u0 > u1) std::swap(u0, u1);
    const Line line{u0, place(random), u1, place(random)};
    const auto height = [](const Line& l, double u) { return l.v0 + (l.v1 - l.v0) * (u - l.u0) / (l.u1 - l.u0); };
    const std::vector<Span> above = raised(one, line), again = raised(many, line);
    expect_spans(again, above);
    for (double u = line.u0 + 1e-4; u < line.u1; u += 7e-3) {
      double highest = kNothing;
      for (const Line& l : lines)
        if (l.u0 < u && u < l.u1) highest = std::max(highest, height(l, u));
      const double d = height(line, u) - highest;
      if (std::abs(d) < 1e-9) continue;
      const bool is_above = std::any_of(above.begin(), above.end(), [u](const Span& s) { return s.from <= u && u <= s.to; });
      EXPECT_EQ(is_above, d > 0) << "line " << i << " at " << u;
    }
    lines.push_back(line);
  }
}

}  // namespace
}  // namespace ligne::horizon
