// tinygltf trusts the types and indices of the JSON that it is given, and keeps images, extras and buffers that no drawing
// needs. So the file is parsed here first, what a drawing needs of it is checked field by field, and only that, written
// anew, goes to tinygltf. An error names the array and the index of the thing that is wrong.

#include "scene/readers/gltf_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>

#include "scene/model/diagnostics.hpp"
#include "scene/readers/gltf_extensions.hpp"
#include "scene/readers/json_place.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

using nlohmann::json;

/// Deepest nesting of a file: a glTF needs about ten levels, but its extras may hold anything.
constexpr int kMaxJsonDepth = 256;
/// tinygltf keeps offsets of sparse accessors as int.
constexpr std::size_t kMaxSparseOffset = std::numeric_limits<int>::max();
/// Beyond it a double does not hold every whole number.
constexpr double kMaxWhole = 9007199254740992.0;

void check_depth(std::string_view text, const std::string& name) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') {
        ++i;
      } else if (c == '"') {
        in_string = false;
      }
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kMaxJsonDepth) {
        throw InputError(
            name, "JSON: nested deeper than " + std::to_string(kMaxJsonDepth) + " levels at byte " + std::to_string(i));
      }
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
}

/// One object of the file and what it is called in errors.
class Item {
 public:
  Item(const json& value, std::string place, const std::string& name)
      : value_(value), place_(std::move(place)), name_(name) {
    if (!value_.is_object()) fail("is not a JSON object");
  }

  [[noreturn]] void fail(const std::string& cause) const { throw InputError(name_, place_ + ": " + cause); }

  const json* find(const char* key) const {
    const auto it = value_.find(key);
    return it == value_.end() ? nullptr : &*it;
  }
  std::optional<Item> object(const char* key) const {
    const json* v = find(key);
    if (!v) return std::nullopt;
    return Item(*v, place_ + ", " + key, name_);
  }
  Item required_object(const char* key) const {
    std::optional<Item> item = object(key);
    if (!item) fail(std::string(key) + " is missing");
    return *item;
  }
  const json* array(const char* key) const {
    const json* v = find(key);
    if (v && !v->is_array()) fail(std::string(key) + " is not an array");
    return v;
  }
  std::string text(const char* key) const {
    const json* v = find(key);
    if (!v) return {};
    if (!v->is_string()) fail(std::string(key) + " is not a string");
    return v->get<std::string>();
  }
  std::optional<std::size_t> whole(const char* key) const {
    const json* v = find(key);
    if (!v) return std::nullopt;
    return whole(*v, key);
  }
  std::size_t required_whole(const char* key) const {
    const std::optional<std::size_t> v = whole(key);
    if (!v) fail(std::string(key) + " is missing");
    return *v;
  }
  /// An index into an array of `size` things.
  std::optional<std::size_t> index(const char* key, std::size_t size) const {
    const std::optional<std::size_t> v = whole(key);
    if (v) check_index(*v, key, size);
    return v;
  }
  std::size_t required_index(const char* key, std::size_t size) const {
    const std::size_t v = required_whole(key);
    check_index(v, key, size);
    return v;
  }
  json indices(const char* key, std::size_t size) const {
    json out = json::array();
    if (const json* list = array(key)) {
      for (const json& v : *list) {
        const std::size_t i = whole(v, key);
        check_index(i, key, size);
        out.push_back(i);
      }
    }
    return out;
  }
  /// `size` numbers, or nothing when the key is absent.
  json numbers(const char* key, std::size_t size) const {
    const json* list = array(key);
    if (!list) return nullptr;
    if (list->size() != size) fail(std::string(key) + " does not have " + std::to_string(size) + " numbers");
    if (!std::all_of(list->begin(), list->end(), [](const json& v) { return v.is_number(); })) {
      fail(std::string(key) + " holds something that is not a number");
    }
    return *list;
  }

 private:
  std::size_t whole(const json& v, const char* key) const {
    if (v.is_number_unsigned()) return v.get<std::size_t>();
    // Some exporters write 3.0.
    if (v.is_number_float() && v.get<double>() >= 0 && v.get<double>() <= kMaxWhole &&
        std::floor(v.get<double>()) == v.get<double>()) {
      return static_cast<std::size_t>(v.get<double>());
    }
    fail(std::string(key) + " is not a whole number from 0 on");
  }
  void check_index(std::size_t v, const char* key, std::size_t size) const {
    if (v >= size) fail(std::string(key) + " names number " + std::to_string(v) + " of " + std::to_string(size));
  }

  const json& value_;
  std::string place_;
  const std::string& name_;
};

class Checker {
 public:
  Checker(const json& root, const std::string& name) : name_(name), root_(root, "glTF", name) {
    for (const auto& [key, size] : {std::pair{"scenes", &scenes_},
                                    {"nodes", &nodes_},
                                    {"meshes", &meshes_},
                                    {"materials", &materials_},
                                    {"accessors", &accessors_},
                                    {"bufferViews", &views_},
                                    {"buffers", &buffers_}}) {
      const json* list = root_.array(key);
      *size = list ? list->size() : 0;
    }
  }

