#include <cstdio>
#include <exception>
#include <pinball/solver/recorded_run.hpp>
#include <string>

/// A host that runs a scene as the program does, with the same files: recorded_run SCENE FOLDER.
int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: recorded_run SCENE FOLDER\n");
    return 2;
  }
  try {
    pinball::RecordOptions options;
    options.out = argv[2];
    options.quiet = true;
    pinball::run_recorded(pinball::read_scene(pinball::find_scene(argv[1])), options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
