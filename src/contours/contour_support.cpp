#include "contours/contour_support.hpp"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "contours/contour_junctions.hpp"
#include "contours/contour_sights.hpp"
#include "contours/surfaces/known_surfaces.hpp"
#include "geometry/nearest_on_segment.hpp"
#include "view/view.hpp"

namespace ligne {
namespace {

/// Adjustable. Radius of the search for outlines around a contour: the larger of kSearchInPens pen widths and
/// kSearchTimes the largest permitted distance.
constexpr double kSearchInPens = 6;
constexpr double kSearchTimes = 2;
/// Adjustable. Factor by which the distance of a surface from uneven triangles may exceed their sag. It applies only to
/// nodes with normals of a fitted surface: on coarse meshes, means of normals are wrong by as much.
constexpr double kFittedSag = 1.6;
/// Least side of the cells of that search, mm. Larger cells have the mean of the largest permitted distances as their side.
constexpr double kLeastCellMm = 1;
/// Largest sag on the page at which a node is compared with the outline, mm. Larger ones occur close to the eye.
constexpr double kLargestSagMm = 10;

/// Whether the outline of the surface of a triangle is straight: it is a ruling of a cylinder, a cone or an extruded
/// surface.
bool has_straight_outline(const SmoothPatch& patch, std::uint32_t triangle) {
  const Patch* surface = surface_at(patch, triangle);
  if (!surface) return false;
  const SurfaceKind kind = surface->surface.kind;
  return kind == SurfaceKind::cylinder || kind == SurfaceKind::cone || kind == SurfaceKind::extruded;
}

/// The parts of a chain between the segments that are not kept.
std::vector<ContourChain> parts_of(const ContourChain& chain, const std::vector<std::uint8_t>& keeps) {
  const std::size_t n = chain.size();
  // A closed chain begins at a segment that is not kept.
  std::size_t first = 0;
  if (chain.closed) first = static_cast<std::size_t>(std::ranges::find(keeps, std::uint8_t{0}) - keeps.begin()) % n;
  std::vector<ContourChain> parts;
  ContourChain part;
  const auto finish = [&] {
    if (part.size() > 0) parts.push_back(std::move(part));
    part = {};
  };
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = (first + k) % n;
    if (!keeps[i]) {
      finish();
      continue;
    }
    if (part.nodes.empty()) part.nodes.push_back(chain.nodes[i]);
    part.nodes.push_back(chain.nodes[i + 1]);
    part.triangles.push_back(chain.triangles[i]);
  }
  finish();
  return parts;
}

}  // namespace

bool in_window(const View& view, Point2 p) {
  return p.x >= view.window.min.x && p.x <= view.window.max.x && p.y >= view.window.min.y && p.y <= view.window.max.y;
}

ContourSupport::ContourSupport(const Scene& scene, const View& view, const SmoothPatch& patch,
                               std::span<ContourChain* const> chains, std::span<const std::uint32_t> sides,
                               double pen_width_mm)
    : chains_(chains),
      patch_(patch),
      view_(view),
      places_(chains.size()),
      middles_(chains.size()),
      pen_width_mm_(pen_width_mm) {
  parallel_blocks(chains.size(), kChainsPerTask, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c) {
      for (const ContourNode& node : chains[c]->nodes) places_[c].push_back(place_of(scene, node));
      middles_[c] = middles_of(*chains[c], places_[c]);
    }
  });
  std::vector<Place*> places;
  for (std::size_t c = 0; c < chains.size(); ++c) {
    for (std::vector<Place>* of_chain : {&places_[c], &middles_[c]}) {
      for (Place& place : *of_chain) {
        if (place.counts) places.push_back(&place);
      }
    }
  }
  std::vector<std::array<Point2, 2>> outlines(sides.size());
  parallel_blocks(sides.size(), kSearchBlock, [&](std::size_t begin, std::size_t end_of_block) {
    for (std::size_t i = begin; i < end_of_block; ++i) {
      const auto end = [&](std::uint32_t corner) {
        return page_point(view, scene.vertices[patch.triangles[corner / 3].v[corner % 3]]);
      };
      outlines[i] = {end(sides[i]), end(next_corner(sides[i]))};
    }
  });
  find_outlines(places, outlines);
}

ContourSupport::Place ContourSupport::place_of(const Scene& scene, const ContourNode& node) const {
  Place place;
  place.mm = page_point(view_, node.meets != kNone ? scene.vertices[node.meets] : node.on_surface);
  const double unit_mm = glm::length(page_direction(view_, node.on_mesh, view_.camera.right));
  place.sag = (node.tangent != Point3(0.0) ? kFittedSag : 1) * node.sag * unit_mm;
  place.lift = glm::length(page_point(view_, node.on_surface) - page_point(view_, node.on_mesh));
  place.counts = place.sag <= kLargestSagMm && in_window(view_, place.mm);
  return place;
}

