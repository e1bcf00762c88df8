#include "reader_harness.hpp"

#include "picture/draw_scene.hpp"
#include "picture/models/compiled_model.hpp"
#include "picture/raster/zbuffer_picture.hpp"
#include "plotting/paths/optimize.hpp"
#include "plotting/readers/drawing_reader.hpp"
#include "scene/creases/find_creases.hpp"
#include "scene/heal/heal.hpp"
#include "scene/readers/gltf/meshopt_codec.hpp"
#include "scene/readers/obj/obj_materials.hpp"
#include "scene/readers/reader.hpp"
#include "scene/surfaces/grids/grid_formats.hpp"
#include "scene/surfaces/grids/point_table.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

std::vector<ModelFormat> formats_of(std::string_view kind) {
  if (kind == "gltf") return {ModelFormat::gltf};
  if (kind == "glb") return {ModelFormat::glb};
  if (kind == "obj") return {ModelFormat::obj};
  if (kind == "stl") return {ModelFormat::stl_ascii, ModelFormat::stl_binary};
  if (kind == "ply") return {ModelFormat::ply};
  if (kind == "off") return {ModelFormat::off};
  if (kind == "3mf") return {ModelFormat::three_mf};
  if (kind == "asc") return {ModelFormat::asc_3d_studio};
  if (kind == "3ds") return {ModelFormat::three_ds};
  if (kind == "scene") return {ModelFormat::ligne_scene};
  need(false, "such a kind of file");
  return {};
}

void check_scene(const Scene& scene) {
  std::uint32_t vertex = 0, face = 0;
  for (const Object& object : scene.objects) {
    need(object.vertex_begin == vertex && object.face_begin == face, "objects own contiguous ranges");
    vertex = object.vertex_end;
    face = object.face_end;
    for (std::size_t f = object.face_begin; f < object.face_end; ++f)
      for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
        need(scene.faces.contour(f, c).size() >= 3, "contours have three corners or more");
        for (const std::uint32_t v : scene.faces.contour(f, c))
          need(v >= object.vertex_begin && v < object.vertex_end, "faces name vertices of their object");
      }
    need(std::isfinite(object.precision), "precisions are finite");
  }
  need(vertex == scene.vertices.size() && face == scene.faces.size(), "objects cover the scene");
  need(scene.face_material.empty() || scene.face_material.size() == scene.faces.size(), "a material per face");
  for (const std::uint32_t m : scene.face_material) need(m < scene.materials.size(), "materials exist");
  need(scene.corner_flags.empty() || scene.corner_flags.size() == scene.faces.corners().size(), "flags per corner");
  for (const Point3& p : scene.vertices)
    need(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "vertices are finite");
  for (const Detail& detail : scene.details) need(detail.face < scene.faces.size(), "details lie on faces");
}

void need_one_line(const InputError& error) {
  for (const char c : std::string_view(error.what())) need(static_cast<unsigned char>(c) >= 0x20, "an error is one line");
}

/// Reads a few rows: all of a small grid, and no more than that of one that a few bytes describe.
void check_heights(const HeightSource& heights) {
  need(heights.x().size() >= 2 && heights.y().size() >= 2, "grids have two columns and two rows");
  for (const std::vector<double>* positions : {&heights.x(), &heights.y()})
    for (std::size_t i = 0; i < positions->size(); ++i) {
      need(std::isfinite((*positions)[i]), "positions are finite");
      need(i == 0 || (*positions)[i - 1] < (*positions)[i], "positions ascend");
    }
  constexpr std::size_t kRows = 1000;
  std::vector<double> z(heights.x().size());
  for (std::size_t j = 0; j < std::min(heights.y().size(), kRows); ++j) {
    heights.read_row(j, z);
    for (const double height : z) need(std::isfinite(height) || std::isnan(height), "heights are finite, or holes");
  }
}

void read_surfaces_as_fuzzer(std::span<const std::byte> bytes, const GridChoice& choice) {
  try {
    Warnings warnings;
    for (const GridSurface& surface : read_surfaces(bytes, "fuzz", warnings, {}, nullptr, choice)) {
      if (surface.heights) check_heights(*surface.heights);
      if (surface.mesh)
        need(surface.mesh->points.size() == surface.mesh->columns * surface.mesh->rows, "meshes have all their points");
    }
    for (const std::string& line : warnings.lines()) need(line.find('\n') == std::string::npos, "a warning is one line");
  } catch (const InputError& error) {
    need_one_line(error);
  }
}

