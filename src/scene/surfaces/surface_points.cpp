#include "scene/surfaces/surface_points.hpp"

#include <string_view>
#include <utility>

#include "base/parallel.hpp"
#include "files/message_text.hpp"
#include "scene/surfaces/formula/formula_evaluator.hpp"

namespace ligne {
namespace {

constexpr std::array<std::string_view, 2> kParameters{"u", "v"};

class SampledHeights : public HeightSource {
 public:
  SampledHeights(const SurfacePoints& surface, std::vector<double> x, std::vector<double> y)
      : HeightSource(std::move(x), std::move(y)), surface_(surface) {}

  void read_row(std::size_t j, std::span<double> z) const override {
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = surface_.points[j * z.size() + i].z;
  }

 private:
  const SurfacePoints& surface_;
};

}  // namespace

std::unique_ptr<HeightSource> heights_of(const SurfacePoints& surface) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < surface.columns; ++i) x.push_back(surface.points[i].x);
  for (std::size_t j = 0; j < surface.rows; ++j) y.push_back(surface.points[j * surface.columns].y);
  return std::make_unique<SampledHeights>(surface, std::move(x), std::move(y));
}

void take_samples(std::size_t& taken, std::size_t columns, std::size_t rows, const std::string& name) {
  // The product of the counts can not overflow: the positions are in memory.
  const std::size_t samples = columns * rows;
  if (samples > kMostMeshSamples - taken) {
    throw InputError(name, std::to_string(columns) + " x " + std::to_string(rows) +
                               " samples are too many for a mesh: all surfaces together may have " +
                               std::to_string(kMostMeshSamples));
  }
  taken += samples;
}

SurfacePoints points_of(const HeightSource& heights) {
  SurfacePoints surface{.columns = heights.x().size(), .rows = heights.y().size()};
  surface.points.resize(surface.columns * surface.rows);
  parallel_for(surface.rows, [&](std::size_t j) {
    std::vector<double> z(surface.columns);
    heights.read_row(j, z);
    for (std::size_t i = 0; i < z.size(); ++i)
      surface.points[j * surface.columns + i] = {heights.x()[i], heights.y()[j], z[i]};
  });
  return surface;
}

SurfacePoints parametric_points(const std::array<std::string, 3>& formulas, const std::vector<double>& u,
                                const std::vector<double>& v) {
  SurfacePoints surface{.columns = u.size(), .rows = v.size()};
  surface.points.resize(u.size() * v.size());
  surface.parametric = surface.from_formula = true;
  constexpr std::array<const char*, 3> kNames{"formula of x", "formula of y", "formula of z"};
  std::array<std::unique_ptr<FormulaEvaluators>, 3> evaluators;
  for (int axis = 0; axis < 3; ++axis) {
    evaluators[axis] = std::make_unique<FormulaEvaluators>(prepare_formula(formulas[axis], {kParameters, kNames[axis]}));
  }
  parallel_for(v.size(), [&](std::size_t j) {
    for (int axis = 0; axis < 3; ++axis) {
      evaluators[axis]->use([&](FormulaEvaluator& evaluator) {
        for (std::size_t i = 0; i < u.size(); ++i) {
          surface.points[j * u.size() + i][axis] = evaluator(std::array{u[i], v[j]});
        }
      });
    }
  });
  return surface;
}

double constant_of(const std::string& formula) {
  FormulaEvaluator evaluator(prepare_formula(formula, {{}, shown(formula, '"')}));
  return evaluator({});
}

}  // namespace ligne
