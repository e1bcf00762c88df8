#include "known_answer.hpp"

#include <initializer_list>
#include <nlohmann/json.hpp>

#include "scene/readers/reader.hpp"

namespace ligne::test {
namespace {

using nlohmann::json;

class AnswerReader {
 public:
  AnswerReader(const json& root, const std::string& name, const std::filesystem::path& folder)
      : root_(root), name_(name), folder_(folder) {}

  KnownAnswer read() const {
    expect_keys(root_, "the file", {"about", "reasoning", "view", "edges", "scene", "visible", "hidden"});
    KnownAnswer answer;
    answer.name = name_;
    answer.about = text(at(root_, "about"), "about");
    for (const json& line : array(at(root_, "reasoning"), "reasoning")) answer.reasoning.push_back(text(line, "reasoning"));
    if (answer.reasoning.empty()) fail("reasoning: is empty");
    read_view(at(root_, "view"), answer);
    answer.edges = text(at(root_, "edges"), "edges");
    if (answer.edges != "all" && answer.edges != "feature") check_classes(answer.edges);
    answer.scene = read_scene_of(at(root_, "scene"));
    answer.camera.up_axis = answer.scene.up_axis;
    read_segments(at(root_, "visible"), "visible", true, answer);
    answer.with_hidden = root_.contains("hidden");
    if (answer.with_hidden) read_segments(root_.at("hidden"), "hidden", false, answer);
    return answer;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw KnownAnswerError(name_ + ": " + what); }

  void expect_keys(const json& object, const std::string& what, std::initializer_list<std::string_view> known) const {
    if (!object.is_object()) fail(what + ": is not an object");
    for (const auto& [key, value] : object.items())
      if (std::find(known.begin(), known.end(), key) == known.end()) fail(what + ": unknown key '" + key + "'");
  }
  const json& at(const json& object, const char* key) const {
    const auto found = object.find(key);
    if (found == object.end()) fail(std::string("key '") + key + "' is missing");
    return *found;
  }
  const json& array(const json& value, const std::string& what) const {
    if (!value.is_array()) fail(what + ": is not an array");
    return value;
  }
  std::string text(const json& value, const std::string& what) const {
    if (!value.is_string()) fail(what + ": is not a string");
    return value.get<std::string>();
  }
  double number(const json& value, const std::string& what) const {
    if (!value.is_number()) fail(what + ": is not a number");
    return value.get<double>();
  }
  Point3 point(const json& value, const std::string& what) const {
    if (array(value, what).size() != 3) fail(what + ": is not a point [x, y, z]");
    return {number(value[0], what), number(value[1], what), number(value[2], what)};
  }

  LineClass line_class(std::string_view word) const {
    const auto found = std::find(kLineClassNames.begin(), kLineClassNames.end(), word);
    if (found == kLineClassNames.end()) fail("there is no class '" + std::string(word) + "'");
    return static_cast<LineClass>(found - kLineClassNames.begin());
  }
  void check_classes(const std::string& list) const {
    std::istringstream words(list);
    for (std::string word; std::getline(words, word, ',');) line_class(word);
  }

  void read_view(const json& view, KnownAnswer& answer) const {
    expect_keys(view, "view", {"name", "direction", "eye", "target", "fov", "up", "right", "down"});
    if (view.contains("name") + view.contains("direction") + view.contains("eye") != 1)
      fail("view: needs one of 'name', 'direction' and 'eye'");
    CameraRequest& camera = answer.camera;
    if (const auto found = view.find("name"); found != view.end()) {
      const std::string wanted = text(*found, "view.name");
      const auto known = std::find(std::begin(kNamedViews), std::end(kNamedViews), wanted);
      if (known == std::end(kNamedViews)) fail("view.name: there is no view '" + wanted + "'");
      camera.named_view = *known;
    }
    if (view.contains("direction")) camera.direction = point(view["direction"], "view.direction");
    if (view.contains("eye")) {
      camera.eye = point(view["eye"], "view.eye");
      camera.target = point(at(view, "target"), "view.target");
      camera.fov_degrees = number(at(view, "fov"), "view.fov");
    }
    if (view.contains("up")) camera.up = point(view["up"], "view.up");
    answer.right = point(at(view, "right"), "view.right");
    answer.down = point(at(view, "down"), "view.down");
  }

  Scene read_scene_of(const json& scene) const {
    Warnings warnings;
    Scene result;
    if (scene.is_string()) {
      result = read_scene(folder_ / scene.get<std::string>(), {}, warnings);
    } else {
      const std::string bytes = scene.dump();
      result = read_scene({std::as_bytes(std::span(bytes)), name_}, ModelFormat::ligne_scene, {}, warnings);
    }
    if (!warnings.counts().empty()) fail("scene: had to be mended");
    return result;
  }

  void read_segments(const json& lists, const std::string& what, bool visible, KnownAnswer& answer) const {
    if (!lists.is_object()) fail(what + ": is not an object");
    for (const auto& [key, list] : lists.items()) {
      const std::string place = what + "." + key;
      for (const json& ends : array(list, place)) {
        if (array(ends, place).size() != 2) fail(place + ": " + ends.dump() + " is not a segment [from, to]");
        KnownSegment segment{point(ends[0], place), point(ends[1], place), line_class(key), visible};
        if (segment.from == segment.to) fail(place + ": " + ends.dump() + " has no length");
        answer.segments.push_back(segment);
      }
    }
  }

  const json& root_;
  const std::string& name_;
  const std::filesystem::path& folder_;
};

}  // namespace

KnownAnswer parse_known_answer(std::string_view text, const std::string& name, const std::filesystem::path& folder) {
  json root;
  try {
    root = json::parse(text);
  } catch (const json::exception& e) {
    throw KnownAnswerError(name + ": " + e.what());
  }
  return AnswerReader(root, name, folder).read();
}

KnownAnswer read_known_answer(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw KnownAnswerError(file.string() + ": can not be read");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parse_known_answer(text, file.stem().string(), file.parent_path());
}

std::vector<std::filesystem::path> known_answer_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace ligne::test
