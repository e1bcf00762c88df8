#pragma once
/// The judge: any method's drawing of a scene against the oracle.

#include "oracle/answers.hpp"
#include "support/standard_views.hpp"
#include "view/projected_scene.hpp"
#include "visibility/method.hpp"

namespace ligne::test {

/// A kind of fault: how much of it there is, and where it is worst.
struct Fault {
  double length_mm = 0;  ///< on the page, all places together
  double worst_mm = 0;   ///< the longest place
  std::string place;     ///< of the worst: line in words, and page mm from -> to
};

struct Verdict {
  std::string skipped;      ///< why nothing was judged; empty when it was
  Fault drawn_hidden;       ///< visible strokes where the oracle says hidden, and intersections that are none
  Fault missing;            ///< what the oracle says is visible and no visible stroke covers
  Fault twice;              ///< visible strokes that lie on each other
  Fault uncovered;          ///< parts of candidate edges that neither visible nor hidden strokes cover
  Fault misplaced;          ///< ends of strokes that are not where their source edge has that parameter
  Fault wrong_class;        ///< strokes of another class than the oracle's, or of none that was asked for
  double line_mm = 0;       ///< length of all candidate lines on the page, but for what lies at the window's border
  double undecided_mm = 0;  ///< of them: where the oracle does not decide

  /// All faults that are longer than a drawing may be off, in words; empty when there is none.
  std::string faults;
  bool passes() const { return faults.empty(); }
};

/// On where the drawing that is judged lacks the back faces of solids.
enum class Cull : std::uint8_t { off, on };

/// A scene in one view on a sheet, with the oracle's answers. These are found once, when they are first needed, for all
/// methods.
///
/// Where faces are transparent a method is held to what its traits say of them: as opaque faces they hide; else nothing does
/// that is behind them alone, and for methods that tell what is behind glass, what they say is seen directly is moreover
/// held to the answers with opaque faces.
class JudgedView {
 public:
  /// `name` is the corpus scene's, "tests/corpus/NAME.json"; it stands in the command that shows a fault. For methods that
  /// are limited by a resolution `accuracy_mm` is that resolution: the oracle is asked on a page so much smaller that what
  /// it leaves open around every change, a micrometre there, is that much here.
  JudgedView(const Scene& scene, std::string name, const StandardView& view, double accuracy_mm = 0.001);
  ~JudgedView();

  /// Draws with the method as `ligne draw --edges EDGES` does and compares. `edges` is "all" or "feature". The method's
  /// tolerance is that of its traits, or the accuracy of this view when that is coarser.
  Verdict judge(const Method& method, const std::string& edges, const MethodSettings& settings = {},
                Cull cull = Cull::off) const;

  const View& view() const { return view_; }
  const oracle::Oracle& oracle() const;  ///< for which transparent faces hide
  bool has_intersections() const;        ///< proper ones

 private:
  struct Lines;
  enum class Edges : std::uint8_t { all, without_glass };

  void ask() const;
  Lines lines_of(const oracle::Answers& answers, Edges edges) const;
  void compare(StrokeModel model, const Lines& lines, const MethodTraits& traits, const ProjectedScene& projected, bool all,
               bool hidden, Verdict& verdict) const;

  const Scene& scene_;
  std::string name_;
  StandardView standard_;
  double accuracy_mm_;
  Topology topology_;
  View view_;
  bool has_glass_;
  mutable std::unique_ptr<oracle::Oracle> oracle_;
  /// Where transparent faces hide; where they hide nothing; and of that without their edges. The latter two with glass
  /// alone.
  mutable std::unique_ptr<Lines> lines_, behind_, opaque_;
};

/// Whether the face is transparent; whether any is.
bool is_glass(const Scene& scene, std::uint32_t face);
bool has_glass(const Scene& scene);

/// The oracle's view of the same doubles.
oracle::View oracle_view(const CameraRequest& request, const View& view);

}  // namespace ligne::test
