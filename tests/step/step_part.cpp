#include "step/step_part.hpp"

#include <BRepAdaptor_Curve.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_UniformAbscissa.hxx>
#include <GeomLProp_SLProps.hxx>
#include <Poly_Triangulation.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

namespace ligne::test {
namespace {

/// Sides that meet at less are tangent. At about this angle there may be an edge or none.
constexpr double kSharpRad = 10 * std::numbers::pi / 180, kSharpSlackRad = 1e-3;
/// Sides whose curvatures across an edge differ by less, as a part of the larger one, go on alike.
constexpr double kAlikePart = 0.05;
/// Curvatures of less count as none, in 1/mm.
constexpr double kFlatPerMm = 1e-4;
constexpr double kResolution = 1e-7;

Point3 point(const gp_XYZ& p) { return {p.X(), p.Y(), p.Z()}; }

/// A point of a face with its derivatives.
class FacePoint {
 public:
  FacePoint(const TopoDS_Face& face, const gp_Pnt2d& uv)
      : properties_(BRep_Tool::Surface(face), uv.X(), uv.Y(), 2, kResolution),
        side_(face.Orientation() == TopAbs_REVERSED ? -1 : 1) {}

  bool has_normal() { return properties_.IsNormalDefined(); }
  Point3 at() const { return point(properties_.Value().XYZ()); }
  Point3 normal() { return side_ * point(properties_.Normal().XYZ()); }

  /// The curvature of the normal section along a direction in the tangent plane, positive where it bends towards the normal.
  double curvature_along(const Point3& direction) {
    const Point3 su = point(properties_.D1U().XYZ()), sv = point(properties_.D1V().XYZ()), n = normal();
    const double e = glm::dot(su, su), f = glm::dot(su, sv), g = glm::dot(sv, sv), determinant = e * g - f * f;
    const double du = glm::dot(direction, su), dv = glm::dot(direction, sv);
    if (!(determinant > 0)) return 0;
    const double a = (g * du - f * dv) / determinant, b = (e * dv - f * du) / determinant;
    const double along = e * a * a + 2 * f * a * b + g * b * b;
    if (!(along > 0)) return 0;
    const double bend = glm::dot(point(properties_.D2U().XYZ()), n) * a * a +
                        2 * glm::dot(point(properties_.DUV().XYZ()), n) * a * b +
                        glm::dot(point(properties_.D2V().XYZ()), n) * b * b;
    return bend / along;
  }

 private:
  GeomLProp_SLProps properties_;
  double side_;
};

bool bend_alike(double a, double b) {
  const double larger = std::max(std::abs(a), std::abs(b));
  return larger < kFlatPerMm || std::abs(a - b) < kAlikePart * larger;
}

/// The point of a face at a parameter of one of its edges.
std::optional<FacePoint> beside(const TopoDS_Edge& edge, const TopoDS_Face& face, double parameter) {
  double first = 0, last = 0;
  const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
  if (curve.IsNull()) return std::nullopt;
  FacePoint found(face, curve->Value(parameter));
  if (!found.has_normal()) return std::nullopt;
  return found;
}

void add_edge(const TopoDS_Edge& edge, const TopTools_ListOfShape& faces, double step, KnownLines& lines) {
  if (BRep_Tool::Degenerated(edge) || faces.IsEmpty()) return;
  const TopoDS_Face one = TopoDS::Face(faces.First()), other = TopoDS::Face(faces.Last());
  const bool is_border = faces.Extent() == 1;
  // The seam of a surface that is closed in itself.
  if (BRep_Tool::IsClosed(edge, one)) return;
  const BRepAdaptor_Curve curve(edge);
  const GCPnts_UniformAbscissa ends(curve, step, -1);
  if (!ends.IsDone()) return;
  for (int k = 1; k < ends.NbPoints(); ++k) {
    const double from = ends.Parameter(k), to = ends.Parameter(k + 1), middle = (from + to) / 2;
    TruePoint sample;
    sample.at = point(curve.Value(middle).XYZ());
    sample.along = point(curve.Value(to).XYZ()) - point(curve.Value(from).XYZ());
    std::optional<FacePoint> a = beside(edge, one, middle), b = beside(edge, other, middle);
    if (!a || !b || !(glm::length(sample.along) > 0)) continue;
    sample.normals = {a->normal(), b->normal()};
    const double angle = std::acos(std::clamp(glm::dot(sample.normals[0], sample.normals[1]), -1.0, 1.0));
    if (is_border || angle >= kSharpRad - kSharpSlackRad) {
      (is_border || angle > kSharpRad + kSharpSlackRad ? lines.wanted : lines.other).push_back(sample);
      continue;
    }
    sample.kind = TrueLine::tangent;
    const Point3 across = glm::normalize(glm::cross(sample.normals[0], sample.along));
    (bend_alike(a->curvature_along(across), b->curvature_along(across)) ? lines.other : lines.wanted).push_back(sample);
  }
}

/// Adds the outline that crosses the facets of a face.
void add_outline(const TopoDS_Face& face, const Viewer& viewer, double step, KnownLines& lines) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
  if (mesh.IsNull() || !mesh->HasUVNodes()) return;
  std::vector<std::optional<double>> turns(static_cast<std::size_t>(mesh->NbNodes()) + 1);
  for (int i = 1; i <= mesh->NbNodes(); ++i) {
    FacePoint at(face, mesh->UVNode(i));
    if (at.has_normal()) turns[static_cast<std::size_t>(i)] = glm::dot(at.normal(), viewer.from(at.at()));
  }
  for (int t = 1; t <= mesh->NbTriangles(); ++t) {
    int corners[3];
    mesh->Triangle(t).Get(corners[0], corners[1], corners[2]);
    std::vector<gp_Pnt2d> crossings;
    for (int k = 0; k < 3; ++k) {
      const int i = corners[k], j = corners[(k + 1) % 3];
      const auto a = turns[static_cast<std::size_t>(i)], b = turns[static_cast<std::size_t>(j)];
      if (!a || !b || (*a > 0) == (*b > 0)) continue;
      const double share = *a / (*a - *b);
      crossings.emplace_back(mesh->UVNode(i).XY() * (1 - share) + mesh->UVNode(j).XY() * share);
    }
    if (crossings.size() != 2) continue;
    const gp_XY from = crossings[0].XY(), to = crossings[1].XY();
    const Point3 begin = FacePoint(face, from).at(), end = FacePoint(face, to).at();
    const int pieces = std::max(1, static_cast<int>(std::ceil(glm::distance(begin, end) / step)));
    for (int k = 0; k < pieces; ++k) {
      FacePoint at(face, from + (to - from) * ((k + 0.5) / pieces));
      if (!at.has_normal()) continue;
      // A surface that bends towards its normal along the sight hides its own outline.
      const double bend = at.curvature_along(viewer.from(at.at()));
      if (bend > -kFlatPerMm) continue;
      TruePoint sample;
      sample.kind = TrueLine::outline;
      sample.at = at.at();
      sample.along = (end - begin) / double(pieces);
      sample.radius = -1 / bend;
      sample.normals.fill(at.normal());
      lines.wanted.push_back(sample);
    }
  }
}

}  // namespace

