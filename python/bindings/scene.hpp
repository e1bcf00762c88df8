#pragma once
/// Scenes as Python holds them.

#include <memory>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "files/input_file.hpp"
#include "picture/models/models.hpp"

namespace ligne::python {

/// A scene after reading and repair. It never changes, so any number of drawings and threads may share it.
struct SceneHolder {
  LoadedModels models;   ///< including their topology
  ModelRequest request;  ///< the options with which they were read
  std::vector<std::string> warnings;

  /// The files that were read for it.
  InputFiles inputs() const;
  const Scene& scene() const { return models.scene; }
  const Topology& topology() const { return *models.topology; }
};

/// Throws RequestError if an output file is also an input file.
void refuse_inputs(const InputFiles& inputs, const std::string& field, const std::string& file);

/// Adds Scene and the functions that make scenes.
void add_scene(pybind11::module_& module);

}  // namespace ligne::python