  CheckedGltf run() {
    check_version();
    check_extensions();
    CheckedGltf out;
    each("buffers", "buffer ", [&](const Item& item) {
      out.buffers.push_back(buffer(item));
      return json();
    });
    json text;
    text["asset"]["version"] = "2.0";
    if (const auto scene = root_.index("scene", scenes_)) text["scene"] = *scene;
    text["bufferViews"] = each("bufferViews", "bufferView ", [&](const Item& item) { return view(item, out.buffers); });
    text["accessors"] = each("accessors", "accessor ", [&](const Item& item) { return accessor(item); });
    text["materials"] = each("materials", "material ", [&](const Item& item) { return material(item); });
    text["meshes"] = list_meshes();
    text["cameras"] = list_cameras();
    text["nodes"] = each("nodes", "node ", [&](const Item& item) { return node(item); });
    text["scenes"] = each("scenes", "scene ", [&](const Item& item) {
      return json{{"nodes", item.indices("nodes", nodes_)}};
    });
    out.text = text.dump();
    return out;
  }

 private:
  template <class Check>
  json each(const char* key, const std::string& place, Check check) const {
    json out = json::array();
    if (const json* list = root_.array(key)) {
      for (const json& value : *list) out.push_back(check(Item(value, place + std::to_string(out.size()), name_)));
    }
    return out;
  }

  void check_version() const {
    const Item asset = root_.required_object("asset");
    for (const char* key : {"version", "minVersion"}) {
      const std::string version = asset.text(key);
      if (version.empty() && std::string_view(key) == "minVersion") continue;
      if (!version.starts_with("2.")) asset.fail(std::string(key) + " " + shown(version, '"') + " is not glTF 2");
    }
  }

  void check_extensions() const {
    const json* list = root_.array("extensionsRequired");
    if (!list) return;
    for (const json& v : *list) {
      if (!v.is_string()) root_.fail("extensionsRequired holds something that is not a string");
      check_required_extension(v.get<std::string>(), name_);
    }
  }

  GltfBufferEntry buffer(const Item& item) const {
    const json* uri = item.find("uri");
    return {item.required_whole("byteLength"), uri != nullptr, item.text("uri")};
  }

  json view(const Item& item, const std::vector<GltfBufferEntry>& buffers) const {
    const std::size_t buffer = item.required_index("buffer", buffers_);
    const std::size_t offset = item.whole("byteOffset").value_or(0), length = item.required_whole("byteLength");
    const std::size_t size = buffers[buffer].byte_length;
    if (offset > size || length > size - offset) {
      item.fail("bytes " + std::to_string(offset) + " + " + std::to_string(length) + " lie outside of buffer " +
                std::to_string(buffer) + " of " + std::to_string(size) + " bytes");
    }
    json out{{"buffer", buffer}, {"byteOffset", offset}, {"byteLength", length}};
    if (const auto stride = item.whole("byteStride")) {
      if (*stride < 4 || *stride > 252 || *stride % 4 != 0)
        item.fail("byteStride " + std::to_string(*stride) + " is not a multiple of 4 up to 252");
      out["byteStride"] = *stride;
    }
    return out;
  }

  std::size_t component_type(const Item& item) const {
    const std::size_t type = item.required_whole("componentType");
    if (type < 5120 || type > 5126 || type == 5124) item.fail("componentType " + std::to_string(type) + " is not known");
    return type;
  }

