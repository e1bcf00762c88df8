#pragma once
/// Meshes as text. Each line adds polygons, or changes those of the object that is made:
///
///     grid N x M [triangles] [round] [ring] [capped]: X; Y; Z
///         N x M squares of a surface, whose corners are formulas of u and v, 0 to N and 0 to M. Of a round one u = N is
///         u = 0, of a ring v = M is v = 0; a capped one is closed by polygons at v = 0 and v = M.
///     face X,Y,Z X,Y,Z ...
///         a polygon
///     plate X,Y,Z X,Y,Z ...
///         a polygon that is an object of its own
///     box X,Y,Z DX,DY,DZ
///         the six sides of a box, from its least corner
///     fan N: X; Y; Z
///         a polygon of N corners, which are formulas of k
///     shape NAME NUMBERS...
///         one of the shapes of tests/patches, by its name with hyphens
///     strip LENGTHS... / DEGREES...
///         planes one behind the other, 10 wide along y, that turn by so much from one to the next
///     object
///         what follows is another object
///     copy OBJECT
///         the polygons of an earlier object, from 0
///     map: X; Y; Z
///         corners are moved to formulas of x, y and z
///     outward; reversed
///         the polygons of a convex body about the origin look away from it; all are turned over
///     shuffled SEED; backwards
///         the order of the polygons
///     without N; without doubled
///         polygon N is left out, and every twelfth one behind it; those with two equal corners
///     below X,Y,Z HEIGHT
///         what lies below a plane, closed by polygons in it
///     exact
///         coordinates are not rounded to float32
///     precision P
///         what the scene says of its coordinates; otherwise that of float32

#include "patches/patch_scenes.hpp"

namespace ligne::test {

class MeshText {
 public:
  /// Throws where the line is none of these.
  void add(const std::string& line);
  /// The polygons of the object that is made.
  const std::vector<Corners>& polygons() const { return objects_.back(); }
  Scene scene() const;
  /// The objects as an OBJ.
  std::string obj() const;
  /// How far a point is above the plane of the last line "below".
  double above(const Point3& p) const { return glm::dot(p, up_) - height_; }

 private:
  void add_grid(const std::string& text);
  void add_fan(const std::string& text);
  void add_box(const Point3& least, const Point3& size);
  void add_strip(const std::vector<std::string>& words);
  void change(const std::string& verb, const std::vector<std::string>& words);

  std::vector<std::vector<Corners>> objects_{1};
  double precision_ = 0, height_ = 0;
  bool is_exact_ = false;
  Point3 up_{0, 0, 0};
};

/// The mesh of lines, and the OBJ of it.
MeshText mesh_of(const std::string& lines);
inline std::string obj_of_mesh(const std::string& lines) { return mesh_of(lines).obj(); }

/// A text in which [[N*TEXT]] stands for N texts one behind the other, and @FORMULA@ in these for a number by a formula of
/// k, 0 to N - 1.
std::string repeated(const std::string& text);

/// The value of a formula of numbers.
double number_of(const std::string& formula);
/// "X,Y,Z", each a formula of numbers.
Point3 point_of(const std::string& text);

/// A place by a formula of so many variables for each coordinate: "X; Y; Z".
std::function<Point3(std::initializer_list<double>)> place_formula(const std::string& text,
                                                                   std::span<const std::string_view> variables);

}  // namespace ligne::test
