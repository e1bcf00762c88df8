#pragma once
/// Files of `ligne compile`: a model with data that a method computes for all views.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "picture/run_report.hpp"
#include "scene/model/scene.hpp"
#include "visibility/method.hpp"

namespace ligne {

struct CompiledModel {
  Scene scene;
  const Method* method = nullptr;
  std::shared_ptr<const CompiledScene> compiled;
};

/// Names of the methods that compile; the first is the default.
std::vector<std::string_view> compiling_methods();

/// Compiles a model. Throws RequestError for a setting that the method does not have.
CompiledModel compile_model(Scene scene, const Method& method, const MethodSettings& settings, RunReport& run);

/// Returns the bytes of a file, see docs/tree-format.md. Equal models give equal bytes.
std::string write_compiled_model(const CompiledModel& model);

/// Writes the checksum of all other bytes into the bytes of such a file.
void write_checksum_of_model(std::string& bytes);

/// Whether a file begins like those of write_compiled_model().
bool is_compiled_model(std::span<const std::byte> bytes);
/// Returns the method for which a file was compiled, and reads only the beginning of the file. Returns nullptr for
/// other files, or if the file does not exist.
const Method* method_of_compiled(const std::filesystem::path& file);

/// Reads such a file; `name` is for error messages. Throws InputError if the file was changed or cut off, has another
/// version, or contains no valid tree.
CompiledModel read_compiled_model(std::span<const std::byte> bytes, const std::string& name);

}  // namespace ligne
