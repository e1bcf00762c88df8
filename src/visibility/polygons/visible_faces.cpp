#include "visibility/polygons/visible_faces.hpp"

#include <algorithm>
#include <mutex>
#include <optional>
#include <tuple>

#include "base/index_lists.hpp"
#include "base/parallel.hpp"
#include "geometry/polygons/clip_contour_by_contour.hpp"
#include "visibility/polygons/facet_order.hpp"

// Steps for each face: (1) Each of its facets is the subject once. The lists of its cells give the facets that may be
// in front, nearest first. If two overlap, their depths over the overlap give their order; a facet that begins nearer
// but is behind clips nothing, as it will itself be clipped. (2) The common borders of pieces from several facets are
// removed. (3) The borders are linked to contours.

namespace ligne {
namespace {

/// Facets grouped by face, in the order of each face's first facet, so that neighbours on the page stay close.
IndexLists group(const std::vector<Facet>& facets) {
  std::uint32_t face_count = 0;
  for (const Facet& f : facets) face_count = std::max(face_count, f.face + 1);
  constexpr std::uint32_t kNew = 0xffffffffu;
  std::vector<std::uint32_t> number(face_count, kNew);
  std::uint32_t groups = 0;
  for (const Facet& f : facets) {
    if (number[f.face] == kNew) number[f.face] = groups++;
  }
  return numbers_by_key(groups, facets.size(), [&](std::uint32_t i) { return number[facets[i].face]; });
}

/// Splits edges on one segment where other edges on it end, so that parts passed in both directions are equal pieces.
void split_at_common_ends(std::vector<ContourEdge>& edges) {
  const auto key = [](const ContourEdge& e) { return std::tie(e.segment.a.x, e.segment.a.y, e.segment.b.x, e.segment.b.y); };
  std::sort(edges.begin(), edges.end(), [&](const ContourEdge& a, const ContourEdge& b) {
    if (key(a) != key(b)) return key(a) < key(b);
    const int order = compare(a.from, b.from);
    return order != 0 ? order < 0 : a.source < b.source;
  });
  std::vector<ContourEdge> cut;
  std::vector<SegmentParameter> ends;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && key(edges[end]) == key(edges[i])) ++end;
    if (end - i == 1) {
      cut.push_back(edges[i++]);
      continue;
    }
    ends.clear();
    for (std::size_t k = i; k < end; ++k) ends.insert(ends.end(), {edges[k].from, edges[k].to});
    std::sort(ends.begin(), ends.end(), [](SegmentParameter a, SegmentParameter b) { return compare(a, b) < 0; });
    for (; i < end; ++i) {
      ContourEdge e = edges[i];
      for (const SegmentParameter t : ends) {
        if (compare(e.from, t) >= 0 || compare(t, e.to) >= 0) continue;
        ContourEdge first = e;
        first.to = t;
        e.from = t;
        cut.push_back(first);
      }
      cut.push_back(e);
    }
  }
  edges = std::move(cut);
}

/// Number of clip faces in a cell at which the first test is made whether they hide the subject there; the number then
/// doubles. Adjustable.
constexpr std::size_t kFirstCheck = 4;

/// Studies faces for one thread, with its working memory.
class Worker {
 public:
  Worker(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid, const FaceRanks* ranks,
         const std::vector<std::uint8_t>& listed, std::vector<std::uint8_t>& touches)
      : scene_(scene),
        facets_(facets),
        grid_(grid),
        ranks_(ranks),
        listed_(listed),
        touches_(touches),
        stamp_(facets.size(), 0),
        number_(facets.size(), 0) {}

  /// Appends the regions of a face with these facets.
  void study(std::span<const std::uint32_t> group, VisibleFaces& out) {
    for (std::vector<ContourEdge>& edges : levels_) edges.clear();
    for (const std::uint32_t f : group) clip(f, out.counts);
    for (std::uint32_t level = 0; level < levels_.size(); ++level) {
      if (!levels_[level].empty())
        add_regions(scene_.lattice, facets_[group[0]].face, level, levels_[level], group.size() > 1, out);
    }
  }

