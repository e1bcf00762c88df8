#include "picture/pages/frames.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "files/message_text.hpp"
#include "picture/errors.hpp"
#include "picture/products.hpp"

namespace ligne {
namespace {

constexpr std::string_view kDepthOfTree = "depth of the tree", kOfListBefore = "elements of the previous view";

/// Adds values of equal names. For the depths of one tree, takes the maximum, since their sum has no meaning.
template <class Value>
void add(std::vector<std::pair<std::string, Value>>& sums, const std::vector<std::pair<std::string, Value>>& values) {
  for (const auto& [name, value] : values) {
    const auto sum = std::ranges::find(sums, name, &std::pair<std::string, Value>::first);
    if (sum == sums.end()) {
      sums.emplace_back(name, value);
    } else if (name == kDepthOfTree) {
      sum->second = std::max(sum->second, value);
    } else {
      sum->second += value;
    }
  }
}

void add(Statistics& sums, const Statistics& values) {
  add(sums.counts, values.counts);
  add(sums.seconds, values.seconds);
}

void add(RunReport& sums, const RunReport& frame) {
  sums.method = frame.method;
  add(sums.study, frame.study);
  add(sums.clear, frame.clear);
  add(sums.stages, frame.stages);
  add(sums.stages.processor_seconds, frame.stages.processor_seconds);
  for (const RunWarning& warning : frame.warnings) {
    const bool known = std::ranges::any_of(
        sums.warnings, [&](const RunWarning& w) { return w.place == warning.place && w.text == warning.text; });
    if (!known) sums.warnings.push_back(warning);
  }
}

/// Whether the view began with the list of the previous view.
bool took_list_over(const Statistics& study) {
  return std::ranges::any_of(study.counts, [](const auto& c) { return c.first == kOfListBefore && c.second > 0; });
}

/// A point of a polyline and the direction of the polyline there.
struct PathPoint {
  Point3 at, direction;
};

/// Returns the point at that fraction of the length of a polyline, which has at least two points.
PathPoint point_on_path(const std::vector<Point3>& way, double share) {
  double whole = 0;
  for (std::size_t i = 1; i < way.size(); ++i) whole += glm::distance(way[i - 1], way[i]);
  double left = share * whole;
  PathPoint place{way.front(), {0, 0, 0}};
  for (std::size_t i = 1; i < way.size(); ++i) {
    const double length = glm::distance(way[i - 1], way[i]);
    if (!(length > 0)) continue;
    const double part = std::min(left / length, 1.0);
    place = {way[i - 1] + part * (way[i] - way[i - 1]), (way[i] - way[i - 1]) / length};
    left -= length;
    if (left <= 0) break;
  }
  return place;
}

void set_view(ViewRequest& view, const FrameRequest& frames, unsigned i) {
  if (frames.eyes.empty()) {
    view.turn_degrees = frames.turn_degrees * i / frames.count;
    return;
  }
  const PathPoint place = point_on_path(frames.eyes, frames.count > 1 ? double(i) / (frames.count - 1) : 0);
  view.eye = place.at;
  if (frames.looks_ahead) view.target = place.at + place.direction;
}

/// The field of view on the plane of the target, at 1 mm per model unit as in projected_extent().
Rect field_of_view(const Camera& camera) {
  const double half_height = std::tan(glm::radians(camera.fov_degrees / 2)) * camera.target_distance;
  const Point2 half{half_height * camera.aspect, half_height};
  return {-half, half};
}

/// The extent that contains the pictures of all frames.
Rect extent_of_all(const Scene& scene, PictureRequest request, const FrameRequest& frames) {
  Rect all;
  for (unsigned i = 0; i < frames.count; ++i) {
    set_view(request.view, frames, i);
    const Rect extent = projected_extent(scene, camera_of(request.view, scene));
    if (extent.empty()) continue;
    all.extend(extent.min);
    all.extend(extent.max);
  }
  return all;
}

/// A placeholder for a number: from a percent sign to its letter.
struct NumberPlace {
  std::size_t begin = 0, end = 0;
  std::size_t width = 0;  ///< width to which the number is filled with zeros
};

constexpr std::size_t kWidestNumber = 9;

/// Finds the first placeholder from position `from` on.
std::optional<NumberPlace> find_place(const std::string& name, std::size_t from, char letter) {
  for (std::size_t i = name.find('%', from); i != std::string::npos; i = name.find('%', i + 1)) {
    std::size_t k = i + 1;
    std::size_t width = 0;
    if (k < name.size() && name[k] == '0') ++k;
    if (k < name.size() && name[k] >= '1' && name[k] <= '9') width = static_cast<std::size_t>(name[k++] - '0');
    if (k < name.size() && name[k] == letter) return NumberPlace{i, k + 1, std::min(width, kWidestNumber)};
  }
  return std::nullopt;
}

}  // namespace

void draw_frames(const Scene& scene, PictureRequest request, const FrameRequest& frames, RunReport& run,
                 std::optional<Topology> topology, const std::function<void(Picture)>& take) {
  check(request);
  const std::string asks = std::to_string(scene.faces.size()) + " faces";
  const bool moves = !frames.eyes.empty();
  if (!moves)
    request.page.extent = timed(run.stages, {"frames", asks}, [&] { return extent_of_all(scene, request, frames); });
  if (!topology) topology = timed(run.stages, {"topology", asks}, [&] { return build_topology(scene); });
  const Method& method = method_of(request);
  if (method.traits().compiles && !request.compiled) {
    request.compiled = timed(run.stages, {"compile", asks}, [&] { return method.compile(scene, request.lines.settings); });
  }
  std::optional<PdfDocument> document;
  if (frames.as_pages) document.emplace();
  request.keep = Keep::for_next_view;
  const std::function<void(double)> progress = request.progress;
  unsigned lists_taken_over = 0;
  for (unsigned i = 0; i < frames.count; ++i) {
    set_view(request.view, frames, i);
    if (moves) request.page.extent = field_of_view(camera_of(request.view, scene));
    if (progress) request.progress = [&, i](double done) { progress((i + done) / frames.count); };
    RunReport frame;
    const DrawnScene drawn = draw_lines(scene, request, frame, {}, topology);
    request.earlier = drawn.visibility().result.kept;
    Picture picture = drawn.write(frame, document ? &*document : nullptr);
    add(run, frame);
    lists_taken_over += took_list_over(frame.study);
    if (!document) take(std::move(picture));
  }
  if (document) take({document->finish()});
  run.study.count("frames", frames.count);
  run.study.count("of these, with the topology of the first", frames.count - 1);
  if (request.compiled) run.study.count("of these, with the tree of the first", frames.count - 1);
  if (lists_taken_over > 0) run.study.count("of these, with the list of the previous one", lists_taken_over);
}

std::string name_of(const std::string& name, const PicturePart& part) {
  return with_number(with_number(name, part.number), part.pen, 'p');
}

bool has_number_place(const std::string& name, char letter) { return find_place(name, 0, letter).has_value(); }

std::string with_number(const std::string& name, unsigned number, char letter) {
  const std::optional<NumberPlace> place = find_place(name, 0, letter);
  if (!place) return name;
  std::string digits = std::to_string(number);
  if (digits.size() < place->width) digits.insert(0, place->width - digits.size(), '0');
  return name.substr(0, place->begin) + digits + name.substr(place->end);
}

std::vector<std::string> numbered_names(const std::string& name, unsigned count) {
  if (count == 1) return {name};
  const std::optional<NumberPlace> place = find_place(name, 0, 'd');
  if (!place) {
    throw RequestError("output", shown(name) + " has no frame number, such as name%03d" + (name == "-" ? ".svg" : "") +
                                     "; only a PDF holds them all");
  }
  if (find_place(name, place->end, 'd')) throw RequestError("output", shown(name) + " has two frame numbers");
  std::vector<std::string> names;
  for (unsigned i = 1; i <= count; ++i) names.push_back(with_number(name, i, 'd'));
  return names;
}

}  // namespace ligne
