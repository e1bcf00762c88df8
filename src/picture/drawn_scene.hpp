#pragma once
/// A scene with its visible lines computed, which can be written as several files without computing them again.

#include <vector>

#include "drawing/drawing.hpp"
#include "picture/hatching/hatch_patches.hpp"
#include "picture/pages/write_picture.hpp"
#include "picture/prepared_scene.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "picture/scene_visibility.hpp"
#include "scene/patches/found_surfaces.hpp"

namespace ligne {

/// The results of all phases before the drawing is composed, as draw_lines() fills them in.
struct DrawnParts {
  PreparedScene prepared;  ///< its topology and projection are emptied
  SceneVisibility found;   ///< after finish_lines()
  std::vector<Layer> hatching{};
  HatchPatches patches{};  ///< smooth groups of faces, if regions are hatched or written to JSON for later hatching
  bool has_edges = false;  ///< whether SceneVisibility::source() may be called
  std::shared_ptr<const KnownEllipses> ellipses{};  ///< known_ellipses(), or null
};

/// The circles of recognised surfaces on the page, for curves in place of polylines.
std::shared_ptr<const KnownEllipses> known_ellipses(const PreparedScene& prepared);

class DrawnScene {
 public:
  explicit DrawnScene(DrawnParts parts);

  const PictureRequest& request() const { return parts_.prepared.request; }
  const PreparedScene& prepared() const { return parts_.prepared; }
  const SceneVisibility& visibility() const { return parts_.found; }
  const HatchPatches& patches() const { return parts_.patches; }

  /// The analytic surfaces recognised behind the mesh; none if the request has no clear creases.
  FoundSurfaces surfaces() const;

  /// Composes the drawing: joined lines, hatching, fills, and the axes, labels and title around the picture. Counts and
  /// warnings go to `run`.
  Drawing compose(RunReport& run) const;

  /// Whether this result suffices to write a file of that format for those pens.
  bool serves(const OutputRequest& output, const PlotterRequest& plotter) const;
  /// Sets the output of later calls of write(). serves() must be true for it. Throws RequestError.
  void choose(OutputRequest output, PlotterRequest plotter);
  /// Writes the file; `pages` as for write_picture().
  Picture write(RunReport& run, PdfDocument* pages = nullptr) const;

 private:
  DrawnParts parts_;
};

/// Whether the output needs the source edges of strokes: JSON does, and so do drawings that separate objects or
/// materials. For other outputs the edges are freed, since the method needs their memory.
bool looks_at_edges(const PictureRequest& request);

}  // namespace ligne
