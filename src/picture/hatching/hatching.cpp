#include "picture/hatching/hatching.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>

#include <glm/geometric.hpp>

#include "picture/choice/method_choice.hpp"
#include "picture/errors.hpp"
#include "picture/fills.hpp"
#include "picture/hatching/form_hatching.hpp"
#include "picture/hatching/hatch_layers.hpp"
#include "picture/products.hpp"
#include "plotting/hatching/hatch.hpp"
#include "view/brightness.hpp"
#include "view/projected_scene.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

// Adjustable.
constexpr double kFaceStep = 7.5;  ///< step of the directions of faces, degrees
/// Degrees added to the direction of the strokes, by number of the material.
constexpr double kMaterialTurns[] = {0, 90, 135, 45, 22.5, 112.5, 67.5, 157.5};
constexpr double kMostLines = 1e6;  ///< largest number of lines of runs on the page
constexpr double kMostRuns = 3e7;   ///< largest number of runs on all faces; they take a gigabyte
/// Largest number of lines within one pen width. Each line is compared with all others that the pen covers. Even a tone
/// that draws one line of sixteen is solid ink at a much lower number.
constexpr double kMostLinesUnderPen = 128;

/// The hatching of a face: its strokes, in terms of plotting/hatching/hatch.hpp, and their direction.
struct FaceHatch {
  double degrees = 0;
  SurfaceHatch strokes{0, kRowCycle, 0, 0};
  bool cross = false;
};

/// Reduces degrees to [0, 180): strokes have no orientation.
double half_turn(double degrees) {
  const double rest = std::fmod(degrees, 180);
  return rest < 0 ? rest + 180 : rest;
}

bool hatched_in(const FaceHatch& face, double degrees) {
  return face.strokes.every > 0 && (face.degrees == degrees || (face.cross && half_turn(face.degrees + 90) == degrees));
}

/// The visible parts of the surfaces that are hatched in one direction.
struct DirectionRuns {
  double degrees;
  HatchFrame frame;
  std::vector<SurfaceRun> runs;
};

/// Decides how faces are hatched, and collects the layers.
class Hatching {
 public:
  explicit Hatching(const HatchScene& hatch)
      : hatch_(hatch), layers_(hatch), light_(hatch.prepared.scene, hatch.prepared.view().camera, hatch.prepared.lights) {
    pen_mm_ = layers_.pen_mm(0, "");
    const double spacing = closest_strokes_mm(hatch.request(), pen_mm_);
    line_mm_ = hatch_line_mm(spacing, pen_mm_);
    if (std::hypot(hatch.plot.page.width_mm, hatch.plot.page.height_mm) / line_mm_ > kMostLines) {
      throw RequestError("hatch-spacing", "the strokes are too dense: more than a million on the page");
    }
    if (pen_mm_ / line_mm_ > kMostLinesUnderPen) {
      throw RequestError("hatch-spacing", "the strokes are too dense: more than 128 under the pen");
    }
    closest_ = static_cast<unsigned>(std::lround(spacing / line_mm_));
    if (hatch.request().direction.by_face) find_directions();
    if (hatch.request().kind == HatchKind::shade && hatch.request().levels == 0u)
      flat_light_ = flat_light(hatch.prepared.scene, hatch.patches, light_);
  }

  double line_mm() const { return line_mm_; }

  /// `region`: details and light of the region, or nullptr for the whole face.
  FaceHatch of(std::uint32_t face, const Region* region);
  void add(std::vector<FaceHatch>& faces, std::span<const DirectionRuns> directions);

  std::vector<Layer> take() { return layers_.take(); }

 private:
  void find_directions();
  void space_evenly(std::vector<FaceHatch>& faces, std::span<const DirectionRuns> directions) const;
  void add(const HatchFrame& frame, std::span<const SurfaceRun> runs, std::span<const SurfaceHatch> surfaces);

