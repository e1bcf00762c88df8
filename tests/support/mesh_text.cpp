#include "support/mesh_text.hpp"

#include "main/script.hpp"
#include "patches/part_scenes.hpp"
#include "patches/patch_scenes.hpp"
#include "scene/readers/reader.hpp"
#include "scene/surfaces/formula/formula_evaluator.hpp"
#include "scene/surfaces/surface_points.hpp"

namespace ligne::test {
namespace {

/// A wire of radius 2 wound about z by four turns, with a radius of 10 and a pitch of 6.
std::vector<Corners> spring(int facets, int sides, bool triangles) {
  const auto at = [&](int u, int v) {
    const double angle = 2 * kPi * v / facets, around = 2 * kPi * (u % sides) / sides;
    const Point3 along = glm::normalize(Point3(-10 * std::sin(angle), 10 * std::cos(angle), 3 / kPi));
    const Point3 out = on_circle(1, angle), up = glm::cross(along, out);
    return on_circle(10, angle, 6.0 * v / facets) + 2.0 * (std::cos(around) * out + std::sin(around) * up);
  };
  std::vector<Corners> polygons;
  add_grid(polygons, sides, 4 * facets, triangles, at);
  Corners first, last;
  for (int u = 0; u < sides; ++u) {
    first.push_back(at(u, 0));
    last.push_back(at(sides - u, 4 * facets));
  }
  polygons.push_back(first);
  polygons.push_back(last);
  return polygons;
}

/// The parts of polygons below a plane at `height` along `up`, closed by polygons in this plane.
std::vector<Corners> below(const std::vector<Corners>& polygons, const Point3& up, double height) {
  using Key = std::array<double, 3>;
  const auto key = [](const Point3& p) { return Key{p.x, p.y, p.z}; };
  const auto over = [&](const Point3& p) { return glm::dot(p, up) - height; };
  std::vector<Corners> kept;
  std::map<Key, Point3> next;  // along the border of the cut
  for (const Corners& polygon : polygons) {
    Corners part, ends(2);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      Point3 a = polygon[i], b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
      const bool is_up = over(a) < over(b);
      if (over(a) <= 0) part.push_back(a);
      if ((over(a) < 0) == (over(b) < 0)) continue;
      if (is_up) std::swap(a, b);  // both faces of an edge get one corner
      ends[is_up] = a + over(a) / (over(a) - over(b)) * (b - a);
      part.push_back(ends[is_up]);
    }
    if (part.size() < 3) continue;
    kept.push_back(part);
    if (ends[0] != ends[1]) next[key(ends[0])] = ends[1];
  }
  while (!next.empty()) {
    Corners cut;
    for (auto at = next.begin(); at != next.end(); at = next.find(key(cut.back()))) {
      cut.push_back(at->second);
      next.erase(at);
    }
    kept.push_back(cut);
  }
  return kept;
}

constexpr std::array<std::string_view, 2> kGridVariables{"u", "v"};
constexpr std::array<std::string_view, 1> kFanVariables{"k"};
constexpr std::array<std::string_view, 3> kPlaceVariables{"x", "y", "z"};

std::vector<Corners> shape_of(const std::vector<std::string>& words) {
  const std::string& name = words.at(0);
  const auto number = [&](std::size_t i) { return number_of(words.at(i)); };
  const auto whole = [&](std::size_t i) { return static_cast<int>(number(i)); };
  const bool triangles = words.back() == "triangles";
  if (name == "bored-plate") return bored_plate(number(1), number(2));
  if (name == "ball") return ball();
  if (name == "rounded-box") return rounded_box({number(1), number(2), number(3)}, whole(4));
  if (name == "csg-plug") return csg_plug(number(1), number(2), whole(3));
  if (name == "spring") return spring(whole(1), whole(2), triangles);
  if (name == "turned-body") {  // facets, and circles as RADIUS,Z
    std::vector<Point2> circles;
    for (std::size_t i = 2; i < words.size() - triangles; ++i) circles.push_back(Point2(point_of(words[i] + ",0")));
    return turned_body(whole(1), circles, triangles);
  }
  throw std::invalid_argument(name + " is no shape");
}

}  // namespace

