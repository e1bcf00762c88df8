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
  /// Draws a scene that stays in memory, with surfaces among it.
  static std::shared_ptr<DrawingHolder> of_scene(std::shared_ptr<const SceneHolder> scene, const SurfaceRequest& surfaces,
                                                 Options options, const pybind11::object& progress);
  /// Draws surfaces.
  static std::shared_ptr<DrawingHolder> of_surface(SurfaceRequest surface, Options options,
                                                   const pybind11::object& progress);

  /// The file of another format or for other pens.
  Picture write(const pybind11::dict& keywords, const pybind11::object& progress);

  /// Throws RequestError where a file to be written is one that was read.
  void refuse_its_inputs(const std::string& field, const std::string& file) const;

  /// The surfaces as a mesh file. Throws RequestError where none were drawn.
  std::string write_mesh(MeshFormat format) const;

  /// Layers of polylines.
  Drawing layers();
  /// Nothing where the floating horizon drew.
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
  std::mutex mutex_;  ///< of whoever writes: that may draw anew
};

/// The options of a drawing of that scene. Throws RequestError.
void adapt(Options& options, const SceneHolder& scene);
/// The request of adapted options, for that scene. Throws RequestError.
PictureRequest request_for(const Options& options, const SceneHolder& scene);

void add_drawing(pybind11::module_& module);
void add_surface(pybind11::module_& module);
/// Adds info(), compare(), compile() and draw_frames().
void add_model_work(pybind11::module_& module);
void add_plot(pybind11::module_& module);
/// Adds study() and experiments().
void add_study(pybind11::module_& module);

}  // namespace ligne::python
