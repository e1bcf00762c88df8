#pragma once
/// The visible surfaces of a mesh, and where on the page they end.

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "drawing/result_models.hpp"
#include "scene/form/form_mesh.hpp"
#include "view/view.hpp"

namespace ligne {

/// It refers to the regions. Those behind transparent faces do not count.
class FormRegions {
 public:
  /// `cell_mm`: about the distance at which rims are asked for.
  FormRegions(const Scene& scene, const FormMesh& mesh, const View& view, std::span<const Region> regions, double cell_mm);

  /// The region of the face that holds the point of the page.
  std::optional<std::uint32_t> region_at(std::uint32_t face, Point2 page_mm) const;
  /// region_at() for a point of the face that is seen, and may lie between two regions.
  std::uint32_t region_near(std::uint32_t face, Point2 page_mm) const;
  /// How much of the way between two points of a face is seen, from its beginning: 1 is all of it.
  double seen_until(std::uint32_t face, Point2 from, Point2 to) const;
  /// Whether a rim is nearer than that: there the surface ends, or is hidden, or turns away.
  bool near_rim(Point2 page_mm, double distance_mm) const;
  /// A point inside of each region; nothing where there is no room.
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

/// Number of a cell of a square grid, of any place.
std::uint64_t grid_cell(std::int32_t column, std::int32_t row);

}  // namespace ligne
