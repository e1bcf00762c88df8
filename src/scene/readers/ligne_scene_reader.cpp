#include "scene/readers/format_readers.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "scene/model/precision.hpp"
#include "scene/readers/json_place.hpp"
#include "scene/readers/scene_builder.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

using nlohmann::json;

/// Largest nesting depth: more than any scene, since objects[] faces[] details[] contour[] [] is nine levels.
constexpr int kDeepestNesting = 32;
/// Largest length of the library's own error text, which quotes the file.
constexpr std::size_t kLongestReason = 200;

/// Parses JSON. Refuses deep nesting and repeated keys of an object, of which the parser would silently keep the last.
json parse_json(std::string_view text, const std::string& name) {
  std::vector<std::set<std::string>> keys;  // keys of the open objects
  const auto watch = [&](int depth, json::parse_event_t event, json& value) {
    if (depth > kDeepestNesting)
      throw InputError(name, "JSON nested deeper than " + std::to_string(kDeepestNesting) + " levels");
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key && !keys.back().insert(value.get_ref<const std::string&>()).second) {
      throw InputError(name, "key " + shown(value.get_ref<const std::string&>()) + " twice in one JSON object");
    }
    return true;
  };
  try {
    return json::parse(text, watch);
  } catch (const json::parse_error& e) {
    // The library's text is "[json.exception.parse_error.101] parse error at line 1, column 2: syntax error while ...".
    // Uses the part after the column.
    const std::string_view what = e.what();
    const std::size_t column = what.find(": ");
    throw error_at_line(name, line_of_byte(text, e.byte),
                        "not valid JSON: " + printable(what.substr(column == what.npos ? 0 : column + 2), kLongestReason));
  } catch (const json::exception&) {
    throw error_at_line(name, line_of_number_out_of_range(text), "a number is out of range");
  }
}

/// A JSON value with its path, for errors.
class Node {
 public:
  Node(const json& value, std::string path, const std::string& name) : value_(value), path_(std::move(path)), name_(name) {}

  InputError error(const std::string& cause) const {
    return InputError(name_, path_.empty() ? cause : path_ + ": " + cause);
  }

  /// Throws unless this is an object with no other keys than those given.
  void expect_object(std::initializer_list<std::string_view> known) const {
    if (!value_.is_object()) throw error("is not an object");
    for (const auto& [key, unused] : value_.items()) {
      if (std::find(known.begin(), known.end(), key) == known.end()) throw error("unknown key " + shown(key));
    }
  }
  std::optional<Node> find(const char* key) const {
    const auto it = value_.find(key);
    if (it == value_.end()) return {};
    return Node(*it, path_.empty() ? key : path_ + "." + key, name_);
  }
  Node at(const char* key) const {
    std::optional<Node> node = find(key);
    if (!node) throw error(std::string("key '") + key + "' is missing");
    return *node;
  }
  std::size_t array_size() const {
    if (!value_.is_array()) throw error("is not an array");
    return value_.size();
  }
  Node operator[](std::size_t i) const { return Node(value_[i], path_ + "[" + std::to_string(i) + "]", name_); }

  /// Calls f for every item of the array `key`, which may be absent.
  template <typename F>
  void for_each(const char* key, F f) const {
    const std::optional<Node> array = find(key);
    if (!array) return;
    const std::size_t n = array->array_size();
    for (std::size_t i = 0; i < n; ++i) f((*array)[i]);
  }

  std::string text() const {
    if (!value_.is_string()) throw error("is not a string");
    return value_.get<std::string>();
  }
  double number() const {
    if (!value_.is_number()) throw error("is not a number");
    const double number = value_.get<double>();
    if (!std::isfinite(number)) throw error("is out of range");
    return number;
  }
  double number_in(double low, double high, const char* range) const {
    const double n = number();
    if (n < low || n > high) throw error(std::string("is not in ") + range);
    return n;
  }
  Point3 point() const {
    if (array_size() != 3) throw error("is not an array of three numbers");
    return {(*this)[0].number(), (*this)[1].number(), (*this)[2].number()};
  }
  /// A whole number below n; `what` names the counted item.
  std::uint32_t index_below(std::size_t n, const char* what) const {
    if (!value_.is_number_integer()) throw error("is not a whole number");
    if (!value_.is_number_unsigned() || value_.get<std::uint64_t>() >= n) {
      throw error(std::string(what) + " " + value_.dump() + " of " + std::to_string(n));
    }
    return value_.get<std::uint32_t>();
  }

 private:
  const json& value_;
  std::string path_;
  const std::string& name_;
};

class SceneReader {
 public:
  SceneReader(Node root, const std::string& name, ReadReport& report)
      : root_(std::move(root)), report_(report), builder_(name, report) {}

  Scene read() {
    root_.expect_object(
        {"format", "version", "about", "up", "materials", "objects", "lights", "facts", "separating_planes"});
    if (const std::string format = root_.at("format").text(); format != "ligne-scene") {
      throw root_.at("format").error(shown(format) + " is not 'ligne-scene'");
    }
    if (root_.at("version").number() != 1) throw root_.at("version").error("only version 1 is known");
    if (const auto about = root_.find("about")) about->text();  // for people: checked, not stored
    const Axis up = read_up();
    root_.for_each("materials", [&](const Node& node) { read_material(node); });
    root_.at("objects").array_size();
    root_.for_each("objects", [&](const Node& node) { read_object(node); });
    root_.for_each("lights", [&](const Node& node) { read_light(node); });
    root_.for_each("facts", [&](const Node& node) { read_fact(node); });
    root_.for_each("separating_planes", [&](const Node& node) { read_plane(node); });
    return builder_.finish(up, {});
  }

