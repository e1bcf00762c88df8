#include "report/compare_output.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "files/message_text.hpp"
#include "picture/models/memory.hpp"
#include "plotting/readers/utf8.hpp"
#include "plotting/writers/number_text.hpp"
#include "plotting/writers/writers.hpp"
#include "report/compare_style.hpp"
#include "visibility/method_parts.hpp"

namespace ligne {
namespace {

/// Coordinates of drawings are rounded to a hundredth of a millimetre, which is enough to look at them.
constexpr int kDecimals = 2;
constexpr double kPartsPerMm = 100;

/// Formats 1234567 as "1 234 567", with narrow no-break spaces.
std::string grouped(std::uint64_t n) {
  std::string digits = std::to_string(n);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, "\u202f");
  return digits;
}

std::string counted(const BoundedCount& count) { return (count.complete ? "" : "\u2265\u202f") + grouped(count.n); }

std::string name_of(const MethodOutcome& m) { return xml_text(m.method->traits().name); }

double study_seconds(const MethodOutcome& m) {
  double sum = 0;
  for (const auto& [name, value] : m.stages.seconds) sum += name == "study" ? value : 0;
  return sum;
}

/// Replaces pairs of backticks by code elements.
std::string with_code(const std::string& text) {
  std::string html;
  bool inside = false;
  for (const char c : text) {
    if (c != '`') {
      html += c;
      continue;
    }
    html += inside ? "</code>" : "<code>";
    inside = !inside;
  }
  return html;
}

/// The lines of the layers. Their class names select the styles.
std::string paths_of(const Drawing& drawing) {
  std::string svg;
  for (const Layer& layer : drawing.layers) {
    Polylines lines = layer.lines;
    for (Point2& p : lines.points) p = glm::round(p * kPartsPerMm) / kPartsPerMm;
    svg += "<g class=\"" + xml_text(layer.name) + "\">" + svg_paths(lines) + "</g>";
  }
  return svg;
}

/// The differing lines in red, with rings around those too short to be found otherwise.
std::string differences_of(const StrokeDifference& difference) {
  constexpr double kShortMm = 2, kRingMm = 2.4;
  constexpr std::size_t kMostRings = 120;
  Drawing drawing;
  std::string rings;
  std::size_t ring_count = 0;
  for (const auto& [kind, parts] : {std::pair{"lost", &difference.only_first}, {"more", &difference.only_second}}) {
    if (parts->empty()) continue;
    Layer& layer = drawing.layers.emplace_back(Layer{kind, {}});
    for (const paper::Segment& part : *parts) {
      layer.lines.add(std::array{part.from, part.to});
      if (part.length() > kShortMm || ring_count == kMostRings) continue;
      ++ring_count;
      const Point2 middle = (part.from + part.to) / 2.0;
      rings += "<circle cx=\"" + fixed(middle.x, kDecimals) + "\" cy=\"" + fixed(middle.y, kDecimals) + "\" r=\"" +
               fixed(kRingMm, 1) + "\"/>";
    }
  }
  return paths_of(drawing) + (rings.empty() ? "" : "<g class=\"spots\">" + rings + "</g>");
}

class ComparisonPage {
 public:
  ComparisonPage(const MethodComparison& comparison, const std::string& name)
      : comparison_(comparison), name_(xml_text(name.substr(name.find_last_of('/') + 1))) {
    find_box();
    for (const MethodOutcome& m : comparison.methods) {
      if (m.drawn() && m.exact() && m.unsupported_reason.empty()) exact_.push_back(&m);
    }
  }

  std::string html() {
    std::string page =
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
        "<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\"><title>" +
        name_ + " by every method</title><style>" + std::string(kCompareStyle) + "</style></head><body><main>\n";
    page += head() + overview() + times() + drawings() + operations() + matrix() + seven_parts();
    return page + "<footer>Made by <b>ligne compare</b>. Times are of one run on one machine; a difference is a length of " +
           "line farther than " + shortest(1000 * kSameLineMm) + " \u00b5m from any line of the other drawing.</footer>" +
           "</main></body></html>\n";
  }

 private:
  const MethodOutcome* reference() const {
    return comparison_.reference ? &comparison_.methods[*comparison_.reference] : nullptr;
  }

