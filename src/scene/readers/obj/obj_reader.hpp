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

/// Reads the polygons of an OBJ file: faces of any number of corners, relative indices, continued lines. Each `o` begins an
/// object; groups do not, since their faces share vertices, unless `groups_as_objects` asks for it and the file has no `o`.
/// A file without `o` is else one object. The names given by usemtl become materials, with what the material libraries in
/// the file's folder say of them (obj_materials.hpp). Bezier and B-spline patches become
/// triangles. y up; not cleaned yet. Throws InputError, with the line. Normals and smoothing groups go to `shading`, and
/// tags of subdivision to `tags`, where there is one.
Scene read_obj(const ModelBytes& file, ReadReport& report, Warnings& warnings, FileShading* shading = nullptr,
               bool groups_as_objects = false, CreaseTags* tags = nullptr);

}  // namespace ligne
