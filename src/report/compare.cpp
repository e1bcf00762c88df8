#include "report/compare.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <glm/geometric.hpp>

#include "base/stop.hpp"
#include "files/message_text.hpp"
#include "picture/choice/method_choice.hpp"
#include "picture/draw_scene.hpp"
#include "picture/drawn_scene.hpp"
#include "picture/errors.hpp"
#include "picture/models/memory.hpp"
#include "picture/parse/parse.hpp"
#include "picture/parse/parse_options.hpp"
#include "visibility/methods.hpp"
#include "visibility/registry.hpp"

namespace ligne {
namespace {

/// The kinds of operations of the methods' counts. Counts that include another count are not listed.
struct KindOfCount {
  std::string_view count;
  OperationKind kind;
};
constexpr KindOfCount kKindsOfCounts[] = {
    {"line-facet tests", OperationKind::line_tests},
    {"drawing: line-facet tests", OperationKind::line_tests},
    {"pairs compared", OperationKind::face_tests},
    {"pairs that overlap on the page", OperationKind::face_tests},
    {"clips", OperationKind::face_tests},
    {"drawing: facet-facet tests", OperationKind::face_tests},
    {"understanding: pairs of faces compared", OperationKind::face_tests},
    {"depths compared", OperationKind::depths},
    {"resolved by their depths", OperationKind::depths},
    {"understanding: depths computed", OperationKind::depths},
    {"span method: depth tests", OperationKind::depths},
    {"span method: comparisons", OperationKind::abscissas},
    {"grid leaves", OperationKind::parts},
    {"windows studied", OperationKind::parts},
    {"bands", OperationKind::parts},
    {"final elements", OperationKind::parts},
    {"pieces", OperationKind::parts},
    {"regions", OperationKind::parts},
    {"faces painted", OperationKind::parts},
    {"leaves visited", OperationKind::accesses},
    {"edges examined", OperationKind::accesses},
    {"analysis: faces examined", OperationKind::accesses},
};

/// Words of memory for each vertex and each face, [Boulle1980] 2.6, figure 2.88.
struct WordsOfMemory {
  std::string_view method;
  std::uint64_t by_vertex, by_face;
};
constexpr WordsOfMemory kThesisWords[] = {
    {"warnock", 3, 37}, {"watkins", 3, 33}, {"atherton-weiler", 5, 40}, {"newell", 3, 40}};

std::optional<std::uint64_t> thesis_words(const Method& method, const Scene& scene) {
  for (const WordsOfMemory& words : kThesisWords) {
    if (words.method == method.traits().name) {
      return words.by_vertex * scene.vertices.size() + words.by_face * scene.faces.size();
    }
  }
  return {};
}

std::optional<std::uint64_t> count_of(const Statistics& statistics, std::string_view name) {
  for (const auto& [known, n] : statistics.counts) {
    if (known == name) return n;
  }
  return {};
}

/// Returns the accuracy of a method's drawing, in mm, if the method or an option (lines, windows) limits it.
std::optional<double> resolution_of(const ComparedMethod& compared, const View& view, const Statistics& statistics) {
  const MethodTraits& traits = compared.method->traits();
  const double height = view.window.height();
  if (!traits.exact) {
    const auto rows = count_of(statistics, "rows");
    return rows && *rows > 0 ? zbuffer_tolerance_mm(height, static_cast<unsigned>(*rows)) : traits.tolerance_mm;
  }
  for (const MethodParameter& p : traits.parameters) {
    const auto value = compared.settings.count(p.name);
    if (!value) continue;  // a word instead of a number means no limit
    if (p.name == "resolution") return warnock_tolerance_mm(view.window, *value);
    if (p.name == "lines") return height / *value;
  }
  return {};
}

/// Stops work that takes too long, or whose caller is stopped.
class TimeLimit {
 public:
  explicit TimeLimit(double seconds) : whole_(StopScope::current()), watch_([this, seconds] { watch(seconds); }) {}
  ~TimeLimit() {
    {
      const std::lock_guard lock(mutex_);
      done_ = true;
    }
    over_.notify_all();
    watch_.join();
  }
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;

