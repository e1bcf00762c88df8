#pragma once
/// The visible surfaces of a mesh, and their rims on the page.

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "drawing/result_models.hpp"
#include "scene/form/form_mesh.hpp"
#include "view/view.hpp"

namespace ligne {

/// Looks up visible regions of faces and their rims. It refers to `regions`, and ignores those behind transparent
/// faces.
class FormRegions {
 public:
  /// `cell_mm`: side of the grid cells, about the distance of the queries for rims.
  FormRegions(const Scene& scene, const FormMesh& mesh, const View& view, std::span<const Region> regions, double cell_mm);

  /// Returns the region of the face that contains the point of the page.
  std::optional<std::uint32_t> region_at(std::uint32_t face, Point2 page_mm) const;
  /// region_at() for a visible point of the face, which may lie between two regions.
  std::uint32_t region_near(std::uint32_t face, Point2 page_mm) const;
  /// Returns the fraction of the way between two points of a face up to which it is visible; 1: all of it.
  double seen_until(std::uint32_t face, Point2 from, Point2 to) const;
  /// Whether a rim is within the distance. At a rim the surface ends, is hidden, or turns away.
  bool near_rim(Point2 page_mm, double distance_mm) const;
  /// Returns a point inside the region; none if it has no area.
  static std::optional<Point2> point_inside(const Region& region);

  const Region& operator[](std::uint32_t number) const { return regions_[number]; }

 private:
  struct Rim {
    Point2 from, to;
  };
  std::span<const std::uint32_t> of_face(std::uint32_t face) const {
    return {list_.data() + first_[face], list_.data() + first_[face + 1]};
  }
  void add_rims(const FormMesh& mesh, std::span<const Point2> page, std::uint32_t face);
  void add_rim(const Rim& rim);
  std::uint64_t cell(double x, double y) const;

  std::span<const Region> regions_;
  std::vector<std::uint32_t> first_, list_;  ///< regions of each face
  double cell_mm_;
  std::vector<Rim> rims_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;  ///< rims that meet the box of a cell
};

/// Key of a cell of a square grid.
std::uint64_t grid_cell(std::int32_t column, std::int32_t row);

}  // namespace ligne
