#pragma once
/// The priority list of Newell, Newell and Sancha: elements in an order in which none hides a later one.
///
/// M. E. Newell, R. G. Newell, T. L. Sancha, "A solution to the hidden surface problem", ACM National Conference 1972.
/// docs/methods/newell.md.

#include <cstdint>
#include <span>
#include <vector>

#include "visibility/newell/list_sorter.hpp"
#include "visibility/newell/paint_elements.hpp"

namespace ligne::newell {

struct ListOptions {
  bool keep_sets = false;  ///< keeps zones(), slabs() and tree()
  bool parallel = true;    ///< sorts lists at the same time; otherwise one after the other, with the same result
};

/// Sorts all elements, farthest first, and cuts elements without an order.
///
/// Zones and slabs end in lists that do not concern each other ([Boulle1980] 2.6), so threads sort them at the same time.
class PriorityList {
 public:
  using Set = std::vector<std::uint32_t>;

  /// The initial list is sorted by depth. Elements of an earlier list keep their order, and the others are merged by depth.
  /// Any initial list gives a correct result; a good one needs fewer moves.
  explicit PriorityList(PaintElements& elements, ListOptions options = {});

  std::vector<std::uint32_t> sort();
  const ListCounts& counts() const { return counts_; }

  /// A set that could not be decomposed.
  struct SortedList {
    std::size_t elements = 0;  ///< before cuts
    std::uint64_t compared = 0, cuts = 0;
  };
  /// The lists in the order of painting.
  const std::vector<SortedList>& lists() const { return lists_; }

  /// A set with extents disjoint from others, and its number among them, from 1. Slabs are numbered in painting order.
  struct FoundSet {
    Extents extents;
    std::uint32_t number = 0;
  };
  /// The division of a set. `x`, `y`: into zones side by side, from the left or from the top. `depth`: into slabs, nearest
  /// first. `list`: none, the set was sorted. `one`: a single element.
  enum class Division : std::uint8_t { x, y, depth, list, one };
  /// A set of the decomposition, [Boulle1980] 2.5.2.7, figure 2.88. Node 0 is the whole scene. Children follow their parent
  /// in the order of their division.
  struct SetNode {
    std::uint32_t parent = 0;
    Division division = Division::list;
    Set elements{};
  };
  /// The tree of the decomposition; empty unless sets are kept.
  const std::vector<SetNode>& tree() const { return tree_; }
  const std::vector<FoundSet>& zones() const { return zones_; }
  const std::vector<FoundSet>& slabs() const { return slabs_; }

 private:
  /// An unprocessed set, and its node in the tree.
  struct OpenSet {
    Set set;
    std::uint32_t node = 0;
  };
  // divide_list.cpp
  std::vector<OpenSet> cells();
  bool decompose(const OpenSet& open, std::vector<OpenSet>& waiting);
  void keep(const std::vector<Set>& parts, bool slabs);
  std::uint32_t add_node(const Set& set, std::uint32_t parent);
  void set_division(const OpenSet& open, Division division);

  struct Group;
  void add_leaf(const Set& set);
  std::span<const std::uint32_t> leaf(std::size_t number) const;
  std::vector<Group> groups() const;
  void sort_lists();
  void sort_group(Group& group);
  void collect(const std::vector<Group>& groups);
  Set with_faces_of_bodies();

  PaintElements& elements_;
  ListOptions options_;
  ListCounts counts_;
  std::vector<SortKey> keys_;  ///< per element of the initial list
  std::vector<FoundSet> zones_, slabs_;
  std::vector<SetNode> tree_;
  // The sets that nothing divides, farthest first: those of one element, and the lists.
  Set leaves_;                          ///< their elements
  std::vector<std::size_t> leaf_ends_;  ///< end of each in leaves_
  std::vector<SortedList> lists_;
  Set order_;
};

}  // namespace ligne::newell
