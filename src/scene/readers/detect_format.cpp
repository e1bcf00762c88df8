// Formats are recognised in this order: files with a magic number (GLB, PLY, JSON, images and archives); binary STL,
// whose size must match its count; text by its first lines; and last the suffix.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "files/input_file.hpp"
#include "scene/readers/format_readers.hpp"
#include "scene/readers/reader.hpp"
#include "scene/readers/text_lines.hpp"
#include "scene/readers/zip_archive.hpp"

namespace ligne {
namespace {

/// Number of bytes of a text that are searched for marks of formats that are not read.
constexpr std::size_t kSearched = 4096;

constexpr char kWithAssimp[] = "convert it, for example with: assimp export IN OUT.glb";
constexpr char kWithBlender[] = "open it in Blender and export glTF";
constexpr char kWithFreeCad[] = "open it in FreeCAD and export STL, OBJ or glTF";
constexpr char kNoModel[] = "";
constexpr char kUnpack[] = "unpack it; a Blender file may be such an archive";

constexpr ForeignFormat kBeginnings[] = {
    {"\x89PNG", "a PNG image", kNoModel},
    {"\xFF\xD8\xFF", "a JPEG image", kNoModel},
    {"GIF8", "a GIF image", kNoModel},
    {"II*", "a TIFF image", kNoModel},
    {{"MM\0*", 4}, "a TIFF image", kNoModel},
    {"%PDF", "a PDF document", kNoModel},
    {"\x1F\x8B", "a gzip archive", kUnpack},
    {"\x28\xB5\x2F\xFD", "a Zstandard archive", kUnpack},
    {"AC3D", "an AC3D file", kWithAssimp},
    {"*3DSMAX_ASCIIEXPORT", "a 3ds Max text file (ASE)", kWithAssimp},
    {"7z\xBC\xAF", "a 7z archive", kNoModel},
    {"Rar!", "a RAR archive", kNoModel},
    {"<svg", "an SVG drawing", kNoModel},
    {"Kaydara FBX Binary", "an FBX file", kWithAssimp},
    {"; FBX", "an FBX file", kWithAssimp},
    {"ISO-10303-21", "a STEP file", kWithFreeCad},
    {"PXR-USDC", "a USD file", kWithBlender},
    {"#usda", "a USD file", kWithBlender},
    {"BLENDER", "a Blender file", kWithBlender},
    {{"\xFF\xFE\xFF\x0ES\0k\0e\0t\0c\0h\0U\0p\0", 20},
     "a SketchUp file",
     "export COLLADA or glTF from SketchUp, and convert the first with assimp"},
    {"AutoCAD Binary DXF", "a DXF file", kWithFreeCad},
    {"AC10", "a DWG file", kWithFreeCad},
    {"#VRML", "a VRML file", "open it in MeshLab and export PLY or OBJ"},
    {"3D Geometry File Format", "a Rhino file", "export OBJ or STL from Rhino"},
    {"# vtk DataFile", "a VTK file", "open it in ParaView and save its surface as PLY or STL"},
    {"$MeshFormat", "a Gmsh mesh", "convert it with: gmsh IN -0 -o OUT.stl"},
    {"MeshVersionFormatted", "a Medit mesh", "convert it with: gmsh IN -0 -o OUT.stl"},
    {"# .PCD", "a point cloud (PCD)", "it has only points: pcl_pcd2ply IN OUT.ply, then ligne surface --grid OUT.ply"},
    {"DBRep_DrawableShape", "a BREP file of Open CASCADE", kWithFreeCad},
    {{"U3D\0", 4}, "a U3D file", kWithBlender},
};

/// Root elements of XML documents, searched for at their beginning.
constexpr ForeignFormat kRoots[] = {
    {"<COLLADA", "a COLLADA file", kWithAssimp},
    {"<X3D", "an X3D file", kWithAssimp},
    {"<amf", "an AMF file", "open it in PrusaSlicer or FreeCAD and export 3MF or STL"},
    {"<svg", "an SVG drawing", kNoModel},
};

/// Whether the text has lines of 80 characters whose 73rd names the section, S in the first line.
bool is_iges(std::string_view text) {
  constexpr std::size_t kSection = 72;
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  return line.size() == kSection + 8 && line[kSection] == 'S' && trimmed(line.substr(kSection + 1)) == "1";
}

/// Whether the text is pairs of lines, a code and a value, beginning with 0 and SECTION or 999 and a comment.
bool is_dxf(std::string_view text) {
  LineReader lines(text);
  std::string_view code, value;
  if (!lines.next(code) || !lines.next(value)) return false;
  return (trimmed(code) == "0" && trimmed(value) == "SECTION") ||
         (trimmed(code) == "999" && text.find("SECTION") != std::string_view::npos);
}

/// A message for a file that is known by its first bytes but not read: its kind, and how to convert it. Nothing for
/// unknown files.
std::optional<std::string> find_foreign_format(std::span<const std::byte> bytes) {
  std::string_view chars = as_characters(bytes);
  if (chars.starts_with("\xEF\xBB\xBF")) chars.remove_prefix(3);
  const std::string_view head = chars.substr(0, kSearched);
  if (chars.starts_with("ISO-10303-21") && head.find("IFC") != std::string_view::npos) {
    return message({"", "an IFC file", "open it in FreeCAD or Blender (Bonsai) and export OBJ or glTF"});
  }
  if (auto found = foreign_format(chars, kBeginnings)) return found;
  for (const ForeignFormat& format : kRoots) {
    if (chars.starts_with('<') && head.find(format.mark) != std::string_view::npos) return message(format);
  }
  if (chars.starts_with("<?xml")) return message({"", "an XML file", kNoModel});
  if (is_iges(head)) return message({"", "an IGES file", kWithFreeCad});
  if (is_dxf(head)) return message({"", "a DXF file", kWithFreeCad});
  return std::nullopt;
}

/// Number of bytes of a text that are examined: enough to get past long comments at the head.
constexpr std::size_t kDetectionBytes = 65536;

/// The format of a ZIP archive. Throws InputError if it is not a model.
ModelFormat zip_format(std::span<const std::byte> bytes, const std::string& name) {
  const ZipArchive archive(bytes, name);
  if (is_three_mf(archive)) return ModelFormat::three_mf;
  for (const ZipEntry& entry : archive.entries()) {
    const std::string inside = lower_case(entry.name);
    if (inside.ends_with(".usdc") || inside.ends_with(".usda") || inside.ends_with(".usd"))
      throw InputError(name, "is a USD file, which is not read: open it in Blender and export glTF");
    if (inside.ends_with(".amf"))
      throw InputError(name, "is an AMF file, which is not read: open it in PrusaSlicer or FreeCAD and export 3MF or STL");
    if (inside.ends_with(".dae"))
      throw InputError(name,
                       "is an archive with a COLLADA file, which is not read: unpack it and convert that, for example "
                       "with: assimp export IN OUT.glb");
    if (inside.ends_with(".3dxml") || inside.ends_with(".3drep"))
      throw InputError(name, "is a 3DXML file, which is not read: export STL or STEP from CATIA or SolidWorks");
  }
  throw InputError(name, "is a ZIP archive, not a model");
}

/// The text from the first character that is neither white space nor part of a byte order mark.
std::string_view without_leading_space(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t begin = text.find_first_not_of(" \t\v\f\r\n");
  return begin == std::string_view::npos ? std::string_view{} : text.substr(begin);
}

/// Whether the outermost JSON object has the key.
bool has_top_level_key(std::string_view json, std::string_view key) {
  int depth = 0;
  std::size_t string_begin = 0;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '{' || c == '[') ++depth;
    if (c == '}' || c == ']') --depth;
    if (c != '"') continue;
    string_begin = i + 1;
    for (++i; i < json.size() && json[i] != '"'; ++i) i += json[i] == '\\';
    if (depth != 1 || i >= json.size() || json.substr(string_begin, i - string_begin) != key) continue;
    if (without_leading_space(json.substr(i + 1)).starts_with(':')) return true;
  }
  return false;
}

