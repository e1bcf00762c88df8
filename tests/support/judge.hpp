#pragma once
/// The judge: any method's drawing of a scene against the oracle.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oracle/oracle.hpp"
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

/// A scene in one view on a sheet, with the oracle's answers. These are found once, for all methods.
class JudgedView {
 public:
  /// `name` is the corpus scene's, "tests/corpus/NAME.json"; it stands in the command that shows a fault. For methods that
  /// are limited by a resolution `accuracy_mm` is that resolution: the oracle is asked on a page so much smaller that what
  /// it leaves open around every change, a micrometre there, is that much here.
  JudgedView(const Scene& scene, std::string name, const StandardView& view, double accuracy_mm = 0.001);
  ~JudgedView();

  /// Draws with the method as `ligne draw --edges EDGES` does and compares. `edges` is "all" or "feature". The method's
  /// tolerance is that of its traits, or the accuracy of this view when that is coarser.
  Verdict judge(const Method& method, const std::string& edges, const MethodSettings& settings = {}) const;

  const View& view() const { return view_; }
  const oracle::Oracle& oracle() const { return *oracle_; }
  bool has_intersections() const;  ///< proper ones

 private:
  struct Lines;

  const Scene& scene_;
  std::string name_;
  StandardView standard_;
  double accuracy_mm_;
  Topology topology_;
  View view_;
  std::unique_ptr<oracle::Oracle> oracle_;
  std::unique_ptr<Lines> lines_;
};

/// The oracle's view of the same doubles.
oracle::View oracle_view(const CameraRequest& request, const View& view);

}  // namespace ligne::test
