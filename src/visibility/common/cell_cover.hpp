#pragma once
/// The cover that hides the depth of a cell: one facet, or a connected patch of facets that do so together.

#include <cstdint>
#include <optional>
#include <vector>

#include "base/no_index.hpp"
#include "visibility/common/facet_in_cell.hpp"

namespace ligne {

/// Finds the patch that covers a cell and hides most. A patch is a set of facets such that across every side of them that
/// passes through the cell another one of them goes on, on the other side of it. Then their union covers the cell: a point
/// of the cell on the border of the union would lie inside a facet or on such a side, or be a corner round which facet
/// follows facet, each by an angle of its own, until they close. One object serves many cells, and holds their work space.
class CellCover {
 public:
  /// `margin`: steps by which cells are widened.
  CellCover(const ProjectedScene& scene, const std::vector<Facet>& facets, double margin)
      : scene_(scene), facets_(facets), margin_(margin) {}

  /// The farthest depth over the cell of the patch for which that is the nearest, depth tolerance added, if there is a
  /// patch. hides(facet): whether it may belong to one. The list is in the order of z_near: mostly a surface in front covers
  /// the cell, and then nothing that begins behind it need be looked at.
  template <class Hides>
  std::optional<float> find(const CellFacet* list, std::size_t n, const CellSquare& square, Hides hides) {
    square_ = square;
    members_.clear();
    uses_.clear();
    const auto add_from = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const Facet& f = facets_[list[i].facet];
        if (hides(f)) add(f);
      }
    };
    const std::size_t in_front = widest_gap(list, n);
    add_from(0, in_front);
    const std::optional<float> depth = choose_patch();
    if (depth && *depth < list[in_front].z_near) return depth;
    add_from(in_front, n);
    return choose_patch();
  }

  /// Whether a facet lies behind the patch found last wherever it is in the cell.
  bool hides(const Facet& f) const;

 private:
  static constexpr std::uint32_t kStays = 0xffffffffu;
  struct Member {
    FacetFunctions functions;
    double z_far = 0;              ///< over the cell, depth tolerance added
    std::uint32_t round = kStays;  ///< in which it was removed
  };
  /// A side of a member that passes through the cell.
  struct SideUse {
    std::uint64_t side;  ///< its places, the lower first
    bool reversed;       ///< the member has it from the higher place to the lower
    std::uint32_t member;
    std::uint32_t next = kNone;  ///< use of the same side
  };
  /// A slot in a hash table of sides; it holds the side that was put into it in round `filled` of filling it.
  struct Slot {
    std::uint64_t side;
    std::uint32_t number, filled = 0;
  };

  /// Where in the middle third of the list the depths are farthest apart.
  static std::size_t widest_gap(const CellFacet* list, std::size_t n);

  void add(const Facet& f);
  std::optional<float> choose_patch();
  void number_sides();
  /// Removes a member, and those that it leaves with a side on which nothing goes on, and so on.
  void remove(std::uint32_t member, std::uint32_t round);
  /// Removes what ends within the cell: it belongs to no patch.
  void remove_ends();

  const ProjectedScene& scene_;
  const std::vector<Facet>& facets_;
  double margin_;
  CellSquare square_;
  std::vector<Member> members_;
  std::vector<SideUse> uses_;
  std::vector<Slot> slots_;
  std::uint32_t filled_ = 0;
  std::vector<std::uint32_t> first_use_;     ///< of each side
  std::vector<std::uint32_t> alive_[2];      ///< by side: uses of members alive, forward and reversed
  std::vector<std::uint32_t> member_sides_;  ///< by member: up to three times 2 side + reversed, kNone for fewer
  std::vector<std::uint32_t> removed_, by_depth_;
  std::vector<FacetFunctions> planes_;  ///< of the patch; none where it has too many
};

}  // namespace ligne