 private:
  static constexpr std::uint32_t kNothing = 0xffffffffu, kCovers = 0xfffffffeu;

  void clip(std::uint32_t facet, StudyCounts& counts);
  std::uint32_t compare(std::uint32_t facet, std::uint32_t other, StudyCounts& counts);
  bool transparent(std::uint32_t face) const {
    return !scene_.face_is_transparent.empty() && scene_.face_is_transparent[face];
  }
  bool clear(std::uint32_t face) const {
    return !scene_.face_is_transparent.empty() && scene_.face_is_transparent[face] == kClearFace;
  }
  bool covered_by(std::uint32_t facet, std::uint32_t other) const;

  const ProjectedScene& scene_;
  const std::vector<Facet>& facets_;
  const CellGrid& grid_;
  const FaceRanks* ranks_;
  const std::vector<std::uint8_t>& listed_;  ///< per facet: 1 if it is in front of the cover of some cell
  std::vector<std::uint8_t>& touches_;
  std::vector<std::uint32_t> stamp_;     ///< per facet: number of the last facet compared with it, plus one
  std::vector<std::uint32_t> number_;    ///< per facet: result of compare() with that facet
  std::vector<FacetClip::Number> here_;  ///< clip faces in the current cell
  FacetClip clip_;
  std::vector<std::vector<ContourEdge>>
      levels_;  ///< borders of the current face, by the number of transparent faces in front
  /// A facet that touches or crosses the current one.
  struct Near {
    std::uint32_t facet;
    FacetOrder order;  ///< order of the current facet and this one
    ClipPart part;     ///< its part in front of the current facet
  };
  std::vector<Near> near_;

  std::vector<ContourFace> rings(std::uint32_t a, const Near& g) const;
};

bool Worker::covered_by(std::uint32_t facet, std::uint32_t other) const {
  const Facet &f = facets_[facet], &g = facets_[other];
  for (int k = 0; k < 3; ++k) {
    const LatticePoint a = scene_.vertices[g.v[k]].p, b = scene_.vertices[g.v[(k + 1) % 3]].p;
    for (const std::uint32_t v : f.v) {
      if (orientation(a, b, scene_.vertices[v].p) < 0) return false;
    }
  }
  return true;
}

/// The part of facet a in front of facet b, by their order `a_b`.
ClipPart part_in_front(const std::vector<Facet>& facets, const std::vector<ProjectedVertex>& vertices, std::uint32_t a,
                       const FacetOrder& a_b) {
  if (a_b.order == DepthOrder::crossing) return left_of(whole_facet(facets, vertices, a), a_b.cut);
  return a_b.order == DepthOrder::first ? whole_facet(facets, vertices, a) : ClipPart{};
}

/// Finds the places where g is in front of a, but an h makes the order cyclic. Three facets through one line have three
/// cuts, which should be one line, but each is rounded by itself. Between the cuts a may be in front of h, h in front
/// of g, and g in front of a, so that none is visible. This can also happen where three facets touch within their
/// tolerances. There the face of the lowest number counts as in front.
std::vector<ContourFace> Worker::rings(std::uint32_t a, const Near& g) const {
  std::vector<ContourFace> places;
  if (facets_[g.facet].face < facets_[a].face) return places;
  for (const Near& h : near_) {
    if (h.order.order == DepthOrder::second || facets_[h.facet].face < facets_[a].face ||
        facets_[h.facet].face == facets_[g.facet].face)
      continue;
    const FacetOrder h_g = order_of(facets_, scene_.vertices, h.facet, g.facet);
    if (!h_g.touching || h_g.order == DepthOrder::apart || h_g.order == DepthOrder::second) continue;
    const ClipPart h_before_g = part_in_front(facets_, scene_.vertices, h.facet, h_g);
    ClipPart h_behind_a = whole_facet(facets_, scene_.vertices, h.facet);
    if (h.order.order == DepthOrder::crossing) h_behind_a = left_of(h_behind_a, h.order.cut);
    if (h_before_g.count == 0 || h_behind_a.count == 0) continue;
    ClipResult both = clip_contour_by_contour(h_before_g.face(), h_behind_a.face());
    std::move(both.inside.begin(), both.inside.end(), std::back_inserter(places));
  }
  return places;
}