bool is_esri_grid(std::string_view text) {
  std::string_view rest = text.substr(0, text.find_first_of("\r\n"));
  const std::string_view word = take_word(rest);
  return (equal_ignoring_case(word, "ncols") || equal_ignoring_case(word, "nrows")) && parse_integer(take_word(rest));
}

/// Whether the text is "OFF BINARY", a line of text before binary numbers.
bool begins_binary_off(std::string_view text) {
  std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  return is_off_word(take_word(line)) && starts_with_ignoring_case(trimmed(line), "BINARY");
}

/// Whether the text begins with at least three numbers: points, or heights.
bool begins_with_numbers(std::string_view text) {
  std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  for (int k = 0; k < 3; ++k) {
    if (!number_in(take_word(line))) return false;
  }
  return true;
}

/// Whether a statement exists only in OBJ: "v 1 2 3", "f 1/1 2/2 3/3", or mtllib.
bool is_obj_statement(std::string_view line) {
  const std::string_view keyword = take_word(line);
  if (keyword == "mtllib") return true;
  if (keyword != "v" && keyword != "f") return false;
  for (int k = 0; k < 3; ++k) {
    const std::string_view word = take_word(line);
    if (!number_in(keyword == "v" ? word : word.substr(0, word.find('/')))) return false;
  }
  return true;
}

