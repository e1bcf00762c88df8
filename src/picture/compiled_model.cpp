#include "picture/compiled_model.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <string_view>

#include "files/bytes.hpp"
#include "scene/readers/scene_bytes.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

constexpr std::string_view kMark = "ligne-tree\r\n";  ///< the line end is lost where a file is copied as text
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kHeadSize = kMark.size() + sizeof(kVersion) + sizeof(std::uint64_t);

/// Of what follows it in the file: tells a file that was damaged, not one that was forged.
std::uint64_t checksum(std::span<const std::byte> bytes) {
  std::uint64_t sum = bytes.size();
  for (std::size_t i = 0; i < bytes.size(); i += sizeof sum) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, std::min(sizeof word, bytes.size() - i));
    sum = (sum ^ word) * 0x9e3779b97f4a7c15u;
    sum ^= sum >> 32;
  }
  return sum;
}

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
  writer.number(kVersion);
  writer.number(std::uint64_t{0});  // the checksum comes when all is there
  writer.text(model.method->traits().name);
  write_scene(writer, model.scene);
  model.compiled->write(writer);
  std::string bytes = std::string(kMark) + writer.take();
  sign_compiled_model(bytes);
  return bytes;
}

void sign_compiled_model(std::string& bytes) {
  if (bytes.size() < kHeadSize) return;
  const std::uint64_t sum = checksum(std::as_bytes(std::span(bytes)).subspan(kHeadSize));
  std::memcpy(bytes.data() + kHeadSize - sizeof sum, &sum, sizeof sum);
}

bool is_compiled_model(std::span<const std::byte> bytes) { return as_characters(bytes).starts_with(kMark); }

const Method* method_of_compiled(const std::filesystem::path& file) {
  constexpr std::size_t kLongestName = 64;
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return nullptr;
  std::array<char, kHeadSize + sizeof(std::uint64_t) + kLongestName> begin{};
  std::ifstream in(file, std::ios::binary);
  in.read(begin.data(), begin.size());
  const auto bytes = std::as_bytes(std::span(begin)).first(static_cast<std::size_t>(in.gcount()));
  if (!is_compiled_model(bytes)) return nullptr;
  try {
    ByteReader reader(bytes.subspan(kMark.size()), file.string());
    reader.number<std::uint32_t>();
    reader.number<std::uint64_t>();
    return find_method(reader.text());
  } catch (const InputError&) {
    return nullptr;  // what is wrong with the file is told when it is read
  }
}

CompiledModel read_compiled_model(std::span<const std::byte> bytes, const std::string& name) {
  if (!is_compiled_model(bytes)) throw InputError(name, "not a compiled model");
  ByteReader reader(bytes.subspan(kMark.size()), name);
  const auto version = reader.number<std::uint32_t>();
  if (version != kVersion) {
    throw InputError(name, "a compiled model of version " + std::to_string(version) + "; this program reads version " +
                               std::to_string(kVersion) + ": compile the model again");
  }
  const auto sum = reader.number<std::uint64_t>();
  reader.need(sum == checksum(reader.rest()), "the file was changed or cut off since it was written");
  CompiledModel model;
  const std::string method = reader.text();
  model.method = find_method(method);
  if (!model.method || !model.method->traits().compiles) {
    throw InputError(name, "compiled for method " + shown(method) + ", which is not known");
  }
  model.scene = read_scene(reader);
  reader.need(!model.scene.objects.empty(), "there is no object");
  model.compiled = model.method->read_compiled(reader, model.scene);
  reader.need(reader.left() == 0, "something stands behind the tree");
  return model;
}

}  // namespace ligne
