#pragma once
/// Walks over the visible faces of a mesh.

#include <optional>

#include "base/no_index.hpp"
#include "picture/hatching/form_field.hpp"
#include "picture/hatching/form_regions.hpp"

namespace ligne {

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
