#pragma once
/// Walks over the faces of a mesh, as far as they are seen.

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

/// It refers to its arguments.
class FormWalk {
 public:
  FormWalk(const FormMesh& mesh, const View& view, const FormRegions& regions)
      : mesh_(mesh), view_(view), regions_(regions) {}

  Point3 point(const FormPlace& place) const;
  /// The place of a face that is drawn at a point of the page.
  std::optional<FormPlace> place_on(std::uint32_t face, Point2 page_mm) const;
  /// Millimetres of page per unit of model that a direction of space is seen as at a place.
  Point2 page_velocity(const Point3& point, const Point3& direction) const;
  /// Millimetres of page per unit of model across the line of sight.
  double scale_at(const Point3& point) const;

  /// Goes on along the field for at most `step_mm` of page and to the end of the triangle at the farthest, and turns
  /// `along`. False where the surface ends or is not seen any more: then `place` is as far as it was seen.
  bool step(const FormField& field, FormPlace& place, Point3& along, bool& second, double step_mm) const;
  /// Goes `length_mm` over the page in a direction of it; false where the surface ends before.
  bool cross(FormPlace& place, Point2 direction, double length_mm) const;

 private:
  /// How far a direction leads before it leaves the triangle, in its own length, and over which side.
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
