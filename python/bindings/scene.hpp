#pragma once
/// Scenes as Python holds them.

#include <memory>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "files/input_file.hpp"
#include "picture/models/models.hpp"

namespace ligne::python {

/// A scene that was read and mended, and never changes: any number of drawings and threads share it.
struct SceneHolder {
  LoadedModels models;   ///< with their topology
  ModelRequest request;  ///< what they were read with
  std::vector<std::string> warnings;

  /// The files that were read for it.
  InputFiles inputs() const;
  const Scene& scene() const { return models.scene; }
  const Topology& topology() const { return *models.topology; }
};

/// Throws RequestError where what is to be written is one of the files that were read.
void refuse_inputs(const InputFiles& inputs, const std::string& field, const std::string& file);

/// Adds Scene, and the functions that make one.
void add_scene(pybind11::module_& module);

}  // namespace ligne::python
