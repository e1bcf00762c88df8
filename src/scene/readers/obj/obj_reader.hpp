#pragma once
/// Reader of Wavefront OBJ.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "scene/creases/file_shading.hpp"
#include "scene/model/diagnostics.hpp"
#include "scene/model/scene.hpp"
#include "scene/readers/model_bytes.hpp"
#include "scene/readers/read_report.hpp"
#include "scene/subdivision/crease_tags.hpp"

namespace ligne {

/// Reads the polygons of an OBJ file: faces of any number of corners, relative indices, continued lines. Each `o`
/// begins an object; a file without `o` is one object. Groups begin objects only if `groups_as_objects` is set and the
/// file has no `o`, since their faces share vertices. The names given by usemtl become materials, with the properties
/// that the material libraries in the file's folder define for them (obj_materials.hpp). Bezier and B-spline patches
/// become triangles. y up; not cleaned yet. Throws InputError with the line. Normals and smoothing groups go to
/// `shading`, and tags of subdivision to `tags`, unless these are null.
Scene read_obj(const ModelBytes& file, ReadReport& report, Warnings& warnings, FileShading* shading = nullptr,
               bool groups_as_objects = false, CreaseTags* tags = nullptr);

}  // namespace ligne
