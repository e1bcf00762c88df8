#include "visibility/atherton_weiler/border_lines.hpp"

#include <algorithm>
#include <compare>
#include <utility>

#include "base/parallel.hpp"

namespace ligne::atherton_weiler {
namespace {

struct EdgeKey {
  std::uint32_t low, high, edge;
  friend auto operator<=>(const EdgeKey&, const EdgeKey&) = default;
};

/// Finds candidate edges by their vertices.
class EdgeFinder {
 public:
  explicit EdgeFinder(const ProjectedScene& scene) {
    keys_.reserve(scene.edges.size());
    for (std::uint32_t i = 0; i < scene.edges.size(); ++i) {
      const ProjectedEdge& e = scene.edges[i];
      keys_.push_back({std::min(e.v0, e.v1), std::max(e.v0, e.v1), i});
    }
    parallel_sort(keys_.begin(), keys_.end());
  }

  /// Calls visit(edge) for all edges between the two vertices.
  template <class Visit>
  void find(std::uint32_t v, std::uint32_t w, Visit visit) const {
    const EdgeKey key{std::min(v, w), std::max(v, w), 0};
    for (auto it = std::lower_bound(keys_.begin(), keys_.end(), key);
         it != keys_.end() && it->low == key.low && it->high == key.high; ++it) {
      visit(it->edge);
    }
  }

 private:
  std::vector<EdgeKey> keys_;
};

struct EdgePart {
  std::uint32_t edge;
  LinePart part;
};

/// Appends a part of an edge to the parts from `first` on, or extends the last part if they overlap.
void unite(std::vector<LinePart>& parts, std::size_t first, const LinePart& part) {
  if (parts.size() > first && part.from <= parts.back().to) {
    parts.back().to = std::max(parts.back().to, part.to);
  } else {
    parts.push_back(part);
  }
}

/// Inserts parts of a higher level into the gaps between the parts from `first` on. Both lists are sorted and disjoint.
void fill_gaps(std::vector<LinePart>& parts, std::size_t first, const std::vector<LinePart>& higher) {
  std::vector<LinePart> all(parts.begin() + static_cast<std::ptrdiff_t>(first), parts.end());
  const std::size_t n = all.size();
  for (LinePart p : higher) {
    for (std::size_t i = 0; i < n && p.from < p.to; ++i) {
      const LinePart& lower = parts[first + i];
      if (lower.to <= p.from) continue;
      if (lower.from >= p.to) break;
      if (p.from < lower.from) all.push_back({p.from, lower.from, p.level});
      p.from = lower.to;
    }
    if (p.from < p.to) all.push_back(p);
  }
  std::sort(all.begin(), all.end(), [](const LinePart& a, const LinePart& b) { return a.from < b.from; });
  parts.resize(first);
  parts.insert(parts.end(), all.begin(), all.end());
}

}  // namespace

BorderLines::BorderLines(const ProjectedScene& scene, const Facets& facets, const VisibleFaces& visible) {
  const EdgeFinder finder(scene);
  const auto vertices = [&](std::uint32_t side) {
    const Facet& f = facets.facets[side / 3];
    return std::pair(f.v[side % 3], f.v[(side % 3 + 1) % 3]);
  };
  // Borders give an edge completely if each of its faces has a facet on it that touches no other face.
  needs_study_.assign(scene.edges.size(), 1);
  for (std::uint32_t f = 0; f < facets.facets.size(); ++f) {
    for (unsigned k = 0; k < 3; ++k) {
      const auto [v, w] = vertices(side_source(f, k));
      finder.find(v, w, [&](std::uint32_t edge) {
        std::uint8_t& needs = needs_study_[edge];
        needs = static_cast<std::uint8_t>(visible.facet_touches[f] ? 2 : needs == 1 ? 0 : needs);
      });
    }
  }
  const auto thin = [&](std::uint32_t face) { return face < facets.face_is_thin.size() && facets.face_is_thin[face]; };
  for (std::size_t i = 0; i < scene.edges.size(); ++i) {
    if (thin(scene.edges[i].face0) || thin(scene.edges[i].face1)) needs_study_[i] = 1;
  }

  std::vector<EdgePart> found;
  found.reserve(visible.borders.size());
  for (const BorderPart& b : visible.borders) {
    const auto [v, w] = vertices(b.side);
    finder.find(v, w, [&](std::uint32_t edge) {
      const bool along = scene.edges[edge].v0 < scene.edges[edge].v1;
      found.push_back({edge, along ? LinePart{b.from, b.to, b.level} : LinePart{1 - b.to, 1 - b.from, b.level}});
    });
  }
  parallel_sort(found.begin(), found.end(), [](const EdgePart& a, const EdgePart& b) {
    return std::tuple(a.edge, a.part.level, a.part.from, a.part.to) <
           std::tuple(b.edge, b.part.level, b.part.from, b.part.to);
  });
  begin_.assign(scene.edges.size() + 1, 0);
  std::size_t k = 0;
  std::vector<LinePart> higher;
  for (std::uint32_t edge = 0; edge < scene.edges.size(); ++edge) {
    const std::size_t first = parts_.size();
    for (; k < found.size() && found[k].edge == edge && found[k].part.level == 0; ++k) unite(parts_, first, found[k].part);
    while (k < found.size() && found[k].edge == edge) {
      const std::uint32_t level = found[k].part.level;
      higher.clear();
      for (; k < found.size() && found[k].edge == edge && found[k].part.level == level; ++k) unite(higher, 0, found[k].part);
      fill_gaps(parts_, first, higher);
    }
    begin_[edge + 1] = static_cast<std::uint32_t>(parts_.size());
  }
}

}  // namespace ligne::atherton_weiler
