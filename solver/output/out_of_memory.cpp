#include "out_of_memory.hpp"

#include <sys/resource.h>

#include <solver/mesh/generators.hpp>
#include <solver/scene/machine.hpp>

namespace pinball {

namespace {

std::size_t mebibytes(double bytes) { return static_cast<std::size_t>(bytes / 1048576.0 + 0.5); }

/// Most that the process has had at a time [bytes].
double most_held() {
  struct rusage usage {};
  return ::getrusage(RUSAGE_SELF, &usage) == 0 ? 1024.0 * usage.ru_maxrss : 0.0;
}

double elements_of(const MeshSettings& mesh) {
  if (std::holds_alternative<FileMesh>(mesh)) return 0;
  return generate(mesh).hexahedra.size();
}

}  // namespace

OutOfMemory::OutOfMemory(const std::string& doing, double needed) {
  text_ << "out of memory";
  if (!doing.empty()) text_ << " " << doing.c_str();
  if (needed > 0) text_ << ", which takes at least " << mebibytes(needed) << " MiB";
  text_ << ": the program had up to " << mebibytes(most_held()) << " MiB of the " << mebibytes(memory_bytes())
        << " MiB of this machine, and was refused more: try a coarser mesh, precision = \"float\", or a larger limit "
           "(ulimit -v) or machine";
}

double least_bytes(const Scene& scene) {
  double sum = 0;
  for (const Body& body : scene.bodies) {
    sum += elements_of(body.mesh) * least_bytes_of_element(scene, body.element.value_or(scene.element));
  }
  return sum;
}

}  // namespace pinball
