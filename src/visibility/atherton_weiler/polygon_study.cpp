#include "visibility/atherton_weiler/polygon_study.hpp"

#include <algorithm>
#include <iterator>
#include <mutex>

#include "base/parallel.hpp"
#include "geometry/connected_boxes.hpp"
#include "geometry/polygons/clip_contour_by_contour.hpp"
#include "visibility/atherton_weiler/unit_order.hpp"

// Per zone, with its polygons sorted by nearest depth: (1) The first polygon is the clip face and clips all others. (2)
// Pieces inside it and behind it are hidden, or seen through it. (3) If a piece inside is nearer, the sort was wrong: the
// clip restarts on the inside with this piece as clip face. (4) Otherwise the whole clip face is visible. (5) The outside is
// treated likewise.
//
// The study terminates: a finished clip face leaves its list, so lists shrink from call to call except after a wrong sort.
// There the chain of clip faces grows, and a polygon in the chain is not taken for nearer again.

namespace ligne::atherton_weiler {
namespace {

/// The part of a unit whose visibility is undecided.
struct Polygon {
  std::uint32_t unit = 0;
  std::uint32_t slab = 0;
  std::uint32_t level = 0;  ///< transparent faces in front of it
  std::vector<ContourFace> pieces;
  PageBox box;
};

/// A visible part of a face.
struct Piece {
  std::uint32_t face = 0, level = 0;
  std::vector<ContourFace> parts;
};

/// Units connected by overlapping boxes, sorted by their lowest unit.
std::vector<std::vector<std::uint32_t>> zones_of(const std::vector<ClipUnit>& units) {
  std::vector<AxisBox> boxes;
  boxes.reserve(units.size());
  for (const ClipUnit& unit : units) boxes.push_back({unit.box.x0, unit.box.y0, unit.box.x1, unit.box.y1});
  DisjointSets sets = connect_boxes(boxes);
  std::vector<std::vector<std::uint32_t>> zones;
  std::vector<std::uint32_t> number(units.size());
  for (std::uint32_t u = 0; u < units.size(); ++u) {
    const std::uint32_t root = sets.find(u);
    if (root == u) {
      number[u] = static_cast<std::uint32_t>(zones.size());
      zones.emplace_back();
    }
    zones[number[root]].push_back(u);
  }
  return zones;
}

class ZoneStudy {
 public:
  ZoneStudy(const std::vector<ClipUnit>& units, UnitOrders orders) : units_(units), orders_(std::move(orders)) {}

  void study(std::vector<std::uint32_t> zone) {
    std::sort(zone.begin(), zone.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::pair(units_[a].z_near, a) < std::pair(units_[b].z_near, b);
    });
    std::vector<Polygon> list;
    double far = -1e300;
    for (const std::uint32_t u : zone) {
      const ClipUnit& unit = units_[u];
      counts.slabs += unit.z_near > far;
      far = std::max(far, unit.z_far);
      list.push_back({u, static_cast<std::uint32_t>(counts.slabs), 0, unit.outline, unit.box});
    }
    study(list, {}, 1);
  }

  std::vector<Piece> pieces;
  PolygonCounts counts;

 private:
  /// `chain`: the clip faces to which the first polygon of the list proved nearer; empty if the sort put it first.
  void study(std::vector<Polygon>& list, std::vector<std::uint32_t> chain, std::uint64_t depth);
  void show(const Polygon& polygon);

