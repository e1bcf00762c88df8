#include "plotted.hpp"

namespace ligne::test {
namespace {

constexpr double kZUp = 5, kZDown = 0;

class GcodeMachine {
 public:
  explicit GcodeMachine(PenKind kind) : kind_(kind) {}

  void line(std::string text) {
    if (const auto comment = text.find('('); comment != std::string::npos) text.resize(comment);
    std::map<char, double> words;
    std::istringstream in(text);
    std::string word, command;
    while (in >> word) {
      char* end = nullptr;
      const double value = std::strtod(word.c_str() + 1, &end);
      if (*end != '\0' || word.size() < 2) return fault("not a word: " + word);
      if (word[0] == 'G' || word[0] == 'M')
        command = word;
      else
        words[word[0]] = value;
    }
    if (command == "G21")
      millimetres_ = true;
    else if (command == "G90")
      absolute_ = true;
    else if (command == "G94" || command == "M2") {
    } else if (command == "G4")
      settled_ = true;
    else if (command == "M0")
      pause();
    else if (command == "M3")
      set_pen(kind_ == PenKind::servo, kind_ != PenKind::z);
    else if (command == "M5")
      set_pen(kind_ == PenKind::servo_reversed, kind_ != PenKind::z);
    else if (command == "G0" || command == "G1")
      move(command == "G0", words);
    else if (!text.empty())
      fault("unknown: " + text);
  }
  Replay take() {
    replay_.ends_up = known_ && !down_;
    return std::move(replay_);
  }

 private:
  void fault(const std::string& text) { replay_.faults.push_back(text); }
  void pause() {
    if (down_) fault("a pause with the pen down");
    replay_.pens.push_back(static_cast<int>(replay_.pens.size()));
  }
  void set_pen(bool down, bool meant) {
    if (!meant) return fault("a servo command for a z axis");
    known_ = true;
    settled_ = false;
    if (down && !down_) replay_.strokes.push_back({at_});
    down_ = down;
  }
  void move(bool rapid, const std::map<char, double>& words) {
    if (!millimetres_ || !absolute_) fault("a move before G21 and G90");
    if (words.contains('F')) feed_ = words.at('F');
    if (words.contains('Z')) {
      if (kind_ != PenKind::z) fault("a z move for a servo");
      if (words.contains('X') || words.contains('Y')) fault("z and the plane at once");
      const double z = words.at('Z');
      if (z != kZUp && z != kZDown) fault("the pen is half down");
      if (z == kZDown && rapid) fault("the pen is rammed into the paper");
      set_pen(z == kZDown, true);
      settled_ = true;
    }
    if (!words.contains('X') && !words.contains('Y')) return;
    if (!known_) fault("a move before the pen is up or down");
    if (!settled_) fault("a move while the pen is half down");
    if (words.contains('X')) at_.x = words.at('X');
    if (words.contains('Y')) at_.y = words.at('Y');
    replay_.reach.extend(at_);
    if (rapid && down_) fault("a rapid move with the pen down");
    if (!rapid && !down_) fault("a drawing move with the pen up");
    if (!rapid && feed_ <= 0) fault("a drawing move without a feed");
    if (down_) replay_.strokes.back().push_back(at_);
  }

  PenKind kind_;
  Replay replay_;
  Point2 at_{0, 0};
  double feed_ = 0;
  bool millimetres_ = false, absolute_ = false, down_ = false, known_ = false, settled_ = true;
};

}  // namespace

Replay replay_gcode(std::string_view text, PenKind kind) {
  GcodeMachine machine(kind);
  std::istringstream in{std::string(text)};
  std::string line;
  while (std::getline(in, line)) machine.line(line);
  return machine.take();
}

Replay replay_hpgl(std::string_view text) {
  Replay replay;
  bool down = false;
  Point2 at{0, 0};
  std::istringstream in{std::string(text)};
  std::string command;
  while (std::getline(in, command, ';')) {
    while (!command.empty() && (command[0] == '\n' || command[0] == '\r')) command.erase(0, 1);
    if (command.empty()) continue;
    const std::string name = command.substr(0, 2);
    std::vector<double> values;
    std::istringstream numbers(command.substr(2));
    std::string number;
    while (std::getline(numbers, number, ',')) {
      char* end = nullptr;
      values.push_back(std::strtod(number.c_str(), &end));
      if (number.empty() || *end != '\0') replay.faults.push_back("not a number: " + command);
    }
    if (name == "SP") {
      if (down) replay.faults.push_back("a pen is changed while it is down");
      if (values.size() == 1 && values[0] > 0) replay.pens.push_back(static_cast<int>(values[0]));
    } else if (name == "PU" || name == "PD") {
      if (name == "PD" && replay.pens.empty()) replay.faults.push_back("there is no pen");
      if (name == "PD" && !down) replay.strokes.push_back({at});
      down = name == "PD";
      if (values.size() % 2 == 1) replay.faults.push_back("an odd number of coordinates");
      for (std::size_t i = 0; i + 1 < values.size(); i += 2) {
        at = {values[i], values[i + 1]};
        replay.reach.extend(at);
        if (down) replay.strokes.back().push_back(at);
      }
    } else if (name != "IN" && name != "PS" && name != "VS" && name != "PW" && name != "PG") {
      replay.faults.push_back("unknown: " + command);
    }
  }
  replay.ends_up = !down;
  return replay;
}

}  // namespace ligne::test