  /// Finds the bounding box of all drawings, with a margin.
  void find_box() {
    constexpr double kRimMm = 3;
    for (const MethodOutcome& m : comparison_.methods) {
      for (const Layer& layer : m.drawing.layers) {
        for (const Point2& p : layer.lines.points) box_.extend(p);
      }
    }
    if (box_.empty()) box_ = {{0, 0}, {comparison_.page.width_mm, comparison_.page.height_mm}};
    box_ = {box_.min - kRimMm, box_.max + kRimMm};
  }

  std::string svg(const std::string& content, const std::string& title) const {
    return "<svg viewBox=\"" + fixed(box_.min.x, kDecimals) + " " + fixed(box_.min.y, kDecimals) + " " +
           fixed(box_.width(), kDecimals) + " " + fixed(box_.height(), kDecimals) + "\" role=\"img\" aria-label=\"" + title +
           "\">" + content + "</svg>";
  }

  std::string head() const {
    double most = 0;
    for (std::size_t i = 0; i < comparison_.methods.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const auto both = [&](const MethodOutcome* m) {
          return m == &comparison_.methods[i] || m == &comparison_.methods[k];
        };
        if (std::count_if(exact_.begin(), exact_.end(), both) != 2) continue;
        most = std::max(most, comparison_.differences_mm[i][k].value_or(0));
      }
    }
    std::string text = "<h1>" + name_ + "</h1><p class=\"lead\">One scene by " + std::to_string(comparison_.methods.size()) +
                       " visibility methods, side by side.</p>";
    if (exact_.size() < 2) return text;
    const bool same = fixed(most, 3) == fixed(0, 3);
    text += same ? "<div class=\"verdict\">All " + std::to_string(exact_.size()) +
                       " exact methods draw the same lines: they differ by 0.000 mm"
                 : "<div class=\"verdict differs\">Exact methods differ by up to " + fixed(most, 3) +
                       " mm of line: red below shows where";
    return text + "</div>";
  }

  std::string overview() const {
    const SceneTraits& t = comparison_.traits;
    const auto row = [](const std::string& what, const std::string& figure, const std::string& more = {}) {
      return "<dt>" + what + "</dt><dd><b>" + figure + "</b>" + (more.empty() ? "" : "<span>" + more + "</span>") + "</dd>";
    };
    std::string text = "<div class=\"top\"><div class=\"sheet\">";
    if (const MethodOutcome* r = reference()) {
      text += svg("<g id=\"reference\">" + paths_of(r->drawing) + "</g>", "the drawing by " + name_of(*r));
    }
    text += "</div><dl>";
    text += row("Faces", grouped(t.faces),
                grouped(t.front_faces) + " facing the viewer" +
                    (t.transparent_faces > 0 ? ", " + grouped(t.transparent_faces) + " transparent" : ""));
    text += row("Visible faces", counted(t.visible_faces),
                "of " + fixed(100 * t.mean_visible_part, 2) + " % of the picture on average, of which " +
                    fixed(100 * t.covered_part, 1) + " % has a face");
    text += row("Corners", fixed(t.mean_corners, 2),
                "of a face on average, " + grouped(t.most_corners) + " at most; " + grouped(t.nonconvex_faces) +
                    " faces are not convex");
    text += row("Pairs of faces apart", fixed(100 * t.spread.apart[0], 1) + " % by x",
                fixed(100 * t.spread.apart[1], 1) + " % by y, " + fixed(100 * t.spread.apart[2], 1) + " % by depth");
    text += row("Convex objects", grouped(t.convex_objects));
    text += row("Zones", grouped(t.zones), "largest of " + grouped(t.largest_zone) + " faces");
    text += row("Overlap", fixed(t.mean_overlap, 2),
                "faces over a point of the page on average, " + grouped(t.most_overlap) + " at most");
    text += row("Conflicts", counted(t.conflicts), "pairs of faces that overlap on the page");
    text += row("Penetrations", counted(t.penetrations));
    text += row("Turning vertices", grouped(t.turning_vertices), "nbsom\u2032 of the thesis");
    text += row("Height field", t.height_field ? "yes" : "no");
    text += row("<code>--method auto</code>", xml_text(comparison_.chosen), xml_text(comparison_.why_chosen));
    return text + "</dl></div>";
  }

