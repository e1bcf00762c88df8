#pragma once
/// Whether a line is hidden by one or two of the facets that hid the lines before it.
///
/// Where many facets pass through each other at one place nearly all of their common segments are hidden, and by a few of
/// them: those are remembered, by the direction of the line that they hid, and asked first.

#include <array>
#include <vector>

#include "visibility/common/cell_grid.hpp"
#include "visibility/common/open_parts.hpp"

namespace ligne {

class CrowdHiders {
 public:
  /// Parts no longer than `least_steps` are not drawn.
  CrowdHiders(const ProjectedScene& scene, const std::vector<Facet>& facets, double least_steps)
      : scene_(scene), facets_(facets), least_(least_steps) {}

  /// Whether facets that were met before, or else facets of the list (by z_near), hide so much of the line that nothing of
  /// it would be drawn. A line that nothing would be left of if all facets of the scene were asked may still be denied.
  bool hide(const PageLine& line, const CellFacet* list, std::size_t count);

 private:
  // Adjustable: facets remembered for lines of about one direction, and the ranges of directions.
  static constexpr std::size_t kKnown = 8;
  static constexpr int kSlopes = 32, kDirections = 4 * kSlopes;
  /// Adjustable: facets of lists that may be asked in vain, at first and for each line.
  static constexpr std::size_t kPatience = 100'000, kPatiencePerLine = 8;

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
  std::size_t in_vain_ = 0;           ///< facets of lists asked for lines that are seen
  std::size_t patience_ = kPatience;  ///< how many that may be
};

}  // namespace ligne