  const std::atomic<bool>& stop() const { return stop_; }

 private:
  using Clock = std::chrono::steady_clock;
  /// Interval of checks for a stop. Adjustable: short for a user who waits, long compared to the time of a check.
  static constexpr std::chrono::milliseconds kLook{50};

  void watch(double seconds) {
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    std::unique_lock lock(mutex_);
    while (!stop_) {
      if (over_.wait_until(lock, std::min(end, Clock::now() + kLook), [this] { return done_; })) return;
      stop_ = Clock::now() >= end || (whole_ && *whole_);
    }
  }

  const std::atomic<bool>* whole_;  ///< stop flag of the calling work
  std::atomic<bool> stop_{false};
  std::mutex mutex_;
  std::condition_variable over_;
  bool done_ = false;
  std::thread watch_;  // the last member: its thread uses the others
};

bool has_parameter(const Method& method, std::string_view name) {
  const auto own = method.traits().parameters;
  return std::any_of(own.begin(), own.end(), [&](const MethodParameter& p) { return p.name == name; });
}

void measure(const StrokeModel& model, MethodOutcome& outcome) {
  for (const Stroke& s : model.strokes) {
    const double mm = glm::length(model.lattice.to_mm(s.to) - model.lattice.to_mm(s.from));
    (s.visible ? outcome.visible_mm : outcome.hidden_mm) += mm;
    outcome.strokes += s.visible;
  }
}

/// Draws the scene by one method, and returns its page.
void draw_by(const ComparedMethod& compared, const Scene& scene, const Topology& topology, PictureRequest picture,
             MethodOutcome& outcome, Page& page) {
  picture.lines.method = compared.method;
  picture.lines.settings = compared.settings;
  RunReport run;
  const DrawnScene drawn = draw_lines(scene, std::move(picture), run, {}, topology);
  const VisibilityResult& result = drawn.visibility().result;
  outcome.drawing = timed(run.stages, "join", [&] { return drawn.compose(run); });
  outcome.model = *result.strokes;
  outcome.unsupported_reason = result.unsupported_reason;
  outcome.study = run.study;
  outcome.stages = run.stages;
  outcome.operations = operations_of(run.study);
  outcome.resolution_mm = resolution_of(compared, drawn.prepared().view(), run.study);
  measure(outcome.model, outcome);
  page = drawn.prepared().around.placement.page;
}

MethodOutcome outcome_of(const ComparedMethod& compared, const Scene& scene, const Topology& topology,
                         const PictureRequest& picture, double limit_seconds, Page& page) {
  MethodOutcome outcome{.method = compared.method, .thesis_words = thesis_words(*compared.method, scene)};
  const PeakMemory memory;
  try {
    const TimeLimit limit(limit_seconds);
    run_until(limit.stop(), [&] { draw_by(compared, scene, topology, picture, outcome, page); });
  } catch (const Stopped&) {
    check_stop();  // the caller was stopped, not this limit
    outcome.failure = "ended after " + shortest(limit_seconds) + " s";
  } catch (const std::exception& e) {
    outcome.failure = e.what();
  }
  outcome.peak_bytes = memory.bytes();
  return outcome;
}

void compare_drawings(MethodComparison& comparison) {
  std::vector<MethodOutcome>& methods = comparison.methods;
  for (std::size_t i = 0; i < methods.size() && !comparison.reference; ++i) {
    if (methods[i].drawn() && methods[i].exact() && methods[i].unsupported_reason.empty()) comparison.reference = i;
  }
  comparison.differences_mm.assign(methods.size(), std::vector<std::optional<double>>(methods.size()));
  for (std::size_t i = 0; i < methods.size(); ++i) {
    for (std::size_t k = i; k < methods.size(); ++k) {
      if (!methods[i].drawn() || !methods[k].drawn()) continue;
      StrokeDifference difference;
      if (i != k) difference = difference_of(methods[i].model, methods[k].model);
      comparison.differences_mm[i][k] = comparison.differences_mm[k][i] = difference.length_mm;
      if (comparison.reference == i)
        methods[k].from_reference = std::move(difference);
      else if (comparison.reference == k) {
        std::swap(difference.only_first, difference.only_second);
        methods[i].from_reference = std::move(difference);
      }
    }
  }
}

/// Finds the traits of the scene and the choice of --method auto. Prepares the scene as for every method.
void look_at_scene(const Scene& scene, const Topology& topology, PictureRequest picture, MethodComparison& comparison) {
  picture.lines.method = nullptr;
  RunReport run;
  const PreparedScene prepared = prepare(scene, picture, {}, run, topology);
  comparison.page = prepared.around.placement.page;
  comparison.traits =
      scene_traits(prepared.scene, prepared.topology, prepared.projected, picture.view.up_axis.value_or(scene.up_axis));
  const ChoiceRule& rule = choice_rules()[choose_rule(facts_of(picture, prepared.projected))];
  comparison.chosen = rule.method;
  comparison.why_chosen = rule.when;
}

}  // namespace

std::vector<const Method*> parse_methods(const std::string& text) {
  std::vector<const Method*> methods;
  for (const std::string& name : parse_names(text)) {
    const Method* method = parse_method(name);
    if (!method) throw std::invalid_argument("auto stands for one of the other methods: name that one");
    if (std::find(methods.begin(), methods.end(), method) != methods.end()) {
      throw std::invalid_argument(shown(name, '"') + " is given twice");
    }
    methods.push_back(method);
  }
  return methods;
}

std::vector<ComparedMethod> compared_methods(std::span<const Method* const> methods,
                                             std::span<const std::pair<std::string, std::string>> parameters) {
  std::vector<ComparedMethod> compared;
  for (const Method* method : all_methods()) {
    const bool wanted = methods.empty() ? (method->traits().products & kStrokes) != 0
                                        : std::find(methods.begin(), methods.end(), method) != methods.end();
    if (wanted) compared.push_back({method});
  }
  for (const auto& [name, text] : parameters) {
    bool known = false;
    for (ComparedMethod& c : compared) {
      if (!has_parameter(*c.method, name)) continue;
      set_parameter(c.settings, *c.method, name, text);
      known = true;
    }
    if (!known) throw SettingError(name, "no method has this option");
  }
  return compared;
}

OperationCounts operations_of(const Statistics& statistics) {
  OperationCounts operations;
  for (const auto& [name, n] : statistics.counts) {
    for (const KindOfCount& known : kKindsOfCounts) {
      if (known.count != name) continue;
      auto& sum = operations[static_cast<std::size_t>(known.kind)];
      sum = sum.value_or(0) + n;
    }
  }
  return operations;
}

double MethodOutcome::seconds() const {
  double sum = 0;
  for (const auto& [name, value] : stages.seconds) sum += value;
  return sum;
}

MethodComparison compare_methods(const Scene& scene, const Topology& topology, const CompareRequest& request) {
  check(request.picture);
  MethodComparison comparison;
  look_at_scene(scene, topology, request.picture, comparison);
  const double parts = static_cast<double>(request.methods.size()) + 1;  // the last part is the comparison
  for (std::size_t i = 0; i < request.methods.size(); ++i) {
    PictureRequest picture = request.picture;
    const auto at = [&request, parts, i](double fraction) { request.progress((static_cast<double>(i) + fraction) / parts); };
    if (request.progress) picture.progress = at;
    comparison.methods.push_back(
        outcome_of(request.methods[i], scene, topology, picture, request.limit_seconds, comparison.page));
    if (request.progress) at(1);
  }
  compare_drawings(comparison);
  if (request.progress) request.progress(1);
  return comparison;
}

}  // namespace ligne
