#pragma once
/// Access to the parts of a 3MF archive.

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <map>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/zip_archive.hpp"

namespace ligne {

/// A group of materials of one resource: base materials, or colours.
using ThreeMfMaterials = std::vector<Material>;

/// A model part, with its elements by their ids.
struct ThreeMfPart {
  std::string path;  ///< path in the archive
  pugi::xml_document xml;
  pugi::xml_node model;
  std::map<std::string, pugi::xml_node> objects;
  std::map<std::string, ThreeMfMaterials> materials;
};

class ThreeMfDocument {
 public:
  ThreeMfDocument(const ZipArchive& archive, const std::string& name, Warnings& warnings)
      : archive_(archive), name_(name), warnings_(warnings) {}

  /// The part that the archive's relations declare as its model.
  ThreeMfPart& root();
  /// A part by its path, read on first use. Throws InputError.
  ThreeMfPart& part(const std::string& path);

 private:
  void parse(ThreeMfPart& part);
  void read_resources(ThreeMfPart& part);

  const ZipArchive& archive_;
  const std::string& name_;
  Warnings& warnings_;
  std::map<std::string, std::unique_ptr<ThreeMfPart>> parts_;
};

/// The name of an element or attribute without its prefix.
std::string_view local_name(const char* name);
/// An attribute by its local name, with any prefix; empty if there is none.
std::string_view attribute_of(const pugi::xml_node& node, std::string_view name);
/// Twelve numbers, row by row, as a matrix for column vectors; nothing if the text is not that.
std::optional<glm::dmat4> transform_of(std::string_view text);
/// Path of the model that the archive declares; empty if it is no 3MF.
std::string model_path(const ZipArchive& archive);

}  // namespace ligne