/// Reads a grid as its content says, and once more with the options that the number of its bytes chooses.
void read_grid_as_fuzzer(std::span<const std::byte> bytes) {
  read_surfaces_as_fuzzer(bytes, {});
  constexpr std::array kLayouts{TableLayout::matrix, TableLayout::frame, TableLayout::series, TableLayout::columns,
                                TableLayout::automatic};
  GridChoice choice;
  choice.layout = kLayouts[bytes.size() % kLayouts.size()];
  if (bytes.size() % 2 == 1) choice.data_set = 1;
  if (bytes.size() % 3 == 1) choice.using_columns = {"3"};
  if (bytes.size() % 3 == 2) choice.using_columns = {"2", "1", "3"};
  read_surfaces_as_fuzzer(bytes, choice);
}

void read_points_as_fuzzer(std::span<const std::byte> bytes) {
  try {
    Warnings warnings;
    for (const LabelledPoint& point : read_points(bytes, "fuzz", warnings)) {
      need(std::isfinite(point.at.x) && std::isfinite(point.at.y), "points have a position");
      need(std::isfinite(point.at.z) || std::isnan(point.at.z), "heights of points are finite, or none");
    }
    for (const std::string& line : warnings.lines()) need(line.find('\n') == std::string::npos, "a warning is one line");
  } catch (const InputError& error) {
    need_one_line(error);
  }
}

/// Readers that are chosen by a file's name or its first bytes.
void read_terrain_as_fuzzer(std::string_view kind, std::span<const std::byte> bytes) {
  try {
    Warnings warnings;
    check_heights(
        *(kind == "hgt" ? read_hgt_grid(bytes, "N47E008.hgt", warnings) : read_tiff_grid(bytes, "fuzz", warnings)));
  } catch (const InputError& error) {
    need_one_line(error);
  }
}

void read_formula_as_fuzzer(std::span<const std::byte> bytes) {
  try {
    const std::string formula(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    check_heights(*formula_heights(formula, {-1.5, 0, 2}, {0, 3}));
  } catch (const InputError& error) {
    need_one_line(error);
    need(std::string_view(error.what()).starts_with("formula:"), "errors of formulas name a column");
  }
}

/// Compiled models are read as if their checksum were right, and drawn with the tree.
void read_tree_as_fuzzer(std::span<const std::byte> bytes) {
  std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  write_checksum_of_model(text);
  try {
    const CompiledModel model = read_compiled_model(std::as_bytes(std::span(text)), "fuzz");
    check_scene(model.scene);
    constexpr std::size_t kFaces = 500;
    if (model.scene.faces.size() > kFaces) return;
    PictureRequest request;
    request.lines.method = model.method;
    request.compiled = model.compiled;
    request.output.format = OutputFormat::json;
    RunReport run;
    draw_scene(model.scene, request, run);
  } catch (const InputError& error) {
    need_one_line(error);
  }
}

/// Depth buffers are read as if their checksum were right, and a triangle is added.
void read_zbuffer_as_fuzzer(std::span<const std::byte> bytes) {
  std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  write_checksum_of_zbuffer(text);
  try {
    ZBuffer buffer = ZBuffer::read(std::as_bytes(std::span(text)), "fuzz");
    check_scene(buffer.scene());
    constexpr std::size_t kFaces = 500;
    if (buffer.scene().faces.size() > kFaces) return;
    Scene added;
    added.vertices = {{0, 0, 0}, {2, 0, 1}, {0, 3, 1}};
    added.faces.add_face(std::vector<std::uint32_t>{0, 1, 2});
    added.objects.push_back({"added", 0, 3, 0, 1});
    PictureRequest request;
    request.lines.method = find_method("zbuffer");
    RunReport run;
    buffer.add(std::move(added), request, run);
  } catch (const InputError& error) {
    need_one_line(error);
  }
}

void read_mtl_as_fuzzer(std::span<const std::byte> bytes) {
  try {
    std::map<std::string, Material> materials;
    Warnings warnings;
    read_mtl(as_characters(bytes), "fuzz", materials, warnings);
    for (const auto& [name, material] : materials)
      need(material.opacity >= 0 && material.opacity <= 1, "opacities lie between 0 and 1");
    for (const std::string& line : warnings.lines()) need(line.find('\n') == std::string::npos, "a warning is one line");
  } catch (const InputError& error) {
    need_one_line(error);
  }
}

/// Streams of compressed views: the first two bytes say of which mode, filter, stride and count.
void read_meshopt_as_fuzzer(std::span<const std::byte> bytes) {
  if (bytes.size() < 2) return;
  const auto first = std::to_integer<std::size_t>(bytes[0]), second = std::to_integer<std::size_t>(bytes[1]);
  MeshoptView view;
  view.mode = static_cast<MeshoptMode>(first % 3);
  view.filter = static_cast<MeshoptFilter>(first / 3 % 4);
  view.stride = view.mode == MeshoptMode::attributes ? 4 * (1 + first / 12) : 2 + 2 * (first / 12 % 2);
  view.count = 3 * second;
  if (!check_meshopt(view).empty()) return;
  std::string cause;
  const std::vector<std::byte> out = decode_meshopt(bytes.subspan(2), view, cause);
  need(cause.empty() ? out.size() == view.count * view.stride : out.empty(), "all elements, or none");
}

/// Drawings are read, "svg" or "drawing", and their first strokes made ready for a pen.
void read_drawing_as_fuzzer(std::string_view kind, std::span<const std::byte> bytes) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  try {
    const ReadDrawing read =
        kind == "svg" ? read_svg_drawing(text, "fuzz", {}, {FillReading::How::hatch, 1}, {.strict = bytes.size() % 4 == 1})
                      : read_json_drawing(text, "fuzz", bytes.size() % 2 == 1);
    need(read.page.width_mm > 0 && read.page.height_mm > 0, "pages have an area");
    if (read.order) {
      need(read.order->pieces.size() == read.order->order.pieces.size(), "every piece has a look");
      for (const ReadOrder::Piece& piece : read.order->pieces)
        need(piece.material < read.order->materials.size(), "materials are there");
    }
    for (const Layer& layer : read.drawing.layers) {
      for (const Point2 p : layer.lines.points)
        need(std::abs(p.x) <= kFarthestMm && std::abs(p.y) <= kFarthestMm, "points lie within a kilometre");
      for (std::size_t i = 0; i < layer.lines.size(); ++i) need(layer.lines[i].size() >= 2, "lines have two points");
      constexpr std::size_t kPoints = 20'000;
      if (layer.lines.points.size() > kPoints) continue;
      const Polylines better = optimize_paths(layer.lines, {});
      for (const Point2 p : better.points)
        need(std::abs(p.x) <= kFarthestMm + 1 && std::abs(p.y) <= kFarthestMm + 1, "and stay there");
    }
  } catch (const std::runtime_error& error) {
    need(std::string_view(error.what()).find('\n') == std::string_view::npos, "errors are one line");
    need(std::string_view(error.what()).starts_with("fuzz"), "errors name the file");
  }
}

}  // namespace

