// tinygltf trusts the types and indices of its JSON, and keeps images, extras and buffers that no drawing needs. So the
// file is parsed here first, the parts that a drawing needs are checked field by field, and only these are written to
// new JSON for tinygltf. Errors name the array and the index of the item.

#include "scene/readers/gltf/gltf_json.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "scene/readers/gltf/gltf_extensions.hpp"
#include "scene/readers/gltf/gltf_item.hpp"
#include "scene/readers/gltf/gltf_motion.hpp"
#include "scene/readers/gltf/gltf_textures.hpp"
#include "scene/readers/json_place.hpp"

namespace ligne {
namespace {

using nlohmann::json;

/// Largest nesting depth of a file: glTF needs about ten levels, but extras may hold anything.
constexpr int kMaxJsonDepth = 256;
/// Largest offset of a sparse accessor, which tinygltf stores as int.
constexpr std::size_t kMaxSparseOffset = std::numeric_limits<int>::max();
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

class Checker {
 public:
  Checker(const json& root, const std::string& name) : name_(name), root_(root, "glTF", name) {
    for (const auto& [key, size] : {std::pair{"scenes", &scenes_},
                                    {"nodes", &counts_.nodes},
                                    {"meshes", &meshes_},
                                    {"materials", &materials_},
                                    {"accessors", &counts_.accessors},
                                    {"bufferViews", &views_},
                                    {"buffers", &buffers_},
                                    {"skins", &counts_.skins}}) {
      const json* list = root_.array(key);
      *size = list ? list->size() : 0;
    }
  }

  CheckedGltf run(const json& root) {
    check_version();
    check_extensions();
    CheckedGltf out;
    count_extensions(root, out.left_out);
    each("buffers", "buffer ", [&](const GltfItem& item) {
      out.buffers.push_back(buffer(item));
      return json();
    });
    json text;
    text["asset"]["version"] = "2.0";
    if (const auto scene = root_.index("scene", scenes_)) text["scene"] = *scene;
    text["bufferViews"] = each("bufferViews", "bufferView ", [&](const GltfItem& item) { return view(item, out); });
    text["accessors"] = each("accessors", "accessor ", [&](const GltfItem& item) { return accessor(item); });
    text["materials"] = each("materials", "material ", [&](const GltfItem& item) { return material(item); });
    text["meshes"] = list_meshes();
    text["cameras"] = list_cameras();
    text["nodes"] = each("nodes", "node ", [&](const GltfItem& item) { return node(item); });
    text["scenes"] = each("scenes", "scene ", [&](const GltfItem& item) {
      return json{{"nodes", item.indices("nodes", counts_.nodes)}};
    });
    text["skins"] = each("skins", "skin ", [&](const GltfItem& item) { return checked_skin(item, counts_); });
    // Broken animations are no reason to refuse a model.
    try {
      text["animations"] = each("animations", "animation ", [&](const GltfItem& item) {
        return checked_animation(item, counts_, out.animation_left_out);
      });
    } catch (const InputError& error) {
      out.animation_error = error.what();
    }
    out.textures = std::move(palettes_);
    out.color_textures = std::move(textures_);
    out.text = text.dump();
    return out;
  }

 private:
  template <class Check>
  json each(const char* key, const std::string& place, Check check) const {
    json out = json::array();
    if (const json* list = root_.array(key)) {
      for (const json& value : *list) out.push_back(check(GltfItem(value, place + std::to_string(out.size()), name_)));
    }
    return out;
  }

  void check_version() const {
    const GltfItem asset = root_.required_object("asset");
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
      if (!v.is_string()) root_.fail("extensionsRequired has a value that is not a string");
      check_required_extension(v.get<std::string>(), name_);
    }
  }

  GltfBufferEntry buffer(const GltfItem& item) const {
    const json* uri = item.find("uri");
    return {item.required_whole("byteLength"), uri != nullptr, item.text("uri")};
  }

  /// Reads a range of bytes in a buffer.
  GltfRange range(const GltfItem& item, const std::vector<GltfBufferEntry>& buffers) const {
    const std::size_t buffer = item.required_index("buffer", buffers_);
    const std::size_t offset = item.whole("byteOffset").value_or(0), length = item.required_whole("byteLength");
    const std::size_t size = buffers[buffer].byte_length;
    if (offset > size || length > size - offset) {
      item.fail("bytes " + std::to_string(offset) + " + " + std::to_string(length) + " lie outside of buffer " +
                std::to_string(buffer) + " of " + std::to_string(size) + " bytes");
    }
    return {buffer, offset, length};
  }