  const HatchScene& hatch_;
  HatchLayers layers_;
  FaceLight light_;
  double line_mm_ = 0, pen_mm_ = 0;
  unsigned closest_ = 1;
  std::vector<double> patch_degrees_;              ///< where the direction is by face
  std::vector<std::optional<double>> flat_light_;  ///< of flat patches; empty: not needed
};

/// Finds the direction on the page of the level lines of each patch, in steps of kFaceStep. It is the requested
/// direction if the patch is level or seen along its level lines. A curved patch has the direction of the mean over its
/// faces, weighted by their visible size.
void Hatching::find_directions() {
  const Scene& scene = hatch_.prepared.scene;
  const Camera& camera = hatch_.prepared.view().camera;
  struct Mean {
    Point3 normal{0, 0, 0}, at{0, 0, 0};
    double weight = 0;
  };
  std::vector<Mean> means(hatch_.patches.count);
  for (std::uint32_t face = 0; face < scene.faces.size(); ++face) {
    Point3 area = area_vector(scene, face);
    const Point3 point = scene.vertices[scene.faces.contour(face, 0)[0]];
    const Point3 sight = camera.perspective ? glm::normalize(point - camera.eye) : camera.forward;
    const double seen = std::abs(glm::dot(area, sight));
    Mean& mean = means[hatch_.patches.of_face[face]];
    if (glm::dot(area, sight) > 0) area = -area;
    mean.normal += area * seen;  // faces seen edge on count little
    mean.at += point * seen;
    mean.weight += seen;
  }
  Point3 up{0, 0, 0};
  up[static_cast<int>(scene.up_axis)] = 1;
  constexpr double kLevel = 1e-3;  // sine of the slope below which a face counts as level
  for (const Mean& mean : means) {
    double degrees = hatch_.request().direction.degrees;
    const double length = glm::length(mean.normal);
    const Point3 level = length > 0 ? glm::cross(mean.normal / length, up) : Point3{0, 0, 0};
    const Point3 at = camera_coordinates(camera, mean.weight > 0 ? mean.at / mean.weight : camera.eye);
    Point2 seen{glm::dot(level, camera.right), glm::dot(level, camera.down)};
    if (camera.perspective && at.z > 0) seen -= Point2{at.x, at.y} * (glm::dot(level, camera.forward) / at.z);
    if (glm::length(level) > kLevel && glm::length(seen) > kLevel) {
      degrees = kFaceStep * std::round(std::atan2(-seen.y, seen.x) * 180 / std::numbers::pi / kFaceStep);
    }
    patch_degrees_.push_back(degrees);
  }
}

FaceHatch Hatching::of(std::uint32_t face, const Region* region) {
  const HatchRequest& request = hatch_.request();
  const Scene& scene = hatch_.prepared.scene;
  const std::uint32_t patch = hatch_.patches.of_face[face];
  FaceHatch how{request.direction.by_face ? patch_degrees_[patch] : request.direction.degrees,
                {closest_, kRowCycle, patch, 0},
                request.cross};
  const Material material = region ? material_of(scene, *region) : material_of(scene, face);
  unsigned shade = 1;
  if (request.kind == HatchKind::shade) {
    const std::uint32_t reached = region ? region->lights : 0xffffffffu;
    const auto shares = region ? std::span<const double>(region->light_shares) : std::span<const double>();
    const bool whole = reached == 0xffffffffu && shares.empty() && !flat_light_.empty();
    const double light =
        std::clamp(whole && flat_light_[patch] ? *flat_light_[patch] : light_.of(face, reached, shares), 0.0, 1.0);
    const unsigned levels = request.levels.value_or(kMostShades), shades = levels == 0 ? kMostShades : levels;
    shade = 1 + std::min(shades - 1, static_cast<unsigned>(light * shades));
    how.strokes.rows = levels > 0                  ? kRowCycle >> (shade - 1)
                       : light > kBrightestHatched ? 0
                                                   : static_cast<std::uint32_t>(std::ceil((1 - light) * kRowCycle));
    how.cross = how.cross || (!hatch_.prepared.lights.empty() && reached == 0);
  } else if (request.kind == HatchKind::material) {
    const std::uint32_t own = scene.face_material.empty() ? 0 : scene.face_material[face];
    const std::uint32_t number = region && region->material < scene.materials.size() ? region->material : own;
    how.degrees += kMaterialTurns[number % std::size(kMaterialTurns)];
    const double luminance = glm::dot(material.color, Point3{0.2126, 0.7152, 0.0722});  // ITU-R BT.709
    shade = 1 + static_cast<unsigned>(std::clamp(luminance, 0.0, 0.99) * kMostShades);
    how.strokes.every = closest_ * shade;
  }
  how.degrees = half_turn(how.degrees);
  how.strokes.layer = layers_.number(shade, material.name);
  return how;
}

