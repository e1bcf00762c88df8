#include "scene/patches/refine/chord_corners.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>

#include <glm/geometric.hpp>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "scene/patches/refine/shared_point.hpp"

namespace ligne {
namespace {

/// Least distance of others, in sags, where a vertex lies kOffSags beside its surface: chords end on it.
constexpr double kNearSags = 0.01;
/// Least distance in precisions of the coordinates: twice what corners of a surface may lie beside it.
constexpr double kPrecisionsOff = 16;
/// Largest distance, in the largest sag of the surfaces there, by which a vertex moves: surfaces that meet at an acute angle
/// meet farther away than either of them lies.
constexpr double kFarthestSags = 8;
/// Largest distance of the new place from its surfaces, in sags.
constexpr double kAccuracySags = 1e-3;
/// Largest number of steps of Newton's method: it doubles the digits at each.
constexpr int kChordSteps = 12;
constexpr std::size_t kMostSides = 3;

/// A vertex with a surface or a plane beside it: a patch, or the number of patches plus that of a region, or kNone for what
/// is neither.
struct VertexSide {
  std::uint32_t vertex, side;
  bool operator<(const VertexSide& o) const { return std::tie(vertex, side) < std::tie(o.vertex, o.side); }
  bool operator==(const VertexSide& o) const = default;
};

/// The shortest step from a point to where the distances from up to three surfaces are 0, to first order.
std::optional<Point3> step_to_all(std::span<const Point3> normals, std::span<const double> distances) {
  constexpr double kLeastSine = 0.1;  // surfaces that touch more nearly have no certain common line
  if (normals.size() == 1) return -distances[0] * normals[0];
  if (normals.size() == 2) {
    const double c = glm::dot(normals[0], normals[1]), s = 1 - c * c;
    if (!(s > kLeastSine * kLeastSine)) return std::nullopt;
    return -(distances[0] - c * distances[1]) / s * normals[0] - (distances[1] - c * distances[0]) / s * normals[1];
  }
  const Point3 a = glm::cross(normals[1], normals[2]), b = glm::cross(normals[2], normals[0]),
               c = glm::cross(normals[0], normals[1]);
  const double volume = glm::dot(normals[0], a);
  if (!(std::abs(volume) > kLeastSine * kLeastSine)) return std::nullopt;
  return -(distances[0] * a + distances[1] * b + distances[2] * c) / volume;
}

class ChordFinder {
 public:
  ChordFinder(const Scene& scene, const Topology& topology, const Patches& patches, const PlaneRegions& planes,
              const std::vector<std::uint8_t>& levels)
      : scene_(scene), topology_(topology), patches_(patches), planes_(planes), levels_(levels) {}

  ChordCorners find() {
    mark_vertices();
    if (!any_) return {};
    list_sides();
    for (std::size_t i = 0; i < sides_.size();) {
      std::size_t k = i + 1;
      while (k < sides_.size() && sides_[k].vertex == sides_[i].vertex) ++k;
      place(std::span(sides_).subspan(i, k - i));
      i = k;
    }
    return std::move(found_);
  }

 private:
  static constexpr std::uint8_t kOnSurface = 0, kNearOff = 1, kFarOff = 2;

  bool is_refined(std::uint32_t patch) const { return patch != kNone && levels_[patch] > 0; }

  void mark_vertices() {
    is_off_.assign(scene_.vertices.size(), kOnSurface);
    std::vector<std::uint8_t> is_cut(patches_.list.size(), 0);
    std::vector<double> rounding(patches_.list.size(), 0);
    for (const Object& object : scene_.objects) {
      for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
        if (is_refined(patches_.patch_of[f])) rounding[patches_.patch_of[f]] = kPrecisionsOff * object.precision;
      }
    }
    const auto for_corners = [&](const auto& visit) {
      for (const Triangle& t : topology_.triangles) {
        const std::uint32_t patch = patches_.patch_of[t.face];
        if (!is_refined(patch)) continue;
        const Patch& at = patches_.list[patch];
        for (const std::uint32_t v : t.v) {
          const double off = std::abs(at.surface.distance(scene_.vertices[v]));
          if (off > rounding[patch]) visit(patch, v, off / at.sag);
        }
      }
    };
    for_corners([&](std::uint32_t patch, std::uint32_t v, double sags) {
      if (sags > kOffSags) is_cut[patch] = 1, is_off_[v] = kFarOff, any_ = true;
    });
    if (!any_) return;
    for_corners([&](std::uint32_t patch, std::uint32_t v, double sags) {
      if (is_cut[patch] && sags > kNearSags) is_off_[v] = std::max(is_off_[v], kNearOff);
    });
  }

