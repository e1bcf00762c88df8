#pragma once
/// The cover of a cell: one facet, or a connected patch of facets, that hides everything behind it in the cell.

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/common/facet_in_cell.hpp"

namespace ligne {

/// Finds the patch that covers a cell and hides most. A patch is a set of facets in which every side that passes
/// through the cell has facets of the set on both sides. Then their union covers the cell, as no point of the cell can
/// be on its border: such a point would lie inside a facet, on a side with facets on both sides, or at a corner with a
/// closed ring of facets round it. One object serves many cells, and holds their work space.
class CellCover {
 public:
  /// `margin`: width added round each cell, in lattice steps.
  CellCover(const ProjectedScene& scene, const std::vector<Facet>& facets, double margin)
      : scene_(scene), facets_(facets), margin_(margin) {}

  /// Returns the farthest depth of the nearest patch in the cell, depth tolerance added, if there is a patch.
  /// hides(facet) says whether the facet may belong to a patch. The list is ordered by z_near: usually a surface in front
  /// covers the cell, and facets that begin behind it need not be examined.
  template <class Hides>
  std::optional<float> find(const CellFacet* list, std::size_t n, const CellSquare& square, Hides hides) {
    begin_cell(square);
    std::size_t end = 0;
    const auto add_next = [&] {
      const Facet& f = facets_[list[end++].facet];
      if (hides(f)) add(f);
    };
    while (end < n && list[end].z_near <= covered_depth()) add_next();
    if (covered_depth() == kNotCovered) return std::nullopt;
    std::optional<float> depth = choose_patch();
    while (end < n && !(depth && *depth < list[end].z_near)) {
      // Facets that begin before the patch ends may belong to a nearer one.
      const std::size_t most = depth ? n : std::min(n, 2 * end);
      while (end < most && !(depth && *depth < list[end].z_near)) add_next();
      depth = choose_patch();
    }
    return depth;
  }

  /// Whether the part of a facet in the cell lies all behind the patch found last.
  bool hides(const Facet& f) const;

 private:
  static constexpr std::uint32_t kNotRemoved = 0xffffffffu;
  struct Member {
    FacetFunctions functions;
    double z_far = 0;                   ///< farthest depth in the cell, depth tolerance added
    std::uint32_t round = kNotRemoved;  ///< the round that removed it
  };
  /// A side of a member that passes through the cell.
  struct SideUse {
    std::uint64_t side;  ///< numbers of its two places, the lower in the high half
    bool reversed;       ///< the member's side runs from the higher place to the lower
    std::uint32_t member;
    std::uint32_t next = kNone;  ///< next use of the same side
  };
  /// A slot of the hash table of sides. It is in use if `filled` is the number of the current filling.
  struct Slot {
    std::uint64_t side;
    std::uint32_t number, filled = 0;
  };

  /// Points of the cell that any patch covers: its centre and its corners, with the margin.
  static constexpr std::size_t kSamples = 5;
  static constexpr double kNotCovered = std::numeric_limits<double>::infinity();

  void begin_cell(const CellSquare& square);
  void add(const Facet& f);
  void cover_samples(const Member& member);
  /// Depth within which the members cover all sample points. A patch is rarely nearer.
  double covered_depth() const { return *std::max_element(sample_depths_.begin(), sample_depths_.end()); }
  std::optional<float> choose_patch();
  void number_sides();
  /// Removes a member, then the members that lose their neighbour across a side, and so on.
  void remove(std::uint32_t member, std::uint32_t round);
  /// Removes the members that end within the cell: they belong to no patch.
  void remove_ends();

  const ProjectedScene& scene_;
  const std::vector<Facet>& facets_;
  double margin_;
  CellSquare square_;
  std::array<double, kSamples> sample_depths_{};  ///< per sample point: the nearest Member::z_far of the members over it
  std::vector<Member> members_;
  std::vector<SideUse> uses_;
  std::vector<Slot> slots_;
  std::uint32_t filled_ = 0;
  std::vector<std::uint32_t> first_use_;     ///< of each side
  std::vector<std::uint32_t> alive_[2];      ///< per side: number of uses by remaining members, forward and reversed
  std::vector<std::uint32_t> member_sides_;  ///< three entries per member, each 2 * side + reversed; kNone if unused
  std::vector<std::uint32_t> removed_, by_depth_;
  std::vector<FacetFunctions> planes_;  ///< planes of the patch; empty if it has more than kMostPlanes
};

}  // namespace ligne
