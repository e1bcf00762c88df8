// Per zone, with its polygons sorted by nearest depth: (1) The first polygon is the clip face and clips all others. (2)
// Pieces inside it and behind it are hidden, or seen through it. (3) If a piece inside is nearer, the sort was wrong: the
// clip restarts on the inside with this piece as clip face. (4) Otherwise the whole clip face is visible. (5) The outside is
// treated likewise.
//
// With InsideTest::at_once, step (3) does not wait for the end of step (1): a polygon that is nearer all over the overlap
// exchanges places with the clip face. What the clip face has cut off behind it so far stays cut off.
//
// The study terminates: a finished clip face leaves its list, so lists shrink from call to call except after a wrong sort.
// There the chain of clip faces grows, and a polygon in the chain is not taken for nearer again. A clip face that was given
// up is not exchanged for again before another one is finished; in a ring of such faces the clip starts again as in step
// (3), and what is inside is studied without exchanges.

#include "visibility/atherton_weiler/polygon_study.hpp"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <span>
#include <unordered_map>
#include <utility>

#include "base/parallel.hpp"
#include "geometry/polygons/clip_contour_by_contour.hpp"
#include "visibility/atherton_weiler/clip_units.hpp"
#include "visibility/atherton_weiler/zones.hpp"
#include "visibility/polygons/clip_part.hpp"
#include "visibility/polygons/facet_order.hpp"

namespace ligne::atherton_weiler {
namespace {

/// The depth order of two units, computed on demand and cached.

/// One per task: not thread-safe.
class UnitOrders {
 public:
  /// Marks facets that touch others in `touches`; see VisibleFaces::facet_touches.
  UnitOrders(const ProjectedScene& scene, const std::vector<Facet>& facets, const std::vector<ClipUnit>& units,
             std::vector<std::uint8_t>& touches, ClipKind clip, PolygonCounts& counts)
      : scene_(scene), facets_(facets), units_(units), touches_(touches), clip_(clip, counts) {}

  /// The order of two units that overlap on the page.
  DepthOrder order(std::uint32_t a, std::uint32_t b);

  /// For units of mixed order, which penetrate or are not planar: the parts of b in front of a that meet the rectangle.
  std::vector<ContourFace> front_parts(std::uint32_t a, std::uint32_t b, const PageBox& within);

 private:
  template <class Visit>
  void for_each_pair(std::uint32_t a, std::uint32_t b, const PageBox& within, Visit visit) const;

  const ProjectedScene& scene_;
  const std::vector<Facet>& facets_;
  const std::vector<ClipUnit>& units_;
  std::vector<std::uint8_t>& touches_;
  PolygonClip clip_;
  std::unordered_map<std::uint64_t, DepthOrder> known_;  ///< by the numbers of two units, lower first
};

DepthOrder turned(DepthOrder order) {
  return order == DepthOrder::first ? DepthOrder::second : order == DepthOrder::second ? DepthOrder::first : order;
}

template <class Visit>
void UnitOrders::for_each_pair(std::uint32_t a, std::uint32_t b, const PageBox& within, Visit visit) const {
  struct Boxed {
    std::uint32_t facet;
    PageBox box;
  };
  const auto facets_within = [&](std::uint32_t unit) {
    std::vector<Boxed> list;
    for (const UnitFace& face : units_[unit].faces) {
      for (const std::uint32_t f : face.facets) {
        const PageBox box = box_of(facets_[f], scene_.vertices);
        if (box.meets(within)) list.push_back({f, box});
      }
    }
    return list;
  };
  const std::vector<Boxed> of_a = facets_within(a), of_b = facets_within(b);
  for (const Boxed& fa : of_a) {
    for (const Boxed& fb : of_b) {
      if (fa.box.meets(fb.box)) visit(fa.facet, fb.facet, order_of(facets_, scene_.vertices, fa.facet, fb.facet));
    }
  }
}

DepthOrder UnitOrders::order(std::uint32_t a, std::uint32_t b) {
  if (a > b) return turned(order(b, a));
  const auto [entry, is_new] = known_.try_emplace(std::uint64_t{a} << 32 | b, DepthOrder::first);
  if (!is_new) return entry->second;
  bool first = false, second = false;
  for_each_pair(a, b, common(units_[a].box, units_[b].box), [&](std::uint32_t fa, std::uint32_t fb, const FacetOrder& o) {
    if (o.order == DepthOrder::apart) return;
    first |= o.order != DepthOrder::second;
    second |= o.order != DepthOrder::first;
    if (o.tie || (o.touching && common_corners(facets_[fa], facets_[fb]) < 2)) touches_[fa] = touches_[fb] = 1;
  });
  entry->second = first && second ? DepthOrder::crossing : second ? DepthOrder::second : DepthOrder::first;
  return entry->second;
}

std::vector<ContourFace> UnitOrders::front_parts(std::uint32_t a, std::uint32_t b, const PageBox& within) {
  std::vector<ContourFace> parts;
  for_each_pair(a, b, within, [&](std::uint32_t fa, std::uint32_t fb, const FacetOrder& o) {
    if (o.order == DepthOrder::apart || o.order == DepthOrder::first) return;
    ClipPart front = whole_facet(facets_, scene_.vertices, fb);
    if (o.order == DepthOrder::crossing) front = left_of(front, {o.cut.b, o.cut.a});
    if (front.count == 0) return;
    const ContourFace subject = front.face(), clip = whole_facet(facets_, scene_.vertices, fa).face();
    clip_.divide(std::span(&subject, 1), std::span(&clip, 1));
    for (ContourFace& face : clip_.take_inside()) parts.push_back(std::move(face));
  });
  return parts;
}

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

/// The pieces inside a clip face that the study goes on with: those in front of it, and those behind it if it is
/// transparent.
struct Inside {
  std::vector<Polygon> nearer, behind;
};

using Units = std::vector<std::uint32_t>;

bool holds(const Units& units, std::uint32_t unit) { return std::ranges::find(units, unit) != units.end(); }

void set_pieces(Polygon& polygon, std::vector<ContourFace> pieces) {
  polygon.pieces = std::move(pieces);
  polygon.box = box_of(polygon.pieces);
}

Polygon like(const Polygon& polygon, std::vector<ContourFace> pieces) {
  Polygon result{polygon.unit, polygon.slab, polygon.level, {}, {}};
  set_pieces(result, std::move(pieces));
  return result;
}

class ZoneStudy {
 public:
  ZoneStudy(const ProjectedScene& scene, const std::vector<Facet>& facets, const std::vector<ClipUnit>& units,
            const OverlapTests& tests, const PolygonOptions& options, std::vector<std::uint8_t>& touches)
      : units_(units),
        tests_(tests),
        at_once_(options.inside == InsideTest::at_once),
        orders_(scene, facets, units, touches, options.clip, counts),
        clip_(options.clip, counts) {}