  std::uint32_t side_of(std::uint32_t face) const {
    if (is_refined(patches_.patch_of[face])) return patches_.patch_of[face];
    const std::uint32_t region = planes_.region_of[face];
    return region == kNone ? kNone : static_cast<std::uint32_t>(patches_.list.size()) + region;
  }

  void list_sides() {
    for (const Triangle& t : topology_.triangles) {
      for (const std::uint32_t v : t.v) {
        if (is_off_[v] != kOnSurface) sides_.push_back({v, side_of(t.face)});
      }
    }
    parallel_sort(sides_.begin(), sides_.end());
    sides_.erase(std::unique(sides_.begin(), sides_.end()), sides_.end());
  }

  void place(std::span<const VertexSide> sides) {
    const std::uint32_t vertex = sides[0].vertex;
    const std::size_t patches = patches_.list.size();
    if (const std::optional<Point3> at = place_of(sides)) {
      found_.moved.push_back(vertex);
      found_.places.push_back(*at);
      for (const VertexSide& s : sides) {
        if (s.side >= patches) found_.regions.push_back(s.side - static_cast<std::uint32_t>(patches));
      }
      return;
    }
    if (is_off_[vertex] != kFarOff) return;
    for (const VertexSide& s : sides) {
      if (s.side < patches) found_.patches.push_back(s.side);
    }
  }

  std::optional<Point3> place_of(std::span<const VertexSide> sides) const {
    if (sides.size() > kMostSides || sides.back().side == kNone) return std::nullopt;
    const Point3& from = scene_.vertices[sides[0].vertex];
    std::array<SideSurface, kMostSides> surfaces;
    double sag = 0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const std::uint32_t side = sides[i].side;
      if (side < patches_.list.size()) {
        surfaces[i].surface = &patches_.list[side].surface;
        sag = std::max(sag, patches_.list[side].sag);
      } else {
        const PlaneRegion& region = planes_.list[side - patches_.list.size()];
        surfaces[i] = {nullptr, region.at, region.normal};
      }
    }
    Point3 at = from;
    std::array<Point3, kMostSides> normals;
    std::array<double, kMostSides> distances{};
    for (int step = 0;; ++step) {
      double most = 0;
      for (std::size_t i = 0; i < sides.size(); ++i) {
        normals[i] = surfaces[i].normal_at(at);
        distances[i] = surfaces[i].distance(at);
        most = std::max(most, std::abs(distances[i]));
      }
      if (step == kChordSteps) return most <= kAccuracySags * sag ? std::optional(at) : std::nullopt;
      const auto by = step_to_all({normals.data(), sides.size()}, {distances.data(), sides.size()});
      if (!by) return std::nullopt;
      at += *by;
      if (!(glm::distance(at, from) <= kFarthestSags * sag)) return std::nullopt;
    }
  }

  const Scene& scene_;
  const Topology& topology_;
  const Patches& patches_;
  const PlaneRegions& planes_;
  const std::vector<std::uint8_t>& levels_;
  std::vector<std::uint8_t> is_off_;  ///< per vertex: how it lies beside a refined surface of its faces
  bool any_ = false;
  std::vector<VertexSide> sides_;  ///< of these vertices; sorted, each once
  ChordCorners found_;
};

}  // namespace

ChordCorners chord_corners(const Scene& scene, const Topology& topology, const Patches& patches, const PlaneRegions& planes,
                           const std::vector<std::uint8_t>& levels) {
  return ChordFinder(scene, topology, patches, planes, levels).find();
}

}  // namespace ligne
