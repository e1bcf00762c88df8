#include "visibility/warnock/analysis.hpp"

#include <algorithm>

namespace ligne::warnock {

void AnalysisCounts::operator+=(const AnalysisCounts& o) {
  faces += o.faces;
  inherited += o.inherited;
  box += o.box;
  remembered += o.remembered;
  side_tests += o.side_tests;
  not_studied += o.not_studied;
}

Relation relation_to(const FaceTable& table, const Face& face, const Window& window, std::uint32_t& side, AnalysisCounts& counts) {
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
  // No side meets the window: any point of it tells.
  const FramePoint corner{window.u0, window.v0};
  int turns = 0;
  for (const Side& s : sides) turns += winding(table.at(s.v0), table.at(s.v1), corner);
  return turns != 0 ? Relation::surrounder : Relation::disjoint;
}

void Analysis::add(Element element, const Window& window, Lists& lists, AnalysisCounts& counts) const {
  const Face& face = table_.faces[element.face];
  const Window larger = window.grown(margin_);
  if (element.relation == Relation::surrounder) {
    ++counts.inherited;
  } else {
    element.relation = relation_to(table_, face, larger, element.side, counts);
    if (element.relation == Relation::disjoint) return;
  }
  const DepthRange depths = face.depths_over(larger);
  element.near = round_down(depths.near);
  if (drop_hidden_ && element.near > lists.cover) return;
  lists.elements.push_back(element);
  if (element.relation == Relation::surrounder) lists.cover = std::min(lists.cover, round_up(depths.far + face.slack));
}

/// What was listed before its cover was found.
void Analysis::finish(Lists& lists) const {
  if (drop_hidden_) std::erase_if(lists.elements, [&](const Element& e) { return e.near > lists.cover; });
}

Lists Analysis::begin(const Window& window, AnalysisCounts& counts) const {
  Lists lists;
  const auto n = static_cast<std::uint32_t>(table_.faces.size());
  for (std::uint32_t f = 0; f < n; ++f) {
    if (drop_hidden_ && table_.faces[f].z_near > lists.cover) {
      counts.not_studied += n - f;
      break;
    }
    ++counts.faces;
    add({f, 0, 0, Relation::intersector}, window, lists, counts);
  }
  finish(lists);
  return lists;
}

Lists Analysis::child(const Lists& parent, const Window& window, AnalysisCounts& counts) const {
  Lists lists;
  lists.cover = parent.cover;
  for (std::size_t i = 0; i < parent.elements.size(); ++i) {
    const Element& element = parent.elements[i];
    if (drop_hidden_ && table_.faces[element.face].z_near > lists.cover) {
      counts.not_studied += parent.elements.size() - i;
      break;
    }
    ++counts.faces;
    add(element, window, lists, counts);
  }
  finish(lists);
  return lists;
}

}  // namespace ligne::warnock
