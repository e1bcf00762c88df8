#pragma once
/// A scene that was studied once, and can be written as several files.

#include <cstdint>
#include <optional>
#include <vector>

#include "drawing/drawing.hpp"
#include "picture/hatching/hatch_patches.hpp"
#include "picture/marks/axes.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "picture/scene_visibility.hpp"
#include "picture/write_picture.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/found_surfaces.hpp"

namespace ligne {

class DrawnScene {
 public:
  /// Studies the scene, which must outlive this, and hatches it; arguments as for draw_scene(). `keep_edges`: study() can
  /// tell sources, whatever the format. Throws RequestError.
  DrawnScene(const Scene& scene, PictureRequest request, RunReport& run, const std::optional<PlotBox>& box = std::nullopt,
             std::optional<Topology> topology = {}, bool keep_edges = false);
  DrawnScene(const DrawnScene&) = delete;
  DrawnScene& operator=(const DrawnScene&) = delete;

  const PictureRequest& request() const { return request_; }
  const PreparedScene& prepared() const { return prepared_; }  ///< its topology and its projection are given up
  const SceneVisibility& study() const { return study_; }

  /// The surfaces behind the mesh, none where no clear creases were asked for.
  FoundSurfaces surfaces() const { return found_surfaces(prepared_.scene, prepared_.patches); }

  /// Lines joined, hatching, fills, and what stands round the picture. Counts and warnings go to `run`.
  Drawing drawing(RunReport& run) const;

  /// True where another file needs no more than the study has: the lines of that format, for these pens.
  bool serves(const OutputRequest& output, const PlotterRequest& plotter) const;
  /// Chooses the output of write() from now on; serves() says that it can. Throws RequestError.
  void choose(OutputRequest output, PlotterRequest plotter);
  /// The file; `pages`: see write_picture().
  Picture write(RunReport& run, PdfDocument* pages = nullptr) const;

 private:
  std::string json(const PlotOptions& plot) const;

  PictureRequest request_;
  PreparedScene prepared_;
  std::vector<Layer> hatching_;
  HatchPatches patches_;  ///< where regions are hatched, now or from the file
  SceneVisibility study_;
  bool has_edges_ = false;
};

}  // namespace ligne