  void study(Units zone) {
    std::ranges::sort(zone, [&](std::uint32_t a, std::uint32_t b) {
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
  void study(std::vector<Polygon>& list, Units chain, std::uint64_t depth);
  std::size_t clip_list(const Polygon& clip, std::vector<Polygon>& list, std::size_t first, const Units& chain,
                        const Units* given_up, Inside& found);
  bool clip_one(const Polygon& clip, Polygon& subject, const Units& chain, const Units* given_up, Inside& found);
  void finish(Polygon clip, Inside found, const Units& chain, std::uint64_t depth);
  void show(const Polygon& polygon);

  const std::vector<ClipUnit>& units_;
  const OverlapTests& tests_;
  bool at_once_;
  UnitOrders orders_;
  PolygonClip clip_;
};

/// Clips a polygon whose box overlaps that of the clip face. True if it is nearer than the clip face all over their overlap
/// and is to become the clip face at once; then it stays as it is.
bool ZoneStudy::clip_one(const Polygon& clip, Polygon& subject, const Units& chain, const Units* given_up, Inside& found) {
  if (!tests_.may_overlap(clip.unit, subject.unit, counts)) return false;
  ++counts.clips;
  if (!clip_.divide(subject.pieces, clip.pieces)) {
    ++counts.empty_clips;
    return false;
  }
  const DepthOrder order =
      holds(chain, subject.unit) || subject.slab > clip.slab ? DepthOrder::first : orders_.order(clip.unit, subject.unit);
  if (order == DepthOrder::second && given_up && !holds(*given_up, subject.unit)) return true;
  const bool transparent = units_[clip.unit].transparent;
  if (order == DepthOrder::crossing) {
    const std::vector<ContourFace> inside = clip_.take_inside();
    set_pieces(subject, clip_.take_outside());
    const bool has_front = clip_.divide(inside, orders_.front_parts(clip.unit, subject.unit, box_of(inside)));
    std::vector<ContourFace> behind = clip_.take_outside();
    counts.splits += has_front && !behind.empty();
    if (has_front) found.nearer.push_back(like(subject, clip_.take_inside()));
    if (transparent && !behind.empty()) found.behind.push_back(like(subject, std::move(behind)));
    return false;
  }
  if (order == DepthOrder::second) {
    found.nearer.push_back(like(subject, clip_.take_inside()));
  } else if (transparent) {
    found.behind.push_back(like(subject, clip_.take_inside()));
  }
  set_pieces(subject, clip_.take_outside());
  return false;
}

/// Clips the list from `first` on. Returns the index of the polygon that is to become the clip face at once, or the size of
/// the list.
std::size_t ZoneStudy::clip_list(const Polygon& clip, std::vector<Polygon>& list, std::size_t first, const Units& chain,
                                 const Units* given_up, Inside& found) {
  for (std::size_t k = first; k < list.size(); ++k) {
    Polygon& subject = list[k];
    if (subject.pieces.empty()) continue;
    ++counts.considered;
    if (subject.box.meets(clip.box) && clip_one(clip, subject, chain, given_up, found)) return k;
  }
  return list.size();
}

void ZoneStudy::study(std::vector<Polygon>& list, Units chain, std::uint64_t depth) {
  counts.deepest = std::max(counts.deepest, depth);
  const bool exchanges = at_once_ && chain.empty();
  Units given_up;  // clip faces given up since the last one was finished
  for (std::size_t i = 0; i < list.size();) {
    Polygon clip = std::move(list[i]);
    Inside found;
    if (!clip.pieces.empty()) {
      const std::size_t nearer = clip_list(clip, list, i + 1, chain, exchanges ? &given_up : nullptr, found);
      if (nearer < list.size()) {
        // The nearer polygon comes first, then the clip face, then the pieces that were found inside it.
        ++counts.exchanges;
        ++counts.wrong_sorts;
        given_up.push_back(clip.unit);
        list[i] = std::move(clip);
        const auto at = [&](std::size_t k) { return list.begin() + static_cast<std::ptrdiff_t>(k); };
        std::rotate(at(i), at(nearer), at(nearer + 1));
        std::move(found.behind.begin(), found.behind.end(), std::back_inserter(found.nearer));
        list.insert(at(i + 2), std::make_move_iterator(found.nearer.begin()), std::make_move_iterator(found.nearer.end()));
        continue;
      }
      finish(std::move(clip), std::move(found), chain, depth);
    }
    ++i;
    chain.clear();
    given_up.clear();
  }
}

/// Goes on after a clip face has clipped its list: the clip face is visible, or the clip starts again on what is inside it.
void ZoneStudy::finish(Polygon clip, Inside found, const Units& chain, std::uint64_t depth) {
  if (found.nearer.empty()) {
    show(clip);
    for (Polygon& p : found.behind) ++p.level;
    if (!found.behind.empty()) study(found.behind, {}, depth + 1);
    return;
  }
  counts.wrong_sorts += found.nearer.size();
  Units longer = chain;
  longer.push_back(clip.unit);
  found.nearer.push_back(std::move(clip));
  std::move(found.behind.begin(), found.behind.end(), std::back_inserter(found.nearer));
  study(found.nearer, std::move(longer), depth + 1);
}

/// The faces of a body are details of its silhouette, clipped to the visible part of it.
void ZoneStudy::show(const Polygon& polygon) {
  for (const UnitFace& face : units_[polygon.unit].faces) {
    Piece piece{face.face, polygon.level, {}};
    if (!units_[polygon.unit].body) {
      piece.parts = polygon.pieces;
    } else if (clip_.divide(face.outline, polygon.pieces)) {
      piece.parts = clip_.take_inside();
    }
    if (!piece.parts.empty()) pieces.push_back(std::move(piece));
  }
}

/// Joins the pieces of each face and level. A common border of two pieces may lie on different segments of one line.
void add_all(const Lattice& lattice, const std::vector<Facet>& facets, std::vector<Piece>& pieces, VisibleFaces& out) {
  std::ranges::stable_sort(
      pieces, [](const Piece& a, const Piece& b) { return std::pair(a.face, a.level) < std::pair(b.face, b.level); });
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

VisibleFaces study_polygons(const ProjectedScene& scene, const std::vector<Facet>& facets, const PolygonOptions& options,
                            const std::function<void(double)>& progress, PolygonCounts& counts) {
  VisibleFaces result;
  result.facet_touches.assign(facets.size(), 0);
  const std::vector<ClipUnit> units = clip_units(scene, facets, options.silhouettes);
  const OverlapTests tests(scene, facets, units, options.zones);
  std::vector<Units> zones = zones_of(units, tests, counts);
  counts.zones = zones.size();
  counts.bodies = static_cast<std::uint64_t>(std::ranges::count_if(units, [](const ClipUnit& u) { return u.body; }));
  std::vector<VisibleFaces> found(zones.size());
  std::mutex mutex;
  std::size_t done = 0;
  parallel_for(zones.size(), [&](std::size_t z) {
    // Facets of different zones are never compared, so each task marks only its own.
    const std::size_t size = zones[z].size();
    ZoneStudy study(scene, facets, units, tests, options, result.facet_touches);
    study.study(std::move(zones[z]));
    add_all(scene.lattice, facets, study.pieces, found[z]);
    const std::lock_guard lock(mutex);
    counts += study.counts;
    done += size;
    if (progress) progress(static_cast<double>(done) / static_cast<double>(units.size()));
  });
  result.append(found);
  return result;
}

}  // namespace ligne::atherton_weiler
