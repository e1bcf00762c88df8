#include "polygon_shapes.hpp"

#include "support/line_text.hpp"

namespace ligne::shapes {
namespace {

/// The closed space-filling curve of Moore.
Contour moore_curve(int n) {
  int order = 1;
  while (4 << (2 * order) <= n) ++order;
  Contour c;
  Point2 at{0, 0}, ahead{0, 1};
  // The L-system LFL+F+LFL, L -> -RF+LFL+FR-, R -> +LF-RFR-FL+.
  const auto turn = [&](int sign) { ahead = {-sign * ahead.y, sign * ahead.x}; };
  const auto forward = [&] {
    c.push_back(at);
    at = at + ahead;
  };
  const auto curve = [&](const auto& self, int sign, int depth) -> void {
    if (depth == 0) return;
    turn(sign);
    self(self, -sign, depth - 1);
    forward();
    turn(-sign);
    self(self, sign, depth - 1);
    forward();
    self(self, sign, depth - 1);
    turn(-sign);
    forward();
    self(self, -sign, depth - 1);
    turn(sign);
  };
  const int depth = order - 1;
  for (int half = 0; half < 2; ++half) {
    curve(curve, 1, depth);
    forward();
    curve(curve, 1, depth);
    turn(-1);
    forward();
    if (half == 0) turn(-1);
  }
  return c;
}

/// The corners of the space-filling curve up to `most` beside their places.
Polygon jittered_curve(int n, double most) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> jitter(-most, most);
  Polygon polygon{moore_curve(n)};
  for (Point2& p : polygon[0]) p += Point2{jitter(random), jitter(random)};
  return polygon;
}

}  // namespace

Polygon Shape::make(int corners) const {
  if (contours.starts_with("curve ")) return jittered_curve(corners, std::stod(contours.substr(6)));
  std::string text = contours;
  const int side = static_cast<int>(std::sqrt(corners / 4.0));
  for (const auto& [name, value] :
       {std::pair{"{n}", corners}, {"{h}", corners / 2}, {"{t}", corners / 3}, {"{q}", corners / 4}, {"{s}", side}})
    for (std::size_t at; (at = text.find(name)) != text.npos;) text.replace(at, 3, std::to_string(value));
  return test::contours_of_text(text);
}

const std::vector<Shape>& all_shapes() {
  const auto star = [](const std::string& k, const std::string& n) {
    const std::string radius = "(525+475*sin(97*" + k + "^2))", turn = "(2*pi*" + k + "/" + n + ")";
    return radius + "*cos" + turn + "," + radius + "*sin" + turn;
  };
  const auto teeth = [](const std::string& gap) {
    return "0..2*{q}-1:k,if(mod(k,2)==0,-{q},-" + gap + "/2) 2*{q},-{q} 2*{q},{q} 0..2*{q}-1:2*{q}-1-k,if(mod(k,2)==0," +
           gap + "/2,{q})";
  };
  const std::string right = "if(mod(mod(k,4)+1,4)>1,", upper = "if(mod(k,4)>1,";
  const auto holes = [&](const std::string& size) {
    return "rectangle 0,0 2*{s}+1,2*{s}+1; 0..4*{s}^2-1:2*floor(floor(k/4)/{s})+1+" + right + size +
           ",0),2*mod(floor(k/4),{s})+1+" + upper + size + ",0) each 4";
  };
  const auto spiral = [](const std::string& k, const std::string& begin) {
    const std::string radius = "(" + begin + "+" + k + "/20)", turn = "(pi*mod(" + k + ",128)/64)";
    return " 0..{h}-1:" + radius + "*cos" + turn + "," + radius + "*sin" + turn;
  };
  const auto square_spiral = [](const std::string& k, const std::string& width) {
    const std::string t = "(floor(" + k + "/4)+1+" + width + ")", corner = "mod(" + k + ",4)";
    return " 0..{h}-1:if(" + corner + "<2," + t + ",-" + t + "),if(" + corner + "==0,1-" + t + ",if(" + corner + "==3,-" +
           t + "," + t + "))";
  };
  static const std::vector<Shape> shapes{
      {"star", true, "0..{n}-1:" + star("k", "{n}")},
      {"comb", true, "0,-1 2*{h},-1 0..2*{h}-1:2*{h}-k,{h}*(1-mod(k,2)) 0,{h}"},
      {"lying_comb", true, "-1,0 -1,-2*{h} 0..2*{h}-1:{h}*(1-mod(k,2)),k-2*{h} {h},0"},
      {"spiral", true, spiral("k", "10") + spiral("({h}-1-k)", "8")},
      // All corners on common horizontal and vertical lines, all sides long.
      {"square_spiral", true, square_spiral("k", "0") + square_spiral("({h}-1-k)", "0.25")},
      // Two rows of teeth with a gap between their tips.
      {"saw_teeth", true, teeth("1e-9")},
      {"teeth_that_touch", true, teeth("0")},
      {"space_filling", true, "curve 0"},
      {"random_simple", true, "curve 0.3"},
      {"holes", true, holes("1")},
      // A diagonal of holes, corner to corner.
      {"chain_of_holes", true,
       "rectangle 0,0 {q}+2,{q}+2; 0..4*{q}-1:floor(k/4)+1+" + right + "1,0),floor(k/4)+1+" + upper + "1,0) each 4"},
      // A row of squares, corner to corner, that is one contour.
      {"beads", true, "0..2*{q}:k,-mod(k,2) 0..2*{q}-1:2*{q}-1-k,mod(k+1,2)"},
      // All corners but two of each petal in one point.
      {"petals", true,
       "0..3*{t}-1:if(mod(k,3)==0,0,1000*cos(2*pi*floor(k/3)/{t}+if(mod(k,3)==2,3/{t},0))),"
       "if(mod(k,3)==0,0,1000*sin(2*pi*floor(k/3)/{t}+if(mod(k,3)==2,3/{t},0)))"},
      // The lower side runs the whole way to and fro between all of its corners.
      {"long_folds", true, "0..2*{h}-1:if(mod(k,2)==0,k/2,2*{h}-(k-1)/2),0 {h},5 0,10"},
      {"teeth_that_cross", false, teeth("(-1)")},
      {"holes_that_cross", false, holes("2.25")},
      // Its corners leave their cells.
      {"tangled", false, "curve 0.6"},
      {"twice_round", false, "0..2*{h}-1:" + star("mod(k,{h})", "{h}")},
      {"random_points", false, "0..{n}-1:500+500*sin(97*k^2),500+500*sin(61*k^2+1)"}};
  return shapes;
}

}  // namespace ligne::shapes
