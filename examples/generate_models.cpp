/// Writes the example models: ligne_examples FOLDER

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "models.hpp"

int main(int argc, char** argv) {
  using namespace ligne::examples;
  if (argc != 2) {
    std::cerr << "usage: ligne_examples FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  const std::pair<const char*, std::string> files[] = {{"gear-pair.json", scene_text(gear_pair())},
                                                       {"pipe-tee.json", scene_text(pipe_tee())},
                                                       {"stair-tower.obj", obj_text(stair_tower())},
                                                       {"five-cubes.obj", obj_text(five_cubes())},
                                                       {"trefoil.obj", obj_text(trefoil())}};
  for (const auto& [name, text] : files) {
    std::ofstream out(folder / name, std::ios::binary);
    out << text;
    out.close();
    if (!out) {
      std::cerr << "ligne_examples: " << (folder / name).string() << ": can not be written\n";
      return 1;
    }
  }
  return 0;
}
