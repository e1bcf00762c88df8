#include "picture/surface/surface_curves.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>

#include "picture/errors.hpp"
#include "picture/marks/contour_labels.hpp"
#include "scene/surfaces/grids/point_table.hpp"
#include "scene/surfaces/surface_curve.hpp"

namespace ligne {
namespace {

constexpr std::size_t kCurveSamples = 600;

/// Colours of heights, from lowlands to peaks. Each is dark enough for a thin line on paper.
constexpr std::array<std::array<double, 3>, 6> kLandColors{{{0.05, 0.35, 0.30},
                                                            {0.20, 0.50, 0.25},
                                                            {0.58, 0.58, 0.16},
                                                            {0.76, 0.49, 0.14},
                                                            {0.62, 0.27, 0.12},
                                                            {0.38, 0.16, 0.16}}};

constexpr Point3 kWaterColor{0.80, 0.89, 0.95};

/// Fraction of white in the tints of these colours that areas have. It keeps lines on them visible.
constexpr double kWhiteOfTints = 0.45;

const SurfacePoints* ground_of(const std::vector<SurfacePoints>& surfaces) {
  const auto found = std::ranges::find_if(surfaces, [](const SurfacePoints& s) { return !s.parametric; });
  return found == surfaces.end() ? nullptr : &*found;
}

/// Converts the numbers at the axes to a point; logarithmic axes have decimal logarithms.
Point3 on_axes(const SurfaceRequest& request, Point3 p) {
  for (int k = 0; k < 3; ++k) {
    if (request.log_axes[static_cast<std::size_t>(k)]) p[k] = std::log10(p[k]);
  }
  return p;
}

/// Adds each line of the files as a curve.
void add_line_files(const SurfaceRequest& request, const SurfacePoints* ground, DrawnCurves& drawn, RunReport& run) {
  for (const std::string& file : request.line_files) {
    Warnings warnings;
    const std::vector<std::vector<Point3>> lines = read_lines(file, run.files, warnings);
    for (std::string& line : warnings.lines()) run.warnings.push_back({file, std::move(line)});
    std::vector<std::array<Point3, 2>>& segments = drawn.curves.emplace_back();
    for (const std::vector<Point3>& line : lines) {
      for (std::size_t k = 1; k < line.size(); ++k) {
        const Point3 a = on_axes(request, line[k - 1]), b = on_axes(request, line[k]);
        if (!std::isfinite(a.x + a.y + b.x + b.y)) continue;
        if (std::isfinite(a.z + b.z)) {
          segments.push_back({a, b});
          continue;
        }
        if (!ground) throw RequestError("path", "on the surface needs a surface z = f(x, y)");
        drape(*ground, a, b, segments);
      }
    }
    if (segments.empty()) run.warnings.push_back({file, "no line lies on the surface: nothing is drawn"});
  }
}

/// Largest distance of a height from a round number, as a fraction of the range of heights, for which the bands end at
/// that number, as ticks do: samples miss the extremes of a formula.
constexpr double kMissedEnd = 0.002;

std::string without_folder(const std::string& file) { return file.substr(file.rfind('/') + 1); }

std::string band_text(double low, double high) {
  const auto rounded = [](double height) {
    constexpr double kDigits = 1000;  // three after the first
    const double unit = height == 0 ? 1 : std::pow(10.0, std::floor(std::log10(std::abs(height)))) / kDigits;
    return height_text(std::round(height / unit) * unit, 10 * unit, false);
  };
  return rounded(low) + " \u2013 " + rounded(high);
}

/// Clips a segment to two limits of an axis. Returns false if nothing remains.
bool clip_to(double low, double high, int axis, std::array<Point3, 2>& segment) {
  for (int k = 0; k < 2; ++k) {
    for (const bool upper : {false, true}) {
      Point3 &here = segment[static_cast<std::size_t>(k)], &there = segment[static_cast<std::size_t>(1 - k)];
      const double limit = upper ? high : low, side = upper ? 1 : -1;
      const double out = side * (here[axis] - limit), other = side * (there[axis] - limit);
      if (out <= 0) continue;
      if (other >= 0) return false;
      here += (there - here) * (out / (out - other));
      here[axis] = limit;
    }
  }
  return true;
}

/// Returns the band that contains a height.
std::size_t band_of(const std::vector<double>& limits, double z) {
  return static_cast<std::size_t>(std::upper_bound(limits.begin() + 1, limits.end() - 1, z) - limits.begin()) - 1;
}

}  // namespace

DrawnCurves curves_of(const SurfaceRequest& request, const std::vector<SurfacePoints>& surfaces, RunReport& run) {
  DrawnCurves drawn;
  const SurfacePoints* ground = ground_of(surfaces);
  const auto needs_ground = [&](const char* option) {
    if (!ground) throw RequestError(option, "on the surface needs a surface z = f(x, y)");
  };
  for (std::size_t i = 0; i < request.space_curves.size(); ++i) {
    const SpaceCurve& curve = request.space_curves[i];
    const CurveRange range =
        request.t.empty() ? CurveRange{0, 6.283185307179586, {}} : request.t[std::min(i, request.t.size() - 1)];
    const std::size_t samples = range.curves ? *range.curves + 1 : kCurveSamples;
    const bool on_surface = curve[2] == kOnSurface;
    if (on_surface) needs_ground("curve");
    const std::vector<Point3> points = curve_points(curve, range.from, range.to, samples);
    std::vector<std::array<Point3, 2>>& segments = drawn.curves.emplace_back();
    for (std::size_t k = 1; k < points.size(); ++k) {
      const Point3 a = on_axes(request, points[k - 1]), b = on_axes(request, points[k]);
      if (!std::isfinite(a.x + a.y + b.x + b.y)) continue;
      if (on_surface) {
        drape(*ground, a, b, segments);
      } else if (std::isfinite(a.z + b.z)) {
        segments.push_back({a, b});
      }
    }
  }
  add_line_files(request, ground, drawn, run);
  std::size_t beside = 0;
  for (const std::string& file : request.point_files) {
    Warnings warnings;
    const std::vector<LabelledPoint> points = read_points(file, run.files, warnings);
    for (std::string& line : warnings.lines()) run.warnings.push_back({file, std::move(line)});
    for (const LabelledPoint& point : points) {
      Point3 p = on_axes(request, point.at);
      if (std::isnan(point.at.z)) {
        needs_ground("points");
        p.z = height_at(*ground, p.x, p.y).value_or(p.z);
      }
      if (!std::isfinite(p.x + p.y + p.z)) {
        ++beside;
        continue;
      }
      drawn.points.push_back({p, point.label});
    }
  }
  if (beside > 0) run.warn(std::to_string(beside) + " points outside the surface are omitted");
  return drawn;
}

bool fit_to_box(const SurfaceRequest& request, DrawnCurves& drawn, AxesBox& box, RunReport& run) {
  const std::array<bool, 3> is_set{request.x.has_value(), request.y.has_value(), request.z_range.has_value()};
  const auto clip = [&](std::array<Point3, 2>& segment) {
    for (int k = 0; k < 3; ++k) {
      if (is_set[static_cast<std::size_t>(k)] && !clip_to(box.low[k], box.high[k], k, segment)) return false;
    }
    return true;
  };
  std::size_t cut = 0;
  for (auto& curve : drawn.curves) {
    bool whole = true;
    std::erase_if(curve, [&](std::array<Point3, 2>& segment) {
      const std::array<Point3, 2> before = segment;
      const bool inside = clip(segment);
      whole = whole && inside && segment == before;
      return !inside;
    });
    if (!whole) ++cut;
  }
  const std::size_t points = drawn.points.size();
  std::erase_if(drawn.points, [&](const MarkedPoint& point) {
    std::array<Point3, 2> segment{point.at, point.at};
    return !clip(segment);
  });
  constexpr const char* kRanges = "the ranges of -x, -y or --z-range: ";
  if (cut == 1) run.warn(std::string("1 curve leaves ") + kRanges + "it ends at the box");
  if (cut > 1) run.warn(std::to_string(cut) + " curves leave " + kRanges + "they end at the box");
  const std::size_t outside = points - drawn.points.size();
  if (outside == 1) run.warn(std::string("1 point lies outside ") + kRanges + "it is left out");
  if (outside > 1) run.warn(std::to_string(outside) + " points lie outside " + kRanges + "they are left out");
  const AxesBox before = box;
  const auto extend = [&](const Point3& p) {
    box.low = glm::min(box.low, p);
    box.high = glm::max(box.high, p);
  };
  for (const auto& curve : drawn.curves) {
    for (const auto& [a, b] : curve) extend(a), extend(b);
  }
  for (const MarkedPoint& point : drawn.points) extend(point.at);
  return box.low != before.low || box.high != before.high;
}

void add_curves(const DrawnCurves& drawn, const Point3& factor, LineGroups& groups) {
  for (std::size_t i = 0; i < drawn.curves.size(); ++i) {
    const auto number = static_cast<std::uint32_t>(groups.groups.size());
    groups.groups.push_back({"curve", "curve " + std::to_string(i + 1)});
    for (const auto& [a, b] : drawn.curves[i]) groups.lines.push_back({{a * factor, b * factor}, number});
  }
  for (MarkedPoint point : drawn.points) {
    point.at *= factor;
    groups.points.push_back(std::move(point));
  }
}

std::vector<double> band_limits(const SurfaceRequest& request, double low, double high) {
  std::vector<double> limits;
  if (!request.bands || !(low < high)) return limits;
  const double range = high - low, unit = std::pow(10., std::floor(std::log10(range)) - 1);
  for (double* end : {&low, &high}) {
    const double number = std::round(*end / unit) * unit;
    if (std::abs(number - *end) <= kMissedEnd * range) *end = number;
  }
  limits.push_back(low);
  for (const double limit : request.bands->limits) {
    if (low < limit && limit < high) limits.push_back(limit);
  }
  for (unsigned k = 1; k < request.bands->count; ++k) limits.push_back(low + (high - low) * k / request.bands->count);
  limits.push_back(high);
  std::ranges::sort(limits);
  return limits;
}

bool fills_colors(const SurfaceRequest& request) {
  const FillKind kind = request.picture.fill.kind;
  return (kind == FillKind::material || kind == FillKind::shade) && (request.bands || !request.colors.empty());
}

std::array<double, 3> band_color(const SurfaceRequest& request, std::size_t band, std::size_t count) {
  if (!request.colors.empty()) return request.colors[std::min(band, request.colors.size() - 1)];
  const double at = count < 2 ? 0 : static_cast<double>(band) * (kLandColors.size() - 1) / static_cast<double>(count - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), kLandColors.size() - 2);
  std::array<double, 3> color{};
  for (std::size_t k = 0; k < 3; ++k) {
    color[k] = kLandColors[i][k] + (at - static_cast<double>(i)) * (kLandColors[i + 1][k] - kLandColors[i][k]);
    if (fills_colors(request)) color[k] += kWhiteOfTints * (1 - color[k]);
  }
  return color;
}