 private:
  Axis read_up() const {
    const std::optional<Node> node = root_.find("up");
    const std::string up = node ? node->text() : "z";
    if (up == "x") return Axis::x;
    if (up == "y") return Axis::y;
    if (up == "z") return Axis::z;
    throw node->error(shown(up) + " is not 'x', 'y' or 'z'");
  }

  void read_material(const Node& node) {
    node.expect_object({"name", "color", "opacity"});
    Material material;
    if (const auto text = node.find("name")) material.name = text->text();
    if (const auto color = node.find("color")) {
      material.color = color->point();
      for (int k = 0; k < 3; ++k) (*color)[static_cast<std::size_t>(k)].number_in(0, 1, "0 .. 1");
    }
    if (const auto opacity = node.find("opacity")) material.opacity = opacity->number_in(0, 1, "0 .. 1");
    builder_.scene().materials.push_back(std::move(material));
  }

  void read_object(const Node& node) {
    node.expect_object({"name", "vertices", "faces", "precision"});
    const auto text = node.find("name");
    builder_.begin_object(text ? text->text() : std::string());
    double largest = 0;
    vertex_count_ = node.at("vertices").array_size();
    node.for_each("vertices", [&](const Node& vertex) {
      const Point3 p = vertex.point();
      largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
      builder_.add_vertex(p);
    });
    report_.vertices += vertex_count_;
    node.at("faces").array_size();
    node.for_each("faces", [&](const Node& face) { read_face(face); });
    double precision = half_ulp_double(largest);
    if (const auto given = node.find("precision")) {
      if (given->number() < 0) throw given->error("is negative");
      precision = std::max(precision, given->number());
    }
    builder_.end_object(precision, true);
  }

  void read_face(const Node& node) {
    node.expect_object({"outer", "holes", "material", "details"});
    builder_.use_material(read_material_of(node, kNone));
    read_contour(node.at("outer"));
    const std::uint32_t face = builder_.add_face(contour_);
    node.for_each("holes", [&](const Node& hole) {
      read_contour(hole);
      builder_.add_hole(contour_);
    });
    node.for_each("details", [&](const Node& detail) { read_detail(detail, face); });
  }

  std::uint32_t read_material_of(const Node& node, std::uint32_t otherwise) const {
    const auto material = node.find("material");
    return material ? material->index_below(builder_.scene().materials.size(), "material") : otherwise;
  }

  void read_contour(const Node& node) {
    const std::size_t n = corner_count(node);
    contour_.clear();
    for (std::size_t i = 0; i < n; ++i) {
      contour_.push_back(builder_.object_vertex_begin() + node[i].index_below(vertex_count_, "vertex"));
    }
  }

  static std::size_t corner_count(const Node& contour) {
    const std::size_t n = contour.array_size();
    if (n < 3) throw contour.error("contour with " + std::to_string(n) + " corners, needs 3 or more");
    return n;
  }

  void read_detail(const Node& node, std::uint32_t face) {
    node.expect_object({"material", "contour"});
    node.at("material");
    Detail detail{face, read_material_of(node, 0), {}};
    corner_count(node.at("contour"));
    node.for_each("contour", [&](const Node& point) { detail.contour.push_back(point.point()); });
    builder_.scene().details.push_back(std::move(detail));
  }

  void read_light(const Node& node) {
    node.expect_object({"kind", "direction", "position"});
    const std::string kind = node.at("kind").text();
    if (kind != "parallel" && kind != "point") throw node.at("kind").error(shown(kind) + " is not 'parallel' or 'point'");
    const bool parallel = kind == "parallel";
    const char* const other = parallel ? "position" : "direction";
    if (const auto misplaced = node.find(other)) throw misplaced->error("does not belong to a light of kind '" + kind + "'");
    const Node vector = node.at(parallel ? "direction" : "position");
    if (parallel && vector.point() == Point3(0)) throw vector.error("is not a direction (zero length)");
    builder_.scene().lights.push_back({parallel ? Light::Kind::parallel : Light::Kind::point, vector.point()});
  }

  void read_fact(const Node& node) {
    const std::string name = node.text();
    const auto known = std::ranges::find(kStatedFactNames, name);
    if (known == kStatedFactNames.end()) throw node.error(shown(name) + " is not 'no-penetration', 'convex' or 'adjacency'");
    builder_.scene().stated.state(static_cast<StatedFact>(known - kStatedFactNames.begin()));
  }

  void read_plane(const Node& node) {
    node.expect_object({"point", "normal"});
    std::vector<SeparatingPlane>& planes = builder_.scene().stated.planes;
    if (planes.size() == kMostSeparatingPlanes)
      throw node.error("there may be " + std::to_string(planes.size()) + " planes");
    const Point3 normal = node.at("normal").point();
    const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    if (largest == 0) throw node.at("normal").error("is not a direction (zero length)");
    planes.push_back({node.at("point").point(), glm::normalize(normal / largest)});
  }

  Node root_;
  ReadReport& report_;
  SceneBuilder builder_;
  std::size_t vertex_count_ = 0;  ///< number of vertices of the object being read
  std::vector<std::uint32_t> contour_;
};

}  // namespace

Scene read_ligne_scene(const ModelReading& in) {
  const std::string& name = in.file.name;
  const json document = parse_json(as_text(in.file.bytes, name), name);
  return SceneReader(Node(document, "", name), name, in.report).read();
}

}  // namespace ligne
