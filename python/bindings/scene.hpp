#pragma once
/// Scenes as Python holds them.

#include <memory>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "picture/models.hpp"
#include "scene/model/topology.hpp"

namespace ligne::python {

/// A scene that was read and mended, and never changes: any number of drawings and threads share it.
struct SceneHolder {
  Scene scene;
  Topology topology;
  ModelRequest request;                             ///< what it was read with
  std::shared_ptr<const CompiledScene> compiled{};  ///< of a file of `ligne compile`, for that method
  const Method* compiled_for = nullptr;
  std::vector<std::string> warnings;
};

/// Adds Scene, and the functions that make one.
void add_scene(pybind11::module_& module);

}  // namespace ligne::python