struct StepPart::Shape {
  TopoDS_Shape shape;
  MeshAccuracy meshed;  ///< the accuracy of its mesh

  void mesh(const MeshAccuracy& accuracy) {
    if (accuracy == meshed) return;
    meshed = accuracy;
    BRepTools::Clean(shape);
    BRepMesh_IncrementalMesh(shape, accuracy.chord_mm, false, accuracy.angle_rad, true);
  }
};

StepPart::StepPart(const std::filesystem::path& file) {
  STEPControl_Reader reader;
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) throw std::runtime_error(file.string() + ": not read as STEP");
  reader.TransferRoots();
  auto shape = std::make_shared<Shape>();
  shape->shape = reader.OneShape();
  if (shape->shape.IsNull() || !TopExp_Explorer(shape->shape, TopAbs_FACE).More())
    throw std::runtime_error(file.string() + ": no faces");
  shape_ = std::move(shape);
}

std::vector<std::array<Point3, 3>> StepPart::mesh(const MeshAccuracy& accuracy) const {
  shape_->mesh(accuracy);
  std::vector<std::array<Point3, 3>> triangles;
  for (TopExp_Explorer at(shape_->shape, TopAbs_FACE); at.More(); at.Next()) {
    TopLoc_Location location;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(TopoDS::Face(at.Current()), location);
    if (mesh.IsNull()) continue;
    const bool is_reversed = at.Current().Orientation() == TopAbs_REVERSED;
    for (int t = 1; t <= mesh->NbTriangles(); ++t) {
      int corners[3];
      mesh->Triangle(t).Get(corners[0], corners[1], corners[2]);
      if (is_reversed) std::swap(corners[1], corners[2]);
      std::array<Point3, 3> triangle;
      for (std::size_t k = 0; k < 3; ++k)
        triangle[k] = point(mesh->Node(corners[k]).Transformed(location.Transformation()).XYZ());
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

KnownLines StepPart::lines(const Viewer& viewer, double step, const MeshAccuracy& accuracy) const {
  shape_->mesh(accuracy);
  KnownLines lines;
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopExp::MapShapesAndUniqueAncestors(shape_->shape, TopAbs_EDGE, TopAbs_FACE, faces_of);
  for (int i = 1; i <= faces_of.Extent(); ++i)
    add_edge(TopoDS::Edge(faces_of.FindKey(i)), faces_of.FindFromIndex(i), step, lines);
  for (TopExp_Explorer at(shape_->shape, TopAbs_FACE); at.More(); at.Next())
    add_outline(TopoDS::Face(at.Current()), viewer, step, lines);
  return lines;
}

}  // namespace ligne::test
