#pragma once
/// The interface of all visibility methods. The implementations are listed in src/visibility/registry.hpp.

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
#include "linework/stroke.hpp"
#include "view/projected_scene.hpp"
#include "visibility/method_parameters.hpp"

namespace ligne {

/// Base class of such results. A method recognizes its own ones, and ignores others.
class KeptVisibility {
 public:
  virtual ~KeptVisibility() = default;
};

/// The kind of later run for which results are kept.
enum class Keep : std::uint8_t {
  nothing,
  for_next_view,     ///< the same model from another viewpoint
  for_more_objects,  ///< the same view, with further objects appended to the same ones
};

struct OccludedCells;
class ByteReader;
class ByteWriter;

/// The kinds of result that a method can produce, as bits.
enum Product : std::uint8_t {
  kStrokes = 1,  ///< visible and hidden pieces of lines
  kRegions = 2,  ///< visible areas of faces
  kOrder = 4,    ///< pieces of faces in the order of painting
  kSpans = 8,    ///< visible runs of faces on scan lines
  kPixels = 16,  ///< faces by pixel
};

/// View-independent data that a method precomputes from a scene and uses for every view, such as a BSP tree.
class CompiledScene {
 public:
  virtual ~CompiledScene() = default;
  virtual void write(ByteWriter& bytes) const = 0;
};

/// How a method treats transparent faces.
enum class TransparencyMode : std::uint8_t {
  opaque,         ///< as opaque faces
  left_out,       ///< ignored, with all edges of transparent faces only (VisibilityResult::left_out says how many)
  hides_nothing,  ///< their edges are drawn; they hide nothing
  seen_through,   ///< their edges are drawn; they hide nothing, and Stroke::level counts those in front of a line
};

struct MethodTraits {
  std::string_view name;             ///< as on the command line
  std::string_view summary;          ///< one line
  std::uint8_t products = kStrokes;  ///< bits of Product that it can produce
  bool exact = true;                 ///< exact on the lattice; false: limited by a resolution
  bool penetration = true;           ///< correct for faces that penetrate each other
  std::string_view paper;            ///< author, title, year
  double tolerance_mm =
      0.001;  ///< largest error of a line or its end on the page; methods that are not exact have a larger one
  std::span<const MethodParameter> parameters{};  ///< the method's own options
  /// The scenes for which its drawings are correct, in words; empty: all scenes. For a scene of another kind
  /// VisibilityResult::unsupported_reason says why the drawing may be wrong.
  std::string_view only_for{};
  bool compiles = false;  ///< whether compile() does a part of its work once for all views of a scene
  TransparencyMode transparency = TransparencyMode::opaque;
};

struct FaceStudy;

struct VisibilityOptions {
  bool hidden_strokes = false;             ///< also return the hidden pieces of lines
  std::function<void(double)> progress{};  ///< called with the fraction done, by one thread at a time; may be empty
  std::optional<SpanLines> span_lines{};   ///< scan lines for which spans are wanted
  /// Whether those spans, and pixels, are wanted with the transparent faces in front of them.
  bool with_transparent_faces = false;
  MethodSettings settings{};                ///< values of the method's own parameters, each within its range
  std::uint8_t wanted = 0xff;               ///< bits of Product; a method may omit products that are not wanted
  const CompiledScene* compiled = nullptr;  ///< result of this method's compile() for ProjectedScene::model, or null
  Keep keep = Keep::nothing;                ///< what VisibilityResult::kept is wanted for
  const KeptVisibility* earlier = nullptr;  ///< VisibilityResult::kept of an earlier run, or null
  const FaceStudy* faces = nullptr;         ///< study_faces() of the scene, or null if not made; read by `appel` only
  const OccludedCells* blank = nullptr;     ///< squares of the page in which faces outside this scene hide every
                                            ///< line, or null; read by `appel` only
  /// Stroke::needs_overlap_check depends on visible strokes only, so that the result does not depend on what is hidden.
  /// Read by `appel` only.
  bool overlap_if_visible = false;
};

/// The results of a method. Products that it does not have stay empty.
struct VisibilityResult {
  std::optional<StrokeModel> strokes;
  std::optional<std::vector<Region>> regions;
  std::optional<PaintOrder> order;
  std::optional<SpanModel> spans;
  std::optional<PixelModel> pixels;
  std::optional<ScanPlane> plane;          ///< for a method that shows it
  std::vector<std::vector<Point2>> debug;  ///< polylines (page mm) that illustrate how the method worked
  std::vector<PageNumber> debug_numbers;   ///< numbers to be drawn for the same purpose
  Statistics statistics;
  /// Why the drawing of this scene may be wrong. Empty if the scene is one of MethodTraits::only_for.
  std::string unsupported_reason;
  std::shared_ptr<const KeptVisibility> kept;  ///< for a later run; null if none was wanted or nothing can be kept
  std::string left_out;                        ///< parts of the scene that the method ignored, in words; or empty
};

/// A visibility method. It has no state: compute_visibility() may be called by several threads at once. The same input
/// gives the same result for any number of threads; that number is set by the caller's oneTBB arena.
class Method {
 public:
  virtual ~Method() = default;
  virtual const MethodTraits& traits() const = 0;
  virtual VisibilityResult compute_visibility(const ProjectedScene& scene, const VisibilityOptions& options) const = 0;

  /// Precomputes what does not depend on the view. Returns null unless MethodTraits::compiles.
  virtual std::shared_ptr<const CompiledScene> compile(const Scene&, const MethodSettings&) const { return nullptr; }
  /// Reads the output of CompiledScene::write() for that scene. Returns null unless MethodTraits::compiles. Throws
  /// InputError.
  virtual std::shared_ptr<const CompiledScene> read_compiled(ByteReader&, const Scene&) const { return nullptr; }
};

}  // namespace ligne
