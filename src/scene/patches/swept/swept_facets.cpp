#include "scene/patches/swept/swept_facets.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>
#include <unordered_set>
#include <utility>

#include "base/no_index.hpp"
#include "scene/patches/swept/profile_curve.hpp"

namespace ligne {
namespace {

/// Joins places that lie within a tolerance of each other.
class PlaceTable {
 public:
  explicit PlaceTable(double tolerance) : tolerance_(tolerance) {}

  std::uint32_t number_of(const Point2& p) {
    const Cell cell{static_cast<std::int64_t>(std::floor(p.x / tolerance_)),
                    static_cast<std::int64_t>(std::floor(p.y / tolerance_))};
    for (std::int64_t i = cell[0] - 1; i <= cell[0] + 1; ++i) {
      const auto end = cells_.end();
      for (auto near = cells_.lower_bound({i, cell[1] - 1}); near != end && near->first <= Cell{i, cell[1] + 1}; ++near) {
        if (glm::distance(first_[near->second], p) <= tolerance_) return add(near->second, p);
      }
    }
    const auto number = static_cast<std::uint32_t>(first_.size());
    first_.push_back(p);
    sums_.emplace_back(0, 0);
    counts_.push_back(0);
    cells_.emplace(cell, number);
    return add(number, p);
  }

  /// The means of the places.
  std::vector<Point2> means() const {
    std::vector<Point2> means = sums_;
    for (std::size_t i = 0; i < means.size(); ++i) means[i] /= counts_[i];
    return means;
  }

 private:
  using Cell = std::array<std::int64_t, 2>;

  std::uint32_t add(std::uint32_t number, const Point2& p) {
    sums_[number] += p;
    ++counts_[number];
    return number;
  }

  double tolerance_;
  std::map<Cell, std::uint32_t> cells_;
  std::vector<Point2> first_, sums_;
  std::vector<double> counts_;
};

}  // namespace

FacetProfile profile_of(std::vector<SweptFacet> facets, const FacetPatches& surfaces, double tolerance) {
  std::ranges::sort(facets, {}, &SweptFacet::facet);
  FacetProfile profile;
  PlaceTable places(tolerance);
  std::map<std::array<std::uint32_t, 2>, std::uint32_t> numbers;
  for (const SweptFacet& f : facets) {
    const std::uint32_t a = places.number_of(f.ends[0]), b = places.number_of(f.ends[1]);
    if (a == b) continue;
    const auto [place, is_new] =
        numbers.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(profile.sides.size()));
    if (is_new) {
      profile.sides.push_back({a, b, surfaces.patch_of[f.facet]});
      profile.facets.emplace_back();
    }
    ProfileSide& side = profile.sides[place->second];
    if (side.owner == kNone) side.owner = surfaces.patch_of[f.facet];
    side.is_plane |= surfaces.patch_of[f.facet] == kNone && !surfaces.is_freeform[f.facet];
    profile.facets[place->second].push_back(f.facet);
  }
  profile.points = places.means();
  return profile;
}

void SweptPatches::list_facets() {
  if (is_listed_) return;
  is_listed_ = true;
  facets_.resize(surfaces_.patches.size());
  for (std::uint32_t f = 0; f < surfaces_.patch_of.size(); ++f) {
    if (surfaces_.patch_of[f] != kNone) facets_[surfaces_.patch_of[f]].push_back(f);
  }
}

std::vector<std::vector<std::uint32_t>> SweptPatches::facets_of(const FacetProfile& profile,
                                                                std::span<const ProfilePiece> pieces) const {
  std::vector<std::vector<std::uint32_t>> facets(pieces.size()), owners(pieces.size());
  std::unordered_set<std::uint32_t> listed;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (const std::uint32_t side : pieces[i].sides) {
      for (const std::uint32_t f : profile.facets[side]) {
        const std::uint32_t owner = surfaces_.patch_of[f];
        if (owner != kNone && owner >= facets_.size()) continue;  // swept already
        facets[i].push_back(f);
        listed.insert(f);
        if (owner != kNone) owners[i].push_back(owner);
      }
    }
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::ranges::sort(owners[i]);
    owners[i].erase(std::unique(owners[i].begin(), owners[i].end()), owners[i].end());
    for (const std::uint32_t owner : owners[i]) {
      std::ranges::copy_if(facets_[owner], std::back_inserter(facets[i]),
                           [&](std::uint32_t f) { return surfaces_.patch_of[f] == owner && listed.insert(f).second; });
    }
    std::ranges::sort(facets[i]);
  }
  return facets;
}

void SweptPatches::add(const PatchSurface& frame, const std::array<Point3, 2>& xy, const FacetProfile& profile,
                       std::span<const ProfilePiece> pieces) {
  list_facets();
  const std::vector<std::vector<std::uint32_t>> facets = facets_of(profile, pieces);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    std::vector<Point2> points;
    for (const std::uint32_t p : pieces[i].points) points.push_back(profile.points[p]);
    if (!facets[i].empty()) add_patch(frame, xy, std::move(points), pieces[i].is_closed, facets[i]);
  }
}

void SweptPatches::add_patch(const PatchSurface& frame, const std::array<Point3, 2>& xy, std::vector<Point2> points,
                             bool is_closed, std::span<const std::uint32_t> facets) {
  const FacetGraph& graph = object_.graph;
  const bool is_revolved = frame.kind == SurfaceKind::revolved;
  const double tolerance = swept_tolerance(object_.object);
  if (is_revolved) {
    for (Point2* end : {&points.front(), &points.back()}) {
      if (end->x <= tolerance) end->x = 0;
    }
  }
  Patch patch;
  patch.surface = frame;
  const auto set_profile = [&] {
    patch.surface.profile =
        std::make_shared<SweptProfile>(SweptProfile{ProfileCurve(points, is_closed, is_revolved), xy[0], xy[1]});
  };
  set_profile();
  // The normals of an extruded surface are those of its facets, and those of a revolved one point away from the axis.
  double same = 0, away = 0;
  for (const std::uint32_t f : facets) {
    const FacetFrame& facet = graph.frames[f];
    const double part = graph.area[f] * glm::dot(facet.normal, patch.surface.normal(facet.middle));
    same += part;
    if (is_revolved) away += graph.area[f] * glm::dot(facet.normal, axis_place(frame, facet.middle).out);
  }
  patch.outward = !is_revolved || away >= 0;
  if ((same < 0) == patch.outward) {
    std::ranges::reverse(points);
    set_profile();
  }
  std::vector<double> distances;
  distances.reserve(facets.size());
  for (const std::uint32_t f : facets) distances.push_back(std::abs(patch.surface.distance(graph.frames[f].middle)));
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>((distances.size() - 1) / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  patch.sag = *middle;
  const auto number = static_cast<std::uint32_t>(surfaces_.patches.size());
  for (const std::uint32_t f : facets) {
    surfaces_.patch_of[f] = number;
    surfaces_.is_freeform[f] = 0;
  }
  surfaces_.patches.push_back(std::move(patch));
}

void find_swept_surfaces(const FacetObject& object, const FacetPatches& surfaces) {
  SweptPatches swept(object, surfaces);
  find_revolved(object, surfaces, swept);
  find_extruded(object, surfaces, swept);
}

}  // namespace ligne
