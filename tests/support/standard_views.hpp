#pragma once
/// The views from which every scene of the corpus is drawn.

#include "support/standard.hpp"
#include "view/view.hpp"

namespace ligne::test {

/// Where the picture is put: on A4 in landscape, as large as it fits, unless told otherwise.
struct Sheet {
  Rect page{{0, 0}, {297, 210}};
  Frame frame{{{10, 10}, {287, 200}}};
  std::optional<double> scale{};
};

struct StandardView {
  std::string name;
  CameraRequest camera;
  /// The view on the command line: "--direction=-1,1,-1 --landscape".
  std::string options;
  Sheet sheet{};
};

/// Four parallel views (isometric, an odd direction, a dimetric-like one, along an axis), two perspectives from outside the
/// scene's bounding sphere, at 2.2 and 1.4 radii from its centre, and one from inside its bounding box.
std::vector<StandardView> standard_views(const Scene& scene);

/// These views; in the first tier `count` of them that follow each other, beginning where the seed and the key choose.
std::vector<StandardView> rotated_views(const Scene& scene, std::string_view key, std::size_t count);

/// Views in which vertices, and edges with them, lie on the border of what is drawn, and more lies outside: the sheet cut
/// through the scene from the front and in the isometric view, and a field of view of 90 degrees whose border goes through a
/// vertex to the last digits.
std::vector<StandardView> border_views(const Scene& scene);

/// A perspective on A4.
StandardView perspective_view(const std::string& name, const Scene& scene, const Point3& eye, const Point3& target,
                              double fov_degrees);

}  // namespace ligne::test