  const std::vector<ClipUnit>& units_;
  UnitOrders orders_;
};

void set_pieces(Polygon& polygon, std::vector<ContourFace> pieces) {
  polygon.pieces = std::move(pieces);
  polygon.box = box_of(polygon.pieces);
}

Polygon like(const Polygon& polygon, std::vector<ContourFace> pieces) {
  Polygon result{polygon.unit, polygon.slab, polygon.level, {}, {}};
  set_pieces(result, std::move(pieces));
  return result;
}

void ZoneStudy::study(std::vector<Polygon>& list, std::vector<std::uint32_t> chain, std::uint64_t depth) {
  counts.deepest = std::max(counts.deepest, depth);
  for (std::size_t i = 0; i < list.size(); ++i, chain.clear()) {
    Polygon clip = std::move(list[i]);
    if (clip.pieces.empty()) continue;
    const bool transparent = units_[clip.unit].transparent;
    std::vector<Polygon> nearer, behind;
    for (std::size_t k = i + 1; k < list.size(); ++k) {
      Polygon& subject = list[k];
      if (subject.pieces.empty()) continue;
      ++counts.considered;
      if (!subject.box.meets(clip.box)) continue;
      ClipResult parts = clip_contour_by_contour(subject.pieces, clip.pieces, true);
      ++counts.clips;
      if (parts.inside.empty()) continue;
      const bool passed = std::find(chain.begin(), chain.end(), subject.unit) != chain.end();
      const DepthOrder order =
          passed || subject.slab > clip.slab ? DepthOrder::first : orders_.order(clip.unit, subject.unit);
      if (order == DepthOrder::crossing) {
        ClipResult cut =
            clip_contour_by_contour(parts.inside, orders_.front_parts(clip.unit, subject.unit, box_of(parts.inside)), true);
        counts.splits += !cut.inside.empty() && !cut.outside.empty();
        if (!cut.inside.empty()) nearer.push_back(like(subject, std::move(cut.inside)));
        if (transparent && !cut.outside.empty()) behind.push_back(like(subject, std::move(cut.outside)));
      } else if (order == DepthOrder::second) {
        nearer.push_back(like(subject, std::move(parts.inside)));
      } else if (transparent) {
        behind.push_back(like(subject, std::move(parts.inside)));
      }
      set_pieces(subject, std::move(parts.outside));
    }
    if (nearer.empty()) {
      show(clip);
      for (Polygon& p : behind) ++p.level;
      if (!behind.empty()) study(behind, {}, depth + 1);
      continue;
    }
    counts.wrong_sorts += nearer.size();
    std::vector<std::uint32_t> longer = chain;
    longer.push_back(clip.unit);
    nearer.push_back(std::move(clip));
    std::move(behind.begin(), behind.end(), std::back_inserter(nearer));
    study(nearer, std::move(longer), depth + 1);
  }
}

/// The faces of a body are details of its silhouette, clipped to the visible part of it.
void ZoneStudy::show(const Polygon& polygon) {
  for (const UnitFace& face : units_[polygon.unit].faces) {
    Piece piece{face.face, polygon.level, {}};
    piece.parts =
        units_[polygon.unit].body ? clip_contour_by_contour(face.outline, polygon.pieces, true).inside : polygon.pieces;
    if (!piece.parts.empty()) pieces.push_back(std::move(piece));
  }
}

/// Joins the pieces of each face and level. A common border of two pieces may lie on different segments of one line.
void add_all(const Lattice& lattice, const std::vector<Facet>& facets, std::vector<Piece>& pieces, VisibleFaces& out) {
  std::stable_sort(pieces.begin(), pieces.end(),
                   [](const Piece& a, const Piece& b) { return std::pair(a.face, a.level) < std::pair(b.face, b.level); });
  for (std::size_t i = 0; i < pieces.size();) {
    const std::size_t first = i;
    std::vector<ContourFace> parts = std::move(pieces[i++].parts);
    for (; i < pieces.size() && pieces[i].face == pieces[first].face && pieces[i].level == pieces[first].level; ++i) {
      std::move(pieces[i].parts.begin(), pieces[i].parts.end(), std::back_inserter(parts));
    }
    if (i - first > 1) parts = clip_contour_by_contour(parts, {}, true).outside;
    std::vector<ContourEdge> edges;
    for (const ContourFace& face : parts) {
      for (const EdgeLoop& loop : face.contours) edges.insert(edges.end(), loop.begin(), loop.end());
    }
    const auto known = static_cast<std::ptrdiff_t>(out.borders.size());
    add_regions(lattice, pieces[first].face, pieces[first].level, edges, false, out);
    // Borders on sides of other faces are dropped: another face may have clipped later along such a side. If the side is
    // visible, its own face is visible beside it and gives the border.
    const auto foreign = [&](const BorderPart& b) { return facets[b.side / 3].face != pieces[first].face; };
    out.borders.erase(std::remove_if(out.borders.begin() + known, out.borders.end(), foreign), out.borders.end());
  }
}

}  // namespace

void PolygonCounts::operator+=(const PolygonCounts& o) {
  zones += o.zones;
  slabs += o.slabs;
  bodies += o.bodies;
  considered += o.considered;
  clips += o.clips;
  wrong_sorts += o.wrong_sorts;
  splits += o.splits;
  deepest = std::max(deepest, o.deepest);
}

VisibleFaces study_polygons(const ProjectedScene& scene, const std::vector<Facet>& facets, bool silhouettes,
                            const std::function<void(double)>& progress, PolygonCounts& counts) {
  VisibleFaces result;
  result.facet_touches.assign(facets.size(), 0);
  const std::vector<ClipUnit> units = clip_units(scene, facets, silhouettes);
  std::vector<std::vector<std::uint32_t>> zones = zones_of(units);
  counts.zones = zones.size();
  counts.bodies =
      static_cast<std::uint64_t>(std::count_if(units.begin(), units.end(), [](const ClipUnit& u) { return u.body; }));
  std::vector<VisibleFaces> found(zones.size());
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(zones.size(), [&](std::size_t z) {
    // Facets of different zones are never compared, so each task marks only its own.
    const std::size_t size = zones[z].size();
    ZoneStudy study(units, UnitOrders(scene, facets, units, result.facet_touches));
    study.study(std::move(zones[z]));
    add_all(scene.lattice, facets, study.pieces, found[z]);
    const std::lock_guard lock(mutex);
    counts += study.counts;
    done += size;
    if (progress) progress(static_cast<double>(done) / static_cast<double>(units.size()));
  });
  for (VisibleFaces& part : found) {
    std::move(part.regions.begin(), part.regions.end(), std::back_inserter(result.regions));
    result.borders.insert(result.borders.end(), part.borders.begin(), part.borders.end());
  }
  std::stable_sort(result.regions.begin(), result.regions.end(),
                   [](const Region& a, const Region& b) { return a.face < b.face; });
  return result;
}

}  // namespace ligne::atherton_weiler
