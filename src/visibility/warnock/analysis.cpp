#include "visibility/warnock/analysis.hpp"

#include <algorithm>

namespace ligne::warnock {
namespace {

/// Relation of a face to a window of any form. meets(p, q): whether a side meets the window; `point`: a point of the window.
template <class Meets>
Relation relation_by_sides(const FaceTable& table, const Face& face, FramePoint point, const Meets& meets,
                           std::uint32_t& side, AnalysisCounts& counts) {
  const auto sides = table.sides_of(face);
  const auto side_meets = [&](std::uint32_t i) {
    ++counts.side_tests;
    return meets(table.at(sides[i].v0), table.at(sides[i].v1));
  };
  if (side < sides.size() && side_meets(side)) {
    ++counts.remembered;
    return Relation::intersector;
  }
  for (std::uint32_t i = 0; i < sides.size(); ++i) {
    if (i == side || !side_meets(i)) continue;
    side = i;
    return Relation::intersector;
  }
  // No side meets the window, so any point of the window decides.
  int turns = 0;
  for (const Side& s : sides) turns += winding(table.at(s.v0), table.at(s.v1), point);
  return turns != 0 ? Relation::surrounder : Relation::disjoint;
}

}  // namespace

Relation relation_to(const FaceTable& table, const Face& face, const Window& window, std::uint32_t& side,
                     AnalysisCounts& counts) {
  if (!face.box.meets(window)) {
    ++counts.box;
    return Relation::disjoint;
  }
  return relation_by_sides(
      table, face, {window.u0, window.v0}, [&](FramePoint p, FramePoint q) { return meets(p, q, window); }, side, counts);
}

Relation relation_to(const FaceTable& table, const Face& face, const ConvexWindow& window, double margin,
                     std::uint32_t& side, AnalysisCounts& counts) {
  if (!face.box.meets(window.box().grown(margin))) {
    ++counts.box;
    return Relation::disjoint;
  }
  return relation_by_sides(
      table, face, window.middle(), [&](FramePoint p, FramePoint q) { return window.meets(p, q, margin); }, side, counts);
}

/// A window with the margin.
struct Analysis::LargerRectangle {
  Window window;

  bool empty() const { return window.empty(); }
  const Window& box() const { return window; }
  bool holds(const FaceBox& face) const { return face.inside(window); }
  Relation relation(const FaceTable& table, const Face& face, std::uint32_t& side, AnalysisCounts& counts) const {
    return relation_to(table, face, window, side, counts);
  }
  DepthRange depths(const Face& face) const { return face.depths_over(window); }
};

/// A polygon, with the margin round its box.
struct Analysis::LargerPolygon {
  const ConvexWindow* window;
  double margin;
  Window larger_box;

  bool empty() const { return window->empty(); }
  const Window& box() const { return larger_box; }
  bool holds(const FaceBox&) const { return false; }
  Relation relation(const FaceTable& table, const Face& face, std::uint32_t& side, AnalysisCounts& counts) const {
    return relation_to(table, face, *window, margin, side, counts);
  }
  DepthRange depths(const Face& face) const { return face.depths_over(*window, margin); }
};

template <class Larger>
void Analysis::add(Element element, const Larger& larger, Lists& lists, AnalysisCounts& counts) const {
  ++counts.faces;
  if (element.relation == Relation::surrounder) {
    ++counts.inherited;
  } else if (!element.box.meets(larger.box())) {
    ++counts.box;
    return;
  } else if (larger.holds(element.box)) {
    ++counts.inside;
    if (!drop_hidden_ || element.near <= lists.occluder_depth) lists.elements.push_back(element);
    return;
  } else {
    if (!remember_sides_) element.side = 0;
    element.relation = larger.relation(table_, table_.faces[element.face], element.side, counts);
    if (element.relation == Relation::disjoint) return;
  }
  const Face& face = table_.faces[element.face];
  const DepthRange depths = larger.depths(face);
  element.near = std::max(element.near, round_down(depths.near));
  if (drop_hidden_ && element.near > lists.occluder_depth) return;
  lists.elements.push_back(element);
  if (element.relation == Relation::surrounder)
    lists.occluder_depth = std::min(lists.occluder_depth, round_up(depths.far + face.slack));
}

/// Removes elements that were listed before their cover was found.
void Analysis::finish(Lists& lists) const {
  if (drop_hidden_) std::erase_if(lists.elements, [&](const Element& e) { return e.near > lists.occluder_depth; });
}

Lists Analysis::begin(const Window& window, AnalysisCounts& counts) const {
  Lists lists;
  const LargerRectangle larger{window.grown(margin_)};
  const std::size_t n = table_.faces.size();
  lists.elements.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint32_t f = table_.by_depth[i];
    const Face& face = table_.faces[f];
    if (drop_hidden_ && face.z_near > lists.occluder_depth) {
      counts.not_studied += n - i;
      break;
    }
    const FaceBox box{round_down(face.box.u0), round_up(face.box.u1), round_down(face.box.v0), round_up(face.box.v1)};
    add({f, 0, face.z_near, Relation::intersector, box}, larger, lists, counts);
  }
  finish(lists);
  return lists;
}

template <class Larger, std::size_t kCount>
std::array<Lists, kCount> Analysis::children_of(const Lists& parent, const std::array<Larger, kCount>& windows,
                                                AnalysisCounts& counts) const {
  std::array<Lists, kCount> lists;
  std::array<bool, kCount> open{};
  int left = 0;
  for (std::size_t k = 0; k < kCount; ++k) {
    lists[k].occluder_depth = parent.occluder_depth;
    open[k] = !windows[k].empty();
    left += open[k];
  }
  for (std::size_t i = 0; i < parent.elements.size() && left > 0; ++i) {
    const Element& element = parent.elements[i];
    for (std::size_t k = 0; k < kCount; ++k) {
      if (!open[k]) continue;
      // The list is sorted by the faces' own z_near, and element.near >= z_near.
      if (drop_hidden_ && element.near > lists[k].occluder_depth &&
          table_.faces[element.face].z_near > lists[k].occluder_depth) {
        counts.not_studied += parent.elements.size() - i;
        open[k] = false;
        --left;
        continue;
      }
      add(element, windows[k], lists[k], counts);
    }
  }
  for (Lists& l : lists) finish(l);
  return lists;
}

std::array<Lists, 4> Analysis::children(const Lists& parent, const std::array<Window, 4>& windows,
                                        AnalysisCounts& counts) const {
  constexpr Window kNoWindow{0, -1, 0, -1};
  std::array<LargerRectangle, 4> larger;
  for (std::size_t k = 0; k < 4; ++k) larger[k].window = windows[k].empty() ? kNoWindow : windows[k].grown(margin_);
  return children_of(parent, larger, counts);
}

std::array<Lists, 2> Analysis::children(const Lists& parent, const std::array<ConvexWindow, 2>& windows,
                                        AnalysisCounts& counts) const {
  const auto larger = [&](const ConvexWindow& w) { return LargerPolygon{&w, margin_, w.box().grown(margin_)}; };
  return children_of(parent, std::array{larger(windows[0]), larger(windows[1])}, counts);
}

}  // namespace ligne::warnock
