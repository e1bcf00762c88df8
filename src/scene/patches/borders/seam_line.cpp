#include "scene/patches/borders/seam_line.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace ligne {
namespace {

// Adjustable.
/// Least part of the length of a line that has sections, and least part of that at which these agree.
constexpr double kMostMeasured = 0.6, kMostAgreeing = 0.6;
/// Least value of both for a line of few edges.
constexpr double kWholeLine = 0.99;
/// Largest curvature of the flat side where a section agrees, in that of the round one.
constexpr double kAgreeingRatio = 0.5;
/// Limits of the ratio of the curvatures, which is negative at an inflection.
constexpr double kLeastSeamRatio = -0.6, kLargestSeamRatio = 0.4;
/// Limits of the turn of the round side over a face, radians, and of the error.
constexpr double kLeastLineTurn = 0.03, kLargestLineTurn = 1.3, kLargestLineError = 0.3;
/// Least ratio of the depths, and least one of a line of few edges.
constexpr double kLeastLineDepths = 0.8, kLeastDepthsOfFew = 1.5;
constexpr std::size_t kFewLineEdges = 3;
/// Limits of a line one of whose sides is nearly flat.
constexpr double kClearRatio = 0.15, kLeastClearTurn = 0.1, kLargestClearError = 0.1, kMostClearAgreeing = 0.8;
/// Least ratio of curvatures where both sides bend alike.
constexpr double kEvenRatio = 0.6;

/// A value with the length of the line that it stands for.
using Weighted = std::pair<double, double>;

double median(std::vector<Weighted> values) {
  double all = 0, sum = 0;
  for (const Weighted& value : values) all += value.second;
  std::ranges::sort(values);
  for (const auto& [number, weight] : values) {
    sum += weight;
    if (2 * sum >= all) return number;
  }
  return 0;
}

template <class Value>
double median_of(std::span<const LineSection> sections, Value value) {
  std::vector<Weighted> values;
  for (const LineSection& at : sections) {
    if (at.section) values.emplace_back(value(*at.section), at.length);
  }
  return median(std::move(values));
}

}  // namespace

bool LineBend::may_be_seam() const {
  const double least_depths = edges > kFewLineEdges ? kLeastLineDepths : kLeastDepthsOfFew;
  return measured >= kMostMeasured && agreeing >= kMostAgreeing && ratio > kLeastSeamRatio && ratio < kLargestSeamRatio &&
         turn > kLeastLineTurn && turn < kLargestLineTurn && depths >= least_depths && error <= kLargestLineError;
}

bool LineBend::is_clear() const {
  return std::abs(ratio) <= kClearRatio && turn >= kLeastClearTurn && error <= kLargestClearError &&
         agreeing >= kMostClearAgreeing;
}

bool LineBend::is_even() const { return measured > 0 && (std::abs(ratio) > kEvenRatio || turn < kLeastLineTurn); }

bool LineBend::is_whole() const { return measured >= kWholeLine && agreeing >= kWholeLine; }

LineBend bend_along(std::span<const LineSection> sections) {
  LineBend bend;
  bend.edges = sections.size();
  for (const LineSection& at : sections) {
    bend.length += at.length;
    if (at.section) bend.measured += at.length;
  }
  if (bend.measured == 0) return bend;
  std::array<double, 2> medians{};
  for (const std::size_t side : {0, 1})
    medians[side] = median_of(sections, [&](const SeamSection& at) { return at.curvatures[side]; });
  const std::size_t round = std::abs(medians[0]) > std::abs(medians[1]) ? 0 : 1, flat = 1 - round;
  if (medians[round] == 0) return bend;
  for (const LineSection& at : sections) {
    if (!at.section) continue;
    const std::array<double, 2>& curvatures = at.section->curvatures;
    const bool is_usual = curvatures[round] * medians[round] > 0;
    if (is_usual && std::abs(curvatures[flat]) < kAgreeingRatio * std::abs(curvatures[round])) bend.agreeing += at.length;
  }
  bend.agreeing /= bend.measured;
  bend.measured /= bend.length;
  bend.ratio = medians[flat] / medians[round];
  bend.turn = median_of(sections, [&](const SeamSection& at) { return at.turn(round); });
  bend.depth = median_of(sections, [&](const SeamSection& at) { return at.depths[round]; });
  bend.depths = median_of(sections, [&](const SeamSection& at) { return at.depths[flat] / at.depths[round]; });
  bend.error = median_of(sections, [&](const SeamSection& at) {
    const double sags = at.turn(round) * at.depths[round];
    return sags > 0 ? at.error / sags : std::numeric_limits<double>::infinity();
  });
  return bend;
}

}  // namespace ligne