void color_faces(const SurfaceRequest& request, const std::vector<double>& limits, double z_factor,
                 const std::vector<ColoredSurface>& surfaces, Scene& scene) {
  if (!fills_colors(request)) return;
  const bool by_bands = !limits.empty();
  const std::size_t count = by_bands ? limits.size() - 1 : request.colors.size();
  constexpr std::uint32_t kWall = 0, kWater = 1, kFirst = 2;
  scene.materials = {{"wall", {0.8, 0.8, 0.8}, 1}, {"water", kWaterColor, 1}};
  for (std::size_t i = 0; i < count; ++i) {
    const auto color = by_bands ? band_color(request, i, count) : request.colors[i];
    scene.materials.push_back(
        {(by_bands ? "band " : "surface ") + std::to_string(i + 1), {color[0], color[1], color[2]}, 1});
  }
  scene.face_material.assign(scene.faces.size(), kWall);
  std::size_t k = 0;
  for (const Object& object : scene.objects) {
    for (std::uint32_t face = object.face_begin; face < object.face_end; ++face) {
      while (k + 1 < surfaces.size() && face >= surfaces[k].face_end) ++k;
      const auto corners = scene.faces.contour(face, 0);
      const std::optional<double>& water = surfaces[k].water;
      std::uint32_t& material = scene.face_material[face];
      if (water && std::ranges::all_of(corners, [&](std::uint32_t v) { return scene.vertices[v].z == *water * z_factor; })) {
        material = kWater;
      } else if (!by_bands) {
        material = static_cast<std::uint32_t>(kFirst + k % count);
      } else if (object.name == surfaces[k].name) {  // and not a wall of the surface
        double z = 0;
        for (const std::uint32_t v : corners) z += scene.vertices[v].z / static_cast<double>(corners.size());
        material = static_cast<std::uint32_t>(kFirst + band_of(limits, z / z_factor));
      }
    }
  }
}

