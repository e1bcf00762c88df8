#include "scene/readers/three_mf/three_mf_document.hpp"

#include <algorithm>
#include <array>

#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

/// Elements that no drawing needs, or that are read elsewhere.
constexpr std::array<std::string_view, 9> kKnownElements{"metadata", "metadatagroup", "resources", "build",        "object",
                                                         "mesh",     "components",    "base",      "basematerials"};

int hex_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

/// Reads "#rrggbb" or "#rrggbbaa".
bool read_color(std::string_view text, Material& material) {
  if ((text.size() != 7 && text.size() != 9) || text[0] != '#') return false;
  std::array<double, 4> parts{0, 0, 0, 1};
  for (std::size_t k = 0; 2 * k + 2 < text.size(); ++k) {
    const int high = hex_of(text[2 * k + 1]), low = hex_of(text[2 * k + 2]);
    if (high < 0 || low < 0) return false;
    parts[k] = (16 * high + low) / 255.0;
  }
  material.color = {parts[0], parts[1], parts[2]};
  material.opacity = parts[3];
  return true;
}

/// Materials of a basematerials or colorgroup element.
ThreeMfMaterials materials_of(const pugi::xml_node& group) {
  ThreeMfMaterials materials;
  for (const pugi::xml_node& entry : group.children()) {
    const bool is_base = local_name(entry.name()) == "base";
    const std::string_view color = attribute_of(entry, is_base ? "displaycolor" : "color");
    Material& material = materials.emplace_back();
    material.name = is_base ? attribute_of(entry, "name") : color;
    read_color(color, material);
  }
  return materials;
}

}  // namespace

std::string_view local_name(const char* name) {
  const std::string_view whole(name);
  const std::size_t colon = whole.find(':');
  return colon == std::string_view::npos ? whole : whole.substr(colon + 1);
}

std::string_view attribute_of(const pugi::xml_node& node, std::string_view name) {
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    if (local_name(attribute.name()) == name) return attribute.value();
  }
  return {};
}

std::optional<glm::dmat4> transform_of(std::string_view text) {
  glm::dmat4 m(1);
  if (text.empty()) return m;
  // The file multiplies row vectors by its matrix, so its rows are columns here.
  for (int i = 0; i < 12; ++i) {
    const std::optional<double> value = number_in(take_word(text));
    if (!value) return std::nullopt;
    m[i / 3][i % 3] = *value;
  }
  return trimmed(text).empty() ? std::optional(m) : std::nullopt;
}

std::string model_path(const ZipArchive& archive) {
  if (const ZipEntry* const relations = archive.find("_rels/.rels")) {
    const std::vector<std::byte> bytes = archive.read(*relations);
    pugi::xml_document xml;
    if (xml.load_buffer(bytes.data(), bytes.size())) {
      for (const pugi::xml_node& relation : xml.document_element().children()) {
        if (!attribute_of(relation, "Type").ends_with("/3dmodel")) continue;
        std::string path(attribute_of(relation, "Target"));
        path.erase(0, path.find_first_not_of('/'));
        if (archive.find(path)) return path;
      }
    }
  }
  return archive.find("3D/3dmodel.model") ? "3D/3dmodel.model" : "";
}

ThreeMfPart& ThreeMfDocument::root() { return part(model_path(archive_)); }

ThreeMfPart& ThreeMfDocument::part(const std::string& path) {
  std::unique_ptr<ThreeMfPart>& known = parts_[path];
  if (known) return *known;
  const ZipEntry* const entry = archive_.find(path);
  if (!entry) throw InputError(name_, "there is no part " + shown(path));
  const std::vector<std::byte> bytes = archive_.read(*entry);
  known = std::make_unique<ThreeMfPart>();
  known->path = path;
  const pugi::xml_parse_result result = known->xml.load_buffer(bytes.data(), bytes.size());
  if (!result) {
    throw InputError(name_, "part " + shown(path) + ": broken XML at byte " + std::to_string(result.offset) + ": " +
                                result.description());
  }
  parse(*known);
  return *known;
}

void ThreeMfDocument::parse(ThreeMfPart& part) {
  part.model = part.xml.document_element();
  if (local_name(part.model.name()) != "model") throw InputError(name_, "part " + shown(part.path) + " is not a model");
  for (const pugi::xml_node& child : part.model.children()) {
    const std::string_view kind = local_name(child.name());
    if (std::ranges::find(kKnownElements, kind) == kKnownElements.end())
      warnings_.leave_out("elements " + std::string(child.name()));
  }
  read_resources(part);
}

void ThreeMfDocument::read_resources(ThreeMfPart& part) {
  for (const pugi::xml_node& resources : part.model.children()) {
    if (local_name(resources.name()) != "resources") continue;
    for (const pugi::xml_node& child : resources.children()) {
      const std::string_view kind = local_name(child.name());
      const std::string id(attribute_of(child, "id"));
      if (kind == "object") {
        if (!part.objects.emplace(id, child).second) throw InputError(name_, "object " + shown(id) + " is given twice");
      } else if (kind == "basematerials" || kind == "colorgroup") {
        part.materials[id] = materials_of(child);
      } else if (kind == "texture2d") {
        warnings_.leave_out("textures");
      } else if (child.type() == pugi::node_element) {
        warnings_.leave_out("elements " + std::string(child.name()));
      }
    }
  }
}

}  // namespace ligne