MeshText mesh_of(const std::string& lines) {
  MeshText mesh;
  for (const std::string& line : parts_of(lines, '\n'))
    mesh.add(line.substr(std::min(line.find_first_not_of(' '), line.size())));
  return mesh;
}

std::string repeated(const std::string& text) {
  std::string all;
  std::size_t at = 0;
  for (std::size_t begin; (begin = text.find("[[", at)) != text.npos;) {
    all.append(text, at, begin - at);
    const std::size_t star = text.find('*', begin);
    int depth = 1;
    for (at = star; depth > 0; ++at) depth += text.compare(at, 2, "[[") == 0 ? 1 : text.compare(at, 2, "]]") == 0 ? -1 : 0;
    std::vector<std::string> parts = parts_of(text.substr(star + 1, at++ - star - 2), '@');
    std::vector<std::function<Point3(std::initializer_list<double>)>> formulas(parts.size());
    for (std::size_t i = 1; i < parts.size(); i += 2) formulas[i] = place_formula(parts[i] + ";0;0", kFanVariables);
    const double count = value_of(text.substr(begin + 2, star - begin - 2));
    for (double k = 0; k < count; ++k) {
      std::string one;
      for (std::size_t i = 0; i < parts.size(); ++i) one += formulas[i] ? as_text(formulas[i]({k}).x) : parts[i];
      all += one.find("[[") == one.npos ? one : repeated(one);
    }
  }
  return all.append(text, at);
}

double number_of(const std::string& formula) { return constant_of(formula); }

Point3 point_of(const std::string& text) {
  const std::vector<std::string> parts = parts_of(text, ',');
  return {number_of(parts.at(0)), number_of(parts.at(1)), number_of(parts.at(2))};
}

std::function<Point3(std::initializer_list<double>)> place_formula(const std::string& text,
                                                                   std::span<const std::string_view> variables) {
  std::vector<std::shared_ptr<FormulaEvaluator>> formulas;
  for (const std::string& part : parts_of(text, ';'))
    formulas.push_back(std::make_shared<FormulaEvaluator>(prepare_formula(part, {variables})));
  if (formulas.size() != 3) throw std::invalid_argument("three formulas: " + text);
  return [formulas](std::initializer_list<double> values) {
    const std::span<const double> all(values.begin(), values.size());
    return Point3((*formulas[0])(all), (*formulas[1])(all), (*formulas[2])(all));
  };
}

void MeshText::add_grid(const std::string& text) {
  const std::size_t colon = text.find(':');
  const std::vector<std::string> words = words_of(text.substr(0, colon));
  const auto is = [&](const char* word) { return std::ranges::find(words, word) != words.end(); };
  const int columns = static_cast<int>(number_of(words.at(0))), rows = static_cast<int>(number_of(words.at(2)));
  const bool round = is("round"), ring = is("ring");
  const auto place = place_formula(text.substr(colon + 1), kGridVariables);
  const auto at = [&](int u, int v) { return place({double(round ? u % columns : u), double(ring ? v % rows : v)}); };
  ligne::test::add_grid(objects_.back(), columns, rows, is("triangles"), at);
  if (!is("capped")) return;
  Corners first, last;
  for (int u = 0; u < columns; ++u) {
    first.push_back(at(columns - 1 - u, 0));
    last.push_back(at(u, rows));
  }
  objects_.back().push_back(first);
  objects_.back().push_back(last);
}

void MeshText::add_fan(const std::string& text) {
  const std::size_t colon = text.find(':');
  const auto place = place_formula(text.substr(colon + 1), kFanVariables);
  Corners corners;
  for (int k = 0; k < number_of(text.substr(0, colon)); ++k) corners.push_back(place({double(k)}));
  objects_.back().push_back(corners);
}

