#pragma once
/// Visible strokes of the scene's edges as the lines that they will be drawn as.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/no_index.hpp"
#include "drawing/stroke.hpp"

namespace ligne {

/// Strokes of one class that continue each other, as make_drawing() joins them, are a run. Where a run ends, the end of a
/// run of another class may continue it: of the ends that are left at a place, the straightest pairs.
class StrokeLines {
 public:
  struct Run {
    double length = 0;  ///< lattice steps
    LineClass line_class = LineClass::mesh;
    std::uint32_t longest_beside = kNone;  ///< of the runs of other classes that continue it: the longest
  };

  /// O(n).
  explicit StrokeLines(const std::vector<Stroke>& strokes);

  /// The strokes of the scene's edges that are seen, in ascending order.
  const std::vector<std::uint32_t>& seen() const { return seen_; }
  /// The lowest stroke of its run stands for it.
  std::uint32_t chain_of(std::uint32_t stroke) const { return run_of_[stroke]; }
  const Run& run(std::uint32_t lowest) const { return runs_[lowest]; }

 private:
  void link(const std::vector<Stroke>& strokes, std::vector<std::uint32_t>& same, std::vector<std::uint32_t>& other) const;

  std::vector<std::uint32_t> seen_, run_of_;
  std::vector<Run> runs_;
};

}  // namespace ligne