void add_surface_groups(const SurfaceRequest& request, const std::vector<double>& limits, double z_factor,
                        const std::vector<std::uint32_t>& face_ends, LineGroups& groups) {
  const bool by_bands = !limits.empty(), by_surface = !by_bands && !request.colors.empty();
  if (fills_colors(request)) return;
  if (!by_bands && !by_surface) return;
  const auto first = static_cast<std::uint32_t>(groups.groups.size());
  const std::size_t count = by_bands ? limits.size() - 1 : face_ends.size();
  for (std::size_t i = 0; i < count; ++i) {
    groups.groups.push_back({.object = (by_bands ? "band " : "surface ") + std::to_string(i + 1),
                             .color = by_bands ? band_color(request, i, count) : request.colors[i % request.colors.size()]});
  }
  const auto inner = std::move(groups.group_of);
  const bool contours_apart = names_heights(request.curves);
  // Contour lines that are distinguished by height keep their own style.
  groups.group_of = [=](const SourceEdge& source, LineClass line_class) -> std::uint32_t {
    if (line_class == LineClass::contour && inner && contours_apart) return inner(source, line_class);
    if (by_bands) {
      const double z = (source.ends[0].z + source.ends[1].z) / 2 / z_factor;
      return first + static_cast<std::uint32_t>(band_of(limits, z));
    }
    if (source.intersection || line_class == LineClass::intersection) return 0;
    const auto surface = std::upper_bound(face_ends.begin(), face_ends.end(), source.faces[0]);
    if (surface == face_ends.end()) return 0;
    return first + static_cast<std::uint32_t>(surface - face_ends.begin());
  };
}