void read_as_fuzzer(std::string_view kind, std::span<const std::byte> bytes) {
  if (kind == "svg" || kind == "drawing") return read_drawing_as_fuzzer(kind, bytes);
  if (kind == "tree") return read_tree_as_fuzzer(bytes);
  if (kind == "zbuf") return read_zbuffer_as_fuzzer(bytes);
  if (kind == "grid") return read_grid_as_fuzzer(bytes);
  if (kind == "points") return read_points_as_fuzzer(bytes);
  if (kind == "hgt" || kind == "tiff") return read_terrain_as_fuzzer(kind, bytes);
  if (kind == "formula") return read_formula_as_fuzzer(bytes);
  if (kind == "mtl") return read_mtl_as_fuzzer(bytes);
  if (kind == "meshopt") return read_meshopt_as_fuzzer(bytes);
  if (kind == "areas") return hide_areas_as_fuzzer(bytes);
  try {
    detect_format(bytes, "." + std::string(kind), "fuzz");
  } catch (const InputError& error) {
    need_one_line(error);
  }
  for (const ModelFormat format : formats_of(kind)) {
    try {
      Warnings warnings;
      check_scene(read_scene({bytes, "fuzz"}, format, {.merge_coplanar = true}, warnings));
      ReadOptions shaded{.shading = true};
      if (bytes.size() % 2 == 1) shaded.pose = ScenePose{"0", 0.5};
      if (format != ModelFormat::gltf && format != ModelFormat::glb) shaded.pose.reset();
      Scene scene = read_scene({bytes, "fuzz"}, format, shaded, warnings);
      Topology topology = build_topology(scene);
      heal(scene, topology, {});
      check_scene(scene);
      const Creases creases = find_creases(scene, topology, {});
      need(creases.lines.size() == topology.edges.size(), "the topology is that of the healed scene");
    } catch (const InputError& error) {
      need_one_line(error);
    }
  }
}

}  // namespace ligne
