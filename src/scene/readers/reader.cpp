#include "scene/readers/reader.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "files/named_input.hpp"
#include "files/utf16.hpp"
#include "scene/clean/clean.hpp"
#include "scene/clean/far_vertices.hpp"
#include "scene/clean/weld.hpp"
#include "scene/creases/file_shading.hpp"
#include "scene/readers/format_readers.hpp"
#include "scene/readers/scene_builder.hpp"

namespace ligne {
namespace {

namespace fs = std::filesystem;

/// Throws InputError if a coordinate is too large to compute with, or not finite. Readers check the values in the file,
/// but the transforms of a glTF can produce such coordinates too.
void check_size(const Scene& scene, const std::string& name) {
  const auto is_too_large = [](const Point3& p) {
    return !(std::abs(p.x) <= kLargestCoordinate && std::abs(p.y) <= kLargestCoordinate &&
             std::abs(p.z) <= kLargestCoordinate);
  };
  const auto first_of = [&](std::size_t begin, std::size_t end) {
    const auto from = scene.vertices.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto to = scene.vertices.begin() + static_cast<std::ptrdiff_t>(end), found = std::find_if(from, to, is_too_large);
    return found == to ? scene.vertices.size() : static_cast<std::size_t>(found - scene.vertices.begin());
  };
  const auto first = [](std::size_t a, std::size_t b) { return std::min(a, b); };
  const std::size_t n = scene.vertices.size(), v = parallel_reduce(n, kShortWorkBlock, n, first_of, first);
  if (v == n) return;
  throw InputError(name, "vertex " + std::to_string(v) + " of " + std::to_string(n) +
                             ": a coordinate is beyond 1.6e60, too large to compute with");
}

/// Makes all materials of a scene opaque if none of its faces could be seen: programs write an opacity of 0 that they do not
/// mean.
void make_visible(Scene& scene, Warnings& warnings) {
  const auto is_invisible = [&](std::uint32_t m) { return scene.materials[m].opacity == 0; };
  if (std::ranges::none_of(scene.materials, [](const Material& m) { return m.opacity == 0; })) return;
  // Without a list, all faces have the first material.
  if (scene.face_material.empty() ? !is_invisible(0) : !std::ranges::all_of(scene.face_material, is_invisible)) return;
  for (Material& material : scene.materials) material.opacity = 1;
  warnings.add("materials drawn opaque: no face has an opacity above 0", scene.materials.size());
}

/// Warns of vertices beside which all others are a dot.
void warn_of_far_vertices(const Scene& scene, Warnings& warnings) {
  const FarVertices far = find_far_vertices(scene.vertices);
  if (far.count == 0) return;
  const Point3& p = scene.vertices[far.farthest];
  warnings.add("vertices a million times as far out as most, such as (" + rounded(p.x, 3) + ", " + rounded(p.y, 3) + ", " +
                   rounded(p.z, 3) + "): the others are a dot beside it",
               far.count);
}

/// Facts about the vertices of a scene that reading has found out.
struct VertexFacts {
  CreaseTags tags{};
  std::optional<Weld> weld{};  ///< weld_vertices() of the scene, if it is known
};

void weld_and_finish(Scene& scene, const ReadOptions& options, VertexFacts facts, const std::string& name,
                     Warnings& warnings, ReadReport& report) {
  make_visible(scene, warnings);
  if (options.weld_distance > 0 || options.subdivision) facts.weld.reset();
  if (options.weld_distance > 0) weld_near_vertices(scene, options.weld_distance);
  if (options.subdivision) {
    const SubdivisionRequest request{*options.subdivision, options.is_subdivided, options.shading};
    report.subdivision = subdivide(scene, request, std::move(facts.tags), name, warnings);
  }
  finish_scene(scene, warnings, std::move(facts.weld));
  warn_of_far_vertices(scene, warnings);
  if (options.merge_coplanar) merge_coplanar_faces(scene);
}

Scene read_raw(const ModelReading& in, ModelFormat format) {
  using Reader = Scene (*)(const ModelReading&);
  constexpr Reader kReaders[] = {[](const ModelReading& text) { return read_gltf(text, false); },
                                 [](const ModelReading& glb) { return read_gltf(glb, true); },
                                 read_obj,
                                 read_stl_ascii,
                                 read_stl_binary,
                                 read_ply,
                                 read_asc,
                                 read_3ds,
                                 read_off,
                                 read_three_mf,
                                 read_ligne_scene};
  if (format == ModelFormat::ligne_tree)
    throw InputError(in.file.name, "a compiled model is read by the programs that draw it");
  return kReaders[static_cast<std::size_t>(format)](in);
}

/// Appends `extra` to `values`, each plus `offset`. An empty list represents as many zeros as its size argument says.
template <typename T>
void append_zeros_left_out(std::vector<T>& values, std::size_t size, const std::vector<T>& extra, std::size_t extra_size,
                           T offset) {
  if (values.empty() && extra.empty() && offset == T{0}) return;
  values.resize(size, T{0});
  for (const T value : extra) values.push_back(static_cast<T>(value + offset));
  values.resize(size + extra_size, offset);
}

}  // namespace

Scene read_scene(const fs::path& file, const ReadOptions& options, Warnings& warnings, ReadReport* report) {
  const std::string name = shown_input(file);
  InputFiles opened;
  const std::vector<std::byte> bytes = as_utf8(read_named_input(file, opened));
  const ModelFormat format = detect_format(bytes, file.extension().string(), name);
  const fs::path folder = file == "-" ? fs::path() : file.parent_path().empty() ? fs::path(".") : file.parent_path();
  Scene scene = read_scene({bytes, name, folder}, format, options, warnings, report);
  if (report) report->files.insert(report->files.begin(), opened.begin(), opened.end());
  return scene;
}

Scene read_scene(const ModelBytes& file, ModelFormat format, const ReadOptions& options, Warnings& warnings,
                 ReadReport* report) {
  const std::string& name = file.name;
  ReadReport own_report;
  ReadReport& counts = report ? *report : own_report;
  counts = ReadReport{};
  counts.format = format;
  FileShading shading;
  VertexFacts facts;
  const bool with_shading = options.shading || options.subdivision;
  Scene scene = read_raw({file, counts, warnings, with_shading ? &shading : nullptr,
                          options.subdivision ? &facts.tags : nullptr, options.groups, options.pose},
                         format);
  if (scene.faces.empty()) {
    const bool points = !scene.vertices.empty();
    throw InputError(name, no_faces(warnings.left_out()) + (points ? "; points are drawn by: ligne surface --grid" : ""));
  }
  check_size(scene, name);
  if (with_shading) facts.weld = mark_smooth_edges(scene, shading);
  const std::size_t faces = scene.faces.size();
  weld_and_finish(scene, options, std::move(facts), name, warnings, counts);
  if (scene.faces.empty()) {
    throw InputError(name, "none of its " + std::to_string(faces) + " faces has an area: they are lines or points");
  }
  return scene;
}

void clean_read_scene(Scene& scene, const std::string& name, const ReadOptions& options, Warnings& warnings,
                      ReadReport& report) {
  if (scene.faces.empty()) throw InputError(name, "holds no faces");
  check_size(scene, name);
  weld_and_finish(scene, options, {}, name, warnings, report);
}

void append_scene(Scene& a, Scene&& b) {
  if (a.objects.empty() && a.vertices.empty() && a.faces.empty()) {
    a = std::move(b);
    return;
  }
  const std::size_t faces_a = a.faces.size(), corners_a = a.faces.corners().size();
  if (a.vertices.size() + b.vertices.size() >= kNone || corners_a + b.faces.corners().size() >= kNone) {
    throw InputError("the models together hold more than 4294967294 vertices or corners");
  }
  const auto vertices = static_cast<std::uint32_t>(a.vertices.size()), faces = static_cast<std::uint32_t>(faces_a);
  // Faces without a material of their own have material 0, which must exist before another scene is appended.
  if (a.materials.empty()) a.materials.emplace_back();
  if (b.materials.empty()) b.materials.emplace_back();
  const auto materials = static_cast<std::uint32_t>(a.materials.size());

  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  std::vector<std::uint32_t> contour;
  for (std::size_t f = 0; f < b.faces.size(); ++f) {
    for (std::size_t c = 0; c < b.faces.contour_count(f); ++c) {
      const auto corners = b.faces.contour(f, c);
      contour.assign(corners.begin(), corners.end());
      for (std::uint32_t& v : contour) v += vertices;
      if (c == 0)
        a.faces.add_face(contour);
      else
        a.faces.add_hole(contour);
    }
  }
  append_zeros_left_out(a.face_material, faces_a, b.face_material, b.faces.size(), materials);
  append_zeros_left_out(a.corner_flags, corners_a, b.corner_flags, b.faces.corners().size(), std::uint8_t{0});
  for (Object& object : b.objects) {
    object.vertex_begin += vertices;
    object.vertex_end += vertices;
    object.face_begin += faces;
    object.face_end += faces;
    a.objects.push_back(std::move(object));
  }
  for (Detail& detail : b.details) {
    detail.face += faces;
    detail.material += materials;
    a.details.push_back(std::move(detail));
  }
  std::move(b.materials.begin(), b.materials.end(), std::back_inserter(a.materials));
  a.stated.bits &= b.stated.bits;
  a.stated.forget_relations();
  a.lights.insert(a.lights.end(), b.lights.begin(), b.lights.end());
  std::move(b.cameras.begin(), b.cameras.end(), std::back_inserter(a.cameras));
}

}  // namespace ligne
