#pragma once
/// Options that say how faces are hatched.

#include <cstdint>
#include <optional>
#include <string_view>

#include "cli/output_options.hpp"
#include "visibility/method.hpp"

namespace CLI {
class App;
}

namespace ligne {

enum class HatchKind : std::uint8_t { none, shade, material, plain };
inline constexpr std::string_view kHatchNames[] = {"none", "shade", "material", "plain"};

/// Degrees of darkness, as many as the thesis has at most.
inline constexpr unsigned kMostShades = 4;

/// Direction of the strokes: fixed, or on every face along its level lines.
struct HatchDirection {
  bool by_face = false;
  double degrees = 45;  ///< counter-clockwise as seen; of level faces too
};

struct HatchRequest {
  HatchKind kind = HatchKind::none;
  std::optional<double> spacing_mm;  ///< of the closest strokes; nothing: by the width of the pen
  HatchDirection direction;
  bool cross = false;
  unsigned levels = kMostShades;  ///< 0: continuous

  bool asked() const { return kind != HatchKind::none; }
};

void add_hatch_options(CLI::App& app, HatchRequest& options);

/// Throws UsageError when the format has no hatching or the method gives nothing that can be hatched; the message names the
/// methods that do.
void check(const HatchRequest& options, OutputFormat format, const Method& method);

/// Throws the UsageError of a method that gives nothing to hatch.
[[noreturn]] void refuse_hatching(std::string_view method);

/// The first method of the registry that gives regions: what draws fills and hatching when no method is named.
const Method& region_method();

}  // namespace ligne
