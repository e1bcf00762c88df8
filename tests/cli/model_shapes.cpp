#include "model_shapes.hpp"

#include <random>

#include "patches/part_scenes.hpp"

namespace ligne::test {
namespace {

std::string torus(bool with_plate) {
  std::ostringstream obj;
  obj.precision(9);
  const int columns = 90, rows = 45;
  obj << "o ring\n";
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < rows; ++k) {
      const double u = 2 * kPi * i / columns, v = 2 * kPi * k / rows, r = 60 + 25 * std::cos(v);
      obj << "v " << r * std::cos(u) << ' ' << 25 * std::sin(v) << ' ' << r * std::sin(u) << '\n';
    }
  }
  for (int i = 0; i < columns; ++i) {
    for (int k = 0; k < rows; ++k) {
      const int a = i * rows + k, b = (i + 1) % columns * rows + k, c = (i + 1) % columns * rows + (k + 1) % rows,
                d = i * rows + (k + 1) % rows;
      obj << "f " << a + 1 << ' ' << d + 1 << ' ' << c + 1 << ' ' << b + 1 << '\n';
    }
  }
  if (with_plate) obj << "o plate\nv 150 20 150\nv 150 220 150\nv 270 220 30\nv 270 20 30\nf -4 -3 -2 -1\n";
  return obj.str();
}

std::string scanned_ball(int n, double noise) {
  std::ostringstream points, faces;
  std::mt19937 random(3);
  std::map<std::array<int, 3>, int> numbers;
  const auto number_of = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = numbers.try_emplace(at, static_cast<int>(numbers.size()) + 1);
    if (is_new) {
      const double x = 2.0 * at[0] / n - 1, y = 2.0 * at[1] / n - 1, z = 2.0 * at[2] / n - 1;
      const double off = noise * (double(random() % 2001) / 1000 - 1), r = (1 + off) / std::hypot(x, y, z);
      points << "v " << r * x << ' ' << r * y << ' ' << r * z << '\n';
    }
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const int side : {0, n}) {
      for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) {
          const auto corner = [&](int a, int b) {
            std::array<int, 3> at{};
            at[axis] = side;
            at[(axis + 1) % 3] = side == n ? i + a : i + b;
            at[(axis + 2) % 3] = side == n ? j + b : j + a;
            return number_of(at);
          };
          const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          faces << "f " << a << ' ' << b << ' ' << c << "\nf " << a << ' ' << c << ' ' << d << '\n';
        }
      }
    }
  }
  return points.str() + faces.str();
}

}  // namespace

std::string obj_of_shape(const std::vector<std::string>& words) {
  const std::string& name = words.at(0);
  const auto number = [&](std::size_t i) { return std::stod(words.at(i)); };
  if (name == "torus") return torus(false);
  if (name == "covered-torus") return torus(true);
  if (name == "disc") {
    Corners corners;
    for (int i = 0; i < number(1); ++i) corners.push_back(on_circle(1, 2 * kPi * i / number(1)));
    return obj_of({corners});
  }
  if (name == "scanned-ball") return scanned_ball(std::stoi(words.at(1)), number(2));
  if (name == "bored-plate") return obj_of(bored_plate(number(1), number(2)));
  if (name == "turned-part") return obj_of(turned_part());
  if (name == "ball") return obj_of(ball());
  if (name == "rounded-box") return obj_of(rounded_box({number(1), number(2), number(3)}, std::stoi(words.at(4))));
  throw std::invalid_argument(name + " is no shape");
}

}  // namespace ligne::test
