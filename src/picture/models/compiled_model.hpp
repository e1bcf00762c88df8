#pragma once
/// Files of `ligne compile`: a model with what a method makes of it for all views.

#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_file.hpp"
#include "picture/run_report.hpp"
#include "scene/model/scene.hpp"
#include "visibility/method.hpp"

namespace ligne {

struct CompiledModel {
  Scene scene;
  const Method* method = nullptr;
  std::shared_ptr<const CompiledScene> compiled;
};

/// Names of the methods that compile; the first is the usual one.
std::vector<std::string_view> compiling_methods();

/// Throws RequestError for a setting that the method does not have.
CompiledModel compile_model(Scene scene, const Method& method, const MethodSettings& settings, RunReport& run);

/// The bytes of a file, see docs/tree-format.md. The same model gives the same bytes.
std::string write_compiled_model(const CompiledModel& model);

/// Puts the checksum of the rest into the bytes of such a file.
void sign_compiled_model(std::string& bytes);

/// Whether a file begins as those of write_compiled_model() do.
bool is_compiled_model(std::span<const std::byte> bytes);
/// The method for which a file was compiled, of which no more than the beginning is read; nullptr for other files, and where
/// there is none.
const Method* method_of_compiled(const std::filesystem::path& file);

/// `name` stands in error messages. Throws InputError for a file that was changed or cut off, or is of another version, or
/// whose tree is none.
CompiledModel read_compiled_model(std::span<const std::byte> bytes, const std::string& name);

}  // namespace ligne
