#include "linework/overlaps/stroke_tree.hpp"

namespace ligne {

bool StrokeTree::suits(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of, double tolerance) {
  // Adjustable: fewest strokes; size of the sample; number of queries; largest mean number of nodes that a query
  // visits. The teeth of a comb need 17 to 19 nodes. Boxes at any angle (23 to 37) and random strokes (37) were faster
  // with the search by ends.
  constexpr std::size_t kFewest = 4096, kSample = 4096, kSampleQueries = 256, kMostNodes = 20;
  if (of.size() < kFewest || !stroke_directions::are_crossing(strokes, of)) return false;
  std::vector<std::uint32_t> sample;
  for (std::size_t k = 0; k < kSample; ++k) sample.push_back(of[k * of.size() / kSample]);
  const StrokeTree tree(strokes, sample, tolerance);
  std::size_t nodes = 0;
  for (std::size_t k = 0; k < kSampleQueries; ++k) {
    const Stroke& s = strokes[sample[k * kSample / kSampleQueries]];
    for (std::size_t group = 0; group < kGroups; ++group) {
      const FrameSegment line(tree.trees_[group].frame(), s.from, s.to);
      if (const auto question = tree.question_of(group, line, s.from, s.to)) {
        nodes += tree.trees_[group].visited_nodes(line, *question);
      }
    }
  }
  return nodes <= kMostNodes * kSampleQueries;
}

bool StrokeTree::suits_runs(const std::vector<Stroke>& strokes, const std::vector<std::uint32_t>& of, double tolerance) {
  // Samples the strokes; runs pay off if a stroke lies on kMinMeanOverlap others on average. Adjustable.
  constexpr std::size_t kFewest = 4096, kSample = 512, kSampleQueries = 64, kMinMeanOverlap = 8;
  if (of.size() < kFewest) return false;
  const auto sampled = [&](std::size_t k) -> const Stroke& { return strokes[of[k * of.size() / kSample]]; };
  std::size_t common = 0;
  for (std::size_t k = 0; k < kSampleQueries; ++k) {
    const Stroke& s = sampled(k * kSample / kSampleQueries);
    for (std::size_t i = 0; i < kSample; ++i) {
      const Stroke& other = sampled(i);
      if (overlap(s.from, s.to, other.from, other.to, tolerance)) ++common;
    }
  }
  return common >= (kMinMeanOverlap + 1) * kSampleQueries;  // each stroke lies on itself
}

}  // namespace ligne
