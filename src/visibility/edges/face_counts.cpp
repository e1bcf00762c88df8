#include "visibility/edges/face_counts.hpp"

#include <algorithm>
#include <utility>

namespace ligne {
namespace {

void change_faces(std::vector<std::uint32_t>& faces, std::uint32_t face, int by) {
  if (by > 0) faces.insert(std::upper_bound(faces.begin(), faces.end(), face), face);
  if (by < 0) faces.erase(std::lower_bound(faces.begin(), faces.end(), face));
}

}  // namespace

FacetForest::FacetForest(const ProjectedScene& scene, const std::vector<Facet>& facets)
    : facets_(facets), vertices_(scene.vertices) {
  std::vector<DepthBox> boxes(facets.size());
  for (std::size_t i = 0; i < facets.size(); ++i) {
    for (const std::uint32_t v : facets[i].v) boxes[i].extend(vertices_[v].p);
    boxes[i].z_near = round_down(double(facets[i].z_near) - facets[i].depth_tolerance);
    boxes[i].z_far = round_up(double(facets[i].z_far) + facets[i].depth_tolerance);
  }
  root_ = forest_.add_tree(boxes);
}

std::vector<CountedPart> FaceCounter::count(const PageLine& line, bool with_faces, std::uint64_t& tests) {
  events_.clear();
  OpenParts whole;
  whole.reset(0, 1);
  forest_.for_each_before(line, whole, [&](std::uint32_t number) {
    const Facet& facet = forest_.facets()[number];
    if (facet.face == line.face0 || facet.face == line.face1) return;
    ++tests;
    bool near_side = false;
    const HiddenInterval hidden =
        hidden_interval(line, facet, forest_.vertices().data(), {0, 1}, coincidence_steps_, near_side);
    if (hidden.sides == HiddenSides::none) return;
    const int left = hidden.sides != HiddenSides::right, right = hidden.sides != HiddenSides::left;
    events_.push_back({hidden.from, facet.face, left, right});
    events_.push_back({hidden.to, facet.face, -left, -right});
  });
  // At one place beginnings come before ends: a face that continues in its next facet is counted once too often there,
  // never once too few.
  std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
    if (a.t != b.t) return a.t < b.t;
    if ((a.left + a.right > 0) != (b.left + b.right > 0)) return a.left + a.right > 0;
    return a.face < b.face;
  });
  left_.clear();
  right_.clear();
  int left = 0, right = 0;
  std::vector<CountedPart> parts;
  double from = 0;
  const auto add_part = [&](double to) {
    if (!(from < to)) return;
    const auto n = static_cast<std::uint32_t>(std::min(left, right));
    CountedPart part{from, to, n, left <= right ? left_ : right_};
    if (!parts.empty() && parts.back().is_like(part)) {
      parts.back().to = to;
    } else {
      parts.push_back(std::move(part));
    }
    from = to;
  };
  for (const Event& e : events_) {
    add_part(e.t);
    left += e.left;
    right += e.right;
    if (!with_faces) continue;
    change_faces(left_, e.face, e.left);
    change_faces(right_, e.face, e.right);
  }
  add_part(1);
  return parts;
}

}  // namespace ligne