  std::string times() const {
    double longest = 0;
    const MethodOutcome* fastest = nullptr;
    for (const MethodOutcome& m : comparison_.methods) {
      if (m.drawn()) longest = std::max(longest, m.seconds());
    }
    for (const MethodOutcome* m : exact_) {
      if (!fastest || study_seconds(*m) < study_seconds(*fastest)) fastest = m;
    }
    std::string text =
        "<h2>Lines, time and memory</h2><p class=\"soft\">Study is the time of the method itself; the rest (projection, "
        "joining, removal of overlapping lines) is the same for all.<i class=\"key\" "
        "style=\"background:var(--blue)\"></i>study<i class=\"key\" style=\"background:var(--bar)\"></i>the rest</p><div "
        "class=\"scroll\"><table><thead><tr><th>Method</th><th>Strokes</th><th>Visible line</th><th>Differs</th><th "
        "style=\"text-align:left\">Time</th><th>Memory</th><th>Memory in 1980</th></tr></thead><tbody>";
    for (std::size_t i = 0; i < comparison_.methods.size(); ++i) {
      const MethodOutcome& m = comparison_.methods[i];
      text += std::string("<tr") + (&m == fastest ? " class=\"best\"" : "") + "><th>" + name_of(m) +
              (m.unsupported_reason.empty() ? "" : "<small>not for this scene</small>") + "</th>";
      if (!m.drawn()) {
        text += "<td class=\"text soft\" colspan=\"6\">" + xml_text(m.failure) + "</td></tr>";
        continue;
      }
      text += "<td>" + grouped(m.strokes) + "</td><td>" + fixed(m.visible_mm, 1) + " mm</td>" + difference_cell(i) +
              bar(m, longest) + "<td>" + memory_of(m) + "</td><td>" +
              (m.thesis_words ? grouped(*m.thesis_words) + " words" : "") + "</td></tr>";
    }
    return text + "</tbody></table></div>";
  }

  /// Text such as "5.5 MB".
  static std::string memory_of(const MethodOutcome& m) {
    if (!m.peak_bytes) return "";
    std::string text = bytes_text(*m.peak_bytes);
    const auto unit = text.find_first_not_of("0123456789.");
    return unit == std::string::npos ? text + " B" : text.insert(unit, " ") + "B";
  }

  static std::string bar(const MethodOutcome& m, double longest) {
    constexpr double kWidth = 170;  // px
    const double all = m.seconds(), width = longest > 0 ? kWidth * all / longest : 0;
    const double share = all > 0 ? 100 * study_seconds(m) / all : 0;
    return "<td class=\"time\"><div class=\"bar\"><i style=\"width:" + fixed(width, 1) +
           "px\"><u style=\"width:" + fixed(share, 1) + "%\"></u></i><span>" + duration(study_seconds(m)) +
           " <span class=\"soft\">of " + duration(all) + "</span></span></div></td>";
  }

  std::string difference_cell(std::size_t i) const {
    if (!comparison_.reference) return "<td></td>";
    if (*comparison_.reference == i) return "<td class=\"zero\">reference</td>";
    const double mm = comparison_.differences_mm[*comparison_.reference][i].value_or(0);
    const std::string text = fixed(mm, 3);
    return std::string("<td class=\"") + (text == fixed(0, 3) ? "zero" : "red") + "\">" + text + " mm</td>";
  }

  std::string operations() const {
    std::string text =
        "<h2>Operations</h2><p class=\"soft\">Counted by the methods and grouped by kind; an empty cell: the method has no "
        "such operation, or does not count it.</p><div class=\"scroll\"><table><thead><tr><th>Method</th>";
    for (const OperationName& name : kOperationNames) text += "<th>" + std::string(name.words) + "</th>";
    text += "</tr></thead><tbody>";
    for (const MethodOutcome& m : comparison_.methods) {
      if (!m.drawn()) continue;
      text += "<tr><th>" + name_of(m) + "</th>";
      for (const auto& n : m.operations) text += "<td>" + (n ? grouped(*n) : "") + "</td>";
      text += "</tr>";
    }
    return text + "</tbody></table></div>";
  }

  std::string matrix() const {
    std::string text =
        "<h2>Every method against every other</h2><p class=\"soft\">Millimetres of line that one of the two draws and the "
        "other does not.</p><div class=\"scroll\"><table class=\"matrix\"><thead><tr><th></th>";
    for (const MethodOutcome& m : comparison_.methods) text += "<th>" + name_of(m) + "</th>";
    text += "</tr></thead><tbody>";
    for (std::size_t i = 0; i < comparison_.methods.size(); ++i) {
      text += "<tr><th>" + name_of(comparison_.methods[i]) + "</th>";
      for (std::size_t k = 0; k < comparison_.methods.size(); ++k) {
        const auto& mm = comparison_.differences_mm[i][k];
        const bool zero = mm && fixed(*mm, 3) == fixed(0, 3);
        text += i == k ? "<td class=\"same\"></td>"
                : !mm  ? "<td class=\"zero\">\u2013</td>"
                : zero ? "<td class=\"zero\">0.000</td>"
                       : "<td class=\"off\">" + fixed(*mm, 3) + "</td>";
      }
      text += "</tr>";
    }
    return text + "</tbody></table></div>";
  }