  json view(const GltfItem& item, CheckedGltf& checked) const {
    const GltfRange bytes = range(item, checked.buffers);
    const std::size_t length = bytes.length;
    json out{{"buffer", bytes.buffer}, {"byteOffset", bytes.offset}, {"byteLength", length}};
    const auto extensions = item.object("extensions");
    const auto compressed = extensions ? extensions->object(kMeshoptExtension) : std::nullopt;
    checked.compressed.emplace_back();
    if (compressed) checked.compressed.back() = compressed_view(*compressed, checked.buffers, length);
    // Some exporters write 0, as in glTF 1.0, where elements follow each other without a gap.
    if (const auto stride = item.whole("byteStride"); stride && *stride != 0) {
      if (*stride < 4 || *stride > 252 || *stride % 4 != 0)
        item.fail("byteStride " + std::to_string(*stride) + " is not a multiple of 4 up to 252");
      out["byteStride"] = *stride;
    }
    return out;
  }

  GltfCompressed compressed_view(const GltfItem& item, const std::vector<GltfBufferEntry>& buffers,
                                 std::size_t length) const {
    GltfCompressed out{range(item, buffers), {}};
    const std::string mode = item.text("mode"), filter = item.text("filter");
    constexpr std::array<std::string_view, 3> kModes{"ATTRIBUTES", "TRIANGLES", "INDICES"};
    constexpr std::array<std::string_view, 4> kFilters{"NONE", "OCTAHEDRAL", "QUATERNION", "EXPONENTIAL"};
    const auto known_mode = std::ranges::find(kModes, mode);
    const auto known_filter = std::ranges::find(kFilters, filter.empty() ? "NONE" : filter);
    if (known_mode == kModes.end()) item.fail("mode " + shown(mode, '"') + " is not known");
    if (known_filter == kFilters.end()) item.fail("filter " + shown(filter, '"') + " is not known");
    out.view.mode = static_cast<MeshoptMode>(known_mode - kModes.begin());
    out.view.filter = static_cast<MeshoptFilter>(known_filter - kFilters.begin());
    out.view.count = item.required_whole("count");
    out.view.stride = item.required_whole("byteStride");
    if (const std::string cause = check_meshopt(out.view); !cause.empty()) item.fail(cause);
    if (length % out.view.stride != 0 || length / out.view.stride != out.view.count) {
      item.fail(std::to_string(out.view.count) + " elements of " + std::to_string(out.view.stride) + " bytes are not the " +
                std::to_string(length) + " bytes of the view");
    }
    return out;
  }

  std::size_t component_type(const GltfItem& item) const {
    const std::size_t type = item.required_whole("componentType");
    if (type < 5120 || type > 5126 || type == 5124) item.fail("componentType " + std::to_string(type) + " is not known");
    return type;
  }