void ContourSupport::find_outlines(std::span<Place* const> places, std::span<const std::array<Point2, 2>> outlines) const {
  if (places.empty()) return;
  double sum = 0;
  Rect box;
  for (const Place* place : places) {
    sum += most_away(*place);
    box.extend(place->mm - reach(*place));
    box.extend(place->mm + reach(*place));
  }
  SegmentFinder finder(page_lattice(view_), std::max(kLeastCellMm, sum / static_cast<double>(places.size())));
  finder.expect_within(box);
  for (const auto& [from, to] : outlines) finder.add({from, to, 0, 0});
  parallel_blocks(places.size(), kSearchBlock, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Place& place = *places[i];
      // Most places have an outline within the permitted distance; the wide search is for the others.
      for (const double radius : {most_away(place), reach(place)}) {
        place.away = radius;
        finder.near(place.mm, place.mm, radius, [&](const OutlineSegment& s) {
          if (!s.may_reach(place.mm, place.away)) return;
          const Point2 nearest = s.from + nearest_on_segment(place.mm, s.from, s.to) * (s.to - s.from);
          const double away = glm::length(nearest - place.mm);
          if (away < place.away) place.away = away, place.outline = nearest;
        });
        if (place.away < radius) break;
      }
    }
  });
}

std::vector<ContourSupport::Place> ContourSupport::middles_of(const ContourChain& chain,
                                                              const std::vector<Place>& places) const {
  std::vector<Place> middles(chain.size());
  for (std::size_t i = 0; i < middles.size(); ++i) {
    const Place &a = places[i], &b = places[i + 1];
    Place& middle = middles[i];
    middle.mm = (a.mm + b.mm) / 2.0;
    const ContourNode& node = chain.nodes[i];
    middle.sag = node.sag_ahead * glm::length(page_direction(view_, node.on_mesh, view_.camera.right));
    middle.counts = a.counts && b.counts;
  }
  return middles;
}

double ContourSupport::reach(const Place& place) const {
  return std::max(kSearchInPens * pen_width_mm_, kSearchTimes * most_away(place));
}

double ContourSupport::mean(double Place::*value) const {
  double sum = 0;
  for (const std::vector<Place>& places : places_) {
    for (const Place& place : places) sum += place.*value;
  }
  return sum / std::max(1.0, double(nodes()));
}

std::size_t ContourSupport::nodes() const {
  std::size_t count = 0;
  for (const std::vector<Place>& places : places_) count += places.size();
  return count;
}

double ContourSupport::astray() const {
  double all = 0, astray = 0;
  for (const std::vector<Place>& places : places_) {
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const double length = glm::length(places[i + 1].mm - places[i].mm);
      all += length;
      for (const Place& end : {places[i], places[i + 1]}) {
        if (end.away > most_away(end)) astray += length / 2;
      }
    }
  }
  return all > 0 ? astray / all : 0;
}

std::vector<ContourChain> ContourSupport::supported() const {
  std::vector<ContourChain> found;
  for (std::size_t c = 0; c < chains_.size(); ++c) {
    ContourChain& chain = *chains_[c];
    const std::vector<Place>& places = places_[c];
    std::vector<std::uint8_t> keeps(chain.size(), 1);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Place& place = places[i];
      ContourNode& node = chain.nodes[i];
      node.most_mm = most_away(place);
      if (i < keeps.size()) {
        const Place& middle = middles_[c][i];
        keeps[i] = middle.away <= std::max(node.most_mm, most_away(places[i + 1]));
        const double rest = std::min(most_away(place) - place.away, most_away(places[i + 1]) - places[i + 1].away);
        node.bulge_mm = has_straight_outline(patch_, chain.triangles[i]) ? 0 : std::clamp(rest, 0.0, most_away(middle));
      }
      if (place.away <= node.most_mm) continue;
      if (place.away >= reach(place)) {
        if (i < keeps.size()) keeps[i] = 0;
        if (i > 0) keeps[i - 1] = 0;
        continue;
      }
      const Point2 shift = (1 - node.most_mm / place.away) * (place.outline - place.mm);
      const double unit_mm = glm::length(page_direction(view_, node.on_surface, view_.camera.right));
      node.on_surface += (shift.x * view_.camera.right + shift.y * view_.camera.down) / unit_mm;
      node.tangent = Point3(0.0);
      node.radial = 0;
    }
    if (std::ranges::find(keeps, 0) == keeps.end()) {
      found.push_back(std::move(chain));
    } else {
      std::ranges::move(parts_of(chain, keeps), std::back_inserter(found));
    }
  }
  return found;
}

}  // namespace ligne