void MeshText::add_strip(const std::vector<std::string>& words) {
  const auto slash = std::ranges::find(words, "/");
  Point3 at(0, 0, 0);
  double angle = 0;
  for (auto length = words.begin(), turn = slash + 1; length != slash; ++length) {
    const Point3 next = at + number_of(*length) * Point3(std::cos(angle), 0, std::sin(angle));
    objects_.back().push_back({at, next, next + Point3(0, 10, 0), at + Point3(0, 10, 0)});
    at = next;
    if (turn != words.end()) angle += number_of(*turn++) * kPi / 180;
  }
}

void MeshText::add_box(const Point3& least, const Point3& size) {
  constexpr int kSides[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& side : kSides) {
    Corners& corners = objects_.back().emplace_back();
    for (const int i : side) corners.push_back(least + size * Point3(i & 1, i >> 1 & 1, i >> 2));
  }
}

void MeshText::change(const std::string& verb, const std::vector<std::string>& words) {
  std::vector<Corners>& polygons = objects_.back();
  const auto number = [&] { return static_cast<std::size_t>(number_of(words.at(0))); };
  if (verb == "outward") {
    polygons = outward(std::move(polygons));
  } else if (verb == "reversed") {
    for (Corners& polygon : polygons) std::ranges::reverse(polygon);
  } else if (verb == "shuffled") {
    std::mt19937 random(static_cast<unsigned>(number()));
    std::ranges::shuffle(polygons, random);
  } else if (verb == "backwards") {
    std::ranges::reverse(polygons);
  } else if (verb == "without" && words.at(0) == "doubled") {
    std::erase_if(polygons, [](const Corners& c) {
      for (std::size_t i = 0; i < c.size(); ++i)
        if (glm::distance(c[i], c[(i + 1) % c.size()]) < 1e-9) return true;
      return false;
    });
  } else if (verb == "without") {
    std::size_t i = 0;
    std::erase_if(polygons, [&](const Corners&) { return i++ % 12 == number(); });
  } else if (verb == "below") {
    up_ = glm::normalize(point_of(words.at(0)));
    height_ = number_of(words.at(1));
    polygons = ligne::test::below(polygons, up_, height_);
  } else if (verb == "exact") {
    is_exact_ = true;
  } else if (verb == "precision") {
    precision_ = number_of(words.at(0));
  } else {
    throw std::invalid_argument(verb + " is nothing to do with a mesh");
  }
}

void MeshText::add(const std::string& line) {
  std::string_view rest = line;
  const std::string verb = take_word(rest), text(rest);
  const std::vector<std::string> words = words_of(text);
  if (verb == "grid") {
    add_grid(text);
  } else if (verb == "fan") {
    add_fan(text);
  } else if (verb == "strip") {
    add_strip(words);
  } else if (verb == "face" || verb == "plate") {
    if (verb == "plate" && !objects_.back().empty()) objects_.emplace_back();
    Corners corners;
    for (const std::string& word : words) corners.push_back(point_of(word));
    objects_.back().push_back(corners);
  } else if (verb == "box") {
    add_box(point_of(words.at(0)), point_of(words.at(1)));
  } else if (verb == "shape") {
    for (Corners& polygon : shape_of(words)) objects_.back().push_back(std::move(polygon));
  } else if (verb == "object") {
    if (!objects_.back().empty()) objects_.emplace_back();
  } else if (verb == "copy") {
    const std::vector<Corners> copied = objects_.at(std::stoul(text));
    objects_.back().insert(objects_.back().end(), copied.begin(), copied.end());
  } else if (verb == "map:") {
    const auto place = place_formula(text, kPlaceVariables);
    for (Corners& polygon : objects_.back())
      for (Point3& p : polygon) p = place({p.x, p.y, p.z});
  } else {
    change(verb, words);
  }
}

std::string MeshText::obj() const {
  std::string all;
  for (std::size_t i = 0; i < objects_.size(); ++i) all += "o part" + std::to_string(i) + '\n' + obj_of(objects_[i]);
  return all;
}

Scene MeshText::scene() const {
  Scene scene;
  for (const std::vector<Corners>& polygons : objects_) {
    Scene one = scene_of(polygons, is_exact_);
    if (precision_ > 0) one.objects.front().precision = precision_;
    append_scene(scene, std::move(one));
  }
  return scene;
}

}  // namespace ligne::test