/// Gives equal distances to the rows of a patch whose visible parts all have one shade, as on flat faces, in place of
/// some rows of a cycle. Faces too narrow for a stroke do not count, since rounding may decide whether a method shows
/// them.
void Hatching::space_evenly(std::vector<FaceHatch>& faces, std::span<const DirectionRuns> directions) const {
  constexpr std::uint32_t kMixed = 0xffffffffu;
  std::map<std::uint32_t, std::uint32_t> rows_of_patch;
  for (const DirectionRuns& direction : directions) {
    for (const SurfaceRun& run : direction.runs) {
      if (run.to - run.from < pen_mm_) continue;
      const SurfaceHatch& strokes = faces[run.surface].strokes;
      const auto [entry, added] = rows_of_patch.emplace(strokes.group, strokes.rows);
      if (!added && entry->second != strokes.rows) entry->second = kMixed;
    }
  }
  for (FaceHatch& face : faces) {
    const auto entry = rows_of_patch.find(face.strokes.group);
    if (face.strokes.every == 0 || entry == rows_of_patch.end()) continue;
    const std::uint32_t rows = entry->second;
    if (rows == kMixed || rows == 0 || rows != face.strokes.rows) continue;
    face.strokes.every = static_cast<std::uint32_t>(std::lround(static_cast<double>(face.strokes.every) * kRowCycle / rows));
    face.strokes.rows = kRowCycle;
  }
}

void Hatching::add(const HatchFrame& frame, std::span<const SurfaceRun> runs, std::span<const SurfaceHatch> surfaces) {
  std::vector<double> pens;
  std::vector<Polylines> lines(layers_.all().size());
  for (const Layer& layer : layers_.all()) pens.push_back(layers_.pen_mm(layer));
  hatch_runs(frame, line_mm_, runs, surfaces, pens, lines);
  for (std::size_t i = 0; i < lines.size(); ++i) append(layers_.all()[i].lines, lines[i]);
}

/// Adds the strokes of all directions.
void Hatching::add(std::vector<FaceHatch>& faces, std::span<const DirectionRuns> directions) {
  space_evenly(faces, directions);
  std::vector<SurfaceHatch> surfaces;
  for (const DirectionRuns& direction : directions) {
    surfaces.assign(faces.size(), {});
    for (std::size_t i = 0; i < faces.size(); ++i) {
      if (hatched_in(faces[i], direction.degrees)) surfaces[i] = faces[i].strokes;
    }
    add(direction.frame, direction.runs, surfaces);
  }
}

/// All directions in which a face is hatched.
std::set<double> directions_of(std::span<const FaceHatch> faces) {
  std::set<double> directions;
  for (const FaceHatch& face : faces) {
    if (face.strokes.every == 0) continue;
    directions.insert(face.degrees);
    if (face.cross) directions.insert(half_turn(face.degrees + 90));
  }
  return directions;
}

/// The bounding box of the page in the frame of the strokes.
Rect turned(const Rect& window, const HatchFrame& frame) {
  Rect box;
  for (const Point2 p : {window.min, window.max, Point2{window.min.x, window.max.y}, Point2{window.max.x, window.min.y}})
    box.extend(frame.to_frame(p));
  return box;
}

