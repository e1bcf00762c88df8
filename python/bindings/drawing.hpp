#pragma once
/// Drawings as Python holds them.

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "bindings/options.hpp"
#include "bindings/scene.hpp"
#include "bindings/work.hpp"
#include "picture/drawn_scene.hpp"
#include "picture/surface/surface_mesh_picture.hpp"
#include "picture/surface/surface_picture.hpp"

namespace ligne::python {

/// A drawing of a scene or by the floating horizon, and its options.
class DrawingHolder {
 public:
  /// Draws a scene, which stays in memory, together with surfaces.
  static std::shared_ptr<DrawingHolder> of_scene(std::shared_ptr<const SceneHolder> scene, const SurfaceRequest& surfaces,
                                                 Options options, const pybind11::object& progress);
  /// Draws surfaces.
  static std::shared_ptr<DrawingHolder> of_surface(SurfaceRequest surface, Options options,
                                                   const pybind11::object& progress);

  /// Writes the file in another format or for other pens.
  Picture write(const pybind11::dict& keywords, const pybind11::object& progress);

  /// Throws RequestError if an output file is also an input file.
  void refuse_its_inputs(const std::string& field, const std::string& file) const;

  /// Writes the surfaces as a mesh file. Throws RequestError if none were drawn.
  std::string write_mesh(MeshFormat format) const;

  /// Layers of polylines.
  Drawing layers();
  /// None for drawings of the floating horizon.
  const DrawnScene* drawn() const { return drawn_.get(); }
  const Page& page() const;
  const RunReport& report() const { return run_; }

 private:
  void draw(const PictureRequest& request, const Progress& progress);

  std::shared_ptr<const SceneHolder> scene_;  ///< of a model
  std::optional<SurfaceRequest> surface_;
  Options options_;
  RunReport run_;
  std::optional<SurfaceScene> surface_scene_;
  std::unique_ptr<DrawnScene> drawn_;
  std::optional<HorizonDrawing> horizon_;
  std::mutex mutex_;  ///< locked while writing, which may draw again
};

/// Options of a drawing of the scene. Throws RequestError.
void adapt(Options& options, const SceneHolder& scene);
/// Request of adapted options, for the scene. Throws RequestError.
PictureRequest request_for(const Options& options, const SceneHolder& scene);

void add_drawing(pybind11::module_& module);
void add_surface(pybind11::module_& module);
/// Adds info(), compare(), compile() and draw_frames().
void add_model_work(pybind11::module_& module);
void add_plot(pybind11::module_& module);
/// Adds study() and experiments().
void add_study(pybind11::module_& module);

}  // namespace ligne::python
