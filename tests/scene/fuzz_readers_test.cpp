#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <new>

#include <kernels/exec.hpp>
#include <solver/base/error.hpp>
#include <solver/formats/gmsh/gmsh_reader.hpp>
#include <solver/scene.hpp>
#include <solver/step/solver.hpp>

#include "fuzz_inputs.hpp"

/// Readers of scenes and meshes on texts that were made worse at random. Each is read, or rejected with an InputError;
/// no other exception, no crash, no hang, no allocation out of proportion. Seeds are fixed; PINBALL_FUZZ_SECONDS=600
/// goes on with further ones for so long. The input at hand is left in a file, which a crash leaves behind.
namespace {

std::atomic<std::size_t> largest_allocation{0};

void* allocate(std::size_t size) {
  std::size_t before = largest_allocation.load(std::memory_order_relaxed);
  while (before < size && !largest_allocation.compare_exchange_weak(before, size, std::memory_order_relaxed)) {
  }
  return std::malloc(size == 0 ? 1 : size);
}

}  // namespace

// Not inlined: GCC takes free() for a mismatch where it sees it beside `new`.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* memory = allocate(size)) return memory;
  throw std::bad_alloc();
}
void* operator new[](std::size_t size) { return ::operator new(size); }
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return allocate(size); }
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

namespace pinball::fuzz_readers_test {
namespace {

using namespace test;
using Clock = std::chrono::steady_clock;

constexpr std::size_t most_bytes = std::size_t{1} << 28;
constexpr double most_seconds = 20;  // of the processor for one input, with sanitizers

std::vector<std::string> texts_in(const std::string& folder, const std::string& ending) {
  std::vector<std::string> paths, texts;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ending) paths.push_back(entry.path().string());
  }
  std::sort(paths.begin(), paths.end());  // seeds mean the same everywhere
  for (const auto& path : paths) texts.push_back(file_text(path));
  return texts;
}

/// More elements than the settings of a body give, roughly.
double elements_of(const MeshSettings& settings) {
  if (const auto* m = std::get_if<BlockMesh>(&settings)) {
    return static_cast<double>(m->elements[0]) * m->elements[1] * m->elements[2];
  }
  if (const auto* m = std::get_if<RoundNosedRodMesh>(&settings)) {
    return (m->core[0] + 2.0 * m->ring) * (m->core[1] + 2.0 * m->ring) * (static_cast<double>(m->layers) + m->ring);
  }
  if (const auto* m = std::get_if<CylinderMesh>(&settings)) {
    return (m->core * (m->core + 4.0 * m->ring) + m->radial) * m->layers;
  }
  if (const auto* m = std::get_if<SphereMesh>(&settings)) {
    return static_cast<double>(m->core[0]) * m->core[1] * (m->core[0] + m->core[1] + 6.0 * m->ring);
  }
  return 0;
}

/// Reads a scene, and if it is small makes two steps.
void use_scene(const std::string& path, const SceneOverrides& overrides) {
  const Scene scene = read_scene(path, overrides);
  double elements = 0;
  for (const Body& body : scene.bodies) elements += elements_of(body.mesh);
  if (elements > 500) return;
  try {
    Solver<double> solver(scene);
    for (int i = 0; i < 2 && !solver.at_end(); ++i) solver.step();
  } catch (const RunError&) {  // it may well be unstable
  }
}

template <class Use>
void fuzz(const std::vector<std::string>& corpus, std::uint64_t count, const std::string& name, const Use& use) {
  ASSERT_FALSE(corpus.empty());
  DefaultExecutionSpace::set_concurrency(1);
  const char* seconds = std::getenv("PINBALL_FUZZ_SECONDS");
  const auto start = Clock::now();
  const auto folder = std::filesystem::temp_directory_path() / fmt::format("pinball_fuzz_{}_{}", name, ::getpid());
  std::filesystem::create_directories(folder);
  std::uint64_t rejected = 0, seed = 0;
  for (; seed < count ||
         (seconds != nullptr && std::chrono::duration<double>(Clock::now() - start).count() < std::atof(seconds));
       ++seed) {
    Random random(seed);
    const std::string text = mutated(corpus[below(random, corpus.size())], random);
    const std::string path = (folder / "input.toml").string();
    std::ofstream(path, std::ios::binary) << text;
    largest_allocation = 0;
    const std::clock_t begin = std::clock();
    std::string problem;
    try {
      use(text, path, random);
    } catch (const InputError& error) {
      ++rejected;
      if (std::string(error.what()).empty()) problem = "an error without a message";
    } catch (const std::exception& error) {
      problem = fmt::format("not an InputError: {}", error.what());
    }
    if (largest_allocation > most_bytes)
      problem += fmt::format("allocates {} bytes at once", largest_allocation.load());
    const double taken = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    if (taken > most_seconds) problem += fmt::format("takes {:.0f} s", taken);
    if (!problem.empty()) {
      const auto kept = folder / fmt::format("seed_{}.txt", seed);
      std::filesystem::copy_file(path, kept, std::filesystem::copy_options::overwrite_existing);
      ADD_FAILURE() << "seed " << seed << ": " << problem << "; see " << kept;
    }
  }
  if (!testing::Test::HasFailure()) std::filesystem::remove_all(folder);
  EXPECT_GT(rejected, seed / 4) << "most changes should be noticed";
  EXPECT_LT(rejected, seed) << "some change nothing that matters";
}

TEST(FuzzReaders, Scenes) {
  auto corpus = texts_in(PINBALL_SOURCE_DIR "/data/scenes", ".toml");
  // The small ones, of which two steps are made, more often.
  corpus.insert(corpus.end(), 10, file_text(PINBALL_SOURCE_DIR "/data/scenes/two_blocks.toml"));
  fuzz(corpus, 400, "scenes", [](const std::string&, const std::string& path, Random& random) {
    SceneOverrides overrides;
    static const std::vector<std::string> keys{
        "time.end", "contact.beta",        "body.0.mesh",        "material.steel.density", "variant", "a.b.c",
        "",         "constraint.0.normal", "body.lower.velocity"};
    if (below(random, 4) == 0) overrides.set.push_back(keys[below(random, keys.size())] + '=' + nasty(random));
    if (below(random, 8) == 0) overrides.refine = static_cast<int>(1 + below(random, 1000));
    use_scene(path, overrides);
  });
}

TEST(FuzzReaders, Meshes) {
  fuzz(texts_in(PINBALL_SOURCE_DIR "/tests/data", ".msh"), 1000, "meshes",
       [](const std::string& text, const std::string&, Random& random) {
         static const std::vector<std::string> names{"", "", "left part", "right", "no such name"};
         parse_gmsh(text, "mesh.msh", {names[below(random, names.size())]});
       });
}

}  // namespace
}  // namespace pinball::fuzz_readers_test