std::optional<ModelFormat> text_format(std::string_view text) {
  const std::string_view head = text.substr(0, kDetectionBytes);
  std::string_view first_line = head.substr(0, head.find_first_of("\r\n"));
  if (is_off_word(take_word(first_line))) return ModelFormat::off;
  if (starts_with_ignoring_case(head, "solid") && head.find_first_of(" \t\r\n", 5) == 5) return ModelFormat::stl_ascii;
  LineReader lines(head);
  for (std::string_view line; lines.next(line);) {
    line = trimmed(line);
    if (starts_with_ignoring_case(line, "Named object:") || starts_with_ignoring_case(line, "Ambient light color:")) {
      return ModelFormat::asc_3d_studio;
    }
    if (is_obj_statement(line)) return ModelFormat::obj;
  }
  return {};
}

}  // namespace

std::optional<std::string> foreign_format(std::string_view chars, std::span<const ForeignFormat> formats) {
  for (const ForeignFormat& format : formats) {
    if (chars.starts_with(format.mark)) return message(format);
  }
  return {};
}

std::string message(const ForeignFormat& format) {
  if (format.advice.empty()) return "is " + std::string(format.what) + ", not a model";
  return "is " + std::string(format.what) + ", which is not read: " + std::string(format.advice);
}

std::string_view to_string(ModelFormat format) {
  constexpr std::string_view kNames[] = {"glTF",        "glTF binary",     "OBJ",       "STL", "STL binary",
                                         "PLY",         "3D Studio ASCII", "3D Studio", "OFF", "3MF",
                                         "ligne scene", "compiled model"};
  return kNames[static_cast<std::size_t>(format)];
}

ModelFormat detect_format(std::span<const std::byte> bytes, std::string_view suffix, const std::string& name) {
  const std::string_view chars = as_characters(bytes);
  if (chars.empty()) throw InputError(name, "is empty");
  if (chars.starts_with("glTF")) return ModelFormat::glb;
  if (chars.starts_with("PK\x03\x04")) return zip_format(bytes, name);
  if (is_3ds(bytes)) return ModelFormat::three_ds;
  if (const auto format = find_foreign_format(bytes)) throw InputError(name, *format);
  const std::string_view text = without_leading_space(chars);
  if (text.starts_with("ply\n") || text.starts_with("ply\r")) return ModelFormat::ply;
  if (is_binary_stl(bytes) && stl_triangle_count(bytes) > 0) return ModelFormat::stl_binary;
  if (chars.starts_with("\xFF\xFE") || chars.starts_with("\xFE\xFF"))
    throw InputError(name, "is UTF-16 text; UTF-8 is needed");

  if (begins_binary_off(text))
    throw InputError(name, "is a binary OFF file, which is not read: convert it to text, or to PLY");
  const bool is_binary = chars.substr(0, kDetectionBytes).find('\0') != std::string_view::npos;
  if (!is_binary) {
    if (text.empty()) throw InputError(name, "contains only white space");
    if (text[0] == '{') {
      const bool own = has_top_level_key(text, "format") && !has_top_level_key(text, "asset");
      return own ? ModelFormat::ligne_scene : ModelFormat::gltf;
    }
    if (is_esri_grid(text)) throw InputError(name, "is an ESRI ASCII grid; draw it with: ligne surface --grid");
    if (const auto format = text_format(text)) return *format;
  }
  if (equal_ignoring_case(suffix, ".stl")) return is_binary ? ModelFormat::stl_binary : ModelFormat::stl_ascii;
  if (!is_binary && equal_ignoring_case(suffix, ".off")) return ModelFormat::off;
  if (!is_binary && equal_ignoring_case(suffix, ".obj")) return ModelFormat::obj;
  if (!is_binary && equal_ignoring_case(suffix, ".gltf")) return ModelFormat::gltf;
  if (!is_binary && begins_with_numbers(text))
    throw InputError(name, "is a table of numbers, not a model; to draw it as heights: ligne surface --grid");
  throw InputError(name, "is not a known model format (glTF, OBJ, STL, PLY, OFF, 3MF, 3D Studio, ligne scene)");
}

}  // namespace ligne