std::vector<LegendEntry> legend_of(const SurfaceRequest& request, const std::vector<std::string>& surfaces,
                                   const std::vector<double>& limits) {
  std::vector<LegendEntry> legend;
  if (!request.legend) return legend;
  const auto named = [&](std::size_t i, const std::string& usual) {
    return i < request.names.size() ? request.names[i] : usual;
  };
  std::size_t number = 0;
  for (std::size_t i = 0; i + 1 < limits.size(); ++i) {
    legend.push_back({named(number++, band_text(limits[i], limits[i + 1])), band_color(request, i, limits.size() - 1),
                      "horizon", "band " + std::to_string(i + 1), fills_colors(request)});
  }
  for (std::size_t i = 0; limits.empty() && i < surfaces.size(); ++i) {
    const bool is_file = i >= request.formulas.size() && i + request.parametric.size() < surfaces.size();
    LegendEntry entry{
        named(number++, is_file ? without_folder(surfaces[i]) : surfaces[i]), {}, "horizon", {}, fills_colors(request)};
    if (!request.colors.empty()) {
      entry.color = request.colors[i % request.colors.size()];
      entry.object = "surface " + std::to_string(i + 1);
    }
    legend.push_back(std::move(entry));
  }
  for (std::size_t i = 0; i < request.space_curves.size(); ++i) {
    const SpaceCurve& c = request.space_curves[i];
    legend.push_back({named(number++, c[0] + ", " + c[1] + ", " + c[2]), {}, "curve", "curve " + std::to_string(i + 1)});
  }
  for (std::size_t i = 0; i < request.line_files.size(); ++i) {
    const std::string object = "curve " + std::to_string(request.space_curves.size() + i + 1);
    legend.push_back({named(number++, without_folder(request.line_files[i])), {}, "curve", object});
  }
  return legend;
}

}  // namespace ligne
