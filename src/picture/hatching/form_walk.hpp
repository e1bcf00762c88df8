#pragma once
/// Walks over the visible faces of a mesh.

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "base/index_lists.hpp"
#include "base/no_index.hpp"
#include "drawing/result_models.hpp"
#include "picture/hatching/form_field.hpp"
#include "scene/form/form_mesh.hpp"
#include "view/view.hpp"

namespace ligne {

/// The visible surfaces of a mesh, and their rims on the page.

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
  void add_rims(const FormMesh& mesh, std::span<const Point2> page, std::uint32_t face);
  void add_rim(const Rim& rim);
  std::uint64_t cell(double x, double y) const;

  std::span<const Region> regions_;
  IndexLists of_face_;  ///< regions of each face
  double cell_mm_;
  std::vector<Rim> rims_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;  ///< rims that meet the box of a cell
};

/// Key of a cell of a square grid.
std::uint64_t grid_cell(std::int32_t column, std::int32_t row);

/// A place on a mesh.
struct FormPlace {
  std::uint32_t triangle = kNone;
  Weights weights{1, 0, 0};
  Point2 page{0, 0};
};

/// The walker. It refers to its arguments.
class FormWalk {
 public:
  FormWalk(const FormMesh& mesh, const View& view, const FormRegions& regions)
      : mesh_(mesh), view_(view), regions_(regions) {}

  Point3 point(const FormPlace& place) const;
  /// Returns the point of the face that is drawn at a point of the page.
  std::optional<FormPlace> place_on(std::uint32_t face, Point2 page_mm) const;
  /// Returns the velocity on the page, in mm per model unit, of a move in a direction of space.
  Point2 page_velocity(const Point3& point, const Point3& direction) const;
  /// Returns page mm per model unit at right angles to the line of sight.
  double scale_at(const Point3& point) const;

  /// Moves along the field by at most `step_mm` on the page and at most to the end of the triangle, and updates
  /// `along`. Returns false where the surface ends or is hidden; `place` is then its last visible point.
  bool step(const FormField& field, FormPlace& place, Point3& along, bool& second, double step_mm) const;
  /// Moves by `length_mm` on the page in a direction of the page. Returns false if the surface ends before.
  bool cross(FormPlace& place, Point2 direction, double length_mm) const;

 private:
  /// Distance to the side where a direction leaves the triangle, in lengths of the direction, and that side.
  struct Exit {
    double length;
    int side;
  };
  Exit exit_of(const FormPlace& place, const Point3& direction) const;
  FormPlace moved(const FormPlace& place, const Point3& way) const;
  Weights rates(std::uint32_t triangle, const Point3& direction) const;
  bool advance(FormPlace& place, const Point3& direction, const Exit& exit, double length) const;

  const FormMesh& mesh_;
  const View& view_;
  const FormRegions& regions_;
};

}  // namespace ligne