/// Number of lines between `low` and `high`, measured across the lines.
double lines_between(double low, double high, double line_mm) {
  return std::max(0.0, std::floor(high / line_mm) - std::ceil(low / line_mm) + 1);
}

/// Throws RequestError if there are more runs than memory or time allow.
void check_runs(const PictureRequest& request, double runs) {
  const std::string text = std::to_string(static_cast<std::uint64_t>(runs)) + " lines across the visible faces";
  if (runs > kMostRuns) throw RequestError("hatch-spacing", "the strokes are too dense: " + text);
  request.memory.require(runs * sizeof(SurfaceRun), {"hatch", text});
}

/// Number of runs in a region: one for every line across it.
double runs_of(const Region& region, const HatchFrame& frame, double line_mm) {
  Rect box;
  for (const Point2 p : region.contours.front()) box.extend(frame.to_frame(p));
  return box.empty() ? 0 : lines_between(box.min.y, box.max.y, line_mm);
}

/// The view with the page turned so that the strokes run from left to right. `box` is the visible part in the frame of
/// the strokes; its corner moves to (0, 0).
View turned_view(const Scene& scene, const View& view, const HatchFrame& frame, const Rect& box) {
  Camera camera = view.camera;
  camera.right = view.camera.right * frame.along().x + view.camera.down * frame.along().y;
  camera.down = view.camera.right * frame.across().x + view.camera.down * frame.across().y;
  // The field of view of the turned camera contains that of the given one.
  const double half = std::tan(camera.fov_degrees * std::numbers::pi / 360) * std::hypot(1.0, camera.aspect);
  camera.fov_degrees = std::atan(half) * 360 / std::numbers::pi;
  camera.aspect = 1;
  const Rect page{{0, 0}, box.max - box.min};
  const View first = make_view(scene, camera, {{{0, 0}, {0, 0}}}, page, view.scale);
  const Point2 shift = -box.min - first.offset;
  return make_view(scene, camera, {{shift, shift}}, page, view.scale);
}

/// Clips runs to the window.
void cut_to(const Rect& window, const HatchFrame& frame, double line_mm, std::vector<SurfaceRun>& runs) {
  const std::vector<std::vector<Point2>> sheet{
      {window.min, {window.max.x, window.min.y}, window.max, {window.min.x, window.max.y}}};
  std::vector<SurfaceRun> lines;
  add_runs(sheet, 0, frame, line_mm, lines);
  std::map<std::int32_t, const SurfaceRun*> line_of;
  for (const SurfaceRun& line : lines) line_of[line.line] = &line;
  std::erase_if(runs, [&](SurfaceRun& run) {
    const auto line = line_of.find(run.line);
    if (line == line_of.end()) return true;
    run.from = std::max(run.from, line->second->from);
    run.to = std::min(run.to, line->second->to);
    return !(run.from < run.to);
  });
}

/// Returns the visible parts of the faces hatched in that direction, from scan lines of the method along the strokes.
DirectionRuns seen_in_direction(const PreparedScene& prepared, std::span<const FaceHatch> faces, double degrees,
                                double line_mm) {
  DirectionRuns direction{degrees, HatchFrame(prepared.view().offset, degrees), {}};
  const Rect box = turned(prepared.view().window, direction.frame);
  if (box.empty()) return direction;
  const View view = turned_view(prepared.scene, prepared.view(), direction.frame, box);
  ProjectedScene projected = project(prepared.scene, prepared.topology, view, {});
  cull(projected, prepared.back_faces);
  const auto first = static_cast<std::int32_t>(std::ceil(box.min.y / line_mm)),
             last = static_cast<std::int32_t>(std::floor(box.max.y / line_mm));
  if (last < first) return direction;
  VisibilityOptions options;
  options.settings = prepared.request.lines.settings;
  options.wanted = kSpans;
  options.span_lines = SpanLines{first * line_mm + view.offset.y, line_mm, static_cast<std::uint32_t>(last - first + 1)};
  const VisibilityResult result = prepared.method.compute_visibility(projected, options);
  if (!result.spans) return direction;
  for (const Span& span : result.spans->spans) {
    if (!hatched_in(faces[span.face], degrees)) continue;
    direction.runs.push_back(
        {first + static_cast<std::int32_t>(span.line), span.x_from - view.offset.x, span.x_to - view.offset.x, span.face});
  }
  cut_to(prepared.view().window, direction.frame, line_mm, direction.runs);
  return direction;
}

}  // namespace