  json accessor(const GltfItem& item) const {
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

  json sparse_part(const GltfItem& item, std::size_t accessor_count) const {
    const std::size_t count = item.required_whole("count");
    if (count > accessor_count) item.fail("count " + std::to_string(count) + " is more than the accessor has");
    if (count > kMaxSparseOffset) item.fail("count is too large");
    const auto part = [&](const char* key) {
      const GltfItem from = item.required_object(key);
      const std::size_t offset = from.whole("byteOffset").value_or(0);
      if (offset > kMaxSparseOffset) from.fail("byteOffset is too large");
      json out{{"bufferView", from.required_index("bufferView", views_)}, {"byteOffset", offset}};
      if (std::string_view(key) == "indices") out["componentType"] = component_type(from);
      return out;
    };
    return {{"count", count}, {"indices", part("indices")}, {"values", part("values")}};
  }

  json material(const GltfItem& item) {
    json out{{"name", item.text("name")}};
    const std::string mode = item.text("alphaMode");
    out["alphaMode"] = mode.empty() ? "OPAQUE" : mode;
    json color;
    std::optional<GltfTexture>& palette = palettes_.emplace_back();
    if (const auto pbr = item.object("pbrMetallicRoughness")) {
      color = pbr->numbers("baseColorFactor", 4);
      if (const auto texture = pbr->object("baseColorTexture")) add_texture(*texture, palette);
    }
    if (const auto extensions = item.object("extensions")) {
      if (const auto glossy = extensions->object(kGlossinessExtension)) {
        if (color.is_null()) color = glossy->numbers("diffuseFactor", 4);
        if (const auto texture = glossy->object("diffuseTexture")) add_texture(*texture, palette);
      }
      if (const auto transmission = extensions->object(kTransmissionExtension)) {
        const json* const factor = transmission->find("transmissionFactor");
        if (factor && factor->is_number()) out["extensions"][kTransmissionExtension] = {{"transmissionFactor", *factor}};
      }
    }
    if (!color.is_null()) out["pbrMetallicRoughness"]["baseColorFactor"] = color;
    return out;
  }

  /// Counts a texture. A broken texture is no reason to refuse a file.
  void add_texture(const GltfItem& texture, std::optional<GltfTexture>& palette) {
    if (!palette) palette = find_palette(root_, texture, views_);
    const json* const index = texture.find("index");
    textures_.insert(index && index->is_number_unsigned() ? index->get<std::size_t>() : 0);
  }

  json list_meshes() const {
    return each("meshes", "mesh ", [&, m = std::size_t{0}](const GltfItem& item) mutable {
      json primitives = json::array();
      if (const json* list = item.array("primitives")) {
        for (const json& value : *list) {
          primitives.push_back(primitive(
              GltfItem(value, "mesh " + std::to_string(m) + ", primitive " + std::to_string(primitives.size()), name_)));
        }
      }
      ++m;
      json out{{"name", item.text("name")}, {"primitives", std::move(primitives)}};
      json weights = item.numbers("weights");
      if (!weights.is_null()) out["weights"] = std::move(weights);
      return out;
    });
  }

  json primitive(const GltfItem& item) const {
    const GltfItem attributes = item.required_object("attributes");
    json out{{"attributes", json::object()}, {"mode", item.whole("mode").value_or(4)}};
    if (out["mode"] > 6) item.fail("mode " + out["mode"].dump() + " is not known");
    if (const auto position = attributes.index("POSITION", counts_.accessors)) out["attributes"]["POSITION"] = *position;
    // Broken normals are left out: shading is no reason to refuse a model.
    const json* normals = attributes.find("NORMAL");
    if (normals && normals->is_number_unsigned() && *normals < counts_.accessors) out["attributes"]["NORMAL"] = *normals;
    if (const auto indices = item.index("indices", counts_.accessors)) out["attributes"][kGltfIndices] = *indices;
    add_skin_attributes(attributes, counts_, out["attributes"]);
    out["targets"] = checked_targets(item, counts_);
    const auto material = item.index("material", materials_);
    if (material) out["material"] = *material;
    const std::string coordinates = material && palettes_[*material] ? palettes_[*material]->attribute() : "";
    const json* at = coordinates.empty() ? nullptr : attributes.find(coordinates.c_str());
    if (at && at->is_number_unsigned() && *at < counts_.accessors) out["attributes"][coordinates] = *at;
    const auto extensions = item.object("extensions");
    if (const auto draco = extensions ? extensions->object(kDracoExtension) : std::nullopt) {
      const std::size_t view = draco->required_index("bufferView", views_);
      const GltfItem ids = draco->required_object("attributes");
      json checked{{"POSITION", ids.required_index("POSITION", std::numeric_limits<int>::max())}};
      // Joints and weights are in the compressed mesh, or nowhere.
      const GltfCounts any{.accessors = std::numeric_limits<int>::max()};
      add_skin_attributes(ids, any, checked);
      at = coordinates.empty() ? nullptr : ids.find(coordinates.c_str());
      if (at && at->is_number_unsigned() && *at < any.accessors) checked[coordinates] = *at;
      out["extensions"][kDracoExtension] = {{"bufferView", view}, {"attributes", std::move(checked)}};
    }
    return out;
  }

  /// Lists the cameras. A broken one gets an angle of 0, since it is no reason to refuse a model.
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

  json node(const GltfItem& item) const {
    json out{{"name", item.text("name")}, {"children", item.indices("children", counts_.nodes)}};
    if (const auto mesh = item.index("mesh", meshes_)) out["mesh"] = *mesh;
    if (const auto skin = item.index("skin", counts_.skins)) out["skin"] = *skin;
    json weights = item.numbers("weights");
    if (!weights.is_null()) out["weights"] = std::move(weights);
    if (const auto extensions = item.object("extensions")) {
      if (const auto instancing = extensions->object(kInstancingExtension))
        out["extensions"][kInstancingExtension] = checked_instancing(*instancing, counts_);
      const auto visibility = extensions->object(kVisibilityExtension);
      const json* const visible = visibility ? visibility->find("visible") : nullptr;
      if (visible && *visible == false) out["extensions"][kVisibilityExtension] = {{"visible", false}};
    }
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
  GltfItem root_;
  GltfCounts counts_;
  std::size_t scenes_ = 0, meshes_ = 0, materials_ = 0, views_ = 0, buffers_ = 0;
  std::set<std::size_t> textures_;                    ///< textures of base colours
  std::vector<std::optional<GltfTexture>> palettes_;  ///< by material
};

/// Recognises glTF 1.0, which keeps its items in objects by name, and whose version may be missing.
void check_not_gltf_1(const json& root, const std::string& name) {
  if (!root.is_object()) return;
  const auto part = [&](const json& object, const char* key) {
    return object.is_object() && object.contains(key) ? object[key] : json();
  };
  const json version = part(part(root, "asset"), "version");
  const bool says_so = version.is_string() && version.get<std::string>().starts_with("1.");
  if (says_so || version == 1 || (version.is_null() && part(root, "meshes").is_object())) throw InputError(name, kGltf1);
}

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
  check_not_gltf_1(root, name);
  return Checker(root, name).run(root);
}

}  // namespace ligne
