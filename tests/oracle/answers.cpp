#include "oracle/answers.hpp"

#include <unistd.h>
#include <type_traits>

namespace oracle {
namespace {

namespace fs = std::filesystem;

/// FNV-1a from another beginning.
std::uint64_t hash(std::string_view bytes, std::uint64_t value) {
  for (const char c : bytes) value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return value;
}

constexpr std::uint64_t kFirst = 0xcbf29ce484222325u, kSecond = 0x9e3779b97f4a7c15u;

/// Appends values as their bytes. Structures are written member by member: padding has no value.
class Bytes {
 public:
  template <class T>
  void add(const T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void add(const Point2& p) { add(p.x), add(p.y); }
  void add(const Point3& p) { add(p.x), add(p.y), add(p.z); }
  template <class T>
  void add(const std::vector<T>& values) {
    add(values.size());
    for (const T& value : values) add(value);
  }
  void add(const Interval& i) {
    add(i.t0), add(i.t1), add(i.from), add(i.to), add(i.answer), add(i.exactly_hidden), add(i.at_border);
  }
  void add(const Edge& e) { add(e.object), add(e.a), add(e.b), add(e.faces), add(e.edge_class); }
  void add(const Intersection& x) {
    add(x.face0), add(x.face1), add(x.a), add(x.b), add(x.page_a), add(x.page_b), add(x.proper), add(x.vague);
  }

  std::string text;
};

/// The reverse. Bytes that end too early make it fail.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}
  bool is_whole() const { return ok_ && rest_.empty(); }

  template <class T>
  void get(T& value) {
    static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
    if (rest_.size() < sizeof value) {
      ok_ = false;
      return;
    }
    std::memcpy(&value, rest_.data(), sizeof value);
    rest_.remove_prefix(sizeof value);
  }
  void get(Point2& p) { get(p.x), get(p.y); }
  void get(Point3& p) { get(p.x), get(p.y), get(p.z); }
  template <class T>
  void get(std::vector<T>& values) {
    std::size_t size = 0;
    get(size);
    if (size > rest_.size()) ok_ = false;
    if (ok_) values.resize(size);
    for (T& value : values) get(value);
  }
  void get(Interval& i) {
    get(i.t0), get(i.t1), get(i.from), get(i.to), get(i.answer), get(i.exactly_hidden), get(i.at_border);
  }
  void get(Edge& e) { get(e.object), get(e.a), get(e.b), get(e.faces), get(e.edge_class); }
  void get(Intersection& x) {
    get(x.face0), get(x.face1), get(x.a), get(x.b), get(x.page_a), get(x.page_b), get(x.proper), get(x.vague);
  }

 private:
  std::string_view rest_;
  bool ok_ = true;
};

}  // namespace

Answers answers_of(const Oracle& oracle) {
  Answers answers;
  answers.edges.assign(oracle.edges().begin(), oracle.edges().end());
  answers.intersections.assign(oracle.intersections().begin(), oracle.intersections().end());
  for (std::size_t i = 0; i < answers.edges.size(); ++i) answers.edge_intervals.push_back(oracle.visible_intervals(i));
  for (std::size_t i = 0; i < answers.intersections.size(); ++i)
    answers.intersection_intervals.push_back(oracle.intersection_intervals(i));
  return answers;
}

std::string answers_name(const ligne::Scene& scene, const View& view, double crease_degrees, Glass glass) {
  Bytes key;
  key.text = LIGNE_ORACLE_SOURCE;
  key.add(scene.vertices);
  key.add(scene.corner_flags);
  for (const ligne::Object& o : scene.objects) key.add(o.face_begin), key.add(o.face_end), key.add(o.precision);
  for (std::uint32_t f = 0; f < scene.faces.size(); ++f) {
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      key.add(scene.faces.contour(f, c).size());
      for (const std::uint32_t v : scene.faces.contour(f, c)) key.add(v);
    }
    key.add(scene.face_material.empty() ? 1.0 : scene.materials[scene.face_material[f]].opacity);
  }
  key.add(view.perspective);
  for (const Point3& p : {view.direction, view.eye, view.target, view.up}) key.add(p);
  key.add(view.scale);
  for (const Point2& p : {view.offset, view.window.min, view.window.max}) key.add(p);
  key.add(crease_degrees);
  key.add(glass);
  char name[40];
  std::snprintf(name, sizeof name, "%016llx%016llx", static_cast<unsigned long long>(hash(key.text, kFirst)),
                static_cast<unsigned long long>(hash(key.text, kSecond)));
  return name;
}

bool read_answers(const fs::path& file, Answers& answers) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  std::uint64_t sum = 0;
  if (bytes.size() < sizeof sum) return false;
  const std::string_view body = std::string_view(bytes).substr(0, bytes.size() - sizeof sum);
  std::memcpy(&sum, bytes.data() + body.size(), sizeof sum);
  if (sum != hash(body, kFirst)) return false;
  Reader reader(body);
  reader.get(answers.edges);
  reader.get(answers.edge_intervals);
  reader.get(answers.intersections);
  reader.get(answers.intersection_intervals);
  return reader.is_whole();
}

void write_answers(const fs::path& file, const Answers& answers) {
  Bytes bytes;
  bytes.add(answers.edges);
  bytes.add(answers.edge_intervals);
  bytes.add(answers.intersections);
  bytes.add(answers.intersection_intervals);
  bytes.add(hash(bytes.text, kFirst));
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  const fs::path beside = file.string() + "." + std::to_string(getpid());
  std::ofstream out(beside, std::ios::binary);
  out << bytes.text;
  out.close();
  if (out) fs::rename(beside, file, error);
  if (!out || error) fs::remove(beside, error);
}

Answers answers_of(const ligne::Scene& scene, const View& view, double crease_degrees, Glass glass) {
  const char* const folder = std::getenv("LIGNE_ORACLE_CACHE");
  if (!folder) return answers_of(Oracle(scene, view, crease_degrees, glass));
  const fs::path file = fs::path(folder) / answers_name(scene, view, crease_degrees, glass);
  Answers answers;
  if (read_answers(file, answers)) return answers;
  answers = answers_of(Oracle(scene, view, crease_degrees, glass));
  write_answers(file, answers);
  return answers;
}

}  // namespace oracle
