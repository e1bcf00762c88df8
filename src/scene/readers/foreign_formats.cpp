#include "scene/readers/foreign_formats.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

#include "scene/readers/load_bytes.hpp"
#include "scene/readers/text_lines.hpp"

namespace ligne {
namespace {

/// Number of bytes of a text that are searched.
constexpr std::size_t kSearched = 4096;

constexpr char kWithAssimp[] = "convert it, for example with: assimp export IN OUT.glb";
constexpr char kWithBlender[] = "open it in Blender and export glTF";
constexpr char kWithFreeCad[] = "open it in FreeCAD and export STL, OBJ or glTF";
constexpr char kNoModel[] = "";
constexpr char kUnpack[] = "unpack it; a Blender file may be such an archive";

struct ForeignFormat {
  std::string_view mark, what, advice;
};

constexpr std::array kBeginnings{
    ForeignFormat{"\x89PNG", "a PNG image", kNoModel},
    ForeignFormat{"\xFF\xD8\xFF", "a JPEG image", kNoModel},
    ForeignFormat{"GIF8", "a GIF image", kNoModel},
    ForeignFormat{"II*", "a TIFF image", kNoModel},
    ForeignFormat{{"MM\0*", 4}, "a TIFF image", kNoModel},
    ForeignFormat{"%PDF", "a PDF document", kNoModel},
    ForeignFormat{"\x1F\x8B", "a gzip archive", kUnpack},
    ForeignFormat{"\x28\xB5\x2F\xFD", "a Zstandard archive", kUnpack},
    ForeignFormat{"AC3D", "an AC3D file", kWithAssimp},
    ForeignFormat{"*3DSMAX_ASCIIEXPORT", "a 3ds Max text file (ASE)", kWithAssimp},
    ForeignFormat{"7z\xBC\xAF", "a 7z archive", kNoModel},
    ForeignFormat{"Rar!", "a RAR archive", kNoModel},
    ForeignFormat{"<svg", "an SVG drawing", kNoModel},
    ForeignFormat{"Kaydara FBX Binary", "an FBX file", kWithAssimp},
    ForeignFormat{"; FBX", "an FBX file", kWithAssimp},
    ForeignFormat{"ISO-10303-21", "a STEP file", kWithFreeCad},
    ForeignFormat{"PXR-USDC", "a USD file", kWithBlender},
    ForeignFormat{"#usda", "a USD file", kWithBlender},
    ForeignFormat{"BLENDER", "a Blender file", kWithBlender},
    ForeignFormat{{"\xFF\xFE\xFF\x0ES\0k\0e\0t\0c\0h\0U\0p\0", 20},
                  "a SketchUp file",
                  "export COLLADA or glTF from SketchUp, and convert the first with assimp"},
    ForeignFormat{"AutoCAD Binary DXF", "a DXF file", kWithFreeCad},
    ForeignFormat{"AC10", "a DWG file", kWithFreeCad},
    ForeignFormat{"#VRML", "a VRML file", "open it in MeshLab and export PLY or OBJ"},
    ForeignFormat{"3D Geometry File Format", "a Rhino file", "export OBJ or STL from Rhino"},
    ForeignFormat{"# vtk DataFile", "a VTK file", "open it in ParaView and save its surface as PLY or STL"},
    ForeignFormat{"$MeshFormat", "a Gmsh mesh", "convert it with: gmsh IN -0 -o OUT.stl"},
    ForeignFormat{"MeshVersionFormatted", "a Medit mesh", "convert it with: gmsh IN -0 -o OUT.stl"},
    ForeignFormat{"# .PCD", "a point cloud (PCD)", "it has only points: reconstruct a surface, for example in MeshLab"},
    ForeignFormat{"DBRep_DrawableShape", "a BREP file of Open CASCADE", kWithFreeCad},
    ForeignFormat{{"U3D\0", 4}, "a U3D file", kWithBlender},
};

/// Root elements of XML documents, searched for at their beginning.
constexpr std::array kRoots{
    ForeignFormat{"<COLLADA", "a COLLADA file", kWithAssimp},
    ForeignFormat{"<X3D", "an X3D file", kWithAssimp},
    ForeignFormat{"<amf", "an AMF file", "open it in PrusaSlicer or FreeCAD and export 3MF or STL"},
    ForeignFormat{"<svg", "an SVG drawing", kNoModel},
};

std::string message(const ForeignFormat& format) {
  if (format.advice.empty()) return "is " + std::string(format.what) + ", not a model";
  return "is " + std::string(format.what) + ", which is not read: " + std::string(format.advice);
}

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

}  // namespace

std::optional<std::string> find_foreign_format(std::span<const std::byte> bytes) {
  std::string_view chars(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (chars.starts_with("\xEF\xBB\xBF")) chars.remove_prefix(3);
  const std::string_view head = chars.substr(0, kSearched);
  if (chars.starts_with("ISO-10303-21") && head.find("IFC") != std::string_view::npos) {
    return message({"", "an IFC file", "open it in FreeCAD or Blender (Bonsai) and export OBJ or glTF"});
  }
  for (const ForeignFormat& format : kBeginnings) {
    if (chars.starts_with(format.mark)) return message(format);
  }
  for (const ForeignFormat& format : kRoots) {
    if (chars.starts_with('<') && head.find(format.mark) != std::string_view::npos) return message(format);
  }
  if (chars.starts_with("<?xml")) return message({"", "an XML file", kNoModel});
  if (is_iges(head)) return message({"", "an IGES file", kWithFreeCad});
  if (is_dxf(head)) return message({"", "a DXF file", kWithFreeCad});
  return std::nullopt;
}

}  // namespace ligne
