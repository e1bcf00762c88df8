#include "known_answer.hpp"

#include <nlohmann/json.hpp>

#include "scene/readers/reader.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

[[noreturn]] void fail(const std::string& what) { throw KnownAnswerError(what); }

void expect_keys(const json& object, const std::string& what, const std::set<std::string>& known) {
  for (const auto& [key, value] : object.items())
    if (!known.contains(key)) fail(what + ": unknown key '" + key + "'");
}

Point3 point(const json& value) {
  const auto [x, y, z] = value.get<std::array<double, 3>>();
  if (value.size() != 3) fail(value.dump() + " is not a point [x, y, z]");
  return {x, y, z};
}

LineClass line_class(std::string_view word) {
  const auto found = std::find(kLineClassNames.begin(), kLineClassNames.end(), word);
  if (found == kLineClassNames.end()) fail("there is no class '" + std::string(word) + "'");
  return static_cast<LineClass>(found - kLineClassNames.begin());
}

void read_view(const json& view, KnownAnswer& answer) {
  expect_keys(view, "view", {"name", "direction", "eye", "target", "fov", "up", "right", "down"});
  if (view.contains("name") + view.contains("direction") + view.contains("eye") != 1)
    fail("view: needs one of 'name', 'direction' and 'eye'");
  CameraRequest& camera = answer.camera;
  if (view.contains("name")) {
    const auto known = std::ranges::find(kNamedViews, view["name"].get<std::string>());
    if (known == std::end(kNamedViews)) fail("there is no view " + view["name"].dump());
    camera.named_view = *known;
  }
  if (view.contains("direction")) camera.direction = point(view["direction"]);
  if (view.contains("eye")) {
    camera.eye = point(view["eye"]);
    camera.target = point(view.at("target"));
    camera.fov_degrees = view.at("fov").get<double>();
  }
  if (view.contains("up")) camera.up = point(view["up"]);
  answer.right = point(view.at("right"));
  answer.down = point(view.at("down"));
}

Scene read_scene_of(const json& scene, const std::filesystem::path& folder) {
  Warnings warnings;
  const std::string bytes = scene.dump();
  Scene result = scene.is_string()
                     ? read_scene(folder / scene.get<std::string>(), {}, warnings)
                     : read_scene({std::as_bytes(std::span(bytes)), "scene"}, ModelFormat::ligne_scene, {}, warnings);
  if (!warnings.counts().empty()) fail("scene: had to be mended");
  return result;
}

void read_segments(const json& lists, bool visible, KnownAnswer& answer) {
  for (const auto& [key, list] : lists.items()) {
    for (const json& ends : list) {
      if (ends.size() != 2) fail(ends.dump() + " is not a segment [from, to]");
      KnownSegment segment{point(ends.at(0)), point(ends.at(1)), line_class(key), visible};
      if (segment.from == segment.to) fail(ends.dump() + " has no length");
      answer.segments.push_back(segment);
    }
  }
}

KnownAnswer read(const json& root, const std::filesystem::path& folder) {
  expect_keys(root, "the file", {"about", "reasoning", "view", "edges", "scene", "visible", "hidden"});
  KnownAnswer answer;
  answer.about = root.at("about").get<std::string>();
  answer.reasoning = root.at("reasoning").get<std::vector<std::string>>();
  if (answer.reasoning.empty()) fail("reasoning: is empty");
  read_view(root.at("view"), answer);
  answer.edges = root.at("edges").get<std::string>();
  std::istringstream words(answer.edges == "all" || answer.edges == "feature" ? "" : answer.edges);
  for (std::string word; std::getline(words, word, ',');) line_class(word);
  answer.scene = read_scene_of(root.at("scene"), folder);
  answer.camera.up_axis = answer.scene.up_axis;
  read_segments(root.at("visible"), true, answer);
  answer.with_hidden = root.contains("hidden");
  if (answer.with_hidden) read_segments(root.at("hidden"), false, answer);
  return answer;
}

}  // namespace

KnownAnswer read_known_answer(const std::filesystem::path& file) {
  try {
    std::ifstream stream(file, std::ios::binary);
    KnownAnswer answer = read(json::parse(stream), file.parent_path());
    answer.name = file.stem().string();
    return answer;
  } catch (const std::exception& e) {
    throw KnownAnswerError(file.string() + ": " + e.what());
  }
}

std::vector<std::filesystem::path> known_answer_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace ligne::test
