#include "properties/implementations/library_table.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "verify/operations/catalogue.hpp"

namespace tps::properties {

using operations::Op;

tps_implementation library_table(const std::string& path) {
  void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) throw std::runtime_error(fmt::format("cannot be loaded: {}", ::dlerror()));
  using Getter = const tps_implementation* (*)();
  const auto get = reinterpret_cast<Getter>(::dlsym(library, "tps_get_implementation"));
  if (get == nullptr) throw std::runtime_error("has no function tps_get_implementation()");
  const tps_implementation* table = get();
  if (table == nullptr) throw std::runtime_error("tps_get_implementation() returned a null pointer");
  if (reinterpret_cast<std::uintptr_t>(table) % alignof(tps_implementation) != 0) {
    throw std::runtime_error(fmt::format(
        "tps_get_implementation() returned {}, where no table can be: its address is a multiple of {}",
        fmt::ptr(table), alignof(tps_implementation)));
  }
  if (table->version < 1 || table->version > TPS_IMPLEMENTATION_VERSION) {
    throw std::runtime_error(fmt::format("has a table of version {}; this program knows versions 1 to {}",
                                         table->version, TPS_IMPLEMENTATION_VERSION));
  }
  if (table->name == nullptr) throw std::runtime_error("has a table without a name");
  tps_implementation known{};
  const std::size_t size = table->version == 1 ? offsetof(tps_implementation, wall_time) : sizeof known;
  std::memcpy(&known, table, size);
  return known;
}

std::vector<std::string> operations_in(const tps_implementation& table) {
  std::vector<std::string> names;
  const auto add = [&](Op op, bool is_there) {
    if (is_there) names.emplace_back(operations::name(op));
  };
  add(Op::block_time, table.block_time != nullptr);
  add(Op::tether_time, table.tether_time != nullptr);
  add(Op::order, table.order != nullptr);
  add(Op::apply_impulse, table.apply_impulse != nullptr);
  add(Op::collision_impulse, table.collision_impulse != nullptr);
  add(Op::revolution_impulse, table.revolution_impulse != nullptr);
  add(Op::tether_response, table.tether_response != nullptr);
  add(Op::load, table.load != nullptr);
  add(Op::restitution_impulse, table.restitution_impulse != nullptr);
  add(Op::group, table.group != nullptr);
  add(Op::wall_time, table.wall_time != nullptr);
  add(Op::drag_time, table.drag_time != nullptr);
  add(Op::rough_impulse, table.rough_impulse != nullptr);
  return names;
}

}  // namespace tps::properties
