#include "machine.hpp"

#include <unistd.h>

#include <fstream>

namespace pinball {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

double memory_bytes() {
  const long pages = sysconf(_SC_PHYS_PAGES), size = sysconf(_SC_PAGESIZE);
  return pages > 0 && size > 0 ? static_cast<double>(pages) * static_cast<double>(size) : 0.0;
}

/// Peaks of memory of three steps of an elastic cube of 10^6 elements, with the copy of the state to go on from, in
/// single and double precision: 326 and 475 bytes per element without numbers of hourglass modes, 421 and 668 with
/// them, 578 and 839 with contact, too. What is assumed is a tenth less; of mixed precision what single precision
/// takes.
double least_bytes_of_element(const Scene& scene, const ElementSettings& element) {
  const double number = has_single_elements(scene.precision) ? sizeof(float) : sizeof(double);
  const bool state = element.hourglass != HourglassControl::none;
  const ContactMethod method = scene.contact.method;
  const bool contact = method == ContactMethod::pinball || method == ContactMethod::slideline;
  const double measured = 177 + 37 * number + (state ? 24 * number : 0) + (contact ? 135 + 5 * number : 0);
  return 0.9 * measured;
}

}  // namespace pinball
