#pragma once
/// Compares several methods on one scene.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "drawing/drawing.hpp"
#include "picture/choice/scene_traits.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "report/stroke_difference.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "visibility/method.hpp"

namespace ligne {

/// Kinds of operations. Every method counts operations of some of these kinds under its own names.
enum class OperationKind : std::uint8_t { line_tests, face_tests, depths, abscissas, parts, accesses };
inline constexpr std::size_t kOperationKinds = 6;
struct OperationName {
  std::string_view key;    ///< for programs
  std::string_view words;  ///< for people
};
inline constexpr std::array<OperationName, kOperationKinds> kOperationNames{{
    {"line_tests", "lines against faces"},
    {"face_tests", "faces against faces"},
    {"depths", "depths compared"},
    {"abscissas", "abscissas compared"},
    {"parts", "cells, windows, nodes, pieces"},
    {"accesses", "list entries visited"},
}};

/// Number of operations by kind; none if the method does not count that kind.
using OperationCounts = std::array<std::optional<std::uint64_t>, kOperationKinds>;
OperationCounts operations_of(const Statistics& statistics);

/// A method, and the values of its own options.
struct ComparedMethod {
  const Method* method = nullptr;
  MethodSettings settings{};
};

/// Parses "NAME,...", distinct methods except auto. Throws std::invalid_argument, as in parse.hpp.
std::vector<const Method*> parse_methods(const std::string& text);

/// Returns the methods in the order of the registry; all that return lines if `methods` is empty. `parameters` are
/// names and values of options; each method gets those that it has. Throws RequestError for an option that no method
/// has, or that does not accept the value.
std::vector<ComparedMethod> compared_methods(std::span<const Method* const> methods,
                                             std::span<const std::pair<std::string, std::string>> parameters);

/// Largest time limit, in seconds.
inline constexpr double kMostLimitSeconds = 1e6;

/// The result of a method.
struct MethodOutcome {
  const Method* method = nullptr;
  std::string failure{};                  ///< reason why there is no drawing; empty if there is one
  std::string unsupported_reason{};       ///< why its drawing may be wrong, see VisibilityResult::unsupported_reason
  std::optional<double> resolution_mm{};  ///< largest error of a line, if the method or its options limit the accuracy
  Statistics study{};                     ///< its own counts, and the times of its phases
  StageTimes stages{};                    ///< of the drawing
  OperationCounts operations{};
  std::optional<double> peak_bytes{};           ///< memory in addition to that of the scene (memory.hpp)
  std::optional<std::uint64_t> thesis_words{};  ///< words of memory by the formula of [Boulle1980] 2.6
  std::size_t strokes = 0;                      ///< visible
  double visible_mm = 0, hidden_mm = 0;
  StrokeModel model{};
  Drawing drawing{};
  StrokeDifference from_reference{};  ///< only_first: missing in this drawing; only_second: missing in the reference

  bool drawn() const { return failure.empty(); }
  bool exact() const { return !resolution_mm; }
  double seconds() const;  ///< of all stages
};

struct MethodComparison {
  SceneTraits traits;
  Page page;
  std::vector<MethodOutcome> methods;
  /// The first exact method whose drawing is not in doubt; none if there is no such method.
  std::optional<std::size_t> reference;
  /// Length of line in which two methods differ; none if one of them has no drawing.
  std::vector<std::vector<std::optional<double>>> differences_mm;
  /// The choice of --method auto, and its reason.
  std::string chosen, why_chosen;
};

struct CompareRequest {
  PictureRequest picture{};  ///< its method is ignored
  std::vector<ComparedMethod> methods{};
  double limit_seconds = 60;  ///< for each method; a method that takes longer is stopped
  std::function<void(double)> progress{};
};

/// Draws the scene by each of the methods. If one fails or takes too long, its outcome says so, and the others
/// continue. Throws RequestError if the request is invalid, and Stopped.
MethodComparison compare_methods(const Scene& scene, const Topology& topology, const CompareRequest& request);

}  // namespace ligne
