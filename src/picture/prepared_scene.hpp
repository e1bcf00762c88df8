#pragma once
/// A scene prepared for a visibility method: topology, placement on the page, candidate lines, contours.

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "contours/contour_lines.hpp"
#include "contours/shapes/shape_lines.hpp"
#include "picture/light/details.hpp"
#include "picture/marks/axes.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/creases/find_creases.hpp"
#include "scene/form/free_forms.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/patch_circles.hpp"
#include "view/cull.hpp"
#include "view/projected_scene.hpp"
#include "visibility/method.hpp"

namespace ligne {

class SmoothTones;
struct GivenScene;

/// A prepared scene. The scene itself must outlive it.
struct PreparedScene {
  const Scene& scene;
  PictureRequest request;
  const Method& method;
  Topology topology;
  PictureMarks around;  ///< axes and texts around the picture, and its placement on the page
  ProjectedScene projected;
  BackFaces back_faces;       ///< culled faces, which `projected` does not contain
  std::vector<Light> lights;  ///< lights of fills, hatching and shadows
  /// Facets of `projected`, and what follows from them, if an idle thread made them; otherwise the method makes them.
  std::shared_ptr<const FaceStudy> faces{};
  SmoothContours contours{};  ///< replace outlines of the mesh
  ShapeLines shape_lines{};   ///< suggestive contours, ridges, valleys, and tangent lines along fillets
  std::vector<ScanObject> scans{};
  std::vector<FreeForm> free_forms{};
  Patches patches{};                   ///< analytic surfaces found for clear creases; free forms are emptied
  std::vector<PatchCircle> circles{};  ///< at which surfaces end
  /// Source of the first probe: a short line at a marked point (LineGroups) whose visibility is that of the point.
  std::uint32_t first_probe = 0;
  std::vector<DetailLine> details{};
  std::uint32_t first_detail = 0;  ///< source of the first detail line

  std::shared_ptr<const SmoothTones> tones{};  ///< for GrayTone::smooth

  std::shared_ptr<const GivenScene> given{};  ///< the scene that `scene` refines (clear/refined_picture.hpp); null: none

  const View& view() const { return around.placement.view; }
};

/// Prepares a scene. `box` and `topology` are those of draw_lines(). Throws RequestError.
PreparedScene prepare(const Scene& scene, PictureRequest request, const std::optional<PlotBox>& box, RunReport& run,
                      std::optional<Topology> topology = {});

/// Replaces the scene of a preparation, which must outlive the result.
PreparedScene with_scene(PreparedScene prepared, const Scene& scene);

/// Options of the smooth contours: the pen width of the request, and the creases at which smooth regions end.
ContourOptions contour_options(const PictureRequest& request, const Creases& creases);

/// Removes the back faces from the projected scene. One warning counts the objects that keep theirs.
BackFaces cull_back_faces(const Scene& scene, const Topology& topology, ProjectedScene& projected, RunReport& run);

}  // namespace ligne
