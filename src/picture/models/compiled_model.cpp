#include "picture/models/compiled_model.hpp"

#include <array>
#include <cstdint>
#include <fstream>

#include "files/checksummed_file.hpp"
#include "scene/readers/scene_bytes.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

constexpr ChecksummedFormat kTreeFile{"ligne-tree\r\n", 1, "a compiled model", "compile the model again"};

}  // namespace

std::vector<std::string_view> compiling_methods() {
  std::vector<std::string_view> names;
  for (const Method* method : all_methods()) {
    if (method->traits().compiles) names.push_back(method->traits().name);
  }
  return names;
}

CompiledModel compile_model(Scene scene, const Method& method, const MethodSettings& settings, RunReport& run) {
  run.method = method.traits().name;
  CompiledModel model{std::move(scene), &method, nullptr};
  const std::string asks = std::to_string(model.scene.faces.size()) + " faces";
  model.compiled = timed(run.stages, {"compile", asks}, [&] { return method.compile(model.scene, settings); });
  return model;
}

std::string write_compiled_model(const CompiledModel& model) {
  ByteWriter writer;
  writer.text(model.method->traits().name);
  write_scene(writer, model.scene);
  model.compiled->write(writer);
  return checksummed_file(kTreeFile, writer.bytes());
}

void write_checksum_of_model(std::string& bytes) { write_checksum(kTreeFile, bytes); }

bool is_compiled_model(std::span<const std::byte> bytes) { return has_magic(kTreeFile, bytes); }

const Method* method_of_compiled(const std::filesystem::path& file) {
  constexpr std::size_t kLongestName = 64;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return nullptr;
  std::array<char, header_size(kTreeFile) + sizeof(std::uint64_t) + kLongestName> begin{};
  std::ifstream in(file, std::ios::binary);
  in.read(begin.data(), begin.size());
  const auto bytes = std::as_bytes(std::span(begin)).first(static_cast<std::size_t>(in.gcount()));
  if (!is_compiled_model(bytes) || bytes.size() < header_size(kTreeFile)) return nullptr;
  try {
    return find_method(ByteReader(bytes.subspan(header_size(kTreeFile)), file.string()).text());
  } catch (const InputError&) {
    return nullptr;  // read_compiled_model() reports the fault
  }
}

CompiledModel read_compiled_model(std::span<const std::byte> bytes, const std::string& name) {
  ByteReader reader = open_checksummed(kTreeFile, bytes, name);
  CompiledModel model;
  const std::string method = reader.text();
  model.method = find_method(method);
  if (!model.method || !model.method->traits().compiles) {
    throw InputError(name, "compiled for method " + shown(method) + ", which is not known");
  }
  model.scene = read_scene(reader);
  reader.need(!model.scene.objects.empty(), "there is no object");
  model.compiled = model.method->read_compiled(reader, model.scene);
  reader.need(reader.left() == 0, "there are bytes after the tree");
  return model;
}

}  // namespace ligne
