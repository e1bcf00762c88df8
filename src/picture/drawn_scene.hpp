#pragma once
/// A scene whose lines are found, and which can be written as several files.

#include <optional>
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

/// The results of all phases before composition; draw_lines() makes it.
struct DrawnParts {
  PreparedScene prepared;  ///< without topology and projection
  SceneVisibility found;   ///< with its lines finished
  std::vector<Layer> hatching{};
  HatchPatches patches{};  ///< where regions are hatched, now or from the file
  bool has_edges = false;  ///< SceneVisibility::source() can be asked
};

class DrawnScene {
 public:
  explicit DrawnScene(DrawnParts parts);

  const PictureRequest& request() const { return parts_.prepared.request; }
  const PreparedScene& prepared() const { return parts_.prepared; }
  const SceneVisibility& visibility() const { return parts_.found; }
  const HatchPatches& patches() const { return parts_.patches; }

  /// The surfaces behind the mesh, none where no clear creases were asked for.
  FoundSurfaces surfaces() const;

  /// Lines joined, hatching, fills, and what stands round the picture. Counts and warnings go to `run`.
  Drawing compose(RunReport& run) const;

  /// True where another file needs no more than what was found: the lines of that format, for these pens.
  bool serves(const OutputRequest& output, const PlotterRequest& plotter) const;
  /// Chooses the output of write() from now on; serves() says that it can. Throws RequestError.
  void choose(OutputRequest output, PlotterRequest plotter);
  /// The file; `pages`: see write_picture().
  Picture write(RunReport& run, PdfDocument* pages = nullptr) const;

 private:
  DrawnParts parts_;
};

/// Only JSON and drawings that tell parts apart look at the source edges; a method needs the memory of the rest.
bool looks_at_edges(const PictureRequest& request);

}  // namespace ligne