  json accessor(const Item& item) const {
    json out{{"componentType", component_type(item)}, {"count", item.required_whole("count")}, {"type", item.text("type")}};
    constexpr std::array kTypes{"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
    if (std::find(kTypes.begin(), kTypes.end(), out["type"]) == kTypes.end()) {
      item.fail("type " + shown(item.text("type"), '"') + " is not known");
    }
    if (const auto view = item.index("bufferView", views_)) out["bufferView"] = *view;
    out["byteOffset"] = item.whole("byteOffset").value_or(0);
    if (const json* normalized = item.find("normalized")) {
      if (!normalized->is_boolean()) item.fail("normalized is neither true nor false");
      out["normalized"] = *normalized;
    }
    if (const auto sparse = item.object("sparse")) out["sparse"] = sparse_part(*sparse, out["count"]);
    return out;
  }

  json sparse_part(const Item& item, std::size_t accessor_count) const {
    const std::size_t count = item.required_whole("count");
    if (count > accessor_count) item.fail("count " + std::to_string(count) + " is more than the accessor has");
    if (count > kMaxSparseOffset) item.fail("count is too large");
    const auto part = [&](const char* key) {
      const Item from = item.required_object(key);
      const std::size_t offset = from.whole("byteOffset").value_or(0);
      if (offset > kMaxSparseOffset) from.fail("byteOffset is too large");
      json out{{"bufferView", from.required_index("bufferView", views_)}, {"byteOffset", offset}};
      if (std::string_view(key) == "indices") out["componentType"] = component_type(from);
      return out;
    };
    return {{"count", count}, {"indices", part("indices")}, {"values", part("values")}};
  }

  json material(const Item& item) const {
    json out{{"name", item.text("name")}};
    const std::string mode = item.text("alphaMode");
    out["alphaMode"] = mode.empty() ? "OPAQUE" : mode;
    if (const auto pbr = item.object("pbrMetallicRoughness")) {
      const json color = pbr->numbers("baseColorFactor", 4);
      if (!color.is_null()) out["pbrMetallicRoughness"]["baseColorFactor"] = color;
    }
    return out;
  }

  json list_meshes() const {
    return each("meshes", "mesh ", [&, m = std::size_t{0}](const Item& item) mutable {
      json primitives = json::array();
      if (const json* list = item.array("primitives")) {
        for (const json& value : *list) {
          primitives.push_back(primitive(
              Item(value, "mesh " + std::to_string(m) + ", primitive " + std::to_string(primitives.size()), name_)));
        }
      }
      ++m;
      return json{{"name", item.text("name")}, {"primitives", std::move(primitives)}};
    });
  }

  json primitive(const Item& item) const {
    const Item attributes = item.required_object("attributes");
    json out{{"attributes", json::object()}, {"mode", item.whole("mode").value_or(4)}};
    if (out["mode"] > 6) item.fail("mode " + out["mode"].dump() + " is not known");
    if (const auto position = attributes.index("POSITION", accessors_)) out["attributes"]["POSITION"] = *position;
    // How a surface is shaded is no reason to refuse it: normals that are broken are left out.
    const json* normals = attributes.find("NORMAL");
    if (normals && normals->is_number_unsigned() && *normals < accessors_) out["attributes"]["NORMAL"] = *normals;
    if (const auto indices = item.index("indices", accessors_)) out["attributes"][kGltfIndices] = *indices;
    if (const auto material = item.index("material", materials_)) out["material"] = *material;
    const auto extensions = item.object("extensions");
    if (const auto draco = extensions ? extensions->object(kDracoExtension) : std::nullopt) {
      const std::size_t view = draco->required_index("bufferView", views_);
      const std::size_t id =
          draco->required_object("attributes").required_index("POSITION", std::numeric_limits<int>::max());
      out["extensions"][kDracoExtension] = {{"bufferView", view}, {"attributes", {{"POSITION", id}}}};
    }
    return out;
  }

  /// One that is broken has an angle of 0: how a model could be looked at is no reason to refuse it.
  json list_cameras() const {
    json out = json::array();
    const json* const list = root_.find("cameras");
    if (!list || !list->is_array()) return out;
    const auto number = [](const json& object, const char* key) {
      const auto found = object.is_object() ? object.find(key) : object.end();
      return found != object.end() && found->is_number() ? found->get<double>() : 0.0;
    };
    for (const json& camera : *list) {
      const auto part = [&](const char* key) { return camera.is_object() && camera.contains(key) ? camera[key] : json(); };
      const json name = part("name"), perspective = part("perspective");
      json to{{"name", name.is_string() ? name : json("")}};
      if (part("type") == "orthographic") {
        to["type"] = "orthographic";
        to["orthographic"] = {{"xmag", 1}, {"ymag", 1}, {"znear", 0}, {"zfar", 1}};
      } else {
        to["type"] = "perspective";
        to["perspective"] = {{"yfov", number(perspective, "yfov")}, {"znear", 1}};
        if (const double aspect = number(perspective, "aspectRatio"); aspect > 0) to["perspective"]["aspectRatio"] = aspect;
      }
      out.push_back(std::move(to));
    }
    return out;
  }

  json node(const Item& item) const {
    json out{{"name", item.text("name")}, {"children", item.indices("children", nodes_)}};
    if (const auto mesh = item.index("mesh", meshes_)) out["mesh"] = *mesh;
    if (item.find("skin")) out["skin"] = 0;
    const json* const camera = item.find("camera");
    const json* const cameras = root_.find("cameras");
    const std::size_t count = cameras && cameras->is_array() ? cameras->size() : 0;
    if (camera && camera->is_number_unsigned() && camera->get<std::size_t>() < count) out["camera"] = *camera;
    for (const auto& [key, size] : {std::pair{"matrix", 16}, {"rotation", 4}, {"scale", 3}, {"translation", 3}}) {
      json numbers = item.numbers(key, static_cast<std::size_t>(size));
      if (!numbers.is_null()) out[key] = std::move(numbers);
    }
    return out;
  }

  const std::string& name_;
  Item root_;
  std::size_t scenes_ = 0, nodes_ = 0, meshes_ = 0, materials_ = 0, accessors_ = 0, views_ = 0, buffers_ = 0;
};

}  // namespace

CheckedGltf check_gltf(std::string_view text, const std::string& name) {
  check_depth(text, name);
  json root;
  try {
    root = json::parse(text);
  } catch (const json::parse_error& error) {
    throw InputError(name + ":" + std::to_string(line_of_byte(text, error.byte)),
                     "JSON: broken at byte " + std::to_string(error.byte));
  } catch (const json::exception&) {
    throw InputError(name + ":" + std::to_string(line_of_number_out_of_range(text)), "JSON: a number is too large");
  }
  return Checker(root, name).run();
}

}  // namespace ligne