  /// The parts by which [Boulle1980] describes a method: a row for each part, a column for each method.
  std::string seven_parts() const {
    std::string text =
        "<h2>The seven parts</h2><p class=\"soft\">How each method works, in the terms of the thesis.</p><div "
        "class=\"scroll\"><table class=\"parts\"><thead><tr><th>Part</th>";
    for (const MethodOutcome& m : comparison_.methods) text += "<th>" + name_of(m) + "</th>";
    text += "</tr></thead><tbody>";
    for (std::size_t i = 0; i < kMethodParts.size(); ++i) {
      const MethodPart& part = kMethodParts[i];
      text += "<tr><th>" + std::string(part.symbol) + "<small>" + std::string(part.meaning) + "</small></th>";
      for (const MethodOutcome& m : comparison_.methods) {
        const SevenParts* parts = seven_parts_of(m.method->traits().name);
        text += "<td>" + (parts ? with_code(xml_text((*parts)[i])) : "") + "</td>";
      }
      text += "</tr>";
    }
    return text + "</tbody></table></div>";
  }

  /// The page's SVG content for a method: its drawing and the differences.
  std::string content_of(std::size_t i) const {
    const MethodOutcome& m = comparison_.methods[i];
    const StrokeDifference& d = m.from_reference;
    const bool as_reference = reference() && d.only_first.empty() && d.only_second.empty();
    return (as_reference ? "<use href=\"#reference\"/>" : paths_of(m.drawing)) + differences_of(d);
  }

  std::string drawings() const {
    std::string text =
        "<h2>Drawings</h2><p class=\"soft\">Red, whole: a line of the reference that is missing. Red, dotted: a "
        "line that only this method draws. Rings mark what is shorter than 2 mm. Choose a drawing to see it "
        "large.</p><div class=\"grid\">";
    std::string large;
    for (std::size_t i = 0; i < comparison_.methods.size(); ++i) {
      const MethodOutcome& m = comparison_.methods[i];
      const std::string name = name_of(m), id = "drawing-" + std::to_string(i);
      text += "<figure>";
      if (!m.drawn()) {
        text += "<div class=\"none\">" + xml_text(m.failure) + "</div><figcaption><b>" + name +
                "</b><span>no drawing</span></figcaption></figure>";
        continue;
      }
      text += "<a href=\"#large-" + id + "\">" + svg("<g id=\"" + id + "\">" + content_of(i) + "</g>", name) +
              "</a><figcaption><b>" + name + "</b><span>" + duration(study_seconds(m)) + ", " + words_of_difference(i) +
              "</span></figcaption>" + note(m) + "</figure>";
      large += "<a class=\"big\" id=\"large-" + id + "\" href=\"#_\"><p>" + name + "</p>" +
               svg("<use href=\"#" + id + "\"/>", name) + "</a>";
    }
    return text + "</div>" + large;
  }

  std::string words_of_difference(std::size_t i) const {
    if (!comparison_.reference) return "";
    if (*comparison_.reference == i) return "the reference";
    const double mm = comparison_.differences_mm[*comparison_.reference][i].value_or(0);
    if (fixed(mm, 3) == fixed(0, 3)) return "differs by 0.000 mm";
    return "<span class=\"red\">differs by " + fixed(mm, 3) + " mm</span>";
  }

  static std::string note(const MethodOutcome& m) {
    std::string text;
    if (m.resolution_mm) text += "Limited to " + fixed(*m.resolution_mm, 3) + " mm by its resolution. ";
    if (!m.unsupported_reason.empty()) {
      text += "Only for " + xml_text(m.method->traits().only_for) + "; here " + xml_text(m.unsupported_reason) + ".";
    }
    return text.empty() ? "" : "<div class=\"note\">" + text + "</div>";
  }

  const MethodComparison& comparison_;
  std::string name_;
  Rect box_;
  std::vector<const MethodOutcome*> exact_;  ///< methods whose drawings must agree
};

}  // namespace

std::string compare_page(const MethodComparison& comparison, const std::string& name) {
  return ComparisonPage(comparison, name).html();
}

}  // namespace ligne
