#pragma once
/// Tests lines first against the few facets that hid earlier lines.
///
/// Where many facets pass through each other at one place, a few of them hide nearly all of their common segments.
/// These few are remembered, by the direction of the line that they hid, and tested first.

#include <array>
#include <span>
#include <vector>

#include "visibility/common/cell_grid.hpp"
#include "visibility/common/open_parts.hpp"

namespace ligne {

class OccluderCache {
 public:
  /// `least_steps`: parts no longer than this, in lattice steps, are not drawn.
  OccluderCache(const ProjectedScene& scene, const std::vector<Facet>& facets, double least_steps)
      : scene_(scene), facets_(facets), least_(least_steps) {}

  /// Whether remembered facets, or else facets of the list of a cell (ordered by z_near), hide the line, but for parts too
  /// short to draw. False does not mean that the line is visible: other facets may hide it.
  bool hide(const PageLine& line, std::span<const CellFacet> list, const CellSquare& square);

 private:
  // Adjustable: facets remembered per range of directions, and the number of ranges.
  static constexpr std::size_t kKnown = 8;
  static constexpr int kSlopes = 32, kDirections = 4 * kSlopes;
  /// Adjustable: number of list facets that may be tested in vain, at the start and added for each line.
  static constexpr std::size_t kMaxFailedTests = 100'000, kFailedTestsPerLine = 8;

  struct Known {
    std::array<std::uint32_t, kKnown> facets;
    std::size_t count = 0;
    void remember(std::uint32_t facet);
  };

  static std::size_t direction_of(const PageLine& line);
  bool take(const PageLine& line, std::uint32_t facet);
  bool is_hidden(const PageLine& line);

  const ProjectedScene& scene_;
  const std::vector<Facet>& facets_;
  double least_;
  std::array<Known, kDirections> known_;
  OpenParts open_;
  std::vector<std::uint32_t> found_;
  std::vector<LinePart> parts_;
  std::size_t in_vain_ = 0;                 ///< list facets tested for lines that were not hidden
  std::size_t patience_ = kMaxFailedTests;  ///< limit on in_vain_
};

}  // namespace ligne