/// Adds the part of the other facet in front of the subject as a clip face, and returns its number. Returns kCovers if
/// the other hides the whole subject, and kNothing if no clip face was added or it waits in near_.
std::uint32_t Worker::compare(std::uint32_t facet, std::uint32_t other, StudyCounts& counts) {
  const Facet &f = facets_[facet], &g = facets_[other];
  if (g.face == f.face || clear(g.face)) return kNothing;
  if (ranks_ && (ranks_->all_before(f.face, g.face) || ranks_->all_before(g.face, f.face))) {
    ++counts.by_order;
    if (ranks_->all_before(f.face, g.face)) return kNothing;
    if (!transparent(g.face) && covered_by(facet, other)) return kCovers;
    return clip_.add(whole_facet(facets_, scene_.vertices, other), transparent(g.face));
  }
  const FacetOrder order = order_of(facets_, scene_.vertices, facet, other);
  if (order.order == DepthOrder::apart) return kNothing;
  ++counts.compared;
  if (order.tie || (order.touching && common_corners(f, g) < 2)) touches_[facet] = 1;
  counts.ties += order.tie;
  const bool near = order.touching && (order.order == DepthOrder::crossing || order.tie || common_corners(f, g) == 0);
  if (near) near_.push_back({other, order, {}});
  if (order.order == DepthOrder::first) {
    counts.wrong_sorts += g.z_near < f.z_near;
    return kNothing;
  }
  ClipPart part = whole_facet(facets_, scene_.vertices, other);
  if (order.order == DepthOrder::crossing) {
    ++counts.cuts;
    part = left_of(part, {order.cut.b, order.cut.a});
    if (part.count == 0) return kNothing;
  } else if (!order.touching && !transparent(g.face) && covered_by(facet, other)) {
    return kCovers;
  }
  if (near) {
    near_.back().part = part;
    return kNothing;
  }
  return clip_.add(part, transparent(g.face));
}

void Worker::clip(std::uint32_t facet, StudyCounts& counts) {
  if (!listed_[facet]) {
    ++counts.not_listed;
    return;
  }
  const Facet& f = facets_[facet];
  const LatticePoint a = scene_.vertices[f.v[0]].p, b = scene_.vertices[f.v[1]].p, c = scene_.vertices[f.v[2]].p;
  const double x0 = std::min({a.x, b.x, c.x}), x1 = std::max({a.x, b.x, c.x}), y0 = std::min({a.y, b.y, c.y}),
               y1 = std::max({a.y, b.y, c.y});
  clip_.begin(whole_facet(facets_, scene_.vertices, facet));
  near_.clear();
  bool listed = false, hidden = false, covered = true;
  stamp_[facet] = facet + 1;
  number_[facet] = kNothing;
  grid_.for_each_leaf_in(x0, y0, x1, y1, [&](const Cell& cell, const CellSquare& square) {
    // One step is added on each side: if facets have common points, at least one of the visited cells then holds some
    // of them.
    const FacetClip::Window window{2 * square.x - 2, 2 * square.y - 2, 2 * (square.x + square.size) + 2,
                                   2 * (square.y + square.size) + 2};
    if (hidden || clip_.subject_beside(window)) return;
    const CellBox box = square.box(x0, x1, y0, y1);
    here_.clear();
    std::size_t check = kFirstCheck;
    bool done = false;
    const CellFacet* entry = grid_.list(cell);
    for (const CellFacet* const end = entry + cell.count; entry != end && entry->z_near <= f.z_far; ++entry) {
      const std::uint32_t other = entry->facet;
      listed |= other == facet;
      if (!entry->box.meets(box)) continue;
      if (stamp_[other] != facet + 1) {
        stamp_[other] = facet + 1;
        number_[other] = compare(facet, other, counts);
        if (number_[other] == kCovers) {
          hidden = true;
          return;
        }
      }
      if (number_[other] >= kCovers) continue;
      here_.push_back(number_[other]);
      if (here_.size() != check) continue;
      check *= 2;
      if ((done = clip_.covers(here_, window))) break;
    }
    covered = covered && (done || (!here_.empty() && clip_.covers(here_, window)));
  });
  counts.not_listed += !listed;
  if (hidden || covered || !listed) return;
  for (const Near& g : near_) {
    if (g.part.count == 0) continue;
    const std::vector<ContourFace> ring = near_.size() > 1 ? rings(facet, g) : std::vector<ContourFace>{};
    if (ring.empty()) {
      clip_.add(g.part, transparent(facets_[g.facet].face));
    } else {
      const std::vector<ContourFace> part{g.part.face()};
      clip_.add(clip_contour_by_contour(part, ring).outside, transparent(facets_[g.facet].face));
    }
  }
  counts.clips += clip_.clip_count();
  clip_.finish(levels_);
}

}  // namespace

