// The engine's loop alone, in double and in space, for called_for.py: SCENE EVENTS. What callgrind counts is
// engine_loop(); printed are the bytes that the run holds when the loop begins, and events a second of
// processor time.
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <new>
#include <stdexcept>

#include "reference/engine/simulation.hpp"
#include "reference/scene/read_scene.hpp"

// Memory at multiples of 64 bytes from lists by size: what an allocation costs, and what a copy costs by its
// alignment, depends on nothing that was allocated before the loop.
namespace {

constexpr std::size_t kUnit = 64, kSizes = 1024, kBlock = std::size_t{1} << 20;

struct Piece {
  std::size_t units, bytes;
  Piece* next;
};

Piece* free_pieces[kSizes];
std::byte* fresh = nullptr;
std::size_t fresh_left = 0;
std::size_t held = 0;  ///< bytes asked for and not given back

void* allocated(std::size_t bytes) {
  const std::size_t units = 1 + (bytes + kUnit - 1) / kUnit;
  Piece* piece = units < kSizes ? free_pieces[units] : nullptr;
  if (piece != nullptr) {
    free_pieces[units] = piece->next;
  } else if (units >= kSizes) {
    piece = static_cast<Piece*>(std::aligned_alloc(kUnit, units * kUnit));
  } else {
    if (fresh_left < units * kUnit) {
      fresh = static_cast<std::byte*>(std::aligned_alloc(kUnit, kBlock));
      fresh_left = kBlock;
    }
    piece = reinterpret_cast<Piece*>(fresh);
    fresh += units * kUnit;
    fresh_left -= units * kUnit;
  }
  if (piece == nullptr) throw std::bad_alloc();
  piece->units = units;
  piece->bytes = bytes;
  held += bytes;
  return reinterpret_cast<std::byte*>(piece) + kUnit;
}

void give_back(void* memory) {
  if (memory == nullptr) return;
  auto* piece = reinterpret_cast<Piece*>(static_cast<std::byte*>(memory) - kUnit);
  held -= piece->bytes;
  if (piece->units >= kSizes) return std::free(piece);
  piece->next = free_pieces[piece->units];
  free_pieces[piece->units] = piece;
}

}  // namespace

void* operator new(std::size_t bytes) {
  return allocated(bytes);
}
void* operator new(std::size_t bytes, std::align_val_t) {
  return allocated(bytes);
}
void operator delete(void* memory) noexcept {
  give_back(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  give_back(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  give_back(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  give_back(memory);
}

namespace {

using Simulation = tps::Simulation<double, 3>;

[[gnu::noinline]] long engine_loop(Simulation& simulation, long events) {
  long done = 0;
  for (; done < events && simulation.next_time() < tps::Time<double>::never(); ++done) simulation.step();
  return done;
}

/// So that lists have what an event needs.
void warm_up(Simulation& simulation) {
  for (int n = 0; n < 100 && simulation.next_time() < tps::Time<double>::never(); ++n) simulation.step();
}

int run(const tps::Scene& scene, long events) {
  const std::size_t before = held;
  Simulation simulation(scene);
  const std::size_t bytes = held - before;
  warm_up(simulation);
  const std::clock_t start = std::clock();
  const long done = engine_loop(simulation, events);
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  std::printf("%ld events, %zu bytes, %.0f events/s\n", done, bytes, static_cast<double>(done) / seconds);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  try {
    const tps::Scene scene = tps::read_scene_file(argv[1]);
    const long events = std::atol(argv[2]);
    if (scene.dimension != 3) throw std::invalid_argument("the loop is compiled for space alone");
    return run(scene, events);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 3;
  }
}
