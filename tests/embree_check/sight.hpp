#pragma once
/// Faces that stand in the way of a sight. Embree's bounding volumes find the faces near a ray; whether the ray meets a face
/// is then decided in double arithmetic on the polygon itself, with its holes, so no triangulation is needed.

#include "checked_scene.hpp"

namespace ligne::check {

/// Which faces pass as touching a point: those whose plane is so near that the error of the input's coordinates explains it.
enum class Touching {
  strict,    ///< only what certainly touches passes; used to find lines that are certainly visible
  generous,  ///< all that may touch passes; used to find lines that are certainly hidden
};

struct Hit {
  std::uint32_t face = 0;
  double distance = 0;
  Point3 point{0, 0, 0};
};

class Sight {
 public:
  /// Keeps references to both.
  Sight(const CheckedScene& scene, const PageMap& map);
  ~Sight();
  Sight(const Sight&) = delete;
  Sight& operator=(const Sight&) = delete;

  /// Whether a face stands between the point and the viewer. `tolerance` is the error of the point's own coordinates.
  bool blocked(const Point3& q, double tolerance, Touching touching) const;
  /// Where the face stands between the point and the viewer, if it does.
  std::optional<Point3> in_front(const Point3& q, std::uint32_t face) const;
  /// The face that is seen at a page point.
  std::optional<Hit> seen_at(Point2 mm) const;

 private:
  struct Rays;
  std::unique_ptr<Rays> rays_;
};

}  // namespace ligne::check
