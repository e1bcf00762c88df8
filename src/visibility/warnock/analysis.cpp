#include "visibility/warnock/analysis.hpp"

#include <algorithm>

namespace ligne::warnock {

void AnalysisCounts::operator+=(const AnalysisCounts& o) {
  faces += o.faces;
  inherited += o.inherited;
  box += o.box;
  inside += o.inside;
  remembered += o.remembered;
  side_tests += o.side_tests;
  not_studied += o.not_studied;
}

Relation relation_to(const FaceTable& table, const Face& face, const Window& window, std::uint32_t& side,
                     AnalysisCounts& counts) {
  if (!face.box.meets(window)) {
    ++counts.box;
    return Relation::disjoint;
  }
  const auto sides = table.sides_of(face);
  const auto side_meets = [&](std::uint32_t i) {
    ++counts.side_tests;
    return meets(table.at(sides[i].v0), table.at(sides[i].v1), window);
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
  const FramePoint corner{window.u0, window.v0};
  int turns = 0;
  for (const Side& s : sides) turns += winding(table.at(s.v0), table.at(s.v1), corner);
  return turns != 0 ? Relation::surrounder : Relation::disjoint;
}

void Analysis::add(Element element, const Window& larger, Lists& lists, AnalysisCounts& counts) const {
  ++counts.faces;
  if (element.relation == Relation::surrounder) {
    ++counts.inherited;
  } else if (!element.box.meets(larger)) {
    ++counts.box;
    return;
  } else if (element.box.inside(larger)) {
    ++counts.inside;
    if (!drop_hidden_ || element.near <= lists.occluder_depth) lists.elements.push_back(element);
    return;
  } else {
    if (!remember_sides_) element.side = 0;
    element.relation = relation_to(table_, table_.faces[element.face], larger, element.side, counts);
    if (element.relation == Relation::disjoint) return;
  }
  const Face& face = table_.faces[element.face];
  const DepthRange depths = face.depths_over(larger);
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
  const Window larger = window.grown(margin_);
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

std::array<Lists, 4> Analysis::children(const Lists& parent, const std::array<Window, 4>& windows,
                                        AnalysisCounts& counts) const {
  std::array<Lists, 4> lists;
  std::array<Window, 4> larger;
  std::array<bool, 4> open{};
  int left = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    lists[k].occluder_depth = parent.occluder_depth;
    larger[k] = windows[k].grown(margin_);
    open[k] = !windows[k].empty();
    left += open[k];
  }
  for (std::size_t i = 0; i < parent.elements.size() && left > 0; ++i) {
    const Element& element = parent.elements[i];
    for (std::size_t k = 0; k < 4; ++k) {
      if (!open[k]) continue;
      // The list is sorted by the faces' own z_near, and element.near >= z_near.
      if (drop_hidden_ && element.near > lists[k].occluder_depth &&
          table_.faces[element.face].z_near > lists[k].occluder_depth) {
        counts.not_studied += parent.elements.size() - i;
        open[k] = false;
        --left;
        continue;
      }
      add(element, larger[k], lists[k], counts);
    }
  }
  for (Lists& l : lists) finish(l);
  return lists;
}

}  // namespace ligne::warnock
