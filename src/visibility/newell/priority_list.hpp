#pragma once
/// The priority list of Newell, Newell and Sancha: elements in an order in which none hides one behind it in the list.
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
  std::uint64_t zones = 0;       ///< sets that were found apart on the page, nested
  std::uint64_t slabs = 0;       ///< sets that were found apart in depth, nested
  std::uint64_t lists = 0;       ///< sets that could not be decomposed and were sorted
  std::uint64_t ahead = 0;       ///< elements that were compared with their sets before they were the head
  std::uint64_t one_body = 0;    ///< pairs of one convex body that were not compared
  std::uint64_t separated = 0;   ///< pairs of two sides of a separating plane that were not compared
  std::uint64_t one_way = 0;     ///< pairs not compared the other way round, since convex faces do not penetrate
  std::uint64_t opened = 0;      ///< bodies whose faces took their place
  std::uint64_t compared = 0;    ///< pairs of an element and one of its set Q_p
  std::uint64_t apart_in_x = 0;  ///< of them, by the test that gave the answer
  std::uint64_t apart_in_y = 0;
  std::uint64_t behind_plane = 0;
  std::uint64_t before_plane = 0;
  std::uint64_t projections = 0;  ///< compared edge by edge
  std::uint64_t disjoint = 0;     ///< of them, those that proved to be disjoint
  std::uint64_t depths = 0;       ///< compared in depth over what they have in common
  std::uint64_t farther = 0;      ///< of them, those that proved to be nowhere in front
  std::uint64_t moved = 0;        ///< elements that were marked and moved to the head of the list
  std::uint64_t plane_cuts = 0;   ///< elements cut by the plane of another one
  std::uint64_t page_cuts = 0;    ///< elements halved on the page because both planes fail

  void add(const ListCounts& o);
};

/// Sorts all elements, farthest first; cuts those that have no place in an order.
class PriorityList {
 public:
  using Set = std::vector<std::uint32_t>;

  /// `keep_sets`: zones() and slabs() are wanted. The first list is by depth; but elements of an earlier list keep their
  /// order, and the others are put among them where they reach as far. Any list may be the first, since it is checked and
  /// mended; in a good one fewer elements have to be moved.
  explicit PriorityList(PaintElements& elements, bool keep_sets = false);

  std::vector<std::uint32_t> sort();
  const ListCounts& counts() const { return counts_; }

  /// A set that was found apart from others: its extents, and its number among them, from 1; slabs are painted in this
  /// order.
  struct FoundSet {
    Extents extents;
    std::uint32_t number = 0;
  };
  /// How a set was decomposed. `x` and `y`: into zones side by side, from the left or from the top; `depth`: into slabs,
  /// from the nearest on; `list`: not at all, it was sorted; `one`: it is one element.
  enum class Division : std::uint8_t { x, y, depth, list, one };
  /// A set of the decomposition, [Boulle1980] 2.5.2.7, figure 2.88: node 0 is the whole, children stand behind their parent
  /// in the order of their division.
  struct SetNode {
    std::uint32_t parent = 0;
    Division division = Division::list;
    Set elements{};
  };
  /// The tree of the decomposition, where sets are kept.
  const std::vector<SetNode>& tree() const { return tree_; }
  const std::vector<FoundSet>& zones() const { return zones_; }
  const std::vector<FoundSet>& slabs() const { return slabs_; }

 private:
  /// How far an element reaches, the farthest first, and its number. There is one order, of the list and of the sets Q_p;
  /// depths that are equal as floats stand by their numbers.
  using Key = std::uint64_t;
  using Keys = std::vector<Key>;
  static constexpr Key kLast = ~Key{0};
  static Key key(double reach, std::uint32_t element);
  static std::uint32_t element_of(Key k) { return static_cast<std::uint32_t>(k); }  ///< kNone of kLast

  /// A set that is not done, and its node in the tree.
  struct OpenSet {
    Set set;
    std::uint32_t node = 0;
  };
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
  std::vector<OpenSet> cells();
  std::vector<std::uint32_t> with_faces_of_bodies();
  bool replace(std::uint32_t element, const ModelPlane& plane, std::uint64_t& count);
  void remove(std::uint32_t element);
  void insert(std::uint32_t element);
  void note(std::uint32_t element);
  double farthest(std::uint32_t element) const { return elements_[element].extents.high[2]; }

  /// How far the comparison of an element with its set Q_p has come. What was found of a pair stays true.
  struct Comparison {
    Keys others;              ///< not yet compared, the farthest last
    Keys before;              ///< what stood before it when it was compared ahead, in any order: most of it will be gone
    std::uint32_t known = 0;  ///< elements with higher numbers were cut later
  };
  Comparison& comparison_of(std::uint32_t p);
  Comparison inherited(const Comparison& whole, std::uint32_t piece) const;
  bool work_off(std::uint32_t p, Keys& set);
  void look_ahead();
  struct AheadWork {
    ListCounts counts;
    CommonPart common;
    Set seen;  ///< per element: for which it was collected last, plus one
  };
  Comparison compared_ahead(std::uint32_t p, AheadWork& work) const;

  PaintElements& elements_;
  PageLevels levels_;
  static constexpr std::uint32_t kBlock = 32;  ///< adjustable
  std::vector<Box> boxes_;                     ///< of every element
  std::vector<Box> blocks_;                    ///< of every kBlock elements together
  ListCounts counts_;
  CommonPart common_;
  Keys keys_;  ///< of every element
  bool keep_sets_;
  std::vector<FoundSet> zones_, slabs_;
  std::vector<SetNode> tree_;
  std::vector<std::uint32_t> order_;

  // The list at hand: what was moved to its head, the initial sort, and what was put in later.
  enum class State : std::uint8_t { waiting, marked, gone };
  std::vector<State> state_;
  Set moved_;
  Set sorted_;
  std::size_t first_ = 0;                                      ///< of sorted_ that may still be waiting
  std::size_t ahead_end_ = 0;                                  ///< sorted_ before it was compared ahead
  std::set<Key> inserted_;                                     ///< pieces that wait
  std::unordered_map<std::uint32_t, Comparison> comparisons_;  ///< of elements that were the head; only looked up
  std::vector<std::uint32_t> seen_;                            ///< per element: for which it was collected last, plus one
};

}  // namespace ligne::newell
