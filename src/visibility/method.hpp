#pragma once
/// The interface of every visibility method. It knows no implementation; src/visibility/registry.hpp lists them.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "drawing/result_models.hpp"
#include "drawing/statistics.hpp"
#include "drawing/stroke.hpp"
#include "view/projected_scene.hpp"
#include "visibility/kept_visibility.hpp"
#include "visibility/method_parameters.hpp"

namespace ligne {

struct OccludedCells;
class ByteReader;
class ByteWriter;

/// The kinds of result that a method can produce.
enum Product : std::uint8_t {
  kStrokes = 1,
  kRegions = 2,
  kOrder = 4,
  kSpans = 8,
  kPixels = 16,
};

/// The data that a method makes of a scene once, for all views of it.
class CompiledScene {
 public:
  virtual ~CompiledScene() = default;
  virtual void write(ByteWriter& bytes) const = 0;
};

/// The treatment of transparent faces by a method.
enum class TransparencyMode : std::uint8_t {
  opaque,    ///< they hide as others do
  left_out,  ///< they and the edges that only they have are no part of the study (VisibilityResult::left_out says how many)
  hides_nothing,  ///< they are drawn, and hide nothing
  seen_through,   ///< they are drawn and hide nothing; Stroke::level counts those in front
};

struct MethodTraits {
  std::string_view name;     ///< as on the command line
  std::string_view summary;  ///< one line
  std::uint8_t products = kStrokes;
  bool exact = true;        ///< exact on the lattice, or limited by a resolution
  bool penetration = true;  ///< draws penetrating faces right
  std::string_view paper;   ///< author, title, year
  double tolerance_mm =
      0.001;  ///< how far on the page a line or an end of it may be off; more for methods that are not exact
  std::span<const MethodParameter> parameters{};  ///< options of its own
  /// The scenes for which its drawings hold, in words; empty: all. For others VisibilityResult::unsupported_reason says why
  /// not.
  std::string_view only_for{};
  bool compiles = false;  ///< part of its work is done once for all views of a scene
  TransparencyMode glass = TransparencyMode::opaque;
};

struct Facets;

struct VisibilityOptions {
  bool hidden_strokes = false;              ///< give the hidden pieces too
  std::function<void(double)> progress{};   ///< called with the fraction done, from one thread at a time; may be empty
  std::optional<SpanLines> span_lines{};    ///< the lines for which a method that produces spans gives them
  MethodSettings settings{};                ///< values of the method's own parameters, each within its range
  std::uint8_t wanted = 0xff;               ///< products; a method may leave others out
  const CompiledScene* compiled = nullptr;  ///< by this method's compile(), of the model that is projected; or nullptr
  Keep keep = Keep::nothing;                ///< what VisibilityResult::kept is wanted for
  const KeptVisibility* earlier = nullptr;  ///< kept by an earlier study; or nullptr
  const Facets* facets = nullptr;           ///< make_facets() of the scene, where it is there already; for `appel`
  const OccludedCells* blank = nullptr;     ///< where no line is seen, whatever the scene says; for `appel`; or nullptr
  /// Stroke::needs_overlap_check is told by what is seen alone, whatever is hidden; for `appel`.
  bool coincide_by_sight = false;
};

/// The results. Models that a method does not produce stay empty.
struct VisibilityResult {
  std::optional<StrokeModel> strokes;
  std::optional<std::vector<Region>> regions;
  std::optional<PaintOrder> order;
  std::optional<SpanModel> spans;
  std::optional<PixelModel> pixels;
  std::vector<std::vector<Point2>> debug;  ///< what shows how the method went about it: polylines in page mm
  std::vector<PageNumber> debug_numbers;   ///< the same: numbers, of which polylines are made
  Statistics statistics;
  /// Why this scene is not one that the method can do: what is drawn may be wrong. Empty when it can; see only_for.
  std::string unsupported_reason;
  std::shared_ptr<const KeptVisibility> kept;  ///< nullptr where nothing is wanted, or the method has nothing to keep
  std::string left_out;  ///< what of the scene the method does not take part in its study, in words; empty: nothing
};

/// A method holds no state: compute_visibility() may be called from several threads, and the same input gives the same
/// result whatever the number of threads (which is the caller's oneTBB arena).
class Method {
 public:
  virtual ~Method() = default;
  virtual const MethodTraits& traits() const = 0;
  virtual VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const = 0;

  /// For methods that compile; others return nullptr.
  virtual std::shared_ptr<const CompiledScene> compile(const Scene&, const MethodSettings&) const { return nullptr; }
  /// Reads the output of CompiledScene::write() for that scene. Throws InputError.
  virtual std::shared_ptr<const CompiledScene> read_compiled(ByteReader&, const Scene&) const { return nullptr; }
};

}  // namespace ligne
