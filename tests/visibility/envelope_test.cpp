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
  ExactEnvelope whole(Columns(0, 10, 50), {0, 50});
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
  ExactEnvelope envelope(Columns(0, 10, 4), {0, 4});
  raised(envelope, {0, 1, 10, 7});
  expect_spans(raised(envelope, {0, 1, 5, 9}), {{0, 5}});
  expect_spans(raised(envelope, {5, 4, 10, 0}), {});
}

TEST(ExactEnvelope, EndsOfLinesAreTheirVeryEnds) {
  // Ends on borders of cells, where rounding may put them on either side.
  ExactEnvelope envelope(Columns(-0.3, 0.4, 7), {0, 7});
  for (int i = 0; i < 7; ++i) {
    const Line line{-0.3 + 0.1 * i, 1.0 * i, -0.3 + 0.1 * (i + 1), 3};
    const std::vector<Span> above = raised(envelope, line);
    ASSERT_EQ(above.size(), 1u);
    EXPECT_EQ(above[0].from, line.u0);
    EXPECT_EQ(above[0].to, line.u1);
  }
}

}  // namespace
}  // namespace ligne::horizon