void add_regions(const Lattice& lattice, std::uint32_t face, std::uint32_t level, std::vector<ContourEdge>& edges,
                 bool several_pieces, VisibleFaces& out) {
  if (several_pieces) split_at_common_ends(edges);
  for (const ContourFace& piece : link_edges(edges)) {
    Region region{.face = face, .level = level};
    for (const EdgeLoop& loop : piece.contours) {
      std::vector<Point2>& contour = region.contours.emplace_back();
      contour.reserve(loop.size());
      for (const ContourEdge& e : loop) {
        contour.push_back(to_mm(lattice, e.begin()));
        if (e.source != kCutSource) out.borders.push_back({e.source, level, value(e.from), value(e.to)});
      }
    }
    out.regions.push_back(std::move(region));
  }
}

VisibleFaces find_visible_faces(const ProjectedScene& scene, const std::vector<Facet>& facets, const CellGrid& grid,
                                const std::function<void(double)>& progress, const FaceRanks* ranks) {
  constexpr std::size_t kFacesPerTask = 256;
  VisibleFaces result;
  result.facet_touches.assign(facets.size(), 0);
  const IndexLists faces = group(facets);
  const std::size_t n = faces.size(), tasks = (n + kFacesPerTask - 1) / kFacesPerTask;
  std::vector<VisibleFaces> found(tasks);
  const std::vector<std::uint8_t> listed = grid.listed(facets.size());
  std::vector<std::optional<Worker>> workers(thread_count());
  std::mutex progress_mutex;
  std::size_t done = 0;
  parallel_for(tasks, [&](std::size_t task) {
    std::optional<Worker>& worker = workers[thread_index()];
    if (!worker) worker.emplace(scene, facets, grid, ranks, listed, result.facet_touches);
    for (std::size_t g = task * kFacesPerTask; g < std::min(n, (task + 1) * kFacesPerTask); ++g) {
      worker->study(faces[g], found[task]);
    }
    if (progress) {
      const std::lock_guard lock(progress_mutex);
      progress(static_cast<double>(++done) / static_cast<double>(tasks));
    }
  });
  for (const VisibleFaces& part : found) result.counts += part.counts;
  result.append(found);
  return result;
}

void VisibleFaces::append(std::vector<VisibleFaces>& parts) {
  for (VisibleFaces& part : parts) {
    std::move(part.regions.begin(), part.regions.end(), std::back_inserter(regions));
    borders.insert(borders.end(), part.borders.begin(), part.borders.end());
    part = {};
  }
  std::stable_sort(regions.begin(), regions.end(), [](const Region& a, const Region& b) { return a.face < b.face; });
}

}  // namespace ligne
