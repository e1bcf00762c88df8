#include "view/axes/axis_lines.hpp"
#include "linework/overlaps/coincident_strokes.hpp"

#include <algorithm>
#include <utility>

#include "view/clip.hpp"

namespace ligne {

Polylines axis_lines(std::span<const AxisLine> lines, const View& view, const LineVisibility& visibility,
                     double coincidence_mm) {
  std::vector<std::vector<VisibleInterval>> visible;
  if (visibility) {
    visible = visibility(lines);
  } else {
    visible.assign(lines.size(), {VisibleInterval{}});
  }

  StrokeModel model{.lattice = page_lattice(view), .edge_count = static_cast<std::uint32_t>(lines.size())};
  const ClipVolume volume = line_volume(view, model.lattice);
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    const HomogeneousPoint a = to_homogeneous(view, lines[i].a), b = to_homogeneous(view, lines[i].b);
    const auto inside = clip_segment(a, b, volume);
    if (!inside) continue;
    for (const VisibleInterval& part : visible[i]) {
      const double from = std::max(part.from, inside->range[0]), to = std::min(part.to, inside->range[1]);
      if (!(from < to)) continue;
      const HomogeneousPoint p = interpolate(a, b, from), q = interpolate(a, b, to);
      Stroke stroke{.t_from = from,
                    .t_to = to,
                    .from = model.lattice.snap({p.x / p.w, p.y / p.w}),
                    .to = model.lattice.snap({q.x / q.w, q.y / q.w}),
                    .z_from = static_cast<float>(p.z / p.w),
                    .z_to = static_cast<float>(q.z / q.w),
                    .w_from = static_cast<float>(p.w),
                    .w_to = static_cast<float>(q.w),
                    .source = i,
                    .line_class = LineClass::border};
      if (stroke.from != stroke.to) model.strokes.push_back(stroke);
    }
  }
  remove_coincident_strokes(model, coincidence_mm);
  Drawing drawing = make_drawing(model);
  return drawing.layers.empty() ? Polylines{} : std::move(drawing.layers.front().lines);
}

}  // namespace ligne
