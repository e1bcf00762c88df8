#pragma once
/// Finds the visible parts of lines by testing them against bodies.

#include <cstdint>
#include <mutex>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/roberts/bodies.hpp"

namespace ligne::roberts {

/// Counts for the statistics.
struct BodyCounts {
  std::uint64_t own = 0;     ///< lines hidden by their own body
  std::uint64_t bodies = 0;  ///< tests of a line against a body
  std::uint64_t beside = 0;  ///< such tests in which the line is outside the silhouette
  std::uint64_t before = 0;  ///< such tests in which the line is in front of the body
  std::uint64_t behind = 0;  ///< such tests in which the line is behind all planes
  std::uint64_t planes = 0;  ///< tests of a line against a plane
  std::uint64_t facets = 0;  ///< tests of a line against a facet: where the line touches or pierces the front
  void operator+=(const BodyCounts& o) {
    own += o.own;
    bodies += o.bodies;
    beside += o.beside;
    before += o.before;
    behind += o.behind;
    planes += o.planes;
    facets += o.facets;
  }
};

/// Counts of all threads.
struct BodyTotals {
  std::mutex mutex;
  BodyCounts counts;
};

enum class LineKind : std::uint8_t { edge, intersection };

/// Tests lines one by one. It keeps its working memory from line to line; the destructor adds the counts to `totals`.
class BodyLines {
 public:
  BodyLines(const Bodies& bodies, double coincidence_steps, LineKind kind, BodyTotals& totals)
      : bodies_(bodies), coincidence_steps_(coincidence_steps), kind_(kind), totals_(totals) {}
  BodyLines(const BodyLines&) = delete;
  BodyLines& operator=(const BodyLines&) = delete;
  ~BodyLines() {
    const std::lock_guard lock(totals_.mutex);
    totals_.counts += counts_;
  }

  /// Finds the visible parts of the line, in order, disjoint.
  void find(const PageLine& line, std::vector<LinePart>& parts);

 private:
  /// The bodies on which the line lies.
  struct Own {
    std::uint32_t bodies[2] = {kNone, kNone};
    bool hidden = false;     ///< one of them hides the whole line
    bool by_facets = false;  ///< they may hide it, and only facets can decide: the line names only one face of each
                             ///< body
  };
  /// Position of the line relative to a body's whole front.
  enum class Depth : std::uint8_t { before, behind, unknown };

  Own own_of(const PageLine& line) const;
  void take_body(const PageLine& line, const Body& body);
  bool clip_to_silhouette(const PageLine& line, const Body& body, HiddenInterval& inside) const;
  Depth depth_of(const PageLine& line, const Body& body, double enter, double leave);
  void take_facets(const PageLine& line, const Body& body);
  void take_facet(const PageLine& line, std::uint32_t facet);

  const Bodies& bodies_;
  double coincidence_steps_;
  LineKind kind_;
  BodyTotals& totals_;
  OpenParts open_;
  BodyCounts counts_;
};

}  // namespace ligne::roberts
