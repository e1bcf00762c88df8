#pragma once
/// Several methods on one scene, side by side.

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
#include "linework/overlaps/stroke_difference.hpp"
#include "picture/choice/scene_traits.hpp"
#include "picture/requests.hpp"
#include "picture/run_report.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "visibility/method.hpp"

namespace ligne {

/// Kinds of operations, of which every method counts some under names of its own.
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

/// Nothing where the method counts no operations of that kind.
using OperationCounts = std::array<std::optional<std::uint64_t>, kOperationKinds>;
OperationCounts operations_of(const Statistics& statistics);

/// A method, and the values of its own options.
struct ComparedMethod {
  const Method* method = nullptr;
  MethodSettings settings{};
};

/// "NAME,..." of methods, each once and none of them auto. Throws std::invalid_argument as the functions of parse.hpp.
std::vector<const Method*> parse_methods(const std::string& text);

/// The methods in the order of the registry (none: all that give lines), each with those of the options that it has;
/// `parameters` are names and values of options that only some methods have. Throws RequestError for one that none of them
/// has, or not with this value.
std::vector<ComparedMethod> compared_methods(std::span<const Method* const> methods,
                                             std::span<const std::pair<std::string, std::string>> parameters);

/// More than anybody waits for.
inline constexpr double kMostLimitSeconds = 1e6;

/// The outcome of a method.
struct MethodOutcome {
  const Method* method = nullptr;
  std::string failure;                    ///< why it drew nothing; empty when it drew
  std::string unsupported_reason;         ///< why its drawing may be wrong, see VisibilityResult::unsupported_reason
  std::optional<double> resolution_mm{};  ///< how far a line may be off, where the method or its options limit it
  Statistics study;                       ///< its own counts, and the times of its phases
  StageTimes stages;                      ///< of the drawing
  OperationCounts operations{};
  std::optional<double> peak_bytes{};           ///< memory beyond what the scene takes (peak_memory.hpp)
  std::optional<std::uint64_t> thesis_words{};  ///< of memory, as [Boulle1980] 2.6 has it
  std::size_t strokes = 0;                      ///< visible
  double visible_mm = 0, hidden_mm = 0;
  StrokeModel model{};
  Drawing drawing{};
  StrokeDifference from_reference{};  ///< only_first: in the reference alone; only_second: in this drawing alone

  bool drawn() const { return failure.empty(); }
  bool exact() const { return !resolution_mm; }
  double seconds() const;  ///< of all stages
};

struct MethodComparison {
  SceneTraits traits;
  Page page;
  std::vector<MethodOutcome> methods;
  /// The first exact method that drew what is in no doubt; nothing when there is none.
  std::optional<std::size_t> reference;
  /// Length on which two methods differ; nothing where one of them drew nothing.
  std::vector<std::vector<std::optional<double>>> differences_mm;
  /// The choice of --method auto, and its reason.
  std::string chosen, why_chosen;
};

struct CompareRequest {
  PictureRequest picture;  ///< its method is not looked at
  std::vector<ComparedMethod> methods;
  double limit_seconds = 60;  ///< for each method; one that takes longer is ended
  std::function<void(double)> progress{};
};

/// Draws the scene by each of the methods. What goes wrong with one of them, or takes too long, is told in its place, and
/// the others go on. Throws RequestError where none can begin; Stopped.
MethodComparison compare_methods(const Scene& scene, const Topology& topology, const CompareRequest& request);

}  // namespace ligne
