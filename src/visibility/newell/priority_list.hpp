#pragma once
/// The priority list of Newell, Newell and Sancha: elements in an order in which none hides a later one.
///
/// M. E. Newell, R. G. Newell, T. L. Sancha, "A solution to the hidden surface problem", ACM National Conference 1972.
/// docs/methods/newell.md.

#include <cstdint>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "visibility/newell/page_levels.hpp"
#include "visibility/newell/paint_elements.hpp"

namespace ligne::newell {

struct ListCounts {
  std::uint64_t zones = 0;       ///< sets with disjoint extents on the page, nested
  std::uint64_t slabs = 0;       ///< sets with disjoint depths, nested
  std::uint64_t lists = 0;       ///< sets that could not be decomposed and were sorted
  std::uint64_t ahead = 0;       ///< elements compared with their sets before they became the head
  std::uint64_t one_body = 0;    ///< pairs of one convex body, not compared
  std::uint64_t separated = 0;   ///< pairs separated by a plane, not compared
  std::uint64_t one_way = 0;     ///< pairs compared one way only, because convex faces do not penetrate
  std::uint64_t opened = 0;      ///< bodies replaced by their faces
  std::uint64_t compared = 0;    ///< pairs of an element and a member of its set Q_p
  std::uint64_t apart_in_x = 0;  ///< these pairs by the test that decided
  std::uint64_t apart_in_y = 0;
  std::uint64_t behind_plane = 0;
  std::uint64_t before_plane = 0;
  std::uint64_t projections = 0;  ///< pairs compared edge by edge
  std::uint64_t disjoint = 0;     ///< of these, disjoint pairs
  std::uint64_t depths = 0;       ///< pairs compared in depth over their common part
  std::uint64_t farther = 0;      ///< of these, pairs where the first is nowhere in front
  std::uint64_t moved = 0;        ///< elements marked and moved to the head of the list
  std::uint64_t plane_cuts = 0;   ///< elements cut by the plane of another element
  std::uint64_t page_cuts = 0;    ///< elements halved on the page because both planes failed

  void add(const ListCounts& o);
};

/// Sorts all elements, farthest first, and cuts elements without an order.
class PriorityList {
 public:
  using Set = std::vector<std::uint32_t>;

  /// `keep_sets`: keeps zones(), slabs() and tree(). The initial list is sorted by depth. Elements of an earlier list keep
  /// their order, and the others are merged by depth. Any initial list gives a correct result; a good one needs fewer moves.
  explicit PriorityList(PaintElements& elements, bool keep_sets = false);

  std::vector<std::uint32_t> sort();
  const ListCounts& counts() const { return counts_; }

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
  /// Sort key: farthest depth, farthest first, then element number for depths equal as floats. The list and the sets Q_p
  /// share this order.
  using Key = std::uint64_t;
  using Keys = std::vector<Key>;
  static constexpr Key kLast = ~Key{0};
  static Key key(double reach, std::uint32_t element);
  static std::uint32_t element_of(Key k) { return static_cast<std::uint32_t>(k); }  ///< kNone for kLast

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

  void sort_list(const Set& set);
  void output(std::uint32_t element);

  std::uint32_t head();
  bool settle(std::uint32_t p);
  bool resolve(std::uint32_t p, std::uint32_t q);
  bool may_hide(std::uint32_t p, std::uint32_t q) { return may_hide(p, q, counts_, common_); }
  bool may_hide(std::uint32_t p, std::uint32_t q, ListCounts& counts, CommonPart& work) const;
  void put_in_place(std::uint32_t whole, const std::vector<std::uint32_t>& parts);
  bool open_body(std::uint32_t p, std::uint32_t q);
  std::vector<std::uint32_t> with_faces_of_bodies();
  bool replace(std::uint32_t element, const ModelPlane& plane, std::uint64_t& count);
  void remove(std::uint32_t element);
  void insert(std::uint32_t element);
  void note(std::uint32_t element);
  double farthest(std::uint32_t element) const { return elements_[element].extents.high[2]; }

  /// The progress of comparing an element with its set Q_p. The result for a pair stays valid.
  struct Comparison {
    Keys others;              ///< not yet compared, farthest last
    Keys before;              ///< elements before it when it was compared ahead, unordered; most will be gone
    std::uint32_t known = 0;  ///< elements with higher numbers were made later
  };
  Comparison& comparison_of(std::uint32_t p);
  Comparison inherited(const Comparison& whole, std::uint32_t piece) const;
  bool work_off(std::uint32_t p, Keys& set);
  void look_ahead();
  struct AheadWork {
    ListCounts counts;
    CommonPart common;
    Set seen;  ///< per element: 1 + the last element whose comparison collected it
  };
  Comparison compared_ahead(std::uint32_t p, AheadWork& work) const;

  PaintElements& elements_;
  PageLevels levels_;
  static constexpr std::uint32_t kBlock = 32;  ///< boxes per block. Tuned
  std::vector<Box> boxes_;                     ///< per element
  std::vector<Box> blocks_;                    ///< union of every kBlock boxes
  ListCounts counts_;
  CommonPart common_;
  Keys keys_;  ///< per element
  bool keep_sets_;
  std::vector<FoundSet> zones_, slabs_;
  std::vector<SetNode> tree_;
  std::vector<std::uint32_t> order_;

  // The current list: elements moved to its head, the initial sort, and pieces inserted later.
  enum class State : std::uint8_t { waiting, marked, gone };
  std::vector<State> state_;
  Set moved_;
  Set sorted_;
  std::size_t first_ = 0;                                      ///< first element of sorted_ that may be waiting
  std::size_t ahead_end_ = 0;                                  ///< elements of sorted_ before this one were compared ahead
  std::set<Key> inserted_;                                     ///< waiting pieces
  std::unordered_map<std::uint32_t, Comparison> comparisons_;  ///< of former heads; only looked up
  std::vector<std::uint32_t> seen_;                            ///< per element: 1 + last element that collected it
};

}  // namespace ligne::newell