HatchScene hatch_scene(const PreparedScene& prepared, const PlotOptions& plot) {
  HatchScene hatch{prepared, plot, {}, {}};
  const PictureRequest& request = prepared.request;
  const bool gives_regions = request.lines.method ? (prepared.method.traits().products & kRegions) != 0
                                                  : chooses_regions(request, prepared.projected);
  // Patches are also needed in JSON, since a stored drawing can be hatched later.
  if (hatch.request().is_requested() || (request.output.format == OutputFormat::json && gives_regions)) {
    hatch.patches = hatch_patches(prepared.scene, prepared.topology, prepared.request.lines.crease_degrees);
  }
  if (follows_form(hatch.request())) {
    hatch.form = form_mesh(prepared.scene, prepared.topology, prepared.request.lines.crease_degrees);
  }
  return hatch;
}

void refuse_hatching(std::string_view method) {
  throw RequestError("hatch", "method " + std::string(method) + " gives neither regions nor spans; regions: " +
                                  methods_with(kRegions) + "; spans: " + methods_with(kSpans));
}

std::vector<Layer> hatch_regions(const HatchScene& hatch, const std::vector<Region>& regions, RunReport& run) {
  if (!hatches_regions(hatch.prepared.request, hatch.prepared.method)) return {};
  return timed(run.stages, "hatch", [&] {
    if (follows_form(hatch.request())) return hatch_form(hatch, regions);
    Hatching hatching(hatch);
    std::vector<FaceHatch> faces;
    faces.reserve(regions.size());
    for (const Region& region : regions) {
      faces.push_back(region.level > 0 ? FaceHatch{} : hatching.of(region.face, &region));
    }
    std::vector<DirectionRuns> directions;
    for (const double degrees : directions_of(faces)) {
      DirectionRuns& direction =
          directions.emplace_back(DirectionRuns{degrees, HatchFrame(hatch.prepared.view().offset, degrees), {}});
      double runs = 0;
      for (std::size_t i = 0; i < faces.size(); ++i) {
        if (hatched_in(faces[i], degrees)) runs += runs_of(regions[i], direction.frame, hatching.line_mm());
      }
      check_runs(hatch.prepared.request, runs);
      for (std::uint32_t i = 0; i < faces.size(); ++i) {
        if (!hatched_in(faces[i], degrees)) continue;
        add_runs(regions[i].contours, i, direction.frame, hatching.line_mm(), direction.runs);
      }
    }
    hatching.add(faces, directions);
    return hatching.take();
  });
}

std::vector<Layer> hatch_spans(const HatchScene& hatch, RunReport& run) {
  const PreparedScene& prepared = hatch.prepared;
  if (!hatch.request().is_requested() || hatches_regions(prepared.request, prepared.method)) return {};
  const auto transparent =
      std::ranges::count_if(prepared.projected.face_is_transparent, [](std::uint8_t t) { return t != 0; });
  if (transparent > 0) run.warn("the hatching omits " + std::to_string(transparent) + " transparent faces");
  return timed(run.stages, "hatch", [&] {
    Hatching hatching(hatch);
    std::vector<FaceHatch> faces;
    for (std::uint32_t face = 0; face < prepared.scene.faces.size(); ++face) faces.push_back(hatching.of(face, nullptr));
    std::vector<DirectionRuns> directions;
    for (const double degrees : directions_of(faces)) {
      directions.push_back(seen_in_direction(prepared, faces, degrees, hatching.line_mm()));
    }
    hatching.add(faces, directions);
    return hatching.take();
  });
}

}  // namespace ligne
