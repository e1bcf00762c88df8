#pragma once
/// The readers of all formats of models. Their scenes are not cleaned yet. They throw InputError, with the line of a text.

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "scene/creases/file_shading.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/read_report.hpp"
#include "scene/subdivision/crease_tags.hpp"

namespace ligne {

class ZipArchive;

/// A kind of file that is known by its first bytes but not read, and how to convert it; without advice: no model.
struct ForeignFormat {
  std::string_view mark, what, advice;
};
/// "is a STEP file, which is not read: open it in FreeCAD ..."
std::string message(const ForeignFormat& format);
/// The message for the format with whose mark a file begins; nothing if there is none.
std::optional<std::string> foreign_format(std::string_view chars, std::span<const ForeignFormat> formats);

/// A model file that is being read, and the receivers of what it holds beside the scene.
struct ModelReading {
  ModelBytes file;
  ReadReport& report;
  Warnings& warnings;
  FileShading* shading = nullptr;   ///< normals and smoothing groups; null: not wanted
  CreaseTags* tags = nullptr;       ///< OBJ: tags of subdivision; null: not wanted
  bool groups_as_objects = false;   ///< OBJ: see read_obj()
  std::optional<ScenePose> pose{};  ///< glTF: a moment of an animation
};

/// Number of triangles in the header of a binary STL file; 0 if it is too short for a header.
std::size_t stl_triangle_count(std::span<const std::byte> bytes);
/// Whether the size is that of a binary STL file with the number of triangles in its header, which may begin with
/// "solid".
bool is_binary_stl(std::span<const std::byte> bytes);

/// Reads STL text: one object per `solid`, three separate vertices per facet. Normals are ignored. z up.
Scene read_stl_ascii(const ModelReading& in);

/// Reads binary STL as one object. Bytes behind the triangles are left out; a number of 0 or 0xFFFFFFFF stands for as many
/// as the file holds. Throws InputError if the file is shorter than its number of triangles says, or if the number does not
/// fit and the coordinates show that the bytes are no triangles.
Scene read_stl_binary(const ModelReading& in);

/// Whether a text begins with the format's word: OFF, or one with letters for the properties of vertices, such as COFF.
bool is_off_word(std::string_view word);

/// Reads OFF text: polygons, and their colours as materials. Normals, colours and texture coordinates of vertices are
/// skipped. z up. Throws InputError with the line, and for binary files and other dimensions.
Scene read_off(const ModelReading& in);

/// Reads a JSON scene of `"format": "ligne-scene", "version": 1`. Unknown keys are errors. Throws
/// InputError with the place: "objects[2].faces[5].outer[1]: vertex 99 of 8".
Scene read_ligne_scene(const ModelReading& in);

/// Reads the elements `vertex` (x, y, z of any type) and `face` (list vertex_indices or vertex_index) as one object.
/// Faces may have any number of corners; other elements and properties are skipped. z up. Points without faces are the
/// vertices of a scene without objects. Throws InputError, with the line for text. Normals are nx, ny, nz.
Scene read_ply(const ModelReading& in);

/// Reads the polygons of an OBJ file: faces of any number of corners, relative indices, continued lines. Each `o`
/// begins an object; a file without `o` is one object. Groups begin objects only if `groups_as_objects` is set and the
/// file has no `o`, since their faces share vertices. The names given by usemtl become materials, with the properties
/// that the material libraries in the file's folder define for them (obj_materials.hpp). Bezier and B-spline patches
/// become triangles. y up. Throws InputError with the line.
Scene read_obj(const ModelReading& in);

/// Reads a glTF 2.0 file (`binary`: GLB). Every node with a mesh in the default scene (below all root nodes if the file
/// has no scene) becomes one object, in world coordinates, y up. Morph targets have their
/// default weights and skins their bind pose, unless `pose` gives a moment of an animation. Omissions are counted by
/// name. Of the images only palettes are read (palette_texture.hpp). Throws InputError. Source: Khronos glTF 2.0
/// specification (ISO/IEC 12113:2022), KHR_mesh_quantization, KHR_draco_mesh_compression, EXT_meshopt_compression,
/// EXT_mesh_gpu_instancing, KHR_node_visibility.
Scene read_gltf(const ModelReading& in, bool binary);

/// Reads the tri-meshes, material names and lights of a 3D Studio ASCII file (`Named object:`, `Tri-mesh, Vertices: n
/// Faces: m`). An edge flag AB, BC or CA of 0 marks the edge as kCornerFileHidden. Cameras and page headings are left
/// out. z up.
Scene read_asc(const ModelReading& in);

/// Whether the file has 3D Studio's binary chunks: the first one, 0x4d4d, has the length of the file, or some bytes less.
bool is_3ds(std::span<const std::byte> bytes);

/// Reads the meshes, materials, lights and cameras of a binary 3D Studio file. An edge that is marked as not visible is
/// kCornerFileHidden, unless no edge of its mesh is visible. Meshes lie where they are stored; one that the keyframes
/// place several times, as instances, is placed as in the first frame. z up. Throws InputError with the byte.
Scene read_3ds(const ModelReading& in);

/// Whether an archive holds a 3MF model.
bool is_three_mf(const ZipArchive& archive);

/// Reads the build of a 3MF file: meshes and components with their transforms, including other parts of the archive
/// (production extension); base materials and colour groups as materials. Supports, textures and unknown elements are
/// left out and counted. z up, with the unit of the file. Throws InputError.
/// Source: 3MF Consortium, Core Specification 1.3, Materials and Properties 1.2, Production Extension 1.1.
Scene read_three_mf(const ModelReading& in);

}  // namespace ligne
