/// The JSON drawing, version 2: docs/drawing-format.md. Written as a stream; only strings go through a library. Strokes are
/// formatted in parallel, a batch of chunks at a time, and put together in their order.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <glm/gtc/type_ptr.hpp>

#include "base/no_index.hpp"
#include "base/parallel.hpp"
#include "files/json_text.hpp"
#include "linework/stroke_geometry.hpp"
#include "plotting/writers/number_text.hpp"
#include "plotting/writers/writers.hpp"

namespace ligne {
namespace {

// Adjustable: strokes to a chunk, chunks to a batch.
constexpr std::size_t kChunkStrokes = 4096;
constexpr std::size_t kBatchChunks = 64;

/// Fewest decimals of page points, mm: a nanometre.
constexpr int kPageDecimals = 6;
constexpr int kMostPageDecimals = 12;
/// Decimals of angles in degrees: finer than the coordinates justify.
constexpr int kTurnDecimals = 6;

/// Decimals that distinguish neighbouring lattice points: at most half a step.
int lattice_decimals(const Lattice& lattice) {
  return std::clamp(static_cast<int>(std::ceil(-std::log10(lattice.step_mm / 2))), kPageDecimals, kMostPageDecimals);
}

void append_integer(std::string& out, std::uint64_t value) {
  char text[kNumberBytes];
  out.append(text, write_fixed(text, static_cast<std::int64_t>(value), 0, false));
}

/// Appends "[x,y]", rounded to the decimals.
void append_point(std::string& out, Point2 p, int decimals) {
  out += '[';
  append_rounded(out, p.x, decimals);
  out += ',';
  append_rounded(out, p.y, decimals);
  out += ']';
}

/// Appends "[item,item,...]": append_item(item) for each item.
template <class Items, class AppendItem>
void append_list(std::string& out, const Items& items, const AppendItem& append_item) {
  out += '[';
  bool is_first = true;
  for (const auto& item : items) {
    if (!std::exchange(is_first, false)) out += ',';
    append_item(item);
  }
  out += ']';
}

/// Appends the number of a face or of a surface; null for kNone.
void append_face(std::string& out, std::uint32_t face) { face == kNone ? void(out += "null") : append_integer(out, face); }

/// Appends "[n,n,...]", each in its shortest form that reads back as the same double.
void append_value(std::string& out, std::span<const double> numbers) {
  append_list(out, numbers, [&](double number) { append_shortest(out, number); });
}
void append_value(std::string& out, const Point3& p) { append_value(out, std::array{p.x, p.y, p.z}); }
void append_value(std::string& out, double number) { append_shortest(out, number); }
void append_value(std::string& out, std::unsigned_integral auto number) { append_integer(out, number); }

/// Appends a label, such as ",\"light\":", and a number or a list of numbers.
template <class Value>
void append_member(std::string& out, std::string_view label, const Value& value) {
  out += label;
  append_value(out, value);
}
template <class Value>
void append_member(std::string& out, std::string_view label, const std::optional<Value>& value) {
  if (value) append_member(out, label, *value);
}

void append_stroke(std::string& out, const Stroke& s, const StrokeModel& model, const DrawingDocument& document,
                   int decimals) {
  out += "{\"class\":\"";
  out += kLineClassNames[static_cast<std::size_t>(s.line_class)];
  out += s.visible ? "\",\"visible\":true" : "\",\"visible\":false";
  if (s.level > 0) out += (s.visible ? ",\"level\":" : ",\"hidden_by\":") + std::to_string(s.level);
  if (const HiddenPart* part = hidden_part_of(model, s); part && !part->faces.empty()) {
    out += ",\"hiding_faces\":";
    append_list(out, part->faces, [&](std::uint32_t face) { append_integer(out, face); });
  }
  if (document.object && s.line_class != LineClass::axes) {
    if (const std::uint32_t object = document.object(s.source); object < document.objects.size()) {
      append_member(out, ",\"object\":", object);
    }
  }
  out += ",\"source\":{\"edge\":";
  if (s.source < model.edge_count) {
    append_integer(out, s.source);
  } else {
    out += "null";
  }
  if (document.source) {
    const SourceEdge edge = document.source(s.source);
    out += ",\"ends\":";
    append_list(out, edge.ends, [&](const Point3& end) { append_value(out, end); });
    out += ",\"faces\":";
    append_list(out, edge.faces, [&](std::uint32_t face) { append_face(out, face); });
    if (!document.surfaces.empty()) {
      out += ",\"surfaces\":";
      append_list(out, edge.faces, [&](std::uint32_t face) {
        append_face(out, face < document.surface_of_face.size() ? document.surface_of_face[face] : kNone);
      });
    }
  }
  append_member(out, "},\"interval\":", std::array{s.t_from, s.t_to});
  out += ",\"points\":";
  append_list(out, std::array{s.from, s.to}, [&](auto end) { append_point(out, model.lattice.to_mm(end), decimals); });
  out += '}';
}

void append_surface(std::string& out, const DocumentSurface& surface) {
  out += "{\"kind\":\"";
  out += surface.kind;
  append_member(out, "\",\"at\":", surface.at);
  append_member(out, ",\"axis\":", surface.axis);
  append_member(out, ",\"radius\":", surface.radius);
  append_member(out, ",\"slope\":", surface.slope);
  append_member(out, ",\"tube\":", surface.tube);
  append_member(out, ",\"along\":", surface.along);
  if (surface.turn) {
    out += ",\"turn\":";
    append_rounded(out, *surface.turn, kTurnDecimals);
  }
  out += surface.outward ? ",\"outward\":true" : ",\"outward\":false";
  append_member(out, ",\"sag\":", surface.sag);
  append_member(out, ",\"faces\":", surface.faces);
  append_member(out, ",\"object\":", surface.object);
  out += '}';
}

/// Appends a label and "[item,\nitem,...]": append_item(text, i) for every i below n, called from several threads.
template <class AppendItem>
void append_array(std::string& out, std::string_view label, std::size_t n, const AppendItem& append_item) {
  out += label;
  out += '[';
  std::vector<std::string> texts(kBatchChunks);
  for (std::size_t batch = 0; batch < n; batch += kBatchChunks * kChunkStrokes) {
    parallel_for(kBatchChunks, [&](std::size_t chunk) {
      std::string& text = texts[chunk];
      text.clear();
      const std::size_t first = batch + chunk * kChunkStrokes;
      for (std::size_t i = first; i < std::min(n, first + kChunkStrokes); ++i) {
        text += i == 0 ? "\n" : ",\n";
        append_item(text, i);
      }
    });
    for (const std::string& text : texts) out += text;
  }
  out += n == 0 ? "]" : "\n]";
}

/// Appends a list of items, in parallel.
template <class Items, class Append>
void append_items(std::string& out, std::string_view label, const Items& items, const Append& append) {
  append_array(out, label, items.size(), [&](std::string& text, std::size_t i) { append(text, items[i]); });
}

void append_contour(std::string& out, const std::vector<Point2>& contour) {
  append_list(out, contour, [&](Point2 p) { append_point(out, p, kPageDecimals); });
}

/// Writes every corner without rounding, so that painting from the file gives the same picture as painting directly.
void append_exact_contour(std::string& out, const std::vector<Point2>& contour) {
  append_list(out, contour, [&](Point2 p) { append_value(out, std::array{p.x, p.y}); });
}

/// Appends a face and one of its areas.
void append_area(std::string& out, std::uint32_t face, std::span<const std::vector<Point2>> contours,
                 void (*append)(std::string&, const std::vector<Point2>&)) {
  out += "\"face\":";
  append_face(out, face);
  out += ",\"outer\":";
  append(out, contours.empty() ? std::vector<Point2>{} : contours[0]);
  out += ",\"holes\":";
  append_list(out, contours.subspan(contours.empty() ? 0 : 1), [&](const auto& hole) { append(out, hole); });
}

void append_region(std::string& out, const Region& region, const RegionAppearance* look,
                   const std::vector<std::uint32_t>* through) {
  out += '{';
  append_area(out, region.face, region.contours, append_contour);
  if (region.level > 0) out += ",\"level\":" + std::to_string(region.level);
  if (region.lights != 0xffffffffu) {
    out += ",\"lights\":";
    std::vector<unsigned> lights;
    for (unsigned i = 0; i < 32; ++i) {
      if (region.lights >> i & 1u) lights.push_back(i);
    }
    append_list(out, lights, [&](unsigned light) { append_integer(out, light); });
  }
  if (!region.light_shares.empty()) {
    append_member(out, ",\"light_shares\":", region.light_shares);
  }
  if (region.material != 0xffffffffu) out += ",\"material\":" + std::to_string(region.material);
  if (look) {
    out += ",\"patch\":" + std::to_string(look->patch) + ",\"light\":";
    append_shortest(out, look->light);
    append_member(out, ",\"color\":", look->color);
    if (!look->material.empty()) {
      out += ",\"material_name\":";
      out += json_string(look->material);
    }
  }
  if (through && !through->empty()) {
    out += ",\"through\":";
    append_list(out, *through, [&](std::uint32_t face) { append_integer(out, face); });
  }
  out += '}';
}

void append_piece(std::string& out, const PaintPiece& piece, const PieceAppearance* look) {
  out += '{';
  if (look && look->hidden) out += "\"hidden\":true,";  // first, so that a reader can pass over the rest
  append_area(out, piece.face, piece.contours, append_exact_contour);
  append_member(out, ",\"plane\":", piece.plane);
  if (look) {
    append_member(out, ",\"material\":", look->material);
    append_member(out, ",\"light\":", look->light);
  }
  out += '}';
}

void append_material(std::string& out, const DocumentMaterial& material) {
  out += "{\"name\":" + json_string(material.name) + ",\"color\":";
  append_value(out, material.color);
  append_member(out, ",\"opacity\":", material.opacity);
  out += '}';
}

/// The spans of one line, [begin, end).
void append_line_of_spans(std::string& out, const SpanModel& model, std::size_t begin, std::size_t end) {
  append_member(out, "{\"line\":", model.spans[begin].line);
  append_member(out, ",\"y\":", model.lines.y_mm(model.spans[begin].line));
  out += ",\"spans\":";
  append_list(out, std::span(model.spans).subspan(begin, end - begin), [&](const auto& span) {
    out += '[';
    append_rounded(out, span.x_from, kPageDecimals);
    out += ',';
    append_rounded(out, span.x_to, kPageDecimals);
    out += ',';
    append_face(out, span.face);
    out += ']';
  });
  out += '}';
}

void append_spans(std::string& out, const SpanModel& model) {
  std::vector<std::size_t> first;  // per line with spans: its first span
  for (std::size_t i = 0; i < model.spans.size(); ++i) {
    if (i == 0 || model.spans[i].line != model.spans[i - 1].line) first.push_back(i);
  }
  const std::size_t lines = first.size();
  first.push_back(model.spans.size());
  append_array(out, ",\n\"spans\":", lines,
               [&](std::string& text, std::size_t i) { append_line_of_spans(text, model, first[i], first[i + 1]); });
}

void append_head(std::string& out, const DrawingDocument& document, const Page& page) {
  append_member(out, "{\"format\":\"ligne-drawing\",\"version\":2,\n\"page\":{\"width_mm\":", page.width_mm);
  append_member(out, ",\"height_mm\":", page.height_mm);
  append_member(out, ",\"margin_mm\":", page.margin_mm);
  out += "},\n\"view\":{\"perspective\":";
  out += document.perspective ? "true" : "false";
  out += ",\"matrix\":";
  const glm::dmat4 rows = glm::transpose(document.model_to_page);
  append_value(out, std::span(glm::value_ptr(rows), 16));
  out += ",\"window\":";
  const Rect& window = document.window;
  append_value(out, std::array{window.min.x, window.min.y, window.max.x, window.max.y});
  if (document.perspective) {
    append_member(out, ",\"near\":", document.near_distance);
  }
  out += "},\n\"method\":" + json_string(document.method);
}

void append_plane(std::string& out, const ScanPlane& plane) {
  const auto append_runs = [&](const char* name, const std::vector<ScanPlane::Run>& runs) {
    out += name;
    append_list(out, runs, [&](const ScanPlane::Run& run) {
      out += '[';
      append_shortest(out, run.x0);
      out += ',';
      append_shortest(out, run.x1);
      out += ',';
      append_face(out, run.segment);
      out += ',';
      append_integer(out, run.row);
      out += ']';
    });
  };
  append_member(out, ",\n\"plane\":{\"y\":", plane.y_mm);
  out += ",\"segments\":";
  append_list(out, plane.segments, [&](const ScanPlane::Segment& s) {
    append_value(out, std::array{s.x0, s.z0, s.x1, s.z1, double(s.face)});
  });
  append_runs(",\"runs\":", plane.runs);
  append_runs(",\"bars\":", plane.bars);
  out += '}';
}

/// Counts only: times differ from run to run, and the same input gives the same bytes.
void append_stats(std::string& out, const Statistics& statistics) {
  out += ",\n\"stats\":{\"counts\":{";
  bool is_first = true;
  for (const auto& [name, count] : statistics.counts) {
    if (!std::exchange(is_first, false)) out += ',';
    out += json_string(name) + ':';
    append_integer(out, count);
  }
  out += "}}\n}\n";
}

}  // namespace

std::string write_json(const DrawingDocument& document, const PlotOptions& options) {
  std::string out;
  append_head(out, document, options.page);
  if (!document.objects.empty())
    append_items(out, ",\n\"objects\":", document.objects,
                 [](std::string& text, const std::string& object) { text += json_string(object); });
  if (!document.surfaces.empty()) append_items(out, ",\n\"surfaces\":", document.surfaces, append_surface);
  if (const StrokeModel* const model = document.strokes) {
    append_member(out, ",\n\"lattice\":{\"origin_mm\":", std::array{model->lattice.origin_mm.x, model->lattice.origin_mm.y});
    append_member(out, ",\"step_mm\":", model->lattice.step_mm);
    const int decimals = lattice_decimals(model->lattice);
    append_array(out, "},\n\"strokes\":", model->strokes.size(), [&](std::string& text, std::size_t i) {
      append_stroke(text, model->strokes[i], *model, document, decimals);
    });
  }
  if (document.regions) {
    append_array(out, ",\n\"regions\":", document.regions->size(), [&](std::string& text, std::size_t i) {
      append_region(text, (*document.regions)[i], document.region_looks.empty() ? nullptr : &document.region_looks[i],
                    document.seen_through.empty() ? nullptr : &document.seen_through[i]);
    });
  }
  if (!document.materials.empty()) append_items(out, ",\n\"materials\":", document.materials, append_material);
  if (document.order) {
    append_array(out, ",\n\"order\":", document.order->pieces.size(), [&](std::string& text, std::size_t i) {
      append_piece(text, document.order->pieces[i], document.piece_looks.empty() ? nullptr : &document.piece_looks[i]);
    });
  }
  if (document.spans) append_spans(out, *document.spans);
  if (document.plane) append_plane(out, *document.plane);
  if (document.debug) append_items(out, ",\n\"debug\":", *document.debug, append_contour);
  append_stats(out, document.statistics);
  return out;
}

}  // namespace ligne
