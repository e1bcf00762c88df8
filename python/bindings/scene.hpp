#pragma once
/// Scenes as Python holds them.

#include <memory>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "picture/models.hpp"

namespace ligne::python {

/// A scene that was read and mended, and never changes: any number of drawings and threads share it.
struct SceneHolder {
  LoadedModels models;   ///< with their topology
  ModelRequest request;  ///< what they were read with
  std::vector<std::string> warnings;

  const Scene& scene() const { return models.scene; }
  const Topology& topology() const { return *models.topology; }
};

/// Adds Scene, and the functions that make one.
void add_scene(pybind11::module_& module);

}  // namespace ligne::python
